"""One camera source as a row of a list: which it is, whether it is drawn, how it does."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QAction,
    QColor,
    QIcon,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QPen,
    QPixmap,
    QResizeEvent,
)
from PySide6.QtWidgets import (
    QCheckBox,
    QColorDialog,
    QFrame,
    QGridLayout,
    QLabel,
    QLineEdit,
    QMenu,
    QRadioButton,
    QSizePolicy,
    QStackedLayout,
    QToolButton,
    QWidget,
)

from procc_annotator.dataset.computed_cameras import TRACK_NAME
from procc_annotator.gui.panels.parts import note_label, show_note
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.theme import blend, fixed_width
from procc_annotator.interaction.palette import SOURCE_COLOURS
from procc_annotator.translation import tr, word

_COLOUR_NAMES = (
    word("Yellow"),
    word("Violet"),
    word("Blue"),
    word("Mint"),
    word("Navy"),
    word("Cyan"),
)
_PATCH = 14


class SourceRow(QFrame):
    """Shows a source, and emits what the user wants of it."""

    activated = Signal()
    renamed = Signal(str)
    recoloured = Signal(str)
    shown = Signal(bool)  # drawn beside the active one, or not
    removed = Signal()

    def __init__(self, index: int, source: CameraSource, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(f"cameras_row_{index}")
        self._active = False
        self._fixed = source.files is None  # the fit keeps its name and colour
        self._colour = ""
        self.radio = ElidedRadio(source.name)
        self.radio.setObjectName(f"cameras_set_{index}")
        self.radio.installEventFilter(self)
        self.edit = QLineEdit()
        self.edit.setObjectName(f"cameras_name_{index}")
        self.edit.setAccessibleName(tr("Name of the source"))
        self.edit.installEventFilter(self)
        self.edit.editingFinished.connect(self._finish_name)
        self.colour = QToolButton(autoRaise=True)
        self.colour.setObjectName(f"cameras_colour_{index}")
        self.colour.setIconSize(QSize(_PATCH, _PATCH))
        self.colour.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.colour.setStyleSheet("QToolButton::menu-indicator { image: none; }")
        if not self._fixed:
            self.colour.setMenu(self._colour_menu())
        self.drawn = QCheckBox()
        self.drawn.setObjectName(f"cameras_drawn_{index}")
        self.drawn.setToolTip(tr("Draw as a wireframe while another source is judged"))
        self.drawn.clicked.connect(self.shown)
        self.jac = _detail(f"cameras_jac_{index}")
        self.jac.setFont(fixed_width(self.font()))
        self.model = ElidedDetail()
        self.model.setObjectName(f"cameras_model_{index}")
        self.matched = _detail(f"cameras_matched_{index}")
        self.remove = QToolButton(autoRaise=True)
        self.remove.setText("✕")
        self.remove.setObjectName(f"cameras_remove_{index}")
        self.remove.setToolTip(_what_remove_does(source))
        self.remove.clicked.connect(self.removed)
        self.problem = note_label(f"cameras_problem_{index}")
        self._arrange()
        self.radio.clicked.connect(self.activated)
        self.show_source(source)

    def _arrange(self) -> None:
        self._names = QStackedLayout()
        layout = QGridLayout(self)
        layout.setContentsMargins(2, 3, 2, 3)
        layout.setHorizontalSpacing(4)
        layout.setVerticalSpacing(1)
        middle = Qt.AlignmentFlag.AlignCenter
        layout.addWidget(self.colour, 0, 0, middle)
        layout.addLayout(self._names, 0, 1)
        self._names.addWidget(self.radio)  # the first one is shown: only now, as a part of this
        self._names.addWidget(self.edit)
        layout.addWidget(self.jac, 0, 2, Qt.AlignmentFlag.AlignRight)
        layout.addWidget(self.remove, 0, 3)
        layout.addWidget(self.drawn, 1, 0, middle)
        layout.addWidget(self.model, 1, 1)
        layout.addWidget(self.matched, 1, 2, 1, 2, Qt.AlignmentFlag.AlignRight)
        layout.addWidget(self.problem, 2, 1, 1, 3)
        layout.setColumnStretch(1, 1)

    # --- showing -------------------------------------------------------------------------------

    def show_source(self, source: CameraSource) -> None:
        """Name, colour and whether it is drawn."""
        self.radio.set_full_text(source.name)
        lines = [tr("Judge against {name}", name=source.name), tr(source.camera_set.origin)]
        if not self._fixed:
            lines.append(tr("Double-click or F2 gives it another name"))
        self.radio.setToolTip("\n".join(lines))
        self.remove.setAccessibleName(tr("Remove {name}", name=source.name))
        self.drawn.setChecked(source.visible)
        self.drawn.setAccessibleName(tr("Draw {name}", name=source.name))
        if source.colour != self._colour:
            self._colour = source.colour
            self.colour.setIcon(colour_icon(source.colour, self.devicePixelRatioF()))
            words = tr("Colour of {name}", name=source.name)
            self.colour.setToolTip(words)
            self.colour.setAccessibleName(words)

    def show_state(
        self, *, active: bool, jac: str, jac_tip: str, model: str, matched: str, matched_tip: str,
        problem: str,
    ) -> None:  # fmt: skip
        """How the source does, in words."""
        if active != self._active:
            self._active = active
            self.update()
        if active != self.radio.isChecked():
            self.radio.setChecked(active)
        for label, text in ((self.jac, jac), (self.matched, matched)):
            if label.text() != text:
                label.setText(text)
        self.jac.setToolTip(jac_tip)
        self.matched.setToolTip(matched_tip)
        self.model.set_full_text(model)
        show_note(self.problem, f"⚠ {problem}" if problem else "")

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._active:
            colours = self.palette()
            ground = colours.color(QPalette.ColorRole.Window)
            tone = blend(ground, colours.color(QPalette.ColorRole.Highlight), 0.16)
            painter = QPainter(self)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(tone)
            painter.drawRoundedRect(QRectF(self.rect()), 4, 4)
            painter.end()
        super().paintEvent(event)

    # --- hands ---------------------------------------------------------------------------------

    def begin_rename(self) -> None:
        """Let the name be typed, where it is the user's to give."""
        if self._fixed:
            return
        self.edit.setText(self.radio.full_text)
        self._names.setCurrentWidget(self.edit)
        self.edit.selectAll()
        self.edit.setFocus()

    def _finish_name(self) -> None:
        if self._names.currentWidget() is self.edit:
            self._names.setCurrentWidget(self.radio)
            self.renamed.emit(self.edit.text())

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            event.accept()
            self.activated.emit()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            event.accept()
            self.begin_rename()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self.radio:
            twice = event.type() == QEvent.Type.MouseButtonDblClick
            key = event.key() if isinstance(event, QKeyEvent) else None
            pressed = event.type() == QEvent.Type.KeyPress and key == Qt.Key.Key_F2
            if twice or pressed:
                self.begin_rename()
                return True
        elif isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape:
            if event.type() == QEvent.Type.ShortcutOverride:
                event.accept()  # not the window's Esc
                return True
            if event.type() == QEvent.Type.KeyPress:
                self._names.setCurrentWidget(self.radio)
                self.radio.setFocus()
                return True
        return False

    def _colour_menu(self) -> QMenu:
        menu = QMenu(self)
        for name, colour in zip(_COLOUR_NAMES, SOURCE_COLOURS, strict=True):
            action = QAction(colour_icon(colour, self.devicePixelRatioF()), tr(name), menu)
            action.triggered.connect(lambda _=False, chosen=colour: self.recoloured.emit(chosen))
            menu.addAction(action)
        other = QAction(tr("Other…"), menu)
        other.triggered.connect(self._ask_colour)
        menu.addAction(other)
        return menu

    def _ask_colour(self) -> None:
        chosen = QColorDialog.getColor(QColor(self._colour), self, tr("Colour of the source"))
        if chosen.isValid():
            self.recoloured.emit(chosen.name())


class ElidedRadio(QRadioButton):
    """A radio button whose text gives way in a narrow panel; the tooltip has it in full."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.full_text = ""
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.set_full_text(text)

    def set_full_text(self, text: str) -> None:
        """Show another text, as much of it as there is room for."""
        if text != self.full_text:
            self.full_text = text
            self.setAccessibleName(text)
            self._elide(self.width())

    def _elide(self, width: int) -> None:
        room = width - self.iconSize().width() - 12
        elided = self.fontMetrics().elidedText(self.full_text, Qt.TextElideMode.ElideMiddle, room)
        self.setText(elided.replace("&", "&&"))

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._elide(event.size().width())
        super().resizeEvent(event)


class ElidedDetail(QLabel):
    """A small text that gives way in a narrow panel; the tooltip has it in full."""

    def __init__(self) -> None:
        super().__init__()
        self._full = ""
        self.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.setTextFormat(Qt.TextFormat.PlainText)

    def set_full_text(self, text: str) -> None:
        """Show another text, as much of it as there is room for."""
        if text != self._full:
            self._full = text
            self.setToolTip(text)
            self._elide(self.width())

    def _elide(self, width: int) -> None:
        mode = Qt.TextElideMode.ElideRight
        self.setText(self.fontMetrics().elidedText(self._full, mode, width))

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._elide(event.size().width())
        super().resizeEvent(event)


def colour_icon(colour: str, ratio: float) -> QIcon:
    """A patch of a colour with a rim that shows on light and on dark ground."""
    pixmap = QPixmap(round(_PATCH * ratio), round(_PATCH * ratio))
    pixmap.setDevicePixelRatio(ratio)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor("#707070"), 1))
    painter.setBrush(QColor(colour))
    corner = QPointF(1.5, 1.5)
    painter.drawRoundedRect(QRectF(corner.x(), corner.y(), _PATCH - 3, _PATCH - 3), 2.5, 2.5)
    painter.end()
    return QIcon(pixmap)


def _detail(name: str) -> QLabel:
    label = QLabel()
    label.setObjectName(name)
    label.setTextFormat(Qt.TextFormat.PlainText)
    return label


def _what_remove_does(source: CameraSource) -> str:
    if source.files is not None:
        return tr("Remove from the list; the files stay")
    if source.name == TRACK_NAME:
        return tr("Forget what was followed (T follows the shot again)")
    return tr("Switch the live fit off (Ctrl+T switches it on again)")
