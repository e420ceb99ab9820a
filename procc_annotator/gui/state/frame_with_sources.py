"""The part of the document that opens, names, chooses and forgets camera sources."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from pathlib import Path

from procc_annotator.errors import ProccError
from procc_annotator.gui.state.camera_sources import (
    CameraSource,
    free_colour,
    free_name,
    same_place,
    where_else,
)
from procc_annotator.gui.state.judged_frame import JudgedFrame
from procc_annotator.gui.state.source_frames import look_up
from procc_annotator.metric.measure import measure_projected
from procc_annotator.session.dataset.camera_set import CameraSet


class FrameWithSources(JudgedFrame):
    """A frame and the camera sources it is judged against; what changes them is here."""

    def load_cameras(self, path: Path, fmt: str = "auto", name: str | None = None) -> bool:
        """Add a folder, archive or file of cameras and make it the active source.

        What is loaded already is read again from the disk.
        """
        try:
            cameras = CameraSet.open(path, fmt, name)
        except (ProccError, OSError) as error:
            self.message.emit(str(error), "error")
            return False
        if not cameras.frames:
            self.message.emit(f"{path}: no cameras in it ({where_else(path)})", "error")
            return False
        source = self.add_source(cameras)
        if name is not None:
            self.rename_source(source, name)
        remarks = [*cameras.notices, *self._no_match(cameras)]
        if remarks:
            self.message.emit("; ".join(remarks), "warning")
        return True

    def _no_match(self, cameras: CameraSet) -> Iterator[str]:
        """What to say of cameras that belong to no frame of the dataset."""
        frames = self.workspace.frames if self.workspace is not None else ()
        if frames and not any(frame.name in cameras.frames for frame in frames):
            yield (
                f"{cameras.path}: no camera has the name of a frame (cameras are named like"
                f" {next(iter(cameras.frames))!r}, frames like {frames[0].name!r})"
            )

    def add_source(
        self,
        cameras: CameraSet,
        *,
        colour: str | None = None,
        visible: bool = True,
        active: bool = True,
        changed: Collection[str] | None = None,
    ) -> CameraSource:
        """Add cameras that were opened already; the same ones loaded before are replaced.

        Args:
            changed: frames whose cameras are others than those loaded before; None: all.
        """
        known = next((s for s in self.sources if same_place(s.files, cameras)), None)
        if known is not None:
            self.set_scores.cancel()  # what it found is of the cameras before
            cameras.name = known.name
            known.camera_set = cameras
            if changed is None:
                self.set_scores.forget([known])
            else:
                known.forget(changed)
            source = known
        else:
            cameras.name = free_name(cameras.name, self.sources)
            source = CameraSource(cameras, colour or free_colour(self.sources), visible=visible)
            self.sources.insert(len(self._from_files), source)
        if active or self.active_source is source:
            self._activate(source)
        else:
            self._show_sources()
            self.camerasChanged.emit()
        self._score_set()
        return source

    def set_active_camera(self, index: int) -> None:
        """Judge against this source; -1 for none. What is known of the set is not computed anew."""
        chosen = self.sources[index] if 0 <= index < len(self.sources) else None
        self._activate(chosen)

    def compare_with(self, source: CameraSource | None) -> None:
        """Hold the active source against this one, until another is chosen; None: against the one
        that was active before."""
        self._compared, self._compared_chosen = source, source is not None
        self.camerasChanged.emit()

    def swap_sources(self) -> None:
        """Judge against the compared source, and compare with the one that was active."""
        if (other := self.compared) is not None:
            self._activate(other)

    def remove_camera_set(self, index: int) -> None:
        """Forget a source (its files stay)."""
        removed = self.sources.pop(index)
        if removed is self.active_source:
            self.active_source = None
            self.set_active_camera(min(index, len(self._from_files) - 1))
        else:
            self._show_sources()
            self.camerasChanged.emit()
        self._score_set()

    def join_source(self, source: CameraSource, *, active: bool) -> None:
        """Put a source of fits behind the others."""
        self.sources.append(source)
        if active:
            self._activate(source)
        else:
            self.camerasChanged.emit()

    def show_source_again(self, source: CameraSource) -> None:
        """A source of fits has another camera for the frame on screen, or none any more."""
        frame = self.frame
        if frame is None or source not in self.sources:
            return
        shown = self.source_frames.peek(source.camera_set, frame.name)
        if shown is None:
            shown = look_up(source.camera_set, frame.name, self.setup)
            self.source_frames.put(source.camera_set, frame.name, shown)
        active = source is self.active_source
        if active:
            self._judge_again()
        measurement = None
        if shown.projected is not None and self.annotation.annotated:
            if active and self.shown_annotation is self.annotation:
                measurement = self.judge.measurement
            else:
                terms = self.judge.frame_setup
                measurement = measure_projected(self.annotation, shown.projected, terms)
        self.set_scores.put(source, frame.name, shown, measurement, self.tau)
        if active:
            self.scoreChanged.emit()
        self.source_frames.changed.emit()

    def clear_sources(self) -> None:
        """Forget all sources."""
        self.sources.clear()
        self.active_source = self._compared = None
        self._compared_chosen = False
        self._activate(None)
        self._score_set()

    def rename_source(self, source: CameraSource, name: str) -> None:
        """Call a source something else; no two have the same name. Its verdicts go along."""
        name, before = " ".join(name.split()), source.name
        if source.files is not None and name and name != before:
            source.files.name = free_name(name, [s for s in self.sources if s is not source])
            if place := self.place(source):
                self.review.rename_source(place, before, source.name)
            self.camerasChanged.emit()

    def set_source_colour(self, source: CameraSource, colour: str) -> None:
        """Show a source in another colour."""
        source.colour = colour
        self.camerasChanged.emit()

    def set_source_visible(self, source: CameraSource, visible: bool) -> None:
        """Whether a source is drawn beside the active one."""
        source.visible = visible
        self.camerasChanged.emit()

    def _activate(self, source: CameraSource | None) -> None:
        before = self.active_source
        # Two that are compared change places; somebody's choice of a third one stays.
        stays = self._compared_chosen and self.compared is not source
        if before is not None and before is not source and not stays:
            self._compared = before
        self.active_source = source
        self._rejudge()
        self._show_sources()
        self.camerasChanged.emit()
        self.frameScoresChanged.emit("")
