"""Pairing, order and bad files of a set; figures do not depend on how the work is shared."""

import json
import unicodedata
from collections.abc import Iterable
from operator import attrgetter
from pathlib import Path
from typing import Any

import pytest

from procc_annotator.batch import evaluation
from procc_annotator.batch.evaluation import EvaluationRun, run_evaluation
from procc_annotator.batch.execution.executor import Executor, make_executor
from procc_annotator.batch.grouping import FrameOrder, Grouping, Tags, check_by
from procc_annotator.batch.scoring import NOTHING_SHOWN, FrameResult
from procc_annotator.dataset.dataset_field import field_with_stadiums
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.load import field_for_frame, load_field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_source import open_source
from procc_annotator.metrics.sets import SetSummary
from procc_annotator.metrics.setup import EvaluationSetup, check_thresholds

CAMERA = {
    "pan_degrees": 0.0,
    "tilt_degrees": 78.0,
    "roll_degrees": 0.0,
    "position_meters": [0.0, 60.0, -14.0],
    "x_focal_length": 1400.0,
    "y_focal_length": 1400.0,
    "principal_point": [479.5, 269.5],
}
ANNOTATION = {"Middle line": [{"x": 0.5, "y": 0.4}, {"x": 0.5, "y": 0.6}]}
SETUP = EvaluationSetup(load_field("soccer"))


@pytest.fixture
def annotations(tmp_path) -> Path:
    folder = tmp_path / "annotations"
    folder.mkdir()
    return folder


@pytest.fixture
def cameras(tmp_path) -> Path:
    folder = tmp_path / "cameras"
    folder.mkdir()
    return folder


def fill(annotations: Path, cameras: Path, names: Iterable[str]) -> None:
    for i, name in enumerate(names):
        (annotations / f"{name}.json").write_text(json.dumps(ANNOTATION))
        camera = CAMERA | {"pan_degrees": 0.05 * (i % 7)}
        (cameras / f"camera_{name}.json").write_text(json.dumps(camera))


def run(
    annotations: Path, cameras: Path, executor: Executor | None = None, **more: Any
) -> EvaluationRun[FrameResult]:
    sources = open_source(annotations), CameraCollection.open(cameras)
    return run_evaluation(
        *sources, SETUP, (5.0, 2.0), attrgetter("result"), executor=executor, **more
    )


def test_frames_come_in_natural_order_each_with_its_own_camera(annotations, cameras):
    fill(annotations, cameras, ["10", "9", "1", "100"])
    results = list(run(annotations, cameras))
    assert [r.name for r in results] == ["1", "9", "10", "100"]
    assert all(r.camera == str(cameras / f"camera_{r.name}.json") for r in results)
    assert all(list(r.scores) == [5.0, 2.0] for r in results)


def test_tally_of_good_and_bad_files(annotations, cameras):
    fill(annotations, cameras, "abcde")
    (annotations / "a.json").write_text("{")
    (cameras / "camera_b.json").write_text("{")
    (cameras / "camera_c.json").unlink()
    (annotations / "d.json").unlink()
    evaluated = run(annotations, cameras)
    results = {r.name: r for r in evaluated}
    assert evaluated.total == 4
    assert evaluated.unmatched_cameras == ("d",)
    assert (evaluated.tally.counted, evaluated.tally.with_camera) == (3, 1)
    assert not results["a"].counted
    assert "a.json" in (results["a"].error or "")
    assert results["b"].camera is None
    assert "camera_b.json" in (results["b"].error or "")
    assert results["c"].error is None
    assert evaluated.summary()[5.0].completeness == pytest.approx(1 / 3)


@pytest.mark.parametrize(("wrong", "told"), [(0, False), (2, False), (3, True), (4, True)])
@pytest.mark.parametrize(
    ("change", "shown"), [({"tilt_degrees": 200.0}, False), ({"x_focal_length": 9e3}, True)]
)
def test_cameras_of_another_size_or_world_are_named(
    annotations, cameras, wrong, told, change, shown
):
    fill(annotations, cameras, "abcd")
    for name in "abcd"[:wrong]:
        turned = CAMERA | {"principal_point": [1500.0, 269.5]} | change
        (cameras / f"camera_{name}.json").write_text(json.dumps(turned))
    evaluated = run(annotations, cameras)
    notices = [notice for result in evaluated for notice in result.notices]
    assert notices.count(NOTHING_SHOWN) == (0 if shown else wrong)
    assert ("picture size" in evaluated.tally.size_doubt) == told


def test_a_folder_in_place_of_a_file_does_not_stop_the_set(annotations, cameras):
    fill(annotations, cameras, "ab")
    (cameras / "camera_a.json").unlink()
    (cameras / "camera_a.json").mkdir()
    results = {r.name: r for r in run(annotations, cameras)}
    assert "camera_a.json" in (results["a"].error or "")
    assert results["b"].scores


@pytest.mark.parametrize("workers", [1, 2])
def test_figures_do_not_depend_on_the_number_of_processes(
    annotations, cameras, monkeypatch, workers
):
    names = [f"{i:03}" for i in range(30)]
    fill(annotations, cameras, names)
    (cameras / "camera_007.json").write_text("[]")
    monkeypatch.setattr(evaluation, "CHUNK", 4)
    with make_executor(workers) as executor:
        evaluated = run(annotations, cameras, executor)
        results = list(evaluated)
    assert [r.name for r in results] == names
    assert [r.name for r in results if r.error] == ["007"]
    alone = run(annotations, cameras)
    list(alone)
    assert evaluated.summary() == alone.summary()
    assert evaluated.tally.with_camera == 29


def test_stopping_half_way_is_clean(annotations, cameras, monkeypatch):
    fill(annotations, cameras, [f"{i:03}" for i in range(30)])
    monkeypatch.setattr(evaluation, "CHUNK", 2)
    with make_executor(2) as executor:
        results = iter(run(annotations, cameras, executor))
        assert next(results).name == "000"
        results.close()
        # The executor is as good as new.
        assert len(list(run(annotations, cameras, executor))) == 30


def test_nothing_to_do_is_said_before_any_work(annotations, cameras):
    with pytest.raises(UsageError, match="no annotation"):
        run(annotations, cameras)
    fill(annotations, cameras, ["1"])
    (cameras / "camera_1.json").rename(cameras / "camera_00001.json")
    with pytest.raises(UsageError, match=r"'1'.*'00001'"):
        run(annotations, cameras)


def test_thresholds_are_positive_and_each_counts_once():
    assert check_thresholds([5, 2.5, 5.0]) == (5.0, 2.5)
    for bad in ([], [0.0], [-1.0], [float("nan")], [float("inf")]):
        with pytest.raises(UsageError):
            check_thresholds(bad)


def test_groups_sum_up_their_own_frames_only(annotations, cameras, monkeypatch):
    names = [f"{i:03}" for i in range(9)]
    fill(annotations, cameras, names)
    (cameras / "camera_001.json").unlink()
    (annotations / "002.json").write_text("{")
    tags = {name: ("day" if i % 2 else "night", None) for i, name in enumerate(names[:6])}
    monkeypatch.setattr(evaluation, "CHUNK", 2)
    evaluated = run(annotations, cameras, grouping=Grouping(("light", "model"), tags))
    results = {r.name: r for r in evaluated}
    assert results["003"].groups == ("day", "pinhole P")
    assert results["001"].groups == ("day", None)
    assert results["008"].groups == (None, "pinhole P")
    found = {(g.by, g.value): g.summaries[5.0] for g in evaluated.group_summaries()}
    assert list(found) == [
        ("light", "day"), ("light", "night"), ("light", None),
        ("model", "pinhole P"), ("model", None),
    ]  # fmt: skip
    counts = {key: (s.images, s.evaluated) for key, s in found.items()}
    # 002 cannot be read: it belongs to no figure.
    assert counts[("light", "day")] == (3, 2)
    assert counts[("light", "night")] == (2, 2)
    assert counts[("light", None)] == (3, 3)
    assert counts[("model", "pinhole P")] == (7, 7)
    assert counts[("model", None)] == (1, 0)

    alone = fill_only(annotations, cameras, ["003", "005"])
    assert found[("light", "day")].mean_jac == alone[5.0].mean_jac
    assert found[("light", "day")].per_class == alone[5.0].per_class


def fill_only(annotations: Path, cameras: Path, names: list[str]) -> dict[float, SetSummary]:
    """The figures of these frames alone."""
    for path in annotations.iterdir():
        if path.stem not in names:
            path.unlink()
    evaluated = run(annotations, cameras)
    list(evaluated)
    return evaluated.summary()


# Tags of frames from a CSV file, damaged ones too.

BOM = "\ufeff"
COMPOSED, APART = (unicodedata.normalize(form, "café") for form in ("NFC", "NFD"))
# As a table may call a frame, and as commands and the window may.
CALLED_OTHERWISE = [(COMPOSED, APART), ("g/1", "g/img1/1"), (f"{APART}/img1/1", f"{COMPOSED}/1")]


def tags(tmp_path: Path, text: str | bytes) -> Tags:
    path = tmp_path / "tags.csv"
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return Tags.read(path)


@pytest.mark.parametrize(
    "text",
    [
        "frame,stadium,light\n1,A,day\n10,,night\n",
        BOM + "frame,stadium,light\r\n1,A,day\r\n\r\n10,,night\r\n",
        "stadium; frame ;light\nA;1;day\n;10;night",
        "light\tframe\tstadium\nday\t1\tA\nnight\t10\t\n",
        'frame,stadium,light\n"1","A","day"\n10,"",night\n',
    ],
    ids=["plain", "bom-crlf", "semicolons", "tabs", "quoted"],
)
def test_forms_of_csv(tmp_path, text):
    read = tags(tmp_path, text)
    assert set(read.columns) == {"stadium", "light"}
    grouping = read.grouping(("light", "model", "stadium"), "any")
    assert grouping.of("1") == ("day", None, "A")
    assert grouping.of("10") == ("night", None, None)
    assert grouping.of("2") == (None, None, None)


def test_rows_of_a_named_set_count_for_it_only(tmp_path):
    read = tags(tmp_path, "set,frame,light\na,1,day\nb,1,night\n")
    assert read.columns == ("light",)
    assert [read.grouping(("light",), name).of("1") for name in "abc"] == [
        ("day",), ("night",), (None,),
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("frame\n1\n", r"line 1: has no column of tags"),
        ("frame,\n1,day\n", r"line 1: column 2 has no name"),
    ],
)
def test_damaged_files_are_one_clear_error(tmp_path, text, says):
    with pytest.raises(InputError, match=says) as caught:
        tags(tmp_path, text)
    assert str(tmp_path / "tags.csv") in str(caught.value)


def test_what_can_be_grouped_by(tmp_path):
    read = tags(tmp_path, "frame,stadium,light\n1,A,day\n")
    assert check_by(["light", "model", "light"], read) == ("light", "model")
    with pytest.raises(UsageError, match="'lihgt': there is model, stadium, light"):
        check_by(["lihgt"], read)
    with pytest.raises(UsageError, match=r"--tags FILE"):
        check_by(["light"], None)
    taken = tags(tmp_path, "frame,model\n1,A\n")
    with pytest.raises(UsageError, match="rename"):
        check_by(["model"], taken)


@pytest.mark.parametrize(("told", "asked"), CALLED_OTHERWISE)
def test_tables_know_a_frame_by_its_other_names(tmp_path, told, asked):
    grouping = tags(tmp_path, f"frame,light\n{told},day\n").grouping(("light",), "any")
    assert grouping.of(asked) == ("day",)
    (tmp_path / "stadiums.csv").write_text(f"frame,stadium,length\n{told},Source,100\n")
    field = field_with_stadiums(load_field("soccer"), tmp_path)
    assert field_for_frame(field, asked).dimension("length").value == 100.0
    (tmp_path / "frames.csv").write_text(f"frame,shot,number\n{told},a,7\nnext,a,8\n")
    order = FrameOrder.read(tmp_path / "frames.csv")
    (shot,) = order.shots_of(["next", asked])
    assert (shot.frames, shot.numbers) == ((asked, "next"), (7, 8))
    (both,) = order.shots_of([asked, told, "next"])  # cameras and pictures of the same frames
    assert both.frames == (told, "next")
