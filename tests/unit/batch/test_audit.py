"""What is kept of a judged frame, and the figures plots make of it, against the metric itself."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.batch import audit as figures
from procc_annotator.batch.audit import TAU_GRID, FrameAudit, Pose, audit_frame
from procc_annotator.batch.frame_sums import mean_band
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.field.landmarks import element_titles, with_landmarks
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Landmark
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.metrics.measurement import Labelling, Measurement, measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

FIELD = load_field("soccer")
SETUP = EvaluationSetup(FIELD)
SIZE = SETUP.size


def audits_of(
    annotations: Path, cameras: Path, tau: float = 5.0
) -> list[tuple[FrameAudit, Measurement]]:
    """Every frame of a set that has both, audited, with what it was audited from."""
    loaded = CameraSet.open(cameras)
    found = []
    for path in sorted(annotations.glob("*.json")):
        camera = loaded.camera(path.stem, SIZE)
        annotation = read_annotation(path.read_bytes(), path=str(path), field=FIELD)
        if camera is not None and annotation.annotated:
            measured = measure(annotation, camera.camera, SETUP)
            audit = audit_frame(path.stem, camera.camera, camera.model, measured, tau)
            found.append((audit, measured))
    return found


def better_labelling(measured: Measurement, tau: float) -> Labelling:
    """The labelling with the higher JaC; the labels as they are when both are alike."""
    plain = measured.plain
    own = sum(d is not None and (d < tau).all() for d in plain.distances) / plain.element_count
    judged = score(measured, tau)
    return judged.labelling if judged.jac > own + 1e-12 else plain


def made_up(
    residuals: list[tuple[float, float]],
    at: list[tuple[float, float]] | None = None,
    rows: list[int] | None = None,
    frame: str = "a",
    pose: Pose | None = None,
) -> FrameAudit:
    count = len(residuals)
    return FrameAudit(
        frame,
        "made up",
        np.linspace(0, 1, len(TAU_GRID)).astype(np.float32),
        np.array(rows if rows is not None else [0] * count, dtype=np.int16),
        np.array(at if at is not None else [(0, 0)] * count, dtype=np.float32).reshape(-1, 2),
        np.array(residuals, dtype=np.float32).reshape(-1, 2),
        pose,
    )


@pytest.mark.parametrize("source", ["bad", "true", "pinhole"])
def test_audits_of_the_sample_say_what_the_metric_says(sample_data, source):
    pairs = audits_of(sample_data, sample_data / "cameras" / source)
    assert pairs
    for audit, measured in pairs:
        for tau in (0.5, 2.0, 5.0, 29.9):
            assert audit.jac_at(tau) == pytest.approx(score(measured, tau).jac, abs=1e-6)
        labelling = better_labelling(measured, 5.0)
        assert audit.errors_px == pytest.approx(labelling.all_distances, abs=2e-3)
        assert len(audit.class_rows) == len(audit.points_px) == len(audit.residuals_px)


def test_where_neither_labelling_passes_residuals_are_those_of_the_labels_as_they_are(sample_data):
    turned = 0
    for audit, measured in audits_of(sample_data, sample_data / "cameras" / "bad", tau=1e-6):
        turned += score(measured, 1e-6).mirrored
        assert audit.errors_px == pytest.approx(measured.plain.all_distances, abs=2e-3)
    assert turned  # the official evaluation takes the mirrored labels there


def test_points_belong_to_the_class_they_were_clicked_for(sample_data):
    for audit, measured in audits_of(sample_data, sample_data / "cameras" / "bad"):
        labelling = better_labelling(measured, 5.0)
        worst = {
            FIELD.index[name]: float(distances.max())
            for name, distances in zip(labelling.annotated_names, labelling.distances, strict=True)
            if distances is not None
        }
        assert {
            row: pytest.approx(audit.errors_px[audit.class_rows == row].max(), abs=2e-3)
            for row in set(audit.class_rows.tolist())
        } == worst


def test_points_keep_their_class_where_something_moves():
    marks = (
        Landmark("ball", moving=True),
        Landmark("ball", position=(1.0, 2.0, -0.1), instant="t1"),
        Landmark("flag", title="The flag", position=(0.0, 0.0, -1.5)),
    )
    field = with_landmarks(FIELD, marks, None, {"with ball": "t1"})
    titles = list(element_titles(field).values())
    camera = PinholeCamera(0.0, math.radians(78), 0.0, (0, 60, -14), (1400, 1400), (479.5, 269.5))
    middle = Point(0.5, 0.5)
    clicked = FrameAnnotation((Polyline("flag", (middle,)), Polyline("ball", (middle,))))
    for frame, seen in (("with ball", ["The flag", "ball"]), ("without", ["The flag"])):
        setup = EvaluationSetup(field, SIZE, "procc").of_frame(frame)
        audit = audit_frame(frame, camera, "pinhole", measure(clicked, camera, setup), 5.0)
        assert [titles[row] for row in audit.class_rows.tolist()] == seen


def test_a_residual_leads_from_the_click_onto_the_projection(sample_data):
    for audit, measured in audits_of(sample_data, sample_data / "cameras" / "pinhole"):
        feet = (audit.points_px + audit.residuals_px).astype(float)
        again = measured.projected.polylines.segments.distances(
            feet, audit.class_rows.astype(np.intp)
        )
        assert again == pytest.approx(0.0, abs=1e-3)


def test_the_pose_is_the_cameras_own(sample_data):
    cameras = CameraSet.open(sample_data / "cameras" / "true")
    for audit, _ in audits_of(sample_data, sample_data / "cameras" / "true"):
        camera = cameras.camera(audit.frame, SIZE).camera
        assert math.radians(audit.pose.pan_deg) == pytest.approx(camera.pan_rad)
        assert audit.pose.position_world == camera.position_world
    for audit, _ in audits_of(sample_data, sample_data / "cameras" / "homography"):
        assert audit.pose is None


def test_the_mean_curve_of_real_cameras_is_the_official_jac(shared_data):
    wc14 = shared_data / "wc14"
    pairs = audits_of(wc14 / "annotations", wc14 / "cameras_pnlcalib")
    curve = figures.mean_curve([audit for audit, _ in pairs])
    for tau, official in ((2.0, 38.91), (5.0, 84.94), (10.0, 93.79), (20.0, 96.11)):
        column = int(np.argmin(np.abs(TAU_GRID - tau)))
        assert 100 * curve[column] == pytest.approx(official, abs=0.01)


class TestHistogram:
    def test_every_point_is_in_one_bar(self):
        rng = np.random.default_rng(1)
        errors = [rng.exponential(2.0, 5000), rng.exponential(5.0, 300), np.empty(0)]
        found = figures.histogram(errors)
        assert [int(c.sum()) for c in found.counts] == [5000, 300, 0]
        assert found.open_ended
        inner = np.histogram(errors[0], found.edges)[0]
        assert found.counts[0][:-1].tolist() == inner[:-1].tolist()
        assert found.counts[0][-1] == (errors[0] >= found.edges[-2]).sum()

    def test_few_errors_are_shown_in_full(self):
        found = figures.histogram([np.array([0.2, 0.2, 9.9])])
        assert not found.open_ended
        assert found.counts[0].sum() == 3
        assert found.edges[-1] > 9.9

    def test_an_error_on_an_edge_is_in_the_bar_above(self):
        found = figures.histogram([np.array([0.0, 0.5, 1.0, 19.0])])
        width = found.edges[1]
        assert found.counts[0][round(0.5 / width)] == 1
        assert found.counts[0][round(1.0 / width)] == 1


def test_points_without_a_distance_are_left_out_and_counted():
    audit = made_up([(3, 4), (math.nan, math.nan), (0, 1)], rows=[2, 2, 5])
    found = figures.gather([audit])
    assert found.errors_px.tolist() == [5, 1]
    assert found.undefined == 1
    only = figures.gather([audit, made_up([(6, 8)], rows=[5], frame="b")], class_row=5)
    assert only.errors_px.tolist() == [1, 10]
    assert [only.names[i] for i in only.frames] == ["a", "b"]
    assert only.undefined == 0


class TestRadius:
    def test_centre_and_corners(self):
        corners = np.array([(0, 0), (959, 0), (959, 539), (479.5, 269.5)])
        assert figures.radius_of(corners, (960, 540)) == pytest.approx([1, 1, 1, 0])

    def test_the_median_rises_where_distortion_is_not_modelled(self):
        rng = np.random.default_rng(2)
        at = rng.uniform((0, 0), (959, 539), (4000, 2))
        radius = figures.radius_of(at, (960, 540))
        errors = 8 * radius**3
        residuals = np.stack([errors, np.zeros_like(errors)], axis=1)
        points = figures.gather([made_up(list(map(tuple, residuals)), list(map(tuple, at)))])
        found = figures.radial_errors(points, (960, 540))
        assert (np.diff(found.medians) > 0).all()
        assert found.medians == pytest.approx(8 * found.centres**3, abs=0.35)


class TestResiduals:
    def test_a_bias_is_one_direction_in_every_cell(self):
        rng = np.random.default_rng(3)
        at = rng.uniform((0, 0), (959, 539), (6000, 2))
        residuals = rng.normal(0, 1.0, at.shape) + np.array([2.0, -1.0])
        points = figures.gather([made_up(list(map(tuple, residuals)), list(map(tuple, at)))])
        assert figures.bias(points) == pytest.approx((2.0, -1.0), abs=0.1)
        cells = figures.cell_arrows(points, (960, 540))
        assert len(cells.counts) == 16 * 9
        assert cells.counts.sum() == 6000
        assert cells.vectors_px == pytest.approx(np.tile((2.0, -1.0), (144, 1)), abs=0.9)
        assert figures.bias(figures.gather([])) is None

    def test_a_cell_lies_where_its_points_are(self):
        at = [(10.0, 500.0)] * 5
        points = figures.gather([made_up([(1, 0)] * 5, at)])
        cells = figures.cell_arrows(points, (960, 540))
        assert cells.at_px.tolist() == [[29.5, 509.5]]
        assert cells.vectors_px.tolist() == [[1, 0]]
        assert len(figures.cell_arrows(figures.gather([made_up([(1, 0)] * 4)]), SIZE).counts) == 0


def steady(pan: float, x: float = 0.0) -> Pose:
    return Pose(pan, 75.0, 0.0, 1500.0, (x, 60.0, -14.0))


class TestPoses:
    def test_a_jump_stands_out_and_a_steady_pan_does_not(self):
        rng = np.random.default_rng(4)
        pans = np.arange(100) * 0.7 + rng.normal(0, 0.05, 100)
        pans[60:] += 9.0
        audits = {f"{i}": made_up([], frame=f"{i}", pose=steady(p)) for i, p in enumerate(pans)}
        found = figures.poses([f"{i}" for i in range(100)], audits)
        assert found.jumps[:, 0].nonzero()[0].tolist() == [60]
        assert not found.jumps[:, 1:].any()
        assert found.values[0, 6] == 14.0  # height, up

    def test_gaps_stay_gaps_and_pan_goes_through_180(self):
        pans = {"a": 179.0, "c": -179.5, "d": -178.0}
        audits = {n: made_up([], frame=n, pose=steady(p)) for n, p in pans.items()}
        audits["e"] = made_up([], frame="e")
        found = figures.poses(["a", "b", "c", "d", "e"], audits)
        assert found.values[[0, 2, 3], 0] == pytest.approx([179.0, 180.5, 182.0])
        assert np.isnan(found.values[[1, 4], 0]).all()
        assert (found.with_pose, found.without) == (3, 1)
        assert not found.jumps.any()


class TestEnvelope:
    def test_nothing_is_lost_of_what_fits(self):
        values = np.array([1.0, np.nan, 3.0])
        at, shown = figures.envelope(values, -5, 99, 100)
        assert at.tolist() == [0, 1, 2]
        assert np.array_equal(shown, values, equal_nan=True)

    def test_the_lowest_of_many_is_still_there(self):
        values = np.full(20_000, 0.9)
        values[12_345] = 0.1
        values[5000:6000] = np.nan
        at, shown = figures.envelope(values, 0, 20_000, 1000)
        assert len(shown) <= 1002
        lowest = int(np.nanargmin(shown))
        assert shown[lowest] == 0.1
        assert abs(at[lowest] - 12_345) <= 40
        assert np.isnan(shown[(at > 5040) & (at < 5960)]).all()
        assert np.isfinite(shown[at < 4960]).all()


def test_a_timeline_has_gaps_where_there_is_no_score():
    line = figures.timeline(["a", "b"], {"b": made_up([], frame="b")}, 30.0)
    assert np.isnan(line[0])
    assert line[1] == 1.0


def test_points_without_a_distance_have_no_residual(sample_data):
    (measured,) = [
        m for a, m in audits_of(sample_data, sample_data / "cameras" / "true") if a.frame == "00002"
    ]
    true = CameraSet.open(sample_data / "cameras" / "true").camera("00002", SIZE)

    class Rounded:
        """Neighbouring positions fall together, which leaves segments without a length."""

        def project(self, world):
            pixels, visible = true.camera.project(world)
            return np.round(pixels), visible

    path = sample_data / "00002.json"
    annotation = read_annotation(path.read_bytes(), path=str(path), field=FIELD)
    measured = measure(annotation, Rounded(), SETUP)
    undefined = np.isnan(measured.plain.all_distances)
    assert undefined.any()
    audit = audit_frame("00002", Rounded(), "rounded", measured, 5.0)
    assert np.isnan(audit.errors_px).tolist() == undefined.tolist()
    assert figures.gather([audit]).undefined == undefined.sum()


def test_turned_labels_count_for_the_classes_that_their_score_is_of(sample_data):
    path = sample_data / "00002.json"
    plain = read_annotation(path.read_bytes(), path=str(path), field=FIELD)
    turn = FIELD.symmetries[0]
    turned = FrameAnnotation(
        tuple(replace(p, class_name=turn.name_of(p.class_name)) for p in plain.polylines)
    )
    found = CameraSet.open(sample_data / "cameras" / "true").camera("00002", SIZE)
    as_meant, as_labelled = (
        figures.gather(
            [audit_frame("00002", found.camera, "P", measure(one, found.camera, SETUP), 5.0)]
        )
        for one in (plain, turned)
    )
    assert as_labelled.counted_rows.tolist() == as_meant.counted_rows.tolist()
    assert as_labelled.class_rows.tolist() != as_meant.class_rows.tolist()


def test_a_band_stays_within_what_a_score_can_be():
    audits = {
        name: replace(
            made_up([], frame=name), jac=np.where(5 + i < TAU_GRID, 1, 0).astype(np.float32)
        )
        for i, name in enumerate("abcdef")
    }
    band = mean_band(audits, tuple(audits)).band
    assert band.low.min() == 0
    assert band.high.max() == 1
