"""What the documentation shows runs as it stands."""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import procc_annotator

ROOT = Path(__file__).parents[1]


def run(*arguments: str | Path) -> str:
    """What a fresh Python prints, where Qt cannot be imported."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, *map(str, arguments)],
        cwd=ROOT, env=environment, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return done.stdout


def test_the_example_fits_and_scores_the_sample_data(tmp_path):
    printed = run("docs/examples/fit_and_score.py", "--cameras", tmp_path, "--tau", "2")
    rows = {line.split()[0]: line for line in printed.splitlines()[1:]}
    annotated = {p.stem for p in (ROOT / "sample_data").glob("*.json")}
    assert set(rows) == annotated
    failed = {name for name, row in rows.items() if "no camera: " in row}
    assert {p.stem.removeprefix("camera_") for p in tmp_path.iterdir()} == annotated - failed
    scores = [float(row.split()[2]) for name, row in rows.items() if name not in failed]
    assert min(scores) > 0.9
    assert "JaC" in run("-m", "procc_annotator", "evaluate", "sample_data", tmp_path, "-t", "2")


def test_the_example_says_what_is_missing(tmp_path):
    done = subprocess.run(
        [sys.executable, "docs/examples/fit_and_score.py", str(tmp_path)],
        cwd=ROOT, env={**os.environ, "PYTHONPATH": str(ROOT)}, capture_output=True, text=True,
        timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 1
    assert "no annotation" in done.stderr


def test_python_of_the_readme():
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL)
    assert blocks
    for block in blocks:
        printed = run("-c", block)
        assert re.search(r"model \S+, JaC 1\.00, tp 12, fp 0, fn 0", printed), printed
        assert "standard deviation of pan" in printed


def test_the_example_goes_on_past_damaged_files(tmp_path):
    good = (ROOT / "sample_data" / "00002.json").read_bytes()
    for name, content in (("1", b"{"), ("2", good), ("3", b"[]"), ("camera_2", b"{}")):
        (tmp_path / f"{name}.json").write_bytes(content)
    done = subprocess.run(
        [sys.executable, "docs/examples/fit_and_score.py", str(tmp_path)],
        cwd=ROOT, env={**os.environ, "PYTHONPATH": str(ROOT)}, capture_output=True, text=True,
        timeout=120, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (1, "")
    lines = done.stdout.splitlines()[1:]
    assert [line.split()[0] for line in lines] == ["1", "2", "3"]
    assert ["unreadable" in line for line in lines] == [True, False, True]


def test_the_example_to_copy_runs(tmp_path):
    example = shutil.copy(ROOT / "docs/examples/judge_a_camera.py", tmp_path)
    printed = run(example, ROOT / "sample_data", tmp_path)
    assert printed.startswith(run(example)[:200])
    assert re.search(r"JaC@5 0\.\d+, completeness", printed), printed
    assert re.search(r"between 0\.\d+ and [01]\.\d+ in 95 of 100", printed), printed
    assert printed.count("tau ") >= 4
    (picture,) = tmp_path.glob("*.png")
    assert f"written: {picture}" in printed
    told = "pandas is not installed" if importlib.util.find_spec("pandas") is None else "mean"
    assert told in printed.splitlines()[-1] + printed


def programs() -> list[str]:
    """The programs of all pages that import the package."""
    pages = "".join(path.read_text() for path in sorted((ROOT / "docs").rglob("*.md")))
    found = re.findall(r"```python\n(.*?)```", pages, re.DOTALL)
    return [block for block in found if "import procc_annotator as procc" in block]


def test_programs_of_the_pages_use_public_names():
    blocks = programs()
    assert len(blocks) > 5
    used = set(re.findall(r"procc\.(\w+)", "".join(blocks)))
    assert used <= set(procc_annotator.__all__)


def test_type_checkers_understand_what_uses_the_package(tmp_path):
    """As a program of somebody else: what is public is typed, and mistakes are found."""
    (tmp_path / "uses.py").write_text(
        "import numpy as np\n"
        "import procc_annotator as procc\n"
        "dataset = procc.load_dataset('sample_data')\n"
        "score: procc.SetScore = procc.evaluate_set(dataset, 'cameras', thresholds=(2.0, 5.0))\n"
        "mean: float | None = score.summaries[5.0].mean_jac\n"
        "camera = procc.camera_from_projection(np.eye(3, 4))\n"
        "pixels, valid = camera.project(np.zeros((1, 3)))\n"
        "drawn = procc.draw_overlay('a.jpg', dataset.annotations['1'], camera)\n"
        "reveal_type(drawn.shape)\n"
        "procc.evaluate(dataset, camera)\n"
        "procc.evaluate_sets(dataset, camera)\n"
    )
    files = [tmp_path / "uses.py"]
    for block in programs():
        files.append(tmp_path / f"block{len(files)}.py")
        files[-1].write_text(block)
    # With the settings and what is kept of the project's own check: it takes a sixth of the time.
    done = subprocess.run(
        [sys.executable, "-m", "mypy", *map(str, files)],
        cwd=ROOT, capture_output=True, text=True, timeout=240, check=False,
    )  # fmt: skip
    errors = [line.split("uses.py:")[1] for line in done.stdout.splitlines() if "error:" in line]
    assert [error.split(":")[0] for error in errors] == ["10", "11"], done
    assert "block" not in done.stdout
    assert "tuple[" in done.stdout
