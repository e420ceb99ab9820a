"""Elements under which the picture shows no paint, or beside which it runs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from procc_annotator.field.appearance import BAR, LIGHTER
from procc_annotator.fit.labels.clicked import AnnotatedElement, FrameEvidence
from procc_annotator.fit.labels.finding import (
    LOOK,
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
    error_classes,
)
from procc_annotator.fit.labels.seen_paint import LineEvidence, LinePresence
from procc_annotator.language import translatable

# Players hide shorter stretches, worn lines smaller shares, px at 960 px width.
_MIN_MISSING_PX, _MIN_MISSING_SHARE = 40.0, 0.5
_MIN_MISSING_BAR_PX = 12.0  # which is short, and stands before whatever else there is
_ERROR_MISSING_SHARE = 0.8
_MIN_CURVE_CLICKS = 5
# A straight element beside its paint: a lens bends it between its clicks.
_BEND_PX = 2.5
_MIN_SEEN_SHARE = 0.6  # what is beside something must be seen
_MIN_DISPLACED_SHARE, _END_SHARE = 0.25, 0.7
# An end beside its paint, px at 960 px width: how far at least, how near to it the point before
# still is, and how far what is seen between them may leave a line.
_DISPLACED_END_PX, _ALIGNED_PX, _LINE_RESIDUAL_PX = 2.5, 1.2, 0.9
_MIN_PLACES, _SEEN_SPACING_PX = 3, 1.2
_FOLLOW_LINE_REMEDY = Remedy(RemedyKind.FOLLOW, translatable("put its points along the paint"))


def line_evidence_findings(looked_at: FrameEvidence, known: Sequence[Finding]) -> Iterator[Finding]:
    """What the picture says of elements; nothing where nobody looked at it.

    Only of paint that is lighter than what lies around it, which is found nearly always; and none
    is missed where as much of what was clicked is not seen as is: at night, in snow, in a picture
    of something else.
    """
    wrong = error_classes(known)
    judged = [
        (one, seen)
        for one in looked_at.clicked
        if (seen := looked_at.paint.get(one.name)) is not None and _is_checked(one)
    ]
    missed = [_has_no_line(one, seen) for one, seen in judged]
    can_see = 2 * sum(missed) <= len(missed)
    for (one, seen), is_missed in zip(judged, missed, strict=True):
        if one.name not in wrong:
            told = _displaced_finding(one, seen) or _no_line_finding(one, seen, is_missed=is_missed and can_see)
            if told is not None:
                yield told


def _displaced_finding(one: AnnotatedElement, seen: LineEvidence) -> Finding | None:
    """Paint that is seen, but beside the element or beside one of its ends."""
    if bent := _line_bend_px(one, seen):
        reason = translatable(
            "{title} is straight between its clicks, its paint runs up to {px:.0f} px beside it:"
            " regularise it (R)",
            title=one.title,
            px=bent,
        )
        return Finding(Rule.BESIDE_PAINT, Severity.WARNING, (one.name,), reason, (_FOLLOW_LINE_REMEDY,))
    if (end := _displaced_end(one, seen)) is not None:
        which, off_px = end
        reason = translatable(
            "an end of {title} lies about {px:.0f} px beside its paint, which is seen on the way"
            " there: put that point on it",
            title=one.title,
            px=off_px,
        )
        point = one.indices[which]
        return Finding(Rule.BESIDE_PAINT, Severity.WARNING, (one.name,), reason, (LOOK,), point)
    return None


def _no_line_finding(one: AnnotatedElement, seen: LineEvidence, *, is_missed: bool) -> Finding | None:
    """No paint under much of the element, or towards one of its ends."""
    if is_missed:
        share, length = seen.missing_share, seen.longest_gap_px
        is_sure = share >= _ERROR_MISSING_SHARE and _missing_px(seen) >= _MIN_MISSING_PX
        severity = Severity.WARNING if is_sure else Severity.HINT
        reason = translatable(
            "no paint under {title} along {percent:.0f} % of it, at most {px:.0f} px on end",
            title=one.title,
            percent=100 * share,
            px=length,
        )
        return Finding(Rule.NO_PAINT, severity, (one.name,), reason, (LOOK,))
    if (end := _end_without_line(one, seen)) is not None:
        reason = translatable(
            "no paint under {title} towards one of its ends, under all the rest there is",
            title=one.title,
        )
        point = one.indices[end]
        return Finding(Rule.NO_PAINT, Severity.HINT, (one.name,), reason, (LOOK,), point)
    return None


def _is_checked(one: AnnotatedElement) -> bool:
    # Between few clicks nobody knows how a curve runs.
    known = not one.element.is_curved or len(one.points) >= _MIN_CURVE_CLICKS
    return known and one.element.appearance.tone == LIGHTER


def _has_no_line(one: AnnotatedElement, seen: LineEvidence) -> bool:
    least_px = _MIN_MISSING_BAR_PX if one.element.appearance.kind == BAR else _MIN_MISSING_PX
    return seen.missing_share >= _MIN_MISSING_SHARE and _missing_px(seen) >= least_px


def _missing_px(seen: LineEvidence) -> float:
    """Length without paint, px at 960 px width."""
    return seen.missing_share * float(seen.lengths_px.sum()) * seen.scale


def _line_bend_px(one: AnnotatedElement, seen: LineEvidence) -> float:
    """How far the paint runs beside the middle of a straight element, px of the picture; 0 where
    it does not, or nobody can say."""
    if not one.element.is_straight:
        return 0.0
    off, paint = seen.steady, seen.paint
    found = paint != LinePresence.NONE
    sides = [(paint == side).mean() for side in (LinePresence.LEFT, LinePresence.RIGHT)]
    if found.mean() < _MIN_SEEN_SHARE or max(sides) < _MIN_DISPLACED_SHARE or min(sides) > 0.1:
        return 0.0
    # Its ends are on the paint: else the element is beside it as a whole, or another one's.
    at_ends = np.abs(off[found][[0, -1]]) * seen.scale
    most = float(np.quantile(np.abs(off[found]), 0.9))
    most_px = most * seen.scale
    return most if most_px >= _BEND_PX and at_ends.max() <= _END_SHARE * most_px else 0.0


def _displaced_end(one: AnnotatedElement, seen: LineEvidence) -> tuple[int, float] | None:
    """Which end of a straight element lies beside its paint, 0 or -1, and how far, px of the
    picture: from the click before it the paint steadily leaves the line."""
    if not one.element.is_straight:
        return None
    for end in (0, -1):
        rows = np.flatnonzero(seen.segments == seen.segments[end])
        rows = rows if end == -1 else rows[::-1]
        way = (np.arange(len(rows)) + 0.5) / len(rows)  # 1 at the end
        off = seen.steady[rows] * seen.scale
        there = ~np.isnan(off)
        if there.sum() < max(_MIN_PLACES, _MIN_SEEN_SHARE / 2 * len(rows)):
            continue
        slope, before = np.polyfit(way[there], off[there], 1)
        apart = np.abs(before + slope * way[there] - off[there])
        at_end = abs(before + slope)
        seen_px = np.abs(off[there][-1])  # farther off nothing is looked for
        starts_on_it = abs(before) <= _ALIGNED_PX and np.median(apart) <= _LINE_RESIDUAL_PX / 2
        if (
            starts_on_it
            and at_end >= _DISPLACED_END_PX
            and seen_px >= _SEEN_SPACING_PX
            and apart.max() < _LINE_RESIDUAL_PX
        ):
            return end, at_end / seen.scale
    return None


def _end_without_line(one: AnnotatedElement, seen: LineEvidence) -> int | None:
    """Which end of a straight element has no paint between it and the click before it, 0 or -1,
    though all else has."""
    if not one.element.is_straight:
        return None
    unseen = seen.paint != LinePresence.UNDER
    for end in (0, -1):
        there = seen.segments == seen.segments[end]
        rest = (~there).sum()
        if (
            there.sum() >= _MIN_PLACES <= rest
            and unseen[there].all()
            and not unseen[~there].any()
        ):
            return end
    return None
