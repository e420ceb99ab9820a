"""Every command where Qt cannot be loaded: pictures are drawn plainer, figures need none of it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np

WITHOUT = """
import sys
class NoQt:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] in ("PySide6", "shiboken6", "pyqtgraph"):
            raise ImportError("libEGL.so.1: cannot open shared object file", name=name)
sys.meta_path.insert(0, NoQt())
from procc_annotator.cli.main import run
sys.argv = ["procc-annotator", *sys.argv[1:]]
run()
"""


def without_qt(*arguments: object) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", WITHOUT, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_pictures_are_drawn_with_what_is_there(dataset, tmp_path: Path) -> None:
    for kind in ("png", "svg"):
        out = tmp_path / kind
        done = without_qt(
            "render", dataset.root, out, "--cameras", dataset.cameras, "--format", kind
        )  # fmt: skip
        assert done.returncode == 0, done.stderr
        assert done.stderr.count("Qt cannot be loaded here (libEGL.so.1") == 1
        assert len(list(out.iterdir())) == 5
    drawn = cv2.imread(str(tmp_path / "png" / "1.png"))
    assert drawn.shape == (540, 960, 3)
    plain = cv2.imread(str(dataset.root / "1.jpg"))
    if plain is not None:
        assert np.abs(drawn.astype(int) - plain).max() > 100  # there are lines on it
    assert "<svg" in (tmp_path / "svg" / "1.svg").read_text()


def test_a_report_has_its_pictures(dataset, tmp_path: Path) -> None:
    page = tmp_path / "r.html"
    done = without_qt(
        "report", dataset.root, "--cameras", dataset.cameras, "--worst", 1, "--random", 0,
        "--output", page,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert page.read_text().count("<img") == 1
    assert "disagreement" not in done.stderr  # nobody asked for it


def test_figures_do_not_even_ask_for_qt(dataset, tmp_path: Path) -> None:
    names = ("r.json", "r.csv", "r.tex")
    outputs = [word for name in names for word in ("--output", tmp_path / name)]
    done = without_qt("report", dataset.root, "--cameras", dataset.cameras, *outputs)
    assert (done.returncode, done.stderr) == (0, "")
    assert all((tmp_path / name).stat().st_size for name in names)


def test_the_window_says_what_is_missing_in_a_line(dataset) -> None:
    done = without_qt("open", dataset.root)
    assert done.returncode == 2
    assert "Traceback" not in done.stderr
