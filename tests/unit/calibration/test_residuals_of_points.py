"""Which point of a polyline each distance of a fit is of."""

from __future__ import annotations

import numpy as np

from procc_annotator.annotation import Polyline, point_from_px, points_px
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.optimization.observations import MAX_POINTS

SIZE = (960, 540)
NAME = "Big rect. left main"


def test_repeated_points_and_points_nowhere_do_not_shift_the_others(views, field) -> None:
    clean = views.main(np.random.default_rng(7), noise_px=0.3).annotation
    points = clean.get(NAME).points
    x, y = points_px(clean.get(NAME), SIZE)[-1]
    bad = point_from_px(x + 30, y, SIZE)
    nowhere = points[0]._replace(u=float("nan"))
    polyline = Polyline(NAME, (points[0], nowhere, points[0], *points[1:-1], bad))
    fit = fit_camera(clean.with_polyline(polyline), field, size=SIZE)
    (residual,) = (e for e in fit.elements if e.name == NAME)
    distances = residual.distances_of(polyline, SIZE)
    assert max(distances, key=distances.__getitem__) == len(polyline.points) - 1
    assert not {1, 2} & distances.keys()


def test_of_very_many_points_some_have_a_distance(views, field) -> None:
    clean = views.main(np.random.default_rng(8), noise_px=0.3).annotation
    first, *_, last = points_px(clean.get(NAME), SIZE)
    way = np.linspace(first, last, 3 * MAX_POINTS)
    polyline = Polyline(NAME, tuple(point_from_px(*p, SIZE) for p in way))
    fit = fit_camera(clean.with_polyline(polyline), field, size=SIZE)
    (residual,) = (e for e in fit.elements if e.name == NAME)
    places = list(residual.distances_of(polyline, SIZE))
    assert len(places) == MAX_POINTS
    assert (places[0], places[-1]) == (0, len(way) - 1)
    assert residual.distances_of(clean.get(NAME), SIZE) == {}  # another polyline
