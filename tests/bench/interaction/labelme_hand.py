"""One run of a hand on labelme's window, in an interpreter that has labelme: prints what it waited
for.

Arguments: as for `our_hand`, without cameras.
"""

import itertools
import sys
import time
from pathlib import Path

from labelme.app import MainWindow
from PyQt5 import QtCore, QtWidgets
from PyQt5.QtCore import QPointF, Qt
from PyQt5.QtGui import QMouseEvent
from stopwatch import Stopwatch, resident_mb


class Window(MainWindow):
    """labelme's, which says when it has been painted."""

    watch: Stopwatch

    def event(self, event):
        answered = super().event(event)
        if event.type() == QtCore.QEvent.UpdateRequest:
            self.watch.painted()
        return answered


class Hand:
    """Does what is measured."""

    def __init__(self, window, watch):
        self.window, self.watch = window, watch
        self.canvas = window._canvas_widgets.canvas

    def go_to(self, index):
        self.window._docks.file_list.setCurrentRow(index)

    def send(self, kind, x, y, button, held):
        origin = self.canvas._compute_image_origin_offset()
        at = (QPointF(x, y) + origin) * self.canvas.scale
        event = QMouseEvent(
            kind, at, self.canvas.mapToGlobal(at.toPoint()), button, held, Qt.NoModifier
        )
        QtWidgets.QApplication.sendEvent(self.canvas, event)

    def move(self, x, y, held=Qt.NoButton):
        self.send(QtCore.QEvent.MouseMove, x, y, Qt.NoButton, held)

    def press(self, x, y):
        self.send(QtCore.QEvent.MouseButtonPress, x, y, Qt.LeftButton, Qt.LeftButton)

    def release(self, x, y):
        self.send(QtCore.QEvent.MouseButtonRelease, x, y, Qt.LeftButton, Qt.NoButton)

    def _let_go(self, x, y):
        self.release(x, y)
        self.canvas.update()

    def edit(self, first):
        window, watch, canvas = self.window, self.watch, self.canvas
        self.go_to(first)
        watch.rest(least_s=0.5)
        window._switch_canvas_mode(edit=True)
        for turn in range(6):
            point = next(s for s in canvas.shapes if s.label == "Big rect. left main").points[0]
            x, y = point.x(), point.y()
            self.move(x, y)
            watch.rest(least_s=0.06)
            self.press(x, y)
            watch.rest(least_s=0.06)
            for i in range(40):
                to = x + 3 + (i + turn) % 40, y + (7 * i) % 30
                watch.time("drag, per move, neither", lambda to=to: self.move(*to, Qt.LeftButton))
            watch.rest(least_s=0.06)
            watch.time("release of a drag, saved and shown", lambda to=to: self._let_go(*to))
        watch.rest(least_s=0.06)
        while canvas.can_restore_shape:
            watch.time("undo", window.undo_shape_edit)
            watch.rest(least_s=0.06)
        for _ in range(20):
            path = str(Path(window._image_path).with_suffix(".json"))
            watch.time("save", lambda path=path: window.save_labels(path), paints=False)
            watch.rest(least_s=0.06)
        window._switch_canvas_mode(edit=False, create_mode="linestrip")
        self.move(800, 500)
        for i in range(20):
            at = 800 + 10 * i, 500 + 4 * i
            self.move(*at)
            watch.rest(least_s=0.02)
            watch.time("click that snaps", lambda at=at: self.press(*at), paints=False)
            self.release(*at)
        canvas.set_editing(True)
        window.mark_clean()

    def walk(self, first):
        for _ in range(40):
            self.watch.rest(least_s=0.06)
            self.watch.time("next frame, prefetched", self.window._open_next_image)
        for index in itertools.islice(itertools.count(first + 60, 20), 20):
            self.watch.rest(least_s=0.06)
            self.watch.time("next frame, decoded", lambda i=index: self.go_to(i))

    def memory(self):
        found = {}
        for index in range(500):
            self.go_to(index)
            QtWidgets.QApplication.processEvents()
            if index + 1 in (75, 500):
                self.watch.rest(least_s=0.3)
                found[str(index + 1)] = resident_mb()
        return found


def main():
    dataset, _, first, begun = sys.argv[1:5]
    app = QtWidgets.QApplication(sys.argv[:1])
    app.setStyle("Fusion")
    watch = Stopwatch(app.processEvents)
    Window.watch = watch
    window = Window(config_overrides={}, file_or_dir=dataset)
    window.resize(1920, 1080)
    watch.time("painting alone", window.show)
    start = time.monotonic() - float(begun)
    hand = Hand(window, watch)
    watch.rest(least_s=0.5)
    hand.edit(int(first))
    hand.walk(int(first))
    watch.tell(start=start, memory=hand.memory())
    window.close()


if __name__ == "__main__":
    main()
