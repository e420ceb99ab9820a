"""Points on chains, spots and curves in any plane: their residuals, and fits to them."""

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.optimization.camera_parameters import vector_from_camera
from procc_annotator.calibration.optimization.observations import (
    ImageFrame,
    build_observations,
    used_point_indices,
)
from procc_annotator.calibration.optimization.residuals import Residuals, pinhole_residuals
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.dimensions import Dimension
from procc_annotator.field.geometry import Arc, Chain, Circle, Geometry, Line, Spot
from procc_annotator.field.model import Element, Field

SIZE = (960, 540)
FRAME = ImageFrame(SIZE)
CAMERA = PinholeCamera(
    np.deg2rad(-8), np.deg2rad(68), np.deg2rad(0.5), (2.0, 26.0, -9.0),
    (900.0, 900.0), (479.5, 269.5), (0.05, 0, 0, 0, 0, 0),
)  # fmt: skip
HALF_TURN = np.pi
BOX = Chain(
    (
        Line((-4.0, -4.0, 0.0), (4.0, -4.0, 0.0)),
        Line((4.0, -4.0, 0.0), (4.0, 4.0, 0.0)),
        Line((4.0, 4.0, 0.0), (-4.0, 4.0, 0.0)),
        Line((-4.0, 4.0, 0.0), (-4.0, -4.0, 0.0)),
    )
)
ROUNDED = Chain(  # a line, half a circle, a line: smooth all along
    (
        Line((-3.0, -5.0, 0.0), (3.0, -5.0, 0.0)),
        Arc((3.0, 0.0, 0.0), 5.0, -HALF_TURN / 2, HALF_TURN / 2),
        Line((3.0, 5.0, 0.0), (-3.0, 5.0, 0.0)),
    )
)
UPRIGHT = Arc((0.0, -6.0, -2.0), 2.0, 0.3, 2.8, (1.0, 0.0, 0.0), (0.0, 0.0, -1.0))
HOOP = Circle((5.0, 0.0, -3.0), 1.5, (0.8, 0.6, 0.0), (0.0, 0.0, 1.0))
SHAPES: dict[str, Geometry] = {
    "Box": BOX, "Rounded": ROUNDED, "Upright": UPRIGHT, "Hoop": HOOP,
    "Spot": Spot((-6.0, 2.0, -1.0)), "Line": Line((-8.0, -7.0, 0.0), (8.0, -7.0, 0.0)),
    "Side": Line((-8.0, -7.0, 0.0), (-8.0, 8.0, 0.0)), "Arc": Arc((0, 0, 0), 7.0, 0.4, 1.4),
}  # fmt: skip
FIELD = Field(
    "court", "Court",
    (Dimension("length", "Length", 16, 16, 16, 16), Dimension("width", "Width", 16, 16, 16, 16)),
    tuple(Element(n, n, "All", "#ffffff", "", shape) for n, shape in SHAPES.items()),
)  # fmt: skip


def dense(shape: Geometry) -> np.ndarray:
    """(n, 3) many places along a geometry."""
    found = []
    for part in shape.parts if isinstance(shape, Chain) else (shape,):
        share = np.linspace(0, 1, 4001)[:, None]
        if isinstance(part, Line):
            found.append(np.array(part.start) + share * np.subtract(part.end, part.start))
        elif isinstance(part, Spot):
            found.append(np.array([part.position]))
        else:
            first, last = (
                (part.start_rad, part.end_rad) if isinstance(part, Arc) else (0.0, 2 * np.pi)
            )
            angle = first + share * (last - first)
            along = np.cos(angle) * np.array(part.ahead) + np.sin(angle) * np.array(part.aside)
            found.append(np.array(part.centre) + part.radius * along)
    return np.concatenate(found)


def clicked(
    names: list[str], rng: np.random.Generator, off_px: float, points: int = 12
) -> FrameAnnotation:
    """Points near places of elements, those of each ending at its ends."""
    polylines = []
    for name in names:
        shown, _ = CAMERA.project(dense(SHAPES[name]))
        inside = shown[((shown > 0) & (shown < SIZE)).all(axis=1)]
        count = 1 if name == "Spot" else points
        chosen = inside[np.linspace(0, len(inside) - 1, count).round().astype(int)]
        px = chosen + rng.normal(0, off_px, chosen.shape)
        polylines.append(Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in px)))
    return FrameAnnotation(tuple(polylines))


def residuals(annotation: FrameAnnotation, vector: np.ndarray | None = None) -> Residuals:
    seen = build_observations(annotation, FIELD, FRAME)
    assert seen is not None
    at = vector_from_camera(CAMERA, FRAME) if vector is None else vector
    return pinhole_residuals(at[None], seen, FRAME.half_diagonal, 11)


@pytest.mark.parametrize("name", SHAPES)
def test_distances_are_those_to_the_nearest_place(name):
    annotation = clicked([name], np.random.default_rng(1), off_px=6.0)
    shown, _ = CAMERA.project(dense(SHAPES[name]))
    given = np.array([(p.u, p.v) for p in annotation.polylines[0].points])
    given = given * (np.array(SIZE) - 1)
    expected = np.hypot(*(given[:, None] - shown[None]).transpose(2, 0, 1)).min(axis=1)
    # The foot is the nearest in the undistorted picture; past a smooth joint only the way across
    # counts.
    np.testing.assert_allclose(residuals(annotation).distances[0], expected, atol=0.15)


def test_a_point_off_a_corner_counts_in_full_and_one_off_a_smooth_joint_across_only():
    corner, _ = CAMERA.project(np.array([[4.0, 4.0, 0.0]]))
    middle, _ = CAMERA.project(np.array([[0.0, 0.0, 0.0]]))
    outwards = (corner - middle)[0] / np.hypot(*(corner - middle)[0])
    point = point_from_px(*(corner[0] + 8 * outwards), SIZE)
    box = residuals(FrameAnnotation((Polyline("Box", (point,)),)))
    assert np.abs(box.values[0, :, 0]).min() > 1
    np.testing.assert_allclose(box.distances, 8, atol=0.1)
    joint, _ = CAMERA.project(np.array([[3.0, 5.0, 0.0]]))
    point = point_from_px(joint[0, 0] + 0.05, joint[0, 1] + 8, SIZE)
    rounded = residuals(FrameAnnotation((Polyline("Rounded", (point,)),)))
    assert rounded.values[0, 1, 0] == 0
    assert 6 < rounded.distances[0, 0] <= 8.1


@pytest.mark.parametrize("name", SHAPES)
def test_the_jacobian_is_that_of_the_residual(name):
    annotation = clicked([name], np.random.default_rng(2), off_px=2.0)
    vector = vector_from_camera(CAMERA, FRAME)
    found = residuals(annotation, vector)
    for i, step in enumerate((1e-6, 1e-6, 1e-6, 1e-4, 1e-4, 1e-4, 1e-6, 1e-6)):
        ahead, behind = vector.copy(), vector.copy()
        ahead[i] += step
        behind[i] -= step
        numeric = residuals(annotation, ahead).values - residuals(annotation, behind).values
        off = np.abs(numeric[0] / (2 * step) - found.derivatives[0, i])
        assert (off < 0.02 * (np.abs(found.derivatives[0, i]).max() + 1e-9)).mean() > 0.9, i


def test_an_element_behind_the_camera_costs_a_constant_without_direction():
    annotation = clicked(list(SHAPES), np.random.default_rng(0), off_px=0.0)
    vector = vector_from_camera(CAMERA, FRAME)
    vector[0] += np.pi
    vector[1] = np.deg2rad(100)
    found = residuals(annotation, vector)
    assert np.isfinite(found.derivatives).all()
    assert (found.distances > 100).all()


def test_a_fit_to_chains_spots_and_curves_finds_the_camera():
    annotation = clicked(list(SHAPES), np.random.default_rng(3), off_px=0.0)
    start = PinholeCamera(
        CAMERA.pan_rad + 0.05, CAMERA.tilt_rad - 0.04, 0.0, (3.0, 24.0, -8.0),
        (950.0, 950.0), (479.5, 269.5), (0.0, 0, 0, 0, 0, 0),
    )  # fmt: skip
    fit = fit_camera(annotation, FIELD, size=SIZE, start=start)
    assert fit.camera is not None, fit.failure
    assert max(e.max_px for e in fit.elements) < 1.0
    ground = dense(BOX)
    shown, _ = CAMERA.project(ground)
    again, _ = fit.camera.project(ground)
    assert np.hypot(*(shown - again).T).max() < 1.0


def test_one_click_on_a_spot_ties_a_camera_twice():
    rng = np.random.default_rng(4)
    spot = clicked(["Spot", "Line", "Side"], rng, off_px=0.0, points=2)
    assert fit_camera(spot, FIELD, size=SIZE).camera is not None
    short = FrameAnnotation(
        tuple(
            Polyline(p.class_name, p.points[:1]) for p in clicked(["Spot", "Line", "Side"], rng, 0)
        )
    )
    fit = fit_camera(short, FIELD, size=SIZE)
    assert fit.failure is not None
    assert "3 points on 3 elements" in fit.failure


@pytest.mark.parametrize("height", [3.05, 3.06, 3.5, 5.0, 9.0])
@pytest.mark.parametrize("off_px", [2.0, 20.0])
def test_distances_to_curves_seen_edge_on_are_true(height, off_px):
    """A rim, a ring on the floor and a rounded corner from the height of the rim and above: clicks
    all around, some of them nearer to the other side."""
    rim, corner = Circle((0.0, 0.0, -3.05), 0.4), Arc((4.0, -2.0, 0.0), 8.5, -np.pi / 2, 0.0)
    shapes: dict[str, Geometry] = {"Rim": rim, "Ring": Circle((0, 0, 0), 1.8), "Corner": corner}
    field = Field(
        "rims", "Rims", (), tuple(Element(n, n, "", "", "", g) for n, g in shapes.items())
    )
    camera = PinholeCamera(
        np.deg2rad(10), np.deg2rad(88), 0.0, (-4.0, 16.0, -height),
        (1800.0, 1800.0), (479.5, 269.5), (0.0, 0, 0, 0, 0, 0),
    )  # fmt: skip
    rng = np.random.default_rng(8)
    polylines, expected = [], []
    for name, shape in shapes.items():
        shown, visible = camera.project(dense(shape))
        assert visible.all()
        exact = shown[rng.integers(0, len(shown), 60)]
        points = exact + rng.normal(0, off_px, exact.shape)
        polylines.append(Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in points)))
        points = points[used_point_indices(polylines[-1], FRAME)]
        expected.append(np.hypot(*(points[:, None] - shown[None]).transpose(2, 0, 1)).min(axis=1))
    seen = build_observations(FrameAnnotation(tuple(polylines)), field, FRAME)
    vector = vector_from_camera(camera, FRAME)
    found = pinhole_residuals(vector[None], seen, FRAME.half_diagonal, 7)
    order = [shapes[e.name] for e in seen.elements]
    assert order == list(shapes.values())
    np.testing.assert_allclose(found.distances[0], np.concatenate(expected), atol=1.0)
