"""What the names of other programs stand for: a file ``labels.toml``.

::

    [labels]
    "service-centerline" = "Centre service line"   # a class of the field
    "crowd" = false                                # left out
    "line (2)" = "Baseline right"                  # the second shape called "line" in a picture
    "baseline" = { top_down = ["Baseline left", "Baseline right"] }
    "pitch" = { template = "soccer_32" }           # keypoints that are places of the field

The last form but one is for labels that several lines of a picture share: which is which is told by
their places in it, from the top down or from left to right.
"""

from __future__ import annotations

import re
import tomllib
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from procc_annotator.annotation import Point
from procc_annotator.errors import InputError
from procc_annotator.field.model import Field
from procc_annotator.field.words import did_you_mean, printable_place, short_repr
from procc_annotator.io.annotation_files.keypoint_templates import known_templates, template_named
from procc_annotator.io.source import read_file
from procc_annotator.words import count_words

LABELS_FILE = "labels.toml"
TOP_DOWN, LEFT_TO_RIGHT = ORDERS = "top_down", "left_to_right"
_TABLE = "labels"
_TEMPLATE = "template"
# The TOML reader takes time by the square of a dotted key's length.
_LARGEST = 256 * 1024
_MOST_DOTS = 60
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
    """A category whose keypoints are places of a template, by its name in `keypoint_templates`."""

    name: str


Rule = str | OrderedClasses | TemplateRule | None


@dataclass(frozen=True)
class LabelMap:
    """Which classes the labels of another program stand for.

    Attributes:
        path: of its file.
        rules: label -> its class, None where it is left out, classes by their order, or a template
            of keypoints.
    """

    path: Path
    rules: Mapping[str, Rule]

    def classes(self, shapes: Sequence[Shape]) -> tuple[list[str | None], list[str]]:
        """What the shapes of one picture are.

        Args:
            shapes: label and normalised points of each, in the order of the file.

        Returns:
            A class for each shape, its label where nothing is said of it, None where it is left
            out; and remarks on what was left out because nobody can tell what it is.
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
                f"{printable_place(key)!r}: {count_words(len(indices), 'shape')} where"
                f" {self.path.name} puts {len(rule.classes)} in order: left out"
            )
        return found, remarks

    def unmet(self, labels: Mapping[str, int], unknown: Mapping[str, int]) -> list[str]:
        """What to say of rules for labels that a set does not have, where one was misspelled.

        Args:
            labels: of the set.
            unknown: those of them that stand for no class.
        """
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
    """Where a shape is along the direction of an order, normalised."""
    values = [point.v if order == TOP_DOWN else point.u for point in points]
    return (min(values) + max(values)) / 2 if values else 0.0


def read_label_map(path: Path, field: Field) -> LabelMap:
    """Read a map.

    Args:
        path: of a ``labels.toml``.
        field: whose classes the labels stand for.

    Raises:
        InputError: it cannot be read, or says what makes no sense: file, line and what was
            expected.
    """
    text = _text_of(path)
    try:
        content = tomllib.loads(text)
    except (ValueError, RecursionError) as error:  # tomllib's own error is a ValueError
        raise InputError(path, f"is no TOML: {error}", advice="correct it") from error
    labels = content.pop(_TABLE, None)
    if type(labels) is not dict or content:
        strange = next(iter(content), None)
        found = "no table [labels]" if strange is None else f"{short_repr(strange)} beside it"
        raise InputError(path, f"expected one table [labels] of names and classes, found {found}")
    rules: dict[str, Rule] = {}
    for label, value in labels.items():
        place = _place(text, label)
        if label.strip() in rules:
            raise InputError(path, f"the label {short_repr(label)} is there twice", place=place)
        rules[label.strip()] = _rule(value, field, path, place)
    return LabelMap(path, rules)


def _text_of(path: Path) -> str:
    data = read_file(path)
    if len(data) > _LARGEST:
        raise InputError(path, f"is larger than {_LARGEST // 1024} kB", advice="is it this file?")
    try:
        text = data.decode("utf-8-sig")
    except ValueError as error:
        raise InputError(path, f"cannot be read as UTF-8 text: {error}") from error
    for number, line in enumerate(text.splitlines(), 1):
        if line.count(".") > _MOST_DOTS:
            raise InputError(
                path, f"has more than {_MOST_DOTS} dots in a line", place=f"line {number}"
            )
    return text


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
