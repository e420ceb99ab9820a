"""The live fit as a camera source beside those from files."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.interact.palette import FIT
from procc_annotator.session.dataset.fitted_cameras import FittedCameras, FittedFrame

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document


class FitSource(QObject):
    """Keeps the source "fit" in step with the live fit.

    It joins the sources once the clicks of a frame have given a camera, and leaves them when the
    live fit is switched off or another dataset is opened. It holds the fits of the frames visited
    in this window, each for as long as its clicks are the same. While the clicks on screen are
    fitted anew, the fit before stays in the picture for that moment, so that nothing flickers.

    Attributes:
        source: as a row of the list.
        preferred: whether the user chose to judge the fit: then it is judged whenever there is no
            other source that is.
    """

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._document = document
        self.source = CameraSource(FittedCameras(), FIT, visible=False)
        self.preferred = False
        self._frame: str | None = None
        self._terms: tuple[object, ...] = ()
        self._joining = False
        document.live_fit.changed.connect(self.look)
        document.frameChanged.connect(self.look)
        document.blindChanged.connect(self._hide)
        document.datasetChanged.connect(self._begin_anew)
        document.framesEdited.connect(self._drop_edited)
        document.camerasChanged.connect(self._note_choice)

    @property
    def cameras(self) -> FittedCameras:
        """The fits known now."""
        found = self.source.camera_set
        assert isinstance(found, FittedCameras)
        return found

    @property
    def listed(self) -> bool:
        """Whether the fit is among the sources."""
        return self.source in self._document.sources

    def look(self) -> None:
        """The fit, or the frame it is for, may be another one."""
        document = self._document
        if not document.live_fit.wanted:
            self._leave()
            return
        frame = document.frame
        if frame is None:
            return
        terms = document.live_fit.model, document.field
        if terms != self._terms:  # fits of several kinds would make no source
            self._terms = terms
            self._forget([name for name in self.cameras.fits if name != frame.name])
        known = self.cameras.fits.get(frame.name)
        insight = document.live_fit.insight
        if insight is not None and insight.fit is not (known.fit if known else None):
            fitted = FittedFrame(insight.annotation, insight.fit)
            cameras = self.cameras.with_fit(frame.name, fitted)
            if (shown := document.live_fit.shown) is not None:
                document.source_frames.put(cameras, frame.name, shown)
            self._replace(cameras)
        elif insight is None and self._outlived(frame.name, known):
            self._replace(self.cameras.without([frame.name]))
        self._frame = frame.name

    # --- inside ---

    def _outlived(self, frame: str, known: FittedFrame | None) -> bool:
        """Whether what is known of a frame must not be shown any more."""
        if known is None or known.annotation is self._document.annotation:
            return False
        came = self._frame != frame  # others may have edited it meanwhile
        return came or not self._document.live_fit.working

    def _replace(self, cameras: FittedCameras) -> None:
        """Take other fits, of which that of the frame on screen is another one."""
        self.source.camera_set = cameras
        if not self.listed and cameras.frames:
            self._join()
        self._document.show_source_again(self.source)

    def _join(self) -> None:
        document = self._document
        self._joining = True
        document.join_source(self.source, active=self.preferred and document.active_source is None)
        self._joining = False

    def _leave(self) -> None:
        self._forget(self.cameras.fits)
        if self.listed:
            self._joining = True
            self._document.remove_camera_set(self._document.sources.index(self.source))
            self._joining = False

    def _forget(self, frames: Collection[str]) -> None:
        """Drop what is known of some frames, also how they scored."""
        frames = list(frames)
        self.source.camera_set = self.cameras.without(frames)
        self.source.forget(frames)

    def _begin_anew(self) -> None:
        self._leave()
        self._frame = None
        self.source.clear()

    def _drop_edited(self, indices: list[int]) -> None:
        """Frames that are not on screen were edited: their fits are of other clicks."""
        workspace = self._document.workspace
        if workspace is not None:
            here = self._document.frame_index
            self._forget([workspace.frames[i].name for i in indices if i != here])

    def _hide(self, blind: bool) -> None:
        """Blind mode: of frames that are not committed nothing may be known."""
        if blind:
            committed = self._document.review.committed_frames()
            self._forget([name for name in self.cameras.fits if name not in committed])
            self._document.show_source_again(self.source)

    def _note_choice(self) -> None:
        """Whoever chooses another source, or this one, means it to stay so."""
        if self.listed and not self._joining:
            self.preferred = self._document.active_source is self.source
