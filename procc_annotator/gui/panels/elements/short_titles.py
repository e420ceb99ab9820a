"""Titles of elements below the heading of their group, which has said a part of them already."""

from __future__ import annotations

from itertools import takewhile

from procc_annotator.field.model import Field


def short_titles(field: Field) -> dict[str, str]:
    """By class: the title without the leading words of its group that all titles there share.

    Below "Left three-point line" the "Left three-point far straight" is the "Far straight".
    """
    groups: dict[str, list[tuple[str, str]]] = {}
    for element in field.elements:
        groups.setdefault(element.group, []).append((element.name, element.title))
    found = {}
    for group, elements in groups.items():
        leading = _leading(group, [title for _, title in elements])
        for name, title in elements:
            rest = " ".join(title.split()[leading:])
            found[name] = f"{rest[:1].upper()}{rest[1:]}"
    return found


def _leading(group: str, titles: list[str]) -> int:
    """How many leading words of a group all its titles share, each having words beyond them."""
    if len(titles) < 2:
        return 0
    columns = zip(group.split(), *(title.split()[:-1] for title in titles), strict=False)
    return sum(1 for _ in takewhile(lambda words: len(set(words)) == 1, columns))
