"""One frame further: the camera as the picture's motion foretells it, made right on paint.

What is believed of the camera goes from frame to frame: the motion makes it less sure, paint surer.
Paint is looked for only where the camera is believed to show some, so that another line is out of
reach; where little of what should be there is found, or it would move the camera farther than the
belief allows, the frame's paint has no say and the motion alone carries the camera on.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from procc_annotator.fit.on_paint.belief import COUNTS, Belief, Solved, solve_believed, weights_of
from procc_annotator.fit.on_paint.beside import (
    FoundAround,
    elements_beside,
    elements_missed,
    look_beside,
    marks_off_px,
)
from procc_annotator.fit.on_paint.expected import Expected, expect, projected_px
from procc_annotator.fit.on_paint.looking import (
    SPACING_PX,
    PaintLook,
    look,
    look_at,
    shares_on_paint,
)
from procc_annotator.fit.on_paint.marks import PARAMETERS_FREE, Marks
from procc_annotator.fit.on_paint.painted import Painted
from procc_annotator.fit.on_paint.result import Worth, worth_of
from procc_annotator.fit.solving.covariance import projected_covariance, worst_sd
from procc_annotator.fit.solving.jacobian import Lens
from procc_annotator.fit.solving.models import KAPPA, LOG_FOCAL, ROLL, X, Z
from procc_annotator.fit.solving.observations import FloatArray, IntArray, PictureFrame
from procc_annotator.fit.through_shot.stand import TRIPOD, ShotStand, lens_change
from procc_annotator.fit.through_shot.turning import OWN, Turn
from procc_annotator.image.pixels import PixelArray
from procc_annotator.language import said

_ROLL_RAD = 2e-5  # what a frame may add to what is believed, standard deviation: tripods lean
# Of a step that nothing foretells: pan, tilt, roll, logarithm of the focal length.
_UNKNOWN_STEP = np.array([np.deg2rad(0.25), np.deg2rad(0.15), np.deg2rad(0.03), 0.01])
_SLOWING = 0.7
_LEAST_REACH_PX, _MOST_REACH_PX = 5.0, 20.0
_REACH_IN_SD = 3.0
_SURE_REACH_PX = 8.0  # beyond it what was found is looked at once more, from nearer
_FEWEST = 15  # marks that may have a say
_LEAST_COVERAGE, _LEAST_COVERAGE_FAR = 0.3, 0.5
_MOST_IN_SD, _MOST_BESIDE_PX = 4.0, 4.0  # how far paint may move the camera against the belief
_APART_SPACING_PX = 20.0
_THIN = 3  # of marks that were averaged with their neighbours every third tells it all
_KEPT = 64


@dataclass(frozen=True, eq=False)
class Stepped:
    """Where a frame's camera is.

    Attributes:
        belief: after the frame.
        marks: paint that had a say, thinned; None if none had.
        worth: of a mark.
        standing_for: how many marks each that was kept stands for.
        turn: from the frame before; None at the first, or where nothing tells.
        coverage, residual_px: of what should be in sight; solver px.
        sd_px: how surely its wireframe is known, solver px, where it is least sure.
        reason: why paint had no say, in words; "" if it had.
        around: where the elements of which little was found were seen, farther out.
    """

    belief: Belief
    marks: Marks | None
    worth: Worth
    turn: Turn | None
    coverage: float
    residual_px: float | None
    sd_px: float
    reason: str = ""
    standing_for: float = 1.0
    around: FoundAround | None = None

    def beside(self, vector: FloatArray, frame: PictureFrame) -> dict[int, float]:
        """Elements that a camera (11,) shows beside their paint in this frame, see
        `elements_beside`."""
        if self.marks is None:
            return {}
        return elements_beside(vector, self.marks, self._length_px(self.marks), self.around, frame)

    def missed(self, painted: Painted, frame: PictureFrame) -> IntArray:
        """Elements that its camera misses in this frame, see `elements_missed`."""
        if self.marks is None:
            return np.zeros(0, dtype=np.intp)
        length = self._length_px(self.marks)
        return elements_missed(self.belief.vector, self.marks, length, painted, frame)

    def _length_px(self, marks: Marks) -> FloatArray:
        return np.full(len(marks), self.standing_for * _THIN * SPACING_PX)


def foretold(
    belief: Belief, turn: Turn | None, last: FloatArray, stand: ShotStand = TRIPOD
) -> Belief:
    """What is believed of a camera one frame on.

    Args:
        belief: of the frame before.
        turn: how the picture says it moved.
        last: (4,) the step before, which goes on more slowly where nothing tells.
        stand: what the camera stands on.
    """
    covariance = belief.covariance
    vector = belief.vector.copy()
    step = np.zeros((PARAMETERS_FREE, PARAMETERS_FREE))
    if turn is None:
        vector[OWN] += _SLOWING * last
        step[OWN, OWN] = _UNKNOWN_STEP**2
    else:
        vector[OWN] += turn.step
        step[np.ix_(OWN, OWN)] = turn.covariance + np.diag(stand.apparent**2)
    step[range(X, Z + 1), range(X, Z + 1)] += stand.position_m**2
    step[KAPPA, KAPPA] += lens_change(vector[LOG_FOCAL] - belief.vector[LOG_FOCAL]) ** 2
    step[ROLL, ROLL] += _ROLL_RAD**2
    return Belief(vector, np.asarray(np.linalg.inv(covariance + step)))


def wireframe_sd(belief: Belief, seen: FloatArray, frame: PictureFrame) -> float:
    """How surely places (3, n) metres in sight are known in the picture: that of nine in ten."""
    if not seen.shape[1]:
        return np.inf
    few = seen[:, :: max(1, seen.shape[1] // 60)]
    found = projected_covariance(belief.vector, None, frame.half_diagonal, belief.covariance, few.T)
    sd = worst_sd(found)
    sd = sd[np.isfinite(sd)]
    return _nine_in_ten(sd)


def stepped(
    picture: PixelArray,
    believed: Belief,
    turn: Turn | None,
    painted: Painted,
    frame: PictureFrame,
    worth: Worth,
) -> Stepped:
    """A frame's camera from what is believed of it and the paint near where that shows some.

    Args:
        picture: (H, W, 4) BGRA.
        believed: before the frame's paint, see `foretold`.
        turn: what went into that.
        painted: the field's paint.
        frame: the picture.
        worth: of a mark in the frame before.
    """
    expected = expect(believed.vector, painted, frame, SPACING_PX)
    sd_px = wireframe_sd(believed, painted.world[:, expected.rows], frame)
    reach = float(np.clip(_REACH_IN_SD * sd_px + 2.0, _LEAST_REACH_PX, _MOST_REACH_PX))
    seen = look_at(picture, expected, painted, frame, reach)
    none = Stepped(believed, None, worth, turn, 0.0, None, sd_px)
    if len(seen.marks) < _FEWEST:
        return replace(none, reason=said("too little paint in sight"))
    solved, marks = _solved(seen, believed, believed.vector, frame, worth, reach)
    if reach > _SURE_REACH_PX:
        seen = look(picture, solved.vector, painted, frame, _LEAST_REACH_PX)
        if len(seen.marks) < _FEWEST:
            return replace(none, reason=said("too little paint in sight"))
        solved, marks = _solved(seen, believed, solved.vector, frame, worth, _LEAST_REACH_PX)
    off = marks_off_px(solved.vector, seen.marks, frame)
    weights = weights_of(off)
    coverage, _ = shares_on_paint(seen, weights, painted)
    least = _LEAST_COVERAGE_FAR if reach > _SURE_REACH_PX else _LEAST_COVERAGE
    none = replace(none, coverage=coverage)
    if (solved.weights > COUNTS).sum() < _FEWEST / _THIN or coverage < least:
        return replace(none, reason=said("too little of what should be in sight was found"))
    moved = _apart(expected, solved.vector, painted, frame)
    if moved > _MOST_IN_SD * sd_px + _MOST_BESIDE_PX:
        return replace(none, reason=said("the paint that was found would move the camera too far"))
    residual = float(np.median(np.abs(off[weights > COUNTS])))
    around = look_beside(picture, solved.vector, painted, frame, seen, weights)
    none = replace(none, residual_px=residual, around=around)
    return _surer(none, solved, marks, painted.world[:, seen.expected.rows], frame)


def _surer(
    before: Stepped, solved: Solved, marks: Marks, seen: FloatArray, frame: PictureFrame
) -> Stepped:
    """A frame after its paint has had a say; ``seen``: (3, n) metres, what is in sight."""
    worth = worth_of(solved, marks)
    information = solved.information / worth.information_px**2 + before.belief.information
    belief = Belief(solved.vector, information)
    counted = solved.weights > COUNTS
    kept = _kept(counted)
    return replace(
        before,
        belief=belief,
        marks=marks.chosen(kept).small(),
        worth=worth,
        sd_px=wireframe_sd(belief, seen, frame),
        standing_for=float(counted.sum()) / len(kept),
    )


def _solved(
    seen: PaintLook,
    believed: Belief,
    start: FloatArray,
    frame: PictureFrame,
    worth: Worth,
    reach_px: float,
) -> tuple[Solved, Marks]:
    """The camera for every third of the marks, and those."""
    marks = seen.marks.chosen(np.arange(0, len(seen.marks), _THIN))
    solved = solve_believed(
        marks,
        believed,
        start,
        frame.half_diagonal,
        error_px=worth.information_px,
        scale_px=reach_px / 2,
    )
    return solved, marks


def wireframe_apart(
    one: FloatArray, other: FloatArray, painted: Painted, frame: PictureFrame
) -> float:
    """Solver px by which nine in ten places in sight of a camera (11,) are less off, across, in
    another one's picture."""
    return _apart(expect(one, painted, frame, _APART_SPACING_PX), other, painted, frame)


def _apart(expected: Expected, other: FloatArray, painted: Painted, frame: PictureFrame) -> float:
    if not len(expected.rows):
        return np.inf
    there, _ = projected_px(
        Lens.of(other[None], frame.half_diagonal), painted.world[:, expected.rows]
    )
    across = ((there - expected.px) * expected.normal).sum(axis=0)
    return _nine_in_ten(np.abs(across))


def _nine_in_ten(values: FloatArray) -> float:
    """What nine in ten of them are below; infinite without any."""
    return float(np.sort(values)[int(0.9 * (len(values) - 1))]) if len(values) else np.inf


def _kept(counted: np.ndarray) -> np.ndarray:
    """Rows of the marks that are kept, evenly chosen."""
    rows = np.flatnonzero(counted)
    if len(rows) <= _KEPT:
        return rows
    return np.asarray(rows[np.linspace(0, len(rows) - 1, _KEPT).round().astype(np.intp)])
