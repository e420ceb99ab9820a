"""How surely the live fit knows the ground of the frame on screen, worked out in the background."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Signal

from procc_annotator.camera.backproject import ground_from_px
from procc_annotator.field.model import Field
from procc_annotator.fit.predict.ground_uncertainty import GroundUncertainty, ground_uncertainty
from procc_annotator.fit.result import FitResult
from procc_annotator.gui.state.metre_map_shapes import MapShapes, map_shapes
from procc_annotator.gui.worker import Job, run_in_background
from procc_annotator.interact.map_looks import UNCERTAINTY
from procc_annotator.metric.contours import filled_contours
from procc_annotator.metric.even_grid import value_at

if TYPE_CHECKING:
    from procc_annotator.gui.state.document import Document


@dataclass(frozen=True, eq=False)
class KnownGround:
    """How surely one fit knows the ground.

    Attributes:
        values: the map and its figures.
        picture: its shapes, px of the fit's picture.
        field: its shapes, metres on the ground.
    """

    values: GroundUncertainty
    picture: MapShapes
    field: MapShapes

    def at(self, x: float, y: float) -> float | None:
        """Standard deviation of the ground point at a place of the picture, metres: between the
        samples in proportion.

        Args:
            x, y: px of the fit's picture.

        Returns:
            None off the field and above the horizon.
        """
        known = self.values
        if known.fit.camera is None:
            return None
        ground_x, ground_y = ground_from_px(known.fit.camera, np.array([[x, y]]))[0].tolist()
        return value_at(known.sd_m, known.xs_m, known.ys_m, ground_x, ground_y)


def know_ground(fit: FitResult, field: Field) -> KnownGround:
    """The map of a fit with its shapes; safe from any thread.

    Raises:
        UsageError: the fit has no camera.
    """
    values = ground_uncertainty(fit, field)
    _ = values.statistics  # kept with the values; worked out here, not where it is shown
    x, y = np.meshgrid(values.xs_m, values.ys_m)
    in_sight = filled_contours(values.inside_px, x, y, (0.0, math.inf))[0]
    px = values.points_px
    return KnownGround(
        values,
        map_shapes(UNCERTAINTY, values.sd_m, px[..., 0], px[..., 1]),
        map_shapes(UNCERTAINTY, values.sd_m, x, y, in_sight),
    )


class UncertaintyWatch(QObject):
    """Keeps the map of the live fit while somebody wants to see it; never that of an older fit."""

    changed = Signal()

    def __init__(self, document: Document) -> None:
        super().__init__(document)
        self._document = document
        self.wanted = False
        self._result: KnownGround | None = None
        self._asked: FitResult | None = None
        self._error = ""
        self._job: Job | None = None
        document.live_fit.changed.connect(self.look)
        document.frameChanged.connect(self.look)
        document.modeChanged.connect(self.look)
        document.disagreement.changed.connect(self._give_way)

    @property
    def result(self) -> KnownGround | None:
        """What is to be shown; None while it is being worked out, not wanted, or to be hidden."""
        found = self._result
        current = found is not None and found.values.fit is self._document.live_fit.result
        return found if current and self.wanted else None

    @property
    def problem(self) -> str:
        """Why there is nothing to be shown although somebody wants to see it."""
        if not self.wanted:
            return ""
        document, live = self._document, self._document.live_fit
        if document.frame is None:
            return "Open a folder of pictures first."
        if barred := document.blind_lock.no_fit:
            return f"{barred[0].upper()}{barred[1:]}."
        if not live.allowed:
            return "Blind: hidden until this frame is committed."
        if not live.wanted:
            return "The live fit is off, so there is no uncertainty map (Ctrl+T switches it on)."
        fit = live.result
        if fit is None:
            return "" if live.working else "There is no fit of this frame, so no uncertainty map."
        if fit.camera is None:
            return f"No camera yet, so no uncertainty map: {fit.failure}."
        if self._error:
            return self._error
        found = self.result
        if found is not None and found.values.statistics.median is None:
            return "The fitted camera sees no part of the field."
        return ""

    def set_shown(self, shown: bool) -> None:
        """Whether somebody wants to see it; it takes the place of the disagreement."""
        if shown == self.wanted:
            return
        self.wanted = shown
        if shown:
            self._document.disagreement.set_shown(False)
        self.look()
        self.changed.emit()

    def look(self) -> None:
        """The fit, or whether it may be shown, may be another now."""
        fit = self._document.live_fit.result if self.wanted else None
        if fit is not self._asked:
            self._forget()
            self._asked = fit
            if fit is not None and fit.camera is not None:
                self._start(fit)
        if self.wanted:
            self.changed.emit()

    def _start(self, fit: FitResult) -> None:
        field = self._document.field
        self._job = run_in_background(
            lambda _: know_ground(fit, field),
            on_result=self._arrived,
            on_error=self._failed,
            owner=self,
            urgent=True,
        )

    def _arrived(self, result: KnownGround) -> None:
        self._job = None
        self._result = result
        self.changed.emit()

    def _failed(self, text: str) -> None:
        self._job = None
        self._error = text
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
        self._result, self._error = None, ""

    def _give_way(self) -> None:
        if self._document.disagreement.wanted:
            self.set_shown(False)
