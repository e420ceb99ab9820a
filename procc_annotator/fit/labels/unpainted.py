"""Elements under which the picture shows no paint, or beside which it runs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from procc_annotator.field.appearance import BAR, LIGHTER
from procc_annotator.fit.labels.clicked import Clicked, ClickedFrame
from procc_annotator.fit.labels.finding import (
    LOOK,
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
    surely_wrong,
)
from procc_annotator.fit.labels.seen_paint import ElementPaint, Paint
from procc_annotator.language import said

# Players hide shorter stretches, worn lines smaller shares, px at 960 px width.
_LONG_PX, _LEAST_SHARE = 40.0, 0.5
_LONG_OF_BAR_PX = 12.0  # which is short, and stands before whatever else there is
_SURE_SHARE = 0.8
_FEWEST_ON_CURVE = 5
# A straight element beside its paint: a lens bends it between its clicks.
_BENT_PX = 2.5
_SEEN_SHARE = 0.6  # what is beside something must be seen
_BESIDE_SHARE, _AT_ENDS = 0.25, 0.7
# An end beside its paint, px at 960 px width: how far at least, how near to it the point before
# still is, and how far what is seen between them may leave a line.
_ASTRAY_PX, _ON_PAINT_PX, _ON_LINE_PX = 2.5, 1.2, 0.9
_LEAST_PLACES, _SEEN_PX = 3, 1.2
_FOLLOW = Remedy(RemedyKind.FOLLOW, said("put its points along the paint"))


def paint_findings(looked_at: ClickedFrame, known: Sequence[Finding]) -> Iterator[Finding]:
    """What the picture says of elements; nothing where nobody looked at it.

    Only of paint that is lighter than what lies around it, which is found nearly always; and none
    is missed where as much of what was clicked is not seen as is: at night, in snow, in a picture
    of something else.
    """
    wrong = surely_wrong(known)
    judged = [
        (one, seen)
        for one in looked_at.clicked
        if (seen := looked_at.paint.get(one.name)) is not None and _is_judged(one)
    ]
    missed = [_is_unpainted(one, seen) for one, seen in judged]
    can_see = 2 * sum(missed) <= len(missed)
    for (one, seen), is_missed in zip(judged, missed, strict=True):
        if one.name not in wrong:
            told = _beside(one, seen) or _without(one, seen, is_missed=is_missed and can_see)
            if told is not None:
                yield told


def _beside(one: Clicked, seen: ElementPaint) -> Finding | None:
    """Paint that is seen, but beside the element or beside one of its ends."""
    if bent := _bent_px(one, seen):
        reason = said(
            "{title} is straight between its clicks, its paint runs up to {px:.0f} px beside it:"
            " regularise it (R)",
            title=one.title,
            px=bent,
        )
        return Finding(Rule.BESIDE_PAINT, Severity.WARNING, (one.name,), reason, (_FOLLOW,))
    if (end := _astray_end(one, seen)) is not None:
        which, off_px = end
        reason = said(
            "an end of {title} lies about {px:.0f} px beside its paint, which is seen on the way"
            " there: put that point on it",
            title=one.title,
            px=off_px,
        )
        point = one.indices[which]
        return Finding(Rule.BESIDE_PAINT, Severity.WARNING, (one.name,), reason, (LOOK,), point)
    return None


def _without(one: Clicked, seen: ElementPaint, *, is_missed: bool) -> Finding | None:
    """No paint under much of the element, or towards one of its ends."""
    if is_missed:
        share, length = seen.share_without, seen.longest_without_px
        is_sure = share >= _SURE_SHARE and _without_px(seen) >= _LONG_PX
        severity = Severity.WARNING if is_sure else Severity.HINT
        reason = said(
            "no paint under {title} along {percent:.0f} % of it, at most {px:.0f} px on end",
            title=one.title,
            percent=100 * share,
            px=length,
        )
        return Finding(Rule.NO_PAINT, severity, (one.name,), reason, (LOOK,))
    if (end := _unseen_end(one, seen)) is not None:
        reason = said(
            "no paint under {title} towards one of its ends, under all the rest there is",
            title=one.title,
        )
        point = one.indices[end]
        return Finding(Rule.NO_PAINT, Severity.HINT, (one.name,), reason, (LOOK,), point)
    return None


def _is_judged(one: Clicked) -> bool:
    # Between few clicks nobody knows how a curve runs.
    known = not one.element.is_curved or len(one.points) >= _FEWEST_ON_CURVE
    return known and one.element.appearance.tone == LIGHTER


def _is_unpainted(one: Clicked, seen: ElementPaint) -> bool:
    least_px = _LONG_OF_BAR_PX if one.element.appearance.kind == BAR else _LONG_PX
    return seen.share_without >= _LEAST_SHARE and _without_px(seen) >= least_px


def _without_px(seen: ElementPaint) -> float:
    """Length without paint, px at 960 px width."""
    return seen.share_without * float(seen.lengths_px.sum()) * seen.scale


def _bent_px(one: Clicked, seen: ElementPaint) -> float:
    """How far the paint runs beside the middle of a straight element, px of the picture; 0 where
    it does not, or nobody can say."""
    if not one.element.is_straight:
        return 0.0
    off, paint = seen.steady, seen.paint
    found = paint != Paint.NONE
    sides = [(paint == side).mean() for side in (Paint.LEFT, Paint.RIGHT)]
    if found.mean() < _SEEN_SHARE or max(sides) < _BESIDE_SHARE or min(sides) > 0.1:
        return 0.0
    # Its ends are on the paint: else the element is beside it as a whole, or another one's.
    at_ends = np.abs(off[found][[0, -1]]) * seen.scale
    most = float(np.quantile(np.abs(off[found]), 0.9))
    most_px = most * seen.scale
    return most if most_px >= _BENT_PX and at_ends.max() <= _AT_ENDS * most_px else 0.0


def _astray_end(one: Clicked, seen: ElementPaint) -> tuple[int, float] | None:
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
        if there.sum() < max(_LEAST_PLACES, _SEEN_SHARE / 2 * len(rows)):
            continue
        slope, before = np.polyfit(way[there], off[there], 1)
        apart = np.abs(before + slope * way[there] - off[there])
        at_end = abs(before + slope)
        seen_px = np.abs(off[there][-1])  # farther off nothing is looked for
        starts_on_it = abs(before) <= _ON_PAINT_PX and np.median(apart) <= _ON_LINE_PX / 2
        if (
            starts_on_it
            and at_end >= _ASTRAY_PX
            and seen_px >= _SEEN_PX
            and apart.max() < _ON_LINE_PX
        ):
            return end, at_end / seen.scale
    return None


def _unseen_end(one: Clicked, seen: ElementPaint) -> int | None:
    """Which end of a straight element has no paint between it and the click before it, 0 or -1,
    though all else has."""
    if not one.element.is_straight:
        return None
    unseen = seen.paint != Paint.UNDER
    for end in (0, -1):
        there = seen.segments == seen.segments[end]
        rest = (~there).sum()
        if (
            there.sum() >= _LEAST_PLACES <= rest
            and unseen[there].all()
            and not unseen[~there].any()
        ):
            return end
    return None
