"""``procc-annotator propose``: what becomes of proposals, whoever makes them."""

import json
import shutil
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from procc_annotator import fit_camera, load_annotation
from procc_annotator.batch.unit_store import only_run
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.proposal import KnownPosition, Proposal, ProposalState
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.geometry import Line
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.packed import read_packed
from tests.cli.conftest import PANS, SIZE, Dataset, rows_in, write_dataset
from tests.drawn_shots import draw, looking_at, stage_of

NAMES = ["1", "2", "3", "10", "11"]
POSITION = (0.0, 60.0, -14.0)


def proposal(fit: FitResult, state: ProposalState, reason: str = "the paint says so") -> Proposal:
    return Proposal(state, reason, fit, 0.91, 0.84, 0.4, 0.3, None)


@dataclass
class Pretended:
    """Stands in for the search in a picture: says of each frame what it is told, in their order.

    Attributes:
        said: what it says of the frames, first look and second one after the other.
        known: what it was told of positions each time.
    """

    said: list[Proposal | KeyboardInterrupt]
    known: list[tuple[KnownPosition, ...]] = field(default_factory=list)

    def __call__(
        self, picture: np.ndarray, field: Field, *, known: Iterable[KnownPosition], **_: object
    ) -> Proposal:
        assert picture.shape[2] == 4
        self.known.append(tuple(known))
        said = self.said[len(self.known) - 1]
        if isinstance(said, KeyboardInterrupt):
            raise said
        return said


def test_a_set_of_squeezed_pictures_has_cameras_with_wide_pixels(cli, tmp_path):
    """Each picture alone suits square pixels nearly as well, with another camera."""
    (tmp_path / "match").mkdir()
    for number, x in enumerate((-36.0, -12.0, 20.0, 38.0)):
        camera = looking_at((2.0, 66.0, -16.0), (x, -3.0, 0.0), 1500.0)
        picture = draw(stage_of("soccer"), camera, seed=number + 1)
        squeezed = cv2.resize(picture, (640, 640), interpolation=cv2.INTER_AREA)
        cv2.imwrite(str(tmp_path / "match" / f"{number}.png"), squeezed[..., :3])
    done = cli("propose", tmp_path / "match", tmp_path / "out", "--workers", "1")
    assert "pixels are 1.778 times as wide as high" in done.stdout
    rows = rows_in(tmp_path / "out" / "proposals.csv")
    assert [row["state"] for row in rows] == ["sure"] * 4
    for row in rows:
        found = json.loads((tmp_path / "out" / row["camera"]).read_text())
        assert found["y_focal_length"] / found["x_focal_length"] == pytest.approx(16 / 9, rel=1e-3)
        assert found["position_meters"] == pytest.approx([2, 66, -16], abs=2)


@pytest.fixture(scope="module")
def fits(tmp_path_factory) -> dict[str, FitResult]:
    """What a fit to its points says of every frame."""
    made = write_dataset(tmp_path_factory.mktemp("fits") / "match")
    return {
        name: fit_camera(load_annotation(made.annotations / f"{name}.json"), size=SIZE)
        for name in PANS
    }


@pytest.fixture
def bare(dataset) -> Dataset:
    """Nobody has annotated anything."""
    for path in dataset.annotations.iterdir():
        path.unlink()
    return dataset


@pytest.fixture
def pretend(monkeypatch):
    def made(said: list[Proposal | KeyboardInterrupt]) -> Pretended:
        found = Pretended(said)
        monkeypatch.setattr("procc_annotator.cli.propose.propose_camera", found)
        return found

    return made


def none() -> Proposal:
    why = "no paint of this field was found"
    failed = FitResult("R", SIZE, None, why)
    return replace(proposal(failed, "none", why), coverage=0.0, residual_px=None)


def table(out: Path) -> dict[str, dict[str, str]]:
    return {row["frame"]: row for row in rows_in(out / "proposals.csv")}


def files(out: Path) -> list[str]:
    return sorted(str(path.relative_to(out)) for path in out.rglob("*") if path.is_file())


def test_sure_cameras_unsure_ones_and_none(cli, bare, pretend, fits, tmp_path):
    said = [proposal(fits["1"], "sure"), proposal(fits["2"], "unsure", "-too little in sight")]
    pretend([*said, none(), none(), none()])
    out = tmp_path / "out"
    done = cli("propose", bare.root, out)
    assert "1 sure, 1 unsure, 3 none" in done.stdout
    assert "too little in sight" in done.stdout
    assert files(out) == ["camera_1.json", "proposals.csv", "unsure/camera_2.json"]
    camera = json.loads((out / "camera_1.json").read_text())
    assert (camera["image_width"], camera["image_height"]) == SIZE
    assert camera["pan_degrees"] == pytest.approx(PANS["1"], abs=0.01)
    rows = table(out)
    assert list(rows) == NAMES
    assert [row["state"] for row in rows.values()] == ["sure", "unsure", "none", "none", "none"]
    assert rows["1"]["coverage"] == "0.91"
    assert float(rows["1"]["sd_pan_degrees"]) > 0
    assert rows["2"]["reason"] == "'-too little in sight"
    assert (rows["2"]["camera"], rows["3"]["camera"]) == ("unsure/camera_2.json", "")
    assert (rows["3"]["residual_px"], rows["3"]["sd_x_m"]) == ("", "")


def test_annotated_frames_are_passed_over(cli, dataset, pretend, fits, tmp_path):
    (dataset.annotations / "3.json").unlink()
    (dataset.annotations / "10.json").write_text("{}")
    pretend([proposal(fits["3"], "sure"), none()])
    done = cli("propose", dataset.root, tmp_path / "out")
    assert "passed over: 3 annotated frames (--all)" in done.stdout
    assert list(table(tmp_path / "out")) == ["3", "10"]
    pretend([none()] * 5)
    cli("propose", dataset.root, tmp_path / "all", "--all")
    assert list(table(tmp_path / "all")) == NAMES


def test_a_damaged_annotation_is_named_and_its_frame_passed_over(
    cli, bare, pretend, fits, tmp_path
):
    (bare.annotations / "2.json").write_text("{")
    pretend([proposal(fits[name], "sure") for name in NAMES if name != "2"])
    done = cli("propose", bare.root, tmp_path / "out", code=1)
    assert "passed over: 1 frame whose annotation cannot be read (--all)" in done.stdout
    assert "2.json" in done.stderr
    assert "2" not in table(tmp_path / "out")


def test_sure_frames_tell_the_others_where_the_camera_stands(cli, bare, pretend, fits, tmp_path):
    first = [proposal(fits[name], "sure") for name in NAMES[:3]]
    first += [proposal(fits["10"], "unsure"), none()]
    finder = pretend([*first, proposal(fits["10"], "sure"), none()])
    out = tmp_path / "out"
    done = cli("propose", bare.root, out)
    assert finder.known[:5] == [()] * 5
    for known in finder.known[5:]:
        (position,) = known
        assert position.position_m == pytest.approx(POSITION, abs=0.5)
        assert position.usual is not None
    assert "frames agree on 1 position" in done.stdout
    assert "with that 1 more frame is sure" in done.stdout
    assert files(out) == [f"camera_{n}.json" for n in ("1", "10", "2", "3")] + ["proposals.csv"]
    rows = table(out)
    assert [rows[n]["known_position"] for n in NAMES] == ["false"] * 3 + ["true", "false"]


def test_matches_do_not_tell_each_other_where_cameras_stand(cli, bare, pretend, fits, tmp_path):
    """Each folder of a tree is a match, of another stadium for all that is known."""
    season = tmp_path / "season"
    for match in ("1", "2"):
        shutil.copytree(bare.root, season / match)
    first = [proposal(fits[name], "sure") for name in NAMES[:3]] + [none()] * 2
    finder = pretend([*first, *[none()] * 5, *[none()] * 2])
    cli("propose", season, tmp_path / "out", "--workers", 1)
    assert [len(known) for known in finder.known] == [0] * 10 + [1] * 2


def test_a_season_has_one_file_of_cameras_a_match(cli, bare, pretend, fits, tmp_path):
    """The sure ones, which commands read, and the others apart."""
    out, listed = tmp_path / "out", tmp_path / "season.csv"
    for match in ("a", "b/c"):
        shutil.copytree(bare.root, tmp_path / match)
    listed.write_text("video,match\na,a\nb/c,b/c\n")
    seen = [proposal(fits["1"], "sure"), proposal(fits["2"], "unsure")]
    pretend([*seen, KeyboardInterrupt()])
    cli("propose", listed, out, code=130)
    assert not list(out.rglob("*.npz"))
    with only_run(out):
        for how in ((), ("--resume",), ("--overwrite",)):
            assert "another run writes there" in cli("propose", listed, out, *how, code=2).stderr
    pretend([*[none()] * 3, *seen, *[none()] * 3])
    cli("propose", listed, out, "--resume")
    made = [f"{name}{end}" for name in ("a", "b/c") for end in (".npz", "/proposals.csv")]
    assert files(out) == sorted([*made, "unsure/a.npz", "unsure/b/c.npz"])
    sure = CameraCollection.open(out)
    assert list(sure.frames) == ["a/1", "b/c/1"]
    assert sure.read("a/1").camera.position_world == fits["1"].camera.position_world
    assert list(CameraCollection.open(out / "unsure").frames) == ["a/2", "b/c/2"]
    found = read_packed((out / "b" / "c.npz").read_bytes(), "c.npz")
    assert (found.frame, found.state) == (("1",), ("sure",))
    unsure = read_packed((out / "unsure" / "a.npz").read_bytes(), "a.npz")
    assert (unsure.frame, unsure.state) == (("2",), ("unsure",))
    assert "holds cameras" in cli("propose", listed, out, code=1).stderr


@pytest.mark.parametrize("given", ["cameras", "positions"])
def test_known_positions(cli, bare, pretend, tmp_path, given):
    known = bare.cameras
    if given == "positions":
        known = tmp_path / "positions.csv"
        known.write_text("position,x_m,y_m,z_m,sd_x_m,sd_y_m,sd_z_m\na,0,60,-14,.1,.2,.1\n")
    finder = pretend([none()] * 5)
    cli("propose", bare.root, tmp_path / "out", "--known-positions", known)
    for told in finder.known:
        (position,) = told
        assert position.position_m == pytest.approx(POSITION)
        assert (np.linalg.eigvalsh(position.covariance) > 0).all()


def test_positions_that_cannot_be_read(cli, bare, pretend, tmp_path):
    finder = pretend([])
    table_file = tmp_path / "positions.csv"
    for text, said in (
        ("a,b\n1,2\n", "has no column 'x_m'"),
        ("x_m,y_m,z_m,sd_x_m,sd_y_m,sd_z_m\n1,2,here,1,1,1\n", "line 2: expected numbers"),
        ("x_m,y_m,z_m,sd_x_m,sd_y_m,sd_z_m\n", "holds no position"),
    ):
        table_file.write_text(text)
        done = cli("propose", bare.root, tmp_path / "out", "--known-positions", table_file, code=2)
        assert said in done.stderr
    np.save(tmp_path / "1.npy", np.eye(3))
    done = cli(
        "propose", bare.root, tmp_path / "out", "--known-positions", tmp_path / "1.npy", code=2
    )
    assert "holds no camera with a position" in done.stderr
    assert not finder.known


def test_what_cannot_be_read_is_listed_and_the_rest_goes_on(cli, bare, pretend, tmp_path):
    (bare.root / "2.jpg").write_bytes(b"no picture")
    pretend([none()] * 4)
    done = cli("propose", bare.root, tmp_path / "out", code=1)
    assert "0 sure, 0 unsure, 4 none" in done.stdout
    assert done.stderr.startswith("unreadable: ")
    assert table(tmp_path / "out")["2"]["state"] == "unreadable"


def test_nothing_is_replaced_that_nobody_asked_to_replace(cli, bare, pretend, fits, tmp_path):
    out = tmp_path / "out"
    pretend([proposal(fits["1"], "sure"), *[none()] * 4])
    cli("propose", bare.root, out)
    pretend([none()] * 5)
    done = cli("propose", bare.root, out, code=2)
    assert "--overwrite to replace them" in done.stderr
    done = cli("propose", bare.root, out, "--overwrite")
    assert files(out) == ["proposals.csv"]  # what was sure before is none now


def test_cameras_in_folders_of_out_are_not_replaced_either(cli, bare, pretend, tmp_path):
    match = tmp_path / "halves"
    for half in ("1", "2"):
        shutil.copytree(bare.root, match / half)
    pretend([none()] * 10)
    for place in ("1/camera_1.json", "unsure/2/camera_1.json"):
        out = tmp_path / place.replace("/", "_")
        theirs = out / place
        theirs.parent.mkdir(parents=True)
        theirs.write_text("{}")
        done = cli("propose", match, out, code=2)
        assert "--overwrite to replace them" in done.stderr
        assert theirs.read_text() == "{}"


def test_an_interrupted_run_says_what_is_there_and_goes_on(cli, bare, monkeypatch, fits, tmp_path):
    calls = []

    def stopped(picture, field, *, known, **_):
        calls.append(picture)
        if len(calls) == 3:
            raise KeyboardInterrupt
        return proposal(fits["1"], "sure")

    monkeypatch.setattr("procc_annotator.cli.propose.propose_camera", stopped)
    done = cli("propose", bare.root, tmp_path / "out", code=130)
    assert "interrupted: 2 sure cameras of 5 frames written" in done.stderr
    assert "again with --resume" in done.stderr
    cameras = ["camera_1.json", "camera_2.json"]
    assert files(tmp_path / "out") == [".propose.unfinished", *cameras]
    assert "--resume goes on with it" in cli("propose", bare.root, tmp_path / "out", code=2).stderr
    done = cli("propose", bare.root, tmp_path / "out", "--resume")
    assert len(calls) == 3 + 3  # two were kept
    again = cli("propose", bare.root, tmp_path / "out", "--resume")
    assert "already complete: proposals.csv is there" in again.stdout
    cli("propose", bare.root, tmp_path / "one")
    assert files(tmp_path / "out") == files(tmp_path / "one")
    for file in (tmp_path / "one").glob("camera_*"):
        assert (tmp_path / "out" / file.name).read_bytes() == file.read_bytes()


# ``propose-map``: what labels may stand for, by name and by geometry.

REAL = Path(__file__).resolve().parents[3] / "shared" / "data" / "foreign"


def as_labelme(cli, dataset, folder: Path, label_of) -> None:
    """The dataset with other labels; those that become None are left out."""
    cli("convert", dataset.root, folder, "--to", "labelme")
    for file in folder.glob("*.json"):
        content = json.loads(file.read_text())
        for shape in content["shapes"]:
            shape["label"] = label_of(shape["label"].strip())
        file.write_text(json.dumps(content))


def test_labels_that_say_nothing_are_told_by_cameras(cli, dataset, tmp_path):
    names = [e.name.strip() for e in load_field(None).elements]
    as_labelme(cli, dataset, tmp_path / "set", lambda name: f"x{names.index(name)}")
    cameras, labels = dataset.cameras, tmp_path / "labels.toml"
    done = cli("propose-map", tmp_path / "set", "--cameras", cameras, "-o", labels, code=None)
    assert done.exit_code in (0, 1), done.stderr
    assert "by geometry alone" in done.stdout
    lines = [line for line in labels.read_text().splitlines() if line.startswith('"x')]
    assert len(lines) >= 10
    for line in lines:
        label, name = (part.strip('"') for part in line.split(" = "))
        assert names[int(label[1:])] == name
    cli("check", tmp_path / "set", "--map", labels, "--no-line-evidence")


def test_labels_that_are_called_alike_need_no_camera(cli, dataset, tmp_path):
    def label(name: str) -> str:
        found = name.replace("Big rect.", "penalty area").replace("Middle line", "halfway-line")
        return found.replace("Side line", "touchline").replace("Circle", "circles").lower()

    as_labelme(cli, dataset, tmp_path / "set", label)
    labels = tmp_path / "labels.toml"
    done = cli("propose-map", tmp_path / "set", "-o", labels, code=None)
    assert done.exit_code in (0, 1), done.stderr
    text = labels.read_text()
    assert '"halfway-line" = "Middle line"' in text
    assert '"penalty area left main" = "Big rect. left main"' in text
    cli("evaluate", dataset.annotations, dataset.cameras, "-o", tmp_path / "own.json")
    cli("evaluate", tmp_path / "set", dataset.cameras, "--map", labels, "-o", tmp_path / "s.json")
    scores = [
        json.loads((tmp_path / name).read_text())["summary"] for name in ("own.json", "s.json")
    ]
    assert scores[0] == scores[1]


def tennis_frame(number: int) -> dict[str, object]:
    """Seen from behind a baseline, its labels shared by pairs of lines and in any order."""
    field = load_field("tennis")
    camera = PinholeCamera(
        position_world=(24.0, 0.5 * number, -9.0 - number), pan_rad=np.radians(-90 + number),
        tilt_rad=np.radians(68), roll_rad=0.0, focal_px=(1000.0, 1000.0),
        principal_point_px=(480.0, 270.0),
    )  # fmt: skip
    shared = {
        "Baseline": "baseline", "Doubles sideline": "sideline-doubles",
        "Singles sideline": "sideline-singles", "Service line": "service-line",
    }  # fmt: skip
    shapes = []
    for element in field.elements:
        key = next((k for k in shared if element.name.startswith(k)), None)
        label = "service-centerline" if element.name == "Centre service line" else shared.get(key)
        if label is not None:
            ends = np.array([element.geometry.start, element.geometry.end])
            px, _ = camera.project(ends)
            shapes.append({"label": label, "points": px.tolist(), "shape_type": "linestrip"})
    rng = np.random.default_rng(number)
    shapes = [shapes[i] for i in rng.permutation(len(shapes))]
    return {"shapes": shapes, "imageWidth": 960, "imageHeight": 540, "imagePath": f"{number}.jpg"}


def test_lines_that_share_a_label_are_put_in_order(cli, tmp_path):
    folder = tmp_path / "tennis"
    folder.mkdir()
    for number in range(4):
        (folder / f"{number}.json").write_text(json.dumps(tennis_frame(number)))
    labels = folder / "labels.toml"
    done = cli("propose-map", folder, "--field", "tennis", "-o", labels)
    assert done.stdout.count("sure") == 5
    text = labels.read_text()
    assert '"baseline" = { top_down = ["Baseline left", "Baseline right"] }' in text
    assert "left_to_right" in text
    found = cli("calibrate", folder, tmp_path / "cameras", "--field", "tennis", "-t", "2")
    assert "4 cameras" in found.stdout


def test_names_of_another_sport_are_told(cli, tmp_path):
    (tmp_path / "0.json").write_text(json.dumps(tennis_frame(0)))
    done = cli("propose-map", tmp_path / "0.json", "-o", tmp_path / "labels.toml")
    assert "--field tennis" in done.stderr
    assert "open" in done.stdout
    again = cli("propose-map", tmp_path / "0.json", "-o", tmp_path / "labels.toml", code=2)
    assert "exists already" in again.stderr


def test_what_was_left_out_is_told_where_there_is_nothing_to_propose(cli, tmp_path):
    content = {
        "images": [{"id": 1, "width": 640, "height": 360, "file_name": "a.jpg"}],
        "annotations": [
            {"id": 1, "image_id": 1, "category_id": 1, "keypoints": [0, 0, 0, 5, 5, 2] * 16}
        ],
        "categories": [{"id": 1, "name": "pitch", "keypoints": [str(i) for i in range(32)]}],
    }
    (tmp_path / "k.json").write_text(json.dumps(content))
    done = cli("propose-map", tmp_path / "k.json", "-o", tmp_path / "labels.toml", code=2)
    assert '"pitch" = { template = "soccer_32" }' in done.stderr
    assert not (tmp_path / "labels.toml").exists()


@pytest.mark.skipif(not REAL.is_dir(), reason="the real files are not here")
@pytest.mark.parametrize("name", ["test", "training"])
def test_a_public_tennis_set(cli, tmp_path, name):
    labels = tmp_path / "labels.toml"
    source = REAL / f"tennis_cvat_{name}.xml"
    done = cli("propose-map", source, "--field", "tennis", "-o", labels)
    assert done.stdout.count("sure ") == 5
    text = labels.read_text()
    assert '"service-line" = { top_down = ["Service line left", "Service line right"] }' in text
    assert '"service-centerline" = "Centre service line"' in text


def test_a_field_without_straight_lines(cli, dataset, tmp_path, monkeypatch):
    field = load_field(None)
    round_ones = tuple(e for e in field.elements if not isinstance(e.geometry, Line))
    as_labelme(cli, dataset, tmp_path / "set", str.lower)
    rings = replace(field, elements=round_ones, symmetries=())
    monkeypatch.setattr("procc_annotator.cli.propose_map.chosen_field", lambda *_: rings)
    done = cli("propose-map", tmp_path / "set", "-o", tmp_path / "labels.toml", code=None)
    assert done.exit_code in (0, 1), done.stderr
    assert '"circle central" = "Circle central"' in (tmp_path / "labels.toml").read_text()
