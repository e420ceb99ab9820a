"""The painted line beside a predicted course: where it runs, and where it can be seen at all.

Places along the course are put on their paint across it; a smooth offset that most of them agree on
gives the line's own course. Along that the picture is straightened: where it shows no stroke of
the line's own contrast and colour the line is hidden, or there is none.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from procc_annotator.field.appearance import EDGE
from procc_annotator.image.decode import PixelArray
from procc_annotator.image.paint import SNAP_RADIUS_PX, snap_points_to_lines
from procc_annotator.image.sought import LineTarget
from procc_annotator.image.strip import straighten_curve
from procc_annotator.metric.course import arc_lengths, polyline_normals, points_at_arc_lengths
from procc_annotator.session.strokes.agreement import smooth_inliers
from procc_annotator.session.strokes.line_runs import BESIDE_PX, runs_seen

FloatArray = NDArray[np.float64]
IntArray = NDArray[np.intp]

_LEAST_REACH_PX = 2.0
_REACH_SD = 3.0
_STEADY_PX = 3  # over so many pixels to either side a line's direction is taken
_SNAP_EVERY_PX = 14.0
_SNAPS = (5, 40)
_TANGENT_PX = 40


@dataclass(frozen=True, eq=False)
class VisibleLine:
    """A line's own course beside a predicted one.

    Attributes:
        course_px: (n, 2) px, a place about every pixel.
        directions: (n, 2) unit vectors.
        runs: first and one past the last place of each stretch that can be seen.
        expected: first and last place of the predicted course; what lies beyond is straight on.
    """

    course_px: FloatArray
    directions: FloatArray
    runs: tuple[tuple[int, int], ...]
    expected: tuple[int, int]

    @property
    def length(self) -> int:
        """Places along it, seen or not."""
        return len(self.course_px)

    @property
    def seen(self) -> int:
        """Places that can be seen."""
        return sum(end - begin for begin, end in self.runs)


def find_line(
    picture: PixelArray,
    predicted_px: FloatArray,
    sd_px: FloatArray,
    sought: LineTarget,
    *,
    curved: bool,
    on_ground: bool,
    beyond_px: tuple[float, float] = (0.0, 0.0),
) -> VisibleLine:
    """The painted line near a predicted course.

    Args:
        picture: (H, W, 4) BGRA.
        predicted_px: (n, 2) px, dense, n >= 2.
        sd_px: (n,) how surely it is known across; the line is looked for within three of these, at
            least 2 px and at most the reach of snapping.
        sought: what its paint looks like.
        curved: whether the line is a circle or an arc.
        on_ground: whether the same ground lies to both sides of it all along.
        beyond_px: how far beyond its first and its last place the line may go on, straight.

    Returns:
        Without runs where there is no such line.
    """
    course, sd = _every_pixel(predicted_px, sd_px)
    across = polyline_normals(course, _STEADY_PX)
    reach = float(np.clip(_REACH_SD * sd.max(), _LEAST_REACH_PX, SNAP_RADIUS_PX))
    offsets, hits = _offsets(picture, course, across, reach, sought, curved=curved)
    if offsets is None:
        return VisibleLine(course, _along(across), (), (0, len(course) - 1))
    course = course + across * offsets[:, None]
    size = picture.shape[1], picture.shape[0]
    whole = continued(course[::-1], beyond_px[0], size)[::-1]
    before = len(whole) - len(course)
    whole = continued(whole, beyond_px[1], size)
    across = polyline_normals(whole, _STEADY_PX)
    strip = straighten_curve(picture, whole, across, BESIDE_PX)
    edge = sought.looks.kind == EDGE
    runs = runs_seen(strip, hits + before, on_ground=on_ground, edge=edge)
    return VisibleLine(whole, _along(across), runs, (before, before + len(course) - 1))


def continued(course: FloatArray, by_px: float, size: tuple[int, int] | None = None) -> FloatArray:
    """A course and, straight on from its last end, some more px; as far as a picture's edge."""
    more = course[-1] + np.arange(1.0, by_px + 1.0)[:, None] * onwards(course)
    if size is not None:
        more = more[((more >= 0) & (more <= np.array(size) - 1)).all(axis=1)]
    return np.vstack([course, more])


def onwards(course: FloatArray) -> FloatArray:
    """(2,) unit vector straight on from a course's last end."""
    along = course[-1] - course[max(0, len(course) - 1 - _TANGENT_PX)]
    return np.asarray(along / max(float(np.hypot(*along)), 1e-9))


def _every_pixel(predicted: FloatArray, sd: FloatArray) -> tuple[FloatArray, FloatArray]:
    lengths = arc_lengths(predicted)
    at = np.linspace(0.0, lengths[-1], max(3, round(lengths[-1]) + 1))
    course = points_at_arc_lengths(predicted, at, lengths)
    return course, np.interp(at, lengths, sd)


def _along(across: FloatArray) -> FloatArray:
    return np.column_stack([across[:, 1], -across[:, 0]])


def _offsets(
    picture: PixelArray,
    course: FloatArray,
    across: FloatArray,
    reach: float,
    sought: LineTarget,
    *,
    curved: bool,
) -> tuple[FloatArray | None, IntArray]:
    """(n,) px from the predicted to the line's own course, and the rows that showed it."""
    n = len(course)
    count = int(np.clip(round(n / _SNAP_EVERY_PX), *_SNAPS))
    rows = np.unique(np.linspace(0, n - 1, count).round().astype(np.intp))
    found = snap_points_to_lines(picture, course[rows], _along(across[rows]), sought, reach_px=reach)
    values = ((found - course[rows]) * across[rows]).sum(axis=1)
    known = ~np.isnan(values)
    if known.sum() < 3:
        return None, rows[:0]
    places = 2.0 * rows / (n - 1) - 1.0
    agreed, coefficients = smooth_inliers(places[known], values[known], reach, terms=5 if curved else 3)
    if agreed.sum() < 3:
        return None, rows[:0]
    whole = np.polynomial.legendre.legval(np.linspace(-1.0, 1.0, n), coefficients)
    return np.clip(whole, -reach - 1.0, reach + 1.0), rows[known][agreed]
