"""Shots of a set over time: which frames follow each other, and what is found in drawn ones."""

import json
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.batch.grouping import FrameOrder, ShotFrames, shots_by_name
from procc_annotator.batch.temporal import OverTimeRun, ShotOverTime, require_shots
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.formats.file_source import open_source
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup
from tests.drawn_shots import Look, soccer_shot

SIZE = (960, 540)
SETUP = EvaluationSetup(load_field("soccer"), SIZE)


def write_set(folder: Path, cameras: Sequence[PinholeCamera | None], names: Sequence[str]) -> Path:
    folder.mkdir()
    for name, camera in zip(names, cameras, strict=True):
        if camera is not None:
            (folder / f"camera_{name}.json").write_bytes(write_camera(camera))
    return folder


def write_clicks(folder: Path, cameras: Sequence[PinholeCamera], names: Sequence[str]) -> Path:
    """Annotations that agree with the cameras to the last digit."""
    folder.mkdir()
    for name, camera in zip(names, cameras, strict=True):
        pieces = project_field(camera, SETUP).pieces
        clicks = {
            element: [
                {"x": x / (SIZE[0] - 1), "y": y / (SIZE[1] - 1)}
                for x, y in parts[0][:: max(1, len(parts[0]) // 4)].tolist()
            ]
            for element, parts in pieces.items()
        }
        (folder / f"{name}.json").write_text(json.dumps(clicks))
    return folder


def over_time(
    annotations: Path,
    cameras: Path,
    shots: Sequence[ShotFrames],
    pictures: dict[str, Path] | None = None,
) -> list[ShotOverTime]:
    with open_source(annotations) as source, CameraCollection.open(cameras) as collection:
        return list(OverTimeRun(shots, source, collection, SETUP, 5.0, pictures=pictures))


def shot(frames: int) -> tuple[tuple[PinholeCamera, ...], list[str]]:
    return soccer_shot(frames, size=SIZE).cameras, [f"a_{n:04d}" for n in range(frames)]


def test_a_true_camera_is_steady_and_on_time(tmp_path):
    cameras, names = shot(80)
    annotations = write_clicks(tmp_path / "annotations", cameras[::4], names[::4])
    found = over_time(annotations, write_set(tmp_path / "c", cameras, names), shots_by_name(names))
    (one,) = found
    assert one.shot.name == "a"
    assert one.jitter_px is not None
    assert one.jitter_px < 0.4  # it turns and zooms by fits and starts
    assert one.mean_jac == pytest.approx(1)
    assert one.outage_share == 0
    assert (one.offset.shift, one.offset.is_sure) == (0, True)


def test_a_frame_annotated_as_empty_counts_in_jac_and_says_nothing_of_shifts(tmp_path):
    cameras, names = shot(12)
    annotations = write_clicks(tmp_path / "annotations", cameras[:4], names[:4])
    folder = write_set(tmp_path / "c", cameras, names)
    (before,) = over_time(annotations, folder, shots_by_name(names))
    for name in names[4:12]:
        (annotations / f"{name}.json").write_text("{}")
    (one,) = over_time(annotations, folder, shots_by_name(names))
    assert one.jac.tolist() == [1.0] * 4 + [0.0] * 8
    assert one.mean_jac == pytest.approx(1 / 3)
    assert before.offset is not None
    assert one.offset == before.offset


@pytest.mark.parametrize("late", [1, -2])
def test_cameras_that_are_late_are_told_from_clicks(tmp_path, late):
    cameras, names = shot(40)
    moved = [cameras[min(max(n - late, 0), 39)] for n in range(40)]
    annotations = write_clicks(tmp_path / "annotations", cameras[::3], names[::3])
    (one,) = over_time(annotations, write_set(tmp_path / "c", moved, names), shots_by_name(names))
    assert (one.offset.shift, one.offset.is_sure) == (late, True)
    assert one.offset.cost_px < one.offset.cost_as_is_px


def test_cameras_that_are_late_are_told_from_pictures(tmp_path):
    """No frame is annotated that could say so: only what moves in the pictures."""
    drawn = soccer_shot(12, size=(480, 270), look=Look(people=False))
    names = [f"{n:05d}" for n in range(12)]
    folder = drawn.write_pictures(tmp_path / "pictures")
    pictures = {name: folder / f"{name}.png" for name in names}
    # Faster where it turns and zooms: only so can a shift be seen in the motion alone.
    cameras = soccer_shot(12, size=SIZE).cameras
    late = [cameras[max(n - 1, 0)] for n in range(12)]
    annotations = write_clicks(tmp_path / "annotations", cameras[:1], names[:1])
    (one,) = over_time(
        annotations, write_set(tmp_path / "c", late, names), shots_by_name(names), pictures
    )
    assert one.offset is None
    assert (one.picture_offset.shift, one.picture_offset.is_sure) == (1, True)
    assert not one.errors


def test_frames_without_a_camera_are_outages_and_damage_is_told(tmp_path):
    cameras, names = shot(30)
    given: list[PinholeCamera | None] = list(cameras)
    given[10:13] = [None] * 3
    folder = write_set(tmp_path / "c", given, names)
    (folder / f"camera_{names[20]}.json").write_text("{")
    annotations = write_clicks(tmp_path / "annotations", cameras[::5], names[::5])
    (one,) = over_time(annotations, folder, shots_by_name(names))
    assert [(o.frame, o.length) for o in one.broken.outages] == [(10, 3), (20, 1)]
    assert one.outage_share == pytest.approx(4 / 30)
    assert len(one.errors) == 1


def test_projections_alone_are_no_outage(tmp_path):
    cameras, names = shot(12)
    annotations = write_clicks(tmp_path / "annotations", cameras, names)
    lines = tmp_path / "lines"
    lines.mkdir()
    for name in names:
        (lines / f"camera_{name}.json").write_bytes((annotations / f"{name}.json").read_bytes())
    with open_source(annotations) as source:
        collection = CameraCollection.open(lines, "polylines")
        (one,) = OverTimeRun(shots_by_name(names), source, collection, SETUP, 5.0)
    assert one.outage_share == 0
    assert one.jitter_px is None
    assert one.mean_jac is not None
    assert one.offset is not None


def test_unrelated_frames_are_refused(tmp_path):
    cameras, names = shot(20)
    random = np.random.default_rng(1)
    strewn = [replace(c, pan_rad=c.pan_rad + random.uniform(-0.5, 0.5)) for c in cameras]
    annotations = write_clicks(tmp_path / "annotations", cameras[:2], names[:2])
    found = over_time(annotations, write_set(tmp_path / "c", strewn, names), shots_by_name(names))
    with pytest.raises(UsageError, match="do not follow each other"):
        require_shots(found, "by their names")


def test_no_three_frames_in_a_row(tmp_path):
    cameras, names = shot(4)
    annotations = write_clicks(tmp_path / "annotations", cameras, names)
    folder = write_set(tmp_path / "c", cameras, names)
    with pytest.raises(UsageError, match=r"frames\.csv"):
        over_time(annotations, folder, shots_by_name(["one", "two", "three"]))


def test_two_frames_of_a_shot_with_one_number_are_refused(tmp_path):
    cameras, names = shot(4)
    annotations = write_clicks(tmp_path / "annotations", cameras, names)
    folder = write_set(tmp_path / "c", cameras, names)
    twice = ShotFrames("one", tuple(names), (1, 2, 2, 3))
    told = f"{names[1]} and {names[2]} of the shot one both have the number 2"
    with pytest.raises(UsageError, match=told):
        over_time(annotations, folder, [twice])


def test_names_tell_shots():
    names = ["b2_10", "b2_9", "b2_11", "a-1", "a-2", "a-500", "odd"]
    found = shots_by_name(names)
    assert [(s.name, s.frames) for s in found] == [
        ("a-1", ("a-1", "a-2")),
        ("a-500", ("a-500",)),
        ("b2", ("b2_9", "b2_10", "b2_11")),
    ]
    assert found[2].numbers == (9, 10, 11)
    (plain,) = shots_by_name(["00003", "00001", "00002"])
    assert plain.name == "00001"


def test_a_table_tells_shots(tmp_path):
    file = tmp_path / "frames.csv"
    file.write_text("frame,shot,number\nx,one,7\ny,one,6\nz,two,1\n")
    order = FrameOrder.read(file)
    assert order.shots_of(["x", "y", "z", "else"]) == [
        ShotFrames("one", ("y", "x"), (6, 7)),
        ShotFrames("two", ("z",), (1,)),
    ]
    file.write_text("frame;shot\nb;s\na;s\n")
    assert FrameOrder.read(file).shots_of("ab") == [ShotFrames("s", ("b", "a"), (0, 1))]


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("frame,size\na,1\n", "no columns"),
        ("frame,number\na,-1\n", "no number"),
    ],
)
def test_a_table_that_cannot_be_used(tmp_path, text, problem):
    file = tmp_path / "frames.csv"
    file.write_text(text)
    with pytest.raises(InputError, match=problem):
        FrameOrder.read(file)
