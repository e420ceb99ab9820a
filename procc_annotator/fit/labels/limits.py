"""From what on something is said, in solver px: px of a picture that is 960 px wide."""

from __future__ import annotations

from procc_annotator.fit.labels.finding import Remedy, RemedyKind
from procc_annotator.fit.result import ElementResidual, FitResult
from procc_annotator.fit.solving.observations import Frame

LOOK = Remedy(RemedyKind.LOOK, "look at it")

# An element with a point farther off than this is not where the camera of the others shows it.
LIMIT_PX = 9.0
# Where the other elements fit well less will do: so many times as far off as the next worst one.
_LEAST_LIMIT_PX = 6.5
_TIMES_NEXT = 3.0
# Points this near to another class could be that class.
FITS_PX = 8.0
# Elements that are right lie this near when the mistakes are left out.
RIGHT_PX = 5.0
# A straight element may lie this far beside a line, whatever the lens.
BENT_PX = 4.0


def limit_of(fit: FitResult, frame: Frame) -> float:
    """From what distance on an element of this fit is a suspect, solver px."""
    worst = sorted(off_px(element, frame) for element in fit.elements)
    if len(worst) < 2:
        return LIMIT_PX
    return min(max(_TIMES_NEXT * worst[-2], _LEAST_LIMIT_PX), LIMIT_PX)


def off_px(element: ElementResidual, frame: Frame) -> float:
    """How far off an element is, solver px: its largest distance, which of a landmark that is not
    known exactly counts less."""
    return element.most_counted_px * frame.scale


def in_picture(solver_px: float, frame: Frame) -> float:
    """The same distance in px of the picture."""
    return solver_px / frame.scale
