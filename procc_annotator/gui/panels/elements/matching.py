"""Type-ahead: which field element a few letters mean."""

from __future__ import annotations

from collections.abc import Iterable

from procc_annotator.field.model import Element


def match_rank(query: str, *names: str) -> int | None:
    """How well a query fits one thing of several names: lower is better, None is not at all.

    A query fits when each of its words begins a word of one name (``l p b`` finds "Left penalty
    area, bottom"), or when a name contains it.
    """
    wanted = query.casefold().split()
    if not wanted:
        return 0
    ranks = [_rank_name(wanted, " ".join(wanted), name.casefold()) for name in names]
    return min((r for r in ranks if r is not None), default=None)


def best_match(query: str, elements: Iterable[Element]) -> Element | None:
    """The element a query means most likely; the field's order decides between equals."""
    best: tuple[int, Element] | None = None
    for element in elements:
        rank = match_rank(query, element.title, element.name, element.shortcut)
        if rank is not None and (best is None or rank < best[0]):
            best = (rank, element)
    return best[1] if best and query.strip() else None


def _rank_name(wanted: list[str], text: str, name: str) -> int | None:
    name = " ".join(name.replace(",", " ").replace(".", " ").split())
    if not name:
        return None
    if name == text:
        return 0
    if name.startswith(text):
        return 1
    words = name.split()
    at = 0
    for word in words:
        if at < len(wanted) and word.startswith(wanted[at]):
            at += 1
    if at == len(wanted):
        return 2
    if all(any(w.startswith(part) for w in words) for part in wanted):
        return 3
    return 4 if text in name else None
