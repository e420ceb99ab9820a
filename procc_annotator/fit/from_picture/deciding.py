"""Whether the best camera of a search may be relied on, and why, in words."""

from __future__ import annotations

from dataclasses import dataclass

from procc_annotator.fit.determined import hardly_determined
from procc_annotator.fit.from_picture.climbing import harmonic
from procc_annotator.fit.from_picture.proposal import NONE, SURE, UNSURE, State
from procc_annotator.fit.result import FitResult
from procc_annotator.language import said, said_joined

# Below, what was found is no camera of this picture.
_LEAST_BOTH = 0.4
SURE_COVERAGE, SURE_EXPLAINED, _SURE_MARGIN = 0.65, 0.8, 0.18
_WELL, MARGIN_WELL = 0.85, 0.1  # where more is found, less has to part it from others
_MOST_UNLIKELY = 6.0
# Longer by shorter side of the narrowest pictures that cameras make (5:4). In a squeezed picture
# another position and zoom agree with the lines as well as the true ones do with square pixels.
_NARROWEST = 1.25
# So many elements tell a camera; one less, such as a circle and two lines, where all is found.
_SURE_ELEMENTS, _ALL_FOUND = 4, 0.9


@dataclass(frozen=True, eq=False)
class Evidence:
    """What speaks for and against a camera.

    Attributes:
        fit: the camera.
        coverage, explained: see `Proposal`.
        margin: see `Proposal`.
        unlikeliness: half the squared deviations from where cameras are expected.
        elements: how many of the field were found on paint.
        beside: which lie beside their paint, in words; "" for none.
    """

    fit: FitResult
    coverage: float
    explained: float
    margin: float
    unlikeliness: float
    elements: int
    beside: str = ""


def another_camera() -> str:
    """The reason for a camera that is not sure because of another one."""
    return said("another camera that shows other lines suits the picture nearly as well")


def decide(seen: Evidence) -> tuple[State, str]:
    """Whether a camera is sure, unsure or none, and why, in a sentence."""
    shares = said(
        "{lines:.0f} % of the lines in sight lie on paint, which explains {paint:.0f} % of the"
        " paint on the ground",
        lines=100 * seen.coverage,
        paint=100 * seen.explained,
    )
    if seen.fit.camera is None:
        return NONE, seen.fit.failure or ""
    if harmonic(seen.coverage, seen.explained) < _LEAST_BOTH:
        return NONE, said(
            "no camera suits the paint in this picture: of the best one {shares}", shares=shares
        )
    doubt = _doubt(seen)
    return (UNSURE, said_joined("", (doubt, " (", shares, ")"))) if doubt else (SURE, shares)


def _doubt(seen: Evidence) -> str:
    share = min(seen.coverage, seen.explained)
    if max(seen.fit.size) < _NARROWEST * min(seen.fit.size):  # phones stand upright
        return said(
            "the picture is nearly square, as a squeezed one is: its pixels may not be square"
        )
    if seen.margin < (_SURE_MARGIN if share < _WELL else MARGIN_WELL):
        return another_camera()
    if seen.coverage < SURE_COVERAGE:
        return said("lines are missing that should be in sight")
    if seen.explained < SURE_EXPLAINED:
        return said("there is paint where the field has none")
    if seen.unlikeliness > _MOST_UNLIKELY:
        return said("cameras hardly stand there")
    if seen.elements < _SURE_ELEMENTS - (share >= _ALL_FOUND):
        return said("too few lines are in sight to tell")
    if seen.beside:
        return seen.beside
    open_ = hardly_determined(seen.fit)
    return said("the lines in sight leave the camera open: {what}", what=open_) if open_ else ""
