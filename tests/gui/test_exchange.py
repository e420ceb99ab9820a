"""Importing and exporting annotations of other programs in the window."""

import json
import sqlite3
import threading
import zlib
from contextlib import closing
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.dataset import saving, workspace
from procc_annotator.dataset.database.connection import FILE
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.locks import FrameLocks, locks_folder
from procc_annotator.dataset.records import Origin, PointKey
from procc_annotator.gui.commands.exporting import ExportAs
from procc_annotator.gui.commands.importing import AnnotationImporter
from procc_annotator.gui.state.editing import batch_edits
from procc_annotator.gui.state.editing.batch_edits import merged
from tests.gui.conftest import all_done, until_kept

LINE = "Middle line"


def labelme(name: str, x: float) -> str:
    shape = {"label": LINE, "points": [[x, 10], [x, 300]], "shape_type": "linestrip"}
    return json.dumps(
        {"shapes": [shape], "imagePath": f"{name}.png", "imageWidth": 640, "imageHeight": 360}
    )


@pytest.fixture
def foreign(tmp_path) -> Path:
    """labelme files for two of the three frames, a damaged one, and one of another picture."""
    folder = tmp_path / "foreign"
    folder.mkdir()
    for name, x in (("frame_0", 100), ("frame_1", 200), ("elsewhere", 300)):
        (folder / f"{name}.json").write_text(labelme(name, x))
    (folder / "frame_2.json").write_text('{"shapes": [1], "imageWidth": 640, "imageHeight": 360}')
    return folder


@pytest.fixture
def importer(services, widget) -> AnnotationImporter:
    widget.show()
    return AnnotationImporter(services, widget)


@pytest.fixture
def export(services, widget) -> ExportAs:
    return ExportAs(services, widget)


def run_import(
    importer: AnnotationImporter, qtbot: QtBot, path: Path, *, replace: bool = False
) -> str:
    """Import as the dialog does; what it says in the end."""
    importer.ask()
    dialog = importer.dialog
    dialog.path.setText(str(path))
    dialog.replace.setChecked(replace)
    dialog.start_button.click()
    qtbot.waitUntil(lambda: bool(dialog.report.toPlainText()) and not dialog.bar.isVisible())
    text = dialog.report.toPlainText()
    dialog.close_button.click()
    return text


def on_disk(dataset: Path, name: str) -> dict[str, list[dict[str, float]]]:
    path = dataset / f"{name}.json"
    return json.loads(path.read_text()) if path.exists() else {}


def test_frames_are_matched_by_name_and_the_rest_is_told(
    importer, services, qtbot, dataset, foreign
):
    said = run_import(importer, qtbot, foreign)
    assert "2 of 2 frames imported (labelme JSON)." in said
    assert "elsewhere" in said
    assert "frame_2.json: shapes[0]" in said
    assert on_disk(dataset, "frame_0") == {
        LINE: [{"x": 100 / 639, "y": 10 / 359}, {"x": 100 / 639, "y": 300 / 359}]
    }
    assert on_disk(dataset, "frame_1")[LINE][0]["x"] == 200 / 639
    assert not (dataset / "frame_2.json").exists()
    assert services.state.annotation.annotated == (LINE,)  # the frame on screen shows it
    assert services.state.workspace.read(1).annotated


def test_what_is_annotated_stays_unless_asked(importer, services, qtbot, dataset, foreign):
    mine = FrameAnnotation((Polyline("Side line top", (Point(0.1, 0.1), Point(0.9, 0.1))),))
    services.editing.commit_edit("draw", mine)
    said = run_import(importer, qtbot, foreign)
    assert "1 of 2 frames imported" in said
    assert "1 frame is annotated already" in said
    assert list(on_disk(dataset, "frame_0")) == ["Side line top"]
    said = run_import(importer, qtbot, foreign, replace=True)
    assert "1 of 2 frames imported" in said
    assert "1 frame holds the same already" in said
    assert list(on_disk(dataset, "frame_0")) == [LINE]
    database = services.review.database
    database.flush(5.0)
    kept = [database.version_data(v.id) for v in database.versions("frame_0")]
    assert any(b"Side line top" in data for data in kept)
    services.editing.undo()
    services.saver.settle()
    assert list(on_disk(dataset, "frame_0")) == ["Side line top"]


def test_other_frames_keep_their_history_too(importer, services, qtbot, dataset, foreign):
    run_import(importer, qtbot, foreign)
    services.navigator.go_to(1)
    services.editing.undo()
    services.saver.settle()
    assert on_disk(dataset, "frame_1") == {}


def test_a_frame_somebody_else_edits_is_left_alone(importer, services, qtbot, dataset, foreign):
    other = FrameLocks(locks_folder(dataset), "Ada")
    assert other.acquire("frame_1") is None
    said = run_import(importer, qtbot, foreign)
    assert "1 of 2 frames imported" in said
    assert "frame_1: Ada is editing it" in said
    assert not (dataset / "frame_1.json").exists()
    assert other.held == {"frame_1"}


@pytest.fixture
def annotated(dataset) -> Path:
    """All three frames annotated, on disk."""
    for i in range(3):
        points = [{"x": 0.1, "y": 0.1 * i}, {"x": 0.9, "y": 0.1}]
        (dataset / f"frame_{i}.json").write_text(json.dumps({"Side line top": points}))
    return dataset


def versions_on_disk(dataset: Path) -> dict[str, set[bytes]]:
    """What the database's file holds, as a program that begins now would see it."""
    found: dict[str, set[bytes]] = {}
    with closing(sqlite3.connect(dataset / ".procc" / FILE)) as connection:
        for frame, data in connection.execute("SELECT frame, data FROM version"):
            found.setdefault(frame, set()).add(bytes(zlib.decompress(data)))
    return found


def test_what_is_replaced_is_a_version_on_disk_before_its_file_changes(
    annotated, services, importer, qtbot, foreign, monkeypatch
):
    """A kill at any moment finds every file whole and everything replaced among the versions."""
    before = {p.stem: p.read_bytes() for p in annotated.glob("*.json")}
    services.navigator.go_to(2)  # no frame that is replaced is on screen
    written, threads = [], set()
    write = saving.write_atomic

    def watched(path: Path, data: bytes, **more: Path) -> None:
        assert before[path.stem] in versions_on_disk(annotated)[path.stem]
        assert path.read_bytes() == before[path.stem]
        threads.add(threading.current_thread())
        written.append(path.stem)
        write(path, data, **more)

    monkeypatch.setattr(saving, "write_atomic", watched)
    said = run_import(importer, qtbot, foreign, replace=True)
    assert "2 of 2 frames imported" in said
    assert sorted(written) == ["frame_0", "frame_1"]
    assert threading.main_thread() not in threads
    assert not list(locks_folder(annotated).glob("*.lock"))


def test_the_database_is_not_asked_about_every_frame(
    annotated, services, importer, qtbot, foreign, monkeypatch
):
    """Each answer would wait for all that is queued before it."""
    services.navigator.go_to(2)
    asked: list[str] = []
    origins = WorkspaceDatabase.origins

    def watched(self: WorkspaceDatabase, frame: str) -> dict[PointKey, Origin]:
        asked.append(frame)
        return origins(self, frame)

    monkeypatch.setattr(WorkspaceDatabase, "origins", watched)
    assert "2 of 2" in run_import(importer, qtbot, foreign, replace=True)
    assert not {"frame_0", "frame_1"} & set(asked)
    services.navigator.go_to(0)
    assert set(services.review.origins("frame_0")) == {
        (100 / 639, 10 / 359),
        (100 / 639, 300 / 359),
    }


def test_a_file_that_changes_just_before_it_is_written_is_kept(
    annotated, services, importer, qtbot, foreign, monkeypatch
):
    services.navigator.go_to(2)
    flush = WorkspaceDatabase.flush

    def changed(self: WorkspaceDatabase, timeout: float = 2.0) -> bool:
        (annotated / "frame_1.json").write_text('{"Circle left": [{"x": 0.5, "y": 0.5}]}')
        return flush(self, timeout)

    monkeypatch.setattr(WorkspaceDatabase, "flush", changed)
    said = run_import(importer, qtbot, foreign, replace=True)
    assert "1 of 2 frames imported" in said
    assert "frame_1: it could not be saved" in said
    assert list(on_disk(annotated, "frame_1")) == ["Circle left"]
    assert services.saver.conflict(1) is not None  # waits for a decision


def test_an_import_that_breaks_off_is_over_and_nothing_of_it_is_lost(
    importer, services, qtbot, dataset, foreign, monkeypatch
):
    monkeypatch.setattr("sys.excepthook", lambda *_: None)  # the terminal would say it
    services.navigator.go_to(2)
    write = workspace.write_saves

    def broken(saves: list[saving.PendingSave]) -> None:
        write(saves[:1])
        raise MemoryError("no more")

    with monkeypatch.context() as breaking:
        breaking.setattr(workspace, "write_saves", broken)
        said = run_import(importer, qtbot, foreign)
    assert "0 of 2 frames imported" in said
    assert "frame_0: it could not be saved" in said
    assert "no more" in said
    assert services.state.unsaved
    assert services.editing.save_now()  # what was written after all is no conflict
    assert {LINE} == set(on_disk(dataset, "frame_0")) == set(on_disk(dataset, "frame_1"))
    assert not services.state.unsaved


def test_closing_the_window_ends_an_import_with_everything_saved(
    make_window, qtbot, annotated, foreign, monkeypatch
):
    monkeypatch.setattr(batch_edits, "_TOGETHER", 1)
    window = make_window(annotated)
    window.services.navigator.go_to(2)
    window.importer.ask()
    importer = window.importer
    importer.dialog.replace.setChecked(True)
    importer.start(foreign)
    saver = window.services.saver
    with qtbot.waitSignal(saver.saved):
        pass
    window.close()
    until_kept()
    held = [list(on_disk(annotated, f"frame_{i}")) for i in range(3)]
    all_done(qtbot)
    assert [list(on_disk(annotated, f"frame_{i}")) for i in range(3)] == held
    assert held[0] == [LINE]
    assert not window.services.state.workspace.dirty_frames()
    assert not list(locks_folder(annotated).glob("*.lock"))


def test_damaged_files_of_the_dataset_are_not_replaced(importer, services, qtbot, dataset, foreign):
    (dataset / "frame_1.json").write_text("{")
    assert services.opening.open_path(dataset)
    said = run_import(importer, qtbot, foreign, replace=True)
    assert "frame_1: " in said
    assert (dataset / "frame_1.json").read_text() == "{"


def test_nothing_to_read_is_said_in_the_dialog(importer, services, qtbot, tmp_path):
    empty = tmp_path / "empty"
    empty.mkdir()
    assert "nothing to do: no annotation" in run_import(importer, qtbot, empty)


def test_merging_keeps_what_has_no_other_place():
    before = FrameAnnotation(
        (Polyline("Circle left", (Point(0, 0),)),),
        (("weather", "rain"), ("crew", "a")),
        (Polyline(LINE, (Point(1, 1),)), Polyline("Side line left", (Point(0, 1),))),
    )
    incoming = FrameAnnotation((Polyline(LINE, (Point(0.5, 0.5),)),), (("crew", "b"),))
    after = merged(before, incoming)
    assert after.polylines == incoming.polylines
    assert after.extra == (("weather", "rain"), ("crew", "b"))
    assert [p.class_name for p in after.unconfirmed] == ["Side line left"]


def test_export_says_what_the_format_cannot_hold(export, services, qtbot, tmp_path):
    services.editing.commit_edit(
        "draw",
        FrameAnnotation(
            (Polyline(LINE, (Point(0.5, 0.1), Point(0.5, 1.2))),),
            (),
            (Polyline("Circle left", (Point(0.1, 0.1),)),),
        ),
    )
    export.ask()
    dialog = export.dialog
    names = [dialog.formats.itemText(i) for i in range(dialog.formats.count())]
    dialog.formats.setCurrentIndex(names.index("segmentation masks (PNG)"))
    assert dialog.line_width.isVisibleTo(dialog)
    export.start(tmp_path / "masks")
    qtbot.waitUntil(lambda: bool(dialog.report.toPlainText()))
    said = dialog.report.toPlainText()
    assert "1 frame, 1 element and 2 points written" in said
    assert "unconfirmed elements are not written (1 frame: frame_0)" in said
    assert "outside the picture" in said
    assert sorted(p.name for p in (tmp_path / "masks").iterdir()) == ["classes.json", "frame_0.png"]
    dialog.report.clear()
    (tmp_path / "masks" / "frame_0.png").write_bytes(b"of somebody else")
    export.start(tmp_path / "masks")
    qtbot.waitUntil(lambda: bool(dialog.report.toPlainText()))
    assert "exists already" in dialog.report.toPlainText()
    dialog.close_button.click()


def test_exported_and_imported_again_is_the_same(
    export, importer, services, qtbot, dataset, tmp_path
):
    line = Polyline(LINE, (Point(1 / 3, 0.1), Point(0.7234567890123, 0.9)))
    services.editing.commit_edit("draw", FrameAnnotation((line,)))
    export.ask()
    dialog = export.dialog
    dialog.formats.setCurrentIndex(4)
    assert dialog.format.name == "cvat"
    export.start(tmp_path / "task.zip")
    qtbot.waitUntil(lambda: bool(dialog.report.toPlainText()))
    dialog.close_button.click()
    before = on_disk(dataset, "frame_0")
    said = run_import(importer, qtbot, tmp_path / "task.zip", replace=True)
    assert "1 frame holds the same already" in said
    assert on_disk(dataset, "frame_0") == before


def test_cancelling_leaves_everything_as_it_was(importer, services, qtbot, dataset, foreign):
    importer.ask()
    dialog = importer.dialog
    dialog.path.setText(str(foreign))
    importer.start(foreign)
    dialog.close_button.click()
    assert "Cancelled" in dialog.report.toPlainText()
    assert dialog.isVisible()
    all_done(qtbot)
    assert not any(dataset.glob("*.json"))
    dialog.close_button.click()
    assert not dialog.isVisible()


def test_the_words_about_every_format_have_room(export, services, qtbot):
    export.ask()
    dialog = export.dialog
    for width in (dialog.width(), 900, dialog.minimumWidth()):
        dialog.resize(width, dialog.height())
        for row in range(dialog.formats.count()):
            dialog.formats.setCurrentIndex(row)
            all_done(qtbot)
            words = dialog.holds
            assert words.height() >= words.heightForWidth(words.width()), words.text()
            lowest = dialog.close_button
            assert lowest.mapTo(dialog, lowest.rect().bottomLeft()).y() < dialog.height()
    dialog.close_button.click()


def test_annotations_of_another_program_in_the_dataset_are_imported_apart(
    importer, services, qtbot, tmp_path, striped
):
    """labelme's files lie where this program's would: both stay apart."""
    folder = tmp_path / "labelme_set"
    folder.mkdir()
    for name, picture in zip(("a", "b"), striped, strict=False):
        (folder / f"{name}.png").write_bytes(picture)
        (folder / f"{name}.json").write_text(labelme(name, 100))
    assert services.opening.open_path(folder)
    assert services.state.editable  # the frame can be edited
    importer.ask()
    dialog = importer.dialog
    dialog.path.setText(str(folder))
    dialog.start_button.click()
    qtbot.waitUntil(lambda: bool(dialog.report.toPlainText()) and not dialog.bar.isVisible())
    assert "2 of 2 frames imported" in dialog.report.toPlainText()
    dialog.close_button.click()
    assert LINE in on_disk(folder / "annotations", "a")
    assert (folder / "a.json").read_text() == labelme("a", 100)
