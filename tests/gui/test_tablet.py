"""A tablet's pen does what the mouse does: nothing of the window takes its events for itself."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QPointF, Qt
from PySide6.QtGui import QInputDevice, QPointingDevice, QPointingDeviceUniqueId, QTabletEvent
from PySide6.QtWidgets import QWidget

from procc_annotator.gui.main_window import MainWindow

pytestmark = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)


def pen_event(widget: QWidget, kind: QEvent.Type, at: QPointF, pressed: bool) -> QTabletEvent:
    pen = QPointingDevice(
        "pen",
        7,
        QInputDevice.DeviceType.Stylus,
        QPointingDevice.PointerType.Pen,
        QInputDevice.Capability.Position | QInputDevice.Capability.Pressure,
        1,
        1,
        "",
        QPointingDeviceUniqueId(),
    )
    button = Qt.MouseButton.LeftButton if pressed else Qt.MouseButton.NoButton
    return QTabletEvent(
        kind, pen, at, QPointF(widget.mapToGlobal(at.toPoint())), 0.6, 0.0, 0.0, 0.0, 0.0, 0.0,
        Qt.KeyboardModifier.NoModifier, Qt.MouseButton.LeftButton, button,
    )  # fmt: skip


@pytest.mark.parametrize(
    "kind",
    [QEvent.Type.TabletPress, QEvent.Type.TabletMove, QEvent.Type.TabletRelease],
)
def test_a_pen_is_left_to_qt_which_makes_a_mouse_of_it(
    window: MainWindow, kind: QEvent.Type
) -> None:
    """Qt sends a mouse event in the place of one that nobody accepted."""
    assert QCoreApplication.testAttribute(
        Qt.ApplicationAttribute.AA_SynthesizeMouseForUnhandledTabletEvents
    )
    for widget in (window.canvas.viewport(), window.field_map, window.filmstrip.viewport()):
        event = pen_event(widget, kind, QPointF(20, 20), kind == QEvent.Type.TabletPress)
        widget.event(event)
        assert not event.isAccepted()
