"""The camera sources to judge and compare, and how they are judged."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QFileDialog,
    QFormLayout,
    QGridLayout,
    QLabel,
    QWidget,
)

from procc_annotator.formats.cameras.registry import format_titles, suffixes_of
from procc_annotator.gui.panels.camera_sources import SourceList, colour_icon
from procc_annotator.gui.panels.widgets import (
    Panel,
    ScrolledContent,
    box_of,
    caption,
    choice,
    empty_state,
    hbox,
    make_button,
    make_label,
    note_label,
    scrolling,
    show_note,
    vbox,
)
from procc_annotator.gui.state.availability import as_sentence, hidden
from procc_annotator.gui.state.maps import Compared
from procc_annotator.gui.state.selectors import judged
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import fixed_width
from procc_annotator.metrics.error_maps import OFFSIDE_ACCURACY_M, MapSummary
from procc_annotator.metrics.setup import OFF_PLANE, PROTOCOLS
from procc_annotator.translation import tr, word

_FIGURES = ("minimum", "median", "maximum")


class ComparingSection(QWidget):
    """Part of the cameras panel; there only while there is something to compare."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._services = services
        self.other = choice(
            "cameras_compared",
            tr("Source to compare with"),
            tip=tr("Held against the active source: comma, split view, disagreement"),
            chosen=services.camera_sources.compare_with,
        )
        self._boxes = hbox()
        self.figures = _Figures()
        self.problem = note_label("disagreement_problem")
        choose = caption(tr("Compare with"), self.other)
        vbox(
            choose,
            self._boxes,
            self.figures,
            self.problem,
            of=self,
            spacing=4,
            margins=(0, 4, 0, 0),
        )

    def add_actions(self, *actions: QAction) -> None:
        """Offer these as boxes to be ticked."""
        for action in actions:
            self._boxes.addWidget(box_of(action, f"cameras_{action.objectName()}"))

    def refresh(self) -> None:
        """Show the choice and the figures as they are now."""
        services = self._services
        compared = services.state.compared
        others = [s for s in services.state.sources if s is not services.state.active]
        self.other.clear()
        for source in others:
            icon = colour_icon(source.colour, self.devicePixelRatioF())
            self.other.addItem(icon, source.name, source)
        self.other.setCurrentIndex(others.index(compared) if compared is not None else -1)
        self.other.setEnabled(compared is not None)
        wanted = compared is not None or services.disagreement.enabled
        self.setVisible(wanted and bool(services.state.sources))
        self.figures.show_found(services.disagreement.value)
        show_note(self.problem, services.disagreement.problem)


class _Figures(QWidget):
    """Least, median and largest disagreement, in metres and in pixels."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("disagreement_figures")
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(10)
        grid.setVerticalSpacing(1)
        self._values: dict[tuple[str, str], QLabel] = {}
        right = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        for column, title in enumerate((tr("min"), tr("median"), tr("max")), start=1):
            grid.addWidget(make_label(title, faint=True), 0, column, right)
        for row, (unit, tip) in enumerate(
            (
                ("m", tr("Between the two points on the ground that a pixel means")),
                ("px", tr("From a pixel to where the compared camera shows its ground point")),
            ),
            start=1,
        ):
            words = tr("on the ground, m") if unit == "m" else tr("in the picture, px")
            grid.addWidget(make_label(words, tip=tip, faint=True), row, 0)
            for column, figure in enumerate(_FIGURES, start=1):
                name, font = f"disagreement_{figure}_{unit}", fixed_width(self.font())
                self._values[unit, figure] = make_label(name=name, tip=tip, font=font)
                grid.addWidget(self._values[unit, figure], row, column, right)
        grid.setColumnStretch(0, 1)
        self.within = make_label(name="disagreement_within", wrap=True)
        grid.addWidget(self.within, 3, 0, 1, 4)
        self.hide()

    def show_found(self, found: Compared | None) -> None:
        """Show the figures of a comparison; without any they take no room."""
        share = found.values.share_within(OFFSIDE_ACCURACY_M) if found is not None else None
        self.setVisible(share is not None)
        if found is None or share is None:
            return
        statistics = found.values.statistics
        self._show_spread("m", statistics.metres, 2)
        self._show_spread("px", statistics.pixels, 1)
        covered = found.values.compared_share
        self.within.setText(
            tr(
                "{share:.0f} % within {far:g} m, over {covered:.0f} % of the picture",
                share=100 * share,
                far=OFFSIDE_ACCURACY_M,
                covered=100 * covered,
            )
        )

    def _show_spread(self, unit: str, spread: MapSummary, decimals: int) -> None:
        for figure in _FIGURES:
            value = getattr(spread, figure)
            self._values[unit, figure].setText("–" if value is None else f"{value:.{decimals}f}")


PROTOCOL_TITLES = {
    "soccernet": word("soccernet (official)"),
    "procc": word("procc (paper)"),
}
OFF_PLANE_TITLES = {"missed": word("count as missed"), "left_out": word("are left out")}

_SPELLED = ".homographyMatrix"  # as it is always written; not every file dialog ignores case


class CamerasPanel(Panel):
    """Loaded sources with the active one marked; loading; comparing; protocol; what is wrong."""

    def __init__(self, services: Services) -> None:
        super().__init__(services, "cameras_panel", (300, 280))
        self._build()
        self._follow(
            lambda s: (judged(s), s.looks, s.compared, s.blind),
            services.store.events.sourceAuditsChanged,
            services.source_frames.changed,
            services.disagreement.changed,
        )

    # --- building ------------------------------------------------------------------------------

    def _build(self) -> None:
        self.empty = empty_state(
            tr(
                "No cameras loaded.\nLoad a folder of camera files or homographies "
                "to see them judged against your clicks."
            ),
            "cameras_empty",
        )
        self.list = SourceList(self._services)
        self.comparing = ComparingSection(self._services)
        self.notice = note_label("cameras_notice")
        self.error = note_label("cameras_error")
        self.load_folder = make_button(
            tr("Load folder…"),
            self.choose_folder,
            "cameras_load_folder",
            tip=tr("A folder with one camera file a frame"),
            wide=True,
        )
        self.load_file = make_button(
            tr("Load file…"),
            self.choose_file,
            "cameras_load_file",
            tip=tr("A zip archive of cameras, or the camera of one frame"),
            wide=True,
        )
        content = ScrolledContent()
        vbox(
            self.empty,
            self.list,
            self.notice,
            self.error,
            self.comparing,
            hbox(self.load_folder, self.load_file),
            self._build_form(),
            None,
            of=content,
            margins=6,
        )
        vbox(scrolling(content), of=self, margins=0)

    def _build_form(self) -> QFormLayout:
        evaluation = self._services.evaluation
        self.format = choice("cameras_format", tip=tr("How the files loaded next are read"))
        self.protocol = choice(
            "cameras_protocol",
            tip=tr(
                "soccernet: the official evaluation with its quirks\n"
                "procc: the paper's definition, closed circles and fine curves"
            ),
            items=[(tr(PROTOCOL_TITLES[name]), name) for name in PROTOCOLS],
            chosen=evaluation.set_protocol,
        )
        self.off_plane = choice(
            "cameras_off_plane",
            tip=tr("A homography knows the ground only: how posts and crossbars count for it"),
            items=[(tr(OFF_PLANE_TITLES[name]), name) for name in OFF_PLANE],
            chosen=lambda value: evaluation.set_protocol(off_plane=value),
        )
        form = QFormLayout()
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.addRow(tr("Read as"), self.format)
        form.addRow(tr("Protocol"), self.protocol)
        form.addRow(tr("Off the ground"), self.off_plane)
        return form

    # --- loading -------------------------------------------------------------------------------

    def choose_folder(self) -> None:
        """Ask for a folder of cameras and load it."""
        chosen = QFileDialog.getExistingDirectory(self, tr("Load a folder of cameras"))
        if chosen:
            self.load(Path(chosen))

    def choose_file(self) -> None:
        """Ask for an archive or a single camera and load it."""
        endings = " ".join(f"*{suffix}" for suffix in (*sorted(suffixes_of()), _SPELLED, ".zip"))
        kinds = tr("Cameras ({endings});;All files (*)", endings=endings)
        chosen, _ = QFileDialog.getOpenFileName(self, tr("Load cameras"), "", kinds)
        if chosen:
            self.load(Path(chosen))

    def load(self, path: Path) -> None:
        """Load cameras as the chosen format says; what goes wrong is reported in a message."""
        self._offer_formats()
        self._services.camera_sources.load_cameras(path, self.format.currentData())

    def _offer_formats(self) -> None:
        """Those of this program and of plug-ins, which are looked for when they can be chosen."""
        if self.format.count() == 0:
            for name, title in format_titles().items():
                self.format.addItem(tr(title), name)

    # --- showing -------------------------------------------------------------------------------

    def _refresh(self) -> None:
        self._offer_formats()
        self.list.refresh()
        self.empty.setVisible(not self._services.state.sources)
        self.comparing.refresh()
        self._show_details()
        setup = self._services.state.setup
        self.protocol.setCurrentIndex(self.protocol.findData(setup.protocol))
        self.off_plane.setCurrentIndex(self.off_plane.findData(setup.off_plane))

    def _show_details(self) -> None:
        services = self._services
        notice, error = services.scorer.shown.notice, services.scorer.shown.error
        notice = tr("This frame: {notice}", notice=notice) if notice else ""
        if services.state.active_cameras is None:
            notice = error = ""
        elif not services.state.projection_visible:
            notice, error = as_sentence(hidden(services.state)), ""
        show_note(self.notice, notice)
        if error:
            error = tr("⚠ This frame's camera cannot be used: {error}", error=error)
        show_note(self.error, error)
