"""A camera that is nearly right is made right on the paint of its picture, and told how surely."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.calibration.line_alignment.expected_lines import (
    expected_line_points,
    marking_points,
)
from procc_annotator.calibration.line_alignment.gaussian_state import edge_point_errors
from procc_annotator.calibration.line_alignment.refinement import (
    align_with_lines,
    displaced_elements_in_image,
    found_shares,
    measure_lines,
)
from procc_annotator.calibration.optimization.camera_parameters import vector_from_camera
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.field.geometry import Line
from procc_annotator.field.model import Appearance, Field
from tests.drawn_shots import draw as draw_scene
from tests.drawn_shots import looking_at, stage_of
from tests.unit.calibration.plain_pictures import FIELD, FRAME, SIZE, apart_px, camera, draw

TRUE = camera()
VECTOR = vector_from_camera(TRUE, FRAME)


def test_a_camera_beside_its_paint_is_put_on_it() -> None:
    beside = replace(TRUE, pan_rad=TRUE.pan_rad + 0.006, tilt_rad=TRUE.tilt_rad - 0.003)
    assert apart_px(TRUE, beside) > 5
    found = align_with_lines(draw(TRUE), FIELD, beside)
    assert isinstance(found.fit.camera, type(TRUE))
    assert apart_px(TRUE, found.fit.camera) < 0.7
    assert found.coverage > 0.9
    assert found.residual_px is not None
    assert found.residual_px < 0.3
    assert found.shares["Big rect. right main"] > 0.9
    assert not found.fit.left_out


def test_what_is_said_of_its_sureness_is_true() -> None:
    offs = []
    for seed in range(6):
        found = align_with_lines(draw(TRUE, noise=6.0, seed=seed), FIELD, TRUE).fit
        assert found.vector is not None
        assert found.covariance is not None
        off = (found.vector - VECTOR)[:8]
        offs.append(off / np.sqrt(np.diag(found.covariance)))
    assert 0.1 < np.sqrt(np.mean(np.square(offs))) < 2.0


def test_a_picture_without_lines_has_no_camera() -> None:
    found = align_with_lines(draw(TRUE, lines=False), FIELD, TRUE)
    assert found.fit.camera is None or found.coverage < 0.3
    blank = np.full((SIZE[1], SIZE[0], 4), 90, dtype=np.uint8)
    found = align_with_lines(blank, FIELD, TRUE)
    assert found.fit.camera is None
    assert found.fit.failure
    assert found.residual_px is None


def test_a_camera_that_sees_nothing_of_the_field_expects_nothing() -> None:
    away = vector_from_camera(replace(TRUE, pan_rad=TRUE.pan_rad + np.pi), FRAME)
    assert not len(expected_line_points(away, marking_points(FIELD), FRAME, 5.0).rows)
    assert align_with_lines(draw(TRUE), FIELD, away).fit.camera is None


def test_paint_darker_than_its_ground_is_found_as_such() -> None:
    dark = replace(
        FIELD,
        elements=tuple(
            replace(e, appearance=Appearance("line", "darker", "any", e.line_width))
            for e in FIELD.elements
            if e.line_width
        ),
    )
    picture = draw(TRUE)
    inverted = picture.copy()
    inverted[..., :3] = 255 - picture[..., :3]
    for field, shown, found in (
        (dark, inverted, True),
        (dark, picture, False),
        (FIELD, inverted, False),
    ):
        painted = marking_points(field)
        seen = measure_lines(shown, VECTOR, painted, FRAME, 4.0)
        share, _ = found_shares(seen, np.ones(len(seen.marks)), painted)
        assert (share > 0.8) == found


def test_derivatives_of_marks_are_those_of_where_they_appear() -> None:
    marks = measure_lines(draw(TRUE), VECTOR, marking_points(FIELD), FRAME, 4.0).marks
    _, by = edge_point_errors(VECTOR[None], marks, FRAME.half_diagonal)
    for parameter, step in enumerate((1e-6, 1e-6, 1e-6, 1e-4, 1e-4, 1e-4, 1e-6, 1e-5)):
        ahead, back = VECTOR.copy(), VECTOR.copy()
        ahead[parameter] += step
        back[parameter] -= step
        off = edge_point_errors(np.array([ahead, back]), marks, FRAME.half_diagonal)[0]
        assert (off[1] - off[0]) / (2 * step) == pytest.approx(
            by[0, :, parameter], rel=1e-3, abs=1e-3
        )


def _with_a_line_elsewhere(name: str, metres: float) -> Field:
    """The field as a file has it that puts one of its lines beside where it is painted."""
    changed = []
    for element in FIELD.elements:
        if element.name == name:
            line = element.geometry
            assert isinstance(line, Line)
            (ax, ay, az), (bx, by, bz) = line.start, line.end
            moved = replace(line, start=(ax + metres, ay, az), end=(bx + metres, by, bz))
            element = replace(element, geometry=moved)
        changed.append(element)
    return replace(FIELD, elements=tuple(changed))


@pytest.mark.parametrize("metres", [0.35, -0.35])
def test_a_line_that_lies_beside_its_paint_is_named(metres) -> None:
    picture, moved = draw(TRUE), _with_a_line_elsewhere("Big rect. right main", metres)
    assert not displaced_elements_in_image(picture, VECTOR, marking_points(FIELD), FRAME)
    said = displaced_elements_in_image(picture, VECTOR, marking_points(moved), FRAME)
    assert said.startswith("Big rect. right main lies ")
    assert said.endswith(" px beside its paint")


def test_a_line_that_is_not_painted_lies_beside_nothing() -> None:
    """Somebody forgot it, or it is worn: that is no other place."""
    assert not displaced_elements_in_image(
        draw(TRUE, lines=False), VECTOR, marking_points(FIELD), FRAME
    )


def test_a_narrow_line_between_two_colours_is_found_in_its_middle() -> None:
    """Its brightest place lies towards the lighter of the two."""
    stage, size = stage_of("basketball_fiba"), (960, 540)
    shown = looking_at((0, 21.5, -6.5), (-6, 0, 0), 640, size, kappa=0.03)
    painted, frame = marking_points(stage.field), ImageFrame(size)
    seen = measure_lines(
        draw_scene(stage, shown, size), vector_from_camera(shown, frame), painted, frame, 5
    )
    own = painted.element[seen.expected.rows] == painted.names.index("Court edge bottom")
    off = seen.offsets.px[own & seen.offsets.found]
    assert len(off) > 50
    assert np.median(seen.expected.width_px[own]) < 1
    assert abs(np.median(off)) < 0.25
