"""Cameras that a person corrected by hand, frame by frame, and what became of them on paint."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from procc_annotator.assist.track_anchors import CameraCorrection, align_to_lines
from procc_annotator.field.load import field_for_frame
from procc_annotator.field.model import Field
from procc_annotator.gui.state.derived import Derived, Inputs, Where
from procc_annotator.gui.state.proposals import Proposals
from procc_annotator.gui.state.signals import Signals
from procc_annotator.gui.state.store import Store
from procc_annotator.image.pixels import PixelArray


class Corrections(QObject):
    """Commands on the state's ``corrected``. Nothing of it is saved: what a person accepts along a
    corrected camera is an edit like any other.
    """

    changed = Signal(str)  # the frame whose camera is corrected otherwise, or not any more

    def __init__(self, store: Store, signals: Signals, proposals: Proposals) -> None:
        super().__init__(store)
        self._store, self._proposals = store, proposals
        self._before: dict[str, list[CameraCorrection | None]] = {}  # steps that can be taken back
        self._look = Derived(self._to_look_at, _look_at, Where.BESIDE, self, stoppable=True)
        self._look.changed.connect(self._take)
        for signal in (signals.frameChanged, signals.pictureChanged, signals.modeChanged):
            signal.connect(self._look.look_later)
        signals.datasetChanged.connect(self._forget)
        signals.fieldChanged.connect(self._forget)

    @property
    def here(self) -> CameraCorrection | None:
        """That of the frame on screen; None if absent, and while it is to be hidden."""
        state = self._store.state
        if state.frame_name is None or not self._proposals.allowed:
            return None
        return state.corrected.get(state.frame_name)

    @property
    def rules(self) -> bool:
        """Return whether nothing was annotated here since the camera was corrected."""
        found = self.here
        return found is not None and found.annotation == self._store.state.annotation

    @property
    def looking(self) -> bool:
        """Return whether the lines of the camera on screen are being looked for."""
        return self._look.working

    def put(self, correction: CameraCorrection | None) -> None:
        """This is the camera of the frame on screen; None: it is corrected no more."""
        name = self._store.state.frame_name
        if name is not None:
            self._before.setdefault(name, []).append(self._store.state.corrected.get(name))
            self._set(name, correction)

    def take_back(self) -> bool:
        """The camera of the frame on screen is as it was before the last correction; False if there
        was none."""
        name = self._store.state.frame_name
        before = self._before.get(name or "")
        if name is None or not before or not self._proposals.allowed:
            return False
        self._set(name, before.pop())
        return True

    def close(self) -> None:
        """Look for nothing any more."""
        self._look.close()

    # --- inside ---

    def _set(self, name: str, correction: CameraCorrection | None) -> None:
        others = {n: c for n, c in self._store.state.corrected.items() if n != name}
        if correction is not None:
            others[name] = correction
        self._store.set(corrected=others)
        self._look.look()
        self.changed.emit(name)

    def _to_look_at(self) -> Inputs | None:
        state, found = self._store.state, self.here
        if found is None or found.looked or state.picture is None or state.frame_name is None:
            return None
        return found, state.picture, state.field, state.frame_name

    def _take(self) -> None:
        """Keep what was found; it is no step of its own."""
        found, name = self._look.value, self._store.state.frame_name
        if found is not None and name is not None:
            self._set(name, found)

    def _forget(self) -> None:
        self._before.clear()
        if self._store.state.corrected:
            self._store.set(corrected={})
            self.changed.emit("")


def _look_at(
    found: CameraCorrection,
    picture: PixelArray,
    field: Field,
    frame: str,
    *,
    go_on: Callable[[], None],
) -> CameraCorrection:
    return align_to_lines(found, picture, field_for_frame(field, frame), go_on=go_on)
