"""Status, comments, provenance, versions, filter and the second annotator in the window."""

import json
import sqlite3
from pathlib import Path

import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtTest import QTest

from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.editing import move_points
from procc_annotator.dataset.records import OriginKind, Status
from procc_annotator.gui.commands.exporting import Exporter
from procc_annotator.gui.commands.frame_walks import StatusWalk
from procc_annotator.gui.commands.versions import apply_version
from procc_annotator.gui.panels.agreement import AgreementPanel
from procc_annotator.gui.panels.frames import FramesPanel
from procc_annotator.gui.panels.review import ReviewPanel
from procc_annotator.gui.state.services import Services
from procc_annotator.report.window_tables import overview_rows
from tests.gui.conftest import all_done, draw, heard

CTRL = Qt.KeyboardModifier.ControlModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
MIDDLE, TOP = "Middle line", "Side line top"


def status(services: Services, frame: int = 0) -> Status:
    return services.review.status(f"frame_{frame}")


def rows(panel: FramesPanel) -> list[str]:
    model = panel.model
    return [str(model.data(model.index(row))) for row in range(model.rowCount())]


def px(*points: tuple[float, float]) -> list[tuple[float, float]]:
    return [(x / 639, y / 359) for x, y in points]


def move(services: Services, point: int) -> None:
    moved = move_points(services.state.annotation, [(MIDDLE, point)], 0.05, 0.05)
    assert services.editing.commit_edit("move", moved, OriginKind.MOVED)


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


@pytest.fixture
def panel(services, show) -> ReviewPanel:
    return show(ReviewPanel(services))


class TestStatus:
    def test_an_edit_begins_a_frame_and_ctrl_enter_ends_it(self, window, hand):
        assert status(window.services) is Status.UNTOUCHED
        hand.draw(MIDDLE, (100, 100), (200, 200))
        assert status(window.services) is Status.IN_PROGRESS
        hand.key(Qt.Key.Key_Return, CTRL)
        assert status(window.services) is Status.DONE
        assert window.top_bar.status.text() == "done"

    def test_shift_d_goes_on_to_what_is_not_done(self, services):
        services.navigator.go_to(1)
        services.editing.commit_frame()
        services.navigator.go_to(0)
        StatusWalk(services).go("unfinished", 1)
        assert services.state.frame_index == 2
        StatusWalk(services).go("unfinished", -1)
        assert services.state.frame_index == 0

    def test_a_rejected_frame_is_found_and_editing_it_reopens_it(self, services):
        services.navigator.go_to(2)
        services.review.set_status("frame_2", Status.REJECTED)
        assert status(services, 2) is Status.REJECTED
        services.navigator.go_to(0)
        StatusWalk(services).go("rejected", 1)
        assert services.state.frame_index == 2
        draw(services, MIDDLE)
        assert status(services, 2) is Status.IN_PROGRESS

    def test_status_and_place_are_there_after_a_restart(self, services, open_services, dataset):
        services.navigator.go_to(1)
        services.review.set_status("frame_1", Status.APPROVED)
        services.close()
        again = open_services(dataset)
        assert status(again, 1) is Status.APPROVED
        assert again.state.frame_index == 1

    def test_undoing_a_slip_gives_an_approved_frame_back(self, services):
        draw(services, MIDDLE)
        services.review.set_status("frame_0", Status.APPROVED)
        move(services, 0)
        assert services.review.status("frame_0") is Status.IN_PROGRESS
        services.editing.undo()
        assert services.review.status("frame_0") is Status.APPROVED
        services.editing.undo()  # further back than what was approved
        assert services.review.status("frame_0") is Status.IN_PROGRESS

    @pytest.mark.parametrize("way", ["button", "key"])
    def test_a_frame_with_an_open_comment_is_approved_once_that_was_asked(
        self, window, monkeypatch, qtbot, way
    ):
        services, panel, answers, asked = window.services, window.review, [False, True], []

        def answer(_parent: object, count: int) -> bool:
            asked.append(count)
            return answers.pop(0)

        monkeypatch.setattr("procc_annotator.gui.panels.review.ask_to_approve", answer)
        window.panels.show("review")
        qtbot.waitUntil(panel.approve.isVisible)
        services.review.add_comment("frame_0", "left post is hidden")
        do = {
            "button": lambda: QTest.mouseClick(panel.approve, Qt.MouseButton.LeftButton),
            "key": lambda: QTest.keyClick(window.canvas, Qt.Key.Key_A, CTRL | SHIFT),
        }[way]
        do()
        assert status(services) is Status.UNTOUCHED
        do()
        assert status(services) is Status.APPROVED
        assert asked == [1, 1]
        QTest.mouseClick(panel.reject, Qt.MouseButton.LeftButton)
        assert status(services) is Status.REJECTED
        qtbot.waitUntil(lambda: panel.status.text() == "rejected")
        services.review.resolve_comment(services.review.comments("frame_0")[0], True)
        do()
        assert status(services) is Status.APPROVED
        assert asked == [1, 1]


class TestComments:
    def test_a_comment_has_author_and_time_and_can_be_settled(self, panel, services, qtbot):
        services.set_author("Ada")
        panel.focus_comment()
        qtbot.keyClicks(panel.text, "left post is hidden")
        qtbot.keyClick(panel.text, Qt.Key.Key_Return)
        (comment,) = services.review.comments("frame_0")
        assert (comment.author, comment.text) == ("Ada", "left post is hidden")
        qtbot.waitUntil(lambda: panel.comments.count() == 1)
        item = panel.comments.item(0)
        assert "Ada" in item.text()
        item.setCheckState(Qt.CheckState.Checked)
        (settled,) = services.review.comments("frame_0")
        assert settled.resolved

    @pytest.mark.parametrize("way", ["key", "menu"])
    def test_a_comment_is_pinned_to_a_place(self, window, hand, qtbot, monkeypatch, way):
        panel, place = window.review, hand.picture(300, 200)
        hand.move(300, 200)
        if way == "key":
            QTest.keyClick(window.canvas, Qt.Key.Key_M, CTRL | SHIFT)
        else:
            menu, at = "procc_annotator.gui.window.menus._CanvasMenu.exec", hand.at(300, 200)
            monkeypatch.setattr(menu, lambda menu, _: menu.actions()[-1].trigger())
            mouse = QContextMenuEvent.Reason.Mouse
            window.canvas.contextMenuEvent(QContextMenuEvent(mouse, at, at))
        qtbot.waitUntil(panel.text.hasFocus)
        qtbot.keyClicks(panel.text, "wrong line")
        QTest.keyClick(panel.text, Qt.Key.Key_Return)
        (comment,) = window.services.review.comments("frame_0")
        assert comment.place == pytest.approx(place)
        window.services.review.add_comment("frame_0", "of the whole frame")
        qtbot.waitUntil(lambda: panel.comments.count() == 2)
        assert not panel.comments.selectedItems()
        on_pin = hand.at(312, 185)
        qtbot.waitUntil(lambda: window.canvas.comment_at(QPointF(on_pin)) == comment)
        QTest.mouseClick(window.canvas.viewport(), Qt.MouseButton.LeftButton, pos=on_pin)
        assert not window.canvas.editor.drawing
        assert [i.text()[:3] for i in panel.comments.selectedItems()] == ["✎ 1"]
        assert window.finding_tips.tip_at(QPointF(on_pin)) == "wrong line"
        item = panel.comments.visualItemRect(panel.comments.item(0)).center()
        QTest.mouseClick(panel.comments.viewport(), Qt.MouseButton.LeftButton, pos=item)
        assert (window.canvas.place.x, window.canvas.place.y) == pytest.approx(place, abs=1)
        window.services.review.resolve_comment(comment, True)
        assert window.services.review.pins == {}

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
    @pytest.fixture
    def frames(self, services, show) -> FramesPanel:
        return show(FramesPanel(services))

    def test_states_elements_and_numbers_combine(self, frames, services, qtbot):
        draw(services, MIDDLE)
        services.editing.commit_frame()
        services.navigator.go_to(1)
        draw(services, TOP)
        for text, expected in (
            ("state:done", ["frame_0"]),
            ("-state:done", ["frame_1", "frame_2"]),
            ('has:"Middle line"', ["frame_0"]),
            ("n:1", ["frame_0", "frame_1"]),
            ("n:1 state:done", ["frame_0"]),
            ("frame_2", ["frame_2"]),
            ("state:", ["frame_0", "frame_1", "frame_2"]),
        ):
            frames.filter.setText(text)
            qtbot.waitUntil(lambda expected=expected: rows(frames) == expected)

    def test_a_mistake_is_explained_and_hides_nothing(self, frames, services):
        frames.filter.setText("staet:done")
        assert "state" in frames.problem.text()
        assert frames.problem.isVisible()
        assert len(rows(frames)) == 3
        frames.filter.setText("")
        assert not frames.problem.isVisible()

    def test_a_new_status_changes_what_is_shown(self, frames, services, qtbot):
        frames.filter.setText("-state:done")
        services.editing.commit_frame()
        qtbot.waitUntil(lambda: rows(frames) == ["frame_1", "frame_2"])


class TestVersions:
    def test_every_save_is_a_version_and_one_can_be_brought_back(self, services, dataset):
        draw(services, MIDDLE)
        first = (dataset / "frame_0.json").read_bytes()
        draw(services, TOP)
        database = services.review.database
        versions = database.versions("frame_0")
        assert [v.reason for v in versions] == [f"draw {TOP}", f"draw {MIDDLE}"]
        apply_version(services, versions[-1].id)
        assert services.state.annotation.annotated == (MIDDLE,)
        services.saver.settle()
        assert (dataset / "frame_0.json").read_bytes() == first
        services.editing.undo()
        assert services.state.annotation.annotated == (MIDDLE, TOP)

    def test_what_was_there_before_the_first_edit_is_a_version_too(
        self, open_services, dataset, hand_on
    ):
        found = b'{"Circle left": [{"x": 0.5, "y": 0.5}]}'
        (dataset / "frame_0.json").write_bytes(found)
        services = open_services(dataset)
        draw(services, MIDDLE)
        database = services.review.database
        assert database.version_data(database.versions("frame_0")[-1].id) == found


class TestProvenance:
    def test_it_is_exported_point_by_point(self, widget, services, tmp_path, qtbot):
        services.set_author("Ada")
        draw(services, MIDDLE)
        move(services, 1)
        target = tmp_path / "provenance.json"
        Exporter(services, widget).write_provenance(target)
        qtbot.waitUntil(target.exists)
        points = json.loads(target.read_text())["frames"]["frame_0"][MIDDLE]
        assert [(kind, author) for kind, author, _ in points] == [
            ("clicked", "Ada"),
            ("moved", "Ada"),
        ]

    def test_undo_gives_a_point_its_origin_back(self, services):
        draw(services, MIDDLE)
        move(services, 1)
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
        self, panel, services, monkeypatch, qtbot
    ):
        now = [1000.0]
        monkeypatch.setattr("procc_annotator.gui.state.review_state.monotonic", lambda: now[0])
        services.navigator.go_to(1)
        now[0] += 12.0
        draw(services, MIDDLE)
        services.editing.commit_frame()
        name = services.state.frame.name if services.state.frame is not None else ""
        assert services.review.record(name).seconds == 12.0
        qtbot.waitUntil(lambda: panel.time.text() == "12 s")


class TestOverview:
    def test_it_counts_statuses_classes_and_time(self, services):
        draw(services, MIDDLE)
        services.editing.commit_frame()
        assert services.state.workspace is not None
        workspace, database = services.state.workspace, services.review.database
        found = overview_rows(workspace, database, {}, lambda *_: None)
        assert [row.status for row in found] == ["done", "untouched", "untouched"]
        assert dict(found[0].classes) == {MIDDLE: 2}

    def test_an_unreadable_frame_has_a_row_too(
        self, widget, dataset, open_services, tmp_path, qtbot
    ):
        (dataset / "frame_1.json").write_text("{")
        target = tmp_path / "overview.csv"
        Exporter(open_services(dataset), widget).write_overview(target)
        qtbot.waitUntil(target.exists)
        assert len(target.read_text().splitlines()) == 4

    def test_a_file_that_cannot_be_written_is_one_message(self, widget, services, tmp_path, qtbot):
        target = tmp_path / "gone" / "overview.csv"
        said = services.store.events.message
        with qtbot.waitSignal(said, check_params_cb=lambda m: str(target) in m.text):
            Exporter(services, widget).write_overview(target)


class TestSecondAnnotator:
    @pytest.fixture
    def panel(self, services, show) -> AgreementPanel:
        return show(AgreementPanel(services))

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

    def test_clicks_beyond_and_elements_apart_are_told(self, panel, services, tmp_path, qtbot):
        draw(services, MIDDLE, *px((100, 100), (200, 100)))
        draw(services, TOP, *px((200, 200), (400, 200)))
        folder = write_other(
            tmp_path, frame_0={MIDDLE: [(100, 103), (300, 103)], TOP: [(400, 200), (500, 100)]}
        )
        services.second_annotator.open(folder)
        table = panel.table
        qtbot.waitUntil(lambda: table.model().rowCount() == 2)
        cells = [[table.model().index(row, column).data() for column in range(4)] for row in (0, 1)]
        assert cells[0] == ["Far touchline", "apart", "apart", "0 of 4"]
        assert cells[1][0] == "Halfway line"
        assert cells[1][3] == "3 of 4"
        assert "1 left out" in table.model().index(1, 3).data(Qt.ItemDataRole.ToolTipRole)
        text = panel.frame.text()
        assert "JaC at 5 px: 0.500" in text
        assert "Apart: Far touchline" in text
        assert "1 click beyond" in text

    def test_a_file_that_cannot_be_read_is_told(self, panel, services, tmp_path, qtbot):
        draw(services, MIDDLE, *px((100, 100), (200, 100)))
        folder = write_other(tmp_path, frame_0={MIDDLE: [(100, 103), (200, 103)]})
        (folder / "frame_1.json").write_text("{")
        services.second_annotator.open(folder)
        qtbot.waitUntil(lambda: "1 frame unreadable" in panel.noise.text())
        assert "Human noise over 1 frame:" in panel.noise.text()
        assert "frame_1.json" in panel.noise.toolTip()
        services.navigator.go_to(1)
        qtbot.waitUntil(lambda: "unreadable" in panel.frame.text())
        assert "frame_1.json" in panel.frame.text()
        services.navigator.go_to(2)
        qtbot.waitUntil(lambda: "has nothing for this frame" in panel.frame.text())
        services.navigator.go_to(0)
        qtbot.waitUntil(lambda: "JaC" in panel.frame.text())

    def test_the_table_fits_a_narrow_panel(self, panel, services, other, qtbot):
        draw(services, MIDDLE, *px((100, 103), (120, 103)))
        services.second_annotator.open(other)
        all_done(qtbot)
        table = panel.table
        qtbot.waitUntil(lambda: table.model().rowCount() == 1)
        assert panel.minimumSizeHint().width() <= 290
        panel.resize(290, 500)
        qtbot.waitUntil(lambda: table.viewport().width() < 290)
        assert not table.horizontalScrollBar().isVisible()
        assert table.columnWidth(0) >= 70

    def test_any_format_is_read_with_the_labels_of_its_folder(
        self, panel, services, tmp_path, qtbot
    ):
        draw(services, MIDDLE, *px((100, 100), (200, 100)))
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
        told = heard(services)
        services.second_annotator.open(folder)
        assert not services.second_annotator.is_open  # it is read in the background
        all_done(qtbot)
        table = panel.table
        assert table.model().rowCount() == 1
        assert table.model().index(0, 0).data() == "Halfway line"
        assert "read as labelme" in told[-1]
        assert services.state.noise_floor is not None
        assert file.read_bytes() == before

    def test_closing_it_takes_everything_away(self, panel, services, other, qtbot):
        draw(services, MIDDLE, *px((100, 103), (200, 103)))
        services.second_annotator.open(other)
        qtbot.waitUntil(lambda: services.state.noise_floor is not None)
        services.second_annotator.close()
        qtbot.waitUntil(lambda: services.state.noise_floor is None)
        assert services.second_annotator.annotation is None

    def test_a_folder_without_annotations_is_one_message(self, panel, services, tmp_path, qtbot):
        empty = tmp_path / "empty"
        empty.mkdir()
        told = heard(services)
        services.second_annotator.open(empty)
        all_done(qtbot)
        assert "no annotation" in told[-1]
        (empty / "match_info.json").write_text('{"match": "BRA-GER"}')
        services.second_annotator.open(empty)
        all_done(qtbot)
        assert "match_info.json holds no list of points" in told[-1]


class TestDatabase:
    def test_a_damaged_one_is_set_aside_and_restored(self, services, dataset, open_services):
        draw(services, MIDDLE)
        services.close()
        (dataset / ".procc" / "workspace.db").write_bytes(b"not a database at all" * 50)
        again = open_services()
        told = heard(again)
        assert again.opening.open_path(dataset)
        assert again.state.annotation.annotated == (MIDDLE,)
        assert "restored from the backup of 20" in told[-1]
        assert status(again) is Status.IN_PROGRESS
        (dataset / ".procc" / "workspace.db").write_bytes(b"")  # while the window has it open
        again.review.set_status("frame_1", Status.DONE)
        assert again.review.database.flush(20)
        again.review.poll()
        assert "damaged-2; restored from" in told[-1]
        assert [status(again, i) for i in (0, 1)] == [Status.IN_PROGRESS, Status.DONE]

    def test_a_foreign_one_is_not_touched(self, dataset, open_services):
        (dataset / ".procc").mkdir()
        with sqlite3.connect(dataset / ".procc" / "workspace.db") as foreign:
            foreign.execute("CREATE TABLE theirs(x)")
        foreign.close()
        services = open_services(dataset)
        draw(services, MIDDLE)
        assert status(services) is Status.IN_PROGRESS
        kept = [p for p in (dataset / ".procc").iterdir() if p.name.startswith("workspace.db.")]
        assert kept


def test_a_step_to_the_next_frame_waits_for_no_answer_of_the_database(
    services, show, qtbot, monkeypatch
):
    """What was queued before (the time on the frame) goes to the disk first."""
    show(ReviewPanel(services))
    all_done(qtbot)
    asked: list[str] = []
    ask = WorkspaceDatabase._ask_origins

    def watched(self: WorkspaceDatabase, frame: str) -> object:
        asked.append(frame)
        return ask(self, frame)

    monkeypatch.setattr(WorkspaceDatabase, "_ask_origins", watched)
    services.navigator.go_to(1)
    all_done(qtbot)
    assert "frame_1" not in asked  # it was asked for while frame_0 was on screen
    assert "frame_1" in services.review._origins
