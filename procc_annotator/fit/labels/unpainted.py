"""Elements under which the picture shows no paint, or beside which it runs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from procc_annotator.field.appearance import LIGHTER
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
from procc_annotator.fit.labels.seen_paint import Paint, SeenPaint

# Players hide shorter stretches, worn lines smaller shares, px at 960 px width.
_LONG_PX, _LEAST_SHARE = 40.0, 0.5
_SURE_SHARE = 0.8
_FEWEST_ON_CURVE = 5
# A straight element beside its paint: a lens bends it between its clicks.
_BENT_PX = 2.5
_SEEN_SHARE = 0.6  # what is beside something must be seen
_BESIDE_SHARE, _AT_ENDS = 0.25, 0.7
_FOLLOW = Remedy(RemedyKind.FOLLOW, "put its points along the paint")


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
    missed = [_is_unpainted(seen) for _, seen in judged]
    can_see = 2 * sum(missed) <= len(missed)
    for (one, seen), is_missed in zip(judged, missed, strict=True):
        if one.name in wrong:
            continue
        bent = _bent_px(one, seen)
        if bent:
            yield Finding(
                Rule.BESIDE_PAINT,
                Severity.WARNING,
                (one.name,),
                f"{one.title} is straight between its clicks, its paint runs up to {bent:.0f} px"
                " beside it: regularise it (R)",
                (_FOLLOW,),
            )
        elif is_missed and can_see:
            share, length = seen.share_without, seen.longest_without_px
            yield Finding(
                Rule.NO_PAINT,
                Severity.WARNING if share >= _SURE_SHARE else Severity.HINT,
                (one.name,),
                f"no paint under {one.title} along {100 * share:.0f} % of it, at most"
                f" {length:.0f} px on end",
                (LOOK,),
            )


def _is_judged(one: Clicked) -> bool:
    # Between few clicks nobody knows how a curve runs.
    known = not one.element.is_curved or len(one.points) >= _FEWEST_ON_CURVE
    return known and one.element.appearance.tone == LIGHTER


def _is_unpainted(seen: SeenPaint) -> bool:
    without_px = seen.share_without * float(seen.lengths_px.sum()) * seen.scale
    return seen.share_without >= _LEAST_SHARE and without_px >= _LONG_PX


def _bent_px(one: Clicked, seen: SeenPaint) -> float:
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
