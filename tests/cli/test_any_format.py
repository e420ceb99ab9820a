"""Commands read annotations of every format as they read the program's own."""

import json
from pathlib import Path

import pytest

from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.proposal import Proposal
from procc_annotator.calibration.tracking import shot_tracker
from procc_annotator.field.load import load_field

FORMATS = ("labelme", "cvat", "coco", "soccernet-v3", "soccernet-gsr")


@pytest.mark.parametrize("fmt", FORMATS)
def test_figures_are_those_of_the_annotations_themselves(cli, dataset, tmp_path, fmt):
    cameras = dataset.cameras
    cli("convert", dataset.root, tmp_path / fmt, "--to", fmt)
    scores = {}
    for name, place in (("own", dataset.annotations), (fmt, tmp_path / fmt)):
        file = tmp_path / f"{name}.json"
        done = cli("evaluate", place, cameras, "-o", file, code=None)
        assert done.exit_code in (0, 1), done.stderr
        scores[name] = json.loads(file.read_text())["summary"]
    assert scores[fmt] == scores["own"]
    assert ": read as" in done.stderr


@pytest.mark.parametrize("inner", ["img1", "v3_frames"])
def test_cameras_are_found_with_the_folder_of_the_pictures_and_without(
    cli, sample_data, tmp_path, inner
):
    """Methods name a frame as the file of labels does, or as the picture lies."""
    one = next(iter(sorted(sample_data.glob("0*.json"))))
    camera = sample_data / "cameras" / "pinhole" / f"camera_{one.name}"
    for place, file in (("with", one), ("without", one), ("cams", camera), ("cams_in", camera)):
        for match in ("a", "b"):
            folder = tmp_path / place / match / (inner if place in ("with", "cams_in") else "")
            folder.mkdir(parents=True)
            (folder / file.name).write_bytes(file.read_bytes())
    for clicks, cameras in (("with", "cams"), ("without", "cams_in")):
        done = cli("evaluate", tmp_path / clicks, tmp_path / cameras)
        assert "2 frames, 2 with a camera" in done.stdout
        assert "not counted" not in done.stderr + done.stdout


def test_a_table_at_the_top_of_a_tree_is_no_frame(cli, sample_data, tmp_path):
    one = next(iter(sorted((sample_data).glob("0*.json"))))
    (tmp_path / "set" / "game").mkdir(parents=True)
    (tmp_path / "set" / "other").mkdir()
    (tmp_path / "set" / "sequences_info.json").write_text('{"version": "1.3"}')
    (tmp_path / "set" / "game" / one.name).write_bytes(one.read_bytes())
    (tmp_path / "set" / "other" / one.name).write_bytes(one.read_bytes())
    done = cli("check", tmp_path / "set", "--no-line-evidence")
    assert "2 frames" in done.stdout + done.stderr


@pytest.fixture
def in_coco(cli, dataset, tmp_path) -> Path:
    """The dataset's pictures, and its annotations as COCO beside them."""
    place = tmp_path / "in_coco"
    place.mkdir()
    for picture in dataset.root.glob("*.jpg"):
        (place / picture.name).write_bytes(picture.read_bytes())
    cli("convert", dataset.root, place / "annotations.json", "--to", "coco")
    return place


def test_export_and_render_of_another_format(cli, dataset, in_coco, tmp_path):
    for name, place in (("own", dataset.root), ("coco", in_coco)):
        done = cli(
            "export", place, tmp_path / f"{name}_out", "--cameras", dataset.cameras, code=None
        )
        assert done.exit_code in (0, 1), done.stderr
    own, read = (json.loads((tmp_path / f"{n}_out/jac.json").read_text()) for n in ("own", "coco"))
    assert read["summary"] == own["summary"]
    assert any(figures["mean_jac"] == 1.0 for figures in read["summary"].values())
    assert "read as COCO" in done.stderr
    done = cli("render", in_coco, tmp_path / "pictures", "--cameras", dataset.cameras, code=None)
    assert done.exit_code in (0, 1), done.stderr
    assert list((tmp_path / "pictures").glob("*.png"))


def test_frames_annotated_in_another_format_are_passed_over(cli, dataset, in_coco, tmp_path):
    done = cli("propose", in_coco, tmp_path / "proposed", code=2)
    assert "all frames are annotated" in done.stderr
    done = cli("annotate", in_coco, in_coco, "--cameras", dataset.cameras)
    assert "not touched: 5 frames annotated already" in done.stdout, done.stderr
    assert not list(in_coco.glob("[0-9]*.json"))


def test_a_release_of_another_format_holds_the_annotations(cli, dataset, in_coco, tmp_path):
    done = cli("release", in_coco, tmp_path / "out", "--no-check", code=None)
    assert done.exit_code in (0, 1), done.stderr
    assert len(list((tmp_path / "out").rglob("annotations/*.json"))) == len(
        list(dataset.annotations.glob("[0-9]*.json"))
    )


def test_a_frame_of_another_format_among_ours_is_told_so(cli, dataset, tmp_path):
    cli("convert", dataset.root, tmp_path / "lm", "--to", "labelme")
    (dataset.annotations / "3.json").write_bytes((tmp_path / "lm" / "3.json").read_bytes())
    for command in (
        ("check", dataset.annotations, "--no-line-evidence"),
        ("export", dataset.root, tmp_path / "out"),
        ("propose", dataset.root, tmp_path / "proposed"),
    ):
        done = cli(*command, code=None)
        assert "is labelme JSON, expected SoccerNet-calibration JSON" in done.stderr, command
        assert "convert" in done.stderr


def test_what_lies_there_instead_is_told_with_the_command(cli, dataset, tmp_path):
    bare = tmp_path / "bare"
    bare.mkdir()
    for picture in dataset.root.glob("*.jpg"):
        (bare / picture.name).write_bytes(picture.read_bytes())
    done = cli("evaluate", bare, dataset.cameras, code=2)
    assert f"it holds 5 pictures, not annotated yet: procc-annotator open {bare}" in done.stderr
    done = cli("evaluate", dataset.cameras, dataset.cameras, code=2)
    assert "it holds 5 cameras (camera_*): give the annotations" in done.stderr
    cli("convert", dataset.root, tmp_path / "lm", "--to", "labelme")
    assert "5 pictures written" in cli("render", tmp_path / "lm", tmp_path / "out").stdout


def test_cameras_instead_of_annotations_are_told_by_their_format(cli, dataset, tmp_path):
    cli("convert", dataset.cameras, tmp_path / "krt", "--to", "krt")
    labels = tmp_path / "labels.toml"
    for command in (
        ("check", tmp_path / "krt"),
        ("convert", tmp_path / "krt", tmp_path / "out", "--to", "coco"),
        ("propose-map", tmp_path / "krt", "--output", labels),
    ):
        done = cli(*command, code=2)
        assert "it holds 5 files of cameras (K, R, t and distortion)" in done.stderr, command
        assert "expected a point" not in done.stderr, command
    matrices = tmp_path / "matrices"
    matrices.mkdir()
    (matrices / "1.npy").write_bytes(b"whatever")
    done = cli("calibrate", matrices, tmp_path / "fitted", code=2)
    assert "it holds 1 file of cameras (.npy): give the annotations" in done.stderr
    done = cli("check", matrices / "1.npy", code=2)
    assert "it is a file of cameras by its name (.npy)" in done.stderr


def test_an_empty_annotation_is_not_taken_for_a_camera(cli, tmp_path):
    (tmp_path / "1.json").write_text('{"Middle line": []}')
    (tmp_path / "2.json").write_text("{}")
    done = cli("check", tmp_path, "--no-line-evidence")
    assert "2 frames have no element at all" in done.stdout


def test_yolo_pose_is_told_where_annotations_are_asked_for(cli, dataset, tmp_path):
    out = tmp_path / "yolo"
    cli("convert", dataset.root, out, "--to", "yolo-pose", "--pictures")
    for place in (out, out / "labels"):
        done = cli("evaluate", place, dataset.cameras, code=2)
        assert "it holds 5 files of YOLO pose, which is not read" in done.stderr
        assert "choose one" not in done.stderr
    done = cli("evaluate", dataset.annotations, out, code=2)
    assert "it holds 5 files of YOLO pose, which is not read" in done.stderr
    done = cli("convert", out, tmp_path / "back", "--to", "coco", code=2)
    assert "it holds 5 files of YOLO pose, which is not read" in done.stderr


def test_annotations_instead_of_cameras_are_told_by_their_format(cli, dataset, in_coco, tmp_path):
    cli("convert", dataset.root, tmp_path / "cvat.xml", "--to", "cvat")
    for place, title in ((in_coco, "COCO"), (tmp_path / "cvat.xml", "CVAT for images 1.1")):
        done = cli("evaluate", dataset.annotations, place, code=2)
        assert f"it holds annotations ({title}" in done.stderr
        assert f"procc-annotator calibrate {place}" in done.stderr
        for command in (
            ("compare", f"a={place}", f"b={dataset.cameras}", dataset.root),
            ("annotate", dataset.root, tmp_path / "out", "--cameras", place),
        ):
            done = cli(*command, code=2)
            assert f"no camera in {place}; it holds annotations ({title}" in done.stderr, command
    (tmp_path / "notes.md").write_text("no cameras")
    done = cli("evaluate", dataset.annotations, tmp_path / "notes.md", code=2)
    assert "cameras are looked for in files of .bin, .csv, .dlt2d" in done.stderr


@pytest.mark.parametrize("fmt", ["cvat", "coco", "soccernet-v3", "soccernet-gsr"])
def test_what_was_taken_in_stands_for_the_file_it_came_from(cli, dataset, tmp_path, fmt):
    """After an import the frames' own files lie beside the file of the other program."""
    both = tmp_path / "both"
    cli("convert", dataset.root, both, "--to", fmt)
    cli("convert", dataset.root, tmp_path / "own", "--to", "soccernet")
    inner = both / "annotations" if (both / "annotations").is_dir() else both
    own = sorted((tmp_path / "own").glob("*.json"))
    for file in own:
        (inner / file.name).write_bytes(file.read_bytes())
    out = tmp_path / "out"
    for args in (
        ("check", both, "--no-line-evidence"),
        ("convert", both, out, "--to", "soccernet"),
    ):
        done = cli(*args)
        assert f"{len(own)} frames" in done.output


# ``--map``: names of another program, with every command that reads annotations.


@pytest.fixture
def renamed(cli, dataset, tmp_path) -> tuple[Path, Path]:
    """The dataset as labelme files whose labels are numbers, and the map back."""
    folder = tmp_path / "renamed"
    cli("convert", dataset.root, folder, "--to", "labelme")
    names = [e.name.strip() for e in load_field(None).elements]
    for file in folder.glob("*.json"):
        content = json.loads(file.read_text())
        for shape in content["shapes"]:
            shape["label"] = f"element {names.index(shape['label'].strip())}"
        file.write_text(json.dumps(content))
    labels = tmp_path / "names.toml"
    rules = [f'"element {i}" = "{name}"' for i, name in enumerate(names)]
    labels.write_text("\n".join(["[labels]", *rules]))
    return folder, labels


def test_figures_are_those_of_the_official_names(cli, dataset, renamed, tmp_path):
    folder, labels = renamed
    cameras = dataset.cameras
    cli("evaluate", dataset.annotations, cameras, "-o", tmp_path / "own.json")
    manifest = tmp_path / "manifest.json"
    done = cli(
        "evaluate",
        folder,
        cameras,
        "--map",
        labels,
        "-o",
        tmp_path / "s.json",
        "--manifest",
        manifest,
    )
    assert "names by" in done.stderr
    summaries = [json.loads((tmp_path / f"{n}.json").read_text())["summary"] for n in ("own", "s")]
    assert summaries[0] == summaries[1]
    cli("repeat", manifest)
    agreed = cli("agree", dataset.annotations, folder, "--map", labels)
    assert "100.00" in agreed.stdout


def test_the_map_of_a_dataset_is_used_by_itself(cli, renamed, tmp_path):
    folder, labels = renamed
    (folder / "labels.toml").write_bytes(labels.read_bytes())
    done = cli("check", folder, "--no-line-evidence")
    assert "unknown class" not in done.stdout
    cli("convert", folder, tmp_path / "back", "--to", "soccernet")
    classes = {
        name for f in (tmp_path / "back").glob("*.json") for name in json.loads(f.read_text())
    }
    assert classes <= {e.name for e in load_field(None).elements}


def test_an_export_has_the_official_names(cli, dataset, renamed, tmp_path):
    """Of annotations alone, and of a dataset with pictures."""
    folder, labels = renamed
    for place in (folder, dataset.root):
        if place is dataset.root:
            for file in dataset.annotations.glob("*.json"):
                content = json.loads(file.read_text())
                names = [e.name for e in load_field(None).elements]
                named = {f"element {names.index(n)}": p for n, p in content.items()}
                file.write_text(json.dumps(named))
        out = tmp_path / f"out_{place.name}"
        cli("export", place, out, "--map", labels)
        frames = [f for f in out.glob("*.json") if not f.name.startswith("jac")]
        assert len(frames) == 5
        classes = {name for f in frames for name in json.loads(f.read_text())}
        assert classes >= {"Middle line", "Side line top"}
        assert not any(name.startswith("element ") for name in classes)


def test_unknown_labels_are_listed_once_with_counts(cli, renamed):
    folder, _ = renamed
    done = cli("check", folder, "--no-line-evidence")
    lines = [line for line in done.stderr.splitlines() if "does not know" in line]
    assert len(lines) == 1
    assert "does not know 26 labels: element " in lines[0]
    assert "and 14 more" in lines[0]
    assert "labels.toml" in lines[0]


def test_a_map_that_is_wrong_is_one_line(cli, renamed):
    folder, labels = renamed
    labels.write_text('[labels]\n"element 1" = "Side line bottm"')
    done = cli("check", folder, "--map", labels, code=2)
    assert len(done.stderr.splitlines()) == 1
    assert "line 2: label 'element 1'" in done.stderr
    assert "did you mean 'Side line bottom'?" in done.stderr


def test_pictures_are_drawn_by_the_map(cli, dataset, renamed, tmp_path):
    folder, labels = renamed
    runs = {
        "own": ("--annotations", dataset.annotations),
        "mapped": ("--annotations", folder, "--map", labels),
        "unnamed": ("--annotations", folder),
    }
    drawn = {}
    for name, given in runs.items():
        out = tmp_path / name
        cli("render", dataset.root, out, "--cameras", dataset.cameras, *given)
        drawn[name] = {file.name: file.read_bytes() for file in out.glob("*.png")}
    assert len(drawn["own"]) == 5
    assert drawn["mapped"] == drawn["own"]
    assert drawn["unnamed"] != drawn["own"]
    (dataset.root / "labels.toml").write_bytes(labels.read_bytes())
    by_itself = tmp_path / "by_itself"
    args = ("--cameras", dataset.cameras, "--annotations", folder)
    cli("render", dataset.root, by_itself, *args)
    assert {file.name: file.read_bytes() for file in by_itself.glob("*.png")} == drawn["own"]


def test_anchors_of_a_track_are_fitted_by_the_map(cli, dataset, renamed, monkeypatch, tmp_path):
    """Nothing is found in pictures alone, which would take long where no anchor is known."""
    folder, labels = renamed

    def none(picture, field, *, known, **_) -> Proposal:
        why = "not looked for"
        fit = FitResult("R", (picture.shape[1], picture.shape[0]), None, why)
        return Proposal("none", why, fit, 0.0, 0.0, None, 0.0, None)

    monkeypatch.setattr(shot_tracker, "propose_camera", none)
    said = []
    for given in ((), ("--map", labels)):
        out = tmp_path / f"tracked{len(given)}"
        done = cli("track", dataset.root, out, "--annotations", folder, *given)
        said.append("no frame here has a camera in" in done.stderr)
    assert said == [True, False]


def test_annotated_frames_are_told_by_the_map(cli, dataset, renamed, tmp_path):
    folder, labels = renamed
    done = cli(
        "propose", dataset.root, tmp_path / "p", "--annotations", folder, "--map", labels, code=2
    )
    assert "names by" in done.stderr
    assert "all frames are annotated" in done.stderr
    done = cli("annotate", dataset.root, folder, "--cameras", dataset.cameras, "--map", labels)
    assert "names by" in done.stderr
    assert "not touched: 5 frames annotated already" in done.stdout
