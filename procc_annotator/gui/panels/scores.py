"""The scores panel: figures of this frame, the table of elements, the verdict."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from PySide6.QtCore import QEvent, QModelIndex, QSize, Qt
from PySide6.QtGui import QGuiApplication, QKeySequence, QResizeEvent
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QStackedLayout,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.annotation import points_px
from procc_annotator.camera.base import projects_only_ground
from procc_annotator.dataset.records import FaultParty
from procc_annotator.field.model import Field
from procc_annotator.gui.panels.element_states import (
    EXPLANATIONS,
    ElementState,
    class_title,
    symbol_icon,
    words_for,
)
from procc_annotator.gui.panels.tables import (
    RIGHT,
    ElementRowsModel,
    ElementTable,
    Index,
    TitleDelegate,
)
from procc_annotator.gui.panels.widgets import (
    NARROW,
    ScrolledContent,
    empty_state,
    note_label,
    scrolling,
    show_note,
)
from procc_annotator.gui.state import availability
from procc_annotator.gui.state.selectors import judged
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.state import MAX_TAU, MIN_TAU
from procc_annotator.gui.theme import fixed_width
from procc_annotator.metrics.measurement import Measurement
from procc_annotator.metrics.score import (
    FrameScore,
    ScoreExplanation,
    explain_score,
    px_text,
    worst_elements_first,
)
from procc_annotator.translation import tr, word

ELEMENT, STATUS, POINT, WORST, PASSES = range(5)
_HEADERS = (word("Element"), word("Status"), word("Point"), word("Worst"), word("Passes at"))
_HEADER_TIPS = (
    word("Click a row to see the point that decides"),
    word("How the element counts at tau"),
    word("The point that decides, counted from 1"),
    word("Largest distance of its points to the projection, px"),
    word("The smallest tau of the slider at which it passes, px"),
)


class ScoreRow(NamedTuple):
    """One line of the table; compared to find changed lines."""

    class_name: str
    counted_as: str
    title: str
    state: ElementState
    point: str
    worst: str
    passes: str
    why: str


def score_rows(
    score: FrameScore, measurement: Measurement, field: Field
) -> tuple[list[ScoreRow], list[ScoreExplanation]]:
    """Lines worst first: too far, missed, not annotated, passing; each by its largest distance."""
    elements = list(worst_elements_first(explain_score(score, measurement, field)))
    rows = []
    for element in elements:
        name = element.annotated_name or element.name
        deciding = element.deciding_px
        worst = "" if deciding is None else px_text(deciding, score.threshold)
        point = "" if element.deciding_point is None else str(element.deciding_point + 1)
        rows.append(
            ScoreRow(
                name,
                element.name,
                class_title(field, name),
                ElementState(element.status),
                point,
                worst,
                _passes_from(element.passes_above),
                element.sentence,
            )
        )
    return rows, elements


def _passes_from(distance: float | None) -> str:
    """The first step of the slider above a distance: passing means strictly closer than tau."""
    if distance is None:
        return ""
    tau = max(MIN_TAU, (math.floor(distance * 10) + 1) / 10)
    return f"{tau:.1f}" if tau <= MAX_TAU else f"> {MAX_TAU:.0f}"


class ScoreTableModel(ElementRowsModel[ScoreRow]):
    """The verdict on every element."""

    def __init__(self, view: QWidget) -> None:
        super().__init__(_HEADERS, _HEADER_TIPS, POINT)
        self._view = view  # whose colours the symbols have
        self.elements: list[ScoreExplanation] = []

    def show(self, rows: list[ScoreRow], elements: list[ScoreExplanation]) -> None:
        """Replace the rows."""
        self.elements = elements
        self.replace(rows)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        row, column = self.rows[index.row()], index.column()
        if role == Qt.ItemDataRole.DisplayRole:
            return (row.title, words_for(row.state), row.point, row.worst, row.passes)[column]
        if role == Qt.ItemDataRole.DecorationRole and column == ELEMENT:
            return symbol_icon(row.state, self._view)
        if role == Qt.ItemDataRole.TextAlignmentRole and column >= POINT:
            return RIGHT
        if role == Qt.ItemDataRole.ToolTipRole:
            lines = [row.title, row.why, tr(EXPLANATIONS[row.state])]
            if row.counted_as != row.class_name:
                lines.append(tr("Counts as {class_name}", class_name=row.counted_as))
            return "\n".join(lines)
        if role == Qt.ItemDataRole.AccessibleDescriptionRole:
            return row.why
        return None


def _samples() -> dict[int, str]:
    """Return what the columns have room for."""
    states = max(map(words_for, ElementState), key=len)
    return {
        STATUS: f"{states} ",
        POINT: f"{tr('Point')}  ",
        WORST: max("88.88 ", f"{tr('Worst')} ", key=len),
        PASSES: f"{tr('Passes at')}  ",
    }


def score_table(model: ScoreTableModel) -> ElementTable:
    """The view of the rows; what is left out of a title is its middle."""
    table = ElementTable("scores_table", model, _samples())
    table.setAccessibleName(tr("Scores by element"))
    table.setItemDelegateForColumn(ELEMENT, TitleDelegate(table))
    table.setTextElideMode(Qt.TextElideMode.ElideMiddle)
    table.setMouseTracking(True)
    return table


_WORDS = {
    FaultParty.CAMERA: word("Camera", "a verdict"),
    FaultParty.ANNOTATION: word("Annotation", "a verdict"),
    FaultParty.FINE: word("Fine", "a verdict"),
}
_TIPS = {
    FaultParty.CAMERA: word("The active camera is wrong in this frame"),
    FaultParty.ANNOTATION: word("The clicks are wrong in this frame"),
    FaultParty.FINE: word("Camera and clicks are right in this frame"),
}
_KEYS = {FaultParty.CAMERA: "F7", FaultParty.ANNOTATION: "F8", FaultParty.FINE: "F9"}


class VerdictRow(QWidget):
    """Shows the verdict on the frame under the active source; a click asks the window to mark."""

    def __init__(self, services: Services, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._services = services
        self.buttons: dict[FaultParty, QToolButton] = {}
        row = QHBoxLayout()
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(3)
        caption = QLabel(tr("Fault"))
        caption.setToolTip(tr("Whose fault the score of this frame is; kept with the dataset"))
        row.addWidget(caption)
        for fault in FaultParty:
            button = QToolButton()
            button.setCheckable(True)
            button.setObjectName(f"scores_verdict_{fault}")
            words = tr(_WORDS[fault], "a verdict")
            button.setText(words)
            button.setAccessibleName(tr("Verdict: {verdict}", verdict=words))
            button.setToolTip(
                tr(
                    "{verdict}; once more takes it back ({key})",
                    verdict=tr(_TIPS[fault]),
                    key=_KEYS[fault],
                )
            )
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            self.buttons[fault] = button
            row.addWidget(button, 1)
        self.note = note_label("scores_verdict_note")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(2)
        layout.addLayout(row)
        layout.addWidget(self.note)

    def refresh(self) -> None:
        """Show what is known now."""
        services = self._services
        frame, source = services.state.frame, services.state.active
        verdict = None
        if frame is not None and source is not None and services.state.projection_visible:
            verdict = services.review.verdict(frame.name, source)
        for fault, button in self.buttons.items():
            button.setChecked(verdict is not None and verdict.fault is fault)
        show_note(self.note, f"“{verdict.comment}”" if verdict is not None and verdict.comment
                  else "")  # fmt: skip


_VERY_NARROW = 300
_LINES = 3  # of an explanation that are always kept free
_CHOOSE = word("Choose an element to read why it counts as it does.")
_OWN_FIT = word("the camera is the fit to these same clicks: this JaC is no score of a method")
_MIRRORED = word("Mirrored labels count here: the field turned by 180° fits at least as well.")
_NOISE = word("human noise {median:.2f} px, 95 % within {p95:.2f} px")
_NOISE_ABOVE_TAU = word("human noise {median:.2f} px, 95 % within {p95:.2f} px – more than tau")
_FIGURES = (
    ("precision", word("Precision"), "TP / (TP + FP)"),
    ("recall", word("Recall"), "TP / (TP + FN)"),
    ("mean_error", word("Mean error"), word("Mean reprojection error of all points, px")),
    ("median_error", word("Median"), word("Median reprojection error, px")),
    ("max_error", word("Max"), word("Largest reprojection error, px")),
)


class ScoresPanel(QWidget):
    """Displays the state's score; a click on an element flies to the point that decides."""

    def __init__(self, services: Services, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("scores_panel")
        self._services = services
        self._figures: dict[str, QLabel] = {}
        self._counts: dict[str, QLabel] = {}
        self._build()
        self._refresher = services.store.watch_visible(
            self,
            self._refresh,
            lambda s: (judged(s), s.selection, s.noise_floor, s.look_of(s.active)),
            services.review.statusChanged,
            services.source_frames.changed,
        )

    def sizeHint(self) -> QSize:
        return QSize(300, 360)

    # --- building ------------------------------------------------------------------------------

    def _build(self) -> None:
        self.empty = empty_state("", "scores_empty")
        content = ScrolledContent()
        layout = QVBoxLayout(content)
        layout.setContentsMargins(6, 6, 6, 6)
        layout.setSpacing(6)
        layout.addLayout(self._build_headline())
        layout.addLayout(self._build_figures())
        self.terms = note_label("scores_terms")
        self.mirrored = note_label("scores_mirrored")
        layout.addWidget(self.terms)
        layout.addWidget(self.mirrored)
        self.verdict = VerdictRow(self._services)
        layout.addWidget(self.verdict)
        layout.addLayout(self._build_table(), 1)
        self._stack = QStackedLayout(self)
        self._stack.addWidget(self.empty)
        self._stack.addWidget(scrolling(content))

    def _build_headline(self) -> QHBoxLayout:
        self.jac = QLabel()
        self.jac.setObjectName("scores_jac")
        self.jac.setFont(fixed_width(self.font(), 2.2, bold=True))
        self.at_tau = QLabel()
        self.at_tau.setObjectName("scores_tau")
        counts = QGridLayout()
        counts.setHorizontalSpacing(14)
        counts.setVerticalSpacing(0)
        tips = {
            "tp": ("TP", tr("Elements whose points all are closer than tau")),
            "fp": ("FP", tr("Elements too far, or projected and not annotated")),
            "fn": ("FN", tr("Annotated elements that the camera does not project")),
        }
        for column, (key, (title, tip)) in enumerate(tips.items()):
            self._counts[key] = _figure(f"scores_{key}", tip)
            self._counts[key].setAlignment(Qt.AlignmentFlag.AlignCenter)
            caption = _caption(title, tip, Qt.AlignmentFlag.AlignCenter)
            counts.addWidget(self._counts[key], 0, column)
            counts.addWidget(caption, 1, column)
        headline = QHBoxLayout()
        name = QVBoxLayout()
        name.setSpacing(0)
        name.addWidget(self.jac)
        name.addWidget(self.at_tau)
        headline.addLayout(name)
        headline.addStretch(1)
        headline.addLayout(counts)
        return headline

    def _build_figures(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(1)
        for i, (key, title, tip) in enumerate(_FIGURES):
            tip = tr(tip)
            row, column = (0, i) if i < 2 else (1, i - 2)
            value = self._figures[key] = _figure(f"scores_{key}", tip)
            caption = _caption(tr(title), tip)
            grid.addWidget(caption, 2 * row, column)
            grid.addWidget(value, 2 * row + 1, column)
        for column in range(3):
            grid.setColumnStretch(column, 1)
        return grid

    def _build_table(self) -> QVBoxLayout:
        """The table, and below it why the chosen element counts as it does."""
        self.model = ScoreTableModel(self)
        self.table = score_table(self.model)
        self.table.chosen.connect(self._fly)
        self.table.entered.connect(self._hover)
        self.table.viewport().installEventFilter(self)
        self.why = QLabel()
        self.why.setObjectName("scores_why")
        self.why.setWordWrap(True)
        self.why.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self.why.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.why.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Minimum)
        self.why.setMinimumHeight(_LINES * self.fontMetrics().lineSpacing())
        copy = self.table.addAction(tr("Copy this explanation"), self._copy_one)
        copy.setShortcut(QKeySequence.StandardKey.Copy)
        copy.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
        self.table.addAction(tr("Copy all explanations"), self._copy_all)
        self.table.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        layout = QVBoxLayout()
        layout.setSpacing(4)
        layout.addWidget(self.table, 1)
        layout.addWidget(self.why)
        return layout

    # --- showing -------------------------------------------------------------------------------

    def _refresh(self) -> None:
        score = self._services.scorer.score
        if score is None or self._services.state.why_not_judged:
            self.empty.setText(self._why_empty())
            self._stack.setCurrentIndex(0)
            return
        self._show_figures(score)
        active = self._services.state.active
        self.verdict.setVisible(active is not None and active.files is not None)
        self.verdict.refresh()
        measurement = self._services.scorer.measurement
        if measurement is not None:
            self.model.show(*score_rows(score, measurement, measurement.setup.field))
            self._show_selection()
        self._stack.setCurrentIndex(1)

    def _why_empty(self) -> str:
        services, state = self._services, self._services.state
        why = availability.no_frame(state) or availability.no_source(state)
        if why := why or availability.hidden(state):
            return availability.as_sentence(why)
        if services.scorer.score is not None:
            return tr("JaC –: {why}.", why=state.why_not_judged)
        if services.scorer.shown.error:
            return tr(
                "This frame's camera cannot be used:\n{error}", error=services.scorer.shown.error
            )
        cameras, name = state.active_cameras, state.frame_name
        assert cameras is not None
        assert name is not None
        if cameras is services.fit_source.cameras:
            return tr("No fit to judge: {why}.", why=cameras.why_none(name))
        return tr("{name} has no camera for this frame.", name=cameras.name)

    def _show_figures(self, score: FrameScore) -> None:
        self.jac.setText(f"{score.jac:.3f}")
        self.at_tau.setText(tr("JaC at {tau:.1f} px", tau=score.threshold))
        for key, label in self._counts.items():
            label.setText(str(getattr(score, key)))
        for key, label in self._figures.items():
            value = getattr(score, key)
            unit = " px" if key.endswith("error") else ""
            label.setText("–" if value is None else f"{value:.2f}{unit}")
        camera = self._services.scorer.camera
        ground_only = camera is not None and projects_only_ground(camera)
        terms = [self._services.scorer.frame_setup.describe(ground_only=ground_only)]
        if self._services.state.active is self._services.fit_source.source:
            terms.append(tr(_OWN_FIT))
        if (floor := self._services.state.noise_floor) is not None:
            above = floor[1] > self._services.state.tau
            words = _NOISE_ABOVE_TAU if above else _NOISE
            terms.append(tr(words, median=floor[0], p95=floor[1]))
        if (points := self._points_by_origin()) is not None:
            terms.append(points)
        show_note(self.terms, "\n".join(terms))
        show_note(self.mirrored, f"⇄ {tr(_MIRRORED)}" if score.mirrored else "")

    def _points_by_origin(self) -> str | None:
        """Return how many points of each origin the score rests on."""
        services = self._services
        if (frame := services.state.frame) is None:
            return None
        counts = services.review.origin_counts(frame.name, services.state.shown_annotation)
        if not counts:
            return None
        kinds = ", ".join(f"{n} {tr(kind.value, 'points')}" for kind, n in counts.items())
        return tr("points: {kinds}", kinds=kinds)

    def _show_selection(self) -> None:
        row = self.table.show_chosen(self._services.state.selected_class)
        why = self.model.rows[row].why if row >= 0 else tr(_CHOOSE)
        if self.why.text() != why:
            self.why.setText(why)

    def resizeEvent(self, event: QResizeEvent) -> None:
        self.table.setColumnHidden(STATUS, event.size().width() < NARROW)
        self.table.setColumnHidden(POINT, event.size().width() < NARROW)
        self.table.setColumnHidden(PASSES, event.size().width() < _VERY_NARROW)
        super().resizeEvent(event)

    # --- choosing ------------------------------------------------------------------------------

    def _hover(self, index: QModelIndex) -> None:
        self._services.selection.hover_class(self.model.rows[index.row()].class_name)

    def eventFilter(self, watched: object, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Leave and watched is self.table.viewport():
            self._services.selection.hover_class(None)
        return False

    def _copy_one(self) -> None:
        row = self.table.currentIndex().row()
        if 0 <= row < len(self.model.rows):
            QGuiApplication.clipboard().setText(self.model.rows[row].why)

    def _copy_all(self) -> None:
        QGuiApplication.clipboard().setText("\n".join(row.why for row in self.model.rows))

    def _fly(self, at: int) -> None:
        row, element = self.model.rows[at], self.model.elements[at]
        if element.deciding_point is not None:
            self._services.selection.select_point(row.class_name, element.deciding_point)
        else:
            self._services.selection.select_class(row.class_name)
        target = self._target(row.class_name, element)
        if target is not None:
            self._services.store.events.flyTo.emit(*target)

    def _target(self, class_name: str, element: ScoreExplanation) -> tuple[float, float] | None:
        """Return where the verdict is decided, picture px: a point, or the middle of a
        projection."""
        size = self._services.state.picture_size
        measurement = self._services.scorer.measurement
        if size is None or measurement is None:
            return None
        polyline = self._services.state.shown_annotation.get(class_name)
        if polyline is not None and polyline.points:
            x, y = points_px(polyline, size)[element.deciding_point or 0]
            return float(x), float(y)
        pieces = measurement.projected.pieces.get(element.name, ())
        if not pieces:
            return None
        piece = max(pieces, key=len)
        from_size = measurement.setup.size
        x, y = piece[len(piece) // 2] if len(piece) > 2 else piece.mean(axis=0)
        return (
            float(x) * (size[0] - 1) / (from_size[0] - 1),
            float(y) * (size[1] - 1) / (from_size[1] - 1),
        )


def _figure(name: str, tip: str) -> QLabel:
    label = _caption("–", tip)
    label.setObjectName(name)
    label.setFont(fixed_width(label.font(), bold=True))
    label.setSizePolicy(QSizePolicy.Policy.Minimum, QSizePolicy.Policy.Fixed)
    return label


def _caption(
    text: str, tip: str, alignment: Qt.AlignmentFlag = Qt.AlignmentFlag.AlignLeft
) -> QLabel:
    label = QLabel(text)
    label.setToolTip(tip)
    label.setAlignment(alignment)
    return label
