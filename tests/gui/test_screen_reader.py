"""What a screen reader is told: whatever takes the keyboard has a name and a role."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractScrollArea,
    QScrollArea,
    QScrollBar,
    QTabWidget,
    QToolBar,
    QToolButton,
    QWidget,
)

from procc_annotator.gui.canvas.viewport_overlays import DividerGrip
from procc_annotator.gui.window.workspaces import WORKSPACES

_NONE = (QAccessible.Role.NoRole, QAccessible.Role.Client, QAccessible.Role.Border)
# What only holds others has no role of its own.
_HOLDING = (QScrollArea, QTabWidget)


def taking_keys(window: QWidget) -> list[QWidget]:
    """All that the keyboard can reach, in sight or behind tabs; what Qt puts within it is not."""
    found = []
    for widget in window.findChildren(QWidget):
        reached = widget.focusPolicy() & Qt.FocusPolicy.TabFocus
        of_a_bar = isinstance(widget, QToolButton) and isinstance(widget.parent(), QToolBar)
        within = widget.objectName().startswith("qt_") or isinstance(widget, QScrollBar)
        leads_on = widget.focusProxy() is not None or widget.window() is not window.window()
        viewport = isinstance(widget.parent(), QAbstractScrollArea)
        empty = isinstance(widget, QAbstractButton) and widget.isHidden()  # it says nothing yet
        if (reached or of_a_bar) and not (within or leads_on or viewport or empty):
            found.append(widget)
    return found


def unnamed(window: QWidget) -> dict[str, str]:
    """What has no name or no role of use, by its class and object name."""
    found = {}
    for widget in taking_keys(window):
        told = QAccessible.queryAccessibleInterface(widget)
        name = told.text(QAccessible.Text.Name)
        silent = isinstance(widget, _HOLDING) or widget.isHidden()  # told once it is shown
        if not name.strip() or (told.role() in _NONE and not silent):
            ours = (
                f"{type(widget).__name__} {widget.objectName()} in {type(widget.parent()).__name__}"
            )
            found[ours] = f"{name!r} {told.role().name}"
    return found


def test_everything_that_takes_the_keyboard_says_what_it_is(audited, qtbot):
    for desk in WORKSPACES:
        audited.panels.turn_to(desk)
        for name in WORKSPACES[desk]:
            audited.panels.show(name)
    assert len(taking_keys(audited)) > 60
    assert unnamed(audited) == {}


def test_what_paints_itself_says_what_it_is(window, qtbot):
    grip = window.findChild(DividerGrip)
    for hidden in (window.strip, grip):
        hidden.show()
    roles = {
        window.canvas: QAccessible.Role.Canvas,
        window.field_map: QAccessible.Role.Canvas,
        window.strip: QAccessible.Role.Slider,
        grip: QAccessible.Role.Grip,
    }
    for widget, role in roles.items():
        told = QAccessible.queryAccessibleInterface(widget)
        assert told.role() == role
        assert told.text(QAccessible.Text.Name) == widget.accessibleName() != ""
    window.services.selection.select_class("Middle line")
    told = QAccessible.queryAccessibleInterface(window.canvas)
    qtbot.waitUntil(lambda: "Halfway line" in told.text(QAccessible.Text.Description))
    assert told.text(QAccessible.Text.Description) == window.canvas.hint
    for shown in (window.strip, grip):
        shown.hide()


@pytest.mark.parametrize("action", ["settings", "keys"])
def test_so_does_everything_of_a_dialog(window, action):
    window.actions_[action].trigger()
    dialog = next(
        w for w in window.children() if isinstance(w, QWidget) and w.isWindow() and w.isVisible()
    )
    assert unnamed(dialog) == {}
    assert dialog.windowTitle()
    dialog.close()


def test_the_picture_says_what_comes_next(window, qtbot):
    window.services.selection.select_class("Middle line")
    told = QAccessible.queryAccessibleInterface(window.canvas)
    assert told.text(QAccessible.Text.Name) == "Picture"
    qtbot.waitUntil(lambda: "DRAW Halfway line" in told.text(QAccessible.Text.Description))
