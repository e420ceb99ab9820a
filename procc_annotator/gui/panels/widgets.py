"""Small widgets of panels and dialogs: number boxes, empty states, notes, scrolled content."""

from __future__ import annotations

from PySide6.QtCore import QLocale, QSize, Qt, Signal
from PySide6.QtGui import QAction, QPalette, QValidator
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QFrame,
    QLabel,
    QScrollArea,
    QSizePolicy,
    QToolTip,
    QWidget,
)

from procc_annotator.translation import tr

NARROW = 380  # below this width tables leave out words that a symbol says as well

# What a search box takes for itself although the window has a shortcut for it.
SEARCH_KEYS = frozenset(
    {Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Escape, Qt.Key.Key_Up, Qt.Key.Key_Down}
)
# Property of a line of text that leaves Escape to the window: back to what it was, then away.
LEFT_BY_ESCAPE = "left_by_escape"


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


def choice(name: str, title: str = "") -> QComboBox:
    """A list to choose from, as narrow as its panel; ``title`` is read out where no label is."""
    combo = QComboBox()
    combo.setObjectName(name)
    combo.setAccessibleName(title)
    combo.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
    combo.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
    combo.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    return combo


def box_of(action: QAction, name: str) -> QCheckBox:
    """An action that is on or off as a box to be ticked."""
    box = QCheckBox(action.text())
    box.setObjectName(name)
    box.setToolTip(action.toolTip())
    box.setChecked(action.isChecked())
    box.clicked.connect(action.trigger)
    action.toggled.connect(box.setChecked)
    return box


class ScrolledContent(QWidget):
    """A panel's content to be put into `scrolling`: as high as its texts need at their width. Qt
    would reserve what they need at their narrowest."""

    def minimumSizeHint(self) -> QSize:
        least = super().minimumSizeHint()
        layout = self.layout()
        # Without a text that wraps no one asks for the height at a width: this is all there is.
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


class DecimalBox(QDoubleSpinBox):
    """Shows a point, as all figures of the window do, and takes a comma for one."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setLocale(QLocale(QLocale.Language.C))

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        return super().validate(text.replace(",", "."), position)


class RangeBox(DecimalBox):
    """Lets numbers out of its range be written, and says that they are not taken."""

    refused = Signal(float)  # this was entered; the value is what it was

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        text = text.replace(",", ".")
        if self._outside(text) is not None:
            return QValidator.State.Intermediate, text, position
        return super().validate(text, position)

    def fixup(self, text: str) -> str:
        number = self._outside(text)
        if number is not None:
            self.refused.emit(number)
        return str(super().fixup(text))

    def tell_refused(self, number: float) -> None:
        """Say next to the box that a number is not taken."""
        told = tr(
            "not {number:g}: {least:g} to {most:g}{unit}",
            number=number,
            least=self.minimum(),
            most=self.maximum(),
            unit=self.suffix(),
        )
        QToolTip.showText(self.mapToGlobal(self.rect().bottomLeft()), told, self)

    def _outside(self, text: str) -> float | None:
        """The number of a text, if the range does not have it."""
        bare = text.replace(",", ".").removesuffix(self.suffix()).strip()
        number, is_number = self.locale().toDouble(bare)
        if not is_number or self.minimum() <= number <= self.maximum():
            return None
        return number
