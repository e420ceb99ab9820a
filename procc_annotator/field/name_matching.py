"""Match class names of other tools to the classes of a field by their words."""

from __future__ import annotations

import difflib
import re
import tomllib
import unicodedata
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cache

from procc_annotator.field.model import Field
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
        (max(_likeness(way, own) * share for way, share in ways for own in theirs), name)
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
    """Return what a label's words may say, too."""
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


def _likeness(label: Sequence[str], other: Sequence[str]) -> float:
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
