"""``procc-annotator ground``: tables of pixels to metres and back, with what each row can know."""

import csv
import json

import numpy as np
import pytest

from procc_annotator import (
    UsageError,
    fit_camera,
    homography_of,
    load_annotation,
    load_camera,
    to_ground,
    to_pixels,
)
from procc_annotator.formats.point_tables import encode_table
from tests.cli.conftest import camera_file, rows_in


@pytest.fixture
def cameras(tmp_path):
    folder = tmp_path / "cameras"
    folder.mkdir()
    for name, pan in (("000003", 0.0), ("000010", 20.0)):
        (folder / f"camera_{name}.json").write_text(json.dumps(camera_file(pan)))
    return folder


def expected(cameras, x, y, name="000003"):
    loaded = load_camera(cameras / f"camera_{name}.json")
    return loaded.camera.ground_from_px(np.array([(x, y)]))[0]


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.csv", "frame,x,y\n3,420,300\n"),
        ("a.csv", "frame;x;y;w;h\n000003.jpg;400;210;40;90\n"),
        ("a.csv", "image,x1,y1,x2,y2\nimages/000003.png,400,210,440,300\n"),
        ("a.csv", "frame;x;y;note\r\n3;420,00;300,0;1,234\r\n"),
        ("a.txt", "frame  x y\n3 420.0  300\n"),
        ("a.csv", "frame;bbox\n3;[400, 210, 40, 90]\n"),
        ("a.csv", "frame,bbox_xyxy\n3,'[400, 210, 440, 300]'\n".replace("'", '"')),
        ("a.csv", "frame,x,y,width,height\n3,400,210,40,90\n"),
        ("a.csv", "frame,bb_left,bb_top,bb_width,bb_height\n3,400,210,40,90\n"),
        ("a.csv", "frame,xmin,ymin,xmax,ymax\n3,400,210,440,300\n"),
        ("a.csv", "frame,left,top,right,bottom\n3,400,210,440,300\n"),
        ("gt.txt", "3,7,400,210,40,90,1,-1,-1,-1\n"),
        ("gt.txt", "3 7 400 210  40 90 1 -1 -1 -1\n"),
        ("a.json", '[{"frame": 3, "bbox": [400, 210, 40, 90], "note": {"a": 1}}]'),
        ("a.json", '{"images": [{"id": 5, "file_name": "000003.jpg"}], "annotations":'
                   ' [{"image_id": 5, "bbox": [400, 210, 40, 90]}]}'),
    ],
)  # fmt: skip
def test_points_boxes_and_mot_files_are_placed_by_the_camera_of_their_number(
    cli, cameras, tmp_path, name, content
):
    points, out = tmp_path / name, tmp_path / "out.csv"
    points.write_text(content)
    assert (
        "1 of 1 row placed, 1 on the field"
        in cli("ground", points, "--cameras", cameras, "-o", out).stderr
    )
    (row,) = rows_in(out)
    np.testing.assert_allclose(
        (float(row["X"]), float(row["Y"])), expected(cameras, 420, 300), atol=1e-4
    )
    back = to_pixels(out, cameras).rows[0]
    is_box = "x,y,w" in content.replace(";", ",")
    corner = (400, 210) if is_box else (420, 300)  # a box stays where it is
    assert (back["x"], back["y"]) == pytest.approx(corner, abs=0.02)
    out.write_text(encode_table([row | {"X": 1.5, "Y": -2}, row | {"Y": 900}], ".csv").decode())
    cli("ground", out, "--cameras", cameras, "--to-pixels", "-o", points.with_suffix(".csv"))
    seen, unseen = to_ground(points.with_suffix(".csv"), cameras).rows
    assert (seen["X"], seen["Y"], unseen["X"]) == (1.5, -2.0, None)


def test_points_of_another_size_than_cameras_that_state_none_are_refused(cli, cameras, tmp_path):
    points, size = tmp_path / "a.csv", ("--size", "1920x1080")
    points.write_text("frame,x,y\n3,840,600\n")
    done = cli("ground", points, "--cameras", cameras, *size, code=2)
    assert "nothing says what picture size it belongs to" in done.stderr
    done = cli("ground", points, "--cameras", cameras, *size, "--camera-size", "960x540")
    assert "pixels are those of pictures of 1920x1080" in done.stderr
    (row,) = csv.DictReader(done.stdout.splitlines())
    x, y = (v * (n - 1) / (2 * n - 1) for v, n in ((840, 960), (600, 540)))
    coco = tmp_path / "coco.json"  # states its size
    image = '{"id": 1, "file_name": "000003.jpg", "width": 1920, "height": 1080}'
    box = '{"image_id": 1, "bbox": [820, 500, 40, 100]}'
    coco.write_text(f'{{"images": [{image}], "annotations": [{box}]}}')
    stated = to_ground(coco, cameras, camera_size=(960, 540)).rows[0]
    assert stated["X"] == pytest.approx(float(row["X"]), abs=1e-3)
    place = expected(cameras, x, y)
    assert (float(row["X"]), float(row["Y"])) == pytest.approx(tuple(place), abs=1e-3)
    with pytest.raises(UsageError, match="pixel_sd"):
        to_ground([{"frame": "3", "x": 1, "y": 1}], cameras, pixel_sd=-1)


def test_rows_without_a_place_stay_and_are_counted_with_their_reason(cli, cameras, tmp_path):
    points = tmp_path / "points.csv"
    points.write_text("frame,id,x,y\n3,007,420,300\n3,8,420,-900\n4,9,1,1\n10,10,,5\n")
    done = cli("ground", points, "--cameras", cameras)
    rows = list(csv.DictReader(done.stdout.splitlines()))
    assert [(row["id"], row["on_field"]) for row in rows] == [
        ("007", "true"),
        ("8", ""),
        ("9", ""),
        ("10", ""),
    ]
    for reason in ("out of sight", "no camera", "empty cells"):
        assert f"no place for 1 row: {reason}" in done.stderr


@pytest.mark.parametrize(
    ("content", "says"),
    [
        ("frame,a\n1,2\n", "expected frame and x, y or a box"),
        ("frame,x,y\n3,left,300\n", "row 1: expected numbers under x, y"),
        ("frame;x;y\n3;1,234;300\n", "row 1: expected numbers under x, y"),
        ("frame,x,y\n3,1\n", "has 2 cells"),
        ("frame,x,y\n7,1,2\n", "frame 7: 2 end in this number: a_000007, b_000007"),
        ("frame,x,y\n4,1,2\n", "0 of 1 row placed"),
    ],
)
def test_a_table_that_cannot_be_used_is_refused_with_the_place(
    cli, cameras, tmp_path, content, says
):
    points = tmp_path / "points.csv"
    points.write_text(content)
    for name in ("a", "b"):
        (cameras / f"camera_{name}_000007.json").write_text(json.dumps(camera_file(0.0)))
    assert says in cli("ground", points, "--cameras", cameras, code=2).stderr
    with pytest.raises(UsageError, match="unknown axes"):
        to_ground([{"frame": 3, "x": 1, "y": 2}], cameras, axes="down")


@pytest.mark.parametrize("axes", ["field", "up", "corner", "metrica"])
def test_axes_and_the_way_back(cameras, axes):
    rows = [{"frame": 3, "x": 420, "y": 300}]
    x, y = expected(cameras, 420, 300)
    found = to_ground(rows, cameras, axes=axes)
    there = {
        "field": (x, y),
        "up": (x, -y),
        "corner": (x + 52.5, y + 34),
        "metrica": (x / 105 + 0.5, y / 68 + 0.5),
    }
    assert (found.rows[0]["X"], found.rows[0]["Y"]) == pytest.approx(there[axes], abs=1e-4)
    positions = [{key: row[key] for key in ("frame", "X", "Y")} for row in found.rows]
    assert to_pixels(positions, cameras, axes=axes).rows[0]["x"] == pytest.approx(420, abs=0.5)
    assert to_pixels(found.rows, cameras).rows == to_pixels(found.rows, cameras, axes=axes).rows
    other = "corner" if axes == "up" else "up"
    if axes != "field":  # the rows say theirs
        with pytest.raises(UsageError, match=f"in the axes {axes}, not {other}"):
            to_pixels(found.rows, cameras, axes=other)


def test_standard_deviations_by_the_camera_and_by_the_pixel(sample_data, cli, tmp_path):
    fit = fit_camera(load_annotation(sample_data / "00002.json"))
    rows = [{"frame": "00002", "x": 480.0, "y": 300.0}]
    cli("calibrate", sample_data, tmp_path / "fits")
    ground = fit.ground_from_px(np.array([(480.0, 300.0)]))
    for sd, cameras in ((None, {"00002": fit}), (2.0, lambda _: fit), (2.0, tmp_path / "fits")):
        row = to_ground(rows, cameras, pixel_sd=sd, size=fit.size).rows[0]
        variance = fit.ground_covariance(ground, pixel_sd=sd or 0.0)[0]
        assert row["sigma_x"] == pytest.approx(variance[0, 0] ** 0.5, rel=0.05, abs=1e-4)
    assert "sigma_x" not in to_ground(rows, sample_data / "cameras" / "bad").rows[0]
    alone = to_ground(rows, sample_data / "cameras" / "bad", pixel_sd=1.0)
    assert alone.rows[0]["sigma_x"] > 0
    assert "pixels alone" in alone.notes[1]


def test_a_bent_camera_becomes_the_nearest_homography_of_a_region_with_its_errors(
    cli, cameras, tmp_path
):
    bent = camera_file(0.0, radial_distortion=[-0.15, 0, 0, 0, 0, 0])
    (cameras / "camera_000003.json").write_text(json.dumps(bent))
    sized = ("--to", "world", "--camera-size", "960x540")
    refused = cli("convert", cameras, tmp_path / "a", *sized, code=1)
    assert "lens distortion (--region field" in refused.stderr
    done = cli("convert", cameras, tmp_path / "b", *sized, "--region=-10,-10,10,10")
    assert "000003 0." in done.stderr
    bent_camera = load_camera(cameras / "camera_000003.json")
    written = load_camera(tmp_path / "b" / "000003.txt", format="world")
    whole, part = (
        homography_of(bent_camera, region, size=(1280, 720), camera_size=(960, 540))
        for region in ("field", (-10, -10, 10, 10))
    )
    px = np.array([(640.0, 400.0)])
    np.testing.assert_allclose(
        written.camera.ground_from_px(px), part.camera.ground_from_px(px), atol=1e-3
    )
    off = written.camera.ground_from_px(px) - expected(cameras, 480, 300)
    assert 0 < part.mean_m < part.max_m < whole.max_m
    assert np.hypot(*off[0]) < 0.5
    for region, size, says in [
        ("here", (960, 540), "expected field, or"),
        ((80, 80, 90, 90), (960, 540), "too little"),
        ("field", None, "states no picture size"),
    ]:
        with pytest.raises(UsageError, match=says):
            homography_of(bent_camera, region, size=size)
    cli("convert", cameras, tmp_path / "c", "--to", "krt", "--region", "field", code=2)
