"""Benchmarks take as long as they take: none of them hangs for being slow."""

import faulthandler

import pytest


@pytest.fixture(autouse=True)
def no_limit() -> None:
    """Call off what ends a test that seems to hang."""
    faulthandler.cancel_dump_traceback_later()
