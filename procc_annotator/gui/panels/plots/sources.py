"""What plots are made of: the shown sources with their audits, as blind mode allows."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from procc_annotator.batch.audit import FrameAudit, audit_frame
from procc_annotator.dataset.layout import FRAMES_FILE
from procc_annotator.field.landmarks import element_titles
from procc_annotator.gui.panels.plots.request import PlotRequest, PlottedSource, Scope
from procc_annotator.gui.panels.refresher import judged
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.document import Document

Restrict = Callable[[PlotRequest], PlotRequest]


class PlotSources:
    """Takes snapshots of the document that another thread may look at.

    ``set_version`` and ``frame_version`` change with what the plots of the set and of the frame on
    screen show; moving on to another frame or tau is no change of the set.
    """

    def __init__(self, document: Document) -> None:
        self._document = document
        self._names: tuple[str, ...] = ()
        self._order_file: Path | None = None
        self.set_version = self.frame_version = 0
        store = document.store
        store.watch(lambda s: s.workspace, self._take_dataset)
        store.watch(
            lambda s: (s.workspace, s.looks, s.field, s.blind, s.committed), self._change_set
        )
        store.watch(judged, self._change_frame)
        document.store.events.sourceAuditsChanged.connect(self._change_set)
        document.review.statusChanged.connect(self._change_set)
        self._take_dataset()

    def version(self, scope: Scope) -> int:
        """A number that is another one when the scope's data is."""
        return self.frame_version + self.set_version if scope == "frame" else self.set_version

    def request(self, scope: Scope, class_row: int | None) -> tuple[PlotRequest, Restrict]:
        """Return what to plot, and what takes out of it, in any thread, the frames that blind
        mode hides.

        The plots of one frame need nothing taken out any more.
        """
        document = self._document
        sources = tuple(
            PlottedSource(
                source.name,
                source.colour,
                number,
                self._of_frame(source) if scope == "frame" else dict(source.audits),
                source.camera_set is document.state.active_cameras,
                source.camera_set,
                source.fitted,
            )
            for number, source in enumerate(document.state.sources)
            if source.visible or source.camera_set is document.state.active_cameras
        )
        request = PlotRequest(
            sources,
            self._names,
            document.state.frame_index,
            scope,
            class_row,
            document.state.tau,
            document.state.setup.size,
            tuple(element_titles(document.state.field).values()),
            document.state.blind if scope == "set" else not document.state.projection_visible,
            document.state.field,
            order_file=self._order_file,
        )
        return request, self._restriction(scope)

    def _of_frame(self, source: CameraSource) -> dict[str, FrameAudit]:
        """The audit of the frame on screen; of the active source as the clicks are right now."""
        document = self._document
        frame = document.state.frame
        if frame is None or not document.state.projection_visible:
            return {}
        measurement, camera = document.judge.measurement, document.judge.camera
        if source.camera_set is not document.state.active_cameras:
            found = source.audits.get(frame.name)
        elif measurement is None or camera is None or not document.state.shown_annotation.annotated:
            found = None
        else:
            found = audit_frame(frame.name, camera, "", measurement, document.state.tau)
        return {} if found is None else {frame.name: found}

    def _restriction(self, scope: Scope) -> Restrict:
        document = self._document
        if scope == "frame" or not document.state.blind:
            return _as_it_is
        database = document.review.database
        records = dict(database.records()) if database is not None else {}

        def restrict(request: PlotRequest) -> PlotRequest:
            committed = {name for name, record in records.items() if record.committed}
            sources = tuple(
                replace(s, audits={n: a for n, a in s.audits.items() if n in committed})
                for s in request.sources
            )
            hidden = frozenset(request.frames) - committed
            return replace(request, sources=sources, hidden=hidden)

        return restrict

    def _take_dataset(self) -> None:
        workspace = self._document.state.workspace
        self._names = () if workspace is None else tuple(f.name for f in workspace.frames)
        self._order_file = None if workspace is None else workspace.folder / FRAMES_FILE

    def _change_set(self) -> None:
        self.set_version += 1

    def _change_frame(self) -> None:
        self.frame_version += 1


def _as_it_is(request: PlotRequest) -> PlotRequest:
    return request
