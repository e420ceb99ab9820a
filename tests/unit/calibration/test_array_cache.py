import numpy as np
import pytest

from procc_annotator.calibration.single_image import search
from procc_annotator.calibration.single_image.array_cache import cached_arrays
from procc_annotator.calibration.single_image.field_points import field_line_points
from procc_annotator.field.load import load_field


@pytest.fixture
def folder(tmp_path, monkeypatch):
    for name in ("XDG_CACHE_HOME", "LOCALAPPDATA", "HOME"):
        monkeypatch.setenv(name, str(tmp_path))
    return tmp_path


class Computed:
    """Counts how often arrays are computed."""

    def __init__(self):
        self.times = 0

    def __call__(self):
        self.times += 1
        return np.arange(1000), np.ones((3, 4), dtype=np.float32)


def kept(compute, key=("a",), valid=lambda _: True):
    return cached_arrays("numbers", key, compute, valid)


def test_a_second_call_reads_what_the_first_one_computed(folder):
    compute = Computed()
    first, second = kept(compute), kept(compute)
    assert compute.times == 1
    for one, other in zip(first, second, strict=True):
        np.testing.assert_array_equal(one, other)
        assert one.dtype == other.dtype


def test_another_key_is_computed(folder):
    compute = Computed()
    kept(compute)
    kept(compute, ("a", np.arange(3)))
    kept(compute, ("a", np.arange(4)))
    assert compute.times == 3


@pytest.mark.parametrize("damage", ["empty", "cut", "changed", "text"])
def test_a_damaged_file_is_computed_and_written_again(folder, damage):
    compute = Computed()
    kept(compute)
    (path,) = folder.rglob("numbers-*.npz")
    data = path.read_bytes()
    middle = len(data) // 2
    changed = data[:middle] + bytes([data[middle] ^ 1]) + data[middle + 1 :]
    path.write_bytes(
        {"empty": b"", "cut": data[:middle], "changed": changed, "text": b"no arrays"}[damage]
    )
    np.testing.assert_array_equal(kept(compute)[0], np.arange(1000))
    kept(compute)
    assert compute.times == 2


def test_arrays_that_are_not_of_this_program_are_computed(folder):
    compute = Computed()
    kept(compute)
    kept(compute, valid=lambda found: found[7] is None)  # fewer arrays than this program has
    kept(compute, valid=lambda _: False)
    assert compute.times == 3


def test_without_a_folder_arrays_are_computed(folder, monkeypatch):
    (folder / "procc-annotator").write_text("in the way")
    (folder / "Library").write_text("in the way")
    compute = Computed()
    kept(compute)
    np.testing.assert_array_equal(kept(compute)[0], np.arange(1000))
    assert compute.times == 2


def test_cameras_from_a_file_are_those_that_were_computed(folder):
    lines = field_line_points(load_field("tennis"))
    found = []
    for _ in range(2):
        search.hypotheses_on_side.cache_clear()
        found.append(search.hypotheses_on_side(lines, 270.0, 0))
    for name in ("vectors", "cells", "length_px"):
        np.testing.assert_array_equal(getattr(found[0], name), getattr(found[1], name))
    assert len(list(folder.rglob("cameras-*.npz"))) == 1
