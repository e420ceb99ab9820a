"""Find the data the package ships: ``resources/`` in a checkout, ``_resources`` inside a wheel."""

from __future__ import annotations

from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent


def resources_dir() -> Path:
    """The folder that holds ``field/``, ``report/`` and ``desktop/``.

    Raises:
        FileNotFoundError: the installation is incomplete.
    """
    for folder in (_PACKAGE / "_resources", _PACKAGE.parent / "resources"):
        if (folder / "field").is_dir():
            return folder
    raise FileNotFoundError("the package's resources are missing: reinstall procc-annotator")
