"""Whose fault a frame's score is under a camera source, as people said."""

from __future__ import annotations

from procc_annotator.dataset.records import FaultParty, Verdict, place_of
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.store import Store


class KeptVerdicts:
    """What is kept of sources from files; fits change with the clicks."""

    def __init__(self, store: Store, review: ReviewState) -> None:
        self._store, self._review = store, review

    def shown_verdict(self, name: str) -> FaultParty | None:
        """Return whose fault a frame's score is under the active source; None while blind mode
        hides what is known of the camera there."""
        source = self._store.state.active
        if source is None or not self._store.state.reveals(name):
            return None
        verdict = self.verdict(name, source)
        return None if verdict is None else verdict.fault

    def verdict(self, name: str, source: CameraSource) -> Verdict | None:
        """Return whose fault a frame's score is under a source, also where blind mode hides it;
        None for fits."""
        if source.files is None:
            return None
        return self._review.verdict(name, source.name, self.place(source))

    def set_verdict(
        self, name: str, source: CameraSource, fault: FaultParty | None, comment: str = ""
    ) -> None:
        """Say whose fault a frame's score is under a source from files; None takes it back."""
        if source.files is not None:
            self._review.set_verdict(name, source.name, self.place(source), fault, comment)

    def rename_source(self, source: CameraSource, before: str) -> None:
        """A source has another name: its verdicts go along."""
        if place := self.place(source):
            self._review.rename_source(place, before, source.name)

    def place(self, source: CameraSource) -> str:
        """Return what verdicts know a source by, whatever it is called; empty without a dataset or
        files."""
        cameras, workspace = source.files, self._store.state.workspace
        if workspace is None or cameras is None:
            return ""
        return place_of(cameras.path, cameras.format, workspace.folder)
