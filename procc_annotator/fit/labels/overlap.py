"""Two classes on top of each other: one line clicked under two names."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import combinations

import numpy as np

from procc_annotator.field.model import Element, Field
from procc_annotator.field.neighbours import distances_to
from procc_annotator.field.sample import sample_every
from procc_annotator.fit.labels.clicked import Clicked, ClickedFrame, in_picture
from procc_annotator.fit.labels.finding import LOOK, Finding, Rule, Severity, surely_wrong
from procc_annotator.fit.solving.observations import FloatArray, PictureFrame
from procc_annotator.language import said
from procc_annotator.metric.course import lengths_along, places_at

# Clicks along one line lie so near to those of somebody else along it.
_NEAR_PX = 3.0
_SHARE = 0.8
_SHORTEST_PX = 20.0
_SAMPLES = 12
_SPACING_M = 0.5
# Elements nearer than this on the field itself may well be on top of each other in the picture.
_SAME_PLACE_M = 0.5


def overlap_findings(looked_at: ClickedFrame, known: Sequence[Finding]) -> Iterator[Finding]:
    """Pairs of elements whose clicks run along the same stretch; nothing in a reflected frame.

    Only of elements on the ground, which lie apart in every picture taken from well above it: a
    crossbar seen from far away hides the goal line behind it, and posts hide each other. Two that
    a camera explains are where they should be.
    """
    if any(f.rule is Rule.REFLECTED for f in known):
        return
    explained, sure = looked_at.explained, surely_wrong(known)
    ground = [
        c for c in looked_at.clicked if c.element.on_ground and _reach(c.points) >= _SHORTEST_PX
    ]
    for one, other in combinations(ground, 2):
        if explained.issuperset((one.name, other.name)) or not sure.isdisjoint(
            (one.name, other.name)
        ):
            continue
        if _boxes_apart(one.points, other.points):
            continue
        if _overlap(one.points, other.points) and not _together(
            looked_at.field, one.name, other.name
        ):
            yield _finding(one, other, looked_at.frame)


def _finding(one: Clicked, other: Clicked, frame: PictureFrame) -> Finding:
    near = in_picture(_NEAR_PX, frame)
    return Finding(
        Rule.COINCIDENT,
        Severity.WARNING,
        (one.name, other.name),
        said(
            "{a} and {b} lie on top of each other, less than {px:.0f} px apart: one line under two"
            " names?",
            a=one.title,
            b=other.title,
            px=near,
        ),
        (LOOK,),
    )


def _reach(points: FloatArray) -> float:
    return float(np.hypot(*np.ptp(points, axis=0)))


def _boxes_apart(one: FloatArray, other: FloatArray) -> bool:
    return bool(
        (one.min(axis=0) > other.max(axis=0) + _NEAR_PX).any()
        or (other.min(axis=0) > one.max(axis=0) + _NEAR_PX).any()
    )


def _overlap(one: FloatArray, other: FloatArray) -> bool:
    """Whether most of the shorter of two polylines lies on the other."""
    short, long = sorted((one, other), key=_reach)
    return bool((_distances(_resampled(short), long) < _NEAR_PX).mean() >= _SHARE)


def _resampled(points: FloatArray) -> FloatArray:
    along = lengths_along(points)
    places = np.linspace(0.0, along[-1], _SAMPLES)
    return places_at(points, places, along)


def _distances(points: FloatArray, polyline: FloatArray) -> FloatArray:
    """(n,) distance of each point from a polyline."""
    begin, span = polyline[:-1], np.diff(polyline, axis=0)
    squares = np.maximum((span**2).sum(axis=1), 1e-12)
    offset = points[:, None] - begin[None]
    share = np.clip((offset * span[None]).sum(axis=2) / squares, 0.0, 1.0)
    apart = offset - share[:, :, None] * span[None]
    return np.asarray(np.sqrt((apart**2).sum(axis=2)).min(axis=1))


def _together(field: Field, one: str, other: str) -> bool:
    """Whether most of one of two elements lies on the other on the field itself."""
    on = _coincidence(field.elements)
    i, j = field.index[one], field.index[other]
    return bool(max(on[i, j], on[j, i]) >= _SHARE / 2)


@lru_cache(maxsize=4)
def _coincidence(elements: tuple[Element, ...]) -> FloatArray:
    """(E, E) share of each element that lies on each other one."""
    samples = sample_every(Field("", "", (), elements), _SPACING_M)
    found = np.array(
        [
            (distances_to(elements, samples.of(i)) < _SAME_PLACE_M).mean(axis=0)
            for i in range(len(elements))
        ]
    )
    found.setflags(write=False)
    return found
