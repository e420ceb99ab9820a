"""``procc-annotator track``: the cameras of a drawn shot whose cameras are known."""

import json
import math
import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from procc_annotator.batch.unit_store import only_run
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.proposal import Proposal
from procc_annotator.calibration.tracking.track import Track, TrackedFrame
from procc_annotator.cli import track as command
from procc_annotator.dataset.sequence import open_pictures
from procc_annotator.formats.cameras.packed import PackedCameras, read_packed
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


def tracked(out: Path, name: str = "match") -> PackedCameras:
    return read_packed((out / f"{name}.npz").read_bytes(), name)


def test_every_frame_of_both_shots(shot, whole):
    found = tracked(whole)
    assert found.frame == tuple(name_of(n) for n in range(FRAMES))
    assert found.shot == (name_of(0),) * CUT + (name_of(CUT),) * (FRAMES - CUT)
    assert found.state.count("anchor") == 2
    assert found.anchor_distance[0] == 2
    assert 0 < found.position_sd_m(0).max() < 10
    assert found.time_s[-1] > found.time_s[0] == 0
    for number, true in enumerate(shot.cameras):
        camera = found.pinhole(number)
        px = math.hypot(camera.pan_rad - true.pan_rad, camera.tilt_rad - true.tilt_rad)
        assert px * true.focal_px[0] < 2.0
    for number in ANCHORS:  # to the digit
        assert found.pinhole(number).position_world == shot.cameras[number].position_world


def test_points_of_tracked_frames_have_places_with_standard_deviations(cli, whole, tmp_path):
    points = tmp_path / "points.csv"
    points.write_text(f"frame,x,y\n{name_of(5)},300,250\n")
    cli("ground", points, "--cameras", whole, "-o", tmp_path / "metres.csv")
    (row,) = rows_in(tmp_path / "metres.csv")
    assert 0 < float(row["sigma_x"]) < 5
    single = tmp_path / "cameras"
    cli("convert", whole, single, "--to", "soccernet-camera")
    cli("ground", points, "--cameras", single, "-o", tmp_path / "again.csv")
    assert rows_in(tmp_path / "again.csv") == [row]


def test_the_same_in_two_processes_and_from_pictures(cli, pictures, cameras, whole, tmp_path):
    out = tmp_path / "out"
    cli("track", pictures, out, "--cameras", cameras, "--workers", 2)
    assert same(tracked(out, "pictures"), tracked(whole))


def same(one: PackedCameras, other: PackedCameras) -> bool:
    """Whether all but the times are the same, to the last bit."""
    texts = "frame", "shot", "state", "reason", "clicks"
    numbers = "coverage", "residual_px", "size", "camera", "covariance", "anchor_distance"
    return all(getattr(one, name) == getattr(other, name) for name in texts) and all(
        np.array_equal(getattr(one, name), getattr(other, name), equal_nan=True) for name in numbers
    )


def test_a_season_is_the_matches_one_by_one(cli, video, cameras, whole, tmp_path):
    """A tree of videos; with a worker that is shared, and once more from a list."""
    season, given = tmp_path / "season", tmp_path / "cameras_by_match"
    for name in ("a/match", "b/match"):
        (season / name).parent.mkdir(parents=True)
        shutil.copyfile(video, season / f"{name}.mp4")
        shutil.copytree(cameras, given / name)
    out = tmp_path / "out"
    done = cli("track", season, out, "--cameras", given, "--workers", 2)
    assert "2 matches" in done.stdout
    assert all(same(tracked(out, name), tracked(whole)) for name in ("a/match", "b/match"))
    page = tmp_path / "status.html"
    told = cli("status", out, "--price", 2, "-o", page).stdout
    assert f"2 of 2 matches done, {2 * FRAMES} of {2 * FRAMES} frames tracked" in told
    assert all(name in page.read_text() for name in ("a/match", "b/match", "2 matches"))
    listed = season / "season.csv"
    listed.write_text("video,match,stadium\nb/match.mp4,one,Arena\na/match.mp4,two,Arena\n")
    for name in ("one", "two"):
        shutil.copytree(cameras, given / name)
    cli("track", listed, tmp_path / "listed", "--cameras", given)
    assert all(same(tracked(tmp_path / "listed", name), tracked(whole)) for name in ("one", "two"))


@pytest.mark.parametrize("is_listed", [False, True])
def test_annotations_beside_the_videos_of_a_season(cli, shot, video, whole, is_listed, tmp_path):
    """By the tree or by a list; the files of matches lie at several depths."""
    season, out, true = tmp_path / "season", tmp_path / "out", tmp_path / "true"
    for name in ("match", "b/match"):
        for folder in (season, out, true):
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
        write_cameras(shot, true / name)
        shutil.copyfile(video, season / f"{name}.mp4")
        shutil.copyfile(whole / "match.npz", out / f"{name}.npz")
    given = season / "season.csv" if is_listed else season
    if is_listed:
        given.write_text("video,match\nmatch.mp4,match\nb/match.mp4,b/match\n")
    cli("annotate", given, season, "--cameras", true)
    cli("track", given, tmp_path / "again", "--annotations", given)
    assert tracked(tmp_path / "again", "b/match").state.count("anchor") == 2
    assert "Summary of 4 frames, 4 with a camera" in cli("evaluate", given, out).stdout
    assert "paint was not looked for" not in cli("check", given, "-o", tmp_path / "f.csv").stdout
    cli("report", given, "--cameras", f"t={out}", "-o", tmp_path / "report.json")
    assert f"b/match/{name_of(20)}" in (tmp_path / "report.json").read_text()
    (out / "b/match.npz").write_bytes(b"PK, cut off")
    for way in (("evaluate", given, out), ("report", given, "--cameras", f"t={out}")):
        said = cli(*way, "-o", tmp_path / "of_rest.json", code=1).stderr
        assert "unreadable: " in said
        assert "b/match.npz" in said
    shutil.move(out / "match.npz", out / "b/match.npz")  # the only one that was tracked so far
    assert "4 frames, 2 with a camera" in cli("evaluate", given, out).stdout
    (tmp_path / "points.csv").write_text(f"frame,x,y\nb/match/{name_of(5)},300,250\n")
    done = cli("ground", tmp_path / "points.csv", "--cameras", out, "-o", tmp_path / "metres.csv")
    assert "no camera" not in done.stderr
    shutil.move(out / "b/match.npz", out / "match.npz")
    shutil.rmtree(season / "b/match_frames")
    cli("calibrate", given, tmp_path / "fits")
    assert len(list((tmp_path / "fits/match").glob("camera_*.json"))) == 2
    (out / "b/match.npz").write_bytes(b"PK, cut off")
    assert "b/match.npz: cannot be read (no frame" in cli("evaluate", given, out).stderr
    for cameras in (out, out / "match.npz", tmp_path / "fits"):
        assert "2 frames, 2 with a camera" in cli("evaluate", given, cameras).stdout


def test_only_what_a_list_has_counts(cli, video, monkeypatch, tmp_path):
    follow_by(monkeypatch, nothing_found)
    listed, out = tmp_path / "season.csv", tmp_path / "out"

    def track(*rows: str, code: int = 0) -> str:
        listed.write_text("\n".join(("video,match,stadum,field", *(f"{video},{r}" for r in rows))))
        return cli("track", listed, out, code=code).stderr

    said = track("one,,", "two,,socer", code=2)
    assert "season.csv: line 3: field: socer: no such field; did you mean 'soccer'?" in said
    assert "season.csv: columns left out: stadum" in track("one,,", "two,,")
    track("two,,")
    told = cli("status", out, "--price", 2, "-o", tmp_path / "status.json").stdout
    assert f"1 of 1 match done, {FRAMES} of {FRAMES} frames tracked" in told
    numbers = json.loads((tmp_path / "status.json").read_text())
    assert (numbers["matches_done"], numbers["frames"], numbers["hours_left"]) == (1, FRAMES, 0)
    assert numbers["cost"] == 2 * numbers["hours"] > 0
    with only_run(out):
        assert "another run writes there" in track("two,,", code=2)
    assert not list(out.glob("*.lock*"))


def test_a_season_of_urls_goes_to_a_url(cli, video, pictures, cameras, whole, tmp_path):
    """A video and an archive; done matches are not fetched again, and units are logged as JSON."""
    store = tmp_path / "store"
    shutil.copytree(cameras, tmp_path / "given/one")
    shutil.copytree(cameras, tmp_path / "given/two")
    shutil.make_archive(str(store / "pictures"), "tar", pictures)
    shutil.copyfile(video, store / "match.mp4")
    listed = store / "season.csv"
    rows = f"{(store / 'match.mp4').as_uri()},one\ngone.mp4,gone\npictures.tar,two\n"
    listed.write_text(f"video,match\n{rows}")
    given = "--cameras", tmp_path / "given", "--cache", tmp_path / "cache", "--log", "json"
    out = Path((tmp_path / "out").as_uri())
    done = cli("track", Path(listed.as_uri()), out, *given, "--workers", 2, code=1)
    assert "store/gone.mp4: cannot be transferred: no such file" in done.stderr
    read = [json.loads(line) for line in done.stderr.splitlines() if line.startswith("{")]
    (failed,) = (line for line in read if line.get("match") == "gone")
    assert (failed["state"], failed["tries"], failed["kind"]) == ("failed", 1, "match")
    lines = [line for line in read if line.get("match") in ("one", "two")]
    assert {line["match"] for line in lines} == {"one", "two"}
    assert {(line["state"], line["tries"], line["error"]) for line in lines} == {("done", 1, "")}
    assert all(line["evidence"] > 0.9 for line in lines if line["kind"] == "track")
    assert all(same(tracked(tmp_path / "out", name), tracked(whole)) for name in ("one", "two"))
    assert not list((tmp_path / "cache/copies").glob("*/*[4r]"))  # mp4, tar
    shutil.rmtree(tmp_path / "cache")
    (store / "pictures.tar").unlink()
    shutil.copyfile(video, store / "gone.mp4")
    again = cli("track", Path(listed.as_uri()), out, *given[2:])
    assert "3 matches" in again.stdout
    assert "gone" in cli("status", out).stdout


def test_a_unit_that_fails_three_times_is_set_aside_and_tried_again_when_asked(
    cli, video, cameras, whole, monkeypatch, tmp_path
):
    tries = []
    real = command.follow_shot

    def failing(frame, numbers, *rest, **options) -> Track:
        tries.append(numbers[0])
        if numbers[0] == CUT:
            raise OSError("the disk is gone")
        return real(frame, numbers, *rest, **options)

    out, words = tmp_path / "out", ("--cameras", cameras)
    with monkeypatch.context() as patched:
        patched.setattr(command, "follow_shot", failing)
        done = cli("track", video, out, *words, code=1)
    assert tries.count(CUT) == 3
    assert f"set aside: match: track of frames {CUT} to {FRAMES - 1}: " in done.stderr
    assert "the disk is gone" in done.stderr
    assert tracked(out).has_camera.tolist() == [True] * CUT + [False] * (FRAMES - CUT)
    again = cli("track", video, out, *words, code=1)  # without being asked
    assert "set aside" in again.stderr
    cli("track", video, out, *words, "--only", "failed")
    assert same(tracked(out), tracked(whole))


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
    over_time = cli("evaluate", known[0].parent, tmp_path / "out", "--over-time")
    assert "by the track" in over_time.stdout
    fitted = {one["name"] for one in images if one.get("fitted_on_these_clicks")}
    assert fitted == {name_of(number) for number in ANCHORS}
    assert len(images) == 3


def test_only_the_shot_of_a_frame(cli, video, cameras, whole, tmp_path):
    out = tmp_path / "out"
    cli("track", video, out, "--cameras", cameras, "--from", name_of(14))
    assert tracked(out).frame == tuple(name_of(n) for n in range(CUT, FRAMES))
    cli("track", video, out, "--cameras", cameras, "--from", "2")
    assert same(tracked(out), tracked(whole))


def follow_by(monkeypatch: pytest.MonkeyPatch, follow: Callable[..., Track]) -> None:
    """Something else follows shots."""
    monkeypatch.setattr(command, "follow_shot", follow)


def test_what_was_found_in_a_picture_is_no_anchor(cli, video, monkeypatch, tmp_path):
    given = []

    def followed(frame, numbers, field, *, anchors, known, on_frame) -> Track:
        given.append((numbers, dict(anchors)))
        return nothing_found(frame, numbers, field, anchors=anchors, known=known, on_frame=on_frame)

    follow_by(monkeypatch, followed)
    cli("track", video, tmp_path / "out", "--from", "14")
    assert given == [(range(CUT, FRAMES), {})]


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
    assert tracked(out).frame == tuple(name_of(n) for n in range(FRAMES))


def test_an_anchor_of_another_picture_is_named(cli, shot, video, cameras, tmp_path):
    name = name_of(ANCHORS[0])
    camera = replace(shot.cameras[ANCHORS[0]], pan_rad=shot.cameras[ANCHORS[0]].pan_rad + 1.0)
    size = {"image_width": SIZE[0], "image_height": SIZE[1]}
    (cameras / f"camera_{name}.json").write_bytes(write_camera(camera, size))
    done = cli("track", video, tmp_path / "out", "--cameras", cameras, "--from", name)
    assert f"1 anchor without any line on paint: cameras of other pictures? {name}" in done.stdout


def test_anchors_that_are_given_later_are_used(cli, shot, video, cameras, monkeypatch, tmp_path):
    """Somebody helps where a shot was lost, and starts the command again."""
    out, given = tmp_path / "out", write_cameras(shot, tmp_path / "one", ANCHORS[:1])
    cli("track", video, out, "--cameras", given)
    real, followed = command.follow_shot, []

    def noted(frame, numbers, *rest, **options) -> Track:
        followed.append(numbers[0])
        return real(frame, numbers, *rest, **options)

    follow_by(monkeypatch, noted)
    cli("track", video, out, "--cameras", cameras)
    assert followed == [CUT]
    assert tracked(out).state.count("anchor") == 2


def test_what_other_programs_left_is_not_replaced(cli, video, cameras, followed, tmp_path):
    before = (followed / "match.npz").read_bytes()
    (followed / "track.sqlite").unlink()
    done = cli("track", video, followed, "--cameras", cameras, code=2)
    assert "holds cameras but no track.sqlite" in done.stderr
    done = cli("track", video, followed, "--cameras", cameras, "--overwrite")
    assert (followed / "match.npz").read_bytes() == before


def test_a_copy_of_a_video_is_not_followed_again_one_that_was_replaced_is(
    cli, video, pictures, cameras, followed, monkeypatch, tmp_path
):
    """Other pictures of its name in another place are a match of another season."""
    follow_by(monkeypatch, nothing_found)
    copy, other = tmp_path / "match.mp4", tmp_path / "other/match.mp4"
    cli("track", shutil.copyfile(video, copy), followed, "--cameras", cameras)
    frames = [decode_bgra(path) for path in sorted(pictures.iterdir())]
    other.parent.mkdir()
    write_video(other, [*frames[CUT:], *frames[:CUT]])
    assert "holds match of other pictures" in cli("track", other, followed, code=2).stderr
    assert tracked(followed).has_camera.all()
    other.replace(copy)
    assert "note: match: the pictures" in cli("track", copy, followed).stderr
    assert set(tracked(followed).state) == {"lost"}


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
    done = cli("track", video, out)
    assert "2 gaps" in done.stdout
    assert "nothing to see" in done.stdout
    assert not tracked(out).has_camera.any()


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
    assert sum("unreadable" in line for line in done.stderr.splitlines()) == 2
    assert "is not 640x360 px" in done.stderr
    found = tracked(tmp_path / "out")
    assert len(found) == FRAMES
    assert "cannot be decoded" in found.reason[0]
    again = cli("track", match, tmp_path / "out", code=1)
    assert again.stderr in done.stderr


def test_a_run_that_was_stopped_goes_on(cli, video, cameras, whole, monkeypatch, tmp_path):
    out, words = tmp_path / "out", ("--cameras", cameras)
    real, followed = command.follow_shot, []

    def stopped(frame, numbers, *rest, **options) -> Track:
        followed.append(numbers[0])
        if followed == [0, CUT]:
            raise KeyboardInterrupt
        return real(frame, numbers, *rest, **options)

    follow_by(monkeypatch, stopped)
    done = cli("track", video, out, *words, code=130)
    assert "run it again to go on" in done.stderr
    cli("track", video, out, *words)
    assert followed == [0, CUT, CUT]
    assert (out / "match.npz").read_bytes() == (whole / "match.npz").read_bytes()


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
        ((video, cameras), "holds cameras but no track.sqlite"),
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
