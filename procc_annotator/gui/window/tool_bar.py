"""The tool bar at the left edge: pointer tools and aids as icons with their keys."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QRectF, QSize, Qt
from PySide6.QtGui import (
    QAction,
    QActionEvent,
    QColor,
    QFont,
    QFontMetrics,
    QKeySequence,
    QPainter,
    QPaintEvent,
    QResizeEvent,
)
from PySide6.QtWidgets import (
    QMenu,
    QSizePolicy,
    QStyle,
    QStyleOptionToolButton,
    QToolBar,
    QToolButton,
    QWidgetAction,
)

from procc_annotator.gui.keymap import NATIVE, short_text
from procc_annotator.gui.panels.widgets import named
from procc_annotator.gui.state.background import after_paint
from procc_annotator.gui.theme import blend, paint_icon
from procc_annotator.gui.window.display_adjustment import AdjustmentControls
from procc_annotator.gui.window.menus import Actions
from procc_annotator.translation import tr

_ICON = 1.45  # heights of a line of text
_PAD = 5
_KEY_FONT = 0.72
_USUAL_KEY = "Ctrl+Z"  # not shown
_RADIUS = 4.0


class IconButton(QToolButton):
    """An icon, and below it a key, in the colours of the theme.

    It is filled while it is on, with a bar at its left edge: colour is not the only sign.
    """

    def __init__(self, icon: str, *, with_key: bool = False) -> None:
        super().__init__()
        self._icon, self._with_key, self._key = icon, with_key, ""
        self._hint: QSize | None = None  # asked for hundreds of times whenever a window is laid out
        self._called_by: list[QKeySequence] = []
        self._soon = after_paint(self, self._take_words)
        self.setAutoRaise(True)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)

    def show_action(self, action: QAction, key_of: QAction | None = None, key: str = "") -> None:
        """Do what an action does, and show its name.

        Args:
            key_of: has the key that is shown if the action has no key.
            key: what is held for the same effect, where there is no such action either.
        """
        self.setDefaultAction(action)
        self._of = (action, key_of or action)
        self._held = key
        for one in {action, key_of or action}:
            one.changed.connect(self._take_keys)
        self._take_words()
        self._take_keys()

    def key_text(self) -> str:
        """The key that is shown; "" if absent."""
        return self._key

    def set_with_key(self, with_key: bool) -> None:
        """Show or hide the key; without it the button is less high."""
        if with_key != self._with_key:
            self._with_key, self._hint = with_key, None
            self.updateGeometry()
            self.update()

    def height_with_key(self) -> int:
        """Return how high it is with its key."""
        return self._icon_side() + QFontMetrics(self._key_font()).height() + _PAD + 2

    def sizeHint(self) -> QSize:
        if self._hint is None:
            self._hint = self._size()
        return self._hint

    def minimumSizeHint(self) -> QSize:
        return self.sizeHint()

    def actionEvent(self, event: QActionEvent) -> None:
        """Words of the action are in the tip; nothing is laid out or painted anew for them."""
        action = event.action()
        changed = event.type() == QEvent.Type.ActionChanged
        states = action.isChecked(), action.isEnabled(), action.isVisible()
        if not changed or states != (self.isChecked(), self.isEnabled(), not self.isHidden()):
            super().actionEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() in (QEvent.Type.FontChange, QEvent.Type.StyleChange):
            self._hint = None
        super().changeEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        area = QRectF(self.rect()).adjusted(1, 1, -1, -1)
        ink = self._paint_ground(painter, area)
        side = self._icon_side()
        top = (self.height() - side) / 2
        if self._with_key:
            font = self._key_font()
            height = QFontMetrics(font).height()
            top = (self.height() - side - height) / 2
            painter.setFont(font)
            painter.setPen(ink)
            line = QRectF(0, top + side, self.width(), height)
            painter.drawText(line, Qt.AlignmentFlag.AlignCenter, self._key)
        paint_icon(painter, self._icon, QRectF((self.width() - side) / 2, top, side, side), ink)
        if self.hasFocus():
            painter.setPen(ink)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(area.adjusted(1.5, 1.5, -1.5, -1.5), _RADIUS, _RADIUS)

    # --- inside ---

    def _size(self) -> QSize:
        side = self._icon_side() + 2 * _PAD
        if not self._with_key:
            return QSize(side, side - _PAD)
        metrics = QFontMetrics(self._key_font())
        usual = metrics.horizontalAdvance(_USUAL_KEY) + 6
        width = max(side, usual, metrics.horizontalAdvance(self._key) + 2)
        return QSize(width, self.height_with_key())

    def _take_keys(self) -> None:
        """Other keys, perhaps; with every edit it is only another step that is undone."""
        action, other = self._of
        called_by = action.shortcuts() or other.shortcuts()
        self._soon.start()
        if called_by != self._called_by:
            self._called_by = called_by
            keys = [short_text(keys.toString(NATIVE)) for keys in called_by]
            self._key, self._hint = min(keys, key=len, default=self._held), None
            self.updateGeometry()
            self.update()

    def _take_words(self) -> None:
        """Update name and tip, after the canvas was painted."""
        action, _ = self._of
        words = action.text().replace("&&", "&")
        self.setAccessibleName(words)
        self.setToolTip(f"{words}\n{action.toolTip()}")

    def _paint_ground(self, painter: QPainter, area: QRectF) -> QColor:
        """Paint what is below the icon; the colour of the icon."""
        option = QStyleOptionToolButton()
        self.initStyleOption(option)
        colours, state = self.palette(), option.state
        ink = colours.color(colours.ColorRole.ButtonText)
        ground = colours.color(colours.ColorRole.Window)
        if self.isChecked():
            fill = colours.color(colours.ColorRole.Highlight)
            ink = colours.color(colours.ColorRole.HighlightedText)
        elif state & (QStyle.StateFlag.State_MouseOver | QStyle.StateFlag.State_Sunken):
            fill = blend(ground, ink, 0.22 if self.isDown() else 0.10)
        else:
            return ink
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(fill)
        painter.drawRoundedRect(area, _RADIUS, _RADIUS)
        if self.isChecked():
            painter.setBrush(ink)
            bar = QRectF(area.left() + 1.5, area.top() + 5, 2.5, area.height() - 10)
            painter.drawRoundedRect(bar, 1.2, 1.2)
        return ink

    def _icon_side(self) -> int:
        return round(self.fontMetrics().height() * _ICON)

    def _key_font(self) -> QFont:
        font = QFont(self.font())
        font.setPointSizeF(font.pointSizeF() * _KEY_FONT)
        return font


# Icon, action, and the action with the key that is shown where that has none; None: a new group.
_BUTTONS: tuple[tuple[str, str, str] | None, ...] = (
    ("undo", "undo", ""),
    ("redo", "redo", ""),
    None,
    ("draw", "draw_mode", "switch_mode"),
    ("edit", "edit_mode", "switch_mode"),
    ("pan", "pan", ""),
    None,
    ("snap", "snapping", ""),
    ("two_clicks", "two_clicks", ""),
    ("loupe", "loupe", ""),
    ("ghosts", "ghosts", ""),
    ("blind", "blind", ""),
)
_BETWEEN, _REST = 2, 50  # px: between two buttons; lines between groups, and the rims
_HELD = {"pan": "Space"}  # not shown


class SideToolBar(QToolBar):
    """Buttons of the table of actions, one below the other, and of how the picture looks."""

    def __init__(self, actions: Actions) -> None:
        super().__init__(tr("Rail"))
        self.setObjectName("rail")
        self.setMovable(False)
        self.setFloatable(False)
        self.toggleViewAction().setEnabled(False)  # it stays in sight
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
        self.setOrientation(Qt.Orientation.Vertical)
        self.buttons: dict[str, IconButton] = {}
        for row in _BUTTONS:
            if row is None:
                self.addSeparator()
                continue
            icon, name, key_of = row
            button = named(IconButton(icon, with_key=True), f"rail_{name}")
            other = actions[key_of] if key_of else None
            held = QKeySequence(_HELD.get(name, "")).toString(NATIVE)
            button.show_action(actions[name], other, held)
            self.buttons[name] = button
            self.addWidget(button)
        self.addSeparator()
        self._add_looks()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Hide the keys if there is no room for all buttons with them."""
        super().resizeEvent(event)
        buttons = self.findChildren(IconButton)
        needed = sum(button.height_with_key() + _BETWEEN for button in buttons) + _REST
        for button in buttons:
            button.set_with_key(needed <= self.height())

    def _add_looks(self) -> None:
        """A button that opens brightness and the like."""
        self.looks = AdjustmentControls()
        menu = QMenu(self)
        action = QWidgetAction(menu)
        action.setDefaultWidget(self.looks)
        menu.addAction(action)
        tip = tr("Picture\nBrightness, contrast, gamma, line enhance: only what you see changes")
        button = IconButton("looks", with_key=True)
        named(button, "lookButton", tip=tip, title=tr("Picture"))
        button.setMenu(menu)
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.addWidget(button)
