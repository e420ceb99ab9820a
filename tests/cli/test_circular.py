"""Fits to the clicks that they are judged by are found, with their mark or without."""

import json
import re
import shutil

import numpy as np
import pytest
from scipy.stats import gamma

from procc_annotator import compare_methods, fit_camera, load_annotation
from procc_annotator.metrics.statistics.independence import are_dependent, independence_evidence
from tests.cli.conftest import rows_in


@pytest.fixture(scope="module")
def wc14(shared_data, tmp_path_factory):
    """Every sixth frame: annotations, published methods."""
    out = tmp_path_factory.mktemp("wc14")
    for source in ("annotations", "cameras_pnlcalib", "cameras_nbjw", "homographies_carwc"):
        (out / source).mkdir()
        for path in (shared_data / "wc14" / source).iterdir():
            if int(re.sub(r"\D", "", path.stem)) % 6 == 0:
                shutil.copy(path, out / source)
    return out


@pytest.fixture(scope="module")
def fits(cli, wc14, tmp_path_factory):
    out = tmp_path_factory.mktemp("fits")
    for model in ("P", "R", "R+", "H"):
        cli("calibrate", wc14 / "annotations", out / model, "--model", model)
        (out / model / "calibration.csv").unlink()
    return out


def described(cli, annotations, **cameras):
    """Method -> the terms in its caption, of methods with marks."""
    named = [a for name, path in cameras.items() for a in ("--cameras", f"{name}={path}")]
    cli("evaluate", annotations, *named, "-o", annotations.parent / "s.json", "--intervals")
    content = json.loads((annotations.parent / "s.json").read_text())
    rows = content["chance"][0]["intervals"]["rows"]
    tested = {
        (row["a"], row["b"])
        for row in content["chance"][0].get("differences", {"rows": []})["rows"]
        if row["p"] is not None
    }
    return {
        row["source"].rstrip("†‡§"): row["source"][-1:].strip("abcdefghijklmnopqrstuvwxyzHPR+")
        for row in rows
    }, tested


def test_fits_without_marks_are_found_and_published_methods_are_not(cli, wc14, fits, tmp_path):
    for path in fits.glob("*/*"):
        (tmp_path / path.parent.name).mkdir(exist_ok=True)
        data = path.read_bytes()
        plain = (
            json.dumps({k: v for k, v in json.loads(data).items() if k != "fit"}).encode()
            if path.suffix == ".json"
            else re.sub(rb"# annotation_sha256.*\n", b"", data)
        )
        (tmp_path / path.parent.name / path.name).write_bytes(plain)
    (tmp_path / "turned").mkdir()
    for path in (tmp_path / "R").glob("*.json"):
        camera = json.loads(path.read_text())
        x, y, z = camera["position_meters"]
        camera |= {"pan_degrees": camera["pan_degrees"] + 180, "position_meters": [-x, -y, z]}
        (tmp_path / "turned" / path.name).write_text(json.dumps(camera))
    marks, tested = described(
        cli, wc14 / "annotations", P=tmp_path / "P", turned=tmp_path / "turned",
        R=tmp_path / "R", Rp=tmp_path / "R+",
        H=tmp_path / "H", pnl=wc14 / "cameras_pnlcalib", nbjw=wc14 / "cameras_nbjw",
        carwc=wc14 / "homographies_carwc",
    )  # fmt: skip
    methods = dict.fromkeys(("pnl", "nbjw", "carwc"), "")
    unmarked = {"P", "R", "Rp", "H", "turned"}
    assert marks == dict.fromkeys(unmarked, "§") | methods
    assert tested == {("pnl", "nbjw"), ("pnl", "carwc"), ("nbjw", "carwc")}
    scores = json.loads((wc14 / "s.json").read_text())["evaluations"]
    assert {s["method"] for s in scores if "too_close_to_clicks" in s} == unmarked


def test_marks_survive_conversion_copying_and_changed_clicks(cli, wc14, fits, tmp_path):
    found = {}
    for to in ("soccernet-camera", "opencv", "krt", "wc14", "carwc", "world"):
        cli("convert", fits / "P", tmp_path / to, "--to", to)
        assert not list((tmp_path / to).glob("*.fit"))
        found[to.replace("-", "_")] = tmp_path / to
    marks, _ = described(cli, wc14 / "annotations", H=fits / "H", **found)
    assert set(marks.values()) == {"†"}
    shutil.copytree(wc14 / "annotations", moved := tmp_path / "moved" / "annotations")
    for path in moved.iterdir():
        content = json.loads(path.read_text())
        next(iter(content.values()))[0]["x"] += 0.001 / 959
        path.write_text(json.dumps(content))
    marks, tested = described(cli, moved, R=fits / "R", pnl=wc14 / "cameras_pnlcalib")
    assert marks == {"R": "‡", "pnl": ""}
    assert not tested


def test_the_test_keeps_its_level_for_the_true_camera():
    """Errors of clicks alone: p is uniform, and so is the combined one."""
    rng = np.random.default_rng(3)
    evidence = []
    for _ in range(4000):
        points = rng.uniform(0, 900, (14, 2))
        angles = rng.uniform(0, np.pi, 14)
        across = np.column_stack((np.cos(angles), np.sin(angles)))
        evidence.append(independence_evidence(points, across * rng.normal(0, 2, (14, 1))))
    shares = np.quantile(np.exp(-np.array(evidence)), (0.05, 0.5, 0.95))
    np.testing.assert_allclose(shares, (0.05, 0.5, 0.95), atol=0.02)
    for count in (1, 7, 200):
        limit = gamma.isf(0.001, count)
        assert not are_dependent(count, limit * 0.999)
        assert are_dependent(count, limit * 1.001)


def test_clicks_that_were_copied_from_frame_to_frame_count_once(sample_data):
    """As many p values would be one, repeated."""
    clicks = load_annotation(sample_data / "00008.json")
    camera, frames = fit_camera(clicks).camera, [f"{n:03}" for n in range(12)]
    of = {"fit": lambda _: camera}
    (found,) = compare_methods(dict.fromkeys(frames, clicks), of, resamples=100)["evaluations"]
    assert "too_close_to_clicks" not in found
    assert all(image["independence_p"] < 0.01 for image in found["images"])


def test_two_fits_are_compared_on_elements_that_both_determine(cli, wc14, tmp_path):
    (few := tmp_path / "few").mkdir()
    for path in sorted((wc14 / "annotations").iterdir())[:12]:
        shutil.copy(path, few)
    rows, out = {}, tmp_path / "s.json"
    for model in ("P", "R"):
        cli("calibrate", few, tmp_path / model, "--model", model, "--leave-one-out")
        found = [r for r in rows_in(tmp_path / model / "held_out.csv") if r["class"]]
        rows[model] = {(r["name"], r["class"]): float(r["held_out_px"] or "inf") for r in found}
    both = rows["P"].keys() & rows["R"].keys()
    cli(
        "evaluate", few, "--cameras", f"P={tmp_path / 'P'}", "--cameras", f"R={tmp_path / 'R'}",
        "--intervals", "-o", out,
    )  # fmt: skip
    chance = json.loads(out.read_text())["chance"][0]
    (row,) = chance["held_out_differences"]["rows"]
    assert row["elements"] == len(both)
    for model, key in (("P", "held_out_a"), ("R", "held_out_b")):
        assert row[key] == pytest.approx(np.mean([rows[model][at] < 5 for at in both]))
    key = "held_out_difference"
    assert row[f"{key}_low"] < row[key] < row[f"{key}_high"]
    assert row["p_holm"] is not None
    assert chance["differences"]["rows"][0]["p"] is None


def test_parts_do_not_depend_on_the_methods(cli, wc14, tmp_path):
    found = []
    named = {"pnl": "cameras_pnlcalib", "carwc": "homographies_carwc"}
    for methods in (["pnl"], ["pnl", "carwc"]):
        given = [a for m in methods for a in ("--cameras", f"{m}={wc14 / named[m]}")]
        out = tmp_path / "s.json"
        cli("evaluate", wc14 / "annotations", *given, "--by", "zoom", "--by", "side", "-o", out)
        content = json.loads(out.read_text())
        chance = content["chance"][0]
        found.append(
            [
                (row["value"], row["frames"], row["mean_jac"])
                for by in ("zoom", "side")
                for row in chance[f"by_{by}_figures"]["rows"]
                if row["source"] == "pnl"
            ]
        )
    assert found[0] == found[1]
    shares = [(r["completeness"], r["completeness_low"]) for r in chance["intervals"]["rows"]]
    frames = len(list((wc14 / "annotations").iterdir()))
    assert shares == [(1.0, pytest.approx(1 - 3 / frames, abs=1e-3))] * len(shares)
