"""What of the state became another, as signals of one subject each; distinguished from this one
place.

==================  ===============================================================================
datasetChanged      another dataset (or none); `frameChanged` follows
frameChanged        another frame is on screen: picture, annotation, selection, scores, save state
                    are all new; no other signal is sent for them
annotationChanged   the frame's annotation: an edit, undo, redo or reload; `scoreChanged` follows
pictureChanged      the picture of the frame: the whole one came after a look at half its size
previewChanged      the annotation as it would be if the mouse button were released now
selectionChanged    selected class or point
hoverChanged        the class under the cursor, in whatever widget
scoreChanged        measurement, threshold, protocol, camera of the frame, or blind mode
fieldChanged        another field, or other dimensions; `scoreChanged` follows
camerasChanged      camera sources were loaded, removed, renamed or are shown otherwise; another one
                    is active or compared
saveStateChanged    whether everything is saved
modeChanged         draw or edit, blind or not, snapping, pinning and the like, who may edit
blindChanged        blind mode is on, or off
message             one line for the user; level "info", "warning" or "error"
==================  ===============================================================================

These are of what the state does not hold:

===================  ==============================================================================
framesEdited         annotations of frames (a list of indices) that need not be on screen
frameScoresChanged   per-frame JaC of one frame, or of all of them ("")
sourceAuditsChanged  (source) more is known of how a source does in the frames of the set
aboutToLeave         the frame on screen is about to be left: finish what is under way
flyTo                show this position of the picture (px)
flyToArea            show this part of the picture (px: left, top, right, bottom)
===================  ==============================================================================
"""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from procc_annotator.gui.state.state import State, same


class Signals(QObject):
    """Compares the state before with the state after and gives what differs."""

    datasetChanged = Signal()
    frameChanged = Signal()
    annotationChanged = Signal()
    pictureChanged = Signal()
    previewChanged = Signal()
    selectionChanged = Signal()
    hoverChanged = Signal()
    scoreChanged = Signal()
    fieldChanged = Signal()
    camerasChanged = Signal()
    saveStateChanged = Signal()
    modeChanged = Signal()
    blindChanged = Signal(bool)
    message = Signal(str, str)

    framesEdited = Signal(list)
    frameScoresChanged = Signal(str)
    sourceAuditsChanged = Signal(object)
    aboutToLeave = Signal()
    flyTo = Signal(float, float)
    flyToArea = Signal(float, float, float, float)

    def tell(self, old: State, new: State) -> None:
        """The state is another one."""
        other_dataset = new.workspace is not old.workspace
        other_frame = other_dataset or new.frame_index != old.frame_index
        other_field = new.field is not old.field
        if other_field:
            self.fieldChanged.emit()
        if other_dataset:
            self.datasetChanged.emit()
        if other_frame:
            self.frameChanged.emit()
        else:
            self._tell_of_frame(old, new, renamed=other_field)
        if _differs(old, new, _sources):
            self.camerasChanged.emit()
        if old.blind != new.blind:
            self.blindChanged.emit(new.blind)
        if _differs(old, new, _scores_of_set):
            self.frameScoresChanged.emit("")
        elif not other_dataset:
            for name in old.committed ^ new.committed:
                self.frameScoresChanged.emit(name)
        if _differs(old, new, _mode):
            self.modeChanged.emit()
        if new.told is not None and new.told is not old.told:
            self.message.emit(new.told.text, new.told.level)

    def _tell_of_frame(self, old: State, new: State, *, renamed: bool) -> None:
        """The same frame is on screen; with another field its elements may bear other names."""
        if new.picture is not old.picture or new.half is not old.half:
            self.pictureChanged.emit()
        if new.annotation is not old.annotation and not renamed:
            self.annotationChanged.emit()
        elif new.shown_annotation is not old.shown_annotation:
            self.previewChanged.emit()
        if not same(new.selection, old.selection):
            self.selectionChanged.emit()
        if new.hovered_class != old.hovered_class:
            self.hoverChanged.emit()
        if _differs(old, new, _judged):
            self.scoreChanged.emit()
        if new.unsaved is not old.unsaved:
            self.saveStateChanged.emit()


def _differs(old: State, new: State, select: Callable[[State], object]) -> bool:
    return not same(select(old), select(new))


def _judged(state: State) -> object:
    """Return what the score of the frame on screen is of, but for a gesture under way."""
    terms = state.setup, state.tau, state.noise_floor, state.projection_visible
    frame = state.annotation, state.counts, state.damage
    return frame, terms, state.active, state.cameras_of(state.active)


def _sources(state: State) -> object:
    """Return how the sources are listed and drawn. Cameras fitted to the clicks come and go with
    these."""
    looks = tuple(
        (k.source, k.name, k.colour, k.visible, k.cameras if k.source.files is not None else None)
        for k in state.looks
    )
    return looks, state.active, state.compared


def _scores_of_set(state: State) -> object:
    return state.active, state.tau, state.blind


def _mode(state: State) -> object:
    return (
        state.mode,
        state.options,
        state.blind,
        state.blind_lock,
        state.holder,
        state.damage,
        state.picture_error,
    )
