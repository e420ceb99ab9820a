"""The list of camera sources: one row each, and one for no camera at all."""

from __future__ import annotations

from itertools import islice, takewhile
from weakref import WeakKeyDictionary

from PySide6.QtWidgets import QButtonGroup, QRadioButton, QVBoxLayout, QWidget

from procc_annotator.camera.base import projects_only_ground
from procc_annotator.dataset.camera_set import FrameCameras
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.gui.panels.cameras.source_row import SourceRow
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.document import Document
from procc_annotator.translation import tr, tr_count, word

NO_CAMERA = -1
_NO_CAMERA_ID = -2  # -1 asks Qt for a number of its own

_COMPLETENESS = word("Frames of this dataset that have a camera (completeness)")
_FITTED_TIP = word(
    "Frames visited in this window whose clicks gave a camera; their JaC is of the clicks that the"
    " fit was made from.\nprocc-annotator calibrate fits and scores the whole set"
)
_FOLLOWED_TIP = word(
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
        self.none = QRadioButton(tr("no camera"))
        self.none.setObjectName("cameras_none")
        self.none.setToolTip(tr("Judge nothing, draw no camera"))
        self.none.clicked.connect(lambda: document.camera_sources.set_active_camera(NO_CAMERA))
        self._group.addButton(self.none, _NO_CAMERA_ID)
        self._layout = QVBoxLayout(self)
        self._layout.setContentsMargins(0, 0, 0, 0)
        self._layout.setSpacing(2)
        self._layout.addWidget(self.none)

    def refresh(self) -> None:
        """Show the sources as they are now."""
        sources = tuple(self._document.state.sources)
        if sources != self._listed:
            self._build(sources)
        self.none.setVisible(bool(sources))
        self.none.setChecked(self._document.state.active is None)
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
        row.renamed.connect(lambda name: document.camera_sources.rename_source(source, name))
        row.recoloured.connect(
            lambda colour: document.camera_sources.set_source_colour(source, colour)
        )
        row.shown.connect(lambda shown: document.camera_sources.set_source_visible(source, shown))
        row.removed.connect(lambda: self._remove(source))

    def _activate(self, source: CameraSource) -> None:
        if self._document.state.active is not source:
            self._document.camera_sources.set_active_camera(
                self._document.state.sources.index(source)
            )

    def _remove(self, source: CameraSource) -> None:
        if source is self._document.shot_track.source:
            self._document.shot_track.forget()
        elif source.files is None:
            self._document.live_fit.set_wanted(False)
        else:
            self._document.camera_sources.remove_camera_set(
                self._document.state.sources.index(source)
            )

    # --- what a row says -----------------------------------------------------------------------

    def _show_state(self, row: SourceRow, source: CameraSource) -> None:
        document = self._document
        jac, tip = self._jac(source)
        matched, matched_tip = self._matched(source)
        row.show_state(
            active=source is document.state.active,
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
        if document.state.blind:
            return "JaC –", tr("Blind mode hides how the sources do")
        mean = source.mean_jac(document.state.tau)
        if mean is None:
            return "JaC –", tr("No frame has both annotated elements and a camera of this source")
        frames = tr_count(len(source.audits), "{n:,} frame", "{n:,} frames")
        if document.set_scores.running:
            frames = tr("{frames} so far", frames=frames)
        tip = tr("Mean JaC at {tau:.1f} px over {frames}", tau=document.state.tau, frames=frames)
        if bad := len(source.problems):
            tip = tr_count(
                bad,
                "{mean}; {n:,} camera cannot be read and takes no part",
                "{mean}; {n:,} cameras cannot be read and take no part",
                mean=tip,
            )
        return f"JaC {mean:.3f}", f"{tip}\n{document.state.setup.describe()}"

    def _model(self, source: CameraSource) -> str:
        """The camera model: of the set when it has one, else of the frame on screen."""
        words = self._model_words(source)
        return f"{words}, {tr(source.fitted.mark)}" if words and source.fitted else words

    def _model_words(self, source: CameraSource) -> str:
        models = source.models
        known = self._document.source_frames.of(source)
        camera = known.camera if known is not None else None
        if len(models) == 1:
            words = models[0]
        elif known is None or camera is None:
            return tr("several models") if models else ""
        else:
            words = known.model
        if camera is not None and projects_only_ground(camera):
            words = tr("{model} (ground)", model=words)
        return tr("{model} here, several models", model=words) if len(models) > 1 else words

    def _matched(self, source: CameraSource) -> tuple[str, str]:
        """Return how many frames have a camera, and which of these cannot be used."""
        workspace, cameras = self._document.state.workspace, source.camera_set
        if source is self._document.shot_track.source:
            count = len(cameras.frames)
            words = tr_count(count, "{n:,} frame followed", "{n:,} frames followed")
            return words, tr(_FOLLOWED_TIP)
        if source.files is None:
            count = len(cameras.frames)
            words = tr_count(count, "{n:,} frame fitted", "{n:,} frames fitted")
            return words, tr(_FITTED_TIP)
        if workspace is None or not workspace.frames:
            return tr_count(len(cameras.frames), "{n:,} camera", "{n:,} cameras"), ""
        of = workspace, cameras, len(source.problems)
        before, matched = self._counted.get(source, (None, 0))
        if before != of:  # counting a large set takes a while
            matched = source.matched(frame.name for frame in workspace.frames)
            self._counted[source] = of, matched
        total = len(workspace.frames)
        share = f"{100 * matched / total:.0f} %"
        if not source.problems:
            words = tr("{n} of {total} ({share})", n=matched, total=total, share=share)
            return words, tr(_COMPLETENESS)
        bad, names = len(source.problems), ", ".join(islice(source.problems, _NAMED))
        if bad > _NAMED:
            names = tr_count(
                bad - _NAMED, "{names} and {n:,} more", "{names} and {n:,} more", names=names
            )
        unreadable = tr("Unreadable (filter camera:unreadable): {names}", names=names)
        words = tr_count(
            bad,
            "{matched} of {total}, {n} unreadable",
            "{matched} of {total}, {n} unreadable",
            matched=matched,
            total=total,
        )
        return words, f"{tr(_COMPLETENESS)}: {share}\n{unreadable}"

    def _problem(self, source: CameraSource) -> str:
        """Why a source that is not judged has nothing to show of this frame; the panel's notes say
        it of the active one."""
        document = self._document
        known = document.source_frames.of(source)
        if known is None or source is document.state.active:
            return ""
        if source.files is None:
            return known.notice if document.state.projection_visible and not known.camera else ""
        if known.error:
            return tr("cannot be used here: {error}", error=known.error)
        return tr("no camera for this frame") if known.camera is None else ""
