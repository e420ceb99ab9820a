"""Where the active and the compared source disagree on the ground, worked out in the background."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from procc_annotator.camera.base import Camera, CameraOrProjections, ElementProjections
from procc_annotator.field.model import Field
from procc_annotator.gui.state.derived import Derived, Inputs, Where
from procc_annotator.gui.state.metre_map_shapes import MapShapes, shapes_in_picture, shapes_on_field
from procc_annotator.gui.state.signals import Signals
from procc_annotator.gui.state.source_frames import SourceFrames
from procc_annotator.gui.state.store import Store
from procc_annotator.metrics.error_maps import Disagreement, bilinear_value, disagreement
from procc_annotator.translation import tr

_SAME_M = 1e-6


@dataclass(frozen=True, eq=False)
class Compared:
    """Two sources compared in the frame on screen.

    Attributes:
        names: of the active and of the compared source.
        values: the disagreement, px of the evaluation size and metres.
        picture: its shapes, px of the evaluation size.
        field: its shapes, metres on the ground as the active source sees it.
    """

    names: tuple[str, str]
    values: Disagreement
    picture: MapShapes
    field: MapShapes

    @property
    def same(self) -> bool:
        """Return whether both mean the same point by every pixel."""
        largest = self.values.statistics.metres.maximum
        return largest is not None and largest < _SAME_M

    def at(self, x: float, y: float) -> tuple[float, float] | None:
        """Metres and pixels between the two at a place of the picture, px of the evaluation size;
        between the samples in proportion, None where one of them does not count."""
        grid = self.values.xs_px, self.values.ys_px
        metres = bilinear_value(self.values.metres, *grid, x, y)
        pixels = bilinear_value(self.values.pixels, *grid, x, y)
        return None if metres is None or pixels is None else (metres, pixels)


class DisagreementWatch(Derived[Compared]):
    """The disagreement in the frame on screen, once a person wants to see it."""

    def __init__(self, store: Store, signals: Signals, source_frames: SourceFrames) -> None:
        super().__init__(
            self._made_of,
            compare_cameras,
            Where.BESIDE,
            store,
            wanted=False,
            after=(
                signals.frameChanged,
                signals.scoreChanged,
                signals.camerasChanged,
                source_frames.changed,
            ),
        )
        self._store, self._source_frames = store, source_frames

    @property
    def problem(self) -> str:
        """Why there is nothing to be shown, or little, although a person wants to see it."""
        if problem := super().problem:
            return problem
        found = self.value
        if found is not None and found.values.statistics.metres.maximum is None:
            return tr("The two see no part of the field in common in this frame.")
        if found is not None and found.same:
            return tr("Both cameras are the same in this frame.")
        return ""

    def _made_of(self) -> Inputs | str | None:
        state = self._store.state
        a, b = state.active, state.compared
        if not state.projection_visible:
            return tr("Blind: hidden until this frame is committed.")
        if state.frame is None:
            return tr("Open a folder of pictures first.")
        if a is None and len(state.sources) > 1:
            return tr("No source is judged: choose one first.")
        if a is None or b is None:
            return tr("Two sources of cameras are needed: load another one.")
        shown = [self._source_frames.of(source) for source in (a, b)]
        cameras = [each.camera for each in shown if each is not None]
        if len(cameras) < 2:
            return None  # they are being read
        names, setup = (a.name, b.name), state.setup
        if why := _why_not(names, cameras):
            return why
        return names, *cameras, state.sized_field, setup.size


def _why_not(names: tuple[str, str], cameras: Sequence[CameraOrProjections | None]) -> str:
    """Why two cameras cannot be compared; empty where they can."""
    named = list(zip(names, cameras, strict=True))
    without = [name for name, camera in named if camera is None]
    if without:
        return tr("{names}: no camera for this frame.", names=_both(without))
    projections = [name for name, camera in named if isinstance(camera, ElementProjections)]
    if not projections:
        return ""
    if len(projections) == 1:
        return tr(
            "{name} shares only where the elements are shown, no camera: there is no ground to"
            " compare.",
            name=projections[0],
        )
    return tr(
        "{names} share only where the elements are shown, no camera: there is no ground to"
        " compare.",
        names=_both(projections),
    )


def _both(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else tr("{a} and {b}", a=names[0], b=names[1])


def compare_cameras(
    names: tuple[str, str], a: Camera, b: Camera, field: Field, size: tuple[int, int]
) -> Compared:
    """Compare two cameras of a frame, px of ``size``; safe from any thread.

    Raises:
        UsageError: one of them shares only projections.
    """
    values = disagreement(a, b, field, size)
    _ = values.statistics  # kept with the values; worked out here, not where it is shown
    return Compared(names, values, shapes_in_picture(values), shapes_on_field(values))
