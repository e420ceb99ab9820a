"""Make the example report of the World Cup 2014 test set again.

    python docs/make_wc14_report.py DATA

DATA is a folder with ``annotations/`` (the 186 test frames in SoccerNet form),
``homographies_carwc/``, ``cameras_nbjw/`` and ``cameras_pnlcalib/``. The files go to
``docs/examples/wc14_report/``; where Chromium is there, pictures of the page go to
``docs/pictures/``, in both themes.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import cv2

OUT = Path(__file__).resolve().parent / "examples" / "wc14_report"
PICTURES = Path(__file__).resolve().parent / "pictures"
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
QUIET = (
    "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--hide-scrollbars",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
)  # fmt: skip
WINDOW, QUALITY = (1280, 1500), 88
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

    app(arguments(data), prog_name="procc-annotator", standalone_mode=False)
    take_pictures(OUT / "report.html")


def take_pictures(page: Path) -> None:
    """The top of a page as a browser shows it, light and dark; nothing where there is none."""
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        print(f"no pictures of {page.name}: none of {', '.join(BROWSERS)} is here")
        return
    for dark in (False, True):
        with tempfile.TemporaryDirectory() as folder:
            picture = Path(folder) / "page.png"
            size = f"--window-size={WINDOW[0]},{WINDOW[1]}"
            theme = ["--force-dark-mode"] if dark else []
            command = [browser, *QUIET, *theme, size, f"--user-data-dir={folder}/profile"]
            subprocess.run(
                [*command, f"--screenshot={picture}", page.as_uri()],
                check=True, capture_output=True, timeout=120,
            )  # fmt: skip
            name = PICTURES / f"report{'-dark' if dark else ''}.webp"
            cv2.imwrite(str(name), cv2.imread(str(picture)), [cv2.IMWRITE_WEBP_QUALITY, QUALITY])
            print(f"written: {name}")


if __name__ == "__main__":
    main()
