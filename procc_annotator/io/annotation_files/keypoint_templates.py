"""Categories that hold a template of keypoints: places of a field, each on several elements.

A category whose keypoints are a polyline (numbered, or joined one after the other) is none.
"""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from typing import Any

from procc_annotator.annotation import Point
from procc_annotator.field.model import Field
from procc_annotator.resources import resources_dir


@dataclass(frozen=True)
class KeypointTemplate:
    """What the keypoints of a category are.

    Attributes:
        name: in a file of labels.
        title: for people.
        field: the field it is of, for people.
        count: of its keypoints.
        names: what they are called, list by list, in their order.
        elements: class -> its keypoints from 0, in their order along it.
    """

    name: str
    title: str
    field: str
    count: int
    names: tuple[tuple[str, ...], ...]
    elements: Mapping[str, tuple[int, ...]]

    def shapes(self, points: Sequence[Point | None]) -> Iterator[tuple[str, tuple[Point, ...]]]:
        """The elements that any keypoint lies on, with their points.

        Args:
            points: the keypoints; None for those that are not labelled.
        """
        for name, places in self.elements.items():
            found = tuple(p for i in places if i < len(points) and (p := points[i]) is not None)
            if found:
                yield name, found

    def is_of(self, field: Field) -> bool:
        """Whether a field has all its elements."""
        return all(field.knows(field.canonical_name(name)) for name in self.elements)

    def _joins(self, edge: tuple[int, int]) -> bool:
        return any(edge[0] in some and edge[1] in some for some in self.elements.values())

    def matches(self, names: Sequence[Any], skeleton: Sequence[tuple[int, int]]) -> bool:
        """Whether keypoints of these names, joined so (from 0), are this template's."""
        if len(names) != self.count:
            return False
        return tuple(names) in self.names or (bool(skeleton) and all(map(self._joins, skeleton)))


@cache
def known_templates() -> tuple[KeypointTemplate, ...]:
    """The templates that the package ships."""
    text = (resources_dir() / "keypoint_templates.toml").read_text(encoding="utf-8")
    return tuple(
        KeypointTemplate(
            one["name"], one["title"], one["field"], one["count"], tuple(map(tuple, one["names"])),
            {name: tuple(i - 1 for i in some) for name, some in one["elements"].items()},
        )
        for one in tomllib.loads(text)["templates"]
    )  # fmt: skip


def holds_template(category: Mapping[str, Any]) -> bool:
    """Whether a category's keypoints are places rather than the points of one line."""
    names = category.get("keypoints")
    if type(names) is not list or len(names) < 2:
        return False
    skeleton = _skeleton(category)
    if len(skeleton) > 0:
        neighbours = set(map(frozenset, pairwise(range(len(names)))))
        return not neighbours <= set(map(frozenset, skeleton))
    return not _are_numbers(names)


def has_gaps(points: Sequence[Point | None]) -> bool:
    """Whether keypoints that are labelled come behind others that are not: no polyline is so."""
    seen = [point is not None for point in points]
    return seen != sorted(seen, reverse=True)


def template_named(name: object) -> KeypointTemplate | None:
    """A template by its name; None if there is none."""
    return next((known for known in known_templates() if known.name == name), None)


def template_of(category: Mapping[str, Any]) -> KeypointTemplate | None:
    """The template a category holds; None if it is none that is known."""
    names, skeleton = category["keypoints"], _skeleton(category)
    return next((known for known in known_templates() if known.matches(names, skeleton)), None)


def _are_numbers(names: Sequence[Any]) -> bool:
    """Whether keypoints are just counted, from 0 or from 1."""
    return any(
        [str(name).lstrip("0") or "0" for name in names]
        == [str(i) for i in range(first, first + len(names))]
        for first in (0, 1)
    )


def _skeleton(category: Mapping[str, Any]) -> list[tuple[int, int]]:
    """The edges of a category, from 0; what is none is left out."""
    edges = category.get("skeleton")
    if type(edges) is not list:
        return []
    return [
        (edge[0] - 1, edge[1] - 1)
        for edge in edges
        if type(edge) is list and len(edge) == 2 and all(type(i) is int for i in edge)
    ]
