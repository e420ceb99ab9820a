"""Status, comments, provenance, versions, filter and the second annotator in the window."""

import json
import sqlite3
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.records import OriginKind, Status
from procc_annotator.gui.commands.versions import apply_version
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.report.window_tables import overview_rows
from tests.gui.conftest import all_done, until_kept

CTRL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
MIDDLE, TOP = "Middle line", "Side line top"


def status(window: MainWindow, frame: int = 0) -> Status:
    return window.services.review.status(f"frame_{frame}")


def rows(window: MainWindow) -> list[str]:
    model = window.frames.model
    return [window.services.state.workspace.frames[model.frame_index(r)].name
            for r in range(model.rowCount())]  # fmt: skip


def write_other(root: Path, **frames: dict[str, list[tuple[float, float]]]) -> Path:
    """A second annotator's folder; positions in px of the pictures."""
    folder = root / "second"
    folder.mkdir()
    for name, polylines in frames.items():
        content = {
            class_name: [{"x": x / 639, "y": y / 359} for x, y in points]
            for class_name, points in polylines.items()
        }
        (folder / f"{name}.json").write_text(json.dumps(content))
    return folder


class TestStatus:
    def test_an_edit_begins_a_frame_and_ctrl_enter_ends_it(self, window, hand):
        assert status(window) is Status.UNTOUCHED
        hand.draw(MIDDLE, (100, 100), (200, 200))
        assert status(window) is Status.IN_PROGRESS
        hand.key(Qt.Key.Key_Return, CTRL)
        assert status(window) is Status.DONE
        assert window.top_bar.status.text() == "done"

    def test_shift_d_goes_on_to_what_is_not_done(self, window, hand):
        window.services.navigator.go_to(1)
        hand.key(Qt.Key.Key_Return, CTRL)
        window.services.navigator.go_to(0)
        hand.key(Qt.Key.Key_D, SHIFT)
        assert window.services.state.frame_index == 2
        hand.key(Qt.Key.Key_A, SHIFT)
        assert window.services.state.frame_index == 0

    def test_a_rejected_frame_is_found_and_editing_it_reopens_it(self, window, hand):
        window.services.navigator.go_to(2)
        hand.key(Qt.Key.Key_X, CTRL | SHIFT)
        assert status(window, 2) is Status.REJECTED
        window.services.navigator.go_to(0)
        hand.key(Qt.Key.Key_R, CTRL | SHIFT)
        assert window.services.state.frame_index == 2
        hand.draw(MIDDLE, (100, 100), (200, 200))
        assert status(window, 2) is Status.IN_PROGRESS

    def test_status_and_place_are_there_after_a_restart(self, window, hand, make_window, dataset):
        window.services.navigator.go_to(1)
        hand.key(Qt.Key.Key_A, CTRL | SHIFT)
        window.close()
        again = make_window(dataset)
        assert status(again, 1) is Status.APPROVED
        assert again.services.state.frame_index == 1

    def test_undoing_a_slip_gives_an_approved_frame_back(self, window, hand):
        hand.draw(MIDDLE, (100, 100), (200, 200))
        window.services.review.set_status("frame_0", Status.APPROVED)
        hand.key(Qt.Key.Key_W)
        hand.drag((100, 100), (120, 130))
        assert window.services.review.status("frame_0") is Status.IN_PROGRESS
        hand.key(Qt.Key.Key_Z, CTRL)
        assert window.services.review.status("frame_0") is Status.APPROVED
        hand.key(Qt.Key.Key_Z, CTRL)  # further back than what was approved
        assert window.services.review.status("frame_0") is Status.IN_PROGRESS

    def test_the_panel_gives_a_status_too(self, window):
        window.panels.show("review")
        combo = window.review.status
        combo.activated.emit(combo.findData(Status.REJECTED))
        assert status(window) is Status.REJECTED


class TestComments:
    def test_a_comment_has_author_and_time_and_can_be_settled(self, window, hand, qtbot):
        window.services.set_author("Ada")
        hand.key(Qt.Key.Key_M, CTRL)
        qtbot.keyClicks(window.review.text, "left post is hidden")
        qtbot.keyClick(window.review.text, Qt.Key.Key_Return)
        (comment,) = window.services.review.comments("frame_0")
        assert (comment.author, comment.text) == ("Ada", "left post is hidden")
        qtbot.waitUntil(lambda: window.review.comments.count() == 1)
        item = window.review.comments.item(0)
        assert "Ada" in item.text()
        item.setCheckState(Qt.CheckState.Checked)
        (settled,) = window.services.review.comments("frame_0")
        assert settled.resolved

    def test_escape_gives_the_keyboard_back(self, window, hand):
        window.panels.enter("review")
        assert window.review.text.hasFocus()
        QTest.keyClick(window.review.text, Qt.Key.Key_Escape)
        assert window.canvas.hasFocus()

    def test_writing_a_comment_finishes_no_polyline(self, window, hand, qtbot):
        window.services.selection.select_class(MIDDLE)
        hand.click(100, 100)
        window.panels.show("review")
        window.review.focus_comment()
        qtbot.keyClicks(window.review.text, "d")
        qtbot.keyClick(window.review.text, Qt.Key.Key_Return)
        assert window.canvas.editor.drawing
        assert window.services.state.frame_index == 0


class TestFilter:
    def test_states_elements_and_numbers_combine(self, window, hand, qtbot):
        hand.draw(MIDDLE, (100, 100), (200, 200))
        hand.key(Qt.Key.Key_Return, CTRL)
        window.services.navigator.go_to(1)
        hand.draw(TOP, (100, 100), (200, 200))
        for text, expected in (
            ("state:done", ["frame_0"]),
            ("-state:done", ["frame_1", "frame_2"]),
            ('has:"Middle line"', ["frame_0"]),
            ("n:1", ["frame_0", "frame_1"]),
            ("n:1 state:done", ["frame_0"]),
            ("frame_2", ["frame_2"]),
            ("state:", ["frame_0", "frame_1", "frame_2"]),
        ):
            window.frames.filter.setText(text)
            qtbot.waitUntil(lambda expected=expected: rows(window) == expected)

    def test_a_mistake_is_explained_and_hides_nothing(self, window):
        window.frames.filter.setText("staet:done")
        assert "state" in window.frames.problem.text()
        assert window.frames.problem.isVisible()
        assert len(rows(window)) == 3
        window.frames.filter.setText("")
        assert not window.frames.problem.isVisible()

    def test_a_new_status_changes_what_is_shown(self, window, hand, qtbot):
        window.frames.filter.setText("-state:done")
        hand.key(Qt.Key.Key_Return, CTRL)
        qtbot.waitUntil(lambda: rows(window) == ["frame_1", "frame_2"])


class TestVersions:
    def test_every_save_is_a_version_and_one_can_be_brought_back(self, window, hand, dataset):
        hand.draw(MIDDLE, (100, 100), (200, 200))
        first = (dataset / "frame_0.json").read_bytes()
        hand.draw(TOP, (100, 50), (200, 50))
        database = window.services.review.database
        versions = database.versions("frame_0")
        assert [v.reason for v in versions] == ["draw Far touchline", "draw Halfway line"]
        apply_version(window.services, versions[-1].id)
        assert window.services.state.annotation.annotated == (MIDDLE,)
        until_kept()
        assert (dataset / "frame_0.json").read_bytes() == first
        window.services.editing.undo()
        assert window.services.state.annotation.annotated == (MIDDLE, TOP)

    def test_what_was_there_before_the_first_edit_is_a_version_too(
        self, make_window, dataset, hand_on
    ):
        found = b'{"Circle left": [{"x": 0.5, "y": 0.5}]}'
        (dataset / "frame_0.json").write_bytes(found)
        window = make_window(dataset)
        hand_on(window).draw(MIDDLE, (100, 100), (200, 200))
        database = window.services.review.database
        assert database.version_data(database.versions("frame_0")[-1].id) == found


class TestProvenance:
    def test_it_is_exported_point_by_point(self, window, hand, tmp_path, qtbot):
        window.services.set_author("Ada")
        hand.draw(MIDDLE, (100, 100), (200, 200))
        hand.key(Qt.Key.Key_W)
        hand.drag((200, 200), (240, 260))
        target = tmp_path / "provenance.json"
        window.exporter.write_provenance(target)
        qtbot.waitUntil(target.exists)
        points = json.loads(target.read_text())["frames"]["frame_0"][MIDDLE]
        assert [(kind, author) for kind, author, _ in points] == [
            ("clicked", "Ada"),
            ("moved", "Ada"),
        ]

    def test_undo_gives_a_point_its_origin_back(self, window, hand):
        hand.draw(MIDDLE, (100, 100), (200, 200))
        hand.key(Qt.Key.Key_W)
        hand.drag((200, 200), (240, 260))
        services = window.services
        assert services.review.origin_counts("frame_0", services.state.annotation) == {
            OriginKind.CLICKED: 1,
            OriginKind.MOVED: 1,
        }
        services.editing.undo()
        assert services.review.origin_counts("frame_0", services.state.annotation) == {
            OriginKind.CLICKED: 2
        }

    def test_points_can_be_coloured_by_it(self, window, hand):
        hand.draw(MIDDLE, (100, 100), (200, 200))
        window.actions_["colour_origin"].trigger()
        clicked = [m for m in window.canvas.overlay_item.overlay.marks if m.colour == "#56B4E9"]
        assert any(len(m.centres) == 2 for m in clicked)


class TestTime:
    def test_the_panel_and_the_overview_count_the_time_of_the_frame_under_way(
        self, window, hand, monkeypatch, qtbot
    ):
        services, now = window.services, [1000.0]
        monkeypatch.setattr("procc_annotator.gui.state.review_state.monotonic", lambda: now[0])
        services.navigator.go_to(1)
        now[0] += 12.0
        hand.draw(MIDDLE, (100, 100), (200, 200))
        hand.key(Qt.Key.Key_Return, CTRL)
        name = services.state.frame.name if services.state.frame is not None else ""
        assert services.review.record(name).seconds == 12.0
        window.panels.show("review")
        qtbot.waitUntil(lambda: window.review.time.text() == "12 s")


class TestOverview:
    def test_it_counts_statuses_classes_and_time(self, window, hand):
        hand.draw(MIDDLE, (100, 100), (200, 200))
        hand.key(Qt.Key.Key_Return, CTRL)
        services = window.services
        assert services.state.workspace is not None
        workspace, database = services.state.workspace, services.review.database
        found = overview_rows(workspace, database, {}, lambda *_: None)
        assert [row.status for row in found] == ["done", "untouched", "untouched"]
        assert dict(found[0].classes) == {MIDDLE: 2}

    def test_an_unreadable_frame_has_a_row_too(self, dataset, make_window, tmp_path, qtbot):
        (dataset / "frame_1.json").write_text("{")
        target = tmp_path / "overview.csv"
        make_window(dataset).exporter.write_overview(target)
        qtbot.waitUntil(target.exists)
        assert len(target.read_text().splitlines()) == 4

    def test_a_file_that_cannot_be_written_is_one_message(self, window, tmp_path, qtbot):
        target = tmp_path / "gone" / "overview.csv"
        said = window.services.store.events.message
        with qtbot.waitSignal(said, check_params_cb=lambda m: str(target) in m.text):
            window.exporter.write_overview(target)


class TestSecondAnnotator:
    @pytest.fixture
    def other(self, tmp_path) -> Path:
        folder = tmp_path / "other"
        folder.mkdir()
        points = [{"x": 102 / 639, "y": 100 / 359}, {"x": 202 / 639, "y": 100 / 359}]
        (folder / "frame_0.json").write_text(json.dumps({MIDDLE: points, TOP: points}))
        return folder

    def test_both_are_drawn_and_compared(self, window, hand, other, qtbot):
        hand.draw(MIDDLE, (100, 103), (200, 103))
        window.panels.show("agreement")
        window.services.second_annotator.open(other)
        qtbot.waitUntil(lambda: window.services.state.noise_floor is not None)
        table = window.agreement.table
        qtbot.waitUntil(lambda: table.model().rowCount() == 1)
        (clicked,) = window.services.state.annotation.polylines
        apart = (clicked.points[0].v - 100 / 359) * 539  # in px of the evaluation size
        assert table.model().index(0, 1).data() == f"{apart:.2f} px"
        assert "Only there" in window.agreement.frame.text()
        second = [s for s in window.canvas.overlay_item.overlay.strokes if s.layer == "second"]
        assert len(second[0].segments) == 2

    def test_clicks_beyond_and_elements_apart_are_told(self, window, hand, tmp_path, qtbot):
        hand.draw(MIDDLE, (100, 100), (200, 100))
        hand.draw(TOP, (200, 200), (400, 200))
        folder = write_other(
            tmp_path, frame_0={MIDDLE: [(100, 103), (300, 103)], TOP: [(400, 200), (500, 100)]}
        )
        window.panels.show("agreement")
        window.services.second_annotator.open(folder)
        table = window.agreement.table
        qtbot.waitUntil(lambda: table.model().rowCount() == 2)
        cells = [[table.model().index(row, column).data() for column in range(4)] for row in (0, 1)]
        assert cells[0] == ["Far touchline", "apart", "apart", "0 of 4"]
        assert cells[1][0] == "Halfway line"
        assert cells[1][3] == "3 of 4"
        assert "1 left out" in table.model().index(1, 3).data(Qt.ItemDataRole.ToolTipRole)
        text = window.agreement.frame.text()
        assert "JaC at 5 px: 0.500" in text
        assert "Apart: Far touchline" in text
        assert "1 click beyond" in text

    def test_a_file_that_cannot_be_read_is_told(self, window, hand, tmp_path, qtbot):
        hand.draw(MIDDLE, (100, 100), (200, 100))
        folder = write_other(tmp_path, frame_0={MIDDLE: [(100, 103), (200, 103)]})
        (folder / "frame_1.json").write_text("{")
        window.panels.show("agreement")
        window.services.second_annotator.open(folder)
        panel = window.agreement
        qtbot.waitUntil(lambda: "1 frame unreadable" in panel.noise.text())
        assert "Human noise over 1 frame:" in panel.noise.text()
        assert "frame_1.json" in panel.noise.toolTip()
        window.services.navigator.go_to(1)
        qtbot.waitUntil(lambda: "unreadable" in panel.frame.text())
        assert "frame_1.json" in panel.frame.text()
        window.services.navigator.go_to(2)
        qtbot.waitUntil(lambda: "has nothing for this frame" in panel.frame.text())
        window.services.navigator.go_to(0)
        qtbot.waitUntil(lambda: "JaC" in panel.frame.text())

    @pytest.mark.new_window  # its panel is not in it any more afterwards
    def test_the_table_fits_a_narrow_panel(self, window, hand, other, qtbot):
        hand.draw(MIDDLE, (100, 103), (120, 103))
        panel = window.agreement
        window.services.second_annotator.open(other)
        window.panels.show("agreement")
        all_done(qtbot)
        table = panel.table
        qtbot.waitUntil(lambda: table.model().rowCount() == 1)
        assert panel.minimumSizeHint().width() <= 290
        panel.setParent(None)  # out of its dock, to be as narrow as a dock may be
        panel.resize(290, 500)
        panel.show()
        qtbot.waitUntil(lambda: table.viewport().width() < 290)
        assert not table.horizontalScrollBar().isVisible()
        assert table.columnWidth(0) >= 70
        panel.close()

    def test_any_format_is_read_with_the_labels_of_its_folder(self, window, hand, tmp_path, qtbot):
        hand.draw(MIDDLE, (100, 100), (200, 100))
        folder = tmp_path / "theirs"
        folder.mkdir()
        shape = {
            "label": "centre",
            "shape_type": "line",
            "points": [[100.5, 103.5], [200.5, 103.5]],
        }
        file = folder / "frame_0.json"
        size = {"imageWidth": 640, "imageHeight": 360, "imagePath": "frame_0.png"}
        file.write_text(json.dumps({"version": "5.0", "shapes": [shape], **size}))
        before = file.read_bytes()
        (folder / "labels.toml").write_text(f'[labels]\n"centre" = "{MIDDLE}"\n')
        window.services.second_annotator.open(folder)
        assert not window.services.second_annotator.is_open  # it is read in the background
        all_done(qtbot)
        table = window.agreement.table
        assert table.model().rowCount() == 1
        assert table.model().index(0, 0).data() == "Halfway line"
        assert "read as labelme" in window.status.hint.text_for(2000)
        assert window.services.state.noise_floor is not None
        assert file.read_bytes() == before

    def test_closing_it_takes_everything_away(self, window, hand, other, qtbot):
        hand.draw(MIDDLE, (100, 103), (200, 103))
        window.services.second_annotator.open(other)
        qtbot.waitUntil(lambda: window.services.state.noise_floor is not None)
        window.services.second_annotator.close()
        qtbot.waitUntil(lambda: window.services.state.noise_floor is None)
        assert window.services.second_annotator.annotation is None

    def test_a_folder_without_annotations_is_one_message(self, window, tmp_path, qtbot):
        empty = tmp_path / "empty"
        empty.mkdir()
        window.services.second_annotator.open(empty)
        all_done(qtbot)
        assert "no annotation" in window.message_bar.label.text()
        (empty / "match_info.json").write_text('{"match": "BRA-GER"}')
        window.services.second_annotator.open(empty)
        all_done(qtbot)
        assert "match_info.json holds no list of points" in window.message_bar.label.text()


class TestDatabase:
    def test_a_damaged_one_is_set_aside_and_restored(self, window, hand, dataset, make_window):
        hand.draw(MIDDLE, (100, 100), (200, 200))
        window.close()
        (dataset / ".procc" / "workspace.db").write_bytes(b"not a database at all" * 50)
        again = make_window(dataset)
        assert again.services.state.annotation.annotated == (MIDDLE,)
        assert "restored from the backup of 20" in again.message_bar.label.text()
        assert status(again) is Status.IN_PROGRESS
        (dataset / ".procc" / "workspace.db").write_bytes(b"")  # while the window has it open
        again.services.review.set_status("frame_1", Status.DONE)
        assert again.services.review.database.flush(20)
        again.services.review.poll()
        assert "damaged-2; restored from" in again.message_bar.label.text()
        assert [status(again, i) for i in (0, 1)] == [Status.IN_PROGRESS, Status.DONE]

    def test_a_foreign_one_is_not_touched(self, dataset, make_window, hand_on):
        (dataset / ".procc").mkdir()
        with sqlite3.connect(dataset / ".procc" / "workspace.db") as foreign:
            foreign.execute("CREATE TABLE theirs(x)")
        foreign.close()
        window = make_window(dataset)
        hand_on(window).draw(MIDDLE, (100, 100), (200, 200))
        assert status(window) is Status.IN_PROGRESS
        kept = [p for p in (dataset / ".procc").iterdir() if p.name.startswith("workspace.db.")]
        assert kept


def test_a_step_to_the_next_frame_waits_for_no_answer_of_the_database(window, qtbot, monkeypatch):
    """What was queued before (the time on the frame) goes to the disk first."""
    window.panels.show("review")
    all_done(qtbot)
    asked: list[str] = []
    ask = WorkspaceDatabase._ask_origins

    def watched(self: WorkspaceDatabase, frame: str) -> object:
        asked.append(frame)
        return ask(self, frame)

    monkeypatch.setattr(WorkspaceDatabase, "_ask_origins", watched)
    window.services.navigator.go_to(1)
    all_done(qtbot)
    assert "frame_1" not in asked  # it was asked for while frame_0 was on screen
    assert "frame_1" in window.services.review._origins
