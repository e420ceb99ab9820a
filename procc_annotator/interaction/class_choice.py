"""Choose a class: unnamed lines, next element, type-ahead search."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from difflib import SequenceMatcher

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.arrays import FloatArray
from procc_annotator.field.model import Element, Field
from procc_annotator.field.sampling import distances_from, touching_elements

# SoccerNet's class of a line that no one could name.
UNNAMED = "Line unknown"  # not shown
_NAMED = 3  # classes offered for a drawn line: as many as fit beside it
_REVERSED = 3.0  # how much farther a line counts that runs across what was drawn


def unnamed_class(annotation: FrameAnnotation) -> str:
    """The first free class of an unnamed line: ``Line unknown``, ``Line unknown (2)``..., as they
    are numbered in files that may hold several."""
    name, number = UNNAMED, 1
    while annotation.get(name) is not None or annotation.get_unconfirmed(name) is not None:
        number += 1
        name = f"{UNNAMED} ({number})"
    return name


def rank_classes(
    drawn: FloatArray,
    courses: Mapping[str, Sequence[FloatArray]],
    otherwise: Iterable[str],
    *,
    farthest: float,
) -> tuple[str, ...]:
    """The elements that a drawn line likely is, best first.

    The mean distance of its points to where each element is expected counts, more where that runs
    in another direction.

    Args:
        drawn: (n, 2) px, n >= 1.
        courses: class -> its expected pieces, each (m, 2) px, m >= 1.
        otherwise: classes to fill up with, likeliest first.
        farthest: px; elements that are farther are none of it.
    """
    away = {
        name: distance
        for name, pieces in courses.items()
        if len(pieces) and (distance := _distance(drawn, pieces)) <= farthest
    }
    ranked = sorted(away, key=lambda name: away[name])
    return tuple(dict.fromkeys((*ranked, *(n for n in otherwise if n not in away))))[:_NAMED]


def _distance(drawn: FloatArray, pieces: Sequence[FloatArray]) -> float:
    """Mean distance of points to a course, px, up to `_TURNED` + 1 times as much across it."""
    segments = np.concatenate([_segments(piece) for piece in pieces])
    starts, along = segments[:, 0], segments[:, 1] - segments[:, 0]
    lengths = np.maximum((along**2).sum(axis=1), 1e-12)
    offsets = drawn[:, None] - starts[None]
    share = np.clip((offsets * along[None]).sum(axis=2) / lengths, 0.0, 1.0)
    feet = starts[None] + share[..., None] * along[None]
    distances = np.hypot(*np.moveaxis(drawn[:, None] - feet, -1, 0))
    nearest = distances.argmin(axis=1)
    mean = float(distances[np.arange(len(drawn)), nearest].mean())
    course = along[nearest].sum(axis=0)
    runs = drawn[-1] - drawn[0]
    if len(drawn) < 2 or not course.any() or not runs.any():
        return mean
    sine = (course[0] * runs[1] - course[1] * runs[0]) / (np.hypot(*course) * np.hypot(*runs))
    return mean * (1 + _REVERSED * float(sine) ** 2)


def _segments(piece: FloatArray) -> FloatArray:
    """(k, 2, 2): the segments of a piece; of a single point one without length."""
    if len(piece) == 1:
        piece = np.repeat(piece, 2, axis=0)
    return np.stack([piece[:-1], piece[1:]], axis=1)


# A rectangle is left for an element elsewhere that would bring so many times as much.
_WORTH_LEAVING = 2.0


def next_element(
    field: Field,
    annotation: FrameAnnotation,
    finished: str | None,
    seen_before: Collection[str] = (),
    *,
    gains: Mapping[str, float] | None = None,
    out_of_sight: Collection[str] = (),
) -> str | None:
    """The class to offer after one was finished; None when every element in sight is annotated.

    Where a camera gives what annotating each element would bring, the group of the finished one
    (the lines of a penalty area) is gone through in the field's order, from it on and round, unless
    an element elsewhere brings at least twice as much. Without a camera, if the frame annotated
    before this one had the finished element too (the camera moved little), its other elements come
    first. Then come those of the same group, then those that meet the finished one, then the
    nearest on the field. Elements on the ground come before goals at the same rank, optional ones,
    which a set need not have, come only where the frame before had them too.

    Args:
        annotation: classes with points are not offered, unconfirmed ones are (they wait for a
            hand).
        finished: the class just drawn; None at the beginning of a frame.
        seen_before: classes of the frame annotated last.
        gains: what the classes in sight would give a fitted camera, px; none where none of them
            is worth a word.
        out_of_sight: classes known not to be in the picture; they are not offered.
    """
    done = {*annotation.annotated, *out_of_sight}
    candidates = [e for e in field.elements if e.name not in done and e.name != finished]
    if not candidates:
        return None
    element = field.element(finished or "")
    gains = gains or {}
    if telling := [e for e in candidates if e.name in gains]:
        return _most_telling(telling, element, field, gains).name
    if element is None:
        likely = [e.name for e in candidates if e.name in seen_before]
        return likely[0] if likely else None
    alike = seen_before if finished in seen_before else ()
    candidates = [e for e in candidates if not e.optional or e.name in alike]
    if not candidates:
        return None
    return _nearest(candidates, element, field, alike).name


def _most_telling(
    candidates: Sequence[Element],
    finished: Element | None,
    field: Field,
    gains: Mapping[str, float],
) -> Element:
    best = max(candidates, key=lambda e: gains[e.name])
    own = [e for e in candidates if finished is not None and e.group == finished.group]
    if finished is None or not own:
        return best
    count, begin = len(field.elements), field.index[finished.name] + 1
    following = min(own, key=lambda e: (field.index[e.name] - begin) % count)
    much = gains[best.name] >= _WORTH_LEAVING * gains[following.name]
    return best if much and gains[best.name] > 0 else following


def _nearest(
    candidates: Sequence[Element], finished: Element, field: Field, alike: Collection[str]
) -> Element:
    """Of some elements the one that goes best with what was finished; ``alike``: also drawn in a
    frame like this one."""
    distance = distances_from(field, (finished.name,))
    touching = touching_elements(field, finished.name)

    def rank(one: Element) -> tuple[bool, bool, bool, bool, float]:
        return (
            one.name not in alike,
            one.group != finished.group,
            one.name not in touching,
            not one.on_ground,
            float(distance[field.index[one.name]]),
        )

    return min(candidates, key=rank)


_LETTERS = 5  # the rank of names that hold the letters in order
_ALIKE = 0.75  # of two words of which one is a misspelling of the other
_SHORTEST = 4  # letters of a word that may be misspelt


def match_rank(query: str, *names: str) -> int | None:
    """Return how well a query fits one thing of several names: lower is better, None is not at all.

    A query fits when each of its words begins a word of one name (``l p b`` finds "Left penalty
    area, bottom"), or when a name contains it.
    """
    wanted = query.casefold().split()
    if not wanted:
        return 0
    ranks = [_rank_name(wanted, " ".join(wanted), _plain(name)) for name in names]
    return min((r for r in ranks if r is not None), default=None)


def loose_rank(query: str, name: str) -> int | None:
    """As `match_rank`, and then names that hold the letters in order, the first one at the
    beginning of a word: ``regall`` finds "Regularise all"."""
    rank = match_rank(query, name)
    if rank is None and _letters_in_order("".join(query.casefold().split()), _plain(name)):
        return _LETTERS
    return rank


def misspelt(query: str, name: str) -> bool:
    """Return whether every word of a query is nearly one of a name: ``regulraise all``."""
    words = _plain(name).split()
    return all(_misspelt_one_of(wanted, words) for wanted in query.casefold().split())


def _plain(name: str) -> str:
    return " ".join(name.casefold().replace(",", " ").replace(".", " ").split())


def _rank_name(wanted: list[str], text: str, name: str) -> int | None:
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


def _letters_in_order(letters: str, name: str) -> bool:
    """Return whether a name holds the letters in order, from the beginning of one of its words on;
    not further apart than three places each, or every long name would hold every short word."""
    starts = [i for i in range(len(name)) if i == 0 or name[i - 1] == " "]
    return any(_follows(letters, name[start:]) for start in starts)


def _follows(letters: str, text: str) -> bool:
    at = -1
    for i, letter in enumerate(letters):
        found = text.find(letter, at + 1)
        if found < 0 or (i == 0 and found > 0):
            return False
        at = found
    return at < 3 * len(letters)


def _misspelt_one_of(wanted: str, words: list[str]) -> bool:
    if len(wanted) < _SHORTEST:
        return wanted in words
    matcher = SequenceMatcher(b=wanted)
    for word in words:
        if word[0] != wanted[0]:
            continue  # first letters are seldom the wrong ones
        matcher.set_seq1(word[: len(wanted) + 1])
        if matcher.real_quick_ratio() >= _ALIKE and matcher.ratio() >= _ALIKE:
            return True
    return False
