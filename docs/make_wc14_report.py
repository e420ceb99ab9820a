"""Make the example report of the World Cup 2014 test set again.

    python docs/make_wc14_report.py DATA

DATA is a folder with ``annotations/`` (the 186 test frames in SoccerNet form),
``homographies_carwc/``, ``cameras_nbjw/`` and ``cameras_pnlcalib/``. The files go to
``docs/examples/wc14_report/``.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

OUT = Path(__file__).resolve().parent / "examples" / "wc14_report"
FOLDERS = ("annotations", "homographies_carwc", "cameras_nbjw", "cameras_pnlcalib")


def arguments(data: Path) -> list[str]:
    """The command line of the example."""
    command = [
        "report", str(data / "annotations"),
        "--cameras", f"CARWC:carwc={data / 'homographies_carwc'}",
        "--cameras", f"NBJW={data / 'cameras_nbjw'}",
        "--cameras", f"PnLCalib={data / 'cameras_pnlcalib'}",
        "--title", "World Cup 2014: homographies and pinhole cameras",
        "--reference", "CARWC", "--disagreement", "CARWC,PnLCalib",
        "--worst", "4", "--random", "2", "--picture-width", "800",
    ]  # fmt: skip
    for name in ("report.html", "table.tex", "figures.csv"):
        command += ["--output", str(OUT / name)]
    return command


def main() -> None:
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    data = Path(sys.argv[1])
    missing = [name for name in FOLDERS if not (data / name).is_dir()]
    if missing:
        sys.exit(f"{data}: has no folder {missing[0]}")
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    OUT.mkdir(parents=True, exist_ok=True)
    from procc_annotator.cli.main import app

    app(arguments(data), prog_name="procc-annotator")


if __name__ == "__main__":
    main()
