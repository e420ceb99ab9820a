"""The user's own copy of the sample: made once, whole, and left as they left it."""

from __future__ import annotations

from pathlib import Path

import pytest

from procc_annotator.dataset.layout import copy_sample
from procc_annotator.errors import SaveError


@pytest.fixture
def sample(tmp_path, monkeypatch) -> Path:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path / "data"))
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    folder = tmp_path / "sample"
    (folder / "cameras").mkdir(parents=True)
    (folder / "00001.json").write_text("{}")
    (folder / "cameras" / "a.json").write_text("{}")
    (folder / ".procc").mkdir()
    (folder / ".procc" / "workspace.db").write_text("somebody else's")
    return folder


def test_a_copy_is_made_and_kept(sample) -> None:
    own = copy_sample(sample)
    assert own != sample
    found = sorted(p.relative_to(own).as_posix() for p in own.rglob("*") if p.is_file())
    assert found == ["00001.json", "cameras/a.json"]
    (own / "00001.json").write_text('{"mine": []}')
    assert copy_sample(sample) == own
    assert (own / "00001.json").read_text() == '{"mine": []}'
    assert (sample / "00001.json").read_text() == "{}"
    assert [p.name for p in own.parent.iterdir()] == ["sample"]


def test_a_copy_that_cannot_be_made_is_said_and_leaves_nothing(sample, monkeypatch) -> None:
    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("shutil.copytree", full)
    with pytest.raises(SaveError, match="No space left on device"):
        copy_sample(sample)
    monkeypatch.undo()


def test_two_windows_at_once(sample, monkeypatch) -> None:
    import os

    replace = os.replace

    def late(begun: Path, own: Path) -> None:
        own.mkdir(parents=True)
        (own / "theirs.json").write_text("{}")
        replace(begun, own)  # fails: it is there and not empty

    monkeypatch.setattr("os.replace", late)
    own = copy_sample(sample)
    assert (own / "theirs.json").exists()
