"""Whoever reads only the first lines of what a command prints has all its files."""

from __future__ import annotations

import json
import shutil

import pytest

from procc_annotator.cli import console


class ReaderLeft(Exception):
    """In place of a broken pipe, at which the command lets go of the process's own stdout."""


@pytest.fixture
def nobody_reads(monkeypatch) -> None:
    def broken(*args: object) -> None:
        raise ReaderLeft

    monkeypatch.setattr(console._Console, "_write", broken)


def test_the_comparison_is_written(cli, dataset, tmp_path, nobody_reads) -> None:
    cameras, out, pictures = dataset.root / "cameras", tmp_path / "c.json", tmp_path / "pictures"
    with pytest.raises(ReaderLeft):
        cli("compare", f"a={cameras}", f"b={cameras}", "-o", out, "--pictures", pictures)
    assert json.loads(out.read_text())
    assert list(pictures.iterdir())


def test_the_figures_over_time_are_written(cli, dataset, tmp_path, nobody_reads) -> None:
    out, shots = tmp_path / "t.json", tmp_path / "shots.csv"
    shots.write_text("frame,shot\n" + "".join(f"{name},one\n" for name in dataset.pans))
    with pytest.raises(ReaderLeft):
        cli("evaluate", dataset.root, dataset.root / "cameras", "--over-time", "--shots", shots,
            "--over-time-output", out)  # fmt: skip
    assert json.loads(out.read_text())


def test_the_dimensions_are_kept(cli, dataset, tmp_path, nobody_reads) -> None:
    match = tmp_path / "alone"
    shutil.copytree(dataset.annotations, match)
    with pytest.raises(ReaderLeft):
        cli("field-size", match, "--save")
    assert (match / ".procc").exists()
