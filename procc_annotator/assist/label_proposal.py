"""Propose a label map for labels of another program, by words and by place; write it as text."""

from __future__ import annotations

import difflib
import re
import tomllib
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Literal

from procc_annotator.assist.label_matching import (
    CameraOf,
    LabelCount,
    LabelledFrame,
    LabelPlaces,
    LineOrders,
    find_orders,
    find_places,
    fitted_cameras,
    label_counts,
)
from procc_annotator.dataset.diagnostics import loadable
from procc_annotator.field.load import field_names, load_field
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.label_map import (
    LABELS_FILE,
    LEFT_TO_RIGHT,
    ORDERS,
    TOP_DOWN,
    LabelMap,
    OrderedClasses,
    Rule,
    WrittenRule,
    label_map_text,
)
from procc_annotator.messages import pluralize
from procc_annotator.resources import resources_dir

_SIDE_WORDS = frozenset({"left", "right", "top", "bottom"})
_STOP_WORDS = frozenset(
    {"the", "of", "de", "la", "le", "du", "del", "der", "die", "das", "main", "no"}
)
_PART_WORDS = ("line", "circle", "area", "mark")  # which are often written in one word with another
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")
_SAME_WORD_RATIO = 0.8  # as difflib compares: a letter or two apart
_MIN_LIKENESS = 0.7
_SYNONYM_FACTOR = 0.95  # the likeness of the same words, if they are another way to say it
_MAX_LABEL_LENGTH = 120
_MAX_WORDS = 16

Words = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class ClassMatch:
    """Classes that are called like a label.

    Attributes:
        classes: in the field's order; several where nothing in the label distinguishes them, as its
            sides are not in it. None are like it: empty.
        likeness: 0 to 1, of each of them; 1 where the words are the same.
    """

    classes: tuple[str, ...]
    likeness: float


def matching_classes(label: str, field: Field) -> ClassMatch:
    """The classes that a label is most like, if it is like any."""
    exact = field.canonical_name(label)
    if field.knows(exact):
        return ClassMatch((exact,), 1.0)
    words = normalised_words(label)
    own_sides = _side_words(words)
    ways = [(words, 1.0), *((way, _SYNONYM_FACTOR) for way in _alternative_readings(words))]
    scored = [
        (max(_word_likeness(way, own) * share for way, share in ways for own in theirs), name)
        for name, theirs in _class_words(field)
    ]
    best = max((score for score, _ in scored), default=0.0)
    if best < _MIN_LIKENESS:
        return ClassMatch((), best)
    alike = [name for score, name in scored if score > best - 1e-9]
    # "Goal left post right" and "Goal right post left" have the same words.
    for count in (None, len(own_sides)):
        told = [name for name in alike if _side_words(normalised_words(name))[:count] == own_sides]
        if told and own_sides:
            return ClassMatch(tuple(told), best)
    return ClassMatch(tuple(alike), best)


def _side_words(words: Words) -> Words:
    return tuple(word for word in words if word in _SIDE_WORDS)


def normalised_words(label: str) -> Words:
    """The words of a label as they are compared: in lower case, of one language, in the singular,
    without a number at its end."""
    plain = unicodedata.normalize("NFKD", label[:_MAX_LABEL_LENGTH])
    found = [w.lower() for w in _WORD.findall("".join(c for c in plain if ord(c) < 128))]
    if len(found) > 1 and found[-1].isdigit():
        found.pop()
    words: list[str] = []
    for word in found[:_MAX_WORDS]:
        for one in _synonyms().get(word, word).split():
            words += _split_word(one)
    return tuple(_synonyms().get(w, w) for w in words if w not in _STOP_WORDS and len(w) > 1)


@cache
def _synonyms() -> dict[str, str]:
    return {other: own for own, others in _synonym_table()["words"].items() for other in others}


@cache
def _synonym_table() -> dict[str, dict[str, list[str]]]:
    text = (resources_dir() / "label_words.toml").read_text(encoding="utf-8")
    table: dict[str, dict[str, list[str]]] = tomllib.loads(text)
    return table


def _split_word(word: str) -> list[str]:
    singular = word[:-1] if len(word) > 3 and word.endswith("s") and word[-2] != "s" else word
    for part in _PART_WORDS:
        if singular.endswith(part) and len(singular) > len(part) + 1:
            return [singular[: -len(part)], part]
    return [singular]


def _alternative_readings(words: Words) -> list[Words]:
    ways = []
    for own, others in _synonym_table()["phrases"].items():
        for other in others:
            phrase = normalised_words(other)
            if phrase and set(phrase) <= set(words):
                rest = tuple(w for w in words if w not in phrase)
                ways.append((*normalised_words(own), *rest))
    return ways


@cache
def _class_word_sets(name: str, title: str) -> tuple[Words, ...]:
    return tuple(
        dict.fromkeys(words for text in (name, title) if (words := normalised_words(text)))
    )


def _class_words(field: Field) -> Iterable[tuple[str, tuple[Words, ...]]]:
    return [(e.name, _class_word_sets(e.name, e.title)) for e in field.elements]


def _word_likeness(label: Sequence[str], other: Sequence[str]) -> float:
    """Share of words in common, 0 to 1. Sides that only the class has cost nothing, since the label
    may leave them open; other sides than its own rule it out."""
    sides = _side_words(tuple(label))
    core = [w for w in label if w not in _SIDE_WORDS]
    theirs = [w for w in other if w not in _SIDE_WORDS]
    if any(side not in other for side in sides) or not core or not theirs:
        return 0.0
    left = list(theirs)
    common = 0.0
    for word in core:
        found = word if word in left else next(
            iter(difflib.get_close_matches(word, left, 1, _SAME_WORD_RATIO)), None
        )  # fmt: skip
        if found is not None:
            common += 1.0 if found == word else 0.9
            left.remove(found)
    return 2 * common / (len(core) + len(theirs))


Confidence = Literal["sure", "likely", "open"]
_MOST_FRAMES = 16  # are looked at with a camera
_MOST = 0.7  # of the shapes or frames, that something is called likely by geometry
_FEWEST = 2  # shapes, frames
_SAME = 0.99  # of two names

_NO_PLACES = LabelPlaces.none()


@dataclass(frozen=True, slots=True)
class LabelProposal:
    """A proposal for a label.

    Attributes:
        count: the label, and how often it occurs.
        rule: what is proposed; None where nothing is.
        surety: ``sure`` by two ways that agree, or by the very words; ``likely`` by one; ``open``
            where a person has to say.
        like: classes that it may be, where it is open.
    """

    count: LabelCount
    rule: Rule
    surety: Confidence
    why: str
    like: tuple[str, ...] = ()


def propose_labels(
    frames: Sequence[LabelledFrame], field: Field, camera_of: CameraOf | None = None
) -> list[LabelProposal]:
    """Propose what the labels of a set stand for.

    By name first. Labels that several straight lines share are put in the order that all frames
    fit best. Then cameras show which elements the shapes lie on: those that are given, or those
    that are fitted to what is known by then.
    """
    counts = label_counts(frames)
    names = {count.label: matching_classes(count.label, field) for count in counts}
    alone = {label: found.classes[0] for label, found in names.items() if len(found.classes) == 1}
    orders = LineOrders({})
    if camera_of is None:
        families = {
            c.label: names[c.label].classes
            for c in counts
            if 1 < len(names[c.label].classes) == c.copies
        }
        orders = find_orders(frames, alone, families, field)
        first = LabelMap(Path(LABELS_FILE), {**alone, **orders.rules})
        camera_of = fitted_cameras(first, field)
    best = sorted(frames, key=lambda frame: -sum(map(len, frame.shapes.values())))[:_MOST_FRAMES]
    places = find_places(best, camera_of, field)
    return _each_once([
        _proposal(count, names[count.label], orders, places.get(count.label, _NO_PLACES))
        for count in counts
    ])  # fmt: skip


def _each_once(proposals: list[LabelProposal]) -> list[LabelProposal]:
    """Two labels of one class: no one knows which of them is it, or whether both are parts."""
    takers: dict[str, list[str]] = {}
    for one in proposals:
        if isinstance(one.rule, str):
            takers.setdefault(one.rule, []).append(one.count.label)
    found = []
    for one in proposals:
        own = one.count.label
        others = [t for t in takers.get(str(one.rule), ()) if t != own] if one.rule else []
        if others:
            also = f"{one.why}; but so is {', '.join(map(repr, others))}"
            like = (str(one.rule),)
            one = replace(one, rule=None, surety="open", why=also, like=like)
        found.append(one)
    return found


def _proposal(
    count: LabelCount, similar: ClassMatch, orders: LineOrders, places: LabelPlaces
) -> LabelProposal:
    if (ordered := orders.rules.get(count.label)) is not None:
        return _by_order(count, ordered, orders, places)
    if count.copies > 1:
        return _of_several(count, similar, places)
    return _of_one(count, similar, places)


def _by_order(
    count: LabelCount, rule: OrderedClasses, orders: LineOrders, places: LabelPlaces
) -> LabelProposal:
    fit = f"in this order {orders.fitting} of {pluralize(orders.frames, 'frame')} fit one camera"
    surety: Confidence = (
        "sure" if orders.fitting >= max(_FEWEST, _MOST * orders.frames) else "likely"
    )
    if not orders.fitting:
        return LabelProposal(count, None, "open", f"by name, but {fit}", rule.classes)
    on = sum(places.on[name] for name in rule.classes)
    seen = f"; {on} of {pluralize(places.shapes, 'shape')} on them" if places.shapes else ""
    return LabelProposal(count, rule, surety, f"by name; {fit}{seen}")


def _of_several(count: LabelCount, similar: ClassMatch, places: LabelPlaces) -> LabelProposal:
    found = next(iter(places.orders.most_common(1)), None)
    if found is not None:
        rule, times = found
        why = f"on these lines in this order in {times} of {pluralize(places.frames, 'frame')}"
        if times >= max(_FEWEST, _MOST * places.frames):
            named = set(rule.classes) <= set(similar.classes)
            return LabelProposal(count, rule, "sure" if named else "likely", why)
        return LabelProposal(count, None, "open", f"only {why}", rule.classes)
    if len(similar.classes) == 1:
        why = f"by name, and {count.copies} shapes in a frame would be joined"
        return LabelProposal(count, similar.classes[0], "likely", why)
    return LabelProposal(count, None, "open", _nothing(similar), similar.classes)


def _of_one(count: LabelCount, similar: ClassMatch, places: LabelPlaces) -> LabelProposal:
    place, times = next(iter(places.on.most_common(1)), ("", 0))
    on = f"{times} of {pluralize(places.shapes, 'shape')} on it"
    clear = times >= max(_FEWEST, _MOST * places.shapes)
    if clear and place in similar.classes:
        return LabelProposal(count, place, "sure", f"by name; {on}")
    if clear and not similar.classes:
        return LabelProposal(count, place, "likely", f"by geometry alone: {on}")
    if clear:
        why = f"its name is like one, its shapes lie on another ({on})"
        return LabelProposal(count, None, "open", why, (*similar.classes, place))
    if len(similar.classes) == 1:
        same = similar.likeness >= _SAME
        why = "by name, the same words" if same else f"by name, {similar.likeness:.0%} alike"
        return LabelProposal(count, similar.classes[0], "sure" if same else "likely", why)
    return LabelProposal(count, None, "open", _nothing(similar), similar.classes)


def _nothing(similar: ClassMatch) -> str:
    return "its name may be any of these" if similar.classes else "no class is called alike"


_DIRECTIONS = {LEFT_TO_RIGHT: "left to right", TOP_DOWN: "top down"}


def order_choices(proposal: LabelProposal) -> list[OrderedClasses]:
    """The orders that a label which two lines share may have, the proposed one first."""
    own = proposal.rule if isinstance(proposal.rule, OrderedClasses) else None
    pair = own.classes if own is not None else proposal.like
    found = [own] if own is not None else []
    if len(pair) == proposal.count.copies == 2:
        found += [OrderedClasses(way, names) for way in ORDERS for names in (pair, pair[::-1])]
    return list(dict.fromkeys(found))


def rule_words(rule: Rule, field: Field) -> str:
    """A rule in a few words, with the titles of the classes."""
    if isinstance(rule, OrderedClasses):
        titles = ", ".join(field.title_of(name) for name in rule.classes)
        return f"{titles} ({_DIRECTIONS[rule.order]})"
    return field.title_of(rule) if isinstance(rule, str) else "Leave out"


_MUCH_MORE = 1.3  # of the likeness of all labels


def proposed_text(
    proposals: Sequence[LabelProposal], source: str, field: Field, *, given_cameras: bool
) -> str:
    """The ``labels.toml`` of a proposal for all labels of a source, named for people; given cameras
    say what is left and what is right."""
    head = [
        f"What the labels of {source} may stand for on a field of {field.title}.",
        "Proposed by procc-annotator propose-map: sure by two ways, likely by one. What is open is"
        " a comment:",
        "write a class there, or leave the label out with false, and take the # away.",
    ]
    ordered = any(p.rule is not None and not isinstance(p.rule, str) for p in proposals)
    if field.symmetries and ordered and not given_cameras:
        head.append(
            "The field looks the same after a turn: the classes of the other end are as good, as"
            " long as all lines agree."
        )
    return label_map_text(head, [_written(one) for one in proposals])


def _written(one: LabelProposal) -> WrittenRule:
    shapes = pluralize(one.count.shapes, "shape")
    like = f"; may be {', '.join(name.strip() for name in one.like)}" if one.like else ""
    comment = f"{one.surety}, {shapes}: {one.why}{like}"
    return WrittenRule(one.count.label, one.rule, comment, used=one.surety != "open")


def better_field(labels: Sequence[str], field: Field) -> str | None:
    """The shipped field, as `load_field` takes it, with classes that are called much more like some
    labels of a set than those of the field they were taken for; None where no field is."""
    own = _likeness(labels, field)
    others = [load_field(name) for name in field_names() if name != field.name]
    best = max(others, key=lambda other: _likeness(labels, other))
    much = _likeness(labels, best)
    return loadable(best) if much > own * _MUCH_MORE and much >= len(labels) / 2 else None


def _likeness(labels: Sequence[str], field: Field) -> float:
    found = (matching_classes(label, field) for label in labels)
    return sum(one.likeness for one in found if one.classes)
