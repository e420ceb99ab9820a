"""Where a click goes: to the middle of the paint that is looked for, in the picture on screen."""

from __future__ import annotations

from functools import lru_cache

from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.state import same
from procc_annotator.image.paint import snap
from procc_annotator.image.pixels import PixelArray
from procc_annotator.interact.gesture import Position, Snapper
from procc_annotator.session.strokes.expected_paint import ExpectedPaint

_KEPT = 16


class ScreenSnapper:
    """A `Snapper` that knows the picture, the field and the fitted camera as they are now.

    It looks for each line once: a click, its hint and what is drawn of it ask for the same.
    """

    def __init__(self, document: Document) -> None:
        self._document = document
        self._made_of: tuple[object, ...] = ()
        self._snap: Snapper | None = None
        document.frameChanged.connect(self._forget)

    @property
    def wanted(self) -> bool:
        """Whether clicks are to snap, and there is a picture to look in."""
        state = self._document.state
        return state.options.snapping and state.picture is not None

    def __call__(
        self, class_name: str, position: Position, direction: Position | None
    ) -> Position | None:
        document = self._document
        # Nobody waits for the whole picture who only looks: a press does (`Canvas`).
        picture, fit = document.state.picture, document.live_fit.result
        size = document.picture_size
        if picture is None or size is None:
            return None
        camera = fit.camera if fit is not None and fit.size == size else None
        made_of = picture, document.field, camera
        if self._snap is None or not same(made_of, self._made_of):
            self._made_of = made_of
            expected = ExpectedPaint(document.field, size[0], camera)
            self._snap = lru_cache(_KEPT)(_snapper(picture, expected))
        return self._snap(class_name, position, direction)

    def _forget(self) -> None:
        """They hold the picture."""
        self._snap, self._made_of = None, ()


def _snapper(picture: PixelArray, expected: ExpectedPaint) -> Snapper:
    def snapped(class_name: str, position: Position, direction: Position | None) -> Position | None:
        sought, shown = expected.at(class_name, position)
        return snap(picture, position, sought, direction=direction or shown)

    return snapped
