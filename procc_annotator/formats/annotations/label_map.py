"""Label maps ``labels.toml``: rules from labels of other programs to classes, keypoint
templates, and writing a map.
"""

from __future__ import annotations

import json
import re
import tomllib
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

from procc_annotator.annotation import Point
from procc_annotator.errors import InputError
from procc_annotator.field.formulas import did_you_mean, printable_place, short_repr
from procc_annotator.field.load import read_toml_text
from procc_annotator.field.model import Field
from procc_annotator.messages import pluralize
from procc_annotator.resources import resources_dir


@dataclass(frozen=True)
class KeypointTemplate:
    """Meaning of a category's keypoints.

    Attributes:
        name: in a file of labels.
        field: the field it is of, for people.
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
        """The elements that any keypoint lies on (None: not labelled), with their points."""
        for name, places in self.elements.items():
            found = tuple(p for i in places if i < len(points) and (p := points[i]) is not None)
            if found:
                yield name, found

    def is_of(self, field: Field) -> bool:
        """Return whether a field has all its elements."""
        return all(field.knows(field.canonical_name(name)) for name in self.elements)

    def _joins(self, edge: tuple[int, int]) -> bool:
        return any(edge[0] in some and edge[1] in some for some in self.elements.values())

    def matches(self, names: Sequence[Any], skeleton: Sequence[tuple[int, int]]) -> bool:
        """Return whether keypoints of these names, joined so (from 0), are this template's."""
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
    """Return whether a category's keypoints are places rather than the points of one line."""
    names = category.get("keypoints")
    if type(names) is not list or len(names) < 2:
        return False
    skeleton = _skeleton(category)
    if len(skeleton) > 0:
        neighbours = set(map(frozenset, pairwise(range(len(names)))))
        return not neighbours <= set(map(frozenset, skeleton))
    return not _are_numbers(names)


def has_gaps(points: Sequence[Point | None]) -> bool:
    """Return whether keypoints that are labelled come behind others that are not: no polyline is
    so."""
    seen = [point is not None for point in points]
    return seen != sorted(seen, reverse=True)


def template_named(name: object) -> KeypointTemplate | None:
    """A template by its name; None if absent."""
    return next((known for known in known_templates() if known.name == name), None)


def template_of(category: Mapping[str, Any]) -> KeypointTemplate | None:
    """The template of a category; None if unknown."""
    names, skeleton = category["keypoints"], _skeleton(category)
    return next((known for known in known_templates() if known.matches(names, skeleton)), None)


def _are_numbers(names: Sequence[Any]) -> bool:
    """Return whether keypoints are just counted, from 0 or from 1."""
    return any(
        [str(name).lstrip("0") or "0" for name in names]
        == [str(i) for i in range(first, first + len(names))]
        for first in (0, 1)
    )


def _skeleton(category: Mapping[str, Any]) -> list[tuple[int, int]]:
    """The edges of a category, from 0; anything else is left out."""
    edges = category.get("skeleton")
    if type(edges) is not list:
        return []
    return [
        (edge[0] - 1, edge[1] - 1)
        for edge in edges
        if type(edge) is list and len(edge) == 2 and all(type(i) is int for i in edge)
    ]


LABELS_FILE = "labels.toml"
TOP_DOWN, LEFT_TO_RIGHT = ORDERS = "top_down", "left_to_right"
_TABLE = "labels"
_TEMPLATE = "template"
_LEFT_OUT = "name a class of the field, or false to leave the label out"
_NUMBERED = re.compile(r"(.*) \((\d{1,4})\)", re.DOTALL)

Shape = tuple[str, tuple[Point, ...]]


@dataclass(frozen=True, slots=True)
class OrderedClasses:
    """Classes that share a label: the shapes of a picture take them in the order of their middles.

    Attributes:
        order: one of `ORDERS`.
        classes: as many as a picture has shapes of the label.
    """

    order: str
    classes: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class TemplateRule:
    """A category of keypoints that are places of a template, by its name in
    `keypoint_templates`."""

    name: str


Rule = str | OrderedClasses | TemplateRule | None


@dataclass(frozen=True)
class LabelMap:
    """Which classes the labels of another program stand for.

    Attributes:
        rules: label -> its class, None where it is left out, classes by their order, or a template
            of keypoints.
    """

    path: Path
    rules: Mapping[str, Rule]

    def classes(self, shapes: Sequence[Shape]) -> tuple[list[str | None], list[str]]:
        """Return what the shapes of one picture are.

        Args:
            shapes: label and normalised points of each, in the order of the file.

        Returns:
            A class for each shape, its label where nothing is said of it, None where it is left
            out; and remarks on what was left out because no one knows what it is.
        """
        found: list[str | None] = []
        ordered: dict[str, list[int]] = {}
        met: Counter[str] = Counter()
        for i, (label, _) in enumerate(shapes):
            key = label.strip()
            met[key] += 1
            copy = f"{key} ({met[key]})"
            key = copy if copy in self.rules else key
            rule = self.rules.get(key, label)
            if isinstance(rule, OrderedClasses):
                ordered.setdefault(key, []).append(i)
            elif isinstance(rule, TemplateRule):
                rule = label
            found.append(None if isinstance(rule, OrderedClasses) else rule)
        remarks = []
        for key, indices in ordered.items():
            rule = self.rules[key]
            assert isinstance(rule, OrderedClasses)
            if len(indices) == len(rule.classes):
                places = {i: _middle(shapes[i][1], rule.order) for i in indices}
                indices.sort(key=places.__getitem__)
                for i, name in zip(indices, rule.classes, strict=True):
                    found[i] = name
                continue
            remarks.append(
                f"{printable_place(key)!r}: {pluralize(len(indices), 'shape')} where"
                f" {self.path.name} puts {len(rule.classes)} in order: left out"
            )
        return found, remarks

    def unmet(self, labels: Mapping[str, int], unknown: Mapping[str, int]) -> list[str]:
        """Return the remark on rules for labels that a set does not have, where labels without a
        class (``unknown``) may be misspelled ones."""
        known = {label.strip() for label in labels}
        said = []
        for label in self.rules:
            numbered = _NUMBERED.fullmatch(label)
            if label in known or (numbered and numbered[1] in known):
                continue
            if near := did_you_mean(label, unknown):
                said.append(f"{self.path}: no shape is called {printable_place(label)!r}{near}")
        return said


def _middle(points: Sequence[Point], order: str) -> float:
    values = [point.v if order == TOP_DOWN else point.u for point in points]
    return (min(values) + max(values)) / 2 if values else 0.0


def read_label_map(path: Path, field: Field) -> LabelMap:
    """Read a map.

    Raises:
        InputError: it cannot be read, or says what makes no sense: file, line and what was
            expected.
    """
    text = read_toml_text(path, InputError)
    try:
        content = tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # tomllib's own error is a ValueError
        raise InputError(path, f"is no TOML: {error}", advice="correct it") from error
    labels = content.pop(_TABLE, None)
    if type(labels) is not dict or content:
        strange = next(iter(content), None)
        found = "no table [labels]" if strange is None else f"{short_repr(strange)} next to it"
        raise InputError(path, f"expected one table [labels] of names and classes, found {found}")
    rules: dict[str, Rule] = {}
    for label, value in labels.items():
        place = _place(text, label)
        if label.strip() in rules:
            raise InputError(path, f"the label {short_repr(label)} is there twice", place=place)
        rules[label.strip()] = _rule(value, field, path, place)
    return LabelMap(path, rules)


def _place(text: str, label: str) -> str:
    """The line that a label's rule stands in, and the label."""
    named = f"label {short_repr(label)}"
    pattern = re.compile(rf"\s*[\"']?{re.escape(label)}[\"']?\s*=")
    lines = enumerate(text.splitlines(), 1)
    number = next((i for i, line in lines if pattern.match(line)), None)
    return named if number is None else f"line {number}: {named}"


def _rule(value: Any, field: Field, path: Path, place: str) -> Rule:
    if value is False:
        return None
    if type(value) is str:
        return _class(value, field, path, place)
    if type(value) is dict and list(value) == [_TEMPLATE]:
        return _template(value[_TEMPLATE], path, place)
    orders = [order for order in ORDERS if type(value) is dict and order in value]
    if len(orders) != 1 or len(value) != 1 or type(value[orders[0]]) is not list:
        raise InputError(
            path,
            f"expected a class, false, or {{ {TOP_DOWN} = [classes] }} or"
            f" {{ {LEFT_TO_RIGHT} = [classes] }}, found {short_repr(value)}",
            place=place,
            advice=_LEFT_OUT,
        )
    classes = value[orders[0]]
    if len(classes) < 2 or len(set(map(repr, classes))) < len(classes):
        raise InputError(
            path,
            "expected two or more classes, each once",
            place=f"{place}.{orders[0]}",
            advice="where a label stands for one class, write just that",
        )
    return OrderedClasses(orders[0], tuple(_class(name, field, path, place) for name in classes))


def _template(name: Any, path: Path, place: str) -> TemplateRule:
    if template_named(name) is not None:
        return TemplateRule(name)
    names = [known.name for known in known_templates()]
    raise InputError(
        path,
        f"there is no template of keypoints {short_repr(name)}{did_you_mean(name, names)}",
        place=place,
        advice=f"known: {', '.join(names)}",
    )


def _class(name: Any, field: Field, path: Path, place: str) -> str:
    if type(name) is str and field.knows(known := field.canonical_name(name)):
        return known
    classes = [e.name.strip() for e in field.elements]
    near = did_you_mean(name, (*classes, *field.classes_without_geometry))
    raise InputError(
        path,
        f"the field {field.title} has no class {short_repr(name)}{near}",
        place=place,
        advice=_LEFT_OUT if near else f"{_LEFT_OUT}; another field: --field NAME",
    )


@dataclass(frozen=True, slots=True)
class WrittenRule:
    """A line of the file.

    Attributes:
        comment: above it; may be empty.
        used: otherwise the line is one to fill in: it stands there as a comment.
    """

    label: str
    rule: Rule
    comment: str = ""
    used: bool = True


def label_map_text(head: Sequence[str], rules: Iterable[WrittenRule]) -> str:
    """The text of a ``labels.toml``."""
    lines = [*(f"# {_plain(line)}".rstrip() for line in head), "", "[labels]"]
    for one in rules:
        if one.comment:
            lines.append(f"# {_plain(one.comment)}")
        lines.append(f"{'' if one.used else '# '}{_quoted(one.label)} = {_value(one.rule)}")
    return "\n".join(lines) + "\n"


def _value(rule: Rule) -> str:
    if rule is None:
        return "false"
    if isinstance(rule, str):
        return _quoted(rule.strip())
    if isinstance(rule, TemplateRule):
        return f"{{ template = {_quoted(rule.name)} }}"
    names = ", ".join(_quoted(name.strip()) for name in rule.classes)
    return f"{{ {rule.order} = [{names}] }}"


def _quoted(text: str) -> str:
    """A basic string of TOML, which are those of JSON but for the last control character."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _plain(text: str) -> str:
    return "".join(c if c.isprintable() else " " for c in text)
