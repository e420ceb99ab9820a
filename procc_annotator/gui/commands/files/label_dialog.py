"""The dialog that asks what the labels of another program stand for."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QStringListModel, Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFrame,
    QGridLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.assist.label_proposal import LabelProposal, order_choices, rule_words
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.label_map import LABELS_FILE, Rule
from procc_annotator.gui.panels.widgets import note_label, show_note
from procc_annotator.translation import tr, tr_count, word

_SIZE = (960, 480)
_HEADERS = (word("Label"), word("Shapes"), word("Stands for"), "", word("Why"))
_AS_IT_IS = word("? (stays as it is, an unknown class)")
_LEFT_OUT = word("Leave out")
_SURETIES = {
    "sure": word("sure", "a proposal"),
    "likely": word("likely", "a proposal"),
    "open": word("to be said", "a proposal"),
}
_LONGEST = 40  # characters of a label that are shown


class _AsItIs:
    """In the place of a rule: nothing is said of the label."""


class LabelDialog(QDialog):
    """One row a label: what it is proposed to stand for, how surely and why, to be changed."""

    def __init__(
        self,
        parent: QWidget,
        proposals: Sequence[LabelProposal],
        field: Field,
        *,
        better: str = "",
        has_file: bool = False,
    ) -> None:
        """Show what is proposed; what is open stays an unknown class unless a person says more.

        Args:
            proposals: of every label that is no class.
            field: of the dataset.
            better: title of a field whose classes are called more like the labels; may be empty.
            has_file: whether the dataset has a ``labels.toml`` already.
        """
        super().__init__(parent)
        self.setObjectName("labelDialog")
        self.setWindowTitle(tr("Names of another program"))
        self._proposals = proposals
        self.choices: list[QComboBox] = []
        self._rules: list[list[Rule | _AsItIs]] = []
        asked = QLabel(_asked(len(proposals), field), wordWrap=True)
        self.note = note_label("labelNote")
        words = tr(
            "These names are more like those of {field}: choose that field first (File > Field).",
            field=tr(better) if better else "",
        )
        show_note(self.note, words if better else "")
        self.keep = QCheckBox(tr("Keep these names with the dataset ({file})", file=LABELS_FILE))
        if has_file:
            self.keep.setText(
                tr("Add these names to the dataset's {file}, written anew", file=LABELS_FILE)
            )
        self.keep.setChecked(not has_file)
        self.buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.take = QPushButton(tr("Import"))
        self.buttons.addButton(self.take, QDialogButtonBox.ButtonRole.AcceptRole)
        self.buttons.button(QDialogButtonBox.StandardButton.Cancel).setAutoDefault(False)
        self.take.setDefault(True)
        self.buttons.accepted.connect(self.accept)
        self.buttons.rejected.connect(self.reject)
        column = QVBoxLayout(self)
        for part in (asked, self.note, self._table(field), self.keep, self.buttons):
            column.addWidget(part, int(isinstance(part, QScrollArea)))
        self.resize(*_SIZE)
        if self.choices:
            self.choices[0].setFocus()

    @property
    def rules(self) -> dict[str, Rule]:
        """Return what was chosen, by label; labels that stay as they are are missing."""
        found: dict[str, Rule] = {}
        for one, box, rules in zip(self._proposals, self.choices, self._rules, strict=True):
            rule = rules[box.currentIndex()]
            if not isinstance(rule, _AsItIs):
                found[one.count.label] = rule
        return found

    def _table(self, field: Field) -> QScrollArea:
        inside = QWidget()
        grid = QGridLayout(inside)
        for column, header in enumerate(_HEADERS):
            title = QLabel(f"<b>{tr(header)}</b>" if header else "")
            title.setTextFormat(Qt.TextFormat.RichText)
            grid.addWidget(title, 0, column)
        names = [e.name for e in field.elements]
        titles = [tr(field.title_of(name)) for name in names]
        self._titles = QStringListModel([tr(_AS_IT_IS), tr(_LEFT_OUT), *titles], self)
        for row, one in enumerate(self._proposals, start=1):
            box = self._choice(one, names, titles, field)
            shown = one.count.label
            shown = shown if len(shown) <= _LONGEST else f"{shown[: _LONGEST - 1]}…"
            cells = (
                _text(shown, one.count.label), _text(str(one.count.shapes)), box,
                _text(tr(_SURETIES[one.surety], "a proposal")), _wrapped(_why(one, field)),
            )  # fmt: skip
            for column, cell in enumerate(cells):
                grid.addWidget(cell, row, column, Qt.AlignmentFlag.AlignVCenter)
        grid.setRowStretch(len(self._proposals) + 1, 1)
        grid.setColumnStretch(len(_HEADERS) - 1, 1)
        area = QScrollArea()
        area.setObjectName("labelTable")
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.setWidget(inside)
        return area

    def _choice(
        self, one: LabelProposal, names: list[str], titles: list[str], field: Field
    ) -> QComboBox:
        orders = order_choices(one)
        rules: list[Rule | _AsItIs] = [_AsItIs(), None, *orders, *names]
        box = QComboBox()
        box.setAccessibleName(tr("What {label} stands for", label=one.count.label))
        if orders:
            words = [rule_words(rule, field) for rule in orders]
            box.addItems([tr(_AS_IT_IS), tr(_LEFT_OUT), *words, *titles])
        else:  # most labels: one list for all of them
            box.setModel(self._titles)
        box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        box.setMinimumContentsLength(_LONGEST)
        box.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        if one.surety != "open":
            box.setCurrentIndex(rules.index(one.rule))
        box.setToolTip(box.currentText())
        box.currentTextChanged.connect(box.setToolTip)
        self.choices.append(box)
        self._rules.append(rules)
        return box


def _why(one: LabelProposal, field: Field) -> str:
    like = ", ".join(tr(field.title_of(name)) for name in one.like)
    return f"{one.why}: {like}" if like else one.why


def _text(text: str, tip: str = "") -> QLabel:
    label = QLabel(text)
    label.setTextFormat(Qt.TextFormat.PlainText)
    label.setToolTip(tip)
    return label


def _wrapped(text: str) -> QLabel:
    label = _text(text, text)
    label.setWordWrap(True)
    return label


def _asked(count: int, field: Field) -> str:
    return tr_count(
        count,
        "{n} label is no class of {field}. Say what they stand for; what is proposed was"
        " told by their words, and by which elements their shapes lie on.",
        "{n} labels are no class of {field}. Say what they stand for; what is proposed was"
        " told by their words, and by which elements their shapes lie on.",
        field=tr(field.title),
    )
