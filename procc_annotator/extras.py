"""Parts of the installation that only some need: how to have them, where this program runs."""

from __future__ import annotations

import importlib.util
import shlex
import sys

# What each is for, and the library that it brings.
EXTRAS = {
    "dask": ("a Dask cluster", "distributed"),
    "parquet": ("Parquet tables", "pyarrow"),
}


def install_hint(extra: str) -> str:
    """The line that adds an extra to this very installation, as words for a message.

    Args:
        extra: one of `EXTRAS`.
    """
    if getattr(sys, "frozen", False):
        return (
            f"the standalone folder goes without {EXTRAS[extra][0]}: install the program into a"
            f" Python, pip install 'procc-annotator[{extra}]'"
        )
    python = shlex.quote(sys.executable)
    if importlib.util.find_spec("pip") is not None:
        return f"install it with: {python} -m pip install 'procc-annotator[{extra}]'"
    return f"install it with: uv pip install --python {python} 'procc-annotator[{extra}]'"
