"""The plots of the real window: what they show, where a click leads, what can be taken along."""

import csv
import io
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QGuiApplication, QImage, QPainter, QPalette
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from procc_annotator.formats.cameras.fit_record import FitCounts
from procc_annotator.gui import theme
from procc_annotator.gui.panels.plots.page import PlotRequest, PlottedSource, dash_of, symbol_of
from procc_annotator.gui.panels.plots.pages import HistogramPage, TauPage, TimelinePage, VectorsPage
from procc_annotator.gui.panels.plots.plots_panel import PlotsPanel
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import contrast, readable
from procc_annotator.interaction.palette import SOURCE_COLOURS
from tests.gui.conftest import all_done

SETS = ("true", "bad", "homography")
PAGES = (TauPage, TimelinePage, HistogramPage, VectorsPage)


@pytest.fixture
def sample(annotated) -> Path:
    """A few frames; classes that need the whole sample have it."""
    return annotated


class Plotted(NamedTuple):
    services: Services
    plots: PlotsPanel


@pytest.fixture
def plotted(open_services, sample, show, qtbot) -> Plotted:
    """Three sources of the sample audited, "bad" active, and the panel; no fit."""
    services = open_services(sample)
    services.live_fit.set_wanted(False)
    for name in SETS:
        assert services.camera_sources.load_cameras(sample / "cameras" / name)
    services.camera_sources.set_active_camera(1)
    services.navigator.go_to(1)
    qtbot.waitUntil(lambda: not services.scoring.running)
    return Plotted(services, opened(services, show))


def opened(services: Services, show: Callable[[PlotsPanel], PlotsPanel]) -> PlotsPanel:
    panel = show(PlotsPanel(services))
    panel.resize(900, 420)
    panel.set_in_sight(True)
    return panel


def turn_to(plotted: Plotted, qtbot: QtBot, page: type, scope: str = "set") -> None:
    panel = plotted.plots
    panel.scope.setCurrentIndex(panel.scope.findData(scope))
    panel.choose(page.title)
    settle(plotted, qtbot)
    assert isinstance(panel.page, page)


def said(plotted: Plotted) -> str:
    return f"{plotted.plots.notes.text()} {plotted.plots.notes.toolTip()}"


def settle(plotted: Plotted, qtbot: QtBot) -> None:
    """Everything asked for is computed and drawn."""
    all_done(qtbot)
    qtbot.waitUntil(lambda: not plotted.plots.busy)
    all_done(qtbot)


def click_at(page: TimelinePage, x: float) -> None:
    """A mouse click on the plot where its axis says x."""
    item = page.item
    low, high = item.vb.viewRange()[1]
    at = page.view.mapFromScene(item.vb.mapViewToScene(QPointF(x, (low + high) / 2)))
    QTest.mouseClick(page.view.viewport(), Qt.MouseButton.LeftButton, pos=at)


def hover_at(page: TimelinePage, x: float) -> None:
    item = page.item
    page.view.scene().sigMouseMoved.emit(item.vb.mapViewToScene(QPointF(x, 0.5)))


def numbers(plotted: Plotted, qtbot: QtBot, path: Path) -> list[dict[str, str]]:
    """What saving the numbers writes."""
    plotted.plots.save_numbers(path)
    qtbot.waitUntil(path.exists)
    all_done(qtbot)
    return list(csv.DictReader(io.StringIO(path.read_bytes().decode())))


class TestTimeline:
    @pytest.fixture
    def sample(self, sample_copy) -> Path:
        return sample_copy

    def test_a_click_shows_the_frame_and_the_mark_follows(self, plotted, qtbot):
        turn_to(plotted, qtbot, TimelinePage)
        page = plotted.plots.page
        for number in (7, 3, 12):
            click_at(page, number)
            assert plotted.services.state.frame_index == number - 1
            qtbot.waitUntil(lambda n=number: page.here.value() == n)
        plotted.services.navigator.go_to(0)
        qtbot.waitUntil(lambda: page.here.value() == 1)

    def test_it_shows_every_score_and_gaps(self, plotted, qtbot, tmp_path):
        turn_to(plotted, qtbot, TimelinePage)
        services = plotted.services
        rows = numbers(plotted, qtbot, tmp_path / "t.csv")
        assert [row["frame"] for row in rows] == [f.name for f in services.state.workspace.frames]
        for source in services.state.sources:
            column = f"jac@5 {source.name}"
            for row in rows:
                audit = source.audits.get(row["frame"])
                if audit is None:
                    assert row[column] == ""
                else:
                    assert float(row[column]) == pytest.approx(audit.jac_at(5.0), abs=1e-5)
        drawn = {s.name: values for s, values, *_ in plotted.plots.page._lines}
        assert np.isnan(drawn["bad"]).sum() == 14 - len(services.state.sources[1].audits) > 0

    def test_hovering_tells_frame_and_values(self, plotted, qtbot):
        turn_to(plotted, qtbot, TimelinePage)
        hover_at(plotted.plots.page, 2.1)
        said = plotted.plots.notes.text()
        jac = plotted.services.state.sources[1].audits["00002"].jac_at(5.0)
        assert said.startswith("00002 (frame 2) · true 1.000")
        assert f"bad {jac:.3f}" in said
        hover_at(plotted.plots.page, 5.0)  # nobody annotated it
        assert "bad –" in plotted.plots.notes.text()

    def test_another_tau_gives_other_values(self, plotted, qtbot):
        turn_to(plotted, qtbot, TimelinePage)
        plotted.services.evaluation.set_tau(20.0)
        settle(plotted, qtbot)
        audits = plotted.services.state.sources[1].audits
        _, values, *_ = next(x for x in plotted.plots.page._lines if x[0].name == "bad")
        assert values[1] == pytest.approx(audits["00002"].jac_at(20.0))
        assert values[1] != pytest.approx(audits["00002"].jac_at(5.0))


class TestTau:
    @pytest.fixture
    def sample(self, sample_copy) -> Path:
        return sample_copy

    def test_the_frames_curves_and_the_line_that_can_be_dragged(self, plotted, qtbot, tmp_path):
        turn_to(plotted, qtbot, TauPage, "frame")
        services, page = plotted.services, plotted.plots.page
        rows = numbers(plotted, qtbot, tmp_path / "t.csv")
        at_5 = next(row for row in rows if row["tau_px"] == "5.0")
        assert float(at_5["jac bad"]) == pytest.approx(services.scorer.score.jac, abs=1e-5)
        assert float(at_5["jac true"]) == 1.0
        assert page.line.isVisible()
        page.line.setValue(8.0)
        page.line.sigDragged.emit(page.line)
        assert services.state.tau == 8.0

    def test_the_sets_curve_is_the_mean(self, plotted, qtbot, tmp_path):
        turn_to(plotted, qtbot, TauPage, "set")
        rows = numbers(plotted, qtbot, tmp_path / "t.csv")
        audits = plotted.services.state.sources[1].audits
        mean = np.mean([a.jac_at(5.0) for a in audits.values()])
        at_5 = next(row for row in rows if row["tau_px"] == "5.0")
        assert float(at_5["jac bad"]) == pytest.approx(mean, abs=1e-5)
        assert float(at_5["low bad"]) < mean < float(at_5["high bad"])
        assert "95 % bands" in plotted.plots.notes.text() + plotted.plots.notes.toolTip()
        assert f"bad ({len(audits)} of 14)" in plotted.plots.legend.text

    def test_bands_rest_on_the_datasets_table_of_frames(self, plotted, qtbot, tmp_path):
        """Names 00001 to 00014 are one shot; the table says that they are of three."""
        turn_to(plotted, qtbot, TauPage, "set")
        assert "not clustered" in said(plotted)
        alone = numbers(plotted, qtbot, tmp_path / "alone.csv")
        names = [frame.name for frame in plotted.services.state.workspace.frames]
        table = plotted.services.state.workspace.folder / "frames.csv"
        rows = [f"{name},{'abc'[place // 5]},{place}" for place, name in enumerate(names)]
        table.write_text("frame,shot,number\n" + "\n".join(rows) + "\n")
        turn_to(plotted, qtbot, TimelinePage, "set")
        turn_to(plotted, qtbot, TauPage, "set")
        assert "3 clusters of one shot each, by frames.csv" in said(plotted)
        clustered = numbers(plotted, qtbot, tmp_path / "clustered.csv")
        at = next(n for n, row in enumerate(alone) if row["tau_px"] == "5.0")
        assert alone[at]["jac bad"] == clustered[at]["jac bad"]
        assert alone[at]["high bad"] != clustered[at]["high bad"]

    def test_a_table_of_frames_that_is_damaged_is_said_and_names_tell(self, plotted, qtbot):
        (plotted.services.state.workspace.folder / "frames.csv").write_text(
            "frame,shot\n1,a\n1,a\n"
        )
        turn_to(plotted, qtbot, TauPage, "set")
        assert "not clustered" in said(plotted)
        assert "Shots are recognized by names, since" in said(plotted)
        assert "line 3: frame '1' again" in said(plotted)

    def test_an_edit_is_seen_at_once(self, plotted, qtbot):
        turn_to(plotted, qtbot, TauPage, "frame")
        services = plotted.services
        before = plotted.plots._data.curves[1].copy()
        services.editing.commit_edit(
            "clear", services.state.annotation.without(services.state.annotation.annotated[0])
        )
        qtbot.waitUntil(lambda: not np.array_equal(plotted.plots._data.curves[1], before))


class TestErrors:
    def test_the_bars_count_every_point(self, plotted, qtbot):
        turn_to(plotted, qtbot, HistogramPage)
        services = plotted.services
        for source, counts in zip(
            services.state.sources, plotted.plots._data.bars.counts, strict=True
        ):
            points = sum(len(audit.errors_px) for audit in source.audits.values())
            assert counts.sum() == points > 0

    def test_one_class_only(self, plotted, qtbot):
        turn_to(plotted, qtbot, HistogramPage)
        panel, services = plotted.plots, plotted.services
        row = services.state.field.index["Middle line"]
        panel.classes.setCurrentIndex(panel.classes.findData(row))
        settle(plotted, qtbot)
        expected = [
            sum(int((a.class_rows == row).sum()) for a in source.audits.values())
            for source in services.state.sources
        ]
        assert [int(c.sum()) for c in panel._data.bars.counts] == expected
        assert (
            0
            < expected[0]
            < sum(len(a.errors_px) for a in services.state.sources[0].audits.values())
        )

    def test_the_numbers_of_a_frame_are_its_points(self, plotted, qtbot, tmp_path):
        turn_to(plotted, qtbot, VectorsPage, "frame")
        rows = [r for r in numbers(plotted, qtbot, tmp_path / "p.csv") if r["source"] == "bad"]
        labelling = plotted.services.scorer.score.labelling
        errors = sorted(float(row["error_px"]) for row in rows)
        assert errors == pytest.approx(sorted(labelling.all_distances), abs=2e-3)
        assert {row["frame"] for row in rows} == {"00002"}
        for row in rows:
            assert np.hypot(float(row["dx_px"]), float(row["dy_px"])) == pytest.approx(
                float(row["error_px"]), abs=1e-4
            )

    def test_arrows_end_on_the_projection_and_can_be_drawn_longer(self, plotted, qtbot):
        turn_to(plotted, qtbot, VectorsPage, "frame")
        page = plotted.plots.page
        page.factor.setCurrentIndex(page.factor.findData(10))
        settle(plotted, qtbot)
        arrows = plotted.plots._data.arrows[1]
        curve = page.items._made["arrows", 1]
        xs, ys = curve.getData()
        tips = np.stack([xs[1::6], ys[1::6]], axis=1)
        assert tips == pytest.approx(arrows.at_px + 10 * arrows.vectors_px, abs=1e-3)
        assert "10 times" in plotted.plots.notes.text()

    @pytest.mark.parametrize("scope", ["frame", "set"])
    def test_numbers_of_residuals_are_those_of_every_point(self, plotted, qtbot, tmp_path, scope):
        turn_to(plotted, qtbot, VectorsPage, scope)
        rows = numbers(plotted, qtbot, tmp_path / "p.csv")
        points = plotted.plots._data.points
        assert len(rows) == sum(len(p.errors_px) for p in points) > 10
        for row in rows:
            assert np.hypot(float(row["dx_px"]), float(row["dy_px"])) == pytest.approx(
                float(row["error_px"]), abs=1e-4
            )


class TestWords:
    def test_without_cameras_and_frames_it_says_what_to_do(
        self, open_services, sample, show, qtbot
    ):
        services = open_services()
        plots = opened(services, show)
        qtbot.waitUntil(lambda: "Open a folder" in plots.empty.text())
        assert plots.empty.isVisible()
        services.opening.open_path(sample)
        qtbot.waitUntil(lambda: "Load cameras" in plots.empty.text())
        assert not plots.more.isEnabled()

    def test_a_frame_without_score_says_so(self, plotted, qtbot):
        plotted.services.navigator.go_to(4)  # nothing is annotated
        for page in (TauPage, HistogramPage, VectorsPage):
            turn_to(plotted, qtbot, page, "frame")
            assert plotted.plots.page.is_empty
            assert plotted.plots.page.empty.text()

    def test_hidden_sources_are_not_plotted(self, plotted, qtbot):
        turn_to(plotted, qtbot, TauPage)
        assert "homography" in plotted.plots.legend.text
        plotted.services.camera_sources.set_source_visible(plotted.services.state.sources[2], False)
        settle(plotted, qtbot)
        assert "homography" not in plotted.plots.legend.text


class TestBlind:
    def test_nothing_of_the_camera_shows_until_a_frame_is_committed(self, plotted, qtbot, tmp_path):
        plotted.services.blind_lock.set_blind(True)
        for page in PAGES:
            for scope in ("frame", "set"):
                turn_to(plotted, qtbot, page, scope)
                assert plotted.plots.page.is_empty, (page.title, scope)
                assert "Hidden: blind mode" in plotted.plots.page.empty.text(), (page.title, scope)
                words = "hidden" if plotted.plots._request.scope == "frame" else "0 committed"
                assert plotted.plots.legend.text == ", ".join(f"{s} ({words})" for s in SETS)
        plotted.services.editing.commit_frame()
        turn_to(plotted, qtbot, TimelinePage)
        rows = numbers(plotted, qtbot, tmp_path / "t.csv")
        assert [row["frame"] for row in rows if row["jac@5 bad"]] == ["00002"]
        turn_to(plotted, qtbot, TauPage, "frame")
        assert not plotted.plots.page.is_empty
        plotted.services.navigator.go_to(2)
        qtbot.waitUntil(lambda: plotted.plots.page.is_empty)


class TestTakingAlong:
    @pytest.mark.parametrize("page", PAGES)
    def test_pictures_and_numbers_of_every_plot(self, plotted, qtbot, tmp_path, page):
        for scope in ("frame", "set"):
            turn_to(plotted, qtbot, page, scope)
            png, svg = tmp_path / f"{scope}.png", tmp_path / f"{scope}.svg"
            plotted.plots.save_picture(png)
            plotted.plots.save_picture(svg)
            qtbot.waitUntil(lambda png=png, svg=svg: png.exists() and svg.exists())
            image = cv2.imread(str(png))
            assert image.shape[1] > 600
            assert len(np.unique(image[::5, ::5] @ (1, 256, 65536))) > 3
            text = svg.read_text()
            assert page.title in text
            assert "bad" in text
            assert numbers(plotted, qtbot, tmp_path / f"{scope}.csv")

    def test_the_clipboard(self, plotted, qtbot):
        turn_to(plotted, qtbot, HistogramPage)
        plotted.plots.copy_numbers()
        qtbot.waitUntil(lambda: "points bad" in QGuiApplication.clipboard().text())
        plotted.plots.copy_picture()
        assert not QGuiApplication.clipboard().image().isNull()

    def test_another_plots_numbers_are_never_taken_for_this_ones(self, plotted, qtbot, tmp_path):
        turn_to(plotted, qtbot, HistogramPage)
        turn_to(plotted, qtbot, TimelinePage)
        plotted.plots.choose(HistogramPage.title)
        with qtbot.waitSignal(plotted.services.store.events.message) as told:
            plotted.plots.save_numbers(tmp_path / "x.csv")
        assert "nothing plotted" in told.args[0].text
        settle(plotted, qtbot)
        assert "points bad" in numbers(plotted, qtbot, tmp_path / "x.csv")[0]

    def test_what_cannot_be_written_is_told(self, plotted, qtbot):
        turn_to(plotted, qtbot, HistogramPage)
        with qtbot.waitSignal(plotted.services.store.events.message) as told:
            plotted.plots.save_numbers(Path("/proc/no such folder/x.csv"))
        assert told.args[0].level == "error"
        assert "x.csv" in told.args[0].text


class TestLooks:
    @pytest.mark.parametrize("dark", [False, True])
    @pytest.mark.parametrize("colour", SOURCE_COLOURS)
    def test_every_source_is_seen_on_both_themes(self, colour, dark):
        palette = theme.palette(dark)
        base = palette.color(QPalette.ColorRole.Base)
        assert contrast(readable(colour, palette), base) >= 3.0

    def test_contrast_is_that_of_the_standard(self):
        assert contrast(QColor("#ffffff"), QColor("#000000")) == pytest.approx(21.0)
        assert contrast(QColor("#777777"), QColor("#ffffff")) == pytest.approx(4.48, abs=0.01)

    def test_axes_follow_the_theme(self, plotted, qtbot, qapp):
        before = qapp.palette()
        turn_to(plotted, qtbot, HistogramPage)
        try:
            for dark in (True, False):
                qapp.setPalette(theme.palette(dark))
                settle(plotted, qtbot)
                axis = plotted.plots.page.item.getAxis("left")
                text = theme.palette(dark).color(QPalette.ColorRole.Text)
                assert axis.textPen().color() == text
        finally:
            qapp.setPalette(before)

    def test_the_ground_follows_the_theme(self, plotted, qtbot, qapp):
        before = qapp.palette()
        turn_to(plotted, qtbot, HistogramPage)
        view = plotted.plots.page.view
        qtbot.waitUntil(view.isVisible)
        try:
            for dark in (True, False, True):
                qapp.setPalette(theme.palette(dark))
                settle(plotted, qtbot)
                ground = view.grab().toImage().pixelColor(2, 2)
                assert theme.is_dark(qapp.palette()) == dark
                assert contrast(ground, view.palette().color(QPalette.ColorRole.Text)) > 7
        finally:
            qapp.setPalette(before)

    def test_pyqtgraph_waits_until_the_plots_are_looked_at(self, make_window, sample, qtbot):
        window = make_window(sample)
        window.services.camera_sources.load_cameras(sample / "cameras" / "bad")
        qtbot.waitUntil(lambda: not window.services.scoring.running)
        all_done(qtbot)
        assert not window.plots._made
        window.panels.show("plots")
        qtbot.waitUntil(lambda: bool(window.plots._made))


def test_a_request_gives_the_frames_in_the_order_of_the_set(qapp):
    class Audit:
        def __init__(self, frame: str) -> None:
            self.frame = frame

    audits = {name: Audit(name) for name in ("c", "a")}
    source = PlottedSource("s", "#ffffff", 0, audits)
    request = PlotRequest((source,), ("a", "b", "c"), 2, "set", None, 5.0, (960, 540))
    assert [a.frame for a in request.audits(source)] == ["a", "c"]


class TestWithoutColour:
    """Colour is never the only sign of a source."""

    def test_no_two_of_many_sources_look_the_same(self):
        sources = [
            PlottedSource(str(i), SOURCE_COLOURS[i % len(SOURCE_COLOURS)], i, {}) for i in range(24)
        ]
        assert len({(s.colour, dash_of(s), symbol_of(s)) for s in sources}) == len(sources)
        assert len({(s.colour, dash_of(s)) for s in sources}) == len(sources)
        for first in range(0, 24, 6):  # those of one round differ in each
            some = sources[first : first + 6]
            assert len({dash_of(s) for s in some}) == len({symbol_of(s) for s in some}) == 6

    def test_lines_too_dense_for_dashes_have_symbols_here_and_there(self, plotted, qtbot):
        turn_to(plotted, qtbot, TimelinePage)
        page = plotted.plots.page
        audits = plotted.services.state.active.audits
        names = tuple(f"f{i}" for i in range(3000))
        known = list(audits.values())
        made = {n: replace(known[i % len(known)], frame=n) for i, n in enumerate(names)}
        sources = tuple(PlottedSource(str(i), "#e4572e", i, made) for i in range(3))
        request = PlotRequest(sources, names, 0, "set", None, 5.0, (960, 540))
        page.draw(page.compute(request), request)
        places = []
        for source, values, line, marks in page._lines:
            assert line.opts["symbol"] is None
            x, y = marks.getData()
            assert 2 <= len(x) <= 30
            assert np.array_equal(y, values[x.astype(int) - 1])
            assert marks.opts["symbol"] == symbol_of(source)
            places.append(set(x))
        assert not places[0] & places[1]

    def test_the_legend_marks_a_fit_to_these_clicks(self, plotted):
        legend = plotted.plots.legend
        source = PlottedSource("fit", "#ff0000", 0, {}, fitted=FitCounts(1))
        legend.show_sources([(source, "(3 of 14)")])
        assert legend.text == "fit (fitted on these clicks) (3 of 14)"

    def test_the_legend_shows_the_symbol(self, plotted, qtbot):
        turn_to(plotted, qtbot, TimelinePage)
        legend = plotted.plots.legend

        def ink(number: int) -> int:
            source = PlottedSource("", "#ff0000", number, {})
            legend.show_sources([(source, "")])
            image = QImage(60, 24, QImage.Format.Format_RGB32)
            image.fill(QColor("#ffffff"))
            painter = QPainter(image)
            legend.paint(painter, 60)
            painter.end()
            pixels = [image.pixelColor(x, y) for x in range(60) for y in range(24)]
            rows = {y for i, c in enumerate(pixels) if c.green() < 128 for y in [i % 24]}
            return len(rows)

        assert ink(0) >= 7  # a line alone is two or three high
        assert ink(1) >= 7
