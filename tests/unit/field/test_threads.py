"""Fields are read in several threads at once: in the window while a dataset is opened."""

from __future__ import annotations

import gc
import sys
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import pytest

from procc_annotator.field.load import field_names, load_field


@pytest.fixture
def threads_in_a_hurry() -> Iterator[None]:
    """Threads take turns, and garbage is collected, as often as can be."""
    interval, thresholds = sys.getswitchinterval(), gc.get_threshold()
    sys.setswitchinterval(1e-7)
    gc.set_threshold(20)
    yield
    sys.setswitchinterval(interval)
    gc.set_threshold(*thresholds)


@pytest.mark.usefixtures("threads_in_a_hurry")
def test_fields_are_the_same_whoever_else_reads_one() -> None:
    names = field_names()[:4]
    alone = [load_field(name) for name in names]
    with ThreadPoolExecutor(6) as pool:
        several = [pool.submit(load_field, name) for _ in range(4) for name in names]
        assert [one.result() for one in several] == alone * 4
