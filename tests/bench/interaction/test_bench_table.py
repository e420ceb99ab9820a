"""What hands wait for, row by row, with labelme's figures beside ours where labelme can be run.

`LABELME_PYTHON` names the interpreter of an environment of its own with labelme in it, which this
project never has. The programs run in turn, so that a busy machine is busy for both; figures are
medians in ms until painted, in brackets the CPU time of the interface's thread. Machines differ:
nothing here fails on a time.
"""

import json
import os
import statistics
import subprocess
import sys
import time
from collections import defaultdict
from pathlib import Path
from typing import Any

from tests.bench.interaction.pictures import make_datasets

FRAMES = 2_000
RUNS = int(os.environ.get("BENCH_RUNS", "3"))
ROOT = Path(__file__).resolve().parents[3]
ROWS = (
    "next frame, prefetched",
    "next frame, decoded",
    "drag, per move, snapping and loupe",
    "drag, per move, neither",
    "release of a drag, saved and shown",
    "an element finished (Enter), shown",
    "click that snaps",
    "undo",
    "save",
)

Run = dict[str, Any]


def test_table(benchmark, sample_data, tmp_path):
    ours, theirs, cameras = make_datasets(sample_data, tmp_path, FRAMES)
    labelme = os.environ.get("LABELME_PYTHON")
    runs: dict[str, list[Run]] = defaultdict(list)

    # Programs are started from bytecode, as those that were installed are.
    compiled = {"PYTHONPYCACHEPREFIX": str(tmp_path / "compiled"), "PYTHONDONTWRITEBYTECODE": ""}
    os.environ.update(compiled)
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    warm = [sys.executable, "-c", "import procc_annotator.gui.app"]
    subprocess.run(warm, env=environment, check=True)

    def measure() -> None:
        first = str(600 + 420 * (len(runs["ours"]) % 3))
        terms = (str(tmp_path / "settings"), first)
        if labelme:
            runs["labelme"].append(_run(labelme, "labelme_hand.py", str(theirs), *terms))
        runs["ours"].append(_run(sys.executable, "our_hand.py", str(ours), *terms))
        judged = _run(sys.executable, "our_hand.py", str(ours), *terms, more=[str(cameras)])
        runs["with a judged camera"].append(judged)

    benchmark.pedantic(measure, rounds=RUNS)
    for run in (*runs["ours"], *runs["with a judged camera"]):
        assert set(ROWS) <= set(run["rows"])
        assert all(run["rows"].values())  # every row was done
    print("\n" + table(runs))


def _run(python: str, script: str, *terms: str, more: list[str] | None = None) -> Run:
    folder = Path(__file__).parent
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    paths = str(folder) if script == "labelme_hand.py" else str(ROOT)
    environment["PYTHONPATH"] = paths
    begun = str(time.monotonic())
    command = [python, str(folder / script), *terms, begun, *(more or [])]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-3000:]
    found: Run = json.loads(done.stdout.splitlines()[-1])
    return found


def table(runs: dict[str, list[Run]]) -> str:
    """All rows, a column for each program."""
    lines = [f"{'':38}" + "".join(f"{name:>24}" for name in runs)]
    for row in ROWS:
        cells = [
            _cell([t for run in column for t in run["rows"].get(row, [])])
            for column in runs.values()
        ]
        lines.append(f"{row:38}" + "".join(f"{cell:>24}" for cell in cells))
    for count in ("75", "500"):
        cells = [
            f"{statistics.median(run['memory'][count] for run in column):.0f} MB"
            for column in runs.values()
        ]
        lines.append(f"{f'memory after {count} frames':38}" + "".join(f"{c:>24}" for c in cells))
    cells = [f"{statistics.median(r['start'] for r in c):.2f} s" for c in runs.values()]
    lines.append(f"{'start to painted window':38}" + "".join(f"{cell:>24}" for cell in cells))
    cells = [
        f"{max((t for r in c for t in r.get('longest', [])), default=float('nan')):.0f}"
        for c in runs.values()
    ]
    lines.append(
        f"{'longest pause of a walk over 500':38}" + "".join(f"{cell:>24}" for cell in cells)
    )
    return "\n".join(lines)


def _cell(times: list[tuple[float, float]]) -> str:
    if not times:
        return "-"
    walls, cpus = zip(*times, strict=True)
    return f"{statistics.median(walls):.2f} ({statistics.median(cpus):.2f})"
