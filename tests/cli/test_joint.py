"""Frames fitted together from the command line: shared positions, and the size of a field."""

import json
import zipfile
from pathlib import Path

import numpy as np
import pytest
from typer.testing import Result

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.dataset_field import (
    DIMENSIONS_SETTING,
    field_of_dataset,
    store_dimensions,
)
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup
from tests.cli.conftest import rows_in

SIZE = (960, 540)
PLACES = {"a": (1.0, 66.0, -15.0), "b": (-2.0, 80.0, -11.0)}


def write_annotations(folder: Path, field: Field, frames: int = 6) -> None:
    """So many frames from each of two places, clicked to half a pixel."""
    rng = np.random.default_rng(0)
    folder.mkdir(parents=True)
    for place, position in PLACES.items():
        for i, pan in enumerate(np.linspace(-28, 28, frames)):
            tilt = np.arctan2(np.hypot(position[1], 60 * np.tan(np.deg2rad(pan))), -position[2])
            camera = PinholeCamera(
                np.deg2rad(pan), float(tilt), 0.0, position, (1500.0, 1500.0), (479.5, 269.5)
            )
            pieces = project_field(camera, EvaluationSetup(field, SIZE)).pieces
            content = {}
            for name, (piece, *_) in pieces.items():
                px = piece[np.linspace(0, len(piece) - 1, 5).round().astype(int)]
                px = px + rng.normal(0, 0.5, px.shape)
                content[name] = [{"x": x / 959, "y": y / 539} for x, y in px.tolist()]
            (folder / f"{place}{i}.json").write_text(json.dumps(content))


@pytest.fixture(scope="module")
def match(tmp_path_factory) -> Path:
    """No test changes it."""
    root = tmp_path_factory.mktemp("together") / "match"
    write_annotations(root / "annotations", load_field("soccer"))
    return root


@pytest.fixture(scope="module")
def short(tmp_path_factory) -> Path:
    """Half as many frames, where it is not about how well they are fitted; unchanged, too."""
    root = tmp_path_factory.mktemp("together") / "short"
    write_annotations(root / "annotations", load_field("soccer"), 3)
    return root


@pytest.fixture(scope="module")
def groups(tmp_path_factory) -> Path:
    lines = [f"{place}{i},{place} stand" for place in PLACES for i in range(6)]
    path = tmp_path_factory.mktemp("together") / "groups.csv"
    path.write_text("\n".join(["frame,camera", *lines]))
    return path


@pytest.fixture(scope="module")
def uneven(cli, groups, tmp_path_factory) -> tuple[Result, Path]:
    """Cameras of frames of which a2 has two elements only and b5 stands in no group."""
    root = tmp_path_factory.mktemp("uneven")
    write_annotations(root / "match" / "annotations", load_field("soccer"))
    path = root / "match" / "annotations" / "a2.json"
    content = json.loads(path.read_text())
    two = {name: content[name] for name in ("Middle line", "Circle central")}
    path.write_text(json.dumps(two))
    kept = [line for line in groups.read_text().splitlines() if not line.startswith("b5")]
    (root / "groups.csv").write_text("\n".join(kept))
    out = root / "cameras"
    given = ("--shared-position", "--groups", root / "groups.csv")
    return cli("calibrate", root / "match", out, *given), out


@pytest.mark.parametrize("given", [False, True])
def test_frames_of_one_place_get_one_position(cli, match, groups, tmp_path, given):
    out = tmp_path / "cameras"
    grouped = ["--groups", groups] if given else []
    done = cli("calibrate", match, out, "--shared-position", *grouped, "-t", 2)
    places = {row["position"]: row for row in rows_in(out / "positions.csv")}
    assert set(places) == ({"a stand", "b stand"} if given else {"1", "2"})
    rows = {row["name"]: row for row in rows_in(out / "calibration.csv")}
    for name, row in rows.items():
        place = places[row["position"]]
        camera = json.loads((out / row["camera"]).read_text())
        where = [float(place[f"{axis}_m"]) for axis in "xyz"]
        assert camera["position_meters"] == pytest.approx(where)
        sd = np.array([float(place[f"sd_{axis}_m"]) for axis in "xyz"])
        off = np.abs(np.array(where) - PLACES[name[0]])
        assert (off < 0.5).all()
        assert (off < 4 * sd).all()
        assert float(place["scatter_y_m"]) > float(place["sd_y_m"])
        assert place["frames"] == "6"
    assert "Shared positions (m)" in done.stdout
    assert "each frame alone" in done.stdout
    assert "12 of 12" in done.stdout


def test_a_camera_for_a_frame_of_two_elements(uneven):
    done, out = uneven
    assert "1 frame has a camera now that the position is known: a2" in done.stdout
    assert "11 of 12" in done.stdout
    assert "12 of 12" in done.stdout
    assert (out / "camera_a2.json").exists()


def test_frames_without_a_group_keep_their_own_position(uneven):
    done, out = uneven
    assert "Own positions: 1" in done.stdout
    assert "it has no group" in done.stdout
    assert {r["name"]: r["position"] for r in rows_in(out / "calibration.csv")}["b5"] == ""


def test_what_makes_no_sense_is_refused(cli, match, groups, tmp_path):
    out = tmp_path / "cameras"
    for arguments, problem in (
        (["calibrate", match, out, "--groups", groups], "--groups is for --shared-position"),
        (["calibrate", match, out, "--shared-position", "-m", "H"], "choose P, R or R+, not H"),
        (["field-size", match, "--dimension", "goal_width"], "cannot be fitted"),
        (["field-size", match, "--field", "soccer:length=x"], "'length=x' is no dimension"),
        (["field-size", match, "--field", "soccer:length=30"], "outside the range of the rules"),
        (
            ["field-size", match, "--field", "soccer:length=90,width=90"],
            "the rules ask for length > width, and 90 > 90 does not hold",
        ),
    ):
        done = cli(*arguments, code=2)
        assert problem in done.stderr
    assert not out.exists()


def test_the_size_of_a_field_is_found_and_kept(cli, tmp_path):
    match = tmp_path / "match"
    write_annotations(match / "annotations", load_field("soccer", length=101.3, width=66.2), 4)
    done = cli("field-size", match, "--save", "-t", 2)
    assert "Dimensions of the field" in done.stdout
    database = WorkspaceDatabase.open(match, "tester")
    kept = json.loads(database.setting(DIMENSIONS_SETTING) or "{}")
    database.close()
    assert kept["field"] == "soccer"
    assert kept["dimensions"]["length"] == pytest.approx(101.3, abs=0.3)
    assert kept["dimensions"]["width"] == pytest.approx(66.2, abs=0.3)
    length = kept["dimensions"]["length"]
    assert f"soccer {length:g} x {kept['dimensions']['width']:g} m" in done.stdout
    # The other commands take dimensions when told, and say so.
    out = tmp_path / "cameras"
    fitted = cli("calibrate", match, out, "--field", "soccer:length=101.3,width=66.2", "-t", 2)
    assert "soccer 101.3 x 66.2 m" in fitted.stdout
    scores = {}
    for field in ("soccer", "soccer:length=101.3,width=66.2"):
        path = tmp_path / f"{len(field)}.json"
        done = cli("evaluate", match / "annotations", out, "--field", field, "-t", 2, "-o", path)
        written = json.loads(path.read_text())
        scores[field] = written["summary"]["2"]["mean_jac"]
        assert written["field"] == field.partition(":")[0] + (
            " 101.3 x 66.2 m" if ":" in field else ""
        )
    assert scores["soccer:length=101.3,width=66.2"] > scores["soccer"] + 0.1


def test_groups_have_sizes_of_their_own(cli, short, groups):
    done = cli("field-size", short, "--groups", groups)
    assert "a stand" in done.stdout
    assert "b stand" in done.stdout


def kept_in(dataset: Path) -> dict[str, float]:
    database = WorkspaceDatabase.open(dataset, "tester")
    kept = json.loads(database.setting(DIMENSIONS_SETTING) or "{}")
    database.close()
    return kept.get("dimensions", {})


def test_dimensions_that_were_kept_before_stay(cli, tmp_path):
    match = tmp_path / "match"
    write_annotations(match / "annotations", load_field("soccer", length=101.3, width=66.2), 3)
    database = WorkspaceDatabase.open(match, "tester")
    store_dimensions(database, load_field("soccer", length=101.3))
    assert database.close()
    cli("field-size", match, "--dimension", "width", "--save",
               "--field", "soccer:length=101.3")  # fmt: skip
    assert kept_in(match) == {"length": 101.3, "width": pytest.approx(66.2, abs=0.3)}
    # Whoever names no length leaves the one that was kept.
    cli("field-size", match, "--dimension", "width", "--save")
    assert kept_in(match)["length"] == 101.3


def test_dimensions_are_kept_where_the_window_looks(cli, tmp_path):
    match = tmp_path / "match"
    write_annotations(match / "annotations", load_field("soccer"), 4)
    done = cli("field-size", match / "annotations", "--save")
    assert set(kept_in(match)) == {"length", "width"}
    assert not (match / "annotations" / ".procc").exists()
    alone = tmp_path / "alone"
    (match / "annotations").rename(alone)
    done = cli("field-size", alone, "--save")
    assert set(kept_in(alone)) == {"length", "width"}
    assert field_of_dataset(alone).field.described in done.stdout.splitlines()[-1]


def test_a_single_frame_keeps_no_dimensions(cli, tmp_path):
    write_annotations(tmp_path / "annotations", load_field("soccer"), 4)
    _, *others = sorted((tmp_path / "annotations").glob("*.json"))
    for path in others:
        path.unlink()
    done = cli("field-size", tmp_path, "--save", code=2)
    assert "nothing kept: a single frame determines no dimensions" in done.stderr
    assert not (tmp_path / ".procc").exists()


def test_an_archive_keeps_no_dimensions(cli, short, tmp_path):
    archive = tmp_path / "match.zip"
    with zipfile.ZipFile(archive, "w") as file:
        for path in sorted((short / "annotations").glob("*.json")):
            file.write(path, path.name)
    done = cli("field-size", archive, "--save", code=2)
    assert "is an archive" in done.stderr


def test_positions_of_another_run_are_not_replaced_and_not_passed_over(cli, short, tmp_path):
    out = tmp_path / "cameras"
    out.mkdir()
    theirs = out / "positions.csv"
    theirs.write_text("mine")
    done = cli("calibrate", short, out, "--shared-position", code=2)
    assert "--overwrite" in done.stderr
    assert theirs.read_text() == "mine"
    done = cli("calibrate", short, out)
    assert "holds positions.csv of cameras with shared positions" in done.stderr
    assert theirs.read_text() == "mine"
    done = cli("calibrate", short, out, "--shared-position", "--overwrite")
    assert theirs.read_text().startswith("position,frames")


def test_it_says_which_models_were_chosen(cli, short, tmp_path):
    done = cli("calibrate", short, tmp_path / "out", "--shared-position", "-m", "auto")
    models = [row["model"] for row in rows_in(tmp_path / "out" / "calibration.csv")]
    chosen = ", ".join(f"{name} {models.count(name)}" for name in sorted(set(models)))
    said = " ".join(done.stdout.split())
    assert f"model chosen for each frame ({chosen}), shared positions" in said
    sized = cli("field-size", short, "-m", "auto")
    assert "model chosen for each frame (P " in " ".join(sized.stdout.split())
