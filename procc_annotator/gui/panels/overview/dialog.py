"""A window with the figures of the whole set: how far it is, what is in it, how long it took."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QPalette, QShowEvent
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QSplitter,
    QStackedWidget,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.gui.panels.overview.plots import OverviewPlots
from procc_annotator.gui.panels.overview.tables import (
    DASH,
    FigureRow,
    FiguresModel,
    duration,
    figures_view,
    whole_percent,
    width_needed,
)
from procc_annotator.gui.panels.parts import empty_state
from procc_annotator.gui.theme import fixed_width
from procc_annotator.report.window_tables import ClassFigures, SetOverview, StatusFigures
from procc_annotator.translation import tr, tr_count, word

_STATUS_HEADERS = (
    word("Status"),
    word("Frames"),
    word("Share"),
    word("Median time"),
    word("Total time"),
)
_STATUS_TIPS = (
    word("Where the frame is in its life"),
    word("How many frames have this status"),
    word("Of all frames"),
    word("Of the frames that somebody worked on"),
    word("Of all frames with this status"),
)
_CLASS_HEADERS = (word("Class"), word("Frames"), word("Share"), word("Points"))
_CLASS_TIPS = (
    word("An element of the field, or another class that occurs"),
    word("How many frames it is annotated in"),
    word("Of all frames"),
    word("Its points in all frames"),
)
_BAR = 2


class _Figure(QWidget):
    """A number in large print, and below it what it is."""

    def __init__(self, name: str) -> None:
        super().__init__()
        self.value = QLabel(DASH)
        self.value.setObjectName(f"overview_{name}")
        self.value.setFont(fixed_width(self.value.font(), 1.5))
        self.caption = QLabel()
        self.caption.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.value)
        layout.addWidget(self.caption)

    def show_figure(self, value: str, caption: str, tip: str = "") -> None:
        self.value.setText(value)
        self.caption.setText(caption)
        self.setToolTip(tip)


class OverviewWindow(QDialog):
    """Shows a `SetOverview`; anyone who computes it listens to `exportRequested`."""

    exportRequested = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("overviewWindow")
        self.setWindowTitle(tr("Overview of the set"))
        self.setWindowFlag(Qt.WindowType.WindowMaximizeButtonHint)
        self._overview: SetOverview | None = None
        self._plots: OverviewPlots | None = None
        self.pages = QStackedWidget()
        self.pages.addWidget(
            empty_state(
                tr("Nothing to sum up: no frames are open.\nOpen a folder of pictures first."),
                "overview_empty",
            )
        )
        self._page = self._make_page()
        self.pages.addWidget(self._page)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.reject)
        self.export_button = QPushButton(tr("Export CSV…"))
        self.export_button.setObjectName("overview_export")
        self.export_button.setToolTip(tr("Write one row a frame to a table for a spreadsheet"))
        self.export_button.setEnabled(False)
        self.export_button.setAutoDefault(False)
        self.export_button.clicked.connect(self.exportRequested)
        buttons.addButton(self.export_button, QDialogButtonBox.ButtonRole.ActionRole)
        layout = QVBoxLayout(self)
        layout.addWidget(self.pages, 1)
        layout.addWidget(buttons)
        buttons.button(QDialogButtonBox.StandardButton.Close).setFocus()
        self.resize(1000, 700)

    def show_overview(self, overview: SetOverview) -> None:
        """Show other figures; the plots follow when they can be seen."""
        self._overview = overview
        self.pages.setCurrentIndex(1 if overview.frames else 0)
        self.export_button.setEnabled(overview.frames > 0)
        self._show_headline(overview)
        self._statuses.replace([_status_line(s) for s in overview.statuses])
        self._classes.replace([_class_line(c, overview.frames) for c in overview.classes])
        self._tables.setMinimumWidth(max(width_needed(view) for view in self._views))
        if self.isVisible():
            self._show_plots()
        # Else figures longer than those before are cut until the next turn.
        for part in (*self._figures.values(), self._page):
            if (layout := part.layout()) is not None:
                layout.activate()

    def showEvent(self, event: QShowEvent) -> None:
        self._show_plots()
        super().showEvent(event)

    # --- assembly -------------------------------------------------------------------------

    def _make_page(self) -> QWidget:
        self._figures = {
            name: _Figure(name)
            for name in ("frames", "progress", "time", "median_time", "jac", "comments")
        }
        headline = QHBoxLayout()
        for figure in self._figures.values():
            headline.addWidget(figure)
            headline.addStretch(1)
        headline.setSpacing(12)
        self._progress = QProgressBar()
        self._progress.setObjectName("overview_progress_bar")
        self._progress.setRange(0, 1000)
        self._progress.setAccessibleName(tr("Share of frames that are done or approved"))
        self._progress.setTextVisible(False)
        self._progress.setFixedHeight(8)
        self._statuses = FiguresModel(_STATUS_HEADERS, _STATUS_TIPS, _BAR)
        self._classes = FiguresModel(_CLASS_HEADERS, _CLASS_TIPS, _BAR)
        statuses = figures_view(self._statuses, "overview_statuses", tr("Frames by status"))
        classes = figures_view(self._classes, "overview_classes", tr("Frames and points by class"))
        rows = statuses.verticalHeader().defaultSectionSize() * 5
        statuses.setFixedHeight(rows + statuses.horizontalHeader().sizeHint().height() + 4)
        self._views = (statuses, classes)
        self._tables = QWidget()
        column = QVBoxLayout(self._tables)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(statuses)
        column.addWidget(classes, 1)
        self._halves = QSplitter(Qt.Orientation.Horizontal)
        self._halves.setChildrenCollapsible(False)
        self._halves.addWidget(self._tables)
        page = QWidget()
        layout = QVBoxLayout(page)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addLayout(headline)
        layout.addWidget(self._progress)
        layout.addWidget(self._halves, 1)
        return page

    def _show_plots(self) -> None:
        if self._overview is None or not self._overview.frames:
            return
        if self._plots is None:
            self._plots = OverviewPlots()
            self._halves.addWidget(self._plots)
            self._halves.setStretchFactor(0, 0)
            self._halves.setStretchFactor(1, 1)
        self._plots.show_overview(self._overview)

    def _show_headline(self, overview: SetOverview) -> None:
        figures = self._figures
        origins = ", ".join(f"{tr(kind, 'points')} {points:,}" for kind, points in overview.origins)
        points = tr_count(overview.points, "{n:,} point", "{n:,} points")
        figures["frames"].show_figure(
            f"{overview.frames:,}",
            tr_count(overview.frames, "frame, {points}", "frames, {points}", points=points),
            tr("Points by origin: {origins}", origins=origins) if origins else "",
        )
        figures["progress"].show_figure(whole_percent(overview.progress), tr("done or approved"))
        self._progress.setValue(int(1000 * (overview.progress or 0.0)))
        times = overview.times
        figures["time"].show_figure(
            duration(times.total if times.frames else None),
            tr_count(times.frames, "on {n:,} frame", "on {n:,} frames")
            if times.frames
            else tr("no time taken yet"),
        )
        figures["median_time"].show_figure(duration(times.median), tr("a frame (median)"))
        jac = overview.median_jac
        figures["jac"].show_figure(
            DASH if jac is None else f"{jac:.3f}", tr("median JaC of {n:,}", n=overview.scored)
        )
        figures["comments"].show_figure(
            f"{overview.open_comments:,}",
            tr_count(overview.comments, "of {n:,} comment open", "of {n:,} comments open"),
            tr_count(overview.frames_with_open_comments, "In {n:,} frame", "In {n:,} frames"),
        )


def _status_line(figures: StatusFigures) -> FigureRow:
    times = figures.times
    return FigureRow(
        (
            tr(figures.status, "a frame"),
            f"{figures.frames:,}",
            whole_percent(figures.share),
            duration(times.median),
            duration(times.total if times.frames else None),
        ),
        figures.share,
    )


def _class_line(figures: ClassFigures, frames: int) -> FigureRow:
    share = figures.frames / frames if frames else 0.0
    texts = (tr(figures.title), f"{figures.frames:,}", whole_percent(share), f"{figures.points:,}")
    return FigureRow(texts, share, figures.name.strip() if figures.title != figures.name else "")
