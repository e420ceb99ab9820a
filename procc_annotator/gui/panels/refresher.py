"""Updates of panels that wait for their turn, and what they follow."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import shiboken6
from PySide6.QtCore import QEvent, QObject, QPoint, QRect, QTimer, SignalInstance, Slot
from PySide6.QtWidgets import QWidget

from procc_annotator.gui.state.state import State
from procc_annotator.gui.state.store import Store


class _Turn(QObject):
    """Runs what waits in one turn of the event loop, so that the window is painted once for all."""

    def __init__(self) -> None:
        super().__init__()
        self._waiting: dict[Refresher, None] = {}
        self._timer = QTimer(self, singleShot=True)
        self._timer.timeout.connect(self._run)

    def add(self, refresher: Refresher) -> None:
        self._waiting[refresher] = None
        self._timer.start(0)

    @Slot()
    def _run(self) -> None:
        waiting, self._waiting = self._waiting, {}
        for refresher in waiting:
            if shiboken6.isValid(refresher):
                refresher.run()


@lru_cache(maxsize=1)
def _turn() -> _Turn:
    return _Turn()


class Refresher(QObject):
    """Runs a panel's update soon and once, however often it is asked for.

    All panels that wait are updated in one turn, in the order they asked. While nothing of the
    panel is seen nothing runs; it catches up when it is shown, or its tab is brought to the front.
    During a drag the updates are at least ``interval_ms`` apart, so that a slow panel does not slow
    the pointer.
    """

    def __init__(self, widget: QWidget, update: Callable[[], None], interval_ms: int = 0) -> None:
        super().__init__(widget)
        self._widget = widget
        self._update = update
        self._interval_ms = interval_ms
        self._stale = True
        self._resting = QTimer(self, singleShot=True)
        self._resting.timeout.connect(self.run)
        widget.installEventFilter(self)

    def follow(
        self, store: Store, select: Callable[[State], object], *signals: SignalInstance
    ) -> None:
        """Update whenever what is shown is another thing.

        Args:
            store, select: what is shown of the state, as in `Store.watch`.
            signals: of what is shown and the state does not hold.
        """
        store.watch(select, self.request)
        for signal in signals:
            signal.connect(self.request)

    @Slot()
    def request(self) -> None:
        """What is shown is another thing: show it at the next opportunity."""
        self._stale = True
        if not self._resting.isActive():
            _turn().add(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()  # first: other events come while the panel is being destroyed
        if kind == QEvent.Type.Show and self._stale:
            self.catch_up()
        elif kind in (QEvent.Type.Paint, QEvent.Type.Resize) and self._stale:
            self.request()
        return False

    def catch_up(self) -> None:
        """The panel is about to be seen: update before it is painted, if anything changed."""
        if self._stale and self._widget.isVisible():
            self._run()

    @Slot()
    def run(self) -> None:
        """Update now, if anything changed and the panel can be seen."""
        if self._stale and self._in_sight():
            self._run()

    def _run(self) -> None:
        self._stale = False
        self._update()
        if self._interval_ms:
            self._resting.start(self._interval_ms)

    def _in_sight(self) -> bool:
        """Return whether any of it is seen: Qt calls docks behind other tabs visible, too, and
        keeps them outside the window."""
        widget = self._widget
        if not widget.isVisible():
            return False
        window = widget.window()
        return window.rect().intersects(QRect(widget.mapTo(window, QPoint()), widget.size()))


def judged(state: State) -> tuple[object, ...]:
    """Return what the verdicts on the frame on screen follow from."""
    frame = state.workspace, state.frame_index, state.shown_annotation, state.why_not_judged
    terms = state.setup, state.tau, state.projection_visible
    return frame, terms, state.active, state.cameras_of(state.active)
