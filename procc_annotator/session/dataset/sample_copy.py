"""The sample to try things on: a copy of the user's own, so that nothing of the program changes."""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path

from procc_annotator.errors import SaveError
from procc_annotator.io.user_folders import data_folder


def copy_sample(sample: Path) -> Path:
    """The user's copy of the sample; made if there is none, else as they left it.

    Args:
        sample: the folder that comes with the program.

    Returns:
        The folder, below the user's data folder; it is there wholly or not at all.

    Raises:
        SaveError: it cannot be made.
    """
    home = data_folder()
    if home is None:
        raise SaveError("the sample cannot be copied: there is no home folder")
    own = home / "procc-annotator" / "sample"
    if own.is_dir():
        return own
    try:
        own.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=own.parent) as begun:
            copied = Path(begun) / own.name
            shutil.copytree(sample, copied, ignore=shutil.ignore_patterns(".procc", "__pycache__"))
            os.replace(copied, own)
    except (OSError, shutil.Error) as error:
        if own.is_dir():  # another window was faster
            return own
        raise SaveError(f"{own}: the sample cannot be copied here ({error})") from error
    return own
