"""Two classes on top of each other: one line clicked under two names."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import combinations

import numpy as np

from procc_annotator.field.model import Element, Field
from procc_annotator.field.neighbours import distances_to
from procc_annotator.field.sample import sample_evenly
from procc_annotator.fit.labels.clicked import AnnotatedElement, FrameEvidence, in_image_px
from procc_annotator.fit.labels.finding import LOOK, Finding, Rule, Severity, error_classes
from procc_annotator.fit.solving.observations import FloatArray, ImageFrame
from procc_annotator.language import translatable
from procc_annotator.metric.course import arc_lengths, points_at_arc_lengths

# Clicks along one line lie so near to those of somebody else along it.
_OVERLAP_PX = 3.0
_MIN_OVERLAP_SHARE = 0.8
_MIN_OVERLAP_LENGTH_PX = 20.0
_OVERLAP_SAMPLES = 12
_OVERLAP_SPACING_M = 0.5
# Elements nearer than this on the field itself may well be on top of each other in the picture.
_COINCIDENT_M = 0.5


def overlap_findings(looked_at: FrameEvidence, known: Sequence[Finding]) -> Iterator[Finding]:
    """Pairs of elements whose clicks run along the same stretch; nothing in a reflected frame.

    Only of elements on the ground, which lie apart in every picture taken from well above it: a
    crossbar seen from far away hides the goal line behind it, and posts hide each other. Two that
    a camera explains are where they should be.
    """
    if any(f.rule is Rule.REFLECTED for f in known):
        return
    explained, sure = looked_at.explained, error_classes(known)
    ground = [
        c for c in looked_at.clicked if c.element.on_ground and _bounding_box(c.points) >= _MIN_OVERLAP_LENGTH_PX
    ]
    for one, other in combinations(ground, 2):
        if explained.issuperset((one.name, other.name)) or not sure.isdisjoint(
            (one.name, other.name)
        ):
            continue
        if _boxes_disjoint(one.points, other.points):
            continue
        if _polylines_overlap(one.points, other.points) and not _coincide_on_field(
            looked_at.field, one.name, other.name
        ):
            yield _overlap_finding(one, other, looked_at.frame)


def _overlap_finding(one: AnnotatedElement, other: AnnotatedElement, frame: ImageFrame) -> Finding:
    near = in_image_px(_OVERLAP_PX, frame)
    return Finding(
        Rule.COINCIDENT,
        Severity.WARNING,
        (one.name, other.name),
        translatable(
            "{a} and {b} lie on top of each other, less than {px:.0f} px apart: one line under two"
            " names?",
            a=one.title,
            b=other.title,
            px=near,
        ),
        (LOOK,),
    )


def _bounding_box(points: FloatArray) -> float:
    return float(np.hypot(*np.ptp(points, axis=0)))


def _boxes_disjoint(one: FloatArray, other: FloatArray) -> bool:
    return bool(
        (one.min(axis=0) > other.max(axis=0) + _OVERLAP_PX).any()
        or (other.min(axis=0) > one.max(axis=0) + _OVERLAP_PX).any()
    )


def _polylines_overlap(one: FloatArray, other: FloatArray) -> bool:
    """Whether most of the shorter of two polylines lies on the other."""
    short, long = sorted((one, other), key=_bounding_box)
    return bool((_polyline_distances(_resample(short), long) < _OVERLAP_PX).mean() >= _MIN_OVERLAP_SHARE)


def _resample(points: FloatArray) -> FloatArray:
    along = arc_lengths(points)
    places = np.linspace(0.0, along[-1], _OVERLAP_SAMPLES)
    return points_at_arc_lengths(points, places, along)


def _polyline_distances(points: FloatArray, polyline: FloatArray) -> FloatArray:
    """(n,) distance of each point from a polyline."""
    begin, span = polyline[:-1], np.diff(polyline, axis=0)
    squares = np.maximum((span**2).sum(axis=1), 1e-12)
    offset = points[:, None] - begin[None]
    share = np.clip((offset * span[None]).sum(axis=2) / squares, 0.0, 1.0)
    apart = offset - share[:, :, None] * span[None]
    return np.asarray(np.sqrt((apart**2).sum(axis=2)).min(axis=1))


def _coincide_on_field(field: Field, one: str, other: str) -> bool:
    """Whether most of one of two elements lies on the other on the field itself."""
    on = _coincidence_matrix(field.elements)
    i, j = field.index[one], field.index[other]
    return bool(max(on[i, j], on[j, i]) >= _MIN_OVERLAP_SHARE / 2)


@lru_cache(maxsize=4)
def _coincidence_matrix(elements: tuple[Element, ...]) -> FloatArray:
    """(E, E) share of each element that lies on each other one."""
    samples = sample_evenly(Field("", "", (), elements), _OVERLAP_SPACING_M)
    found = np.array(
        [
            (distances_to(elements, samples.of(i)) < _COINCIDENT_M).mean(axis=0)
            for i in range(len(elements))
        ]
    )
    found.setflags(write=False)
    return found
