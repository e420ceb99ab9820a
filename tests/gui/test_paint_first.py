"""An edit is shown first, saved behind the interface, and judged for the set after the paint."""

import json
from pathlib import Path

import pytest
from PySide6.QtCore import QEvent, QObject, QTimer
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QApplication, QWidget

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset import editing
from tests.gui.conftest import all_done, settle

FRAME = 1  # of the sample, annotated and with a camera in every source


def nudged(annotation: FrameAnnotation) -> FrameAnnotation:
    """Its first element a little further to the right."""
    polyline = annotation.polylines[0]
    chosen = [(polyline.class_name, i) for i in range(len(polyline.points))]
    return editing.move_points(annotation, chosen, 0.05, 0.0)


def on_disk(folder: Path, frame: str, class_name: str) -> list[float]:
    entries = json.loads((folder / f"{frame}.json").read_text())
    return [point["x"] for point in entries[class_name]]


def test_an_edit_is_shown_before_it_is_saved_and_judged(audited, qtbot):
    services, order = audited.services, []
    services.store.watch(lambda s: s.annotation, lambda: order.append("shown"))
    services.saver.saved.connect(lambda: order.append("saved"))
    services.store.events.sourceAuditsChanged.connect(lambda _: order.append("judged"))
    services.editing.commit_edit("nudge", nudged(services.state.annotation))
    assert order == ["shown"]
    assert audited.top_bar.saved.text() == "saving..."
    qtbot.waitUntil(lambda: {"saved", "judged"} <= set(order))
    assert audited.top_bar.saved.text() == "saved"


def test_leaving_right_after_an_edit_judges_what_was_left(audited, qtbot):
    services = audited.services
    name, before = (
        services.state.frame.name,
        services.scoring.active_audits[services.state.frame.name],
    )
    services.editing.commit_edit("nudge", nudged(services.state.annotation))
    score = services.scorer.score
    services.navigator.next_frame()
    assert services.scoring.active_audits[name] is not before
    assert services.scoring.active_audits[name].jac_at(services.state.tau) == pytest.approx(
        score.jac
    )
    settle(audited.services, qtbot)


def test_closing_right_after_an_edit_or_an_undo_loses_nothing(make_window, annotated):
    window = make_window(annotated)
    services = window.services
    services.navigator.go_to(FRAME)
    frame, polyline = services.state.frame.name, services.state.annotation.polylines[0]
    services.editing.commit_edit("nudge", nudged(services.state.annotation))
    moved = [point.u for point in services.state.annotation.polylines[0].points]
    window.close()
    assert on_disk(annotated, frame, polyline.class_name) == moved
    window = make_window(annotated)
    window.services.navigator.go_to(FRAME)
    window.services.editing.commit_edit("nudge", nudged(window.services.state.annotation))
    window.services.editing.undo()
    window.close()
    assert on_disk(annotated, frame, polyline.class_name) == moved


def test_an_undo_is_one_step_and_draws_the_overlay_once(audited, qtbot, monkeypatch):
    services, canvas = audited.services, audited.canvas
    services.editing.commit_edit("nudge", nudged(services.state.annotation))
    settle(audited.services, qtbot)
    steps, drawn = [], []
    services.store.watch(lambda s: s.annotation, lambda: steps.append(1))
    draw = canvas.overlay_item.set_overlay
    monkeypatch.setattr(
        canvas.overlay_item, "set_overlay", lambda *a, **k: (drawn.append(a), draw(*a, **k))
    )
    services.editing.undo()
    assert (len(steps), len(drawn)) == (1, 1)
    assert audited.status.hint.text().startswith("undone: nudge")
    settle(audited.services, qtbot)


class Layouts(QObject):
    """Counts how often a widget is asked to lay itself out anew."""

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self.count = 0
        widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        self.count += event.type() == QEvent.Type.LayoutRequest
        return False


def test_a_text_in_a_bar_does_not_lay_out_the_window(audited, qtbot):
    settle(audited.services, qtbot)
    status, saved, layouts = audited.status, audited.top_bar.saved, Layouts(audited)
    saved.set_saved("saving...", alarm=False)
    status.set_work("scoring 1 / 2,000")
    status.tell("a line that is longer than the one before it")
    audited.top_bar.camera_bar.jac.set_text("JaC 0.123")
    QApplication.processEvents()
    layouts.count = 0  # the score may need other room than the one before it
    audited.top_bar.camera_bar.jac.set_text("JaC 0.456")
    saved.set_saved("NOT SAVED: 2 frames", alarm=True)
    status.set_work("")
    status.tell("short")
    QApplication.processEvents()
    assert layouts.count == 0
    assert saved.width() >= saved.sizeHint().width(), "nothing of it is cut"
    saved.set_saved("saved 12:34:56", alarm=False)


class Painted(QObject):
    """Collects what is painted of a widget."""

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self.heights: list[int] = []
        widget.installEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QPaintEvent):
            self.heights.append(event.rect().height())
        return False


def test_an_edit_is_painted_before_anything_that_waits_its_turn(audited, qtbot):
    settle(audited.services, qtbot)
    services, canvas, later = audited.services, audited.canvas, QTimer(singleShot=True, interval=0)
    painted = Painted(canvas.viewport())
    QApplication.processEvents()
    painted.heights.clear()
    seen: list[int] = []
    later.timeout.connect(lambda: seen.append(len(painted.heights)))
    services.editing.commit_edit("nudge", nudged(services.state.annotation))
    later.start()
    qtbot.waitUntil(lambda: bool(seen))
    assert seen == [1], "the picture was painted before it, once"
    settle(audited.services, qtbot)


def test_one_row_of_the_frames_is_painted_for_one_frame(audited, qtbot):
    audited.panels.show("frames")
    all_done(qtbot)  # thumbnails, marks and the label check paint rows when they come
    check, rows = audited.services.label_check, audited.frames.list
    painted = Painted(rows.viewport())
    QApplication.processEvents()
    painted.heights.clear()  # what an earlier change had left to paint
    check.framesChanged.emit(audited.services.state.workspace.frames[3].name)
    QApplication.processEvents()
    assert painted.heights == [rows.rowHeight(3)]
    painted.heights.clear()
    check.framesChanged.emit("")
    QApplication.processEvents()
    assert painted.heights == [rows.viewport().height()]
