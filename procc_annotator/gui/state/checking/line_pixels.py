"""Line pixels of the picture along the annotated elements, found in the background."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.assist.line_evidence import line_evidence
from procc_annotator.calibration.label_check.evidence import LineEvidence
from procc_annotator.field.model import Field
from procc_annotator.gui.state.background import ComputedValue, Inputs
from procc_annotator.gui.state.state import same
from procc_annotator.gui.state.store import Store
from procc_annotator.image.pixels import PixelArray

Evidence = Mapping[Polyline, LineEvidence]
_STAYED_MS = 150  # a frame that is left sooner was only passed
_KEPT = 8


class LinePixels(ComputedValue[Evidence]):
    """Line pixels along each element; from the picture alone, so that blind mode may show them.

    An element that did not change is not examined again.

    Attributes:
        shown: whether a person wants to see it next to the annotation; findings go by it anyway.
    """

    def __init__(self, store: Store) -> None:
        super().__init__(
            self._made_of,
            self._look_for,
            store,
            cache_size=_KEPT,
            cache_scope=lambda: store.state.frame_name,  # each holds the frame's picture
            stoppable=True,
            delay_ms=self._wait,
        )
        self._store, self.shown = store, False
        store.keep_current(self)
        self._frame: str | None = None
        self._before: tuple[tuple[object, ...], Evidence] | None = None  # picture and field

    def set_shown(self, shown: bool) -> None:
        """Draw it next to the annotation, or do not."""
        if shown != self.shown:
            self.shown = shown
            self.changed.emit()

    # --- inside ---

    def _made_of(self) -> Inputs | None:
        state = self._store.state
        if state.picture is None:
            return None
        return state.annotation, state.picture, state.field

    def _wait(self, _: Inputs) -> int:
        name, before = self._store.state.frame_name, self._frame
        self._frame = name
        return _STAYED_MS if name != before else 0

    def _look_for(
        self,
        annotation: FrameAnnotation,
        picture: PixelArray,
        field: Field,
        *,
        go_on: Callable[[], None],
    ) -> Evidence:
        """Find line pixels; runs in a thread, one at a time."""
        of, before = (picture, field), self._before
        known = before[1] if before is not None and same(before[0], of) else None
        found = line_evidence(annotation, picture, field, known, go_on)
        self._before = of, found
        return found
