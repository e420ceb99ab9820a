"""How well camera and clicks of this frame agree: the figures, the curve, and every element."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QModelIndex, QSize, Qt
from PySide6.QtGui import QGuiApplication, QIcon, QKeySequence, QResizeEvent
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QStackedLayout,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.annotation import points_px
from procc_annotator.camera.base import projects_only_ground
from procc_annotator.gui.panels.judged.score_table import (
    PASSES,
    POINT,
    STATUS,
    ScoreTableModel,
    score_rows,
    score_table,
)
from procc_annotator.gui.panels.judged.verdict_row import VerdictRow
from procc_annotator.gui.panels.parts import (
    NARROW,
    ScrolledContent,
    empty_state,
    note_label,
    scrolling,
    show_note,
)
from procc_annotator.gui.panels.refresher import Refresher, judged
from procc_annotator.gui.panels.states import ElementState, symbol_icon
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.theme import fixed_width
from procc_annotator.metrics.score import FrameScore, ScoreExplanation
from procc_annotator.translation import tr, word

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
    """Displays the document's score; a click on an element flies to the point that decides."""

    def __init__(self, document: Document, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("scores_panel")
        self._document = document
        self._icons: dict[ElementState, QIcon] = {}
        self._figures: dict[str, QLabel] = {}
        self._counts: dict[str, QLabel] = {}
        self._plot: QWidget | None = None
        self._build()
        self._refresher = Refresher(self, self._refresh, interval_ms=60)
        self._refresher.follow(
            document.store,
            lambda s: (judged(s), s.selection, s.noise_floor, s.look_of(s.active)),
            document.review.statusChanged,
            document.source_frames.changed,
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
        self.verdict = VerdictRow(self._document)
        layout.addWidget(self.verdict)
        layout.addWidget(self._build_tabs(), 1)
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

    def _build_tabs(self) -> QTabWidget:
        self.model = ScoreTableModel(self._icon)
        self.table = score_table(self.model)
        self.table.chosen.connect(self._fly)
        self.table.entered.connect(self._hover)
        self.table.viewport().installEventFilter(self)
        self._plot_page = QWidget()
        self._plot_page.setMinimumHeight(110)
        QVBoxLayout(self._plot_page).setContentsMargins(0, 0, 0, 0)
        self.tabs = QTabWidget(documentMode=True)
        self.tabs.setObjectName("scores_tabs")
        self.tabs.setAccessibleName(tr("Scores and their plot"))
        self.tabs.addTab(self._build_explained(), tr("Elements"))
        self.tabs.addTab(self._plot_page, tr("JaC over tau"))
        self.tabs.currentChanged.connect(lambda: self._refresher.request())
        return self.tabs

    def _build_explained(self) -> QWidget:
        """The table, and below it why the chosen element counts as it does."""
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
        page = QWidget()
        layout = QVBoxLayout(page)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        layout.addWidget(self.table, 1)
        layout.addWidget(self.why)
        return page

    def _icon(self, state: ElementState) -> QIcon:
        if state not in self._icons:
            dpr = self.devicePixelRatioF()
            self._icons[state] = symbol_icon(state, self.palette(), 14, dpr)
        return self._icons[state]

    # --- showing -------------------------------------------------------------------------------

    def _refresh(self) -> None:
        score = self._document.judge.score
        if score is None or self._document.state.why_not_judged:
            self.empty.setText(self._why_empty())
            self._stack.setCurrentIndex(0)
            return
        self._show_figures(score)
        active = self._document.state.active
        self.verdict.setVisible(active is not None and active.files is not None)
        self.verdict.refresh()
        measurement = self._document.judge.measurement
        if self.tabs.currentIndex() == 0 and measurement is not None:
            self.model.show(*score_rows(score, measurement, measurement.setup.field))
            self._show_selection()
        else:
            self._show_plot()
        self._stack.setCurrentIndex(1)

    def _why_empty(self) -> str:
        document = self._document
        if document.state.frame is None:
            return tr("Open a folder of pictures to see scores.")
        if document.state.active_cameras is None:
            return tr(
                "No camera to judge.\nLoad cameras to see how well they agree with your clicks."
            )
        if not document.state.projection_visible:
            return tr("Hidden: blind mode shows the score once this frame is committed.")
        if document.judge.score is not None:
            return tr("JaC –: {why}.", why=document.state.why_not_judged)
        if document.judge.shown.error:
            return tr(
                "This frame's camera cannot be used:\n{error}", error=document.judge.shown.error
            )
        if document.state.active_cameras is document.fit_source.cameras:
            why = document.state.active_cameras.why_none(document.state.frame.name)
            return tr("No fit to judge: {why}.", why=why)
        return tr("{name} has no camera for this frame.", name=document.state.active_cameras.name)

    def _show_figures(self, score: FrameScore) -> None:
        self.jac.setText(f"{score.jac:.3f}")
        self.at_tau.setText(tr("JaC at {tau:.1f} px", tau=score.threshold))
        for key, label in self._counts.items():
            label.setText(str(getattr(score, key)))
        for key, label in self._figures.items():
            value = getattr(score, key)
            unit = " px" if key.endswith("error") else ""
            label.setText("–" if value is None else f"{value:.2f}{unit}")
        camera = self._document.judge.camera
        ground_only = camera is not None and projects_only_ground(camera)
        terms = [self._document.judge.frame_setup.describe(ground_only=ground_only)]
        if self._document.state.active is self._document.fit_source.source:
            terms.append(tr(_OWN_FIT))
        if (floor := self._document.state.noise_floor) is not None:
            above = floor[1] > self._document.state.tau
            words = _NOISE_ABOVE_TAU if above else _NOISE
            terms.append(tr(words, median=floor[0], p95=floor[1]))
        if (points := self._points_by_origin()) is not None:
            terms.append(points)
        show_note(self.terms, "\n".join(terms))
        show_note(self.mirrored, f"⇄ {tr(_MIRRORED)}" if score.mirrored else "")

    def _points_by_origin(self) -> str | None:
        """Return how many points of each origin the score rests on."""
        document = self._document
        if (frame := document.state.frame) is None:
            return None
        counts = document.review.origin_counts(frame.name, document.state.shown_annotation)
        if not counts:
            return None
        kinds = ", ".join(f"{n} {tr(kind.value, 'points')}" for kind, n in counts.items())
        return tr("points: {kinds}", kinds=kinds)

    def _show_plot(self) -> None:
        measurement = self._document.judge.measurement
        if measurement is None:
            return
        from procc_annotator.gui.panels.judged.jac_plot import JacPlot  # imports pyqtgraph

        if not isinstance(self._plot, JacPlot):
            self._plot = JacPlot()
            self._plot.tauChosen.connect(self._document.terms.set_tau)
            layout = self._plot_page.layout()
            assert layout is not None
            layout.addWidget(self._plot)
        self._plot.show_curve(measurement, self._document.state.tau)

    def _show_selection(self) -> None:
        row = self.table.show_chosen(self._document.state.selected_class)
        why = self.model.rows[row].why if row >= 0 else tr(_CHOOSE)
        if self.why.text() != why:
            self.why.setText(why)

    def resizeEvent(self, event: QResizeEvent) -> None:
        self.table.setColumnHidden(STATUS, event.size().width() < NARROW)
        self.table.setColumnHidden(POINT, event.size().width() < NARROW)
        self.table.setColumnHidden(PASSES, event.size().width() < _VERY_NARROW)
        super().resizeEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.PaletteChange:
            self._icons.clear()
        super().changeEvent(event)

    # --- choosing ------------------------------------------------------------------------------

    def _hover(self, index: QModelIndex) -> None:
        self._document.selecting.hover_class(self.model.rows[index.row()].class_name)

    def eventFilter(self, watched: object, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Leave and watched is self.table.viewport():
            self._document.selecting.hover_class(None)
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
            self._document.selecting.select_point(row.class_name, element.deciding_point)
        else:
            self._document.selecting.select_class(row.class_name)
        target = self._target(row.class_name, element)
        if target is not None:
            self._document.store.events.flyTo.emit(*target)

    def _target(self, class_name: str, element: ScoreExplanation) -> tuple[float, float] | None:
        """Return where the verdict is decided, picture px: a point, or the middle of a
        projection."""
        size = self._document.state.picture_size
        measurement = self._document.judge.measurement
        if size is None or measurement is None:
            return None
        polyline = self._document.state.shown_annotation.get(class_name)
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
