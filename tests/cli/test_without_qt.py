"""Every command where Qt cannot be loaded: pictures are drawn plainer, figures need none of it."""

import json
import os
import runpy
import subprocess
import sys
from pathlib import Path

import cv2
import numpy as np

from procc_annotator.cli.main import COMMANDS

ROOT = Path(__file__).parents[2]
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


def test_pictures_are_drawn_with_what_is_there(dataset, tmp_path):
    out = tmp_path / "svg"
    done = without_qt("render", dataset.root, out, "--cameras", dataset.cameras, "--format", "svg")
    assert done.returncode == 0, done.stderr
    assert done.stderr.count("Qt cannot be loaded here (libEGL.so.1") == 1
    assert len(list(out.iterdir())) == 5
    assert "<svg" in (out / "1.svg").read_text()


def test_a_report_has_its_pictures(dataset, tmp_path):
    page = tmp_path / "r.html"
    done = without_qt(
        "report", dataset.root, "--cameras", dataset.cameras, "--worst", 1, "--random", 0,
        "--output", page,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert page.read_text().count("<img") == 1
    assert "disagreement" not in done.stderr  # nobody asked for it


def test_figures_do_not_even_ask_for_qt(dataset, tmp_path):
    names = ("r.json", "r.csv", "r.tex")
    outputs = [word for name in names for word in ("--output", tmp_path / name)]
    done = without_qt("report", dataset.root, "--cameras", dataset.cameras, *outputs)
    assert (done.returncode, done.stderr) == (0, "")
    assert all((tmp_path / name).stat().st_size for name in names)


def test_the_window_says_what_is_missing_in_a_line(dataset):
    done = without_qt("open", dataset.root)
    assert done.returncode == 2
    assert "Traceback" not in done.stderr


EVERY = """
import json
import os
from procc_annotator.cli.main import app
asked = json.load(sys.stdin)
ended = []
for arguments in asked:
    try:
        app(arguments, prog_name="procc-annotator")
        ended.append(0)
    except SystemExit as end:
        ended.append(end.code)
print(json.dumps(ended), file=sys.stderr)
"""


def test_every_command_does_its_work(dataset, sample_data, tmp_path):
    """All of them one after the other in one program: what they need of Qt is nothing."""
    root, cameras = dataset.root, dataset.cameras
    one = tmp_path / "one"
    one.mkdir()
    for file in ("00002.jpg", "00002.json"):
        (one / file).write_bytes((sample_data / file).read_bytes())
    bare = tmp_path / "bare"
    bare.mkdir()
    (bare / "1.jpg").write_bytes((one / "00002.jpg").read_bytes())
    shape = '<polyline label="halfway line" points="0.0,0.0;10.0,10.0"></polyline>'
    image = f'<image id="0" name="1.jpg" width="960" height="540">{shape}</image>'
    (tmp_path / "named.xml").write_text(f"<annotations>{image}</annotations>")
    (tmp_path / "points.csv").write_text("frame,x,y\n2,1,2\n")
    (tmp_path / "gold.csv").write_text("frame\n1\n2\n")
    runpy.run_path(str(ROOT / "docs/examples/three_views.py"))["make_dataset"](tmp_path / "views")
    tree, others = sample_data / "cameras" / "true", dataset.annotations
    commands: list[list[object]] = [
        ["evaluate", root, cameras, "--manifest", tmp_path / "manifest.json"],
        ["repeat", tmp_path / "manifest.json", "--data", root],
        ["agree", root, others],
        ["agree", others, "--reference", root, "--frames", tmp_path / "gold.csv"],
        ["compare", f"a={cameras}", f"b={cameras}", root],
        ["report", root, "--cameras", cameras, "-o", tmp_path / "r.csv"],
        ["calibrate", root, tmp_path / "fitted", "--model", "P"],
        ["propose", bare, tmp_path / "proposed", "--known-positions", tree / "camera_00002.json"],
        ["track", one, tmp_path / "tracked", "--cameras", tree],
        ["status", tmp_path / "tracked"],
        ["annotate", one, tmp_path / "annotated", "--cameras", tree],
        ["check", root],
        ["field-size", root],
        ["triangulate", tmp_path / "views"],
        ["export", root, tmp_path / "out.zip"],
        ["ground", tmp_path / "points.csv", "--cameras", cameras],
        ["convert", root, tmp_path / "match.xml", "--to", "cvat"],
        ["convert", cameras, tmp_path / "sub.zip", "--to", "submission"],
        ["propose-map", tmp_path / "named.xml"],
        ["release", root, tmp_path / "released"],
        ["render", one, tmp_path / "drawn", "--cameras", tree],
        ["figure", one, tmp_path / "figure.svg", "--cameras", tree],
        ["check-submission", tmp_path / "sub.zip"],
        ["desktop-entry", "--install"],
        ["field", "list"],
        ["field", "show", "tennis"],
    ]
    assert {str(command[0]) for command in commands} == {c.name for c in COMMANDS} - {"open"}
    done = subprocess.run(
        [sys.executable, "-c", WITHOUT.rpartition("from procc")[0] + EVERY],
        input=json.dumps([[str(word) for word in command] for command in commands]),
        capture_output=True, text=True, check=False, cwd=tmp_path,
        env={**os.environ, "XDG_DATA_HOME": str(tmp_path / "share"), "HOME": str(tmp_path)},
    )  # fmt: skip
    assert "Traceback" not in done.stderr, done.stderr
    ended = json.loads(done.stderr.splitlines()[-1])
    for command, code in zip(commands, ended, strict=True):
        assert code == 0, (command, code, done.stderr)
    drawn, plain = (cv2.imread(str(tmp_path / f)) for f in ("drawn/00002.png", "one/00002.jpg"))
    assert np.abs(drawn.astype(int) - plain).max() > 100  # there are lines on it
