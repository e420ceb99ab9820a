"""The terms of the evaluation and the field that is shown: commands of the store."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QObject

from procc_annotator.dataset.database.location import folder_of
from procc_annotator.dataset.dataset_field import store_dimensions, store_field, store_lines
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.load import with_stadiums
from procc_annotator.field.model import Field
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.selection import class_that_fits
from procc_annotator.gui.state.state import MAX_TAU, MIN_TAU, ChosenElement
from procc_annotator.gui.state.store import Store


class EvaluationSettings(QObject):
    """Changes what scores are computed with."""

    def __init__(self, store: Store, review: ReviewState) -> None:
        super().__init__(store)
        self._store, self._review = store, review

    def set_tau(self, tau: float) -> None:
        """Change the threshold within its limits; nothing is measured again."""
        self._store.update(tau=round(min(max(tau, MIN_TAU), MAX_TAU), 1))

    def set_protocol(
        self,
        protocol: str | None = None,
        *,
        size: tuple[int, int] | None = None,
        off_plane: str | None = None,
    ) -> None:
        """Change the terms of the evaluation."""
        setup = self._store.state.setup
        other = replace(
            setup,
            protocol=protocol or setup.protocol,
            size=size or setup.size,
            off_plane=off_plane or setup.off_plane,
        )
        if other != setup:
            self._store.update(setup=other)

    def set_noise_floor(self, floor: tuple[float, float] | None) -> None:
        """Median and 95 % of the distances between two annotators, px; shown next to tau."""
        self._store.update(noise_floor=floor)

    def set_sized_field(self, field: Field, *, keep: bool = True) -> None:
        """Give the field other dimensions, or lines elsewhere; all that is shown and judged goes by
        them.

        Args:
            field: the one that is shown, `resized`.
            keep: whether the dataset keeps its dimensions and where its lines are.

        Raises:
            FieldError: a landmark has the name of one of the field's classes.
        """
        field = self._with_own_landmarks(field)
        if keep and (database := self._review.database) is not None:
            store_dimensions(database, field)
            store_lines(database, field)
        self.take_field(field)

    def set_field(self, field: Field, *, keep: bool = True) -> None:
        """Show, judge and fit by another field; annotations, their histories and what is not saved
        yet stay, as do the dataset's landmarks.

        Args:
            field: of any sport; classes that it does not know stay in sight.
            keep: whether the dataset remembers it.

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
        chosen = state.selected_class
        if class_that_fits(chosen, field, state.annotation) != chosen:
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
        return with_landmarks(field, own.landmarks, own.instant, own.instants)
