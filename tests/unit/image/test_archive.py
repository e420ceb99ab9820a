"""Pictures are read from archives where they are packed, and what cannot be read is named."""

import io
import tarfile
import zipfile
from pathlib import Path

import cv2
import numpy as np
import pytest

from procc_annotator.dataset.season import list_matches
from procc_annotator.dataset.sequence import open_pictures
from procc_annotator.errors import ImageError
from procc_annotator.image.decoding import decode_bgra, read_size

NAMES = "b/10.png", "b/9.png", "a/in/1.png", "a/2.png"
HIDDEN = "__MACOSX/b/9.png", "a/.2.png", "notes.txt"


def frames(path: Path) -> Path:
    """An archive of pictures; in a zip every second one is compressed."""
    path.parent.mkdir(exist_ok=True)
    pictures = (np.full((36, 64, 3), 10 * number, dtype=np.uint8) for number in range(len(NAMES)))
    files = {n: cv2.imencode(".png", p)[1].tobytes() for n, p in zip(NAMES, pictures, strict=True)}
    files |= dict.fromkeys(HIDDEN, b"no picture")
    if path.suffix == ".zip":
        with zipfile.ZipFile(path, "w") as archive:
            for number, (name, data) in enumerate(files.items()):
                archive.writestr(name, data, (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)[number % 2])
        return path
    with tarfile.open(path, "w") as tar:
        for name, data in files.items():
            member = tarfile.TarInfo(f"./{name}")
            member.size = len(data)
            tar.addfile(member, io.BytesIO(data))
    return path


@pytest.mark.parametrize("suffix", [".zip", ".tar"])
def test_pictures_of_an_archive_are_consecutive_frames(suffix, tmp_path):
    source = open_pictures(frames(tmp_path / f"match{suffix}"))
    assert [frame.name for frame in source.frames] == ["a/2", "a/in/1", "b/9", "b/10"]
    values = [int(decode_bgra(frame.image_path)[0, 0, 0]) for frame in source.frames]
    assert values == [30, 20, 10, 0]
    assert read_size(source.frames[0].image_path) == (64, 36)
    assert source.frames[0].annotation_path == tmp_path / "match_frames/a/2.json"


def test_archives_in_a_tree_are_matches_if_they_hold_pictures(tmp_path):
    frames(tmp_path / "a/one.zip")
    frames(tmp_path / "two.tar")
    with zipfile.ZipFile(tmp_path / "cameras.zip", "w") as archive:
        archive.writestr("camera_1.json", "{}")
    assert [match.name for match in list_matches(tmp_path) or ()] == ["a/one", "two"]


def with_entry(data: bytes, place: int, value: bytes) -> bytes:
    """A zip with other bytes in the first entry of its table."""
    at = data.index(b"PK\x01\x02") + place
    return data[:at] + value + data[at + len(value) :]


@pytest.mark.parametrize(
    ("suffix", "change", "said"),
    [
        (".zip", lambda data: with_entry(data, 8, b"\x01"), "b/10.png: is encrypted"),
        (".zip", lambda data: with_entry(data, 24, b"\0\0\0\x40"), "b/10.png: holds 1073741824"),
        (".zip", lambda data: data.replace(b"IHDR", b"IHDX", 1), "b/10.png: is damaged"),
        (".zip", lambda data: data[:200], "match.zip: is not a readable archive"),
        (".tar", lambda data: b"x" * 2000, "match.tar: is not a readable archive"),
        (".tar", lambda data: data[1024:], "b/10.png: is no picture in the archive"),
    ],
)
def test_what_cannot_be_read_is_named(suffix, change, said, tmp_path):
    path = frames(tmp_path / f"match{suffix}")
    path.write_bytes(change(path.read_bytes()))
    with pytest.raises(ImageError, match=said):
        decode_bgra(path / "b/10.png")


@pytest.mark.parametrize("change", [(2000, None), (b"./a/in/1", b"./a/in/2")])
def test_the_end_of_a_tar_that_is_missing_is_a_problem(change, tmp_path):
    """It is cut off, or the check sum of a header is wrong."""
    path = frames(tmp_path / "match.tar")
    data = path.read_bytes()
    path.write_bytes(data[: change[0]] if change[1] is None else data.replace(*change))
    source = open_pictures(path)
    assert [frame.name for frame in source.frames] == ["9", "10"]
    assert "match.tar: is cut off or damaged" in source.problems[0]
