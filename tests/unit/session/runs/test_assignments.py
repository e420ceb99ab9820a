"""Who annotates which frame: even, seeded, gold for everybody."""

from __future__ import annotations

from collections import Counter
from itertools import combinations

import pytest

from procc_annotator.errors import UsageError
from procc_annotator.session.runs.assignments import StudyTerms, assign_frames

WHO = ("anna", "ben", "cleo")
FRAMES = [f"m{n // 30}_{n:03d}" for n in range(240)]
PARTS = {frame: frame.split("_")[0] for frame in FRAMES}
GOLD = FRAMES[5::24]


def plan(**changes):
    return assign_frames(FRAMES, PARTS, GOLD, StudyTerms(WHO, **changes))


def test_frames_are_dealt_out_evenly_and_over_the_parts() -> None:
    assigned = plan(overlap=0.3)
    work = [one for one in assigned if one.why != "gold"]
    totals = Counter(one.annotator for one in work)
    assert max(totals.values()) - min(totals.values()) <= 2
    of_part = Counter((one.annotator, PARTS[one.frame]) for one in work)
    for part in set(PARTS.values()):
        own = [of_part[who, part] for who in WHO]
        assert max(own) - min(own) <= 3
    assert {one.frame for one in work} == set(FRAMES) - set(GOLD)


def test_as_many_overlap_as_asked_for_in_every_pair_and_part() -> None:
    assigned = [one for one in plan(overlap=0.3) if one.why == "overlap"]
    who = {}
    for one in assigned:
        who.setdefault(one.frame, []).append(one.annotator)
    assert len(who) == round(0.3 * (len(FRAMES) - len(GOLD)))
    pairs = Counter(tuple(sorted(names)) for names in who.values())
    assert set(pairs) == set(combinations(sorted(WHO), 2))
    assert max(pairs.values()) - min(pairs.values()) <= 1
    parts = Counter(PARTS[frame] for frame in who)
    assert max(parts.values()) - min(parts.values()) <= 2


def test_everybody_gets_as_many_gold_frames_once_each() -> None:
    for each in (None, 4):
        assigned = plan(gold_each=each)
        gold = Counter(one.annotator for one in assigned if one.why == "gold")
        assert set(gold.values()) == {each or len(GOLD)}
        assert len({(one.annotator, one.frame) for one in assigned}) == len(assigned)


def test_the_same_seed_assigns_the_same_frames() -> None:
    assert plan(seed=3) == plan(seed=3)
    assert plan(seed=3) != plan(seed=4)


def test_everybody_may_get_every_frame_or_none_overlaps() -> None:
    everything = Counter(one.annotator for one in plan(overlap=1.0, copies=3))
    assert set(everything.values()) == {len(FRAMES)}
    alone = Counter(one.frame for one in plan(overlap=0.0) if one.why != "gold")
    assert set(alone.values()) == {1}


@pytest.mark.parametrize(
    ("who", "changes", "words"),
    [
        (("anna",), {}, "two or more"),
        (("anna", "anna"), {}, "different"),
        (WHO, {"copies": 4}, "4 of 3"),
        (WHO, {"gold_each": 11}, "there are 10"),
    ],
)
def test_what_makes_no_study_is_refused(who, changes, words) -> None:
    with pytest.raises(UsageError, match=words):
        assign_frames(FRAMES, PARTS, GOLD, StudyTerms(who, **changes))
