"""The camera sets to judge against, and how they are judged."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QButtonGroup,
    QComboBox,
    QFileDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QRadioButton,
    QSizePolicy,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from procc_annotator.camera.base import projects_only_ground
from procc_annotator.gui.panels.common import Refresher, empty_state, note_label, show_note
from procc_annotator.gui.state.document import Document
from procc_annotator.io.registry import format_titles, suffixes_of
from procc_annotator.metric.setup import OFF_PLANE, PROTOCOLS
from procc_annotator.session.camera_set import CameraSet

PROTOCOL_TITLES = {
    "soccernet": "soccernet (official)",
    "procc": "procc (paper)",
}
OFF_PLANE_TITLES = {"missed": "count as missed", "left_out": "are left out"}

_NO_CAMERA = -1
_SPELLED = ".homographyMatrix"  # as it is always written; not every file dialog ignores case


class CamerasPanel(QWidget):
    """Loaded sets with the active one marked; loading, removing; protocol; what is wrong here."""

    def __init__(self, document: Document, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("cameras_panel")
        self._document = document
        self._rows: list[QWidget] = []
        self._group = QButtonGroup(self)
        self._group.idClicked.connect(lambda i: document.set_active_camera(max(i, _NO_CAMERA)))
        self._build()
        self._refresher = Refresher(self, self._refresh)
        document.camerasChanged.connect(self._rebuild_soon)
        document.datasetChanged.connect(self._rebuild_soon)
        document.frameChanged.connect(self._refresher.request)
        document.scoreChanged.connect(self._refresher.request)
        document.modeChanged.connect(self._refresher.request)
        self._listed: tuple[object, ...] | None = None

    def sizeHint(self) -> QSize:
        return QSize(300, 280)

    # --- building ------------------------------------------------------------------------------

    def _build(self) -> None:
        self.empty = empty_state(
            "No cameras loaded.\nLoad a folder of SoccerNet camera files or homographies "
            "to see them judged against your clicks.",
            "cameras_empty",
        )
        self._list = QVBoxLayout()
        self._list.setSpacing(2)
        self.notice = note_label("cameras_notice")
        self.error = note_label("cameras_error")
        layout = QVBoxLayout(self)
        layout.setContentsMargins(6, 6, 6, 6)
        layout.addWidget(self.empty)
        layout.addLayout(self._list)
        layout.addWidget(self.notice)
        layout.addWidget(self.error)
        layout.addLayout(self._build_buttons())
        layout.addLayout(self._build_form())
        layout.addStretch(1)

    def _build_buttons(self) -> QHBoxLayout:
        self.load_folder = QPushButton("Load folder…")
        self.load_folder.setObjectName("cameras_load_folder")
        self.load_folder.setToolTip("A folder with one camera file a frame")
        self.load_folder.clicked.connect(self.choose_folder)
        self.load_file = QPushButton("Load file…")
        self.load_file.setObjectName("cameras_load_file")
        self.load_file.setToolTip("A zip archive of cameras, or the camera of one frame")
        self.load_file.clicked.connect(self.choose_file)
        buttons = QHBoxLayout()
        for button in (self.load_folder, self.load_file):
            button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
            buttons.addWidget(button)
        return buttons

    def _build_form(self) -> QFormLayout:
        titles = format_titles()
        self.format = _combo("cameras_format", tuple(titles), titles)
        self.format.setToolTip("How the files loaded next are read")
        self.protocol = _combo("cameras_protocol", PROTOCOLS, PROTOCOL_TITLES)
        self.protocol.setToolTip(
            "soccernet: the official evaluation with its quirks\n"
            "procc: the paper's definition, closed circles and fine curves"
        )
        self.protocol.activated.connect(
            lambda: self._document.set_protocol(self.protocol.currentData())
        )
        self.off_plane = _combo("cameras_off_plane", OFF_PLANE, OFF_PLANE_TITLES)
        self.off_plane.setToolTip(
            "A homography knows the ground only: how posts and crossbars count for it"
        )
        self.off_plane.activated.connect(
            lambda: self._document.set_protocol(off_plane=self.off_plane.currentData())
        )
        form = QFormLayout()
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.addRow("Read as", self.format)
        form.addRow("Protocol", self.protocol)
        form.addRow("Off the ground", self.off_plane)
        return form

    # --- loading -------------------------------------------------------------------------------

    def choose_folder(self) -> None:
        """Ask for a folder of cameras and load it."""
        chosen = QFileDialog.getExistingDirectory(self, "Load a folder of cameras")
        if chosen:
            self.load(Path(chosen))

    def choose_file(self) -> None:
        """Ask for an archive or a single camera and load it."""
        endings = " ".join(f"*{suffix}" for suffix in (*sorted(suffixes_of()), _SPELLED, ".zip"))
        kinds = f"Cameras ({endings});;All files (*)"
        chosen, _ = QFileDialog.getOpenFileName(self, "Load cameras", "", kinds)
        if chosen:
            self.load(Path(chosen))

    def load(self, path: Path) -> None:
        """Load cameras as the chosen format says; what goes wrong is told by the document."""
        self._document.load_cameras(path, self.format.currentData())

    # --- showing -------------------------------------------------------------------------------

    def _rebuild_soon(self) -> None:
        self._listed = None
        self._refresher.request()

    def _refresh(self) -> None:
        if self._listed is None:
            self._list_sets()
            self._listed = tuple(self._document.camera_sets)
        self._show_details()
        setup = self._document.setup
        self.protocol.setCurrentIndex(self.protocol.findData(setup.protocol))
        self.off_plane.setCurrentIndex(self.off_plane.findData(setup.off_plane))

    def _list_sets(self) -> None:
        for row in self._rows:
            self._list.removeWidget(row)
            row.deleteLater()
        for button in self._group.buttons():
            self._group.removeButton(button)
        sets = self._document.camera_sets
        self._rows = [self._row(i, cameras) for i, cameras in enumerate(sets)]
        if sets:
            none = QRadioButton("no camera")
            none.setObjectName("cameras_none")
            self._group.addButton(none, _NO_CAMERA - 1)  # -1 asks Qt for a number of its own
            self._rows.append(none)
        for row in self._rows:
            self._list.addWidget(row)
        active = self._document.active_camera
        index = next((i for i, s in enumerate(sets) if s is active), _NO_CAMERA - 1)
        button = self._group.button(index)
        if button is not None:
            button.setChecked(True)
        self.empty.setVisible(not sets)

    def _row(self, index: int, cameras: CameraSet) -> QWidget:
        row = QWidget()
        radio = _ElidedRadio(cameras.name)
        radio.setObjectName(f"cameras_set_{index}")
        radio.setToolTip(f"Judge against {cameras.name}")
        self._group.addButton(radio, index)
        matched = QLabel(self._matched(cameras))
        matched.setObjectName(f"cameras_matched_{index}")
        matched.setToolTip("Frames of this dataset that have a camera (completeness)")
        remove = QToolButton(autoRaise=True)
        remove.setText("✕")
        remove.setObjectName(f"cameras_remove_{index}")
        remove.setToolTip("Remove from the list; the files stay")
        remove.setAccessibleName(f"Remove {cameras.name}")
        remove.clicked.connect(lambda: self._document.remove_camera_set(index))
        layout = QHBoxLayout(row)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(radio, 1)
        layout.addWidget(matched)
        layout.addWidget(remove)
        return row

    def _matched(self, cameras: CameraSet) -> str:
        workspace = self._document.workspace
        if workspace is None or not workspace.frames:
            count = len(cameras.frames)
            return f"{count} camera" + ("s" if count != 1 else "")
        total = len(workspace.frames)
        matched = sum(frame.name in cameras.frames for frame in workspace.frames)
        return f"{matched} of {total} ({100 * matched / total:.0f} %)"

    def _model(self) -> str:
        """What kind of camera the frame on screen has; empty where it has none or it is hidden."""
        document = self._document
        frame, camera_set = document.frame, document.active_camera
        if document.camera is None or frame is None or camera_set is None:
            return ""
        found = camera_set.camera(frame.name, document.setup.size)  # kept since it was judged
        if found is None:
            return ""
        return found.model + (" (ground plane only)" if projects_only_ground(found.camera) else "")

    def _show_details(self) -> None:
        document = self._document
        notice, error = document.camera_notice, document.camera_error
        if model := self._model():
            notice = f"This frame: {model}" + (f", {notice}" if notice else "")
        if document.active_camera is None:
            notice = error = ""
        elif not document.projection_visible:
            notice, error = "Blind: the projection is hidden until this frame is committed.", ""
        show_note(self.notice, notice)
        show_note(self.error, f"⚠ This frame's camera cannot be used: {error}" if error else "")


class _ElidedRadio(QRadioButton):
    """A radio button whose text gives way in a narrow panel; the tooltip has it in full."""

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self._full = text
        self.setAccessibleName(text)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)

    def resizeEvent(self, event: QResizeEvent) -> None:
        room = event.size().width() - self.iconSize().width() - 12
        elided = self.fontMetrics().elidedText(self._full, Qt.TextElideMode.ElideMiddle, room)
        self.setText(elided.replace("&", "&&"))
        super().resizeEvent(event)


def _combo(name: str, values: tuple[str, ...], titles: dict[str, str]) -> QComboBox:
    combo = QComboBox()
    combo.setObjectName(name)
    combo.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
    combo.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
    combo.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    for value in values:
        combo.addItem(titles.get(value, value), value)
    return combo
