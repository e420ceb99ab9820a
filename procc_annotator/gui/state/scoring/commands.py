"""Commands of the store: evaluation settings and camera sources."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject

from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.database.location import folder_of
from procc_annotator.dataset.dataset_field import store_dimensions, store_field, store_lines
from procc_annotator.errors import ProccError
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.load import with_stadiums
from procc_annotator.field.model import Field
from procc_annotator.gui.state.camera_sources import (
    CameraSource,
    free_colour,
    free_name,
    same_files,
    where_else,
)
from procc_annotator.gui.state.messages import say
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.scoring.dataset_scores import DatasetScoring
from procc_annotator.gui.state.state import MAX_TAU, MIN_TAU, ChosenElement
from procc_annotator.gui.state.store import Store
from procc_annotator.translation import tr


class EvaluationSettings(QObject):
    """Changes what scores are computed with."""

    def __init__(self, store: Store, review: ReviewState) -> None:
        super().__init__(store)
        self._store, self._review = store, review

    def set_tau(self, tau: float) -> None:
        """Change the threshold within its limits; nothing is measured again."""
        self._store.update(tau=round(min(max(tau, MIN_TAU), MAX_TAU), 1))

    def set_protocol(self, protocol: str | None = None, *, off_plane: str | None = None) -> None:
        """Change the terms of the evaluation."""
        setup = self._store.state.setup
        other = replace(
            setup, protocol=protocol or setup.protocol, off_plane=off_plane or setup.off_plane
        )
        if other != setup:
            self._store.update(setup=other)

    def set_noise_floor(self, floor: tuple[float, float] | None) -> None:
        """Median and 95 % of the distances between two annotators, px; shown next to tau."""
        self._store.update(noise_floor=floor)

    def set_sized_field(self, field: Field, *, keep: bool = True) -> None:
        """Give the field, as it is shown, other dimensions, or lines elsewhere, which the dataset
        may ``keep``; all that is shown and judged goes by them. `FieldError` if a landmark has the
        name of one of the field's classes."""
        field = self._with_own_landmarks(field)
        if keep and (database := self._review.database) is not None:
            store_dimensions(database, field)
            store_lines(database, field)
        self.take_field(field)

    def set_field(self, field: Field, *, keep: bool = True) -> None:
        """Show, judge and fit by another field of any sport, which the dataset may ``keep``;
        annotations, their histories and what is not saved yet stay, as do the dataset's landmarks.
        Classes that it does not know stay in sight.

        Raises:
            FieldError: a landmark has the name of one of the field's classes.
        """
        state = self._store.state
        chosen = state.selected_class
        # What is under way belongs to the field of before, unless that is only written anew.
        if keep or not (chosen is None or field.knows(chosen)):
            self._store.events.aboutToLeave.emit()
        field = self._with_own_landmarks(field)
        database = self._review.database
        if keep and state.workspace is not None and database is not None:
            store_field(database, folder_of(state.workspace.root), field)
        self.take_field(field)
        state = self._store.state
        name = state.selected_class or ""
        here = state.annotation.renamed(str.strip).get(name.strip()) is not None
        own = any(mark.name == name for mark in field.landmarks)  # placed or not
        if not (field.knows(name) or here or own):  # clicks would write it into other files
            self._store.update(selection=ChosenElement())
        self._store.update(hovered_class=None)

    def take_field(self, field: Field) -> None:
        """Go by a field; what the dataset keeps of its field stays."""
        state = self._store.state
        if field == state.field and field.source == state.field.source:
            return
        changes: dict[str, object] = {"setup": replace(state.setup, field=field)}
        if state.workspace is not None:
            state.workspace.set_field(field)
            if state.frame is not None:
                changes["annotation"] = state.workspace.state(state.frame_index).history.current
        self._store.update(**changes)

    def _with_own_landmarks(self, field: Field) -> Field:
        own = self._store.state.field
        if field.stadiums is None and field.name == own.name:  # its file was read again
            field = with_stadiums(field, own.stadiums)
        field = replace(field, pixels=own.pixels)
        return with_landmarks(field, own.landmarks, own.instant, own.instants)


class CameraSourceCommands(QObject):
    """The camera sources that the frames are judged against, those of fits behind the others."""

    def __init__(self, store: Store, scoring: DatasetScoring, review: ReviewState) -> None:
        super().__init__(store)
        self._store, self._scoring, self._review = store, scoring, review

    # --- which there are ----------------------------------------------------------------------

    def load_cameras(self, path: Path, fmt: str = "auto", name: str | None = None) -> bool:
        """Add a folder, archive or file of cameras and make it the active source.

        What is loaded already is read again from the disk.
        """
        try:
            cameras = CameraSet.open(path, fmt, name)
        except (ProccError, OSError) as error:
            say(self._store, str(error), "error")
            return False
        if not cameras.frames or self._only_below(cameras):
            text = tr(
                "{path}: no cameras in it ({what_to_do})", path=path, what_to_do=where_else(path)
            )
            say(self._store, text, "error")
            return False
        source = self.add_source(cameras)
        if name is not None:
            self.rename_source(source, name)
        remarks = [*cameras.notices, *filter(None, [self._no_match(cameras)])]
        if remarks:
            say(self._store, "; ".join(remarks), "warning")
        return True

    def _only_below(self, cameras: CameraSet) -> bool:
        """Return whether all cameras are in folders of it, and none by the place of a frame: sets
        of their own."""
        return self._none_matches(cameras) and all("/" in name for name in cameras.frames)

    def _none_matches(self, cameras: CameraSet) -> bool:
        workspace = self._store.state.workspace
        frames = workspace.frames if workspace is not None else ()
        return bool(frames) and not any(frame.name in cameras.frames for frame in frames)

    def _no_match(self, cameras: CameraSet) -> str:
        workspace = self._store.state.workspace
        if workspace is None or not self._none_matches(cameras):
            return ""
        return tr(
            "{path}: no camera has the name of a frame (cameras are named like {camera!r},"
            " frames like {frame!r})",
            path=cameras.path,
            camera=next(iter(cameras.frames)),
            frame=workspace.frames[0].name,
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
        ``changed``: frames whose cameras are others than those (None: all)."""
        sources = list(self._store.state.sources)
        source = next((s for s in sources if same_files(s.files, cameras)), None)
        if source is not None:
            self._scoring.cancel()  # what it found is of the cameras before
            cameras.name = source.name
            source.camera_set = cameras
            if changed is None:
                self._scoring.forget([source])
            else:
                source.forget(changed)
        else:
            cameras.name = free_name(cameras.name, sources)
            source = CameraSource(cameras, colour or free_colour(sources), visible=visible)
            sources.insert(sum(s.files is not None for s in sources), source)
        self._list(sources, source if active else self._store.state.active)
        return source

    def join_source(self, source: CameraSource, *, active: bool) -> None:
        """Put a source of fits behind the others."""
        sources = (*self._store.state.sources, source)
        self._list(sources, source if active else self._store.state.active)

    def remove_camera_set(self, index: int) -> None:
        """Forget a source (its files stay)."""
        sources = list(self._store.state.sources)
        removed, active = sources.pop(index), self._store.state.active
        if removed is active:
            from_files = [source for source in sources if source.files is not None]
            active = from_files[min(index, len(from_files) - 1)] if from_files else None
        self._list(sources, active)

    def remove_source(self, source: CameraSource) -> None:
        """Forget a source, if it is listed."""
        if source in self._store.state.sources:
            self.remove_camera_set(self._store.state.sources.index(source))

    def clear_sources(self) -> None:
        """Forget all sources."""
        self._list((), None)
        self._store.update(compared_choice=(None, False))

    # --- which is judged ----------------------------------------------------------------------

    def set_active_camera(self, index: int) -> None:
        """Judge against this source; -1 for none. What is known of the set is not computed anew."""
        sources = self._store.state.sources
        self._list(sources, sources[index] if 0 <= index < len(sources) else None)

    def compare_with(self, source: CameraSource | None) -> None:
        """Hold the active source against this one, until another is chosen; None: against the one
        that was active before."""
        self._store.update(compared_choice=(source, source is not None))

    def swap_sources(self) -> None:
        """Judge against the compared source, and compare with the one that was active."""
        if (other := self._store.state.compared) is not None:
            self._list(self._store.state.sources, other)

    # --- how they are shown -------------------------------------------------------------------

    def rename_source(self, source: CameraSource, name: str) -> None:
        """Call a source something else; no two have the same name. Its verdicts go along."""
        name, before = " ".join(name.split()), source.name
        if source.files is not None and name and name != before:
            others = [s for s in self._store.state.sources if s is not source]
            source.files.name = free_name(name, others)
            self._review.rename_source(source, before)
            self._show_looks()

    def set_source_colour(self, source: CameraSource, colour: str) -> None:
        """Show a source in another colour."""
        source.colour = colour
        self._show_looks()

    def set_source_visible(self, source: CameraSource, visible: bool) -> None:
        """Draw a source beside the active one, or do not."""
        source.visible = visible
        self._show_looks()

    def show_source_again(self, source: CameraSource) -> None:
        """A source of fits has another camera for the frame on screen, or none any more."""
        if source in self._store.state.sources:
            self._show_looks()
            self._scoring.fitted(source)

    # --- inside -------------------------------------------------------------------------------

    def _show_looks(self) -> None:
        self._store.update(looks=tuple(source.look for source in self._store.state.sources))

    def _list(self, sources: Sequence[CameraSource], active: CameraSource | None) -> None:
        state = self._store.state
        choice, before = state.compared_choice, state.active
        # Two that are compared change places; a person's choice of a third one stays.
        stays = choice[1] and state.compared is not active
        if before is not None and before is not active and not stays:
            choice = (before, choice[1])
        self._store.update(
            sources=tuple(sources),
            looks=tuple(source.look for source in sources),
            active=active,
            compared_choice=choice,
        )
