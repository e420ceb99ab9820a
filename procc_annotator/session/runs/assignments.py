"""Who annotates which frame: even between annotators and over the parts of a set, seeded.

Some frames go to several annotators, who can then be compared, and some are gold: their answer is
known, and every annotator gets as many of them. A list does not tell which ones.
"""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Literal

from procc_annotator.errors import UsageError

Why = Literal["alone", "overlap", "gold"]


@dataclass(frozen=True)
class StudyTerms:
    """How a study is made.

    Attributes:
        annotators: names, at least two.
        overlap: share of the frames (without gold) that several annotate, 0 to 1.
        copies: how many annotate such a frame.
        gold_each: gold frames an annotator gets; None for all.
        seed: the same one assigns the same frames.
    """

    annotators: tuple[str, ...]
    overlap: float = 0.2
    copies: int = 2
    gold_each: int | None = None
    seed: int = 1


@dataclass(frozen=True, slots=True)
class Assigned:
    """A frame and an annotator who gets it."""

    frame: str
    annotator: str
    why: Why


def assign_frames(
    frames: Sequence[str],
    parts: Mapping[str, str],
    gold: Sequence[str],
    terms: StudyTerms,
) -> list[Assigned]:
    """Assign frames, in the order of the frames.

    Args:
        frames: names, in their order, with the gold ones.
        parts: frame -> what it is alike with (a match, a shot); frames without one are of one part.
        gold: frames whose answer is known.
        terms: how.

    Raises:
        UsageError: fewer than two annotators, one twice, or more copies than annotators; more gold
            frames asked for than there are.
    """
    _check(terms, gold)
    rng = random.Random(terms.seed)
    marked = set(gold)
    rest = [frame for frame in frames if frame not in marked]
    shared = set(_chosen(rest, parts, round(terms.overlap * len(rest)), rng))
    rng.shuffle(rest)
    load = _Load(terms.annotators, rng)
    assigned: list[Assigned] = []
    groups = list(combinations(terms.annotators, terms.copies))
    rng.shuffle(groups)
    for n, frame in enumerate(frame for frame in rest if frame in shared):
        for who in groups[n % len(groups)]:
            assigned.append(Assigned(frame, who, "overlap"))
            load.add(who, parts.get(frame, ""))
    for frame in rest:
        if frame not in shared:
            who = load.least(parts.get(frame, ""))
            assigned.append(Assigned(frame, who, "alone"))
            load.add(who, parts.get(frame, ""))
    known = [frame for frame in frames if frame in marked]
    each = len(known) if terms.gold_each is None else terms.gold_each
    for who in terms.annotators:
        chosen = set(_chosen(known, parts, each, rng))
        assigned += [Assigned(frame, who, "gold") for frame in known if frame in chosen]
    at = {frame: n for n, frame in enumerate(frames)}
    return sorted(assigned, key=lambda one: (terms.annotators.index(one.annotator), at[one.frame]))


def _check(terms: StudyTerms, gold: Sequence[str]) -> None:
    count = len(terms.annotators)
    if count < 2 or len(set(terms.annotators)) < count:
        raise UsageError("--annotators needs two or more different names: anna,ben,cleo")
    if not 2 <= terms.copies <= count:
        raise UsageError(f"a frame cannot go to {terms.copies} of {count} annotators")
    if terms.gold_each is not None and terms.gold_each > len(gold):
        raise UsageError(f"{terms.gold_each} gold frames asked for, there are {len(gold)}")


class _Load:
    """How many frames everybody has, of each part and in all."""

    def __init__(self, annotators: Sequence[str], rng: random.Random) -> None:
        self._total = dict.fromkeys(annotators, 0)
        self._of_part: dict[tuple[str, str], int] = {}
        self._rng = rng

    def add(self, who: str, part: str) -> None:
        self._total[who] += 1
        self._of_part[who, part] = self._of_part.get((who, part), 0) + 1

    def least(self, part: str) -> str:
        """Who has the fewest, of the part where the totals are as even as can be."""
        fewest = min(self._total.values())
        near = [who for who, total in self._total.items() if total <= fewest + 1]
        return min(
            near,
            key=lambda who: (
                self._of_part.get((who, part), 0),
                self._total[who],
                self._rng.random(),
            ),
        )


def _chosen(
    frames: Sequence[str], parts: Mapping[str, str], count: int, rng: random.Random
) -> list[str]:
    """Some of the frames, of every part as large a share: each so-manieth of those in line."""
    of_part: dict[str, list[str]] = {}
    for frame in frames:
        of_part.setdefault(parts.get(frame, ""), []).append(frame)
    for own in of_part.values():
        rng.shuffle(own)
    in_line = [frame for own in of_part.values() for frame in own]
    begin = rng.random()
    return [in_line[int((n + begin) * len(in_line) / count)] for n in range(count)]
