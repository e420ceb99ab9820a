"""What the camera of the frame on screen has of the field in sight: how the field map is turned."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from procc_annotator.camera.base import ElementProjections
from procc_annotator.errors import UsageError
from procc_annotator.gui.state.derived import Derived, Inputs, Where
from procc_annotator.gui.state.foresight import Foresight
from procc_annotator.gui.state.judge import Judge
from procc_annotator.gui.state.signals import Signals
from procc_annotator.gui.state.store import Store
from procc_annotator.interaction.camera_view import VisibleField, visible_field

_KEPT = 8


class MapSight(QObject):
    """Follows the camera that ghosts go by, else the one that is judged.

    While the next one is worked out the sight before stays, so that the map does not flicker with
    every click. A frame without a camera has nothing in sight; its map stays turned as it was, for
    cameras of one set stand on one side. In blind mode nothing of it is reported.
    """

    changed = Signal()

    def __init__(self, store: Store, signals: Signals, foresight: Foresight, judge: Judge) -> None:
        super().__init__(store)
        self._store, self._foresight, self._judge = store, foresight, judge
        self._wanted = True
        self._sight: VisibleField | None = None
        self._sure = True
        self._turns = 0
        self._told: tuple[object, ...] = ()
        self._found = Derived(self._made_of, _look_at, Where.BESIDE, self, kept=_KEPT)
        self._found.changed.connect(self._take)
        signals.datasetChanged.connect(self._begin_anew)
        signals.fieldChanged.connect(self._begin_anew)
        for signal in (signals.frameChanged, signals.scoreChanged, signals.camerasChanged):
            signal.connect(self._found.look_later)
        foresight.changed.connect(self._look)
        signals.blindChanged.connect(self._look)

    @property
    def wanted(self) -> bool:
        """Return whether the map follows the camera."""
        return self._wanted

    def set_wanted(self, wanted: bool) -> None:
        """Turn the map to the side of the camera, or leave the main camera's side below."""
        if wanted != self._wanted:
            self._wanted = wanted
            self._look()

    @property
    def shown(self) -> VisibleField | None:
        """Return what is in sight in the frame on screen; None where no camera is known, or may
        be."""
        return self._sight if self._allowed else None

    @property
    def turns(self) -> int:
        """Quarter turns of the map, see `FieldSight.turns`."""
        return self._turns if self._allowed else 0

    @property
    def half(self) -> int:
        """The half that is in sight alone, see `FieldSight.half`; 0 also by a doubtful camera."""
        return 0 if self.shown is None or not self._sure else self.shown.half

    def close(self) -> None:
        """Work nothing out any more."""
        self._found.close()

    # --- inside ---

    @property
    def _allowed(self) -> bool:
        return self._wanted and self._store.state.projection_visible

    def _made_of(self) -> Inputs | None:
        state = self._store.state
        if not self._allowed or state.frame is None:
            return None
        insight = self._foresight.insight
        if insight is not None and insight.fit.camera is not None:
            return state.sized_field, insight.fit.camera, insight.fit.size
        camera = self._judge.camera
        if camera is None or isinstance(camera, ElementProjections):
            return None
        return state.sized_field, camera, state.setup.size

    def _look(self, *_: object) -> None:
        self._found.look()
        self._take()

    def _begin_anew(self) -> None:
        self._sight, self._turns = None, 0
        self._found.forget()
        self._look()

    def _take(self, *_: object) -> None:
        if not (self._found.working or self._foresight.working):
            self._sight = self._found.value
            self._sure = not (self._foresight.stands_in and self._foresight.doubt)
            if self._sight is not None:
                self._turns = self._sight.turns
        now = self.shown, self.turns, self.half
        if now != self._told:
            self._told = now
            self.changed.emit()


def _look_at(*inputs: object) -> VisibleField | None:
    try:
        return visible_field(*inputs)  # type: ignore[arg-type]
    except UsageError:  # a field that hangs in the air has no ground to turn
        return None
