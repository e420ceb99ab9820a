"""Data of plots: the visible sources with their audits, as blind mode allows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

from procc_annotator.batch.audit import FrameAudit, audit_frame
from procc_annotator.batch.grouping import FrameOrder
from procc_annotator.dataset.layout import FRAMES_FILE
from procc_annotator.dataset.records import FrameRecord
from procc_annotator.errors import InputError
from procc_annotator.field.landmarks import element_titles
from procc_annotator.formats.cameras.fit_record import NOT_FITTED, FitCounts
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.selectors import judged
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr

Scope = Literal["frame", "set"]


@dataclass(frozen=True, eq=False)
class PlottedSource:
    """A camera source as plots know it.

    Attributes:
        name, colour: as everywhere in the window; the colour as "#rrggbb".
        number: its place among all sources, which gives its dashes and its symbol.
        audits: by frame name; only of frames that may be shown.
        active: whether it is the one that is judged.
        fitted: whether they were fitted to the clicks they are judged by.
    """

    name: str
    colour: str
    number: int
    audits: Mapping[str, FrameAudit]
    active: bool = False
    fitted: FitCounts = NOT_FITTED


@dataclass(frozen=True, eq=False)
class PlotRequest:
    """The sources, frames and settings of a plot.

    Attributes:
        sources: the visible ones.
        frames: names of all frames of the dataset, in its order.
        current: position of the frame on screen, -1 without one.
        scope: the frame on screen, or all of them.
        class_row: only points of this class of the field; None for all.
        tau: px.
        size: of the evaluation, px.
        titles: of the classes, by row of the field.
        blind: whether blind mode hides frames of the scope.
        order_file: the dataset's table of frames, if it has one.
        shown: in blind mode what is known of each frame; of those that are not committed nothing
            is plotted (`revealed`). None: all may be plotted.
    """

    sources: tuple[PlottedSource, ...]
    frames: tuple[str, ...]
    current: int
    scope: Scope
    class_row: int | None
    tau: float
    size: tuple[int, int]
    titles: tuple[str, ...] = ()
    blind: bool = False
    order_file: Path | None = None
    shown: Mapping[str, FrameRecord] | None = None

    def revealed(self) -> PlotRequest:
        """Return the request without the frames that blind mode hides, in any thread."""
        if self.shown is None:
            return self
        committed = {name for name, record in self.shown.items() if record.committed}
        sources = tuple(
            replace(s, audits={n: a for n, a in s.audits.items() if n in committed})
            for s in self.sources
        )
        return replace(self, sources=sources, shown=None)

    def order(self) -> tuple[FrameOrder | None, str]:
        """The dataset's table of frames, read anew (not on the interface's thread), and what is
        wrong with it, if it cannot be used."""
        if self.order_file is None or not self.order_file.is_file():
            return None, ""
        try:
            return FrameOrder.read(self.order_file), ""
        except InputError as error:
            return None, tr("Shots are told by names, since {error}.", error=error)

    def why_nothing(self, otherwise: str) -> str:
        """Return why there is nothing to plot: blind mode, or the page's own reason."""
        if not self.blind:
            return otherwise
        if self.scope == "frame":
            return tr("Hidden: blind mode shows this plot once this frame is committed.")
        return tr(
            "Hidden: blind mode shows committed frames only, and none of them is in this plot."
        )

    def audits(self, source: PlottedSource) -> list[FrameAudit]:
        """Return what the scope holds of a source, in the order of the frames."""
        if self.scope == "frame":
            name = self.frames[self.current] if self.current >= 0 else ""
            found = source.audits.get(name)
            return [] if found is None else [found]
        return [source.audits[name] for name in self.frames if name in source.audits]


class PlotSources:
    """Takes snapshots of the state that another thread may look at.

    ``set_version`` and ``frame_version`` change with what the plots of the set and of the frame on
    screen show; moving on to another frame or tau is no change of the set.
    """

    def __init__(self, services: Services) -> None:
        self._services = services
        self._names: tuple[str, ...] = ()
        self._order_file: Path | None = None
        self.set_version = self.frame_version = 0
        store = services.store
        store.watch(lambda s: s.workspace, self._take_dataset)
        store.watch(
            lambda s: (s.workspace, s.looks, s.field, s.blind, s.committed), self._change_set
        )
        store.watch(judged, self._change_frame)
        services.store.events.sourceAuditsChanged.connect(self._change_set)
        services.review.statusChanged.connect(self._change_set)
        self._take_dataset()

    def version(self, scope: Scope) -> int:
        """A number that is another one when the scope's data is."""
        return self.frame_version + self.set_version if scope == "frame" else self.set_version

    def request(self, scope: Scope, class_row: int | None) -> PlotRequest:
        """Return what to plot; of a set before the frames are left out that blind mode hides."""
        services = self._services
        sources = tuple(
            PlottedSource(
                source.name,
                source.colour,
                number,
                self._of_frame(source) if scope == "frame" else dict(source.audits),
                source.camera_set is services.state.active_cameras,
                source.fitted,
            )
            for number, source in enumerate(services.state.sources)
            if source.visible or source.camera_set is services.state.active_cameras
        )
        shown = None
        if scope == "set" and services.state.blind:
            database = services.review.database
            shown = dict(database.records()) if database is not None else {}
        return PlotRequest(
            sources,
            self._names,
            services.state.frame_index,
            scope,
            class_row,
            services.state.tau,
            services.state.setup.size,
            tuple(element_titles(services.state.field).values()),
            services.state.blind if scope == "set" else not services.state.projection_visible,
            self._order_file,
            shown,
        )

    def _of_frame(self, source: CameraSource) -> dict[str, FrameAudit]:
        """The audit of the frame on screen; of the active source as the clicks are right now."""
        services = self._services
        frame = services.state.frame
        if frame is None or not services.state.projection_visible:
            return {}
        measurement, camera = services.scorer.measurement, services.scorer.camera
        if source.camera_set is not services.state.active_cameras:
            found = source.audits.get(frame.name)
        elif measurement is None or camera is None or not services.state.shown_annotation.annotated:
            found = None
        else:
            found = audit_frame(frame.name, camera, "", measurement, services.state.tau)
        return {} if found is None else {frame.name: found}

    def _take_dataset(self) -> None:
        workspace = self._services.state.workspace
        self._names = () if workspace is None else tuple(f.name for f in workspace.frames)
        self._order_file = None if workspace is None else workspace.folder / FRAMES_FILE

    def _change_set(self) -> None:
        self.set_version += 1

    def _change_frame(self) -> None:
        self.frame_version += 1
