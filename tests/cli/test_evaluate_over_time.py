"""``procc-annotator evaluate --over-time`` as a user runs it."""

import json
from pathlib import Path

import pytest

from tests.cli.conftest import annotation_text, camera_file, rows_in

FRAMES = 30


@pytest.fixture
def shot(tmp_path) -> Path:
    """A pan that goes faster and faster; every third frame is annotated. ``true`` cameras, ``late``
    ones by a frame."""
    pans = [-10 + 0.02 * n * n for n in range(FRAMES)]
    for name in ("annotations", "true", "late"):
        (tmp_path / name).mkdir()
    for n, pan in enumerate(pans):
        late = pans[max(n - 1, 0)]
        (tmp_path / "true" / f"camera_a_{n:03d}.json").write_text(json.dumps(camera_file(pan)))
        (tmp_path / "late" / f"camera_a_{n:03d}.json").write_text(json.dumps(camera_file(late)))
        if n % 3 == 1:
            (tmp_path / "annotations" / f"a_{n:03d}.json").write_text(annotation_text(pan))
    (tmp_path / "late" / "camera_a_010.json").unlink()
    return tmp_path


def arguments(shot: Path) -> list[str]:
    sources = [f"--cameras={name}={shot / name}" for name in ("true", "late")]
    return ["evaluate", str(shot / "annotations"), *sources, "--over-time"]


def test_tables_and_files_tell_late_cameras(cli, shot):
    out = [shot / "figures.json", shot / "frames.csv"]
    written = [f"--over-time-output={path}" for path in out]
    done = cli(*arguments(shot), *written)
    assert "shots by the names of frames" in done.output
    assert "cameras are 1 frame late" in done.output
    found = json.loads(out[0].read_text())
    true, late = found["over_time"]["rows"]
    assert (true["source"], true["shot"], true["frames"]) == ("true", "a", FRAMES)
    assert (true["offset"], true["offset_frames"], true["outages"]) == ("none", 0, 0)
    assert (late["offset_frames"], late["outages"], late["longest_outage"]) == (1, 1, 1)
    assert true["mean_jac"] == 1
    # 0.04 degrees a frame and frame: a second difference, as the error of one frame.
    assert true["jitter_pan_degrees"] == pytest.approx(0.04 / 6**0.5)
    assert true["jitter_position_m"] == pytest.approx(0, abs=1e-9)
    (outage,) = found["over_time_breaks"]["rows"]
    assert (outage["frame"], outage["what"], outage["length"]) == ("a_010", "outage", 1)
    rows = rows_in(out[1])
    assert len(rows) == 2 * FRAMES
    assert rows[1]["jac"] == "1.0"
    assert rows[FRAMES + 10]["camera"] == "false"


def test_a_table_beside_the_annotations_tells_the_shots(cli, shot):
    lines = [f"a_{n:03d},{'one' if n < 15 else 'two'}" for n in range(FRAMES)]
    (shot / "annotations" / "frames.csv").write_text("\n".join(["frame,shot", *lines]))
    done = cli(*arguments(shot), f"--over-time-output={shot / 'o.json'}")
    assert "shots by frames.csv" in done.output
    rows = json.loads((shot / "o.json").read_text())["over_time"]["rows"]
    shots = [(row["source"], row["shot"], row["frames"]) for row in rows]
    assert shots[:3] == [("true", "all 2 shots", 30), ("true", "one", 15), ("true", "two", 15)]


def test_fits_are_marked_wherever_they_are_told(cli, shot):
    fits, figures, frames = shot / "fits", shot / "figures.json", shot / "frames.csv"
    cli("calibrate", shot / "annotations", fits, "--model", "R")
    first = shot / "annotations" / "a_001.json"
    changed = json.loads(first.read_text())
    next(iter(changed.values()))[0]["x"] += 1e-6
    first.write_text(json.dumps(changed))
    sources = [f"--cameras=true={shot / 'true'}", f"--cameras=ours={fits}"]
    written = [f"--over-time-output={path}" for path in (figures, frames)]
    done = cli("evaluate", shot / "annotations", *sources, "--over-time", *written)
    tables = done.stdout[done.stdout.index("Over time") :]
    assert tables.count("ours†") == tables.count("Over time")
    assert tables.count("† fitted on these clicks: not ranked") == tables.count("Over time")
    assert "true†" not in tables
    true, ours = json.loads(figures.read_text())["over_time"]["rows"]
    assert (true["source"], true["fitted_on_these_clicks"]) == ("true", 0)
    assert (ours["source"], ours["fitted_on_these_clicks"]) == ("ours", FRAMES // 3 - 1)
    rows = rows_in(frames)
    assert [
        (row["source"], row["frame"]) for row in rows if row["fitted_on_these_clicks"] == "true"
    ] == [("ours", f"a_{n:03d}") for n in range(4, FRAMES, 3)]
    frames.unlink()  # in a dataset a table of this name tells of shots
    page = shot / "page.html"
    few = ("--worst", 0, "--random", 0, "--over-time", "-o", page)
    done = cli("report", shot / "annotations", *sources, *few)
    text = page.read_text()
    assert '<section id="over-time">' in text
    assert "Jitter of every frame" in text
    tables = (t.split("</table>")[0] for t in text.split("<table"))
    (breaks,) = (table for table in tables if "Jumps and outages</" in table)
    assert breaks.count("ours†") == breaks.count("ours") > 0


def test_cameras_of_the_ground_alone_leave_out_the_same_everywhere(cli, shot, sample_data):
    homographies = shot / "homographies"
    homographies.mkdir()
    (given,) = (sample_data / "cameras" / "homography").glob("*00002*")
    for n in range(3):
        (homographies / f"a_{n:03d}{given.suffix}").write_bytes(given.read_bytes())
    still = ("--off-plane", "left_out", "--over-time")
    words = "soccernet, 960x540, off-plane elements left out"
    out = shot / "report.json"
    cli("report", shot / "annotations", "--cameras", homographies, *still, "-o", out)
    found = json.loads(out.read_text())
    assert found["sources"][0]["described"] == words
    assert found["chance"][0]["described"] == words
    assert found["over_time"]["described"].startswith(f"{words}, JaC@5, shots")


def test_a_table_of_shots_tells_a_report_what_intervals_rest_on(cli, shot):
    lines = [f"a_{n:03d},{'one' if n < 15 else 'two'}" for n in range(FRAMES)]
    (shot / "shots.csv").write_text("\n".join(["frame,shot", *lines]))
    sources = [f"--cameras={name}={shot / name}" for name in ("true", "late")]
    asked = ("--over-time", "--shots", shot / "shots.csv", "--manifest", shot / "manifest.json")
    cli("report", shot / "annotations", *sources, *asked, "-o", shot / "report.json")
    (told,) = json.loads((shot / "report.json").read_text())["chance"]
    assert "2 clusters of one shot each, by shots.csv" in told["intervals"]["notes"][0]
    cli("repeat", shot / "manifest.json", "--data", shot)


def test_options_that_cannot_be(cli, shot, tmp_path):
    done = cli(*arguments(shot)[:-1], f"--shots={shot / 'x.csv'}", code=2)
    assert "--over-time" in done.output
    done = cli(*arguments(shot), f"--over-time-output={tmp_path / 'x.png'}", code=2)
    assert ".json or .csv" in done.output


def test_frames_that_do_not_follow_each_other_have_scores_and_a_note(cli, sample_data, tmp_path):
    files = {name: tmp_path / name for name in ("scores.json", "page.html", "time.json")}
    cameras = sample_data / "cameras" / "true"
    of_set = ("--cameras", f"a={cameras}", "--over-time", "--output")
    manifest = tmp_path / "manifest.json"
    done = cli("evaluate", sample_data, *of_set, files["scores.json"], "--manifest", manifest)
    page = cli("report", sample_data, *of_set, files["page.html"])
    for one in (done, page):
        assert one.exit_code == 0, one.output
        assert "sample_data, a: no metrics over time: the frames do not follow" in one.stderr
    without = cli("evaluate", sample_data, "--cameras", f"a={cameras}")
    assert without.stdout in done.stdout
    assert "over_time" not in json.loads(files["scores.json"].read_text())
    assert files["page.html"].exists()
    cli("repeat", manifest, "--data", sample_data)

    done = cli("evaluate", sample_data, *of_set, tmp_path / "more.json",
               "--over-time-output", files["time.json"], code=2)  # fmt: skip
    assert f"{files['time.json']}: not written" in done.stderr
    assert (tmp_path / "more.json").exists()


def test_a_manifest_repeats_them(cli, shot):
    manifest = shot / "manifest.json"
    cli(*arguments(shot), "--manifest", manifest)
    done = cli("repeat", manifest)
    assert (done.exit_code, "the same" in done.stdout) == (0, True), done.output
    camera = shot / "true" / "camera_a_012.json"  # of a frame that is not annotated
    camera.write_text(json.dumps(camera_file(-9.0)))
    done = cli("repeat", manifest, code=1)
    assert "other metric: over_time" in done.stdout
    assert "jitter_px" in done.stdout
    assert "mean_jac" not in done.stdout


def test_frames_that_cameras_call_otherwise_are_the_same_frames(cli, tmp_path):
    for game in ("g1", "g2"):
        (tmp_path / "clicks" / game / "img1").mkdir(parents=True)
        (tmp_path / "cameras" / game).mkdir(parents=True)
        for n in range(4):
            annotated = tmp_path / "clicks" / game / "img1" / f"{n:05d}.json"
            annotated.write_text(annotation_text(float(n)))
            camera = tmp_path / "cameras" / game / f"camera_{n:05d}.json"
            camera.write_text(json.dumps(camera_file(float(n))))
    out = tmp_path / "frames.csv"
    cli(
        "evaluate", tmp_path / "clicks", tmp_path / "cameras", "--over-time",
        "--over-time-output", out,
    )  # fmt: skip
    rows = rows_in(out)
    assert len(rows) == 8
    assert {row["jac"] for row in rows} == {"1.0"}
