"""Two sources compared frame by frame."""

import json
import pickle
from pathlib import Path
from typing import Any

import pytest

from procc_annotator.batch.comparison import ComparisonRun, worst_frames
from procc_annotator.camera.base import ElementProjections
from procc_annotator.dataset.camera_set import CameraForFrame, CameraSet
from procc_annotator.errors import CameraError, UsageError
from procc_annotator.field.load import load_field

SIZE = (960, 540)
FIELD = load_field("soccer")


def camera(**changes: Any) -> dict[str, Any]:
    return {
        "pan_degrees": 0.0,
        "tilt_degrees": 78.0,
        "roll_degrees": 0.0,
        "position_meters": [0.0, 60.0, -14.0],
        "x_focal_length": 1400.0,
        "y_focal_length": 1400.0,
        "principal_point": [479.5, 269.5],
        "radial_distortion": [0.0] * 6,
        "tangential_distortion": [0.0] * 2,
        "thin_prism_distortion": [0.0] * 4,
    } | changes


def write(folder: Path, cameras: dict[str, dict[str, Any]]) -> CameraSet:
    folder.mkdir()
    for name, content in cameras.items():
        (folder / f"camera_{name}.json").write_text(json.dumps(content))
    return CameraSet.open(folder)


def moved(metres: float) -> dict[str, Any]:
    return camera(position_meters=[metres, 60.0, -14.0])


@pytest.fixture
def sources(tmp_path) -> tuple[CameraSet, CameraSet]:
    a = write(tmp_path / "a", {name: camera() for name in ("1", "2", "3", "4")})
    b = write(
        tmp_path / "b",
        {"1": moved(0.2), "2": moved(3.0), "3": moved(1.0), "5": camera()},
    )
    return a, b


def test_frames_in_common_in_their_order(sources):
    comparison = ComparisonRun(*sources, FIELD, SIZE)
    assert comparison.names == ("1", "2", "3")
    assert (comparison.only_a, comparison.only_b) == (("4",), ("5",))
    assert comparison.neither == ()
    of_dataset = ComparisonRun(*sources, FIELD, SIZE, ["9", "3", "1", "4"])
    assert of_dataset.names == ("3", "1")
    assert (of_dataset.only_a, of_dataset.only_b) == (("4",), ())
    assert of_dataset.neither == ("9",)


def test_the_order_of_two_does_not_matter_where_one_has_a_single_folder(tmp_path):
    for name in ("season/g1", "season/g2", "match/g2"):
        (tmp_path / name).mkdir(parents=True)
        (tmp_path / name / "camera_1.json").write_text(json.dumps(camera()))
    season, match = (CameraSet.open(tmp_path / name) for name in ("season", "match"))
    there = ComparisonRun(season, match, FIELD, SIZE)
    assert (there.names, there.only_a, there.only_b) == (("g2/1",), ("g1/1",), ())
    back = ComparisonRun(match, season, FIELD, SIZE)
    assert (back.names, back.only_a, back.only_b) == (("g2/1",), (), ("g1/1",))
    assert [(frame.median_m, frame.errors) for frame in back] == [(0.0, ())]


def test_figures_of_the_set(sources):
    comparison = ComparisonRun(*sources, FIELD, SIZE)
    frames = list(comparison)
    assert [frame.median_m for frame in frames] == pytest.approx([0.2, 3.0, 1.0])
    assert [frame.within for frame in frames] == [1.0, 0.0, 0.0]
    summary = comparison.summary()
    assert (summary.frames, summary.blank) == (3, ())
    metres = summary.metres
    assert (metres.minimum, metres.median, metres.maximum) == pytest.approx((0.2, 1.0, 3.0))
    areas = [frame.compared_share for frame in frames]
    assert summary.within == pytest.approx(areas[0] / sum(areas))
    assert summary.legacy["projection_m"].mean == pytest.approx(4.2 / 3)
    assert [frame.name for frame in worst_frames(frames, 2)] == ["2", "3"]
    assert [frame.name for frame in worst_frames(frames, None)] == ["2", "3", "1"]


def test_running_twice_counts_once(sources):
    comparison = ComparisonRun(*sources, FIELD, SIZE)
    first = list(comparison)
    again = list(comparison)
    assert [f.median_m for f in first] == [f.median_m for f in again]
    assert comparison.summary().frames == 3


def test_a_worker_that_was_started_elsewhere_finds_relative_paths(sources, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run = ComparisonRun(CameraSet.open(Path("a")), CameraSet.open(Path("b")), FIELD, SIZE)
    sent = pickle.dumps(run.task)
    monkeypatch.chdir("/")
    task = pickle.loads(sent)  # noqa: S301
    (one,), _ = task(["1"])
    assert one.statistics is not None, one.errors
    assert task.a.opened.path == Path("a")  # as it is named to people


def test_frames_without_common_ground_are_blank(tmp_path):
    a = write(tmp_path / "a", {"1": camera(), "2": camera()})
    b = write(tmp_path / "b", {"1": camera(tilt_degrees=130.0), "2": camera()})
    comparison = ComparisonRun(a, b, FIELD, SIZE)
    frames = list(comparison)
    assert frames[0].median_m is None
    assert frames[0].within is None
    summary = comparison.summary()
    assert (summary.frames, summary.blank) == (1, ("1",))
    assert summary.within == 1.0
    assert [frame.name for frame in worst_frames(frames, None)] == ["2"]


def test_a_damaged_camera_is_an_error_of_its_frame(tmp_path):
    a = write(tmp_path / "a", {"1": camera(), "2": camera()})
    b = write(tmp_path / "b", {"1": camera(x_focal_length="long"), "2": camera()})
    comparison = ComparisonRun(a, b, FIELD, SIZE)
    frames = list(comparison)
    assert "camera_1.json" in frames[0].errors[0]
    assert frames[0].statistics is None
    assert frames[1].errors == ()
    assert comparison.summary().blank == ()
    with pytest.raises(CameraError, match=r"camera_1\.json"):
        comparison.cameras("1")


def test_a_source_of_projections_alone_is_refused_by_name(sources, monkeypatch):
    a, b = sources

    def shared(self: CameraSet, name: str, size: tuple[int, int]) -> CameraForFrame:
        return CameraForFrame(ElementProjections({}), "projections", None)

    monkeypatch.setattr(CameraSet, "camera", shared)
    with pytest.raises(UsageError, match=r"^a shares only projections, there is no ground"):
        list(ComparisonRun(a, b, FIELD, SIZE))


def test_nothing_in_common_says_how_frames_are_named(sources):
    with pytest.raises(UsageError, match="the frames of the dataset like 'x1'"):
        ComparisonRun(*sources, FIELD, SIZE, ["x1"])
    with pytest.raises(UsageError, match="too small"):
        ComparisonRun(*sources, FIELD, (1, 540))
