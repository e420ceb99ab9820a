"""Words for how many there are, and for which: every plural is made here."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

_SHOWN_NAMES = 5
# So many remarks that differ in their numbers only are told one by one.
_MAX_SIMILAR = 5
_SHOWN_SIMILAR = 3
_NUMBER = re.compile(r"\d+")


def count_words(count: int, thing: str, several: str = "", *, thousands: str = "") -> str:
    """``1 frame``, ``2 frames``, or what is to be said of ``several``; thousands: set apart by."""
    return f"{count:{thousands}} {thing if count == 1 else several or f'{thing}s'}"


def first_names(names: Sequence[str]) -> str:
    """The first few of many names: ``a, b, c, d, e, ...``."""
    return ", ".join(names[:_SHOWN_NAMES]) + (", ..." if len(names) > _SHOWN_NAMES else "")


def list_names(names: Sequence[str], thing: str, several: str = "") -> str:
    """How many there are and the first few of them: ``2 frames (a, b)``."""
    return f"{count_words(len(names), thing, several)} ({first_names(names)})"


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
