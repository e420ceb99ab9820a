"""The parts of the window, for a keyboard that goes round them: bars, panels, the picture."""

from __future__ import annotations

from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication, QDockWidget, QMainWindow, QToolBar, QToolButton, QWidget

_BY_TAB = Qt.FocusPolicy.TabFocus


class Regions:
    """Takes the keyboard from one part of a window to the next, left to right, top to bottom."""

    def __init__(self, window: QMainWindow) -> None:
        self._window = window

    def go(self, step: int) -> None:
        """On to the next part (1) or back to the one before (-1)."""
        regions = self.all()
        if not regions:
            return
        focus = QApplication.focusWidget()
        here = next((i for i, r in enumerate(regions) if _holds(r, focus)), None)
        begin = (-1 if step > 0 else 0) if here is None else here
        for turn in range(1, len(regions) + 1):
            region = regions[(begin + step * turn) % len(regions)]
            target = _target(region)
            if target is not None:
                region.window().activateWindow()
                target.setFocus(Qt.FocusReason.TabFocusReason)
                return

    def all(self) -> list[QWidget]:
        """The parts in sight, in the order in which they are gone to."""
        window = self._window
        bars = [bar for bar in window.findChildren(QToolBar) if bar.isVisible()]
        for bar in bars:
            _reach(bar)
        docks = [d for d in window.findChildren(QDockWidget) if not d.visibleRegion().isEmpty()]
        return sorted([*bars, *docks, *self._middle()], key=_place)

    def _middle(self) -> list[QWidget]:
        """The picture, the strip below it, and whatever else is one above the other there."""
        centre = self._window.centralWidget()
        if centre is None:
            return []
        direct = Qt.FindChildOption.FindDirectChildrenOnly
        parts = [w for w in centre.findChildren(QWidget, options=direct) if w.isVisible()]
        return [part for part in parts if _target(part) is not None]


def _reach(bar: QToolBar) -> None:
    """Qt leaves the buttons of a tool bar to the mouse."""
    for button in bar.findChildren(QToolButton):
        if button.focusPolicy() == Qt.FocusPolicy.NoFocus and button.defaultAction() is not None:
            button.setFocusPolicy(_BY_TAB)


def _place(part: QWidget) -> tuple[int, int]:
    at = part.mapToGlobal(QPoint(0, 0))
    return at.x(), at.y()


def _holds(region: QWidget, focus: QWidget | None) -> bool:
    return focus is not None and (focus is region or region.isAncestorOf(focus))


def _target(region: QWidget) -> QWidget | None:
    """Return what had the keyboard there last, or else what is first."""
    if _takes(region):
        return region
    last = region.focusWidget()
    if last is not None and _takes(last):
        return last
    taking = [widget for widget in region.findChildren(QWidget) if _takes(widget)]
    return min(taking, key=lambda w: w.mapTo(region, QPoint(0, 0)).toTuple()[::-1], default=None)


def _takes(widget: QWidget) -> bool:
    reachable = bool(widget.focusPolicy() & _BY_TAB)
    return reachable and widget.isVisible() and widget.isEnabled()
