"""``procc-annotator compare``: tables, files and pictures of two sources' disagreement."""

import json
import shutil
import zipfile
from pathlib import Path

import cv2
import numpy as np
import pytest

from procc_annotator.interaction.palette import DISAGREEMENT_COLOURS
from procc_annotator.metrics.error_maps import DISAGREEMENT_LEVELS_M
from tests.cli.conftest import PANS, camera_file, rows_in

pytestmark = pytest.mark.usefixtures("qapp")

SHIFT = (0.3, -0.4)  # metres: everything on the ground is half a metre off


@pytest.fixture
def other(dataset) -> Path:
    """The dataset's cameras, each moved by half a metre along the ground, but for frame 3."""
    folder = dataset.root / "other"
    folder.mkdir()
    for name, pan in PANS.items():
        x, y, z = 0.0, 60.0, -14.0
        dx, dy = (0.0, 0.0) if name == "3" else SHIFT
        moved = camera_file(pan, position_meters=[x + dx, y + dy, z])
        (folder / f"camera_{name}.json").write_text(json.dumps(moved))
    return folder


def test_a_known_shift_is_found_in_every_frame(cli, dataset, other, tmp_path):
    out = tmp_path / "out.json"
    done = cli("compare", f"ours={dataset.cameras}", f"theirs={other}", dataset.root, "-o", out)
    assert "Disagreement of ours and theirs in 5 frames" in done.stdout
    assert "theirs against ours as reference" in done.stdout
    content = json.loads(out.read_text())
    assert [content["a"]["name"], content["b"]["name"]] == ["ours", "theirs"]
    assert content["size"] == [960, 540]
    images = {image["name"]: image for image in content["images"]}
    assert list(images) == ["1", "2", "3", "10", "11"]
    for name, image in images.items():
        expected = 0.0 if name == "3" else 0.5
        for figure in ("minimum", "median", "maximum"):
            assert image["metres"][figure] == pytest.approx(expected, abs=1e-6)
        assert image["legacy"]["projection_m"] == pytest.approx(expected, abs=1e-6)
    assert images["3"]["legacy"]["iou_whole"] == pytest.approx(1.0)
    assert images["1"]["legacy"]["iou_whole"] == pytest.approx(
        (104.7 * 67.6) / (2 * 105 * 68 - 104.7 * 67.6)
    )
    summary = content["summary"]
    assert summary["frames"] == 5
    assert summary["metres"]["minimum"] == pytest.approx(0.0, abs=1e-6)
    assert summary["metres"]["median"] == pytest.approx(0.5, abs=1e-6)
    assert summary["legacy"]["projection_m"]["mean"] == pytest.approx(0.4, abs=1e-6)
    assert summary["legacy"]["projection_m"]["median"] == pytest.approx(0.5, abs=1e-6)


def test_distances_next_to_a_horizon_stay_readable(cli, dataset, other, tmp_path):
    """A camera that looks up sees some of the field kilometres away; files hold the number."""
    up = camera_file(PANS["1"], tilt_degrees=88.0)
    (other / "camera_1.json").write_text(json.dumps(up))
    out = tmp_path / "out.json"
    done = cli("compare", dataset.cameras, other, "-o", out)
    assert "> 1000" in done.stdout
    image = next(i for i in json.loads(out.read_text())["images"] if i["name"] == "1")
    assert image["metres"]["maximum"] > 1000
    assert image["legacy"]["projection_lost"] > 0


def test_csv_has_a_row_a_frame(cli, dataset, other, tmp_path):
    out = tmp_path / "out.csv"
    cli("compare", dataset.cameras, other, "-o", out)
    rows = {row["name"]: row for row in rows_in(out)}
    assert rows.keys() == PANS.keys()
    assert float(rows["1"]["metres_median"]) == pytest.approx(0.5, abs=1e-6)
    assert float(rows["3"]["pixels_max"]) == pytest.approx(0.0, abs=1e-6)
    assert float(rows["3"]["within_offside_accuracy"]) == 1.0
    assert rows["1"]["field"] == "soccer"
    assert rows["1"]["error"] == ""


def test_frames_of_one_source_only_are_named(cli, dataset, other):
    (other / "camera_2.json").unlink()
    (dataset.cameras / "camera_10.json").unlink()
    done = cli("compare", f"a={dataset.cameras}", f"b={other}", dataset.root)
    assert "in 3 frames" in done.stdout
    assert "only in a, not compared: 1 frame (2)" in done.stderr
    assert "only in b, not compared: 1 frame (10)" in done.stderr


def test_a_dataset_may_be_annotations_alone_or_zipped(cli, dataset, other, tmp_path):
    (dataset.annotations / "11.json").unlink()
    archive = tmp_path / "annotations.zip"
    with zipfile.ZipFile(archive, "w") as target:
        for path in dataset.annotations.glob("*.json"):
            target.write(path, path.name)
    for place in (dataset.annotations, archive):
        done = cli("compare", dataset.cameras, other, place)
        assert "in 4 frames" in done.stdout


def test_a_damaged_camera_is_listed_and_the_rest_compared(cli, dataset, other, tmp_path):
    (other / "camera_2.json").write_text("{")
    out = tmp_path / "out.csv"
    done = cli("compare", dataset.cameras, other, dataset.root, "-o", out, code=1)
    assert "in 4 frames" in done.stdout
    assert "camera_2.json" in done.stderr
    rows = {row["name"]: row for row in rows_in(out)}
    assert "camera_2.json" in rows["2"]["error"]
    assert rows["2"]["metres_median"] == ""


# -------------------------------------------------------------------------------------- pictures


def test_pictures_of_the_worst_frames(cli, dataset, other, tmp_path):
    far = camera_file(PANS["10"], position_meters=[0.0, 64.0, -14.0])
    (other / "camera_10.json").write_text(json.dumps(far))
    out = tmp_path / "pictures"
    done = cli("compare", dataset.cameras, other, dataset.root, "--pictures", out, "-n", 1)
    assert "1 disagreement picture written" in done.stdout
    assert [p.name for p in out.iterdir()] == ["10.png"]
    picture = cv2.imread(str(out / "10.png")).astype(int)
    assert picture.shape == (540, 960 + 430, 3)
    # Four metres off everywhere: one tone, that of 2.5 to 5 m, over the grey of the picture.
    tone = int(np.searchsorted(DISAGREEMENT_LEVELS_M, 4.0)) - 1
    red, green, blue = (int(DISAGREEMENT_COLOURS[tone][i : i + 2], 16) for i in (1, 3, 5))
    expected = 0.6 * np.array([blue, green, red]) + 0.4 * 90
    frame = picture[:, :960]
    assert (np.abs(frame - expected).max(axis=2) <= 3).mean() > 0.5
    assert np.abs(frame[5, 5] - 90).max() <= 3  # above the field nothing is painted
    # The tones of legend and map are those of the picture.
    assert (np.abs(picture[:, 960:] - expected).max(axis=2) <= 3).sum() > 2000


def test_pictures_as_vectors(cli, dataset, other, tmp_path):
    out, kind = tmp_path / "pictures", ("--format", "pdf", "-n", 1)
    cli("compare", dataset.cameras, other, dataset.root, "--pictures", out, *kind)
    (picture,) = out.iterdir()
    assert picture.suffix == ".pdf"
    assert picture.read_bytes().startswith(b"%PDF")


def test_frames_without_a_picture_are_drawn_on_grey(cli, dataset, other, tmp_path):
    out = tmp_path / "pictures"
    cli("compare", dataset.cameras, other, dataset.annotations, "--pictures", out, "-n", 0)
    assert sorted(p.stem for p in out.iterdir()) == sorted(PANS)


def test_a_large_picture_gets_a_large_panel(cli, dataset, other, tmp_path):
    large = np.full((1080, 1920, 3), 90, np.uint8)
    cv2.imwrite(str(dataset.root / "1.jpg"), large)
    cv2.imwrite(str(dataset.root / "2.jpg"), large[:180, :320])
    out = tmp_path / "pictures"
    cli("compare", dataset.cameras, other, dataset.root, "--pictures", out, "-n", 0)
    assert cv2.imread(str(out / "1.png")).shape == (1080, 1920 + 860, 3)
    assert cv2.imread(str(out / "2.png")).shape == (540, 320 + 430, 3)


def test_a_damaged_picture_is_listed(cli, dataset, other, tmp_path):
    (dataset.root / "2.jpg").write_bytes(b"not a picture")
    done = cli(
        "compare",
        dataset.cameras,
        other,
        dataset.root,
        "--pictures",
        tmp_path / "out",
        "-n",
        0,
        code=1,
    )
    assert "4 disagreement pictures" in done.stdout
    assert "2.jpg" in done.stderr


# ------------------------------------------------------------------------------------- real data


def test_some_of_the_world_cup(cli, shared_data, tmp_path):
    for source, name in (("homographies_carwc", "{}.npy"), ("cameras_nbjw", "camera_{}.json")):
        (tmp_path / source).mkdir()
        for path in (shared_data / "wc14" / source / name.format(i) for i in range(130, 150)):
            if path.exists():
                shutil.copy(path, tmp_path / source)
    out = tmp_path / "out.json"
    done = cli(
        "compare", f"carwc={tmp_path / 'homographies_carwc'}",
        f"nbjw={tmp_path / 'cameras_nbjw'}", shared_data / "wc14" / "annotations", "-o", out,
    )  # fmt: skip
    assert "only in carwc, not compared: 1 frame" in done.stderr
    assert "scaled from 1280x720 to 960x540 (19 cameras)" in done.stderr
    summary = json.loads(out.read_text())["summary"]
    assert summary["frames"] == 19
    assert 0.2 < summary["metres"]["median"] < 0.6
    assert 0.5 < summary["within_offside_accuracy"] < 0.9
    assert 0.95 < summary["legacy"]["iou_part"]["mean"] < 1


def test_requests_that_make_no_sense_are_refused_before_the_work(
    cli, dataset, tmp_path, monkeypatch
):
    def never(*_: object, **__: object) -> None:
        raise AssertionError("nothing may be compared")

    monkeypatch.setattr("procc_annotator.cli.compare.compare_sources", never)
    (tmp_path / "file").write_text("")
    given = ("compare", f"a={dataset.cameras}", f"b={dataset.cameras}", dataset.root)
    for place, why in ((tmp_path / "file", "is a file"), (dataset.root, "is the dataset itself")):
        done = cli(*given, "--pictures", place, code=2)
        assert why in done.stderr


def test_cameras_in_a_dataset_of_another_sport_are_told(cli, sample_data):
    court = sample_data / "basketball" / "cameras"
    done = cli("compare", court / "bad", court / "true")
    assert "the field Soccer does not know any of the" in done.stderr
    assert "name the dataset after B" in done.stderr
    assert "does not know" not in cli("compare", court / "bad", court / "true", court.parent).stderr


# ------------------------------------------------------------------------------------- intervals


@pytest.fixture
def far(dataset) -> Path:
    """The dataset's cameras, each moved by 1 to 3 metres."""
    folder = dataset.root / "far"
    folder.mkdir()
    for n, (name, pan) in enumerate(PANS.items()):
        moved = camera_file(pan, position_meters=[1.0 + 0.5 * n, 60.0, -14.0])
        (folder / f"camera_{name}.json").write_text(json.dumps(moved))
    return folder


def test_intervals_are_about_means_and_medians_of_frames(cli, dataset, far, tmp_path):
    out = tmp_path / "out.json"
    done = cli("compare", dataset.cameras, f"far={far}", "--intervals", "-o", out)
    assert "not clustered" in " ".join(done.stdout.split())
    content = json.loads(out.read_text())
    rows = {(r["figure"], r["over"]): r for r in content["chance"]["intervals"]["rows"]}
    mean = rows["frames' medians on the ground, m", "mean"]
    # Of 1, 1.5, 2, 2.5 and 3 m: mean 2, deviation of the mean 0.354, Student's quantile 2.776.
    assert mean["value"] == pytest.approx(2.0, abs=1e-6)
    assert mean["low"] == pytest.approx(2.0 - 2.776 * 0.35355, abs=1e-3)
    assert mean["high"] == pytest.approx(2.0 + 2.776 * 0.35355, abs=1e-3)
    median = rows["frames' medians on the ground, m", "median"]
    assert median["value"] == content["summary"]["metres"]["median"]
    assert 1.0 - 1e-6 <= median["low"] < median["value"] < median["high"] <= 3.0 + 1e-6
    within = rows["within 0.5 m, %", "share of all area"]
    assert (within["value"], within["low"]) == (0.0, 0.0)
    assert within["high"] == pytest.approx(3 / 5, abs=0.01)  # none of five: the rule of three
    plain = tmp_path / "plain.json"
    cli("compare", dataset.cameras, f"far={far}", "-o", plain)
    del content["chance"]
    assert json.loads(plain.read_text()) == content


def test_of_three_sources_the_nearer_one_is_told_where_frames_are_enough(
    cli, dataset, other, far, tmp_path
):
    out = tmp_path / "out.json"
    arguments = ("compare", f"true={dataset.cameras}", f"near={other}", "--versus", f"far={far}")
    cli(*arguments, "-o", out)
    rows = {r["figure"]: r for r in json.loads(out.read_text())["chance"]["nearer"]["rows"]}
    metres = rows["frames' medians on the ground, m"]
    assert metres["difference"] == pytest.approx(0.4 - 2.0, abs=1e-6)
    assert metres["high"] < 0.0
    # Five frames can be exchanged in 32 ways: no p is below 1/16.
    assert metres["p"] == pytest.approx(2 / 32)
    assert metres["nearer"] == "undecided"
    for name, pan in ((str(n), PANS["1"] + n / 2) for n in range(20, 40)):
        for folder, x in ((dataset.cameras, 0.0), (other, 0.3), (far, 1.0 + int(name) / 20)):
            moved = camera_file(pan, position_meters=[x, 60.0, -14.0])
            (folder / f"camera_{name}.json").write_text(json.dumps(moved))
    (far / "camera_1.json").unlink()
    (dataset.root / "tags.csv").write_text("frame,day\n20,a\n21,a\n22,b\n")
    cli(*arguments, "--tags", dataset.root / "tags.csv", "--cluster", "day", "-o", out)
    content = json.loads(out.read_text())["chance"]["nearer"]
    rows = {r["figure"]: r for r in content["rows"]}
    for figure in ("frames' medians on the ground, m", "IoU whole, %", "projection error, m"):
        assert rows[figure]["nearer"] == "near", figure
        assert rows[figure]["frames"] == 24
    assert "clusters by day" in content["notes"][0]
