"""``triangulate``: from clicks in wide views to a close-up that is calibrated from landmarks."""

import importlib.util
import json
import re
import shutil
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.formats.landmark_file import load_landmarks

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def three_views() -> ModuleType:
    spec = importlib.util.spec_from_file_location(
        "three_views", ROOT / "docs/examples/three_views.py"
    )
    module = importlib.util.module_from_spec(spec)
    sys.modules["three_views"] = module
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def match(tmp_path, monkeypatch, three_views) -> Path:
    monkeypatch.chdir(tmp_path)
    three_views.make_dataset(tmp_path / "match")
    return Path("match")


def positions(path: Path) -> dict[str, np.ndarray]:
    return {
        mark.name: np.array(mark.position)
        for mark in load_landmarks(path).landmarks
        if mark.position is not None
    }


def edit(match: Path, frame: str, **changes: object) -> None:
    path = match / "annotations" / f"{frame}.json"
    content = json.loads(path.read_text()) | changes
    path.write_text(json.dumps({k: v for k, v in content.items() if v is not None}))


def test_landmarks_calibrate_a_close_up_that_sees_too_little_of_the_field(cli, match, three_views):
    alone = cli("calibrate", match, "alone", "--protocol", "procc")
    assert "17_close" in alone.stdout
    assert not Path("alone/camera_17_close.json").exists()
    done = cli("triangulate", match)
    assert "no camera in 17_close: 2 elements, 3 needed" in done.stderr
    known = load_landmarks(match / "landmarks.json").landmarks
    assert {mark.name for mark in known} == set(three_views.LANDMARKS)
    for mark in known:
        assert mark.position is not None
        off = np.array(mark.position) - three_views.LANDMARKS[mark.name]
        # Of three degrees of freedom: beyond 16 is 1 in 1000.
        assert off @ np.linalg.inv(np.array(mark.covariance)) @ off < 16
        assert (mark.surveyed, mark.frames) == (False, ("17_left", "17_right"))
    cli("calibrate", match, "fitted", "--protocol", "procc")
    path = Path("fitted/camera_17_close.json")
    camera = read_camera_file(path.read_bytes(), path=path.name).camera
    touchline = np.array([(x, -34.0, 0.0) for x in np.linspace(4, 24, 9)])
    off_px = camera.project(touchline)[0] - three_views.CAMERAS["17_close"].project(touchline)[0]
    assert np.abs(off_px[:, 1]).max() < 1.5  # across the line, which is nearly level
    assert np.abs(off_px[:, 0]).max() < 14  # along it: half a metre


def test_scores_and_checks_use_the_landmarks(cli, match):
    cli("triangulate", match, "--cameras", match / "cameras")
    scored = cli("evaluate", match / "annotations", match / "cameras", "--protocol", "procc")
    assert "6 landmarks" in scored.stdout
    assert re.search(r"Clock\s+│", scored.stdout)
    official = cli("evaluate", match / "annotations", match / "cameras")
    assert "landmark" not in official.stdout
    assert "Clock" not in official.stdout
    clock = json.loads((match / "annotations/17_left.json").read_text())["Clock"]
    edit(match, "17_left", Clock=[{"x": clock[0]["x"] + 0.1, "y": clock[0]["y"]}])
    checked = cli("check", match)
    assert "Clock" in checked.stdout
    assert "17_left" in checked.stdout


@pytest.mark.parametrize("protocol", ["soccernet", "procc"])
def test_landmarks_that_are_only_named_change_no_figure(cli, match, three_views, protocol):
    def figures(name: str) -> object:
        cli("evaluate", match / "annotations", match / "cameras", "--protocol", protocol,
                   "-o", name)  # fmt: skip
        return json.loads(Path(name).read_text())["summary"]["5"]

    clicked = {path: path.read_text() for path in (match / "annotations").iterdir()}
    for path in clicked:
        edit(match, path.stem, **dict.fromkeys(three_views.LANDMARKS))
    alone = figures("alone.json")
    for path, text in clicked.items():
        path.write_text(text)
    # Known by name, or where it was at another instant: no views.csv says when the frames are.
    entries = [{"name": name} for name in three_views.LANDMARKS if name != "Mast"]
    mast = [{"name": "Mast", "moving": True},
            {"name": "Mast", "instant": "17", "position": [14.5, -60.0, -11.0]}]  # fmt: skip
    (match / "landmarks.json").write_text(json.dumps({"landmarks": [*entries, *mast]}))
    assert figures("named.json") == alone
    assert "Clock" not in cli("check", match).stdout
    # SoccerNet's own evaluation would take them for elements that no camera shows.
    exported = cli("export", match, "out")
    assert "Clock is left out" in exported.stdout + exported.stderr
    written = json.loads(Path("out/17_left.json").read_text())
    assert not {"Clock", "Mast"} & written.keys()


def test_surveyed_places_stay_and_what_is_known_of_a_landmark_is_kept(cli, match):
    path = match / "landmarks.json"
    path.write_text(json.dumps({
        "surveyor": "M.",
        "landmarks": [
            {"name": "Clock", "position": [1.0, 2.0, -3.0], "serial": 7},
            {"name": "Mast", "title": "The mast", "colour": "#112233"},
        ],
    }))  # fmt: skip
    done = cli("triangulate", match, "--cameras", match / "cameras")
    assert "surveyed: kept as it is" in done.stdout
    written = json.loads(path.read_text())
    entries = {entry["name"]: entry for entry in written["landmarks"]}
    assert written["surveyor"] == "M."
    assert entries["Clock"] == {"name": "Clock", "position": [1.0, 2.0, -3.0], "serial": 7}
    assert (entries["Mast"]["title"], entries["Mast"]["colour"]) == ("The mast", "#112233")
    assert len(entries["Mast"]["position"]) == 3
    cli("triangulate", match, "--surveyed", "Clock=12,-52,-11", "--surveyed", "Flag=52,-34,0")
    found = positions(path)
    assert found["Clock"].tolist() == [12.0, -52.0, -11.0]
    assert found["Flag"].tolist() == [52.0, -34.0, 0.0]
    assert json.loads(path.read_text())["landmarks"][0]["serial"] == 7


def test_a_surveyed_landmark_cannot_be_made_a_moving_one(cli, match):
    path = match / "landmarks.json"
    entry = {"name": "Clock", "position": [12.0, -52.0, -11.0]}
    path.write_text(json.dumps({"landmarks": [entry]}))
    done = cli(
        "triangulate", match, "--cameras", match / "cameras", "--moving", "Clock",
        "--pattern", "{instant}_{view}",
    )  # fmt: skip
    assert "surveyed: kept as it is" in done.stdout
    clocks = [e for e in json.loads(path.read_text())["landmarks"] if e["name"] == "Clock"]
    assert clocks == [entry]


def test_a_moving_object_has_a_position_each_instant(cli, match, three_views):
    for inner in ("annotations", "cameras"):
        for file in list((match / inner).iterdir()):
            (match / inner / file.name.replace("17_", "18_")).write_bytes(file.read_bytes())
    for name, camera in three_views.CAMERAS.items():
        for instant, place in (("17", (3.0, -30.0, -2.0)), ("18", (6.0, -28.0, -1.0))):
            px = camera.project(np.array([place]))[0][0]
            point = {"x": px[0] / 959, "y": px[1] / 539}
            edit(match, name.replace("17", instant), Ball=[point])
    ungrouped = cli("triangulate", match, "--cameras", match / "cameras", "--moving", "Ball")
    assert "no views.csv states when" in " ".join(ungrouped.stdout.split())
    rows = "".join(f"{name},17\n" for name in ("17_left", "17_close", "17_rihgt"))
    (match / "views.csv").write_text(f"frame,instant\n{rows}")
    partly = cli("triangulate", match, "--cameras", match / "cameras", "--moving", "Ball")
    said = " ".join(partly.stdout.replace("│", " ").split())
    assert "views.csv does not state when 17_right and 3 more" in said
    assert "views.csv: line 4: there is neither a picture nor an annotation of '17_rihgt'" in (
        " ".join(partly.stderr.split())
    )
    (match / "views.csv").unlink()
    (match / "landmarks.json").unlink()
    cli(
        "triangulate", match, "--cameras", match / "cameras", "--moving", "Ball",
        "--pattern", "{instant}_{view}",
    )  # fmt: skip
    balls = {m.instant: m for m in load_landmarks(match / "landmarks.json").landmarks
             if m.name == "Ball"}  # fmt: skip
    assert balls[None].moving
    assert balls[None].position is None
    assert np.allclose(balls["17"].position, (3.0, -30.0, -2.0), atol=1e-3)
    assert np.allclose(balls["18"].position, (6.0, -28.0, -1.0), atol=1e-3)
    # Each frame is scored with the ball where it was then.
    cli("evaluate", match / "annotations", match / "cameras", "--protocol", "procc", "-o", "s.json")
    per_class = json.loads(Path("s.json").read_text())["summary"]["5"]["per_class"]
    assert (per_class["Ball"]["tp"], per_class["Ball"]["fp"], per_class["Ball"]["fn"]) == (6, 0, 0)
    cli("calibrate", match, "fitted", "--protocol", "procc")
    # It is known to move from now on, and views.csv tells when.
    again = cli("triangulate", match, "--cameras", match / "cameras")
    assert len(re.findall(r"│ Ball +│ 1[78]", again.stdout)) == 2


def test_a_static_landmark_can_be_made_a_moving_one(cli, match):
    cli("triangulate", match, "--cameras", match / "cameras", "--pattern", "{instant}_{view}")
    cli("triangulate", match, "--cameras", match / "cameras", "--moving", "Mast")
    masts = [m for m in load_landmarks(match / "landmarks.json").landmarks if m.name == "Mast"]
    assert [(m.instant, m.position is None) for m in masts] == [(None, True), ("17", False)]


def test_reasons_are_told_where_there_is_no_position(cli, match):
    one = {"Clock": None, "Seat A": None, "Seat B": [{"x": 0.2, "y": 0.2}]}
    edit(match, "17_left", **one)
    edit(match, "17_close", **one)
    edit(match, "17_right", **{"Seat A": [{"x": 0.1, "y": 0.1}, {"x": 0.2, "y": 0.2}]})
    done = cli("triangulate", match, "--cameras", match / "cameras")
    said = " ".join(done.stdout.replace("│", " ").split())
    assert "clicked in one view only" in said
    assert "a landmark is one click, this has up to 2 points" in said
    assert "do not agree" in said
    assert set(positions(match / "landmarks.json")) == {"Board", "Mast", "Tunnel"}


def test_output_leaves_the_dataset_as_it_was(cli, match, tmp_path):
    done = cli("triangulate", match, "-o", "found.json", "--pattern", "{instant}_{view}")
    assert len(positions(Path("found.json"))) == 6
    assert "views.csv was not written" in done.stderr
    assert not (match / "landmarks.json").exists()
    assert not (match / "views.csv").exists()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--model", "H"], "a homography has no position in space"),
        (["--click-sd", "0"], "must be a positive number"),
        (["--surveyed", "Clock"], "expected NAME=X,Y,Z"),
        (["--surveyed", "Clock=1,2"], "is no place: write x, y, z"),
        (["--surveyed", "Clock=1,2,9e9"], "at most 1000"),
        (["--surveyed", "=1,2,3"], "names no landmark"),
        (["--pattern", "{view}"], "names no instant"),
        (["--pattern", "{instant}", "--views", "v.csv"], "choose one"),
        (["--views", "v.csv"], "does not exist"),
        (["--cameras", "nowhere"], "does not exist"),
        (["-o", "landmarks.csv"], "are written as .json"),
        (["--surveyed", "Middle line=1,2,3"], "is a class of the field"),
        (["--moving", "Middle line"], "is a class of the field"),
        (["--surveyed", "Clock=1,2,3", "--surveyed", "Clock=1,2,4"], "has a place already"),
        (["--surveyed", "Clock=1,2,3", "--moving", "Clock"], "says where it stays"),
    ],
)
def test_what_makes_no_sense_is_refused(cli, match, arguments, words):
    done = cli("triangulate", match, *arguments, code=2)
    assert words in " ".join(done.stderr.split())
    assert not (match / "landmarks.json").exists()


@pytest.mark.parametrize(
    "entries",
    [
        [{"name": "Ball", "moving": True}],
        [{"name": "Ball", "moving": True, "position": [1, 2, -1], "instant": "17"}],
    ],
)
def test_what_moves_has_no_lasting_place(cli, match, entries):
    path = match / "landmarks.json"
    path.write_text(json.dumps({"landmarks": entries}))
    before = path.read_bytes()
    done = cli("triangulate", match, "--surveyed", "Ball=5,5,-1", code=2)
    assert "Ball moves: its positions hold for an instant each" in " ".join(done.stderr.split())
    assert path.read_bytes() == before


def test_a_surveyed_place_is_compared_to_its_clicks(cli, match):
    def surveyed(place: str) -> tuple[float, str, str]:
        done = cli("triangulate", match, "--cameras", match / "cameras",
                   "--surveyed", f"Clock={place}", "--moving", "Mas")  # fmt: skip
        row = next(line for line in done.stdout.splitlines() if "Clock" in line)
        *_, off_px, remark, _ = row.split("│")
        return float(off_px), remark, " ".join(done.stderr.split())

    off_px, remark, said = surveyed("12,-52,-11")
    assert off_px < 4
    assert remark.strip() == "surveyed: kept as it is"
    assert "elsewhere" not in said
    assert "--moving Mas: it is clicked in no frame; did you mean 'Mast'?" in said
    off_px, remark, said = surveyed("12,-52,-12")
    assert off_px > 20  # the close-up shows a metre as 27 px
    assert "the clicks do" in remark  # not agree: the table is as narrow as the terminal
    assert "Clock was surveyed, but its clicks are elsewhere: 27 px off in 17_close" in said
    assert positions(match / "landmarks.json")["Clock"].tolist() == [12.0, -52.0, -12.0]


def test_classes_of_another_field_do_not_become_landmarks(cli, tmp_path):
    match = tmp_path / "match"
    shutil.copytree(ROOT / "sample_data/basketball", match)
    done = cli("triangulate", match, "--field", "soccer", "--cameras", match / "cameras", code=2)
    said = " ".join(done.stderr.split())
    assert "knows all" in said
    assert "--field" in said
    assert "nothing was triangulated" in said
    assert not (match / "landmarks.json").exists()


def test_an_entry_that_locks_the_field_is_named(cli, match):
    entries = [{"name": "Clock"}, {"name": "Middle line", "position": [1, 2, 3]}]
    (match / "landmarks.json").write_text(json.dumps({"landmarks": entries}))
    done = cli("evaluate", match, match / "cameras", code=2)
    said = " ".join(done.stderr.split())
    assert "landmarks.json: landmarks[1].name: the landmark 'Middle line' has the name" in said
    assert "delete the entry" in said


def test_places_can_be_surveyed_before_anything_is_clicked(cli, tmp_path):
    done = cli("triangulate", tmp_path, "--surveyed", "Flag A=52,-34,0")
    assert positions(tmp_path / "landmarks.json")["Flag A"].tolist() == [52.0, -34.0, 0.0]
    assert "--surveyed Flag A: it is clicked in no frame" in done.stderr


def test_a_set_without_landmarks_has_nothing_to_do(cli, dataset):
    done = cli("triangulate", dataset.root, code=2)
    assert "no landmark is clicked" in done.stderr


def test_cameras_of_other_frames_leave_everything_as_it_is(cli, match):
    cli("triangulate", match)
    written = (match / "landmarks.json").read_bytes()
    cli("calibrate", match, "fitted")
    for path in Path("fitted").glob("camera_*.json"):
        path.rename(path.with_name(f"camera_other{path.stem}.json"))
    with open("fitted/cameras.jsonl", "w") as file:  # two good records and a cut one
        for frame in ("a", "b"):
            record = json.loads(next(Path("fitted").glob("camera_*.json")).read_text())
            file.write(json.dumps({"image_ids": f"{frame}.jpg", **record}) + "\n")
        file.write('{"image_ids": "c.jp')
    for cameras in ("fitted/cameras.jsonl", "fitted"):
        done = cli("triangulate", match, "--cameras", cameras, code=2)
        assert "no camera has the name of a frame with a landmark" in done.stderr
        assert "note: " in done.stderr  # the cut record; and the file beside other cameras
        assert "written" not in done.stdout
        assert (match / "landmarks.json").read_bytes() == written
