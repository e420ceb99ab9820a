"""Length and width of a field are found from many frames, with an honest standard deviation."""

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.joint.field_dimensions import (
    GeometryDerivatives,
    StadiumFit,
    fit_dimensions,
    fittable_dimensions,
    residuals_by_dimensions,
)
from procc_annotator.calibration.optimization.camera_parameters import FREE_PARAMETERS
from procc_annotator.calibration.optimization.observations import ImageFrame, build_observations
from procc_annotator.calibration.optimization.residuals import pinhole_residuals
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import UsageError
from procc_annotator.field.load import load_field, with_dimensions
from procc_annotator.field.model import Field
from tests.bench.sports.views import Views

SIZE = (960, 540)
TRUE = {"length": 101.3, "width": 66.2}


def camera(rng: np.random.Generator, pan: float) -> PinholeCamera:
    position = (float(rng.normal(0, 2)), float(rng.normal(70, 3)), float(rng.normal(-15, 1)))
    away = np.hypot(position[1], 60 * np.tan(np.deg2rad(pan)))
    focal = float(rng.uniform(1100, 1700))
    return PinholeCamera(
        np.deg2rad(pan), float(np.arctan2(away, -position[2])), 0.0, position, (focal, focal),
        (479.5, 269.5), (0.04 * (focal / 550) ** 2, 0, 0, 0, 0, 0),
    )  # fmt: skip


def make_frames(views_of, field: Field, pans, seed: int) -> dict[str, FrameAnnotation]:
    rng = np.random.default_rng(seed)
    views = views_of(field)
    return {f"f{i}": views.clicks(camera(rng, pan), rng) for i, pan in enumerate(pans)}


def fitted(frames: dict[str, FrameAnnotation], field: Field, **more) -> StadiumFit:
    alone = {name: fit_camera(a, field, model="R", size=SIZE) for name, a in frames.items()}
    return fit_dimensions(frames, alone, field, **more)


@pytest.fixture(scope="module")
def views_of(views):
    return type(views)


@pytest.fixture(scope="module", params=[8, pytest.param(30, marks=pytest.mark.soak)])
def stadium(views_of, field, request) -> StadiumFit:
    pans = np.linspace(-30, 30, request.param)
    return fitted(make_frames(views_of, load_field("soccer", **TRUE), pans, 7), field)


def test_the_dimensions_of_a_made_up_stadium_are_found(stadium, request):
    for found in stadium.dimensions:
        off = abs(found.dimension.value - TRUE[found.dimension.name])
        assert off < 0.3
        assert off < 2 * found.sd_m
        assert found.sd_m < 0.3
        assert found.is_determined
        assert not found.remark
        assert found.dimension.nominal in (105.0, 68.0)
    assert stadium.frames == request.node.callspec.params["stadium"]
    assert stadium.values.keys() == TRUE.keys()


def test_a_set_that_never_sees_an_end_does_not_tell_the_length(views_of, field):
    frames = make_frames(views_of, field, [-2.0, 0.0, 1.0, 3.0], 3)
    middle = {"Middle line", "Circle central", "Side line top"}
    frames = {
        name: FrameAnnotation(tuple(p for p in a if p.class_name in middle))
        for name, a in frames.items()
    }
    length, width = fitted(frames, field).dimensions
    assert not length.is_determined
    assert length.frames == 0
    assert "length is not determined" in length.remark
    assert "no frame shows what moves with it" in length.remark
    assert width.frames > 0


def test_dimensions_of_a_court_are_found_as_well():
    true = {"length": 38.4, "width": 18.7}
    views = Views(load_field("futsal", **true))
    rng = np.random.default_rng(8)
    frames = {f"f{i}": views.random(rng).annotation for i in range(4)}
    for found in fitted(frames, load_field("futsal")).dimensions:
        assert found.is_determined
        off = abs(found.dimension.value - true[found.dimension.name])
        assert off < max(3 * found.sd_m, 0.1)


def test_a_net_stands_as_high_as_the_frames_show_it():
    """The rules fix a volleyball court on the ground, but not its net."""
    views = Views(load_field("volleyball", net_height=2.24))
    rng = np.random.default_rng(9)
    frames = {f"f{i}": views.random(rng).annotation for i in range(5)}
    field = load_field("volleyball")
    assert "net_height" in fittable_dimensions(field)
    found = fitted(frames, field, names=["net_height"]).dimensions[0]
    assert found.is_determined
    assert found.dimension.value == pytest.approx(2.24, abs=max(3 * found.sd_m, 0.01))


def test_only_what_is_asked_for_is_fitted(views_of, field):
    frames = make_frames(views_of, load_field("soccer", width=66.2), [-25.0, 0.0, 25.0], 5)
    found = fitted(frames, field, names=["width"])
    assert [d.dimension.name for d in found.dimensions] == ["width"]
    assert found.values["width"] == pytest.approx(66.2, abs=3 * found.dimensions[0].sd_m)


def test_values_stay_within_the_rules(views_of, tmp_path):
    """A field wider than its rules allow is found at their limit, and that is told."""
    text = load_field("soccer").source.read_text().replace("minimum = 45.0, maximum = 90.0", "R")
    narrow, wide = tmp_path / "narrow.toml", tmp_path / "wide.toml"
    narrow.write_text(text.replace("R }", "minimum = 66.0, maximum = 68.0 }"))
    wide.write_text(text.replace("R }", "minimum = 45.0, maximum = 90.0 }"))
    frames = make_frames(views_of, load_field(wide, width=70.0), [-25.0, 0.0, 25.0], 6)
    found = fitted(frames, load_field(narrow), names=["width"]).dimensions[0]
    assert found.dimension.value == 68.0
    assert found.is_at_limit
    assert "limit of the rules" in found.remark


def test_what_cannot_be_fitted_is_refused(field):
    assert fittable_dimensions(field) == ("length", "width")
    with pytest.raises(UsageError, match=r"'goal_width' cannot be fitted.*length, width"):
        fittable_dimensions(field, ["goal_width"])
    with pytest.raises(UsageError, match="the rules fix all dimensions"):
        fittable_dimensions(load_field("handball"))
    with pytest.raises(UsageError, match="no frame has a camera"):
        fit_dimensions({}, {}, field)


def test_derivatives_by_dimensions_agree_with_differences(views, field):
    rng = np.random.default_rng(2)
    view = views.main(rng, noise_px=3.0)
    frame = ImageFrame(SIZE)
    fit = fit_camera(view.annotation, field, model="R", size=SIZE)
    vector = fit.vector
    step = 1e-3

    def at(length: float, width: float) -> Field:
        return with_dimensions(field, {"length": length, "width": width})

    seen = build_observations(view.annotation, field, frame)
    around = [
        (at(105 - step, 68), at(105 + step, 68), 2 * step),
        (at(105, 68 - step), at(105, 68 + step), 2 * step),
    ]
    rates = GeometryDerivatives.of(seen, around)
    free, half = FREE_PARAMETERS["R"], frame.half_diagonal
    own = residuals_by_dimensions(vector, seen, half, free, rates)
    plain = pinhole_residuals(vector[None], seen, half, free)
    assert own.values == pytest.approx(plain.values)
    assert own.derivatives[:, 2:] == pytest.approx(plain.derivatives)
    for row, (less, more, apart) in enumerate(around):
        low = pinhole_residuals(vector[None], seen.on(less), half, free).distances[0]
        high = pinhole_residuals(vector[None], seen.on(more), half, free).distances[0]
        slope = (own.derivatives[0, row] * own.values[0]).sum(axis=0) / own.distances[0]
        assert (high - low) / apart == pytest.approx(slope, abs=2e-3)
    moved = np.abs(own.derivatives[0, :2]).max(axis=(1, 2))
    assert (moved > 1).all()  # px a metre


def test_the_dimensions_do_not_depend_on_those_the_search_starts_from(views_of, field):
    """Elements far off on a wrong field are no mistakes: they are heard once it is right."""
    frames = make_frames(
        views_of, load_field("soccer", length=116, width=62), [-25, -10, 10, 25], 9
    )
    found = [fitted(frames, start) for start in (field, load_field("soccer", length=95, width=75))]
    first, second = (f.dimensions for f in found)
    for one, other, metres in zip(first, second, (116.0, 62.0), strict=True):
        assert one.dimension.value == pytest.approx(other.dimension.value, abs=0.1 * one.sd_m)
        assert one.dimension.value == pytest.approx(metres, abs=3 * one.sd_m)
    assert found[0].left_out == 0


def test_frames_of_two_stadiums_are_told(views_of, field):
    pans = [-25, -12, 12, 25]
    mixed = {
        f"{size}{name}": annotation
        for size, seed in ((100, 3), (112, 4))
        for name, annotation in make_frames(
            views_of, load_field("soccer", length=size, width=size - 36), pans, seed
        ).items()
    }
    assert any("several stadiums" in remark for remark in fitted(mixed, field).remarks)
