"""A save either happened or did not: at every point of failure the old file is whole."""

import errno
import os
import stat
from typing import Any

import pytest

from procc_annotator.errors import SaveError
from procc_annotator.formats.atomic import open_replacing, sibling_path, try_lock, write_atomic


@pytest.mark.parametrize("step", ["access", "open", "fdopen", "fchmod", "fsync", "replace"])
def test_a_failure_at_any_step_leaves_the_old_file(tmp_path, monkeypatch, step):
    path = tmp_path / "1.json"
    path.write_bytes(b"old")

    def fail(*_: Any) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(os, step, fail)
        with pytest.raises(SaveError, match="No space left on device") as caught:
            write_atomic(path, b"new")
    assert str(path) in str(caught.value)
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


class _FullDisk:
    """A file whose disk is full after three bytes."""

    def __init__(self, file: Any) -> None:
        self.file = file

    def __enter__(self):
        return self

    def __exit__(self, *_: object) -> None:
        self.file.close()

    def fileno(self) -> int:
        return int(self.file.fileno())

    def write(self, data: bytes) -> None:
        self.file.write(data[:3])
        self.file.flush()
        raise OSError(errno.ENOSPC, "No space left on device")


def test_a_disk_that_fills_up_in_the_middle(tmp_path, monkeypatch):
    path = tmp_path / "1.json"
    path.write_bytes(b"old")
    fdopen = os.fdopen
    with monkeypatch.context() as patch:
        patch.setattr(os, "fdopen", lambda *a: _FullDisk(fdopen(*a)))
        with pytest.raises(SaveError, match="No space left on device"):
            write_atomic(path, b"new content")
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


def test_an_interruption_leaves_no_temporary_file(tmp_path, monkeypatch):
    path = tmp_path / "1.json"
    path.write_bytes(b"old")

    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(os, "fsync", interrupt)
        with pytest.raises(KeyboardInterrupt):
            write_atomic(path, b"new")
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


def test_a_folder_that_cannot_be_synced_does_not_fail_the_save(tmp_path, monkeypatch):
    fsync = os.fsync

    def files_only(descriptor: int) -> None:
        if stat.S_ISDIR(os.fstat(descriptor).st_mode):
            raise OSError(errno.EINVAL, "Invalid argument")
        fsync(descriptor)

    with monkeypatch.context() as patch:
        patch.setattr(os, "fsync", files_only)
        write_atomic(tmp_path / "1.json", b"new")
    assert (tmp_path / "1.json").read_bytes() == b"new"


def test_a_write_protected_file_is_not_replaced(tmp_path, monkeypatch):
    path = tmp_path / "1.json"
    path.write_bytes(b"old")
    path.chmod(0o444)
    with monkeypatch.context() as patch:
        # An administrator may write to everything; be nobody special.
        patch.setattr(os, "access", lambda *_: False)
        with pytest.raises(SaveError, match="write-protected"):
            write_atomic(path, b"new")
    assert path.read_bytes() == b"old"


def test_the_longest_file_name_can_be_saved(tmp_path):
    path = tmp_path / ("n" * 250 + ".json")
    write_atomic(path, b"new")
    assert path.read_bytes() == b"new"


def test_a_failed_first_save_leaves_nothing(tmp_path):
    with pytest.raises(SaveError, match="No such file or directory"):
        write_atomic(tmp_path / "absent" / "1.json", b"new")
    assert list(tmp_path.iterdir()) == []


def test_permissions_are_kept_and_links_followed(tmp_path):
    target = tmp_path / "real.json"
    target.write_bytes(b"old")
    target.chmod(0o640)
    link = tmp_path / "link.json"
    link.symlink_to(target)
    write_atomic(link, b"new")
    assert link.is_symlink()
    assert target.read_bytes() == b"new"
    assert stat.S_IMODE(target.stat().st_mode) == 0o640


def test_a_folder_in_the_way_is_said(tmp_path):
    (tmp_path / "1.json").mkdir()
    with pytest.raises(SaveError, match="could not be saved"):
        write_atomic(tmp_path / "1.json", b"new")
    assert [p.name for p in tmp_path.iterdir()] == ["1.json"]


def test_a_stream_that_is_broken_off_leaves_the_old_file(tmp_path):
    path = tmp_path / "scores.json"
    path.write_text("old")

    def write() -> None:
        with open_replacing(path) as stream:
            stream.write(b"half")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        write()
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_what_killed_processes_left_is_removed(tmp_path):
    left, young, locked, other = (
        tmp_path / f".procc-{name}" for name in ("1.tmp", "2.tmp", "3.tmp", "4.json")
    )
    for path in (left, young, locked, other):
        path.write_bytes(b"half")
        if path != young:
            os.utime(path, (1e9, 1e9))
    with locked.open("rb") as file:
        assert try_lock(file.fileno())  # a process that is still writing
        write_atomic(tmp_path / "1.json", b"new")
    assert sorted(tmp_path.glob(".procc*")) == sorted({young, locked, other} - {left})


def test_a_name_as_long_as_it_may_be_is_written(tmp_path):
    for name in ("d" * 250, "\u00e4" * 125):
        write_atomic(tmp_path / name, b"new")
        assert (tmp_path / name).read_bytes() == b"new"
    assert sibling_path(tmp_path / "a", ".", ".lock") == tmp_path / ".a.lock"
