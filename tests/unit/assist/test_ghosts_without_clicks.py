"""What a camera found without clicks tells of a frame."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.assist.frame_analysis import analyse_frame, contradicts, ghosts_without_clicks
from procc_annotator.calibration.result import FitResult, external_camera_fit
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.field.load import load_field

SIZE = (960, 540)
FIELD = load_field("soccer")
NOTHING = FrameAnnotation()


@pytest.fixture
def fit(sample_data) -> FitResult:
    found = CameraSet.open(sample_data / "cameras" / "true").camera("00002", SIZE)
    assert isinstance(found.camera, PinholeCamera)
    return external_camera_fit(found.camera, SIZE)


def clicked(fit: FitResult, name: str, off_px: float) -> FrameAnnotation:
    """Two points of the first piece of an element, moved aside."""
    ghost = next(g for g in ghosts_without_clicks(NOTHING, FIELD, fit).ghosts if g.name == name)
    course = ghost.pieces[0].points_px
    ends = course[[len(course) // 3, 2 * len(course) // 3]]
    along = (ends[1] - ends[0]) / np.hypot(*(ends[1] - ends[0]))
    ends = ends + off_px * np.array([-along[1], along[0]])
    points = tuple(point_from_px(x, y, SIZE) for x, y in ends.tolist())
    return NOTHING.with_polyline(Polyline(name, points))


def test_ghosts_without_a_click(fit) -> None:
    insight = ghosts_without_clicks(NOTHING, FIELD, fit)
    names = [ghost.name for ghost in insight.ghosts]

    assert not insight.from_clicks
    assert "Big rect. left main" in names
    hidden = ghosts_without_clicks(NOTHING, FIELD, fit, frozenset(names[:1]))
    assert [ghost.name for ghost in hidden.ghosts] == names[1:]


@pytest.mark.parametrize(("off_px", "contradicted"), [(0.0, False), (6.0, False), (40.0, True)])
def test_clicks_elsewhere_end_it(fit, off_px, contradicted) -> None:
    annotation = clicked(fit, "Big rect. left main", off_px)

    assert contradicts(annotation, FIELD, fit) is contradicted
    insight = ghosts_without_clicks(annotation, FIELD, fit)
    assert (insight.fit.camera is None) is contradicted
    assert bool(insight.ghosts) is not contradicted


def test_an_element_out_of_sight_contradicts_it(fit) -> None:
    points = tuple(point_from_px(x, y, SIZE) for x, y in ((300, 200), (500, 300)))
    annotation = NOTHING.with_polyline(Polyline("Big rect. right main", points))

    assert contradicts(annotation, FIELD, fit)


@pytest.mark.parametrize(("off_px", "by_clicks"), [(0.0, False), (12.0, True)])
def test_three_lines_are_judged_with_the_camera_that_they_agree_with(
    fit, off_px, by_clicks
) -> None:
    names = "Big rect. left main", "Big rect. left bottom", "Small rect. left main"
    polylines = [clicked(fit, name, off_px).polylines[0] for name in names]
    annotation = FrameAnnotation(tuple(polylines))
    fitted = analyse_frame(annotation, FIELD, size=SIZE)
    insight = ghosts_without_clicks(annotation, FIELD, fit, fitted=fitted)

    assert fitted.fit.camera is not None
    assert (insight is fitted) is by_clicks
    assert (len(insight.ghosts) > len(fitted.ghosts)) is not by_clicks
