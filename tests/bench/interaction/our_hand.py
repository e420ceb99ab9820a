"""One run of a hand on this program's window: prints what it waited for.

Arguments: dataset, folder for settings, number of the first frame, when the process was begun
(`time.monotonic`), and a folder of cameras, or none.
"""

import gc

gc.disable()  # as the command does before it imports the window
# ruff: noqa: E402

import itertools
import sys
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path

from PySide6.QtCore import QEvent, QPoint, QPointF, QSettings, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from procc_annotator.gui.app import (
    application,
    build_window,
    go_to_work,
    start_lean,
)
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.background import hold
from tests.bench.interaction.stopwatch import Stopwatch, resident_mb

ELEMENT = "Big rect. left main"
LEFT, NONE = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier


def main() -> None:
    dataset, settings, first, begun = Path(sys.argv[1]), sys.argv[2], int(sys.argv[3]), sys.argv[4]
    cameras = Path(sys.argv[5]) if len(sys.argv) > 5 else None
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, settings)
    start_lean()  # as the program does until its window is shown
    app = application()
    watch = Stopwatch(app.processEvents)
    tell_when_painted(watch)
    hold()
    window = build_window(dataset, cameras=cameras if cameras is not None else ())
    window.resize(1920, 1080)
    watch.time("painting alone", window.show)
    start = time.monotonic() - float(begun)
    go_to_work(app)
    hand = OurHand(window, watch)
    watch.rest(hand.quiet, least_s=0.5)
    hand.edit(first)
    hand.walk(first)
    memory = hand.memory()
    watch.tell(start=start, memory=memory, longest=hand.longest)
    window.close()


def tell_when_painted(watch: Stopwatch) -> None:
    """The window has painted all its widgets when it has answered a request for an update."""
    answer = MainWindow.event

    def event(self: MainWindow, event: QEvent) -> bool:
        answered = bool(answer(self, event))
        if event.type() == QEvent.Type.UpdateRequest:
            watch.painted()
        return answered

    MainWindow.event = event


class OurHand:
    """Does what is measured."""

    def __init__(self, window: MainWindow, watch: Stopwatch) -> None:
        self.window, self.services, self.watch = window, window.services, watch
        self.longest: list[float] = []

    def quiet(self) -> bool:
        """Whether everything in the background is done."""
        from procc_annotator.gui.state import background

        return not background._dispatcher().jobs

    def rest(self, least_s: float = 0.06) -> None:
        self.watch.rest(self.quiet, least_s)

    def edit(self, first: int) -> None:
        services, watch, canvas = self.services, self.watch, self.window.canvas
        services.navigator.go_to(first)
        self.rest(0.5)
        services.selection.set_mode("edit")
        for snapping, name in ((True, "snapping and loupe"), (False, "neither")):
            services.selection.set_option("snapping", snapping)
            if not snapping:
                canvas._place_loupe = canvas.loupe.hide
            self.rest()
            for turn in range(3):
                self._drag(f"drag, per move, {name}", turn)
        del canvas._place_loupe
        services.selection.set_option("snapping", True)
        for turn in range(20):
            self.rest()
            watch.time("undo", services.editing.redo if turn % 2 else services.editing.undo)
        self._draw()
        for turn in range(20):
            (services.editing.redo if turn % 2 else services.editing.undo)()
            self.rest()
            workspace, index = services.state.workspace, services.state.frame_index
            edited = workspace.state(index).history
            workspace.edit(index, "bench", _moved(edited.current, 1e-4 * (turn + 1)))
            watch.time("save", partial(services.saver.save_behind, index), paints=False)
            self.rest()

    def _drag(self, row: str, turn: int) -> None:
        polyline = self.services.state.annotation.get(ELEMENT)
        point = polyline.points[0]
        grip = self.window.canvas.to_view(point.u * 1919, point.v * 1079).toPoint()
        viewport = self.window.canvas.viewport()
        self._move(grip, Qt.MouseButton.NoButton)
        self.rest()
        QTest.mousePress(viewport, LEFT, NONE, grip)
        self.rest()
        for i in range(40):
            at = grip + QPoint(3 + (i + turn) % 40, (7 * i) % 30)
            self.watch.time(row, lambda at=at: self._move(at, LEFT))
        self.rest()
        release = "release of a drag, saved and shown"
        self.watch.time(release, lambda: QTest.mouseRelease(viewport, LEFT, NONE, at))
        self.rest()

    def _draw(self) -> None:
        services, watch, canvas = self.services, self.watch, self.window.canvas
        services.selection.set_mode("draw")
        name = next(
            e.name
            for e in services.state.field.elements
            if services.state.annotation.get(e.name) is None
        )
        ground = services.state.annotation.get(ELEMENT).points
        for turn in range(10):
            services.selection.select_class(name)
            self.rest()
            for i in range(5):
                at = ground[0].u * 1919 + 20 * i + turn, ground[0].v * 1079 + 15 * i
                px = canvas.to_view(*at).toPoint()
                self._move(px, Qt.MouseButton.NoButton)
                self.rest(0.02)
                click = partial(QTest.mouseClick, canvas.viewport(), LEFT, NONE, px)
                watch.time("click that snaps", click)
            row = "an element finished (Enter), shown"
            watch.time(row, partial(QTest.keyClick, canvas, Qt.Key.Key_Return))
            self.rest()
            services.editing.undo()
            self.rest()

    def _move(self, at: QPoint, held: Qt.MouseButton) -> None:
        # QTest.mouseMove sets the one cursor of the platform, which other windows may lie under.
        viewport = self.window.canvas.viewport()
        kind, over = QEvent.Type.MouseMove, QPointF(viewport.mapToGlobal(at))
        event = QMouseEvent(kind, QPointF(at), over, Qt.MouseButton.NoButton, held, NONE)
        QApplication.sendEvent(viewport, event)

    def walk(self, first: int) -> None:
        """Frame after frame; each prefetched, or each jumped to."""
        services, watch = self.services, self.watch
        services.selection.set_mode("draw")
        for index in range(first + 1, first + 41):
            path = services.state.workspace.frames[index].image_path
            watch.rest(lambda path=path: services.cache.peek(path) is not None)
            self.rest()
            watch.time("next frame, prefetched", lambda i=index: services.navigator.go_to(i))
        for index in itertools.islice(itertools.count(first + 60, 20), 20):
            self.rest()
            watch.time("next frame, decoded", lambda i=index: services.navigator.go_to(i))

    def memory(self) -> dict[str, float]:
        """After so many frames seen from here, one after the other as fast as they come."""
        services, found = self.services, {}
        for index in range(500):
            self._step(lambda i=index: services.navigator.go_to(i))
            if index + 1 in (75, 500):
                self.rest(0.3)
                found[str(index + 1)] = resident_mb()
        return found

    def _step(self, act: Callable[[], object]) -> None:
        begin = time.thread_time()  # a busy machine would count otherwise
        act()
        QApplication.processEvents()
        self.longest.append((time.thread_time() - begin) * 1e3)


def _moved(annotation: object, by: float) -> object:
    from dataclasses import replace

    polylines = annotation.polylines
    first = polylines[0]
    points = (first.points[0]._replace(u=first.points[0].u + by), *first.points[1:])
    return replace(annotation, polylines=(replace(first, points=points), *polylines[1:]))


if __name__ == "__main__":
    main()
