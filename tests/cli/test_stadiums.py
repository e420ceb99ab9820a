"""A set of several stadiums goes by the dimensions of each: `field-size --groups --save`."""

import json
import re
import shutil
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.cli import field_size
from procc_annotator.dataset.dataset_field import field_of_dataset
from procc_annotator.field.load import load_field
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup
from tests.cli.conftest import PANS, SIZE, camera_file, rows_in

SIZES = {"old": {"length": 100.0, "width": 64.0}, "new": {"length": 105.0, "width": 68.0}}
QUIET = ("--resamples", 200, "--seed", 1)


def plain(text: str) -> str:
    return " ".join(text.split())


def write_annotation(path: Path, pan: float, dimensions: dict[str, float]) -> None:
    """What a camera shows of a field of these dimensions, exactly."""
    camera = PinholeCamera(
        np.deg2rad(pan), np.deg2rad(78.0), 0.0, (0.0, 60.0, -14.0), (1400.0, 1400.0), (479.5, 269.5)
    )
    shown = project_field(camera, EvaluationSetup(load_field("soccer", **dimensions), SIZE))
    content = {
        name: [
            {"x": float(x) / (SIZE[0] - 1), "y": float(y) / (SIZE[1] - 1)}
            for x, y in pieces[0][[0, len(pieces[0]) // 2, -1]]
        ]
        for name, pieces in shown.pieces.items()
    }
    path.write_text(json.dumps(content))


def write_match(root: Path) -> Path:
    """Frames of two stadiums, with the cameras that took them; whose they are stands beside it."""
    (root / "annotations").mkdir(parents=True)
    (root / "cameras").mkdir()
    rows = ["frame,match"]
    for stadium, dimensions in SIZES.items():
        for pan_name, pan in PANS.items():
            frame = f"{stadium}_{pan_name}"
            write_annotation(root / "annotations" / f"{frame}.json", pan, dimensions)
            (root / "cameras" / f"camera_{frame}.json").write_text(json.dumps(camera_file(pan)))
            rows.append(f"{frame},{stadium}")
    (root.parent / "matches.csv").write_text("\n".join(rows))
    return root


@pytest.fixture
def two(tmp_path) -> Path:
    return write_match(tmp_path / "match")


@pytest.fixture(scope="module")
def found_once(cli, tmp_path_factory) -> Path:
    """The folder of a match whose stadiums were found."""
    folder = tmp_path_factory.mktemp("found")
    root = write_match(folder / "match")
    done = cli("field-size", root, "--groups", folder / "matches.csv", "--save")
    assert "(2 stadiums, 10 frames)" in plain(done.stdout)
    return folder


@pytest.fixture
def known(found_once, tmp_path) -> Path:
    """Such a match, to be changed at will."""
    shutil.copytree(found_once, tmp_path, dirs_exist_ok=True)
    return tmp_path / "match"


def jac(cli, root: Path, out: Path, *more: object) -> float:
    cli("evaluate", root / "annotations", root / "cameras", "-t", 1, "-o", out, *more)
    found: float = json.loads(out.read_text())["summary"]["1"]["mean_jac"]
    return found


def test_each_frame_is_judged_by_its_own_stadium(cli, known, tmp_path):
    rows = rows_in(known / "stadiums.csv")
    assert len(rows) == 10
    for row in rows:
        assert row["frame"].startswith(row["stadium"])
        for name, metres in SIZES[row["stadium"]].items():
            assert float(row[name]) == pytest.approx(metres, abs=0.02)
    out = tmp_path / "s.json"
    assert jac(cli, known, out) > 0.99
    assert json.loads(out.read_text())["field_stadiums"].keys() == SIZES.keys()
    assert jac(cli, known, out, "--field", "soccer") < 0.9


def test_every_command_goes_by_them(cli, known, tmp_path):
    fits = tmp_path / "fits"
    done = cli("calibrate", known, fits, "-t", 1)
    assert "dimensions of 2 stadiums" in plain(done.stdout)
    table = rows_in(fits / "calibration.csv")
    assert max(float(row["mean_error"]) for row in table) < 0.1  # half a metre is some 10 px
    shared = cli("calibrate", known, tmp_path / "shared", "--shared-position", "-t", 1)
    assert "old" in shared.stdout  # a place of its own for each stadium
    out = tmp_path / "r.json"
    cli("report", known, "--cameras", f"a={known / 'cameras'}", "-t", 1, "-o", out, *QUIET)
    source = json.loads(out.read_text())["sources"][0]
    assert source["summary"]["1"]["mean_jac"] > 0.99
    compared = cli("compare", f"a={known / 'cameras'}", f"b={fits}", known)
    assert "dimensions of 2 stadiums" in plain(compared.stdout)
    cli("check", known, "--output", tmp_path / "f.csv")
    rules = {row["rule"] for row in rows_in(tmp_path / "f.csv")}
    assert rules <= {"few points"}  # nothing is off its place


def test_a_manifest_holds_them(cli, known, tmp_path):
    manifest = tmp_path / "manifest.json"
    jac(cli, known, tmp_path / "s.json", "--manifest", manifest)
    assert "the same" in cli("repeat", manifest, "--data", known).stdout
    elsewhere = tmp_path / "elsewhere"
    shutil.copytree(known, elsewhere / "match")
    assert "the same" in cli("repeat", manifest, "--data", elsewhere / "match").stdout
    path = elsewhere / "match" / "stadiums.csv"
    kept = [line for line in path.read_text().splitlines() if ",old," not in line]
    path.write_text("\n".join(kept))
    done = cli("repeat", manifest, "--data", elsewhere / "match", code=1)
    assert "other content: stadiums.csv" in done.stdout
    assert "other field" in done.stdout
    assert "other metric" in done.stdout


def test_what_was_kept_of_others_stays(cli, known, tmp_path):
    before = (known / "stadiums.csv").read_text().splitlines()
    (tmp_path / "one.csv").write_text(
        "frame,match\n" + "\n".join(f"old_{name},old" for name in PANS)
    )
    groups = ("--groups", tmp_path / "one.csv")
    cli("field-size", known, *groups, "--dimension", "width", "--save")
    after = (known / "stadiums.csv").read_text().splitlines()
    assert {line for line in before if ",new," in line} <= set(after)
    assert len(after) == len(before)
    assert all(line.split(",")[2] for line in after)  # the length found before


def test_the_stadiums_that_are_known_need_no_groups(cli, known, tmp_path):
    """What is not asked for stays as it is in each stadium, before and after."""
    path = known / "stadiums.csv"
    before = path.read_text()
    path.write_text(re.sub(r"(?m)^(old.*,)[\d.]+$", r"\g<1>66", before))
    done = cli("field-size", known, "--dimension", "width", "--save", "-t", 1)
    widths = [line for line in done.stdout.splitlines() if "Width" in line]
    assert len(widths) == 2
    assert all("→ 100.00" in line for line in widths), done.stdout
    assert path.read_text() == before
    assert field_of_dataset(known).field.dimensions == load_field("soccer").dimensions


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (("frame,", "picture,"), "line 1: has no column 'frame'"),
        (("width", "widht"), "did you mean 'width'"),
        (("old_1,old,", "old_1,old,wide"), "line 2: length is 'wide"),
        (("old_2,old,", "old_2,old,9"), "line 3: the stadium 'old' has other dimensions"),
        ((",old,1", ",old,91"), "outside the range of the rules"),
    ],
)
def test_a_damaged_file_is_told_and_nothing_is_lost(
    cli, known, tmp_path, monkeypatch, change, said
):
    path = known / "stadiums.csv"
    text = path.read_text().replace(",old,99", ",old,100").replace(*change)
    path.write_text(text)
    done = cli("evaluate", known / "annotations", known / "cameras", "-o", tmp_path / "s.json")
    assert "stadiums' dimensions are not used" in plain(done.stderr)
    assert said in plain(done.stderr)
    assert path.read_text() == text
    monkeypatch.setattr(field_size, "fit_set", None)  # nobody waits for fits that would be lost
    kept = cli("field-size", known, "--groups", tmp_path / "matches.csv", "--save", code=2)
    assert said in plain(kept.stderr)
    assert path.read_text() == text


def test_a_stadium_of_one_frame_is_not_kept(cli, two, tmp_path):
    (tmp_path / "one.csv").write_text("frame,match\nold_3,lonely\n")
    done = cli("field-size", two, "--groups", tmp_path / "one.csv", "--save", code=2)
    assert "nothing to save" in plain(done.stderr)
    assert not (two / "stadiums.csv").exists()


def test_a_release_carries_them(cli, known, tmp_path):
    out = tmp_path / "published"
    cli("release", known, out, "--version", "1.0", "--creator", "Ann Other", "--no-check")
    assert (out / "stadiums.csv").read_bytes() == (known / "stadiums.csv").read_bytes()
    assert "`stadiums.csv`: the stadium of each frame" in (out / "README.md").read_text()
