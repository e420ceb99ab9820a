"""A benchmark of projected polylines: written, checked and scored, by two who share no camera."""

import json
import shutil
import zipfile
from pathlib import Path

import pytest
from typer.testing import CliRunner

from procc_annotator import (
    ElementProjections,
    UsageError,
    evaluate_set,
    load_annotations,
    load_cameras,
    project_field,
)
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.cli.main import app
from procc_annotator.formats.cameras.soccernet import write_camera

SOURCES = ("true", "bad", "homography", "pinhole")


def summary(path: Path) -> dict:
    found = json.loads(path.read_text())
    return (found.get("evaluations") or [found])[0]["summary"]["5"]


def submit(cli, data: Path, source: str, out: Path, *options: object) -> None:
    cli("convert", data / "cameras" / source, out, "--to", "polylines", "--frames", data, *options)


def changed(path: Path, out: Path, **changes: object) -> Path:
    """The archive with another manifest or other files; None leaves a file out."""
    with zipfile.ZipFile(path) as archive, zipfile.ZipFile(out, "w") as other:
        for name in archive.namelist():
            data = changes.pop(name, archive.read(name))
            if data is not None:
                other.writestr(name, data)
        for name, data in changes.items():
            other.writestr(name, data)
    return out


def manifest(path: Path) -> dict:
    with zipfile.ZipFile(path) as archive:
        return json.loads(archive.read("manifest.json"))


@pytest.fixture
def data(sample_data, tmp_path) -> Path:
    folder = tmp_path / "sample"
    folder.mkdir()
    for file in sample_data.glob("*.json"):
        shutil.copy(file, folder)
    shutil.copytree(sample_data / "cameras", folder / "cameras")
    return folder


@pytest.mark.parametrize("protocol", ["procc", "soccernet"])
@pytest.mark.parametrize("source", SOURCES)
def test_polylines_score_as_their_cameras_do(cli, data, tmp_path, source, protocol):
    archive, own, theirs = tmp_path / "s.zip", tmp_path / "own.json", tmp_path / "theirs.json"
    submit(cli, data, source, archive, "--protocol", protocol, "--method", "mine")
    cameras = data / "cameras" / source
    missing = source == "bad"  # it has no camera for some
    cli("check-submission", archive, "--annotations", data, code=int(missing))
    terms = ("--protocol", protocol, "-t", "5")
    cli("evaluate", data, "--submission", archive, *terms, "--output", theirs)
    cli("evaluate", data, cameras, *terms, "--output", own)
    assert json.loads(theirs.read_text())["evaluations"][0]["method"] == "mine"
    for key in ("mean_jac", "completeness", "mean_reprojection_error"):
        assert summary(theirs)[key] == pytest.approx(summary(own)[key], abs=2e-3), key


def test_polylines_cut_to_the_picture_are_no_method_of_procc(cli, data, tmp_path):
    """Their distances are not the camera's."""
    annotations, size = load_annotations(data), (960, 540)
    cameras = load_cameras(data / "cameras" / "true")
    own = evaluate_set(annotations, cameras, protocol="procc").summaries[5.0].mean_jac
    whole = {n: project_field(c, size=size, clipped=False) for n, c in cameras.items()}
    given = {name: ElementProjections(pieces) for name, pieces in whole.items()}
    assert evaluate_set(annotations, given, protocol="procc").summaries[5.0].mean_jac == own
    for protocol in ("procc", "soccernet"):
        cut = {n: project_field(c, size=size, protocol=protocol) for n, c in cameras.items()}
        with pytest.raises(UsageError, match="cut to the picture"):
            evaluate_set(
                annotations, {n: ElementProjections(p) for n, p in cut.items()}, protocol="procc"
            )
        (out := tmp_path / protocol).mkdir()
        for name, pieces in cut.items():
            lines = {
                key: [
                    [{"x": round(x / 959, 9), "y": round(y / 539, 9)} for x, y in p] for p in parts
                ]
                for key, parts in pieces.items()
            }
            (out / f"{name}.json").write_text(json.dumps(lines))
        done = cli(
            "evaluate", data, out, "--camera-format", "polylines", "--protocol", "procc", code=1
        )
        assert "its polylines are cut to the picture" in " ".join(done.stderr.split())


def test_cameras_that_hardly_belong_to_the_size_are_told(cli, data, tmp_path):
    done = cli("convert", data / "cameras" / "pinhole", tmp_path / "s.zip", "--to", "polylines",
               "--size", "1280x720")  # fmt: skip
    assert "in the exact middle of 960x540, not of 1280x720" in done.stderr


def test_what_it_was_made_for_counts(cli, data, tmp_path):
    archive = tmp_path / "s.zip"
    submit(cli, data, "true", archive, "--protocol", "procc")

    def refused(*options: object) -> str:
        done = cli("evaluate", data, "--submission", archive, *options, code=2)
        return done.output

    assert "made for the protocol procc, not soccernet" in refused()
    assert "960x540, not 1280x720" in refused("--protocol", "procc", "--size", "1280x720")
    assert "another field" in refused("--protocol", "procc", "--field", "soccer:length=100")
    (data / "00099.json").write_text((data / "00001.json").read_text())
    assert "other frames" in refused("--protocol", "procc")


def test_findings_of_a_poor_submission(cli, data, tmp_path):
    good = tmp_path / "s.zip"
    submit(cli, data, "true", good)
    poor = changed(
        good,
        tmp_path / "poor.zip",
        **{
            "00001.json": None,
            "00002.json": b'{"Middle line": [{"x": "far"}]}',
            "00003.json": b'{"Half line": [{"x": 0.5, "y": 0.1}, {"x": 0.5, "y": 0.9}]}',
            "00077.json": b"{}",
            "run.py": b"raise SystemExit",
        },
    )
    done = cli("check-submission", poor, "--annotations", data, code=1)
    assert "lowers the score: 1 of 11 annotated frames are missing (00001)" in done.output
    assert "lowers the score: 00002.json" in done.output
    assert "ignored: 00003.json: no element of the field: Half line" in done.output
    assert "ignored: 1 file (00077): no such frame is annotated" in done.output
    assert "run.py" in done.output
    cli("evaluate", data, "--submission", poor, "--output", tmp_path / "o.json", code=1)
    assert summary(tmp_path / "o.json")["completeness"] == pytest.approx(9 / 11)


@pytest.mark.parametrize(
    ("text", "said"),
    [(b"{", "is no manifest"), (b'{"format": 1}', "is no manifest"), (None, "no manifest.json")],
)
def test_a_manifest_that_cannot_be_used(cli, data, tmp_path, text, said):
    good = tmp_path / "s.zip"
    submit(cli, data, "true", good)
    bad = changed(good, tmp_path / "bad.zip", **{"manifest.json": text})
    done = cli("evaluate", data, "--submission", bad, code=2)
    assert said in done.output


def test_a_name_from_a_manifest_is_only_a_name(cli, data, tmp_path):
    good = tmp_path / "s.zip"
    submit(cli, data, "true", good)
    content = manifest(good) | {"method": "../../x=y:{set}\n" + "z" * 300}
    odd = changed(good, tmp_path / "odd.zip", **{"manifest.json": json.dumps(content).encode()})
    cli("evaluate", data, "--submission", odd, "--output", tmp_path / "o.json")
    method = json.loads((tmp_path / "o.json").read_text())["evaluations"][0]["method"]
    assert not set(method) & set("=:/{}\n")


def test_only_an_archive_takes_polylines(cli, data, tmp_path):
    done = cli("convert", data / "cameras" / "true", tmp_path / "out", "--to", "polylines", code=2)
    assert ".zip" in done.output


def test_names_may_begin_at_the_top_of_the_archive_and_be_composed_otherwise(cli, data, tmp_path):
    composed, apart = "caf\u00e9.json", "cafe\u0301.json"
    (data / "00001.json").rename(data / composed)
    (data / "cameras/true/camera_00001.json").rename(data / f"cameras/true/camera_{apart}")
    plain, dotted = tmp_path / "s.zip", tmp_path / "d.zip"
    submit(cli, data, "true", plain)
    with zipfile.ZipFile(plain) as archive, zipfile.ZipFile(dotted, "w") as other:
        for name in archive.namelist():
            other.writestr(f"./{name.replace(composed, apart)}", archive.read(name))
    (data / composed).rename(data / apart)  # as a Mac would copy them
    for path in (plain, dotted):
        looked = cli("check-submission", path, "--annotations", data)
        assert looked.output == "nothing to say: every polyline will be read\n"
        cli("evaluate", data, "--submission", path, "-o", tmp_path / "o.json")
        assert summary(tmp_path / "o.json")["completeness"] == 1


# ``procc-annotator check-submission`` as it is typed.

CAMERA = PinholeCamera(0.1, 1.3, 0.01, (2.0, 60.0, -15.0), (1400.0, 1410.0), (479.5, 269.5))


def test_a_good_and_an_incomplete_submission(tmp_path):
    path = tmp_path / "submission.zip"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("valid/camera_1.json", write_camera(CAMERA))
    annotations = tmp_path / "annotations"
    annotations.mkdir()
    (annotations / "1.json").write_text("{}")
    run = CliRunner().invoke
    good = run(
        app, ["check-submission", str(path), "--annotations", str(annotations), "--split", "valid"]
    )
    assert (good.exit_code, good.stdout) == (
        0,
        "nothing to say: the official evaluation will read every camera\n",
    )
    (annotations / "2.json").write_text(json.dumps({}))
    missing = run(
        app, ["check-submission", str(path), "--annotations", str(annotations), "--split", "valid"]
    )
    assert missing.exit_code == 1
    assert missing.stdout.startswith("lowers the score: 1 of 2 annotated frames have no camera (2)")
    wrong = run(app, ["check-submission", str(path)])
    assert wrong.exit_code == 1
    assert "expected files named test/camera_FRAME.json" in wrong.stdout
    assert run(app, ["check-submission", str(tmp_path / "absent.zip")]).exit_code == 2
    folder = run(app, ["check-submission", str(annotations)])
    assert folder.exit_code == 2
    assert "is a folder, a submission is a zip archive" in folder.stderr
