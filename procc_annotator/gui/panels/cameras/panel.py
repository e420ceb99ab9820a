"""The camera sources to judge and compare, and how they are judged."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QSize
from PySide6.QtWidgets import (
    QComboBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.formats.cameras.registry import format_titles, suffixes_of
from procc_annotator.gui.panels.cameras.comparing import ComparingSection
from procc_annotator.gui.panels.cameras.source_list import SourceList
from procc_annotator.gui.panels.parts import (
    ScrolledContent,
    choice,
    empty_state,
    note_label,
    scrolling,
    show_note,
)
from procc_annotator.gui.panels.refresher import Refresher, judged
from procc_annotator.gui.state.document import Document
from procc_annotator.metrics.setup import OFF_PLANE, PROTOCOLS
from procc_annotator.translation import tr, word

PROTOCOL_TITLES = {
    "soccernet": word("soccernet (official)"),
    "procc": word("procc (paper)"),
}
OFF_PLANE_TITLES = {"missed": word("count as missed"), "left_out": word("are left out")}

_SPELLED = ".homographyMatrix"  # as it is always written; not every file dialog ignores case


class CamerasPanel(QWidget):
    """Loaded sources with the active one marked; loading; comparing; protocol; what is wrong."""

    def __init__(self, document: Document, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("cameras_panel")
        self._document = document
        self._build()
        self._refresher = Refresher(self, self._refresh, interval_ms=60)
        self._refresher.follow(
            document.store,
            lambda s: (judged(s), s.looks, s.compared, s.blind),
            document.store.events.sourceAuditsChanged,
            document.source_frames.changed,
            document.disagreement.changed,
        )

    def sizeHint(self) -> QSize:
        return QSize(300, 280)

    # --- building ------------------------------------------------------------------------------

    def _build(self) -> None:
        self.empty = empty_state(
            tr(
                "No cameras loaded.\nLoad a folder of SoccerNet camera files or homographies "
                "to see them judged against your clicks."
            ),
            "cameras_empty",
        )
        self.list = SourceList(self._document)
        self.comparing = ComparingSection(self._document)
        self.notice = note_label("cameras_notice")
        self.error = note_label("cameras_error")
        content = ScrolledContent()
        layout = QVBoxLayout(content)
        layout.setContentsMargins(6, 6, 6, 6)
        layout.addWidget(self.empty)
        layout.addWidget(self.list)
        layout.addWidget(self.notice)
        layout.addWidget(self.error)
        layout.addWidget(self.comparing)
        layout.addLayout(self._build_buttons())
        layout.addLayout(self._build_form())
        layout.addStretch(1)
        around = QVBoxLayout(self)
        around.setContentsMargins(0, 0, 0, 0)
        around.addWidget(scrolling(content))

    def _build_buttons(self) -> QHBoxLayout:
        self.load_folder = QPushButton(tr("Load folder…"))
        self.load_folder.setObjectName("cameras_load_folder")
        self.load_folder.setToolTip(tr("A folder with one camera file a frame"))
        self.load_folder.clicked.connect(self.choose_folder)
        self.load_file = QPushButton(tr("Load file…"))
        self.load_file.setObjectName("cameras_load_file")
        self.load_file.setToolTip(tr("A zip archive of cameras, or the camera of one frame"))
        self.load_file.clicked.connect(self.choose_file)
        buttons = QHBoxLayout()
        for button in (self.load_folder, self.load_file):
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            buttons.addWidget(button)
        return buttons

    def _build_form(self) -> QFormLayout:
        self.format = choice("cameras_format")
        self.format.setToolTip(tr("How the files loaded next are read"))
        self.protocol = _combo("cameras_protocol", PROTOCOLS, PROTOCOL_TITLES)
        self.protocol.setToolTip(
            tr(
                "soccernet: the official evaluation with its quirks\n"
                "procc: the paper's definition, closed circles and fine curves"
            )
        )
        self.protocol.activated.connect(
            lambda: self._document.terms.set_protocol(self.protocol.currentData())
        )
        self.off_plane = _combo("cameras_off_plane", OFF_PLANE, OFF_PLANE_TITLES)
        self.off_plane.setToolTip(
            tr("A homography knows the ground only: how posts and crossbars count for it")
        )
        self.off_plane.activated.connect(
            lambda: self._document.terms.set_protocol(off_plane=self.off_plane.currentData())
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
        """Load cameras as the chosen format says; what goes wrong is reported by the document."""
        self._offer_formats()
        self._document.camera_sources.load_cameras(path, self.format.currentData())

    def _offer_formats(self) -> None:
        """Those of this program and of plug-ins, which are looked for when they can be chosen."""
        if self.format.count() == 0:
            for name, title in format_titles().items():
                self.format.addItem(tr(title), name)

    # --- showing -------------------------------------------------------------------------------

    def _refresh(self) -> None:
        self._offer_formats()
        self.list.refresh()
        self.empty.setVisible(not self._document.state.sources)
        self.comparing.refresh()
        self._show_details()
        setup = self._document.state.setup
        self.protocol.setCurrentIndex(self.protocol.findData(setup.protocol))
        self.off_plane.setCurrentIndex(self.off_plane.findData(setup.off_plane))

    def _show_details(self) -> None:
        document = self._document
        notice, error = document.judge.shown.notice, document.judge.shown.error
        notice = tr("This frame: {notice}", notice=notice) if notice else ""
        if document.state.active_cameras is None:
            notice = error = ""
        elif not document.state.projection_visible:
            notice, error = tr("Blind: the projection is hidden until this frame is committed."), ""
        show_note(self.notice, notice)
        if error:
            error = tr("⚠ This frame's camera cannot be used: {error}", error=error)
        show_note(self.error, error)


def _combo(name: str, values: tuple[str, ...], titles: dict[str, str]) -> QComboBox:
    combo = choice(name)
    for value in values:
        combo.addItem(tr(titles.get(value, value)), value)
    return combo
