"""Files of URLs are copied while they are used; what cannot be copied is named."""

import os
import sys
from pathlib import Path

import pytest

from procc_annotator.dataset import remote_files
from procc_annotator.dataset.remote_files import local_path, remove_copies
from procc_annotator.errors import InputError, UsageError

fsspec = pytest.importorskip("fsspec")


@pytest.fixture(autouse=True)
def cache(tmp_path, monkeypatch) -> None:
    monkeypatch.setenv(remote_files.CACHE_VARIABLE, str(tmp_path / "cache"))


def stored(content: bytes, name: str = "match.mp4") -> Path:
    fsspec.filesystem("memory").pipe_file(f"/bucket/{name}", content)
    return Path(f"memory://bucket/{name}")


def test_a_copy_is_made_once_for_each_content():
    url = stored(b"one", "match.mp4")
    copy = local_path(url)
    before = copy.stat()
    assert (copy.name, copy.read_bytes()) == ("match.mp4", b"one")
    assert local_path(url).stat().st_ino == before.st_ino
    remove_copies(url)
    assert not copy.exists()
    assert local_path(url).stat().st_mtime_ns == before.st_mtime_ns
    assert local_path(stored(b"two")).stat().st_mtime_ns != before.st_mtime_ns


def test_old_copies_make_room(monkeypatch):
    monkeypatch.setattr(remote_files, "_MOST_BYTES", 5)
    old, used = local_path(stored(b"old", "old.mp4")), local_path(stored(b"used", "used.mp4"))
    os.utime(old.parent, (0, 0))
    local_path(stored(b"new", "new.mp4"))
    assert [old.exists(), used.exists()] == [False, True]


def test_what_cannot_be_copied_is_named(monkeypatch):
    with pytest.raises(InputError, match=r"memory://bucket/none.mp4: .* no such file"):
        local_path(Path("memory://bucket/none.mp4"))
    with pytest.raises(InputError, match=r"zzz://a.mp4: cannot be transferred: Protocol not known"):
        local_path(Path("zzz://a.mp4"))
    monkeypatch.setitem(sys.modules, "fsspec.core", None)
    with pytest.raises(UsageError, match=r"s3://b/a.mp4: .* install .*procc-annotator\[cloud\]"):
        local_path(Path("s3://b/a.mp4"))
