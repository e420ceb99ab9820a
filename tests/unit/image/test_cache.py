"""Going back is instant, memory stays bounded, and threads do not trip over each other."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from pathlib import Path

import cv2
import numpy as np
import pytest

from procc_annotator.errors import ImageError
from procc_annotator.image import decoding as cache_module
from procc_annotator.image.decoding import FrameCache, decode_bgra
from procc_annotator.image.pixels import PixelArray

PICTURE_BYTES = 20 * 10 * 4


@pytest.fixture
def pictures(tmp_path) -> list[Path]:
    paths = []
    for i in range(5):
        path = tmp_path / f"{i}.png"
        cv2.imwrite(str(path), np.full((10, 20, 3), i, dtype=np.uint8))
        paths.append(path)
    return paths


@pytest.fixture
def cache() -> Iterator[FrameCache]:
    cache = FrameCache(3 * PICTURE_BYTES, kept_at_least=1)
    yield cache
    cache.close()


@pytest.fixture
def decoded(monkeypatch) -> list[Path]:
    """The paths that were decoded, in order."""
    paths: list[Path] = []

    def decode(path: Path) -> PixelArray:
        paths.append(path)
        return decode_bgra(path)

    monkeypatch.setattr(cache_module, "decode_bgra", decode)
    return paths


def _wait_for(cache: FrameCache, path: Path) -> None:
    deadline = time.monotonic() + 5
    while cache.peek(path) is None:
        assert time.monotonic() < deadline, f"{path.name} was not prefetched"
        threading.Event().wait(0.001)


def test_a_picture_is_decoded_once(cache, pictures, decoded) -> None:
    assert cache.peek(pictures[0]) is None
    first = cache.get(pictures[0])
    assert cache.get(pictures[0]) is first
    assert cache.peek(pictures[0]) is first
    assert decoded == pictures[:1]


def test_the_least_recently_used_picture_leaves_first(cache, pictures) -> None:
    for path in pictures[:3]:
        cache.get(path)
    cache.get(pictures[0])
    cache.get(pictures[3])
    assert cache.peek(pictures[1]) is None
    assert cache.peek(pictures[0]) is not None
    assert cache.used_bytes == 3 * PICTURE_BYTES


def test_the_newest_pictures_are_kept_even_if_they_exceed_the_limit(pictures) -> None:
    cache = FrameCache(10, kept_at_least=2)
    for path in pictures[:3]:
        cache.get(path)
    assert cache.peek(pictures[0]) is None
    assert cache.peek(pictures[1]) is not None
    assert cache.peek(pictures[2]) is not None
    assert cache.used_bytes == 2 * PICTURE_BYTES
    cache.close()


def test_prefetched_pictures_are_there_without_asking(cache, pictures, decoded) -> None:
    cache.prefetch([pictures[1], pictures[1], pictures[2]])
    _wait_for(cache, pictures[2])
    assert decoded == [pictures[1], pictures[2]]
    cache.get(pictures[1])
    assert decoded == [pictures[1], pictures[2]]


def test_prefetching_passes_over_damaged_pictures(cache, pictures, tmp_path) -> None:
    broken = tmp_path / "broken.png"
    broken.write_bytes(b"nothing")
    cache.prefetch([broken, pictures[0]])
    _wait_for(cache, pictures[0])
    with pytest.raises(ImageError):
        cache.get(broken)
    cv2.imwrite(str(broken), np.zeros((4, 4, 3), dtype=np.uint8))
    assert cache.get(broken).shape == (4, 4, 4)


def test_asking_for_a_picture_on_its_way_waits_for_it(cache, pictures, monkeypatch) -> None:
    started, go_on = threading.Event(), threading.Event()
    decoded: list[Path] = []

    def slow(path: Path) -> PixelArray:
        decoded.append(path)
        started.set()
        assert go_on.wait(5)
        return decode_bgra(path)

    monkeypatch.setattr(cache_module, "decode_bgra", slow)
    cache.prefetch(pictures[:1])
    assert started.wait(5)
    results: list[PixelArray] = []
    thread = threading.Thread(target=lambda: results.append(cache.get(pictures[0])))
    thread.start()
    go_on.set()
    thread.join(5)
    assert results[0].shape == (10, 20, 4)
    assert decoded == pictures[:1]


def test_a_closed_cache_holds_nothing_but_still_reads(cache, pictures) -> None:
    cache.prefetch(pictures)
    cache.close()
    cache.prefetch(pictures)
    assert cache.used_bytes == 0
    assert cache.get(pictures[0]).shape == (10, 20, 4)
    assert cache.used_bytes == 0


def test_a_picture_that_was_replaced_is_read_again(cache, pictures, decoded) -> None:
    cache.get(pictures[0])
    cv2.imwrite(str(pictures[0]), np.zeros((4, 6, 3), dtype=np.uint8))
    assert cache.get(pictures[0]).shape == (4, 6, 4)
    assert cache.used_bytes == 4 * 6 * 4
    pictures[0].unlink()  # or out of reach
    assert cache.get(pictures[0]).shape == (4, 6, 4)
    assert decoded == [pictures[0]] * 2
