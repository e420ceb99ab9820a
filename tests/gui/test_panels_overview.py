"""The overview window: figures that are those of the set, plots on demand, both themes."""

from __future__ import annotations

import subprocess
import sys

import pytest
from PySide6.QtCore import QModelIndex, Qt
from PySide6.QtGui import QColor, QPalette
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QProgressBar, QPushButton, QTableView
from pytestqt.qtbot import QtBot

from procc_annotator.field.load import load_field
from procc_annotator.gui.panels.overview.dialog import OverviewWindow
from procc_annotator.gui.panels.overview.plots import count_ticks, time_ticks
from procc_annotator.gui.panels.overview.tables import duration, whole_percent, width_needed
from procc_annotator.gui.theme import palette
from procc_annotator.report.window_tables import OverviewRow, SetOverview, TimeHistogram, summarise
from tests.gui.conftest import all_done

FIELD = load_field("soccer")


def _overview(scale: int = 1, *, seconds: float = 40.0) -> SetOverview:
    def row(status: str, classes: dict[str, int], seconds: float, jac: float | None) -> OverviewRow:
        points = {"hand": sum(classes.values())} if classes else {}
        return OverviewRow("f", status, classes, seconds, len(classes), 1, jac, points)

    rows = [
        row("untouched", {}, 0.0, None),
        row("done", {"Circle left": 5, "Corner flag": 1}, seconds, 0.5),
        row("approved", {"Circle left": 4}, 2 * seconds, 1.0),
        row("rejected", {"Middle line": 2}, 3 * seconds, 0.0),
    ]
    return summarise(rows * scale, FIELD)


@pytest.fixture
def window(qtbot: QtBot) -> OverviewWindow:
    window = OverviewWindow()
    qtbot.addWidget(window)
    window.resize(900, 600)
    return window


def _shown(window: OverviewWindow, qtbot: QtBot, overview: SetOverview) -> OverviewWindow:
    window.show_overview(overview)
    with qtbot.waitExposed(window):
        window.show()
    return window


def _text(window: OverviewWindow, name: str) -> str:
    label = window.findChild(QLabel, name)
    assert label is not None
    return label.text()


def _table(window: OverviewWindow, name: str) -> dict[str, list[str]]:
    view = window.findChild(QTableView, name)
    assert view is not None
    model = view.model()
    lines = [
        [model.index(r, c, QModelIndex()).data() for c in range(model.columnCount())]
        for r in range(model.rowCount())
    ]
    return {line[0]: line[1:] for line in lines}


def test_the_window_shows_the_figures_of_the_set(window: OverviewWindow, qtbot: QtBot) -> None:
    _shown(window, qtbot, _overview())
    assert _text(window, "overview_frames") == "4"
    assert _text(window, "overview_progress") == "50 %"
    assert _text(window, "overview_time") == "4 min 00 s"
    assert _text(window, "overview_median_time") == "1 min 20 s"
    assert _text(window, "overview_jac") == "0.500"
    assert _text(window, "overview_comments") == "4"
    bar = window.findChild(QProgressBar, "overview_progress_bar")
    assert bar is not None
    assert bar.value() == bar.maximum() // 2
    statuses = _table(window, "overview_statuses")
    assert list(statuses) == ["untouched", "in progress", "done", "approved", "rejected"]
    assert statuses["done"] == ["1", "25 %", "40 s", "40 s"]
    assert statuses["in progress"] == ["0", "0 %", "–", "–"]
    classes = _table(window, "overview_classes")
    assert len(classes) == len(FIELD.elements) + 1
    assert classes["Left penalty arc"] == ["2", "50 %", "9"]
    assert classes["Corner flag"] == ["1", "25 %", "1"]
    assert classes["Right penalty arc"] == ["0", "0 %", "0"]


def test_bars_are_as_high_as_the_counts_and_follow_new_figures(
    window: OverviewWindow, qtbot: QtBot
) -> None:
    _shown(window, qtbot, _overview())
    plots = window._plots
    assert plots is not None
    assert plots.statuses.bars.opts["height"] == [1, 0, 1, 1, 1]
    assert plots.elements.bars.opts["height"] == [1, 2, 1]
    assert sum(plots.times.bars.opts["height"]) == 3
    assert plots.times.caption.text() == "Time per frame in minutes"
    window.show_overview(_overview(1000))
    assert window._plots is plots
    assert plots.statuses.bars.opts["height"] == [1000, 0, 1000, 1000, 1000]
    assert _text(window, "overview_frames") == "4,000"


def test_longer_figures_are_not_cut_even_for_a_moment(window: OverviewWindow, qtbot: QtBot) -> None:
    _shown(window, qtbot, summarise([], FIELD))
    window.show_overview(_overview(1000, seconds=4000.0))
    for name in ("frames", "progress", "time", "median_time", "jac", "comments"):
        figure = window._figures[name]
        for label in (figure.value, figure.caption):
            assert label.width() >= label.sizeHint().width(), label.text()
    plots = window._plots
    assert plots is not None
    axis = plots.statuses.plot.getPlotItem().getAxis("bottom")
    assert axis.height() >= 2 * plots.fontMetrics().height()  # "in progress" has two lines


def test_names_of_statuses_lie_side_by_side_however_small_the_window(
    window: OverviewWindow, qtbot: QtBot
) -> None:
    _shown(window, qtbot, _overview(1000))
    window.resize(window.minimumSizeHint())
    all_done(qtbot)
    plots = window._plots
    assert plots is not None
    view = plots.statuses.plot.getPlotItem().vb
    apart = view.width() / (view.viewRange()[0][1] - view.viewRange()[0][0])
    metrics = plots.statuses.fontMetrics()
    assert apart > max(metrics.horizontalAdvance(w) for w in ("untouched", "approved", "progress"))


def test_without_times_the_plot_says_so(window: OverviewWindow, qtbot: QtBot) -> None:
    _shown(window, qtbot, _overview(seconds=0.0))
    note = window.findChild(QLabel, "overview_times_plot_empty")
    assert note is not None
    assert note.isVisible()
    assert "No time yet" in note.text()
    assert _text(window, "overview_time") == "–"
    window.show_overview(_overview())
    assert not note.isVisible()


def test_an_empty_set_has_an_explanation_and_no_export(
    window: OverviewWindow, qtbot: QtBot
) -> None:
    _shown(window, qtbot, summarise([], FIELD))
    note = window.findChild(QLabel, "overview_empty")
    button = window.findChild(QPushButton, "overview_export")
    assert note is not None
    assert button is not None
    assert note.isVisible()
    assert not button.isEnabled()
    assert window._plots is None
    window.show_overview(_overview())
    assert not note.isVisible()
    assert button.isEnabled()
    assert window._plots is not None
    window.show_overview(summarise([], FIELD))
    assert note.isVisible()


def test_the_button_asks_for_an_export_and_enter_does_not(
    window: OverviewWindow, qtbot: QtBot
) -> None:
    _shown(window, qtbot, _overview())
    button = window.findChild(QPushButton, "overview_export")
    assert button is not None
    with qtbot.waitSignal(window.exportRequested):
        qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert window.isVisible()
    with qtbot.assertNotEmitted(window.exportRequested):
        QTest.keyClick(window, Qt.Key.Key_Return)
    assert not window.isVisible()  # Enter presses Close


@pytest.mark.parametrize("scale", [1, 3000])
def test_nothing_is_cut_off_at_900_by_600(window: OverviewWindow, qtbot: QtBot, scale: int) -> None:
    _shown(window, qtbot, _overview(scale, seconds=500.0))
    assert (window.width(), window.height()) == (900, 600)
    for name in ("overview_statuses", "overview_classes"):
        view = window.findChild(QTableView, name)
        assert view is not None
        assert view.width() >= width_needed(view)
        assert not view.horizontalScrollBar().isVisible()
    statuses = window.findChild(QTableView, "overview_statuses")
    assert statuses is not None
    assert not statuses.verticalScrollBar().isVisible()
    for label in window.findChildren(QLabel):
        if label.isVisible() and not label.wordWrap():
            assert label.width() >= label.sizeHint().width(), label.text()
    assert window._plots is not None
    assert window._plots.width() >= 300


@pytest.mark.parametrize("dark", [False, True])
def test_colours_follow_the_theme(window: OverviewWindow, qtbot: QtBot, dark: bool) -> None:
    _shown(window, qtbot, _overview())
    window.setPalette(palette(not dark))
    window.grab()  # what a plot paints now must not stay
    window.setPalette(palette(dark))
    expected = palette(dark)
    plots = window._plots
    assert plots is not None
    ground = plots.elements.plot.grab().toImage().pixelColor(1, 1)
    assert ground == expected.color(QPalette.ColorRole.Window)
    axis = plots.elements.plot.getPlotItem().getAxis("left")
    assert axis.textPen().color() == expected.color(QPalette.ColorRole.Text)
    brush = plots.elements.bars.opts["brush"]
    assert QColor(brush.color()) == expected.color(QPalette.ColorRole.Highlight)
    picture = window.grab().toImage()
    table = window.findChild(QTableView, "overview_classes")
    assert table is not None
    corner = table.mapTo(window, table.viewport().geometry().topRight())
    assert picture.pixelColor(1, 1) == expected.color(QPalette.ColorRole.Window)
    # the bar's track of an unused class ends before the figures; beside them is the table's base
    assert picture.pixelColor(corner.x() - 1, corner.y() + 1) == expected.color(
        QPalette.ColorRole.Base
    )


def test_pyqtgraph_is_not_imported_before_the_window_is_shown() -> None:
    code = (
        "import sys; from PySide6.QtWidgets import QApplication; app = QApplication([]);"
        "from procc_annotator.gui.panels.overview.dialog import OverviewWindow; OverviewWindow();"
        "sys.exit('pyqtgraph' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@pytest.mark.parametrize(
    ("seconds", "words"),
    [
        (None, "–"),
        (0.0, "0.0 s"),
        (9.94, "9.9 s"),
        (9.96, "10 s"),
        (59.4, "59 s"),
        (59.6, "1 min 00 s"),
        (3599.4, "59 min 59 s"),
        (3600.0, "1 h 00 min"),
        (50 * 3600 + 65.0, "50 h 01 min"),
    ],
)
def test_durations(seconds: float | None, words: str) -> None:
    assert duration(seconds) == words


@pytest.mark.parametrize(
    ("share", "words"),
    [
        (None, "–"),
        (0.0, "0 %"),
        (0.001, "< 1 %"),
        (0.5, "50 %"),
        (0.9999, "> 99 %"),
        (1.0, "100 %"),
    ],
)
def test_shares(share: float | None, words: str) -> None:
    assert whole_percent(share) == words


def test_ticks_are_round() -> None:
    assert count_ticks(0) == [(0.0, "0")]
    assert [t for _, t in count_ticks(3)] == ["0", "1", "2", "3"]
    assert [t for _, t in count_ticks(4358)] == ["0", "2,000", "4,000"]
    assert [t for _, t in count_ticks(9)] == ["0", "5"]
    ticks, unit = time_ticks(TimeHistogram(15, (1,) * 20, True))
    assert unit == "minutes"
    assert ticks == [(0.0, "0"), (4.0, "1"), (8.0, "2"), (12.0, "3"), (16.0, "4"), (20.0, "5")]
    ticks, unit = time_ticks(TimeHistogram(1, (3, 1), False))
    assert (ticks, unit) == ([(0.0, "0"), (1.0, "1"), (2.0, "2")], "seconds")
