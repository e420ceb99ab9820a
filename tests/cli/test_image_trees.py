"""Pictures in folders of folders: a frame is called by its path, in every command."""

import csv
import json
import os
import shutil
import zipfile
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
import pytest

from procc_annotator import load_dataset
from procc_annotator.dataset.frames import list_frames
from procc_annotator.dataset.sequence import FEWEST, sequence_of
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.field.load import load_field
from procc_annotator.report.conversion import read_annotations
from tests.cli.conftest import rows_in

MATCHES = ("a/img1", "b/img1")
FRAMES = ("00001", "00002")
NAMES = [f"{match}/{frame}" for match in MATCHES for frame in FRAMES]


@dataclass(frozen=True)
class Tree:
    root: Path
    cameras: Path


@pytest.fixture
def tree(sample_data, tmp_path) -> Tree:
    """Two matches whose pictures have the same names, annotated beside them."""
    made = Tree(tmp_path / "season", tmp_path / "cameras")
    for match in MATCHES:
        for place in (made.root, made.cameras):
            (place / match).mkdir(parents=True)
        for frame in FRAMES:
            for suffix in (".jpg", ".json"):
                shutil.copy(sample_data / f"{frame}{suffix}", made.root / match)
            camera = f"camera_{frame}.json"
            shutil.copy(sample_data / "cameras" / "pinhole" / camera, made.cameras / match)
    return made


def test_every_picture_is_a_frame_of_its_own(tree):
    root, frames, notices = list_frames(tree.root)
    assert root == tree.root
    assert [frame.name for frame in frames] == NAMES
    assert notices == ()
    assert [f.annotation_path for f in frames] == [tree.root / f"{name}.json" for name in NAMES]


def test_commands_agree_on_the_names_of_frames(cli, tree, tmp_path):
    out = tmp_path / "s.csv"
    cli("evaluate", tree.root, tree.cameras, "-o", out)
    with out.open(encoding="utf-8") as file:
        rows = list(csv.reader(file))
    evaluated = {cell for row in rows for cell in row if cell.endswith(FRAMES)}
    done = cli("export", tree.root, tmp_path / "out.zip", "--cameras", tree.cameras)
    with zipfile.ZipFile(tmp_path / "out.zip") as archive:
        exported = {name.removesuffix(".json") for name in archive.namelist()} - {"jac", "jac.csv"}
        scores = json.loads(archive.read("jac.json"))
    assert evaluated == exported == set(NAMES)
    assert "4 frames" in done.stdout
    assert scores["summary"]


def test_pictures_and_cameras_are_written_into_folders_as_they_lie(cli, tree, tmp_path):
    cli("render", tree.root, tmp_path / "r", "--cameras", tree.cameras)
    cli("calibrate", tree.root, tmp_path / "c")
    cli("convert", tree.cameras, tmp_path / "k", "--to", "opencv")
    for name in NAMES:
        match, _, frame = name.rpartition("/")
        assert (tmp_path / "r" / f"{name}.png").is_file()
        assert (tmp_path / "c" / match / f"camera_{frame}.json").is_file()
        assert list((tmp_path / "k" / match).glob(f"*{frame}*"))
    done = cli("render", tree.root, tmp_path / "r", "--cameras", tree.cameras, code=2)
    assert "holds a/img1/00001.png and 3 more" in done.stderr


@pytest.mark.parametrize("fmt", ["soccernet", "labelme", "cvat", "coco", "soccernet-gsr"])
def test_other_formats_hold_a_tree_with_its_pictures(cli, tree, tmp_path, fmt):
    place = tmp_path / "there"
    cli("convert", tree.root, place, "--to", fmt, "--pictures")
    assert len(list(place.rglob("*.jpg"))) == len(NAMES)
    cli("evaluate", place, tree.cameras, "-o", tmp_path / "s.csv")
    text = (tmp_path / "s.csv").read_text()
    assert all(name in text for name in NAMES)


def test_what_one_match_has_goes_with_the_whole_tree(cli, tree, tmp_path):
    """Cameras of one match alone lie in the only folder of their place."""
    for place in (tree.root, tree.cameras):
        for match in ("a", "b"):
            for file in (place / match / "img1").iterdir():
                file.rename(place / match / file.name)
            (place / match / "img1").rmdir()
    shutil.rmtree(tree.cameras / "b")
    cli("export", tree.root, tmp_path / "out", "--cameras", tree.cameras)
    scored = {row["name"]: row["camera"] for row in rows_in(tmp_path / "out/jac.csv")}
    assert set(scored) == {"a/00001", "a/00002", "b/00001", "b/00002"}
    assert [bool(scored[name]) for name in sorted(scored)] == [True, True, False, False]


def test_clicks_of_one_match_are_not_judged_by_cameras_of_another(cli, tree):
    """Each lies in the only folder of its place, which is otherwise no part of a frame's name."""
    for match in ("a", "b"):
        for place in (tree.root / match, tree.cameras / match):
            for file in (place / "img1").iterdir():
                file.rename(place / file.name)
            (place / "img1").rmdir()
        kept = tree.root / "annotations" / match
        kept.mkdir(parents=True)
        for file in (tree.root / match).glob("*.json"):
            file.rename(kept / file.name)
    shutil.rmtree(tree.root / "annotations/b")
    (tree.cameras / "a").rename(tree.root.parent / "a")
    done = cli("evaluate", tree.root, tree.cameras, code=2)
    assert "annotations are named like 'a/00001', cameras like 'b/00001'" in done.stderr
    shutil.rmtree(tree.cameras / "b")
    (tree.root.parent / "a").rename(tree.cameras / "a")
    figures = tree.root.parent / "figures.csv"
    cli("evaluate", tree.root, tree.cameras, "-o", figures)
    assert {row["name"] for row in rows_in(figures)} == {"a/00001", "a/00002"}
    (tree.cameras / "a").rename(tree.cameras / "any method")  # of which match nobody says
    cli("evaluate", tree.root, tree.cameras, code=2)
    inside = tree.root / "annotations/a"
    assert "2 frames" in cli("evaluate", inside, tree.cameras).stdout


def test_annotations_may_lie_apart_in_folders_of_the_same_names(cli, tree, tmp_path):
    for match in MATCHES:
        for frame in FRAMES:
            (tree.root / match / f"{frame}.json").unlink()
    cli("annotate", tree.root, tree.root / "annotations", "--cameras", tree.cameras)
    assert (tree.root / "annotations/a/img1/00002.json").is_file()
    workspace = Workspace.open(tree.root, load_field())
    assert all(workspace.annotated_count(index) for index in range(len(NAMES)))
    cli("check", tree.root, "--no-line-evidence")
    assert "4 frames" in cli("evaluate", tree.root, tree.cameras).stdout


def test_game_state_folders_go_by_their_pictures(cli, tree, tmp_path):
    """Its file lies above img1 and leaves that folder out."""
    for match in MATCHES:
        folder = tree.root / match
        game = folder.parent
        cli("convert", folder, game, "--to", "soccernet-gsr")
        for frame in FRAMES:
            (folder / f"{frame}.json").unlink()
    done = cli("evaluate", tree.root, tree.cameras, "-o", tmp_path / "s.csv")
    assert all(name in (tmp_path / "s.csv").read_text() for name in NAMES)
    done = cli("propose", tree.root, tmp_path / "p", code=2)
    assert "all frames are annotated" in done.stderr
    read = load_dataset(tree.root)
    assert list(read.annotations) == list(read.pictures) == NAMES
    imported = read_annotations(tree.root, Workspace.open(tree.root, load_field()))
    assert list(imported.frames) == NAMES


def test_pictures_of_one_folder_keep_plain_names(sample_data, tmp_path):
    (tmp_path / "game/img1").mkdir(parents=True)
    shutil.copy(sample_data / "00001.jpg", tmp_path / "game/img1")
    _, (frame,), _ = list_frames(tmp_path / "game")
    assert frame.name == "00001"
    assert frame.annotation_path == tmp_path / "game/annotations/00001.json"
    shutil.copy(sample_data / "00001.json", tmp_path / "game/img1")
    _, (frame,), _ = list_frames(tmp_path / "game")
    assert frame.annotation_path == tmp_path / "game/img1/00001.json"


def test_a_damaged_tree_loses_only_what_is_damaged(cli, tree, tmp_path):
    (tree.root / "a" / "again").symlink_to(tree.root, target_is_directory=True)
    (tree.root / "b" / "nowhere.jpg").symlink_to(tree.root / "gone.jpg")
    (tree.root / "b/img1/00001.json").write_text("{")
    done = cli("export", tree.root, tmp_path / "out", code=1)
    assert "b/img1/00001.json" in done.stderr
    written = {p.relative_to(tmp_path / "out").as_posix() for p in (tmp_path / "out").rglob("0*")}
    assert written == {f"{name}.json" for name in NAMES if name != "b/img1/00001"}


def test_an_unreadable_folder_is_told_and_the_others_are_there(tree, monkeypatch):
    """As a disk with a fault does: permissions do not stop everybody."""
    listed = os.scandir

    def scandir(path):
        if str(path).rstrip("/").endswith("season/a"):
            raise OSError(5, "Input/output error")
        return listed(path)

    monkeypatch.setattr(os, "scandir", scandir)
    _, frames, notices = list_frames(tree.root)
    assert [frame.name for frame in frames] == NAMES[2:]
    assert len(notices) == 1
    assert "a/: cannot be listed: Input/output error" in notices[0].replace("season/a:", "a/:")


def test_what_is_annotated_in_a_tree_is_saved_beside_its_picture(tree):
    (tree.root / "b/img1/00002.json").unlink()
    workspace = Workspace.open(tree.root, load_field())
    index = workspace.index["b/img1/00002"]
    workspace.edit(index, "taken over", workspace.read(workspace.index["a/img1/00002"]))
    workspace.save(index)
    texts = [(tree.root / m / "00002.json").read_bytes() for m in MATCHES]
    assert texts[0] == texts[1]
    assert {p.name for p in tree.root.rglob("*.json")} == {f"{frame}.json" for frame in FRAMES}


def test_nothing_is_written_over_a_tree_that_is_read(cli, tree):
    before = {p: p.read_bytes() for p in tree.root.rglob("*.*") if p.is_file()}
    for command in (
        ("export", tree.root, tree.root, "--overwrite"),
        ("render", tree.root, tree.root, "--overwrite"),
        ("propose", tree.root, tree.root, "--all", "--overwrite"),
        ("convert", tree.root, tree.root / "new", "--to", "labelme"),
    ):
        cli(*command, code=2)
    for path, data in before.items():
        assert path.read_bytes() == data
    assert {p for p in tree.root.rglob("*.*") if p.is_file()} == set(before)


@pytest.mark.usefixtures("no_charts")
def test_a_report_and_a_comparison_of_a_tree(cli, tree, tmp_path):
    page = tmp_path / "report.html"
    done = cli("report", tree.root, "--cameras", f"ours={tree.cameras}", "--output", page)
    text = page.read_text(encoding="utf-8")
    assert all(name in text for name in NAMES)
    done = cli("compare", f"a={tree.cameras}", f"b={tree.cameras}", tree.root)
    assert "4 frames" in done.stdout + done.stderr


def test_a_tree_of_shots_has_a_strip_that_breaks_between_folders(tmp_path):
    picture = np.random.default_rng(5).integers(0, 255, (36, 64, 3), dtype=np.uint8)
    picture = cv2.resize(picture, (640, 360), interpolation=cv2.INTER_CUBIC)
    for shot in ("a/img1", "b/img1"):
        (tmp_path / shot).mkdir(parents=True)
        for number in range(1, FEWEST + 1):
            cv2.imwrite(str(tmp_path / shot / f"{number:06d}.jpg"), picture)
    _, frames, _ = list_frames(tmp_path)
    sequence = sequence_of(frames)
    assert len(sequence.numbers) == 2 * FEWEST
    first, second = (int(sequence.numbers[at]) for at in (0, FEWEST))
    assert list(sequence.unbroken(first)) == list(range(first, first + FEWEST))
    assert list(sequence.unbroken(second)) == list(range(second, second + FEWEST))
    assert sequence.paths[second] == tmp_path / "b/img1/000001.jpg"


def test_a_folder_of_overlays_below_annotations_is_none_of_pictures(cli, sample_data, tmp_path):
    """All annotations count, not only those of frames that were drawn."""
    annotations = tmp_path / "annotations_alone"
    (annotations / "overlays").mkdir(parents=True)
    for frame in ("00001", "00002"):
        shutil.copy(sample_data / f"{frame}.json", annotations)
    cv2.imwrite(str(annotations / "overlays" / "00001.png"), np.zeros((48, 48, 3), np.uint8))
    done = cli("export", annotations, tmp_path / "out")
    assert "2 annotations written" in done.stdout
    cameras = sample_data / "cameras" / "pinhole"
    done = cli("compare", f"a={cameras}", f"b={cameras}", annotations)
    assert "2 frames" in done.stdout + done.stderr
    done = cli("calibrate", annotations, tmp_path / "fitted")
    assert "960x540" in done.stdout


def test_what_cvat_exports_is_a_tree_with_its_pictures(cli, tree, tmp_path):
    """It puts pictures in images/, leaves that folder out of their names, and adds a list of
    labels."""
    place = tmp_path / "project"
    cli("convert", tree.root, place, "--to", "cvat", "--pictures")
    (place / "labels.json").write_text("[]")
    done = cli("check", place)
    assert "no pictures" not in done.stdout
    done = cli("export", place, tmp_path / "out.zip")
    assert "4 annotations written" in done.stdout
    assert [frame.name for frame in list_frames(place)[1]] == NAMES


@pytest.mark.parametrize(
    ("fmt", "name"),
    [("soccernet-gsr", "Labels-GameState.json"), ("soccernet-v3", "Labels-v3.json")],
)
def test_a_format_of_one_file_a_game_has_one_in_each_folder(cli, tree, tmp_path, fmt, name):
    """Each names the pictures of its own game, as its loader joins them to its folder."""
    out = tmp_path / "games"
    cli("convert", tree.root, out, "--to", fmt)
    folders = ("a", "b") if fmt == "soccernet-gsr" else MATCHES
    assert sorted(p.relative_to(out).as_posix() for p in out.rglob("*.json")) == [
        f"{folder}/{name}" for folder in folders
    ]
    for folder in folders:
        content = json.loads((out / folder / name).read_text())
        pictures = (
            [image["file_name"] for image in content["images"]]
            if fmt == "soccernet-gsr"
            else list(content["actions"])
        )
        assert pictures == ["00001.jpg", "00002.jpg"]
    archive = tmp_path / "games.zip"
    cli("convert", tree.root, archive, "--to", fmt)
    with zipfile.ZipFile(archive) as written:
        assert sorted(written.namelist()) == [f"{folder}/{name}" for folder in folders]
    back = tmp_path / "back"
    cli("convert", out, back, "--to", "soccernet")
    assert len(list(back.rglob("*.json"))) == 4
    one = tmp_path / "one.json"
    cli("convert", tree.root, one, "--to", fmt)
    assert "a/img1/00001.jpg" in one.read_text()


def test_pictures_of_soccernet_v3_that_are_still_packed_are_told(cli, tmp_path):
    game = tmp_path / "league" / "season" / "game"
    game.mkdir(parents=True)
    lines = [{"class": "Middle line", "points": [1, 2, 3, 4]}]
    image = {"imageMetadata": {"width": 1920, "height": 1080}, "lines": lines}
    (game / "Labels-v3.json").write_text(
        json.dumps({"GameMetadata": {}, "actions": {"0.png": image}, "replays": {}})
    )
    (game / "Frames-v3.zip").write_bytes(b"")
    done = cli("render", tmp_path, tmp_path / "out", code=2)
    assert "unpack each Frames-v3.zip into a folder v3_frames next to it" in done.stderr


@pytest.mark.parametrize("place", ["annotations/{}", "{}/annotations", "{}"])
def test_annotations_without_the_folder_of_pictures_are_those_of_the_pictures(
    cli, tree, tmp_path, place
):
    """By every command, and by the window; the names composed otherwise, as a Mac copies them."""
    here, there = "é", "e\u0301"
    for match in MATCHES:
        folder = tree.root / match
        kept = tree.root / place.format(match.removesuffix("/img1"))
        kept.mkdir(parents=True, exist_ok=True)
        (folder / "00001.json").rename(kept / f"{there}1.json")
        (folder / "00001.jpg").rename(folder / f"{here}1.jpg")
        (folder / "00002.json").rename(kept / "00002.json")
        camera = tree.cameras / match / "camera_00001.json"
        camera.rename(camera.with_name(f"camera_{here}1.json"))
    workspace = Workspace.open(tree.root, load_field("soccer"))
    assert all(workspace.has_file(index) for index in range(len(workspace.frames)))
    done = cli("export", tree.root, tmp_path / "out", "--cameras", tree.cameras)
    assert "4 annotations written" in done.stdout
    (tmp_path / "tags.csv").write_text(f"frame,sun\na/{here}1,yes\nb/img1/{here}1,no\n", "utf-8")
    done = cli("evaluate", tree.root, tree.cameras, "--tags", tmp_path / "tags.csv")
    assert "4 frames" in done.stdout
    assert done.stderr == ""


def test_annotations_of_one_match_go_with_cameras_of_the_whole_tree(cli, tree, tmp_path):
    """Without pictures nothing but the cameras tells that their only folder is one of several."""
    kept = tmp_path / "kept/a"
    kept.mkdir(parents=True)
    for frame in FRAMES:
        shutil.copy(tree.root / f"a/img1/{frame}.json", kept)
    figures = tmp_path / "figures.csv"
    cli("evaluate", kept.parent, tree.cameras, "-o", figures)
    assert {row["name"] for row in rows_in(figures)} == {f"a/{frame}" for frame in FRAMES}


@pytest.mark.parametrize("fmt", ["cvat", "coco", "soccernet-v3"])
def test_a_file_of_one_match_comes_back_into_the_tree(cli, tree, tmp_path, fmt):
    shutil.move(tree.root / "b", tmp_path / "b")
    (tree.root / "b/img1").mkdir(parents=True)
    shutil.copy(tmp_path / "b/img1/00001.jpg", tree.root / "b/img1")
    suffix = {"cvat": ".xml", "coco": ".json"}.get(fmt, "")
    file = tmp_path / f"one{suffix}"
    cli("convert", tree.root, file, "--to", fmt)
    workspace = Workspace.open(tree.root, load_field("soccer"))
    assert set(read_annotations(file, workspace).frames) == {f"a/img1/{f}" for f in FRAMES}


def test_releases_and_reports_find_frames_however_they_are_called(cli, tree, tmp_path):
    """Without the folder of pictures in a table, and composed otherwise by the annotations."""
    here, there = "é1", "e\u03011"
    for match in MATCHES:
        folder = tree.root / match
        (folder / "00001.jpg").rename(folder / f"{here}.jpg")
        (folder / "00001.json").rename(folder / f"{there}.json")
        camera = tree.cameras / match / "camera_00001.json"
        camera.rename(camera.with_name(f"camera_{there}.json"))
    table = tmp_path / "splits.csv"
    rows = [
        f"{name},{match[0]}" for match in "ab" for name in (f"{match}/{here}", f"{match}/00002")
    ]
    table.write_text("frame,split\n" + "\n".join(rows) + "\n", "utf-8")
    terms = ("--name", "X", "--license", "CC0", "--splits", table)
    first, second = tmp_path / "one", tmp_path / "two"
    done = cli("release", tree.root, first, *terms, "--version", "1")
    assert "a: 2 frames" in done.stdout
    assert "in no split" not in done.output
    for match in MATCHES:
        folder = tree.root / match
        (folder / f"{there}.json").rename(folder / f"{here}.json")
    done = cli("release", tree.root, second, *terms, "--version", "2", "--previous", first)
    assert "since version 1: 0 added, 0 removed, 0 changed" in done.stdout
    page = tmp_path / "page.html"
    few = ("--worst", "0", "--random", "4", "-o", page)
    cli("report", tree.root, "--cameras", tree.cameras, *few)
    assert page.read_text().count("data:image/jpeg") == 4
