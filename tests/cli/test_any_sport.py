"""Commands over made-up datasets of other sports: what is told of soccer is told of them."""

import json
from pathlib import Path

import cv2
import numpy as np
import pytest

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup
from tests.cli.conftest import SIZE, Dataset, camera_file

pytestmark = pytest.mark.usefixtures("qapp")

SPORTS = ("basketball_fiba", "ice_hockey_iihf", "volleyball", "athletics")
PANS = {"1": -24.0, "2": 0.0, "3": 20.0}


def changes_of(field: Field) -> dict[str, object]:
    """A camera on the near side that has about half of the field in its picture."""
    away = field.dimension("width").value
    far = field.dimension("length").value
    return {
        "position_meters": [0.0, 0.5 * away + 0.4 * far, -0.25 * far],
        "tilt_degrees": 68.0,
        "x_focal_length": 900.0,
        "y_focal_length": 900.0,
    }


def clicks_of(field: Field, camera: PinholeCamera) -> dict[str, list[dict[str, float]]]:
    """Exact points along everything the camera shows; a spot has one, a chain ends of its parts."""
    shown = project_field(camera, EvaluationSetup(field, SIZE, "procc")).pieces
    found = {}
    for name, pieces in shown.items():
        element = field.element(name)
        if element.is_spot:
            points = pieces[0][:1]
        else:
            longest = max(pieces, key=length_of)
            if length_of(longest) < 25:
                continue
            many = 9 if element.is_curved else 3
            points = longest[np.linspace(0, len(longest) - 1, many).round().astype(int)]
        found[name] = [{"x": float(x) / 959, "y": float(y) / 539} for x, y in points]
    return found


def length_of(piece: np.ndarray) -> float:
    return float(np.hypot(*np.diff(piece, axis=0).T).sum())


@pytest.fixture(
    params=[*SPORTS[:2], *(pytest.param(name, marks=pytest.mark.soak) for name in SPORTS[2:])]
)
def sport(request, tmp_path) -> tuple[Dataset, Field]:
    field = load_field(request.param)
    made = Dataset(tmp_path / "match")
    made.annotations.mkdir(parents=True)
    made.cameras.mkdir()
    changes = changes_of(field)
    for name, pan in PANS.items():
        cv2.imwrite(str(made.root / f"{name}.jpg"), np.full((SIZE[1], SIZE[0], 3), 90, np.uint8))
        made.write_camera(name, camera_file(pan, **changes))
        camera = PinholeCamera(
            np.deg2rad(pan), np.deg2rad(68.0), 0.0, tuple(changes["position_meters"]),
            (900.0, 900.0), (479.5, 269.5),
        )  # fmt: skip
        clicks = clicks_of(field, camera)
        assert len(clicks) > 4
        (made.annotations / f"{name}.json").write_text(json.dumps(clicks))
    return made, field


@pytest.fixture
def moved(sport) -> Path:
    """The dataset's cameras, each half a metre aside along the ground."""
    dataset, field = sport
    folder = dataset.root / "moved"
    folder.mkdir()
    changes = changes_of(field)
    x, y, z = changes["position_meters"]
    for name, pan in PANS.items():
        aside = camera_file(pan, **changes | {"position_meters": [x + 0.3, y - 0.4, z]})
        (folder / f"camera_{name}.json").write_text(json.dumps(aside))
    return folder


def speaks_of_soccer(text: str) -> bool:
    return any(word in text.lower() for word in ("soccer ", "penalty area", "big rect"))


@pytest.mark.parametrize("protocol", ["soccernet", "procc"])
def test_true_cameras_score_full_marks(cli, sport, protocol):
    dataset, field = sport
    done = cli(
        "evaluate", *dataset.set_arguments, "--field", field.name, "--protocol", protocol, "-t", 2
    )
    assert "100.00" in done.stdout
    assert not speaks_of_soccer(done.output)


def test_comparisons_reports_and_pictures(cli, sport, moved, tmp_path):
    dataset, field = sport
    own = ("--field", field.name)
    compared = tmp_path / "compared.json"
    sets = (f"true={dataset.cameras}", f"moved={moved}")
    cli("compare", *sets, dataset.root, *own, "-o", compared)
    length, width = (field.dimension(name).value for name in ("length", "width"))
    common = (length - 0.3) * (width - 0.4)
    for image in json.loads(compared.read_text())["images"]:
        assert image["metres"]["median"] == pytest.approx(0.5, abs=1e-6)
        iou = image["legacy"]["iou_whole"]  # over the field of play of whatever sport
        assert iou == pytest.approx(common / (2 * length * width - common), abs=1e-6)
    page, table = tmp_path / "report.html", tmp_path / "report.tex"
    given = [part for one in sets for part in ("--cameras", one)]
    cheap = ("--worst", 1, "--random", 0, "--date", "2024-06-01")
    cli("report", dataset.root, *given, *own, *cheap, "-o", page, "-o", table)
    assert field.name in page.read_text()
    assert not speaks_of_soccer(page.read_text() + table.read_text())
    pictures = tmp_path / "pictures"
    cli("render", dataset.root, pictures, "--cameras", dataset.cameras, *own)
    assert len(list(pictures.glob("*.png"))) == len(PANS)


def test_labels_are_checked_and_exchanged_ones_are_found(cli, sport, tmp_path):
    dataset, field = sport
    own = ("--field", field.name)
    cli("check", dataset.root, *own, "--fail-on", "warning")
    file = dataset.annotations / "2.json"
    clicks = json.loads(file.read_text())
    straight = [n for n in clicks if field.element(n).is_straight and field.element(n).on_ground]
    one, other = straight[0], straight[-1]
    clicks[one], clicks[other] = clicks[other], clicks[one]
    file.write_text(json.dumps(clicks))
    found = tmp_path / "found.json"
    cli(
        "check",
        dataset.root,
        *own,
        "-o",
        found,
        "--fail-on",
        "error",
        "--min-severity",
        "error",
        code=1,
    )
    named = json.dumps(json.loads(found.read_text()))
    assert one in named
    assert other in named


def test_annotations_go_through_other_formats_and_back(cli, sport, tmp_path):
    """Spots and optional elements among them: other sports lose nothing in files of SoccerNet's
    form."""
    dataset, field = sport
    own = ("--field", field.name, "--size", "960x540")
    before = {f.name: json.loads(f.read_text()) for f in dataset.annotations.glob("*.json")}
    for name in ("labelme", "cvat", "coco"):
        out, back = tmp_path / f"{name}.zip", tmp_path / name
        for source, target, to in ((dataset.root, out, name), (out, back, "soccernet")):
            done = cli("convert", source, target, "--to", to, *own)
            assert "is left out" not in done.output
        after = {f.name: json.loads(f.read_text()) for f in back.glob("*.json")}
        assert after == before
    done = cli("convert", dataset.root, tmp_path / "v3.json", "--to", "soccernet-v3", *own, code=2)
    assert f"the field is {field.title}" in done.output


def test_soccer_leaves_optional_elements_out_of_files_of_soccernet(cli, dataset, tmp_path):
    file = dataset.annotations / "1.json"
    clicks = json.loads(file.read_text())
    (mark,) = [e for e in load_field("soccer").elements if e.title == "Left penalty mark"]
    file.write_text(json.dumps(clicks | {mark.name: [{"x": 0.5, "y": 0.5}]}))
    for to in ("soccernet", "soccernet-gsr"):
        for more, kept in (((), False), (("--keep-optional",), True)):
            out = tmp_path / f"{to}{kept}.zip"
            done = cli("convert", dataset.root, out, "--to", to, *more)
            assert ("Left penalty mark is left out" in done.output) != kept
            back = tmp_path / f"{to}{kept}"
            cli("convert", out, back, "--to", "soccernet", "--keep-optional")
            assert (mark.name in json.loads((back / "1.json").read_text())) == kept
    done = cli("export", dataset.root, tmp_path / "exported")
    assert "note: Left penalty mark is left out: SoccerNet has no such class (1 frame)" in (
        done.output
    )
    assert json.loads((tmp_path / "exported" / "1.json").read_text()) == clicks
