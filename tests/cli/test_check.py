"""``check`` names wrong labels frame by frame, in a table, as CSV and as JSON."""

import json
import zipfile
from pathlib import Path

import pytest

from tests.cli.conftest import rows_in


def swap(folder: Path, frame: str, one: str, other: str) -> None:
    path = folder / f"{frame}.json"
    content = json.loads(path.read_text())
    content[one], content[other] = content[other], content[one]
    path.write_text(json.dumps(content))


FRONT, SMALL = "Big rect. left main", "Small rect. left main"


@pytest.mark.parametrize("kind", ["dataset", "annotations", "zip"])
def test_a_swap_is_found_and_the_remedy_is_told(cli, dataset, tmp_path, kind):
    swap(dataset.annotations, "1", FRONT, SMALL)
    given = {"dataset": dataset.root, "annotations": dataset.annotations}.get(kind)
    if given is None:
        given = tmp_path / "annotations.zip"
        with zipfile.ZipFile(given, "w") as archive:
            for path in dataset.annotations.iterdir():
                archive.write(path, path.name)
    out = tmp_path / "findings.csv"
    done = cli("check", given, "--output", out)
    assert "Checked 5 frames" in done.stdout
    assert f"written: {out}" in done.stdout
    (found,) = [row for row in rows_in(out) if row["severity"] == "error"]
    assert (found["frame"], found["rule"]) == ("1", "swapped")
    assert set(found["elements"].split("; ")) == {FRONT, SMALL}
    assert found["suggestion"].startswith("swap Left")
    assert "without" in found["reason"]
    assert float(found["error_px"]) > 9
    assert (found["model"], found["width"], found["height"]) == ("R", "960", "540")
    assert "swap Left" in " ".join(done.stdout.split())


def test_clean_frames_have_no_errors(cli, dataset, tmp_path):
    """Their circles have three points each, which is worth a warning."""
    out = tmp_path / "findings.csv"
    done = cli("check", dataset.root, "-o", out, "--min-severity", "warning", "--fail-on", "error")
    assert {(row["rule"], row["elements"]) for row in rows_in(out)} == {
        ("few points", "Circle central")
    }
    done = cli(
        "check", dataset.root, "-o", out, "--min-severity", "error", "--fail-on", "warning", code=1
    )
    assert rows_in(out) == []
    assert "Worst findings" not in done.stdout


def test_json_holds_the_remedies(cli, dataset, tmp_path):
    swap(dataset.annotations, "1", FRONT, SMALL)
    out = tmp_path / "findings.json"
    cli("check", dataset.root, "-o", out, "--size", "1920x1080")
    content = json.loads(out.read_text())
    assert (content["model"], content["size"], content["frames"]) == ("R", [1920, 1080], 5)
    (found,) = [f for f in content["findings"] if f["severity"] == "error"]
    assert found["remedies"][0]["kind"] == "swap"
    assert sorted(found["remedies"][0]["renamed"]) == [[FRONT, SMALL], [SMALL, FRONT]]
    assert content["unreadable"] == []


def test_damaged_files_and_classes_that_stand_twice_are_told(cli, dataset, tmp_path):
    points = '[{"x": 0.1, "y": 0.1}, {"x": 0.5, "y": 0.1}]'
    (dataset.annotations / "2.json").write_text(
        f'{{"Middle line": {points}, "Middle line": {points}}}'
    )
    out = tmp_path / "findings.csv"
    done = cli("check", dataset.root, "-o", out, code=1)
    assert "2.json" in done.stderr
    assert "Checked 4 frames" in done.stdout
    (found,) = [row for row in rows_in(out) if row["rule"] == "unreadable"]
    assert (found["frame"], found["severity"]) == ("2", "error")
    assert "twice" in found["reason"]
    as_json = tmp_path / "findings.json"
    cli("check", dataset.root, "-o", as_json, code=1)
    assert json.loads(as_json.read_text())["unreadable"][0]["frame"] == "2"


def test_the_exit_code_can_depend_on_what_was_found(cli, dataset):
    done = cli("check", dataset.root)
    assert cli("check", dataset.root, "--fail-on", "error").stdout == done.stdout
    assert cli("check", dataset.root, "--fail-on", "warning", code=1).stdout == done.stdout
    swap(dataset.annotations, "1", FRONT, SMALL)
    cli("check", dataset.root, "--fail-on", "error", code=1)


def test_names_cannot_become_formulas(cli, dataset, tmp_path):
    swap(dataset.annotations, "1", FRONT, SMALL)
    (dataset.annotations / "1.json").rename(dataset.annotations / "=1+1.json")
    out = tmp_path / "findings.csv"
    cli("check", dataset.annotations, "-o", out)
    assert "'=1+1" in {row["frame"] for row in rows_in(out)}


def test_frames_without_a_camera_are_counted(cli, dataset, tmp_path):
    two = json.loads((dataset.annotations / "3.json").read_text())
    (dataset.annotations / "2.json").write_text("{}")
    (dataset.annotations / "3.json").write_text(json.dumps(dict(list(two.items())[:2])))
    out = tmp_path / "findings.csv"
    done = cli("check", dataset.root, "-o", out, "--min-severity", "error")
    assert "1 frame has no element at all" in done.stdout
    assert (
        "1 frame has too few elements for a camera: only checked by rules that need no camera"
        in done.stdout
    )
    assert [(r["frame"], r["rule"], r["severity"], r["reason"]) for r in rows_in(out)] == [
        ("2", "no camera", "", "by eye only: 0 elements, 3 needed"),
        ("3", "no camera", "", "by eye only: 2 elements, 3 needed"),
    ]
    as_json = tmp_path / "findings.json"
    cli("check", dataset.root, "-o", as_json)
    told = json.loads(as_json.read_text())["without_camera"]
    assert [(one["frame"], one["elements"]) for one in told] == [("2", 0), ("3", 2)]
    assert "no element" not in cli("check", dataset.annotations / "1.json").stdout


def test_classes_are_written_as_in_the_files(cli, dataset, tmp_path):
    left, right = "Goal left post left ", "Goal left post right"
    swap(dataset.annotations, "1", left, right)
    out = tmp_path / "findings.csv"
    cli("check", dataset.root, "-o", out)
    found = {name for row in rows_in(out) for name in row["elements"].split("; ")}
    assert left in found
    assert left.strip() not in found
    known = set(json.loads((dataset.annotations / "1.json").read_text()))
    assert {
        n for r in rows_in(out) if r["frame"] == "1" for n in r["elements"].split("; ")
    } <= known


def test_unknown_classes_and_pixels_are_errors(cli, dataset, tmp_path):
    path = dataset.annotations / "1.json"
    content = json.loads(path.read_text())
    content["Side line tpo"] = content.pop("Side line top")
    path.write_text(json.dumps(content))
    other = dataset.annotations / "2.json"
    pixels = {
        name: [{"x": 959 * p["x"], "y": 539 * p["y"]} for p in points]
        for name, points in json.loads(other.read_text()).items()
    }
    other.write_text(json.dumps(pixels))
    out = tmp_path / "findings.csv"
    done = cli("check", dataset.root, "-o", out, "--min-severity", "error")
    found = {row["frame"]: row for row in rows_in(out) if row["severity"] == "error"}
    assert found["1"]["rule"] == "unknown class"
    assert found["1"]["suggestion"] == "relabel to Far touchline"
    assert found["2"]["rule"] == "pixels"
    assert "look like pixels" in " ".join(done.stdout.split())
    fitted = cli("calibrate", dataset.root, tmp_path / "out")
    assert "look like pixels, expected 0 to 1" in " ".join(fitted.stdout.split())
