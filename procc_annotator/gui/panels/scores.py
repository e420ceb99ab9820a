"""The scores panel: figures of this frame, the table of elements, the verdict."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from PySide6.QtCore import QEvent, QModelIndex, Qt
from PySide6.QtGui import QGuiApplication, QKeySequence, QResizeEvent
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.camera.base import projects_only_ground
from procc_annotator.dataset.records import FaultParty
from procc_annotator.field.model import Field
from procc_annotator.gui.panels.element_states import (
    EXPLANATIONS,
    ElementState,
    TitleDelegate,
    class_title,
    fly_to_point,
    symbol_icon,
    words_for,
)
from procc_annotator.gui.panels.widgets import (
    NARROW,
    ElementRowsModel,
    ElementTable,
    Index,
    Pages,
    Panel,
    ScrolledContent,
    hbox,
    make_label,
    named,
    note_label,
    scrolling,
    show_note,
    vbox,
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
    title: str
    state: ElementState
    element: ScoreExplanation
    cells: tuple[str, ...]  # title, status, deciding point, worst distance, smallest passing tau


def score_rows(score: FrameScore, measurement: Measurement, field: Field) -> list[ScoreRow]:
    """Lines worst first: too far, missed, not annotated, passing; each by its largest distance."""
    rows = []
    for element in worst_elements_first(explain_score(score, measurement, field)):
        name = element.annotated_name or element.name
        state, title = ElementState(element.status), class_title(field, name)
        deciding = element.deciding_px
        worst = "" if deciding is None else px_text(deciding, score.threshold)
        point = "" if element.deciding_point is None else str(element.deciding_point + 1)
        cells = (title, words_for(state), point, worst, _passes_from(element.passes_above))
        rows.append(ScoreRow(name, title, state, element, cells))
    return rows


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
        self._view = view  # the symbols have its colours

    def texts(self, row: ScoreRow) -> Sequence[str]:
        return row.cells

    def tip(self, row: ScoreRow) -> str:
        lines = [row.title, row.element.sentence, tr(EXPLANATIONS[row.state])]
        if row.element.name != row.class_name:
            lines.append(tr("Counts as {class_name}", class_name=row.element.name))
        return "\n".join(lines)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        row = self.rows[index.row()]
        if role == Qt.ItemDataRole.DecorationRole and index.column() == ELEMENT:
            return symbol_icon(row.state, self._view)
        if role == Qt.ItemDataRole.AccessibleDescriptionRole:
            return row.element.sentence
        return super().data(index, role)


_WORDS = {
    FaultParty.CAMERA: word("Camera wrong", "a verdict"),
    FaultParty.ANNOTATION: word("Labels wrong", "a verdict"),
    FaultParty.FINE: word("OK", "a verdict"),
}
_TIPS = {
    FaultParty.CAMERA: word("The active camera is wrong in this frame"),
    FaultParty.ANNOTATION: word("The clicks are wrong in this frame"),
    FaultParty.FINE: word("Camera and clicks are right in this frame"),
}
_KEYS = {FaultParty.CAMERA: "F7", FaultParty.ANNOTATION: "F8", FaultParty.FINE: "F9"}


class VerdictRow(QWidget):
    """Shows the verdict on the frame under the active source; a click asks the window to mark."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._services = services
        self.buttons: dict[FaultParty, QToolButton] = {}
        tip = tr("What causes the score of this frame; saved with the dataset")
        buttons = hbox(make_label(tr("Verdict"), tip=tip), spacing=3)
        for fault in FaultParty:
            words = tr(_WORDS[fault], "a verdict")
            tip = tr(
                "{verdict}; once more takes it back ({key})",
                verdict=tr(_TIPS[fault]),
                key=_KEYS[fault],
            )
            button = QToolButton()
            button.setText(words)
            button.setCheckable(True)
            title = tr("Verdict: {verdict}", verdict=words)
            self.buttons[fault] = named(button, f"scores_verdict_{fault}", tip=tip, title=title)
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            buttons.addWidget(button, 1)
        self.note = note_label("scores_verdict_note")
        vbox(buttons, self.note, of=self, spacing=2, margins=0)

    def refresh(self) -> None:
        """Show what is known now."""
        name = self._services.state.frame_name
        verdict = self._services.review.shown_verdict(name) if name is not None else None
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


class ScoresPanel(Panel):
    """Displays the state's score; a click on an element flies to the point that decides."""

    def __init__(self, services: Services) -> None:
        super().__init__(services, "scores_panel", (300, 360))
        self._figures: dict[str, QLabel] = {}
        self._counts: dict[str, QLabel] = {}
        self._build()
        self._follow(
            lambda s: (judged(s), s.selection, s.noise_floor, s.look_of(s.active)),
            services.review.statusChanged,
            services.source_frames.changed,
        )

    # --- building ------------------------------------------------------------------------------

    def _build(self) -> None:
        self.terms = note_label("scores_terms")
        self.mirrored = note_label("scores_mirrored")
        self.verdict = VerdictRow(self._services)
        content = ScrolledContent()
        vbox(
            self._build_headline(),
            self._build_figures(),
            self.terms,
            self.mirrored,
            self.verdict,
            (self._build_table(), 1),
            of=content,
            spacing=6,
            margins=6,
        )
        self._pages = Pages(scrolling(content), "scores_empty")
        self.empty = self._pages.empty
        vbox(self._pages, of=self, margins=0)

    def _build_headline(self) -> QHBoxLayout:
        font = fixed_width(self.font(), 2.2, bold=True)
        self.jac = make_label(name="scores_jac", font=font)
        self.at_tau = make_label(name="scores_tau")
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
            for line, part in enumerate((self._counts[key], make_label(title, tip=tip))):
                part.setAlignment(Qt.AlignmentFlag.AlignCenter)
                counts.addWidget(part, line, column)
        return hbox(vbox(self.jac, self.at_tau, spacing=0), None, counts)

    def _build_figures(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(1)
        for i, (key, title, tip) in enumerate(_FIGURES):
            tip = tr(tip)
            row, column = (0, i) if i < 2 else (1, i - 2)
            self._figures[key] = _figure(f"scores_{key}", tip)
            grid.addWidget(make_label(tr(title), tip=tip), 2 * row, column)
            grid.addWidget(self._figures[key], 2 * row + 1, column)
        for column in range(3):
            grid.setColumnStretch(column, 1)
        return grid

    def _build_table(self) -> QVBoxLayout:
        """The table, and below it why the chosen element counts as it does."""
        self.model = ScoreTableModel(self)
        self.table = ElementTable(
            "scores_table",
            self.model,
            {
                STATUS: f"{max(map(words_for, ElementState), key=len)} ",
                POINT: f"{tr('Point')}  ",
                WORST: max("88.88 ", f"{tr('Worst')} ", key=len),
                PASSES: f"{tr('Passes at')}  ",
            },
        )
        self.table.setAccessibleName(tr("Scores by element"))
        self.table.setItemDelegateForColumn(ELEMENT, TitleDelegate(self.table))
        self.table.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.table.setMouseTracking(True)
        self.table.chosen.connect(self._fly)
        self.table.entered.connect(self._hover)
        self.table.viewport().installEventFilter(self)
        self.why = make_label(name="scores_why", wrap=True)
        self.why.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self.why.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.why.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Minimum)
        self.why.setMinimumHeight(_LINES * self.fontMetrics().lineSpacing())
        copy = self.table.addAction(tr("Copy this explanation"), self._copy_one)
        copy.setShortcut(QKeySequence.StandardKey.Copy)
        copy.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
        self.table.addAction(tr("Copy all explanations"), self._copy_all)
        self.table.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        return vbox((self.table, 1), self.why, spacing=4)

    # --- showing -------------------------------------------------------------------------------

    def _refresh(self) -> None:
        score = self._services.scorer.score
        if score is None or self._services.state.why_not_judged:
            self._pages.explain(self._why_empty())
            return
        self._show_figures(score)
        active = self._services.state.active
        self.verdict.setVisible(active is not None and active.files is not None)
        self.verdict.refresh()
        measurement = self._services.scorer.measurement
        if measurement is not None:
            self.model.replace(score_rows(score, measurement, measurement.setup.field))
            self._show_selection()
        self._pages.explain("")

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
        ground_only = projects_only_ground(self._services.scorer.camera)
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
        self.why.setText(self.model.rows[row].element.sentence if row >= 0 else tr(_CHOOSE))

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
            QGuiApplication.clipboard().setText(self.model.rows[row].element.sentence)

    def _copy_all(self) -> None:
        sentences = (row.element.sentence for row in self.model.rows)
        QGuiApplication.clipboard().setText("\n".join(sentences))

    def _fly(self, at: int) -> None:
        row = self.model.rows[at]
        element, services = row.element, self._services
        annotation, point = services.state.shown_annotation, element.deciding_point
        if not fly_to_point(services, annotation, row.class_name, point):
            target = self._middle_of(element)
            if target is not None:
                services.store.events.flyTo.emit(*target)

    def _middle_of(self, element: ScoreExplanation) -> tuple[float, float] | None:
        """Return the middle of an element's projection, px of the picture."""
        size, measurement = self._services.state.picture_size, self._services.scorer.measurement
        if size is None or measurement is None:
            return None
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
    made = make_label("–", name, tip=tip)
    made.setFont(fixed_width(made.font(), bold=True))
    made.setSizePolicy(QSizePolicy.Policy.Minimum, QSizePolicy.Policy.Fixed)
    return made
