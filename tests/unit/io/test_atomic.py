"""A save either happened or did not: at every point of failure the old file is whole."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path
from typing import Any

import pytest

from procc_annotator.errors import SaveError
from procc_annotator.io.atomic import write_atomic


@pytest.mark.parametrize("step", ["open", "fchmod", "fsync", "replace"])
def test_a_failure_at_any_step_leaves_the_old_file(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, step: str
) -> None:
    path = tmp_path / "1.json"
    path.write_bytes(b"old")

    def fail(*_: Any) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(os, step, fail)
    with pytest.raises(SaveError, match="No space left on device") as caught:
        write_atomic(path, b"new")
    monkeypatch.undo()
    assert str(path) in str(caught.value)
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


def test_a_failed_first_save_leaves_nothing(tmp_path: Path) -> None:
    with pytest.raises(SaveError, match="No such file or directory"):
        write_atomic(tmp_path / "absent" / "1.json", b"new")
    assert list(tmp_path.iterdir()) == []


def test_permissions_are_kept_and_links_followed(tmp_path: Path) -> None:
    target = tmp_path / "real.json"
    target.write_bytes(b"old")
    target.chmod(0o640)
    link = tmp_path / "link.json"
    link.symlink_to(target)
    write_atomic(link, b"new")
    assert link.is_symlink()
    assert target.read_bytes() == b"new"
    assert stat.S_IMODE(target.stat().st_mode) == 0o640


def test_a_folder_in_the_way_is_said(tmp_path: Path) -> None:
    (tmp_path / "1.json").mkdir()
    with pytest.raises(SaveError, match="could not be saved"):
        write_atomic(tmp_path / "1.json", b"new")
    assert [p.name for p in tmp_path.iterdir()] == ["1.json"]
