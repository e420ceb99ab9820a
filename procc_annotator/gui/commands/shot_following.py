"""Following the shot of the frame on screen, in both directions, while its frames fill in."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace

from PySide6.QtCore import QObject, Signal

from procc_annotator.assist.track_anchors import (
    CameraCorrection,
    align_to_lines,
    anchors_of,
    as_anchor,
)
from procc_annotator.batch.tracking import UsablePictures, lost_frame
from procc_annotator.calibration.tracking.frame_reader import shot_range_around
from procc_annotator.calibration.tracking.shot_tracker import track_shot
from procc_annotator.calibration.tracking.track import Track, TrackedFrame
from procc_annotator.camera.base import Camera
from procc_annotator.camera.models import HomographyCamera, PinholeCamera
from procc_annotator.dataset.computed_cameras import review_reason
from procc_annotator.dataset.records import OriginKind
from procc_annotator.dataset.sequence import FrameSequence
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import CameraError
from procc_annotator.field.load import field_for_frame, field_for_stadium, stadium_of
from procc_annotator.field.model import Field
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask, Stopped
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr, tr_count, word

_UNSURE_HERE = word(
    "the camera of this frame is unsure: a sure one is looked for in the shot; look at this one,"
    " accept its lines (Shift+Enter), then T follows them"
)
_NONE_SURE = word(
    "no frame of the shot has a camera that is sure: accept the lines of one (Shift+Enter), or"
    " {advice}; then T follows it"
)


@dataclass(frozen=True, eq=False)
class _Asked:
    """A request to follow a shot.

    Attributes:
        stadium: of the shot; None where its field has no dimensions of its own.
        number: of the frame it begins at.
        camera: of that frame, px of the picture; None where nothing is known of it.
        within: the frames to follow; None: the shot of the frame, up to its cuts.
        corrected: cameras that a person dragged, by frame name.
    """

    workspace: Workspace
    sequence: FrameSequence
    field: Field
    stadium: str | None
    model: str
    number: int
    camera: Camera | None
    within: range | None
    corrected: Mapping[str, CameraCorrection]


class ShotFollowing(QObject):
    """One shot at a time. Annotated frames, and those whose camera a person dragged, are anchors:
    the track passes through their cameras, and once one of them was corrected, what is between
    its neighbours is followed again.

    Attributes:
        marked: the stretch that a person marked on the strip; that is followed, not the shot.
    """

    changed = Signal()  # how far it is, or that it ended

    def __init__(self, services: Services, parent: QObject) -> None:
        super().__init__(parent)
        self._services = services
        self.marked: Callable[[], tuple[int, int] | None] = lambda: None
        self._work = LatestOnlyTask(self, self._fail)
        self._far = (0, 0)
        self._corrected: dict[int, None] = {}  # numbers of anchors, in the order of their edits
        services.shot_track.forgotten.connect(self.forget)
        services.store.watch(select.blind, self._hide)
        services.store.events.annotationEdited.connect(self._note_edit)
        services.corrections.changed.connect(self._note_dragged)
        services.store.watch(select.frame, self._follow_corrected)

    @property
    def running(self) -> bool:
        """Return whether a shot is followed just now."""
        return self._work.running

    def words(self) -> str:
        """Return how far it is."""
        if not self.running:
            return ""
        done, total = self._far
        if not total:
            return tr("looking for the ends of the shot …  T stops")
        return tr("following: {done} of {total} frames  ·  T stops", done=done, total=total)

    def toggle(self) -> None:
        """Follow the shot of the frame on screen, or stop."""
        services, sequence = self._services, self._services.sequence.value
        if self.running:
            self.stop()
            return
        if sequence is None:
            services.say(tr("only a video, or frames that follow one another, can be followed"))
            return
        if services.state.blind:
            services.say(tr("blind mode: no shot is followed, its cameras would be seen"))
            return
        services.store.events.aboutToLeave.emit()
        number = int(sequence.numbers[services.state.frame_index])
        marked = self.marked()
        within = None
        if marked is not None and marked[0] <= number <= marked[1]:
            within = range(marked[0], marked[1] + 1)
        camera = self._camera_here()
        seen = services.prediction.found is not None and not services.state.annotation.annotated
        if camera is None and seen and services.prediction.doubt:
            services.say(tr(_UNSURE_HERE))
        self._begin(number, camera, within)

    def stop(self) -> None:
        """Follow no further; the frames that came stay."""
        track = self._services.shot_track
        if self._work.stop_keep_partial():
            self.changed.emit()
            track.replace(track.tracked, track.cuts)
            self._services.say(
                tr("stopped; what was followed so far stays")
                if self._far[0]
                else tr("stopped; nothing was followed")
            )

    # --- inside -------------------------------------------------------------------------------

    def _camera_here(self) -> Camera | None:
        """The camera of the frame on screen: of its clicks, found without, or loaded. None that is
        unsure: a whole shot would be; the track then looks for one that is sure."""
        services = self._services
        insight, found = services.prediction.insight, services.prediction.found
        if (dragged := services.corrections.here) is not None and services.corrections.rules:
            return dragged.fit.camera
        if insight is not None and insight.from_clicks and insight.fit.camera is not None:
            return insight.fit.camera
        agreed = insight is not None and insight.fit.camera is not None
        agreed = agreed or not services.state.annotation.annotated
        if found is not None and agreed and not services.prediction.doubt:
            return found.camera
        state = services.state
        cameras, name, size = state.active_cameras, state.frame_name, state.picture_size
        if cameras is None or name is None or size is None:
            return None
        try:
            loaded = cameras.camera(name, size)
        except CameraError:
            return None  # told where it is shown
        camera = loaded.camera if loaded is not None else None
        return camera if isinstance(camera, PinholeCamera | HomographyCamera) else None

    def _begin(self, number: int, camera: Camera | None, within: range | None) -> None:
        services, state = self._services, self._services.state
        sequence, name = services.sequence.value, state.frame_name
        assert state.workspace is not None
        assert sequence is not None
        stadium = None if name is None else stadium_of(state.field, name)
        asked = _Asked(
            state.workspace, sequence, state.field, stadium, services.live_fit.model,
            number, camera, within, state.corrected,
        )  # fmt: skip
        self._far = (0, 0)
        self._work.start(
            lambda control: _follow(asked, control),
            lambda track: self._take(track, is_shot=within is None),
            progress=self._advance,
            partial=services.shot_track.put,
        )
        self.changed.emit()

    def _advance(self, done: int, total: int) -> None:
        self._far = (done, total)
        self.changed.emit()

    def _take(self, found: Track, *, is_shot: bool) -> None:
        self.changed.emit()
        shot_track = self._services.shot_track
        shot_track.take(found, is_shot=is_shot)
        if all(frame.fit is None for frame in found.frames):
            self._services.say(tr(_NONE_SURE, advice=self._services.ghosts.advice))
            return
        doubtful = sum(bool(review_reason(frame)) for frame in found.frames)
        self._services.say(_followed(len(found.frames), doubtful))
        self._follow_corrected()

    def _fail(self, text: str) -> None:
        self.changed.emit()
        self._services.say(tr("the shot could not be followed: {why}", why=text), "warning")

    def _hide(self) -> None:
        if self._services.state.blind:
            self.stop()

    def forget(self) -> None:
        """Follow no further and say nothing: the dataset or the window closes."""
        self._corrected.clear()
        if self._work.cancel():
            self.changed.emit()

    # --- corrected anchors --------------------------------------------------------------------

    def _note_edit(self) -> None:
        """The frame on screen was edited: an anchor was corrected, came or went."""
        track = self._services.shot_track
        number, tracked = track.number_here, track.here
        if number is None or tracked is None or self._only_accepted():
            return
        if tracked.state == "anchor" or self._services.state.annotation.annotated:
            self._corrected[number] = None
        else:
            self._corrected.pop(number, None)  # taken back: the track did not pass through it

    def _note_dragged(self, _: str) -> None:
        """The camera of the frame on screen was dragged, or is as it was before that."""
        track, dragged = self._services.shot_track, self._services.corrections.here
        number, before = track.number_here, track.here
        if number is None or before is None or (dragged is None and before.state != "anchor"):
            return
        if dragged is not None:
            track.correct(as_anchor(dragged, number))
        self._corrected[number] = None

    def _only_accepted(self) -> bool:
        """Return whether all that is annotated here was taken over along the track: that is no
        news."""
        name, annotation = self._services.state.frame_name, self._services.state.annotation
        if name is None or not annotation.annotated:
            return False
        kinds = self._services.review.origin_counts(name, annotation)
        return set(kinds) == {OriginKind.ACCEPTED}

    def _follow_corrected(self) -> None:
        """Once a person is done with it: what is between its neighbours is followed again."""
        track = self._services.shot_track
        if self.running or self._services.sequence.value is None or self._services.state.blind:
            return
        for number in [n for n in self._corrected if n != track.number_here]:
            del self._corrected[number]
            within = track.between_anchors(number)
            if within is not None:
                self._begin(number, None, within)
                return


def _followed(frames: int, doubtful: int) -> str:
    if not doubtful:
        return tr_count(
            frames,
            "followed {n:,} frame, all of them sure; Ctrl+Shift+Enter accepts the sure ones",
            "followed {n:,} frames, all of them sure; Ctrl+Shift+Enter accepts the sure ones",
        )
    return tr_count(
        frames,
        "followed {n:,} frame, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter"
        " accepts the sure ones",
        "followed {n:,} frames, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter"
        " accepts the sure ones",
        doubtful=doubtful,
    )


def _follow(asked: _Asked, control: JobControl) -> Track:
    """In a thread."""
    done, total = set[int](), 0  # frames, which may be followed more than once

    def go_on() -> None:
        if control.cancelled:
            raise Stopped

    def on_frame(frame: TrackedFrame) -> None:
        done.add(frame.number)
        control.emit_partial(frame)
        control.progress(len(done), total)

    sequence = asked.sequence
    numbers, within = sequence.unbroken(asked.number), asked.within
    with sequence.open_pictures() as read:
        pictures = UsablePictures(read, numbers, lambda n: f"frame {n}")  # not shown
        if within is None:
            within = shot_range_around(pictures.or_last, asked.number, numbers, go_on)
        else:
            within = range(max(within[0], numbers[0]), min(within[-1], numbers[-1]) + 1)
        total = len(within)
        control.progress(0, total)
        given, clicks = _anchors(asked, pictures, within, go_on)
        anchors = dict(given)
        if asked.camera is not None:
            anchors.setdefault(asked.number, asked.camera)
        shown = field_for_stadium(asked.field, asked.stadium)
        found = track_shot(pictures, within, shown, anchors=anchors, on_frame=on_frame, go_on=go_on)
    frames = []
    for frame in found.frames:
        if (why := pictures.damaged.get(frame.number)) is not None:
            frames.append(lost_frame(frame, why))
        else:
            own = replace(frame, clicks=clicks.get(frame.number, ""))
            frames.append(own if frame.number in given else _not_an_anchor(own))
    return replace(found, frames=tuple(frames))


def _anchors(
    asked: _Asked, pictures: UsablePictures, within: range, go_on: Callable[[], None]
) -> tuple[dict[int, Camera], dict[int, str]]:
    """Cameras by number, and digests of the clicks that some of them were fitted to."""
    picture = pictures(asked.number)
    indices = {n: i for n, i in asked.sequence.index_of.items() if n in within}
    clicked = anchors_of(
        asked.workspace,
        indices,
        asked.field,
        size=(picture.shape[1], picture.shape[0]),
        model=asked.model,
        go_on=go_on,
    )
    dragged = _dragged(asked, pictures, indices, clicked, go_on)
    anchors = {number: anchor.camera for number, anchor in clicked.items()}
    clicks = {number: anchor.clicks for number, anchor in clicked.items() if number not in dragged}
    return anchors | dragged, clicks


def _dragged(
    asked: _Asked,
    pictures: UsablePictures,
    indices: Mapping[int, int],
    clicked: Collection[int],
    go_on: Callable[[], None],
) -> dict[int, Camera]:
    """The cameras that a person dragged, but where the clicks of later say more."""
    found: dict[int, Camera] = {}
    frames = asked.workspace.frames
    for number, index in indices.items():
        name = frames[index].name
        dragged = asked.corrected.get(name)
        if dragged is None:
            continue
        if number in clicked and asked.workspace.read(index) != dragged.annotation:
            continue
        if not dragged.looked:  # the frame was left at once
            field = field_for_frame(asked.field, name)
            dragged = align_to_lines(dragged, pictures(number), field, go_on=go_on)
        if dragged.fit.camera is not None:
            found[number] = dragged.fit.camera
    return found


def _not_an_anchor(frame: TrackedFrame) -> TrackedFrame:
    """A camera that the track began from counts as measured: no one clicked there."""
    return frame if frame.state != "anchor" else replace(frame, state="followed")
