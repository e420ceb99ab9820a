"""What the benchmarks of cameras without a click share."""

from collections.abc import Iterator

import cv2
import pytest


@pytest.fixture(autouse=True)
def one_core() -> Iterator[None]:
    """Seconds are those of one core."""
    before = cv2.getNumThreads()
    cv2.setNumThreads(1)
    yield
    cv2.setNumThreads(before)
