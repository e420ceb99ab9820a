"""``procc-annotator annotate``: the paint under given cameras, as proposed, over nothing."""

import json
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import pytest

from procc_annotator import evaluate, load_annotation
from procc_annotator.batch import auto_annotation
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.records import Origin, OriginKind, count_points_by_origin
from procc_annotator.formats.cameras.soccernet import write_camera
from tests.drawn_shots import DrawnShot, soccer_shot

SIZE = (640, 360)
FRAMES = 3


@dataclass(frozen=True)
class Match:
    """Pictures of a drawn shot, with their cameras."""

    shot: DrawnShot
    root: Path

    @property
    def cameras(self) -> Path:
        return self.root / "cameras"

    @property
    def pictures(self) -> Path:
        return self.root / "match"

    @property
    def annotations(self) -> Path:
        return self.pictures / "annotations"

    def write_cameras(self) -> None:
        """The true cameras of all frames."""
        self.cameras.mkdir()
        size = {"image_width": SIZE[0], "image_height": SIZE[1]}
        for number, camera in enumerate(self.shot.cameras):
            path = self.cameras / f"camera_{number:05d}.json"
            path.write_bytes(write_camera(camera, size))


def names_in(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.glob("*.json"))


def kinds_of(dataset: Path, annotation: Path) -> dict[OriginKind, int]:
    """How the points of an annotation came to be, as a dataset's workspace has it."""
    database = WorkspaceDatabase.open(dataset, "somebody")
    try:
        return count_points_by_origin(
            load_annotation(annotation), database.origins(annotation.stem)
        )
    finally:
        database.close()


@pytest.fixture(scope="module")
def shot() -> DrawnShot:
    return soccer_shot(FRAMES, size=SIZE)


@pytest.fixture(scope="module")
def pictures(shot, tmp_path_factory) -> dict[str, bytes]:
    folder = shot.write_pictures(tmp_path_factory.mktemp("drawn"))
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.fixture(scope="module", autouse=True)
def looked_at_once() -> Iterator[None]:
    """The same picture under the same camera is looked at once in this process: nearly all the time
    of the tests below would go into that."""
    known: dict[object, auto_annotation.AnnotatedPicture] = {}
    look = auto_annotation.annotate_picture

    def painted(name, picture, camera, field):
        key = (name, picture.tobytes(), camera, field.name)
        if key not in known:
            known[key] = look(name, picture, camera, field)
        return known[key]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(auto_annotation, "annotate_picture", painted)
        yield


@pytest.fixture
def match(shot, pictures, tmp_path) -> Match:
    made = Match(shot, tmp_path)
    made.pictures.mkdir()
    for name, data in pictures.items():
        (made.pictures / name).write_bytes(data)
    made.write_cameras()
    return made


def test_the_paint_under_the_cameras_becomes_annotations(cli, match):
    done = cli("annotate", match.pictures, match.annotations, "--cameras", match.cameras)
    assert f"written: {FRAMES} annotations (" in done.stdout
    assert not done.stderr
    for number, camera in enumerate(match.shot.cameras):
        annotation = load_annotation(match.annotations / f"{number:05d}.json")
        field = match.shot.stage.field
        score = evaluate(annotation, camera, field=field, size=SIZE, protocol="procc")
        assert score.tp >= 3
        assert score.max_error is not None
        assert score.max_error < 1.5


def test_the_cameras_that_made_annotations_take_no_rank_against_them(cli, match, tmp_path):
    cli("annotate", match.pictures, match.annotations, "--cameras", match.cameras)
    cli("convert", match.cameras, tmp_path / "krt", "--to", "krt")
    (tmp_path / "own").mkdir()
    for number, camera in enumerate(match.shot.cameras):
        moved = replace(camera, pan_rad=camera.pan_rad + 1e-3).scaled(SIZE, (960, 540))
        (tmp_path / "own" / f"camera_{number:05d}.json").write_bytes(write_camera(moved))
    (match.annotations / "00000.json").write_text(
        (match.annotations / "00000.json").read_text().replace("0.", "0.0", 1)  # a point was moved
    )
    out = tmp_path / "scores.json"
    methods = [f"{name}={tmp_path / name}" for name in ("cameras", "krt", "own")]
    done = cli(
        "evaluate", match.annotations, *(a for m in methods for a in ("--cameras", m)), "-o", out
    )
    marks = [e.get("fitted_on_these_clicks") for e in json.loads(out.read_bytes())["evaluations"]]
    assert marks == [FRAMES, FRAMES, None]
    assert f"points of {FRAMES} frames (00000, 00001, 00002) come from cameras" in done.stderr


def test_their_points_are_proposed_wherever_the_set_is_opened(cli, match, tmp_path):
    elsewhere = tmp_path / "elsewhere"
    for out in (match.annotations, elsewhere):
        cli("annotate", match.pictures, out, "--cameras", match.cameras)
    first = match.annotations / "00000.json"
    points = sum(len(polyline.points) for polyline in load_annotation(first).polylines)
    assert kinds_of(match.pictures, first) == {OriginKind.PROPOSED: points}
    again = elsewhere / "00000.json"
    assert again.read_bytes() == first.read_bytes()
    assert kinds_of(elsewhere, again) == {OriginKind.PROPOSED: points}


def test_points_that_a_person_accepted_at_the_same_places_stay_theirs(cli, match, tmp_path):
    arguments = "--cameras", match.cameras
    cli("annotate", match.pictures, match.annotations, *arguments)
    first = match.annotations / "00000.json"
    database = WorkspaceDatabase.open(match.pictures, "somebody")
    known = database.origins("00000")
    database.put_origins("00000", {k: Origin(OriginKind.ACCEPTED, "somebody", 1.0) for k in known})
    database.close()

    elsewhere = tmp_path / "elsewhere"
    cli("annotate", match.pictures, elsewhere, *arguments)

    assert set(kinds_of(match.pictures, first)) == {OriginKind.ACCEPTED}
    assert set(kinds_of(elsewhere, elsewhere / "00000.json")) == {OriginKind.PROPOSED}


def test_what_is_annotated_stays_and_a_run_goes_on(cli, match):
    match.annotations.mkdir()
    own = match.annotations / "00001.json"
    own.write_text("{}")
    arguments = ("annotate", match.pictures, match.annotations, "--cameras", match.cameras)
    done = cli(*arguments)
    assert f"written: {FRAMES - 1} annotations" in done.stdout
    assert "not touched: 1 frame annotated already" in done.stdout
    assert own.read_text() == "{}"
    before = {path: path.read_bytes() for path in match.annotations.iterdir()}
    (match.annotations / "00002.json").unlink()
    assert "written: 1 annotation (" in cli(*arguments).stdout
    assert {path: path.read_bytes() for path in match.annotations.iterdir()} == before


def test_an_annotation_that_appears_meanwhile_stays(cli, match, monkeypatch):
    def slow(name, *arguments):
        match.annotations.joinpath(f"{name}.json").write_text("{}")
        return painted(name, *arguments)

    painted = auto_annotation.annotate_picture
    monkeypatch.setattr(auto_annotation, "annotate_picture", slow)
    done = cli("annotate", match.pictures, match.annotations, "--cameras", match.cameras)
    assert f"not touched: {FRAMES} frames annotated already" in done.stdout
    assert {path.read_text() for path in match.annotations.iterdir()} == {"{}"}


def test_nothing_is_written_where_no_paint_is(cli, match):
    last = (match.pictures / f"{FRAMES - 1:05d}.png").read_bytes()
    (match.pictures / "00000.png").write_bytes(last)  # the picture of another camera
    done = cli("annotate", match.pictures, match.annotations, "--cameras", match.cameras)
    assert "no paint found under the camera: 1 frame (00000)" in done.stdout
    assert "00000.json" not in names_in(match.annotations)


def test_frames_of_a_video_by_their_names(cli, match, tmp_path):
    video = match.shot.write_video(tmp_path / "match.mp4")
    for path in match.cameras.iterdir():
        path.rename(path.with_name(path.name.replace("camera_0", "camera_match_00")))
    frames = tmp_path / "match_frames"
    done = cli("annotate", video, frames, "--cameras", match.cameras, "--every", 2)
    assert names_in(frames) == ["match_000000.json", "match_000002.json"]
    assert not done.stderr
    assert set(kinds_of(frames, frames / "match_000002.json")) == {OriginKind.PROPOSED}


def test_the_views_that_differ_most(cli, match):
    arguments = ("--cameras", match.cameras, "--views", 2)
    cli("annotate", match.pictures, match.annotations, *arguments)
    first, second = names_in(match.annotations)
    assert (first, second) == ("00000.json", "00001.json")


def test_several_processes_find_the_same(cli, match, tmp_path):
    for name, workers in (("one", 1), ("two", 2)):
        out = tmp_path / name
        arguments = ("--cameras", match.cameras, "--workers", workers)
        cli("annotate", match.pictures, out, *arguments)
    one, two = (
        [p.read_bytes() for p in sorted((tmp_path / n).glob("*.json"))] for n in ("one", "two")
    )
    assert one == two
    assert len(one) == FRAMES


def test_what_cannot_be_read_is_listed_and_the_rest_goes_on(cli, match):
    (match.pictures / "00000.png").write_bytes(b"no picture")
    (match.cameras / "camera_00001.json").write_text("{")
    done = cli("annotate", match.pictures, match.annotations, "--cameras", match.cameras, code=1)
    assert len(done.stderr.splitlines()) == 2
    assert names_in(match.annotations) == ["00002.json"]


def test_what_makes_no_sense(cli, match, tmp_path):
    for wrong, said in (
        ((tmp_path / "nowhere", match.annotations, "--cameras", match.cameras), "does not exist"),
        ((match.pictures, match.annotations, "--cameras", tmp_path / "no"), "does not exist"),
        ((match.pictures, match.cameras, "--cameras", match.cameras), "write to another folder"),
        ((match.cameras, match.annotations, "--cameras", match.cameras), "no picture in"),
    ):
        done = cli("annotate", *wrong, code=2)
        assert said in done.stderr
    for path in match.cameras.iterdir():
        path.rename(path.with_name("camera_other.json"))
    done = cli("annotate", match.pictures, match.annotations, "--cameras", match.cameras, code=2)
    assert "holds no camera of these frames (it holds 1 camera, e.g. for other" in done.stderr


def test_an_interrupted_run_says_how_to_go_on(cli, match, monkeypatch):
    def stopped(name, *arguments):
        if name == "00002":
            raise KeyboardInterrupt
        return painted(name, *arguments)

    painted = auto_annotation.annotate_picture
    monkeypatch.setattr(auto_annotation, "annotate_picture", stopped)
    done = cli("annotate", match.pictures, match.annotations, "--cameras", match.cameras, code=130)
    assert f"interrupted: 2 of {FRAMES} frames examined, 2 annotations written" in done.stderr
    assert names_in(match.annotations) == ["00000.json", "00001.json"]
    assert set(kinds_of(match.pictures, match.annotations / "00001.json")) == {OriginKind.PROPOSED}
