"""What the panels share: updates that wait for their turn, empty states, muted colours."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import shiboken6
from PySide6.QtCore import QEvent, QObject, QPoint, QRect, QSize, Qt, QTimer, SignalInstance, Slot
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import (
    QFrame,
    QGraphicsView,
    QLabel,
    QScrollArea,
    QSizePolicy,
    QTableView,
    QWidget,
)

from procc_annotator.gui.state.state import State
from procc_annotator.gui.state.store import Store

NARROW = 380  # below this width tables leave out words that a symbol says as well


# What a search box takes for itself although the window has a shortcut for it.
SEARCH_KEYS = frozenset(
    {Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Escape, Qt.Key.Key_Up, Qt.Key.Key_Down}
)
# Property of a line of text that leaves Escape to the window: back to what it was, then away.
LEFT_BY_ESCAPE = "left_by_escape"


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
        store.watch(select, self._take)
        for signal in signals:
            signal.connect(self.request)

    def _take(self, _: object) -> None:
        self.request()

    @Slot()
    def request(self) -> None:
        """What is shown is another thing: show it at the next opportunity."""
        self._stale = True
        if self._in_sight() and not self._resting.isActive():
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
        """Whether any of it is seen: Qt calls docks behind other tabs visible, too, and keeps them
        outside the window."""
        widget = self._widget
        if not widget.isVisible():
            return False
        window = widget.window()
        return window.rect().intersects(QRect(widget.mapTo(window, QPoint()), widget.size()))


def judged(state: State) -> tuple[object, ...]:
    """What the verdicts on the frame on screen follow from."""
    frame = state.workspace, state.frame_index, state.shown_annotation, state.why_not_judged
    terms = state.setup, state.tau, state.projection_visible
    return frame, terms, state.active, state.cameras_of(state.active)


def empty_state(text: str, name: str) -> QLabel:
    """A label that explains why a panel has nothing to show, and what to do about it."""
    label = QLabel(text)
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setAlignment(Qt.AlignmentFlag.AlignCenter)
    label.setForegroundRole(QPalette.ColorRole.PlaceholderText)
    label.setMargin(12)
    label.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Expanding)
    return label


def note_label(name: str) -> QLabel:
    """A wrapping label for one line of explanation; hidden until `show_note` gives it text."""
    label = QLabel()
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    label.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Minimum)
    label.hide()
    return label


def show_note(label: QLabel, text: str) -> None:
    """Put text on a note; without text the note takes no room."""
    if label.text() != text:
        label.setText(text)
    label.setVisible(bool(text))


class ScrolledContent(QWidget):
    """A panel's content to be put into `scrolling`: as high as its texts need at their width. Qt
    would reserve what they need at their narrowest."""

    def minimumSizeHint(self) -> QSize:
        least = super().minimumSizeHint()
        layout = self.layout()
        # Without a text that wraps nobody asks for the height at a width: this is all there is.
        wraps = layout is not None and layout.hasHeightForWidth()
        return QSize(least.width(), 0) if wraps else least


def scrolling(content: ScrolledContent) -> QScrollArea:
    """A panel's content with a scroll bar where it has no room.

    It asks for no room of its own, so a text that changes in it moves nothing outside: docks that
    share a column with others are laid out anew whenever one of them wants another size.
    """
    area = QScrollArea()
    area.setFrameShape(QFrame.Shape.NoFrame)
    area.setWidgetResizable(True)
    area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    area.setWidget(content)
    return area


class LowTable(QTableView):
    """A table that asks for its least height, and takes what else there is: Qt's asks for 192."""

    def sizeHint(self) -> QSize:
        return QSize(super().sizeHint().width(), self.minimumSizeHint().height())

    def minimumSizeHint(self) -> QSize:
        return QSize(super().minimumSizeHint().width(), 4 * (self.fontMetrics().height() + 6))


def blend(a: QColor, b: QColor, share: float) -> QColor:
    """A colour between two: share 0 gives the first, 1 the second."""
    return QColor.fromRgbF(
        a.redF() + (b.redF() - a.redF()) * share,
        a.greenF() + (b.greenF() - a.greenF()) * share,
        a.blueF() + (b.blueF() - a.blueF()) * share,
    )


def muted(palette: QPalette, share: float = 0.35) -> QColor:
    """Text that steps back, readable on light and on dark windows."""
    return blend(
        palette.color(QPalette.ColorRole.Text), palette.color(QPalette.ColorRole.Base), share
    )


def follow_theme(view: QGraphicsView) -> None:
    """Have a plot's ground painted in the theme of the moment; pyqtgraph's views keep the first."""
    view.setCacheMode(QGraphicsView.CacheModeFlag.CacheNone)
