"""Where the active and the compared source disagree on the ground, worked out in the background."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from procc_annotator.camera.base import Camera
from procc_annotator.camera.projections import CameraOrProjections, ElementProjections
from procc_annotator.field.model import Field
from procc_annotator.gui.state.metre_map_shapes import MapShapes, shapes_in_picture, shapes_on_field
from procc_annotator.gui.worker import Job, run_in_background
from procc_annotator.metric.disagreement import Disagreement, disagreement
from procc_annotator.metric.even_grid import value_at

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document

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
        """Whether both mean the same point by every pixel."""
        largest = self.values.statistics.metres.maximum
        return largest is not None and largest < _SAME_M

    def at(self, x: float, y: float) -> tuple[float, float] | None:
        """Metres and pixels between the two at a place of the picture, px of the evaluation size;
        between the samples in proportion, None where one of them does not count."""
        grid = self.values.xs_px, self.values.ys_px
        metres = value_at(self.values.metres, *grid, x, y)
        pixels = value_at(self.values.pixels, *grid, x, y)
        return None if metres is None or pixels is None else (metres, pixels)


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


class DisagreementWatch(QObject):
    """Keeps the disagreement of the frame on screen while somebody wants to see it."""

    changed = Signal()

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._document = document
        self.wanted = False
        self._result: Compared | None = None
        self._problem = ""
        self._asked: tuple[object, ...] | None = None
        self._job: Job | None = None

    @property
    def result(self) -> Compared | None:
        """What is to be shown; None while it is being worked out, not wanted, or to be hidden."""
        visible = self.wanted and self._document.projection_visible
        return self._result if visible else None

    @property
    def problem(self) -> str:
        """Why there is nothing to be shown although somebody wants to see it."""
        if not self.wanted:
            return ""
        if not self._document.projection_visible:
            return "Blind: hidden until this frame is committed."
        return self._problem

    def set_shown(self, shown: bool) -> None:
        """Whether somebody wants to see it."""
        if shown != self.wanted:
            self.wanted = shown
            self.look()
            self.changed.emit()

    def look(self) -> None:
        """Frame, sources, terms or blind mode may be others now."""
        if not self.wanted:
            self._forget()
            self._asked = None
            return
        document = self._document
        a, b = document.active_source, document.compared
        shown_a, shown_b = document.source_frames.of(a), document.source_frames.of(b)
        frame = document.frame.name if document.frame is not None else None
        names = (a.name if a else "", b.name if b else "")
        visible, number = document.projection_visible, len(document.sources)
        terms = document.setup.size, document.field
        asked = frame, *names, shown_a, shown_b, *terms, visible, number
        if asked == self._asked:
            return
        self._asked = asked
        self._forget()
        if frame is None:
            self._problem = "Open a folder of pictures first."
        elif a is None and number > 1:
            self._problem = "No source is judged: choose one first."
        elif a is None or b is None:
            self._problem = "Two sources of cameras are needed: load another one."
        elif shown_a is not None and shown_b is not None:
            self._start(names, shown_a.camera, shown_b.camera)
        self.changed.emit()

    def _start(
        self,
        names: tuple[str, str],
        a: CameraOrProjections | None,
        b: CameraOrProjections | None,
    ) -> None:
        without = [name for name, camera in zip(names, (a, b), strict=True) if camera is None]
        projections = [
            name
            for name, camera in zip(names, (a, b), strict=True)
            if isinstance(camera, ElementProjections)
        ]
        if without:
            self._problem = f"{' and '.join(without)}: no camera for this frame."
        elif projections:
            verb = "shares" if len(projections) == 1 else "share"
            self._problem = (
                f"{' and '.join(projections)} {verb} only where the elements are shown, no camera:"
                " there is no ground to compare."
            )
        if not isinstance(a, Camera) or not isinstance(b, Camera):
            return
        field, size = self._document.field, self._document.setup.size
        self._job = run_in_background(
            lambda _: compare_cameras(names, a, b, field, size),
            on_result=self._arrived,
            on_error=self._failed,
            owner=self,
            urgent=True,
        )

    def _arrived(self, result: Compared) -> None:
        self._job = None
        self._result = result
        if result.values.statistics.metres.maximum is None:
            self._problem = "The two see no part of the field in common in this frame."
        elif result.same:
            self._problem = "Both cameras are the same in this frame."
        self.changed.emit()

    def _failed(self, text: str) -> None:
        self._job = None
        self._problem = text
        self.changed.emit()

    def close(self) -> None:
        """Work nothing out any more."""
        self.wanted = False
        self._forget()

    def _forget(self) -> None:
        """What was shown or asked for is not wanted any more."""
        if self._job is not None:
            self._job.cancel()
            self._job = None
        self._result, self._problem = None, ""
