"""Where the standalone program starts, with a terminal or without."""

import multiprocessing
import sys
from pathlib import Path

from procc_annotator.cli.main import run, run_window

if __name__ == "__main__":
    multiprocessing.freeze_support()  # worker processes are this program, started once more
    (run_window if Path(sys.executable).stem.endswith("-window") else run)()
