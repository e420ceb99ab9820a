"""Locate bundled resources and the user's data and cache folders."""

from __future__ import annotations

import os
import sys
from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent


def resources_dir() -> Path:
    """The folder that holds ``field/``, ``report/`` and ``desktop/``. `FileNotFoundError` if the
    installation is incomplete."""
    for folder in (_PACKAGE / "_resources", _PACKAGE.parent / "resources"):
        if (folder / "field").is_dir():
            return folder
    raise FileNotFoundError("the package's resources are missing: reinstall procc-annotator")


def data_folder() -> Path | None:
    """Return where programs keep what is theirs and the user's (on Linux as the XDG base
    directories say).

    Returns:
        None when the user has no home.
    """
    return _user_folder("XDG_DATA_HOME", "~/.local/share", "~/Library/Application Support")


def cache_folder() -> Path | None:
    """Return where programs keep what they can compute again, as `data_folder`."""
    return _user_folder("XDG_CACHE_HOME", "~/.cache", "~/Library/Caches")


def _user_folder(variable: str, linux: str, mac: str) -> Path | None:
    if sys.platform == "win32":
        named, usual = os.environ.get("LOCALAPPDATA", ""), "~/AppData/Local"
    elif sys.platform == "darwin":
        named, usual = "", mac
    else:
        named, usual = os.environ.get(variable, ""), linux
    folder = named if os.path.isabs(named) else os.path.expanduser(usual)
    return Path(folder) if os.path.isabs(folder) else None
