"""``procc-annotator track``: the cameras of a drawn shot whose cameras are known."""

import json
import math
import re
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.proposal import Proposal
from procc_annotator.calibration.tracking.track import Track, TrackedFrame
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.cli import track as command
from procc_annotator.dataset.sequence import open_pictures
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.image.decoding import decode_bgra
from tests.cli.conftest import rows_in
from tests.drawn_shots import DrawnShot, cut_shot, write_video

SIZE = (640, 360)
FRAMES, CUT = 24, 12
ANCHORS = (2, 20)


@pytest.fixture(scope="module")
def shot() -> DrawnShot:
    return cut_shot(FRAMES, size=SIZE)


@pytest.fixture(scope="module")
def video(shot, tmp_path_factory) -> Path:
    return shot.write_video(tmp_path_factory.mktemp("drawn") / "match.mp4")


@pytest.fixture(scope="module")
def pictures(video) -> Path:
    """The frames of the video, as they are decoded."""
    folder = video.parent / "pictures"
    folder.mkdir()
    for frame in open_pictures(video).frames:
        picture = decode_bgra(frame.image_path)
        cv2.imwrite(str(folder / f"{frame.name}.png"), picture[..., :3])
    return folder


def name_of(number: int) -> str:
    return f"match_{number:06d}"


def write_cameras(shot: DrawnShot, folder: Path, numbers: tuple[int, ...] = ANCHORS) -> Path:
    folder.mkdir(exist_ok=True)
    size = {"image_width": SIZE[0], "image_height": SIZE[1]}
    for number in numbers:
        content = write_camera(shot.cameras[number], size)
        (folder / f"camera_{name_of(number)}.json").write_bytes(content)
    return folder


@pytest.fixture
def cameras(shot, tmp_path) -> Path:
    return write_cameras(shot, tmp_path / "cameras")


@pytest.fixture(scope="module")
def whole(cli, shot, video, tmp_path_factory) -> Path:
    """The whole track of the video from both anchors, which no test changes."""
    folder = tmp_path_factory.mktemp("whole")
    given = write_cameras(shot, folder / "cameras")
    done = cli("track", video, folder / "out", "--cameras", given)
    assert f"{FRAMES} of {FRAMES} frames have a camera (2 anchors, 22 followed" in done.stdout
    assert f"{FRAMES} frames in 2 shots" in done.stdout
    return folder / "out"


@pytest.fixture
def followed(whole, tmp_path) -> Path:
    """The same, to be changed at will."""
    return shutil.copytree(whole, tmp_path / "out")


def table(out: Path) -> list[dict[str, str]]:
    return rows_in(out / "track.csv")


def files(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


def camera_in(out: Path, number: int) -> PinholeCamera:
    path = out / f"camera_{name_of(number)}.json"
    return read_camera_file(path.read_bytes(), path=path.name).camera


def test_every_frame_of_both_shots(shot, whole):
    rows = table(whole)
    assert [row["frame"] for row in rows] == [name_of(n) for n in range(FRAMES)]
    assert [row["shot"] for row in rows] == [name_of(0)] * CUT + [name_of(CUT)] * (FRAMES - CUT)
    assert [row["state"] for row in rows].count("anchor") == 2
    assert rows[0]["anchor_distance"] == "2"
    assert float(rows[0]["sd_pan_degrees"]) > 0
    assert sorted(files(whole)) == [
        *(f"camera_{name_of(n)}.json" for n in range(FRAMES)), "track.csv",
    ]  # fmt: skip
    for number, true in enumerate(shot.cameras):
        found = camera_in(whole, number)
        px = math.hypot(found.pan_rad - true.pan_rad, found.tilt_rad - true.tilt_rad)
        assert px * true.focal_px[0] < 2.0
    for number in ANCHORS:  # to the digit
        assert camera_in(whole, number).position_world == shot.cameras[number].position_world


def test_the_same_in_two_processes_and_from_pictures(cli, pictures, cameras, whole, tmp_path):
    out = tmp_path / "out"
    cli("track", pictures, out, "--cameras", cameras, "--workers", 2)
    assert files(out) == files(whole)


def test_annotated_frames_are_anchors(cli, shot, video, tmp_path):
    true = write_cameras(shot, tmp_path / "true")
    marked = tmp_path / "marked"
    cli("annotate", video, marked, "--cameras", true)
    done = cli("track", video, tmp_path / "out", "--annotations", marked)
    assert "(2 anchors, 22 followed" in done.stdout

    # Judged by the clicks they were fitted to they explain these; other frames do not.
    every = tmp_path / "every"
    shutil.copytree(marked, every)
    known = sorted(every.rglob("*.json"))
    (known[0].parent / f"{name_of(5)}.json").write_bytes(known[0].read_bytes())
    scores = tmp_path / "scores.json"
    cli("evaluate", known[0].parent, tmp_path / "out", "-o", scores)
    images = json.loads(scores.read_text())["images"]
    fitted = {one["name"] for one in images if one.get("fitted_on_these_clicks")}
    assert fitted == {name_of(number) for number in ANCHORS}
    assert len(images) == 3


def test_only_the_shot_of_a_frame(cli, video, cameras, tmp_path):
    out = tmp_path / "out"
    cli("track", video, out, "--cameras", cameras, "--from", name_of(14))
    assert [row["frame"] for row in table(out)] == [name_of(n) for n in range(CUT, FRAMES)]


def follow_by(monkeypatch: pytest.MonkeyPatch, follow: Callable[..., Track]) -> list[object]:
    """Something else follows shots; what was to be prepared for looking for cameras is told."""
    prepared: list[object] = []
    monkeypatch.setattr(command, "follow_shot", follow)
    monkeypatch.setattr(command, "warm_up_caches", lambda *given: prepared.append(given))
    return prepared


def test_what_was_found_in_a_picture_is_no_anchor(cli, video, monkeypatch, tmp_path):
    given = []

    def followed(frame, numbers, field, *, anchors, known, on_frame) -> Track:
        given.append((numbers, dict(anchors)))
        return nothing_found(frame, numbers, field, anchors=anchors, known=known, on_frame=on_frame)

    prepared = follow_by(monkeypatch, followed)
    cli("track", video, tmp_path / "out", "--from", "14")
    assert given == [(range(CUT, FRAMES), {})]
    assert prepared == [(load_field("soccer"), SIZE)]


def test_a_shot_without_a_camera_is_looked_at_where_the_other_one_stands(
    cli, shot, video, monkeypatch, tmp_path
):
    real, looks = command.follow_shot, []

    def followed(frame, numbers, field, *, anchors, known, on_frame) -> Track:
        looks.append((numbers[0], len(known)))
        if not anchors and not known:
            return nothing_found(
                frame, numbers, field, anchors=anchors, known=known, on_frame=on_frame
            )
        if known:
            tripod = shot.cameras[0].position_world
            assert np.linalg.norm(known[0].position_m - tripod) < 0.5
            anchors = {CUT: shot.cameras[CUT]}
        return real(frame, numbers, field, anchors=anchors, on_frame=on_frame)

    follow_by(monkeypatch, followed)
    out, given = tmp_path / "out", write_cameras(shot, tmp_path / "one", ANCHORS[:1])
    done = cli("track", video, out, "--cameras", given)
    assert looks == [(0, 0), (CUT, 0), (CUT, 1)]
    assert f"{FRAMES} of {FRAMES} frames have a camera" in done.stdout
    assert [row["frame"] for row in table(out)] == [name_of(n) for n in range(FRAMES)]


def test_an_anchor_of_another_picture_is_named(cli, shot, video, cameras, tmp_path):
    name = name_of(ANCHORS[0])
    camera = replace(shot.cameras[ANCHORS[0]], pan_rad=shot.cameras[ANCHORS[0]].pan_rad + 1.0)
    size = {"image_width": SIZE[0], "image_height": SIZE[1]}
    (cameras / f"camera_{name}.json").write_bytes(write_camera(camera, size))
    done = cli("track", video, tmp_path / "out", "--cameras", cameras, "--from", name)
    assert f"1 anchor without any line on paint: cameras of other pictures? {name}" in done.stdout


def test_anchors_that_are_given_later_are_used(cli, video, cameras, followed):
    """Somebody helps where a shot was lost, and starts the command again."""
    helped = re.compile(f"^{name_of(ANCHORS[1])},.*$", re.M)
    text = (followed / "track.csv").read_text()
    (followed / "track.csv").write_text(helped.sub(lambda m: m[0].replace("anchor", "lost"), text))
    done = cli("track", video, followed, "--cameras", cameras)
    assert "followed before: 1 shot" in done.stdout
    assert (followed / "track.csv").read_text() == text


def test_a_shot_is_followed_again_and_the_other_one_kept(cli, video, cameras, followed):
    before = table(followed)
    cli("track", video, followed, "--cameras", cameras, "--from", "14", "--overwrite")
    assert table(followed) == before


def test_a_shot_that_is_replaced_does_not_count_as_done_meanwhile(
    cli, video, cameras, monkeypatch, followed
):
    def stopped(*_, **__) -> Track:
        raise KeyboardInterrupt

    follow_by(monkeypatch, stopped)
    cli("track", video, followed, "--cameras", cameras, "--from", "14", "--overwrite", code=130)
    assert [row["frame"] for row in table(followed)] == [name_of(n) for n in range(CUT)]


def test_the_track_of_something_else_is_not_replaced(cli, video, followed, tmp_path):
    before = files(followed)
    other = shutil.copyfile(video, tmp_path / "other.mp4")
    done = cli("track", other, followed, code=2)
    assert f"is of other frames, such as {name_of(0)}" in done.stderr
    assert files(followed) == before


def lost(number: int, reason: str) -> TrackedFrame:
    return TrackedFrame(number, "lost", reason, None, 0.0, None, None)


def nothing_found(frame, numbers, field, *, anchors, known, on_frame) -> Track:
    """Looks at every picture and finds no camera."""
    found = []
    for number in numbers:
        dark = np.asarray(frame(number))[..., :3].max() == 0
        found.append(lost(number, "dark" if dark else "nothing to see"))
        on_frame(found[-1])
    return Track(tuple(found), ((numbers[0], numbers[-1]),))


def test_lost_frames_are_gaps_without_a_camera(cli, video, monkeypatch, tmp_path):
    follow_by(monkeypatch, nothing_found)
    out = tmp_path / "out"
    out.mkdir()
    (out / "track.csv").write_text("")
    (out / f"camera_{name_of(3)}.json").write_text("{}")  # of an earlier track
    done = cli("track", video, out, "--overwrite")
    assert "2 gaps" in done.stdout
    assert "nothing to see" in done.stdout
    assert list(files(out)) == ["track.csv"]
    assert {row["camera"] for row in table(out)} == {""}


def test_the_end_of_a_video_that_is_missing_is_a_problem(cli, pictures, monkeypatch, tmp_path):
    follow_by(monkeypatch, nothing_found)
    nowhere = Proposal("none", "", FitResult("P", SIZE, None, "nothing"), 0, 0, None, 0, None)
    monkeypatch.setattr("procc_annotator.cli.propose.propose_camera", lambda *_, **__: nowhere)
    frames = (decode_bgra(picture) for picture in sorted(pictures.iterdir()))
    cut = write_video(tmp_path / "cut.mkv", frames)
    cut.write_bytes(cut.read_bytes()[: cut.stat().st_size * 6 // 10])
    for name, *options in (("track",), ("propose", "--every", FRAMES)):
        done = cli(name, cut, tmp_path / name, *options, code=1)
        assert f"unreadable: {cut}: the file is cut off or damaged: it ends after" in done.stderr


def test_damaged_pictures_are_lost_and_listed(cli, pictures, monkeypatch, tmp_path):
    follow_by(monkeypatch, nothing_found)
    match = tmp_path / "match"
    shutil.copytree(pictures, match)
    (match / "match_000000.png").write_bytes(b"no picture")
    small = np.zeros((90, 160, 3), np.uint8)
    cv2.imwrite(str(match / "match_000003.png"), small)
    done = cli("track", match, tmp_path / "out", code=1)
    assert len(done.stderr.splitlines()) == 2
    assert "is not 640x360 px" in done.stderr
    rows = table(tmp_path / "out")
    assert len(rows) == FRAMES
    assert "cannot be decoded" in rows[0]["reason"]
    again = cli("track", match, tmp_path / "out", code=1)
    assert "followed before: " in again.stdout
    assert again.stderr == done.stderr


def test_a_run_that_was_stopped_goes_on(cli, video, cameras, whole, monkeypatch, tmp_path):
    out = tmp_path / "out"
    arguments = ("--cameras", cameras)
    real = command.follow_shot

    def stopped(frame, numbers, *rest, **options) -> Track:
        found = real(frame, numbers, *rest, **options)
        if numbers[0] == CUT:
            raise KeyboardInterrupt  # its cameras are written, those of frames
        return found

    with monkeypatch.context() as patched:
        patched.setattr(command, "follow_shot", stopped)
        done = cli("track", video, out, *arguments, code=130)
    assert f"interrupted: {CUT} of {FRAMES} frames are in {out}/track.csv" in done.stderr
    assert len(table(out)) == CUT
    assert len(files(out)) > CUT + 1  # also cameras of the shot that was not done
    again = cli("track", video, out, *arguments)
    assert "followed before: 1 shot" in again.stdout
    assert files(out) == files(whole)


def test_what_makes_no_sense(cli, video, cameras, tmp_path):
    out = tmp_path / "out"
    (tmp_path / "broken.mp4").write_bytes(video.read_bytes()[:2000])
    (tmp_path / "other.mp4").write_text("no video")
    for wrong, said in (
        ((tmp_path / "nowhere.mp4", out), "does not exist"),
        ((tmp_path / "broken.mp4", out), "cannot be opened as a video"),
        ((tmp_path / "other.mp4", out), "expected a video"),
        ((video, out, "--from", "99"), "there is no such frame"),
        ((video, out, "--cameras", tmp_path / "no"), "does not exist"),
        ((video, cameras, "--cameras", cameras), "write to another folder"),
        ((video, cameras), "holds cameras but no track.csv"),
        ((cameras, out), "no picture in"),
    ):
        done = cli("track", *wrong, code=2)
        assert said in done.stderr
    assert not out.exists()


def test_pictures_that_have_nothing_to_do_with_each_other_have_their_own_anchors(
    cli, sample_data, tmp_path
):
    """What cannot be followed from one anchor to the next is followed from each of them."""
    match = tmp_path / "match"
    match.mkdir()
    for name in ("00002", "00003"):
        for suffix in (".jpg", ".json"):
            shutil.copy(sample_data / f"{name}{suffix}", match)
    done = cli("track", match, tmp_path / "out", "--annotations", match)
    assert "2 of 2 frames have a camera (2 anchors" in done.stdout
