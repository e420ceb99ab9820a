"""Annotate many frames in one action: the sure frames of a track, or of the whole dataset."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TypeVar

import numpy as np
from PySide6.QtCore import QObject, Signal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.assist.ghost_points import accept_all, find_points
from procc_annotator.batch.camera_proposals import ProposalRun, Proposed, second_pass
from procc_annotator.calibration.prediction.ghosts import find_ghosts
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.propose import propose_camera
from procc_annotator.calibration.tracking.track import TrackedFrame
from procc_annotator.dataset.computed_cameras import review_reason
from procc_annotator.dataset.frames import Frame
from procc_annotator.dataset.records import OriginKind
from procc_annotator.dataset.sequence import FrameSequence
from procc_annotator.errors import ImageError
from procc_annotator.field.load import field_for_frame
from procc_annotator.field.model import Field
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask
from procc_annotator.gui.state.editing.batch_edits import BatchEdits, EditedFrames
from procc_annotator.gui.state.sequences import is_annotated
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.state import Level
from procc_annotator.image.decoding import decode_for_camera
from procc_annotator.image.pixels import PixelArray
from procc_annotator.translation import tr, tr_count, translatable, word

_NOTHING = FrameAnnotation(())
_ANNOTATED = word("it is annotated by now")
_EDITED = word("it was edited since")
_NOT_FOLLOWED = word("no frame to accept: follow the shot first (T)")
_FOLLOWING = word("the shot is still being followed: wait for its end, or stop it (T), then accept")
_NONE_LEFT = word("no frame to accept: all that were followed are annotated")
_ALL_ANNOTATED = word("every frame is annotated")
_BLIND = word("blind mode: nothing is accepted that was not clicked")


T = TypeVar("T")
Unsure = dict[int, float]  # index of a frame -> probability that its camera is right
Found = dict[int, FrameAnnotation]  # index of a frame -> what it is to hold


@dataclass(frozen=True, eq=False)
class _Dataset:
    """The frames of a dataset, as they were when a person asked.

    Attributes:
        not_visible: the classes that cannot be seen in a frame; for any thread.
        least: how much of a line is to be seen.
    """

    frames: Sequence[Frame]
    field: Field
    not_visible: Callable[[str], frozenset[str]]
    least: float

    def annotated(
        self,
        fits: Mapping[int, FitResult],
        picture_of: Callable[[int], PixelArray],
        progress: Callable[[int], object],
    ) -> Found:
        """In a thread: the elements whose paint is seen where cameras, by index, show them."""
        found = Found()
        for done, (index, fit) in enumerate(fits.items()):
            progress(done)
            try:
                picture = picture_of(index)
            except ImageError:
                continue  # reported when that frame is opened
            name, size = self.frames[index].name, (picture.shape[1], picture.shape[0])
            field = field_for_frame(self.field, name)
            ghosts = find_ghosts(_NOTHING, field, fit, without=self.not_visible(name))
            points = [find_points(ghost, picture, field, size) for ghost in ghosts]
            annotation = accept_all(_NOTHING, points, self.least).annotation
            if annotation.annotated:
                found[index] = annotation
        return found


class StretchAccepting(QObject):
    """One run at a time. What is annotated already is never written over; each frame keeps its
    own history, and can be taken back alone.

    Attributes:
        following: whether the shot is being followed.
        marked: the stretch that a person marked on the strip; else the shot on screen is meant.
    """

    changed = Signal()  # how far it is, or that it ended

    def __init__(
        self, services: Services, least_support: Callable[[], float], parent: QObject
    ) -> None:
        super().__init__(parent)
        self._services, self._least_support = services, least_support
        self.following: Callable[[], bool] = lambda: False
        self.marked: Callable[[], tuple[int, int] | None] = lambda: None
        self._looking = LatestOnlyTask(self, self._fail)
        self._far = (0, 0)
        self.unsure: Unsure = {}  # frames that `accept_sure` left
        self._found: Found = {}
        self._put: Found = {}  # what frames held once they were edited
        self._accepted: Found = {}  # what was accepted last, by index
        self._taken_back: Found = {}  # what was taken back last
        self._offered: frozenset[int] = frozenset()  # doubtful frames that once more accepts
        self._at = -1  # the frame on screen by then; -1 once somebody went on
        self._here = _NOTHING  # what it held by then
        self._edits = BatchEdits(services.store, services.editing, services.scoring, self)
        services.store.watch(select.dataset, self.forget)
        services.shot_track.forgotten.connect(self._stop_looking)
        services.store.watch(select.frame, self._go_on)
        services.store.events.annotationEdited.connect(self._settle)
        services.review.statusChanged.connect(self._settle)

    @property
    def running(self) -> bool:
        """Return whether points are looked for, or edits are being made."""
        return self._looking.running or self._edits.running

    def words(self) -> str:
        """Return how far it is."""
        if not self._looking.running:
            return ""
        done, total = self._far
        if not total:
            return tr("finding line points …  Esc stops")
        return tr(
            "finding line points: {done} of {total} frames  ·  Esc stops", done=done, total=total
        )

    def accept(self) -> None:
        """Annotate the sure frames along the track; once more, the doubtful ones too."""
        services = self._services
        if not self._may_begin():
            return
        sequence, chosen = services.sequence.value, self._followed()
        if sequence is None or chosen is None:
            services.say(tr(_NOT_FOLLOWED))
            return
        doubts = {index: why for index, frame in chosen.items() if (why := review_reason(frame))}
        if not doubts or self._offered != doubts.keys():
            chosen = {index: frame for index, frame in chosen.items() if index not in doubts}
            self._offered = frozenset(doubts)
        else:
            self._offered = frozenset()
        if not chosen:
            services.say(_doubtful(list(doubts.values())) if doubts else tr(_NONE_LEFT))
            return
        fits = {index: frame.fit for index, frame in chosen.items() if frame.fit is not None}
        self._look(partial(_annotate_followed, self._dataset(), sequence, fits), self._take)

    def accept_sure(self) -> None:
        """Annotate every frame of the dataset that has a sure camera, of the track or found in its
        picture; the others become `unsure`."""
        services, shot_track = self._services, self._services.shot_track
        workspace, sequence = services.state.workspace, services.sequence.value
        if workspace is None or not self._may_begin():
            return
        indices = [
            index
            for index, frame in enumerate(workspace.frames)
            if services.proposals.allowed_in(frame.name) and not is_annotated(workspace, index)
        ]
        if not indices:
            services.say(tr(_ALL_ANNOTATED))
            return
        index_of = {} if sequence is None else sequence.index_of
        tracked = {
            index_of[number]: one.fit
            for number, one in shot_track.tracked.items()
            if number in index_of and one.fit is not None and not review_reason(one)
        }
        self._look(partial(_annotate_sure, self._dataset(), indices, tracked), self._take_sure)

    def _may_begin(self) -> bool:
        services = self._services
        if self.running or services.state.workspace is None:
            return False
        if self.following() or not services.proposals.allowed:
            services.say(tr(_FOLLOWING if self.following() else _BLIND))
            return False
        services.store.events.aboutToLeave.emit()
        return True

    def take_back(self) -> None:
        """Frames that were accepted last and not edited since are as they were before."""
        services = self._services
        if self.running or not self._accepted:
            services.say(tr("nothing was accepted that could be taken back"))
            return
        services.store.events.aboutToLeave.emit()
        self._found, self._accepted = self._accepted, {}
        self._at = services.state.frame_index
        self._edits.start(tuple(self._found), self._empty_frame, self._tell_taken_back)

    def key(self, name: str, _shift: bool) -> bool:
        """Take Undo right after a stretch was accepted, Redo right after it was taken back, and
        Escape while it is looked for."""
        if name in ("Escape", "Undo") and self._looking.running:
            self._stop_looking()
            self._services.say(tr("taken back: no frame is accepted"))
            return True
        state = self._services.state
        meant = {"Undo": self._accepted, "Redo": self._taken_back}.get(name)  # not shown
        if not meant or self._at != state.frame_index or state.annotation != self._here:
            return False  # something was done here since: that is meant
        if name == "Undo":
            self.take_back()
        else:
            self._found, self._put, self._taken_back = meant, {}, {}
            self._edits.start(tuple(meant), self._put_frame, self._tell_accepted)
        return True

    # --- which frames -------------------------------------------------------------------------

    def _dataset(self) -> _Dataset:
        services = self._services
        workspace = services.state.workspace
        assert workspace is not None
        not_visible = services.review.not_visible
        return _Dataset(workspace.frames, services.state.field, not_visible, self._least_support())

    def _followed(self) -> dict[int, TrackedFrame] | None:
        """Index and camera of the frames that are meant and not annotated; None where no frame of
        these was followed."""
        services, sequence = self._services, self._services.sequence.value
        workspace, shot_track = services.state.workspace, self._services.shot_track
        if sequence is None or workspace is None:
            return None
        here, marked = int(sequence.numbers[services.state.frame_index]), self.marked()
        meant = shot_track.shot_of(here) if marked is None else range(marked[0], marked[1] + 1)
        begin, end = np.searchsorted(sequence.numbers, (meant.start, meant.stop)).tolist()
        numbers = enumerate(sequence.numbers[begin:end].tolist(), start=begin)
        tracked = {i: shot_track.tracked[n] for i, n in numbers if n in shot_track.tracked}
        annotated, revealed = services.annotated_frames.indices, services.state.revealed_frames
        followed = {
            index: frame
            for index, frame in tracked.items()
            if frame.fit is not None
            and index not in annotated
            and (revealed is None or workspace.frames[index].name in revealed)
        }
        return followed if tracked else None

    # --- points -------------------------------------------------------------------------------

    def _look(self, work: Callable[[JobControl], T], then: Callable[[T], None]) -> None:
        self._far = (0, 0)
        self._looking.start(work, then, progress=self._advance)
        self.changed.emit()

    def _advance(self, done: int, total: int) -> None:
        self._far = (done, total)
        self.changed.emit()

    def _take_sure(self, done: tuple[Found, Unsure]) -> None:
        found, self.unsure = done
        self._offered = frozenset()
        self._take(found)

    def _take(self, found: Found) -> None:
        self.changed.emit()
        if not found:
            words = tr("no frame was annotated: too little of their lines is seen")
            if self.unsure:
                words = tr("no frame was annotated: no camera is sure")
            self._services.say("; ".join((words, *self._left())))
            return
        self._found, self._put = found, {}
        self._at, self._here = self._services.state.frame_index, self._services.state.annotation
        self._edits.start(tuple(found), self._put_frame, self._tell_accepted)

    def _fail(self, text: str) -> None:
        self.changed.emit()
        self._services.say(tr("no frame was accepted: {why}", why=text), "warning")

    def _stop_looking(self) -> None:
        if self._looking.cancel():
            self.changed.emit()

    # --- edits --------------------------------------------------------------------------------

    def _put_frame(self, index: int) -> str:
        workspace = self._services.state.workspace
        assert workspace is not None
        if not self._services.proposals.allowed_in(workspace.frames[index].name):
            return tr(_BLIND)

        def change(before: FrameAnnotation) -> FrameAnnotation | str:
            if before.annotated or before.unconfirmed:
                return tr(_ANNOTATED)
            found = self._found[index]
            for polyline in found.polylines:
                before = before.with_polyline(polyline)
            self._put[index] = before
            return before

        label = translatable("accept elements")
        return self._edits.edit_frame(index, change, label, OriginKind.ACCEPTED)

    def _empty_frame(self, index: int) -> str:
        def change(before: FrameAnnotation) -> FrameAnnotation | str:
            if before.polylines != self._found[index].polylines:
                return tr(_EDITED)
            for polyline in before.polylines:
                before = before.without(polyline.class_name)
            return before

        label = translatable("take back accepted elements")
        return self._edits.edit_frame(index, change, label, OriginKind.ACCEPTED)

    def _tell_accepted(self, outcome: EditedFrames) -> None:
        services = self._services
        self._accepted = {i: self._put[i] for i in outcome.edited}
        self._at = services.state.frame_index
        self._here = self._accepted.get(self._at, services.state.annotation)
        words = tr_count(
            len(outcome.edited),
            "annotated {n:,} frame",
            "annotated {n:,} frames",
        )
        back = tr("Ctrl+Z takes them back")
        level: Level = "warning" if self.unsure else "info"
        remedy = "next_doubtful" if self.unsure else ""
        services.say("; ".join((words, *_why(outcome), back, *self._left())), level, remedy)
        self.changed.emit()

    def _left(self) -> list[str]:
        """Name the doubtful frames that were left, and how they are accepted or gone through."""
        count = len(self._offered)
        if self.unsure:
            return [
                tr_count(
                    len(self.unsure),
                    "{n:,} frame is not sure: Alt+PgDown shows it",
                    "{n:,} frames are not sure: Alt+PgDown goes through them, the least sure first",
                )
            ]
        return [
            tr_count(
                count,
                "{n:,} doubtful frame left: Ctrl+Shift+Enter once more accepts it",
                "{n:,} doubtful frames left: Ctrl+Shift+Enter once more accepts them",
            )
        ][: bool(count)]

    def _tell_taken_back(self, outcome: EditedFrames) -> None:
        self._taken_back = {index: self._found[index] for index in outcome.edited}
        self._at, self._here = self._services.state.frame_index, self._services.state.annotation
        words = tr_count(
            len(outcome.edited),
            "taken back: {n:,} annotated frame",
            "taken back: {n:,} annotated frames",
        )
        self._services.say("; ".join((words, *_why(outcome))))
        self.changed.emit()

    def _go_on(self) -> None:
        """A person looks at another frame: from now on undo means that one, unless the stretch is
        accepted just now."""
        self._at = self._services.state.frame_index if self._edits.running else -1
        self._here = self._services.state.annotation

    def _settle(self, *_: object) -> None:
        """Something else was done: from now on undo and redo mean the frame on screen."""
        if not self._edits.running:
            self._at = -1

    def forget(self) -> None:
        """Accept no more and say nothing: the dataset or the window closes."""
        self._stop_looking()
        self._edits.forget()
        self._accepted, self._taken_back, self._offered = {}, {}, frozenset()
        self.unsure = {}
        self._at = -1


def _why(outcome: EditedFrames) -> list[str]:
    whys = dict.fromkeys(why for _, why in (*outcome.left, *outcome.unsaved))
    left = len(outcome.left) + len(outcome.unsaved)
    if not left:
        return []
    why = ", ".join(whys)
    return [tr_count(left, "{n:,} frame left: {why}", "{n:,} frames left: {why}", why=why)]


def _doubtful(reasons: list[str]) -> str:
    """Say that all frames are doubtful, the most frequent reason, and what accepts them."""
    why = max(reasons, key=reasons.count)
    return tr_count(
        len(reasons),
        "{n:,} frame is doubtful ({why}): look at it; Ctrl+Shift+Enter once more accepts it",
        "all {n:,} frames are doubtful ({why}): look at some; Ctrl+Shift+Enter once more accepts"
        " them",
        why=tr(why),
    )


def _annotate_followed(
    dataset: _Dataset, sequence: FrameSequence, fits: Mapping[int, FitResult], control: JobControl
) -> Found:
    """In a thread: what frames of a track are to hold, by index."""
    with sequence.open_pictures() as pictures:
        return dataset.annotated(
            fits,
            lambda index: pictures(int(sequence.numbers[index])),
            lambda done: control.progress_or_stop(done, len(fits)),
        )


def _annotate_sure(
    dataset: _Dataset,
    indices: Sequence[int],
    tracked: Mapping[int, FitResult],
    control: JobControl,
) -> tuple[Found, Unsure]:
    """In a thread: what each sure frame is to hold, and how sure the others are.

    Args:
        indices: of the frames without annotation.
        tracked: index -> the camera of a sure tracked frame.
    """
    index_of = {dataset.frames[index].name: index for index in indices}
    asked = [dataset.frames[index] for index in indices if index not in tracked]
    steps = len(asked) + len(indices)  # each frame is searched, then annotated

    def progress(done: int) -> None:
        total = len(indices)
        control.progress_or_stop(done * total // steps, total)

    run, proposed = ProposalRun(asked, dataset.field, propose_camera), dict[str, Proposed]()
    for one in run if asked else ():
        proposed[one.name] = one
        progress(len(proposed))
    if (more := second_pass(run, list(proposed.values()))) is not None:
        for one in more.run:
            proposed[one.name] = more.better(one)
            control.raise_if_cancelled()
    fits = dict(tracked)
    unsure = Unsure()
    for name, one in proposed.items():
        if one.is_sure and one.proposal is not None:
            fits[index_of[name]] = one.proposal.fit
        else:
            unsure[index_of[name]] = 0.0 if one.proposal is None else one.proposal.probability
    return (
        dataset.annotated(
            {index: fits[index] for index in sorted(fits.keys() & set(indices))},
            lambda index: decode_for_camera(dataset.frames[index].image_path),
            lambda done: progress(len(asked) + done),
        ),
        unsure,
    )
