"""Snapping of clicks to the centre of line markings in the picture on screen."""

from __future__ import annotations

from procc_annotator.assist.line_evidence import ExpectedLines
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.state import same
from procc_annotator.image.line_snapping import SNAP_RADIUS_PX, snap_to_line
from procc_annotator.image.pixels import PixelArray
from procc_annotator.interaction.gestures import Position, Snapper

_KEPT = 16
_HAND_PX, _LEAST_SCALE = 8.0, 1 / 6  # so far a hand is off, px of the screen; down to this scale

Sought = tuple[str, Position, Position | None]


class ScreenSnapper:
    """A `Snapper` that knows the picture, the field and the fitted camera as they are now.

    It looks for each line once: a click, its hint and what is drawn of it ask for the same. Who
    draws before the mouse moved takes what is `remembered`: looking takes as long as painting.
    """

    def __init__(self, services: Services) -> None:
        self._services = services
        self.view_scale = 1.0  # screen px per picture px
        self._made_of: tuple[object, ...] = ()
        self._snap: Snapper | None = None
        self._found: dict[Sought, Position | None] = {}  # the latest last
        services.store.watch(select.frame, self._forget)

    @property
    def wanted(self) -> bool:
        """Return whether clicks are to snap, and there is a picture to look in."""
        state = self._services.state
        return state.options.snapping and state.picture is not None

    def __call__(
        self, class_name: str, position: Position, direction: Position | None
    ) -> Position | None:
        if not self._is_ready() or self._snap is None:
            return None
        sought = class_name, position, direction
        if sought not in self._found:
            if len(self._found) == _KEPT:
                del self._found[next(iter(self._found))]
            self._found[sought] = self._snap(*sought)
        return self._found[sought]

    def remembered(
        self, class_name: str, position: Position, direction: Position | None
    ) -> Position | None:
        """The same, if it was looked for before."""
        return self._found.get((class_name, position, direction)) if self._is_ready() else None

    def _is_ready(self) -> bool:
        """Return whether there is something to look in; what was found in another picture, or with
        another camera, is forgotten."""
        services = self._services
        # No one waits for the whole picture who only looks: a press does (`Canvas`).
        picture, fit = services.state.picture, services.live_fit.result
        size = services.state.picture_size
        if picture is None or size is None:
            return False
        camera = fit.camera if fit is not None and fit.size == size else None
        made_of = picture, services.state.field, camera, self.view_scale
        if self._snap is None or not same(made_of, self._made_of):
            self._made_of = made_of
            expected = ExpectedLines(services.state.field, size[0], camera)
            self._snap, self._found = _snapper(picture, expected, self.view_scale), {}
        return True

    def _forget(self) -> None:
        """They hold the picture."""
        self._snap, self._found, self._made_of = None, {}, ()


def _snapper(picture: PixelArray, expected: ExpectedLines, view_scale: float) -> Snapper:
    by_hand = max(SNAP_RADIUS_PX, _HAND_PX / max(view_scale, _LEAST_SCALE))

    def snapped(class_name: str, position: Position, direction: Position | None) -> Position | None:
        sought, shown = expected.at(class_name, position)
        reach = by_hand if sought.is_pale_line else SNAP_RADIUS_PX
        return snap_to_line(picture, position, sought, direction=direction or shown, reach_px=reach)

    return snapped
