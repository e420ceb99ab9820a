"""Parts of messages: counts with nouns, shortened lists, how to install optional extras."""

from __future__ import annotations

import importlib.util
import re
import shlex
import sys
from collections.abc import Mapping, Sequence

_SHOWN_NAMES = 5
# So many remarks that differ in their numbers only are reported one by one.
_MAX_SIMILAR = 5
_SHOWN_SIMILAR = 3
_NUMBER = re.compile(r"\d+")


def pluralize(count: int, thing: str, several: str = "", *, thousands: str = "") -> str:
    """``1 frame``, ``2 frames``, or what is to be said of ``several``; thousands: set apart by."""
    return f"{count:{thousands}} {thing if count == 1 else several or f'{thing}s'}"


def first_names(names: Sequence[str]) -> str:
    """The first few of many names: ``a, b, c, d, e, ...``."""
    return ", ".join(names[:_SHOWN_NAMES]) + (", ..." if len(names) > _SHOWN_NAMES else "")


def list_names(names: Sequence[str], thing: str, several: str = "") -> str:
    """How many there are and the first few of them: ``2 frames (a, b)``."""
    return f"{pluralize(len(names), thing, several)} ({first_names(names)})"


def condensed(remarks: Mapping[str, int]) -> dict[str, int]:
    """Remarks and for how many each is, where many differ in their numbers only (sizes of
    pictures) the most frequent of those, and how many more there are and for how many."""
    alike: dict[str, list[str]] = {}
    for remark in remarks:
        alike.setdefault(_NUMBER.sub("0", remark), []).append(remark)
    told: dict[str, int] = {}
    for some in alike.values():
        if len(some) <= _MAX_SIMILAR:
            told |= {remark: remarks[remark] for remark in some}
            continue
        by_count = sorted(some, key=lambda remark: -remarks[remark])
        first, rest = by_count[:_SHOWN_SIMILAR], by_count[_SHOWN_SIMILAR:]
        told |= {remark: remarks[remark] for remark in first}
        told[f"and {len(rest)} more like {first[-1]!r}"] = sum(remarks[remark] for remark in rest)
    return told


# What each is for, and the library that it brings.
EXTRAS = {
    "dask": ("a Dask cluster", "distributed"),
    "cloud": ("object stores", "fsspec"),
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
