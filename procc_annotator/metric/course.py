"""A course of points: lengths along it, places at them, directions across it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

FloatArray = NDArray[np.float64]


def arc_lengths(course: FloatArray) -> FloatArray:
    """(n,) length of the way to each point of a course (n, 2), 0 at the first; in its units."""
    return np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(course, axis=0).T))])


def points_at_arc_lengths(course: FloatArray, at: FloatArray, lengths: FloatArray | None = None) -> FloatArray:
    """(m, 2) the places at some lengths (m,) along a course (n, 2); at its ends beyond them.

    Args:
        course, at: in the same units.
        lengths: of `arc_lengths`, where they are known.
    """
    known = arc_lengths(course) if lengths is None else lengths
    return np.column_stack([np.interp(at, known, course[:, k]) for k in (0, 1)])


def polyline_normals(course: FloatArray, reach: int = 1) -> FloatArray:
    """(n, 2) unit vectors across a course of (n, 2) px, n >= 2.

    Args:
        course: px.
        reach: the direction is that from so many points before to so many behind; more than one
            where the corners of a polyline are not to show.
    """
    rows = np.arange(len(course))
    along = course[np.minimum(rows + reach, len(rows) - 1)] - course[np.maximum(rows - reach, 0)]
    length = np.hypot(along[:, 0], along[:, 1])[:, None]
    along = np.where(length > 0, along / np.maximum(length, 1e-12), (1.0, 0.0))
    return np.column_stack([-along[:, 1], along[:, 0]])
