"""Whether the best camera of a search may be relied on, and why, in words."""

from __future__ import annotations

from dataclasses import dataclass

from procc_annotator.fit.determined import ill_conditioned_reason
from procc_annotator.fit.from_picture.climbing import harmonic_mean
from procc_annotator.fit.from_picture.proposal import NONE, SURE, UNSURE, ProposalState
from procc_annotator.fit.result import FitResult
from procc_annotator.language import translatable, translatable_joined

# Below, what was found is no camera of this picture.
_MIN_HARMONIC_SCORE = 0.4
SURE_MIN_COVERAGE, SURE_MIN_EXPLAINED, _SURE_MIN_MARGIN = 0.65, 0.8, 0.18
_CLEAR_COVERAGE, CLEAR_MARGIN = 0.85, 0.1  # where more is found, less has to part it from others
_MAX_PRIOR_COST = 6.0
# Longer by shorter side of the narrowest pictures that cameras make (5:4). In a squeezed picture
# another position and zoom agree with the lines as well as the true ones do with square pixels.
_MIN_VIEW_FACTOR = 1.25
# So many elements tell a camera; one less, such as a circle and two lines, where all is found.
_SURE_MIN_ELEMENTS, _ALL_FOUND_SHARE = 4, 0.9


@dataclass(frozen=True, eq=False)
class ProposalEvidence:
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


def rival_camera_reason() -> str:
    """The reason for a camera that is not sure because of another one."""
    return translatable("another camera that shows other lines suits the picture nearly as well")


def classify_proposal(seen: ProposalEvidence) -> tuple[ProposalState, str]:
    """Whether a camera is sure, unsure or none, and why, in a sentence."""
    shares = translatable(
        "{lines:.0f} % of the lines in sight lie on paint, which explains {paint:.0f} % of the"
        " paint on the ground",
        lines=100 * seen.coverage,
        paint=100 * seen.explained,
    )
    if seen.fit.camera is None:
        return NONE, seen.fit.failure or ""
    if harmonic_mean(seen.coverage, seen.explained) < _MIN_HARMONIC_SCORE:
        return NONE, translatable(
            "no camera suits the paint in this picture: of the best one {shares}", shares=shares
        )
    doubt = _doubt_reason(seen)
    return (UNSURE, translatable_joined("", (doubt, " (", shares, ")"))) if doubt else (SURE, shares)


def _doubt_reason(seen: ProposalEvidence) -> str:
    share = min(seen.coverage, seen.explained)
    if max(seen.fit.size) < _MIN_VIEW_FACTOR * min(seen.fit.size):  # phones stand upright
        return translatable(
            "the picture is nearly square, as a squeezed one is: its pixels may not be square"
        )
    if seen.margin < (_SURE_MIN_MARGIN if share < _CLEAR_COVERAGE else CLEAR_MARGIN):
        return rival_camera_reason()
    if seen.coverage < SURE_MIN_COVERAGE:
        return translatable("lines are missing that should be in sight")
    if seen.explained < SURE_MIN_EXPLAINED:
        return translatable("there is paint where the field has none")
    if seen.unlikeliness > _MAX_PRIOR_COST:
        return translatable("cameras hardly stand there")
    if seen.elements < _SURE_MIN_ELEMENTS - (share >= _ALL_FOUND_SHARE):
        return translatable("too few lines are in sight to tell")
    if seen.beside:
        return seen.beside
    open_ = ill_conditioned_reason(seen.fit)
    return translatable("the lines in sight leave the camera open: {what}", what=open_) if open_ else ""
