"""The live fit as a camera source next to those from files."""

from __future__ import annotations

from collections.abc import Collection

from PySide6.QtCore import QObject

from procc_annotator.dataset.computed_cameras import FittedCameras, FittedFrame
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.prediction.live_fit import LiveFit
from procc_annotator.gui.state.scoring.camera_sources import CameraSourceCommands
from procc_annotator.gui.state.scoring.frame_cameras import SourceFrames
from procc_annotator.gui.state.store import Store
from procc_annotator.interaction.palette import FIT


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

    def __init__(
        self,
        store: Store,
        sources: CameraSourceCommands,
        source_frames: SourceFrames,
        live_fit: LiveFit,
    ) -> None:
        super().__init__(store)
        self._store, self._sources = store, sources
        self._source_frames, self._live_fit = source_frames, live_fit
        self.source = CameraSource(FittedCameras(), FIT, visible=False)
        self.preferred = False
        self._frame: str | None = None
        self._terms: tuple[object, ...] = ()
        self._seen = (False, store.state.active)  # whether it was listed, and what was judged
        live_fit.changed.connect(self.look)
        store.watch(select.dataset, self._begin_anew)
        store.watch(select.frame, self.look)
        store.watch(select.blind, self._hide)
        store.watch(select.cameras, self._note_choice)
        store.events.framesEdited.connect(self._drop_edited)

    @property
    def cameras(self) -> FittedCameras:
        """The fits known now."""
        found = self.source.camera_set
        assert isinstance(found, FittedCameras)
        return found

    @property
    def listed(self) -> bool:
        """Return whether the fit is among the sources."""
        return self.source in self._store.state.sources

    def look(self) -> None:
        """The fit, or the frame it is for, may be another one."""
        live_fit, state = self._live_fit, self._store.state
        if not live_fit.wanted:
            self._leave()
            return
        frame = state.frame
        if frame is None:
            return
        terms = live_fit.model, state.field
        if terms != self._terms:  # fits of several kinds would make no source
            self._terms = terms
            self._forget([name for name in self.cameras.fits if name != frame.name])
        if self._frame not in (None, frame.name):
            self._drop_outdated(self._frame)
        known = self.cameras.fits.get(frame.name)
        insight = live_fit.insight
        if insight is not None and insight.fit is not (known.fit if known else None):
            fitted = FittedFrame(insight.annotation, insight.fit)
            cameras = self.cameras.with_fit(frame.name, fitted)
            if (shown := live_fit.shown) is not None:
                self._source_frames.put(cameras, frame.name, shown)
            self._replace(cameras)
        elif insight is None and self._outlived(frame.name, known):
            self._replace(self.cameras.without([frame.name]))
        self._frame = frame.name

    # --- inside ---

    def _drop_outdated(self, left: str) -> None:
        """The frame was left before the clicks there were fitted anew."""
        workspace, known = self._store.state.workspace, self.cameras.fits.get(left)
        index = None if workspace is None else workspace.index.get(left)
        if workspace is None or index is None or known is None:
            return
        now = workspace.loaded_annotation(index)
        if now is not None and now.polylines != known.annotation.polylines:
            self._forget([left])
            self._sources.show_source_again(self.source)

    def _outlived(self, frame: str, known: FittedFrame | None) -> bool:
        """Return whether what is known of a frame must not be shown any more."""
        if known is None or known.annotation is self._store.state.annotation:
            return False
        came = self._frame != frame  # others may have edited it meanwhile
        return came or not self._live_fit.working

    def _replace(self, cameras: FittedCameras) -> None:
        """Take other fits, of which that of the frame on screen is another one."""
        self.source.camera_set = cameras
        if not self.listed and cameras.frames:
            self._join()
        self._sources.show_source_again(self.source)

    def _join(self) -> None:
        nothing_judged = self._store.state.active is None
        self._sources.join_source(self.source, active=self.preferred and nothing_judged)

    def _leave(self) -> None:
        self._forget(self.cameras.fits)
        if self.listed:
            self._sources.remove_camera_set(self._store.state.sources.index(self.source))

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
        workspace = self._store.state.workspace
        if workspace is not None:
            here = self._store.state.frame_index
            self._forget([workspace.frames[i].name for i in indices if i != here])

    def _hide(self) -> None:
        """Blind mode: of frames that are not committed nothing may be known."""
        if self._store.state.blind:
            committed = self._store.state.committed
            self._forget([name for name in self.cameras.fits if name not in committed])
            self._sources.show_source_again(self.source)

    def _note_choice(self) -> None:
        """Remember whether the user chose the fit or another source."""
        was_listed, judged = self._seen
        self._seen = now_listed, active = self.listed, self._store.state.active
        if was_listed and now_listed and active is not judged:
            self.preferred = active is self.source
