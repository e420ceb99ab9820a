"""The list of camera sources: one row each, and one for no camera at all."""

from __future__ import annotations

from itertools import islice, takewhile
from weakref import WeakKeyDictionary

from PySide6.QtWidgets import QButtonGroup, QRadioButton, QVBoxLayout, QWidget

from procc_annotator.camera.base import projects_only_ground
from procc_annotator.gui.panels.cameras.source_row import SourceRow
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.document import Document
from procc_annotator.interact.hints import counted
from procc_annotator.io.camera_files.fitted_on import FITTED
from procc_annotator.session.dataset.camera_set import FrameCameras
from procc_annotator.session.dataset.workspace import Workspace

NO_CAMERA = -1
_NO_CAMERA_ID = -2  # -1 asks Qt for a number of its own

_COMPLETENESS = "Frames of this dataset that have a camera (completeness)"
_FITTED_TIP = (
    "Frames visited in this window whose clicks gave a camera; their JaC is of the clicks that the"
    " fit was made from.\nprocc-annotator calibrate fits and scores the whole set"
)
_FOLLOWED_TIP = (
    "Frames of this dataset that were followed through their shot and have a camera.\n"
    "procc-annotator track follows a whole video and writes its cameras"
)
_NAMED = 12  # unreadable cameras in a tip
_Counted = tuple[
    Workspace, FrameCameras, int
]  # what was counted, and how many were known as damaged


class SourceList(QWidget):
    """Displays the document's sources and does with them what hands want."""

    def __init__(self, document: Document, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document = document
        self._listed: tuple[CameraSource, ...] = ()
        self.rows: list[SourceRow] = []
        self._counted: WeakKeyDictionary[CameraSource, tuple[_Counted, int]] = WeakKeyDictionary()
        self._group = QButtonGroup(self)
        self.none = QRadioButton("no camera")
        self.none.setObjectName("cameras_none")
        self.none.setToolTip("Judge nothing, draw no camera")
        self.none.clicked.connect(lambda: document.set_active_camera(NO_CAMERA))
        self._group.addButton(self.none, _NO_CAMERA_ID)
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._layout.setSpacing(2)
        self._layout.addWidget(self.none)

    def refresh(self) -> None:
        """Show the sources as they are now."""
        sources = tuple(self._document.sources)
        if sources != self._listed:
            self._build(sources)
        self.none.setVisible(bool(sources))
        self.none.setChecked(self._document.active_source is None)
        for row, source in zip(self.rows, sources, strict=True):
            row.show_source(source)
            self._show_state(row, source)

    def _build(self, sources: tuple[CameraSource, ...]) -> None:
        """Rows in front that stay the same are kept: a name may be typed into one just now."""
        pairs = zip(self._listed, sources, strict=False)
        kept = len(tuple(takewhile(lambda pair: pair[0] is pair[1], pairs)))
        self._listed = sources
        for row in self.rows[kept:]:
            self._group.removeButton(row.radio)
            self._layout.removeWidget(row)
            row.deleteLater()
        del self.rows[kept:]
        for index, source in enumerate(sources[kept:], start=kept):
            row = SourceRow(index, source)
            self._group.addButton(row.radio, index)
            self._connect(row, source)
            self._layout.insertWidget(index, row)
            self.rows.append(row)

    def _connect(self, row: SourceRow, source: CameraSource) -> None:
        document = self._document
        row.activated.connect(lambda: self._activate(source))
        row.renamed.connect(lambda name: document.rename_source(source, name))
        row.recoloured.connect(lambda colour: document.set_source_colour(source, colour))
        row.shown.connect(lambda shown: document.set_source_visible(source, shown))
        row.removed.connect(lambda: self._remove(source))

    def _activate(self, source: CameraSource) -> None:
        if self._document.active_source is not source:
            self._document.set_active_camera(self._document.sources.index(source))

    def _remove(self, source: CameraSource) -> None:
        if source is self._document.shot_track.source:
            self._document.shot_track.forget()
        elif source.files is None:
            self._document.live_fit.set_wanted(False)
        else:
            self._document.remove_camera_set(self._document.sources.index(source))

    # --- what a row says -----------------------------------------------------------------------

    def _show_state(self, row: SourceRow, source: CameraSource) -> None:
        document = self._document
        jac, tip = self._jac(source)
        matched, matched_tip = self._matched(source)
        row.show_state(
            active=source is document.active_source,
            jac=jac,
            jac_tip=tip,
            model=self._model(source),
            matched=matched,
            matched_tip=matched_tip,
            problem=self._problem(source),
        )

    def _jac(self, source: CameraSource) -> tuple[str, str]:
        """Mean JaC of the set, and what it is the mean of."""
        document = self._document
        if document.blind:
            return "JaC –", "Blind mode hides how the sources do"
        mean = source.mean_jac(document.tau)
        if mean is None:
            return "JaC –", "No frame has both annotated elements and a camera of this source"
        frames = counted(len(source.audits), "frame")
        so_far = " so far" if document.set_scores.running else ""
        tip = f"Mean JaC at {document.tau:.1f} px over {frames}{so_far}"
        if bad := len(source.problems):
            tip += f"; {counted(bad, 'camera')} cannot be read and take no part"
        return f"JaC {mean:.3f}", f"{tip}\n{document.setup.describe()}"

    def _model(self, source: CameraSource) -> str:
        """The camera model: of the set when it has one, else of the frame on screen."""
        models = source.models
        known = self._document.source_frames.of(source)
        camera = known.camera if known is not None else None
        ground = " (ground)" if camera is not None and projects_only_ground(camera) else ""
        mark = f", {FITTED}" if source.fitted else ""
        if len(models) == 1:
            return models[0] + ground + mark
        if known is None or camera is None:
            return f"several models{mark}" if models else ""
        return known.model + ground + (" here, several models" if models else "") + mark

    def _matched(self, source: CameraSource) -> tuple[str, str]:
        """How many frames have a camera, and which of these cannot be used."""
        workspace, cameras = self._document.workspace, source.camera_set
        if source is self._document.shot_track.source:
            return f"{counted(len(cameras.frames), 'frame')} followed", _FOLLOWED_TIP
        if source.files is None:
            return f"{counted(len(cameras.frames), 'frame')} fitted", _FITTED_TIP
        if workspace is None or not workspace.frames:
            return counted(len(cameras.frames), "camera"), ""
        of = workspace, cameras, len(source.problems)
        before, matched = self._counted.get(source, (None, 0))
        if before != of:  # counting a large set takes a while
            matched = source.matched(frame.name for frame in workspace.frames)
            self._counted[source] = of, matched
        total = len(workspace.frames)
        share = f"{100 * matched / total:.0f} %"
        if not source.problems:
            return f"{matched} of {total} ({share})", _COMPLETENESS
        bad, named = len(source.problems), islice(source.problems, _NAMED)
        names = ", ".join(named) + (f" and {bad - _NAMED:,} more" * (bad > _NAMED))
        tip = f"{_COMPLETENESS}: {share}\nUnreadable (filter camera:unreadable): {names}"
        return f"{matched} of {total}, {bad} unreadable", tip

    def _problem(self, source: CameraSource) -> str:
        """Why a source that is not judged has nothing to show of this frame; the panel's notes say
        it of the active one."""
        document = self._document
        known = document.source_frames.of(source)
        if known is None or source is document.active_source:
            return ""
        if source.files is None:
            return known.notice if document.projection_visible and not known.camera else ""
        if known.error:
            return f"cannot be used here: {known.error}"
        return "no camera for this frame" if known.camera is None else ""
