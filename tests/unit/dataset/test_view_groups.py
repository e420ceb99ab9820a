"""Frames of one instant from several cameras."""

import math
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.calibration.triangulation import Triangulation
from procc_annotator.camera.base import Camera
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.landmarks.clicks import (
    ClickedLandmark,
    LocatedLandmark,
    why_kept,
    with_positions,
)
from procc_annotator.dataset.landmarks.dataset_landmarks import (
    parse_position,
    parse_surveyed,
    unknown_frames_message,
    with_surveyed_position,
)
from procc_annotator.dataset.landmarks.triangulation import (
    DatasetPaths,
    TriangulationSettings,
    fitted_views,
    locate_in_dataset,
)
from procc_annotator.dataset.landmarks.view_groups import (
    ViewAssignment,
    ViewGroups,
    groups_by_name,
    load_views,
    replace_views,
    save_views,
    suggested_pattern,
    views_by_name,
)
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.load import field_for_frame, load_field, with_stadiums
from procc_annotator.field.model import Landmark, Stadiums
from procc_annotator.formats.frame_names import FrameTable
from procc_annotator.formats.landmark_file import LandmarkFile
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

GROUPS = ViewGroups(
    FrameTable(
        {
            "17_left": ViewAssignment("17", "left"),
            "17_right": ViewAssignment("17", "right"),
            "9_left": ViewAssignment("9", "left"),
        }
    )
)


def test_a_file_tells_the_groups(tmp_path):
    path = tmp_path / "views.csv"
    path.write_text("frame;instant;view;note\na2;t1;wide;x\na10;t1;close;\nb;t2;wide;\nc;;;\n")
    groups = load_views(path)
    assert groups.groups == {"t1": ("a2", "a10"), "t2": ("b",)}
    assert groups.others("a10") == ("a2",)
    assert groups.view_of("a10") == "close"
    assert groups.others("c") == ()
    assert groups.instant_of("c") is None
    assert groups.others("not there") == ()


def test_views_without_a_name_may_be_any_camera(tmp_path):
    path = tmp_path / "views.csv"
    path.write_text("frame,instant,view\na,1,\nb,1,\nc,2,left\nd,,left\ne,,left\n")
    assert load_views(path).groups == {"1": ("a", "b"), "2": ("c",)}


def test_rows_of_frames_that_there_are_not_are_named(tmp_path):
    path = tmp_path / "views.csv"
    path.write_text("frame,instant\n17_left,17\n17_rigth,17\n99,\n")
    assert load_views(path).unknown_rows(["17_left", "17_right"]) == (
        "views.csv: line 3: there is neither a picture nor an annotation of '17_rigth'; did you"
        " mean '17_right'?",
        "views.csv: line 4: there is neither a picture nor an annotation of '99'",
    )
    assert load_views(path).unknown_rows(["17_left", "17_rigth", "99"]) == ()


def test_groups_are_written_as_they_are_read(tmp_path):
    path = tmp_path / "views.csv"
    strange = ViewGroups(FrameTable({**GROUPS.frames, "=1+1": ViewAssignment("-3", 'a "b", c')}))
    save_views(path, strange)
    assert load_views(path) == strange
    assert "\n=1" not in path.read_text()


def test_a_name_that_is_no_utf_8_does_not_keep_the_others_from_being_written(tmp_path):
    file = tmp_path / "views.csv"
    save_views(file, ViewGroups(FrameTable({**GROUPS.frames, "caf\udce9": ViewAssignment("18")})))
    assert GROUPS.frames.items() < load_views(file).frames.items()


def test_a_dataset_without_the_file_has_no_groups(tmp_path):
    assert load_views(tmp_path / "views.csv") == ViewGroups()


def test_a_camera_takes_one_frame_at_an_instant(tmp_path):
    path = tmp_path / "views.csv"
    path.write_text("frame,instant,view\na,1,left\nb,1,right\nc,1,left\n")
    with pytest.raises(InputError, match="line 4: the view 'left' at instant '1' again, after li"):
        load_views(path)


def test_another_file_is_replaced_only_where_it_is_known(tmp_path):
    path = tmp_path / "views.csv"
    assert replace_views(path, GROUPS) is None
    assert load_views(path) == GROUPS
    same = b"frame;instant;view;note\n9_left;9;left;x\n17_right;17;right;\n17_left;17;left;\n"
    path.write_bytes(same)
    assert replace_views(path, GROUPS) is None
    assert path.read_bytes() == same  # it says so already, and more
    for other in (b"frame,instant\n17_left,1\n", b"damaged"):
        path.write_bytes(other)
        assert replace_views(path, GROUPS, same) == other
        assert path.read_bytes() == other
        assert replace_views(path, GROUPS, other) is None
        assert load_views(path) == GROUPS


def test_only_so_many_strange_rows_are_told():
    lines = {"a": 2, "b": 3, "c": 4}
    groups = ViewGroups(FrameTable(), "views.csv", lines)
    assert groups.unknown_frames({"b"}) == ("a", "c")
    assert [row.split(":")[1] for row in groups.unknown_rows(["b"], 1)] == [" line 2"]


def test_frames_are_found_however_they_are_spelled(tmp_path):
    """Letters composed otherwise, as a Mac's file system has them, and folders of pictures."""
    path = tmp_path / "views.csv"
    path.write_text("frame,instant,view\ncaf\u00e9/1,7,left\ncaf\u00e9/2,7,right\n", "utf-8")
    groups = load_views(path)
    there = "cafe\u0301/img1/1"
    assert groups.instant_of(there) == "7"
    assert groups.view_of(there) == "left"
    assert groups.others(there) == ("caf\u00e9/2",)
    assert groups.unknown_frames([there, "cafe\u0301/img1/2"]) == ()
    assert groups.unknown_rows([there])[0].startswith("views.csv: line 3: ")


def test_annotations_of_a_tree_may_have_no_picture(tmp_path):
    for game in ("game1", "game2"):
        (tmp_path / game / "annotations").mkdir(parents=True)
        (tmp_path / game / "1.png").touch()
    (tmp_path / "game2/annotations/5.json").write_text("{}")
    rows = "game2/img1/5,7\ngame2/5,7\ngame2/6,7\n"
    (tmp_path / "views.csv").write_text(f"frame,instant\ngame1/1,7\n{rows}")
    groups = load_views(tmp_path / "views.csv")
    said = unknown_frames_message(groups, Workspace.open(tmp_path, load_field("soccer")))
    assert said.startswith("views.csv: line 5: there is neither a picture nor an annotation of")


# Frames of one instant told by their names: a pattern, and one that fits.


@pytest.mark.parametrize(
    ("pattern", "names", "expected"),
    [
        ("{instant}_{view}", ("17_left_high", "17_right"), ("17", "left_high")),
        ("{view}_{instant}", ("left_high_17", "right_17"), ("17", "left_high")),
        ("{view}{instant}", ("left17", "right17"), ("17", "left")),
        ("game.{view}@{instant}s", ("game.left@1.5s", "game.r@1.5s"), ("1.5", "left")),
        (r"(?P<view>[a-z]+)-(?P<instant>\d+)-.*", ("left-17-x", "right-17-y"), ("17", "left")),
        (r"(?P<instant>\d+).", ("17a", "17b"), ("17", "")),
    ],
)
def test_names_tell_the_groups(pattern, names, expected):
    groups = groups_by_name([*names, "another"], pattern)
    assert groups.frames[names[0]] == ViewAssignment(*expected)
    assert groups.others(names[0]) == (names[1],)
    assert "another" not in groups.frames


@pytest.mark.parametrize(
    ("pattern", "words"),
    [
        ("{view}", "names no instant"),
        ("{instant}_{camera}", "has {camera}"),
        ("{instant}_{instant}", "once each"),
        ("(?P<instant>", "cannot be understood"),
        ("{instant}-{view}", "no name fits it"),
        ("{instant}_left", "1 of 2 names fit it"),
        (r"(?P<instant>\d+)(?P<view>_).*", "takes 17_left and 17_right both for the view '_'"),
    ],
)
def test_a_pattern_that_groups_nothing_is_refused(pattern, words):
    with pytest.raises(UsageError, match=words):
        groups_by_name(["17_left", "17_right"], pattern)


def test_a_pattern_tells_whom_it_leaves_alone_and_what_is_wrong():
    found = views_by_name(["17_left", "b", "17_right", "a"], "{instant}_{view}")
    assert (found.alone, found.problem) == (("a", "b"), "")
    assert found.groups.groups == {"17": ("17_left", "17_right")}
    twice = views_by_name(["17_left", "17_right"], r"(?P<instant>\d+)(?P<view>_).*")
    assert "both for the view '_'" in twice.problem
    assert len(twice.groups.frames) == 2  # to be looked at all the same


@pytest.mark.parametrize(
    ("names", "pattern"),
    [
        (["17_left", "17_right", "17_close"], "{instant}_{view}"),
        (["17-cam1", "17-cam2", "18-cam1", "18-cam2"], "{instant}-{view}"),
        (["cam1_17", "cam2_17", "cam1_18", "cam2_18"], "{view}_{instant}"),
        (["left_0001", "right_0001", "left_0002", "right_0002", "left_0003"], "{view}_{instant}"),
        (
            ["final_1_left", "final_1_right", "final_2_left", "final_2_right"],
            "final_{instant}_{view}",
        ),
        (["17L", "17R", "18L", "18R", "poster"], "{instant}{view}"),
        (["left17", "right17", "left18", "right18"], "{view}{instant}"),
        (
            ["05-01_22_a", "05-01_22_b", "05-02_23_a", "05-02_23_b"],
            "(?P<instant>.+)_(?P<view>[^_]+)",
        ),
        ([f"{i:05d}" for i in range(30)], ""),
        ([f"frame_{i}" for i in range(30)], ""),
        ([f"cut{i}_{j:04d}" for i in range(3) for j in range(i * 20, i * 20 + 20)], ""),
        (
            ["{a}_1_left", "{a}_1_right", "{a}_2_left", "{a}_2_right"],
            "(?P<instant>.+)_(?P<view>[^_]+)",
        ),
        (["one"], ""),
        ([], ""),
    ],
)
def test_a_pattern_that_fits_is_suggested(names, pattern):
    assert suggested_pattern(names) == pattern
    if pattern:
        assert not views_by_name(names, pattern).problem


# What triangulated positions may be written over: never what somebody surveyed.

PLACE = (1.0, 2.0, -3.0)


def found(name: str, instant: str | None = None) -> LocatedLandmark:
    return LocatedLandmark(ClickedLandmark(name, instant), Triangulation(position=PLACE))


@pytest.mark.parametrize(
    ("known", "instant"),
    [
        (Landmark("Mast", position=(9.0, 9.0, -9.0)), None),
        # It was to be made one that moves: the place that was measured is all there is to know.
        (Landmark("Mast", position=(9.0, 9.0, -9.0)), "17"),
        (Landmark("Mast", position=(9.0, 9.0, -9.0), moving=True, instant="17"), "17"),
        (Landmark("Mast ", position=(9.0, 9.0, -9.0)), None),
        (Landmark("Mast", moving=True), None),
    ],
)
def test_surveyed_places_and_moving_objects_are_left_alone(known, instant):
    file = LandmarkFile((known,))
    assert why_kept(file, "Mast", instant)
    assert with_positions(file, [found("Mast", instant)]) == file


def test_what_was_triangulated_or_is_not_known_is_placed():
    old = Landmark("Mast", position=(9.0, 9.0, -9.0), surveyed=False, note="high")
    ball = Landmark("Ball", moving=True)
    there = Landmark("Ball", position=(4.0, 4.0, 0.0), instant="16")
    file = LandmarkFile((old, ball, there))
    located = [found("Mast"), found("Clock"), found("Ball", "17"), found("Ball", "16")]
    placed = {(m.name, m.instant): m for m in with_positions(file, located).landmarks}
    assert not why_kept(file, "Ball", "17")
    assert placed["Mast", None].position == PLACE
    assert placed["Mast", None].note == "high"
    assert (placed["Clock", None].position, placed["Clock", None].surveyed) == (PLACE, False)
    assert placed["Ball", None] == ball
    assert placed["Ball", "17"].position == PLACE
    assert placed["Ball", "16"] == there


# Edits of landmarks: what the window and the command line let a hand write.


def test_a_survey_keeps_what_else_is_known():
    mark = Landmark("Mast ", "The mast", (1.0, 1.0, 0.0), surveyed=False, frames=("a", "b"))
    (placed,) = with_surveyed_position(LandmarkFile((mark,)), "Mast", (9.0, 9.0, -9.0)).landmarks
    assert (placed.name, placed.title) == ("Mast ", "The mast")
    assert (placed.position, placed.surveyed, placed.frames) == ((9.0, 9.0, -9.0), True, ())
    assert with_surveyed_position(LandmarkFile(), "Flag", (1.0, 2.0, 0.0)).landmarks == (
        Landmark("Flag", position=(1.0, 2.0, 0.0)),
    )


def test_what_moves_is_not_surveyed_for_good():
    looks = Landmark("Ball", moving=True)
    at_17 = Landmark("Ball", position=(1.0, 2.0, -1.0), instant="17", surveyed=False)
    for file in (LandmarkFile((looks,)), LandmarkFile((at_17,)), LandmarkFile((looks, at_17))):
        with pytest.raises(UsageError, match="Ball moves"):
            with_surveyed_position(file, "Ball", (5.0, 5.0, -1.0))


def test_places_are_read_alike_everywhere():
    assert parse_surveyed(" Seat=A1 = 1; 2; -3") == ("Seat=A1", parse_position("1, 2, -3"))
    for text in ("Seat", "=1,2,3", "Seat=1,2", "Seat=a,b,c"):
        with pytest.raises(UsageError):
            parse_surveyed(text)


# Landmarks of a dataset, triangulated together.

SIZE = (960, 540)
STAND = np.array([10.0, -40.0, -8.0])


def camera(x: float) -> PinholeCamera:
    position = (x, 60.0, -15.0)
    dx, dy, dz = STAND - position
    pan, tilt = math.atan2(dx, -dy), math.atan2(math.hypot(dx, dy), dz)
    return PinholeCamera(pan, tilt, 0.0, position, (1800.0, 1800.0), (479.5, 269.5))


CAMERAS = {"left": camera(-40.0), "right": camera(40.0)}


@dataclass(frozen=True)
class Found:
    camera: Camera


class Cameras:
    """A set of the true cameras."""

    name = "true"

    def camera(self, frame: str, size: tuple[int, int]) -> Found:
        return Found(CAMERAS[frame])

    def why_none(self, frame: str) -> str:
        return "none"


def located(folder: Path, rng: np.random.Generator, noise_px: float, click_px: float | None):
    places = STAND + rng.normal(size=(30, 3)) * (6, 4, 2)

    def clicked(frame: str) -> FrameAnnotation:
        shown, _ = CAMERAS[frame].project(places)
        off = shown + rng.normal(0, noise_px, shown.shape)
        return FrameAnnotation(
            tuple(Polyline(f"Seat {i}", (point_from_px(*p, SIZE),)) for i, p in enumerate(off))
        )

    read = {frame: partial(clicked, frame) for frame in CAMERAS}
    search = TriangulationSettings(LandmarkFile(), cameras=Cameras(), size=SIZE, click_px=click_px)
    found = locate_in_dataset(read, load_field("soccer"), DatasetPaths(folder, folder), search)
    assert len(found.located) == 30
    return [one.found for one in found.located]


@pytest.mark.parametrize("noise_px", [1.5, 3.0])
def test_all_landmarks_together_say_how_far_clicks_are_off(tmp_path, noise_px):
    """One that is clicked in two views says next to nothing of it."""
    found = located(tmp_path, np.random.default_rng(2), noise_px, None)
    assert {one.noise for one in found} == {found[0].noise}
    assert found[0].noise == pytest.approx(noise_px / 1.5, rel=0.25)
    told = located(tmp_path, np.random.default_rng(2), noise_px, 1.5)
    grown = [a.deviations_m[1] / b.deviations_m[1] for a, b in zip(found, told, strict=True)]
    np.testing.assert_allclose(grown, found[0].noise, rtol=1e-6)
    assert {one.noise for one in told} == {1.0}


def test_the_cameras_are_fitted_to_the_dimensions_of_each_frame_s_stadium():
    stadium = Stadiums({"a": "small"}, {"small": {"length": 100.0, "width": 64.0}})
    field = with_stadiums(load_field("soccer"), stadium)
    true = PinholeCamera(0.1, 1.35, 0.0, (5.0, 75.0, -18.0), (1100.0, 1100.0), (479.5, 269.5))
    shown = project_field(true, EvaluationSetup(field_for_frame(field, "a"), SIZE, "procc"))
    lines = []
    for name, pieces in shown.pieces.items():
        piece = max(pieces, key=len)
        few = piece[np.linspace(0, len(piece) - 1, 6).astype(int)]
        lines.append(Polyline(name, tuple(point_from_px(*p, SIZE) for p in few)))
    views = fitted_views(field, lambda _: FrameAnnotation(tuple(lines)), lambda _: SIZE, "P")
    found = views("a")
    np.testing.assert_allclose(found.camera.position_world, true.position_world, atol=0.2)
