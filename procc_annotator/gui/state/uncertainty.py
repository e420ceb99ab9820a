"""How surely the live fit knows the ground of the frame on screen, worked out in the background."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from procc_annotator.calibration.prediction.uncertainty import (
    GroundUncertainty,
    map_ground_uncertainty,
)
from procc_annotator.calibration.result import FitResult
from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.field.model import Field
from procc_annotator.gui.state.blind_lock import BlindLock
from procc_annotator.gui.state.derived import Derived, Inputs, Where
from procc_annotator.gui.state.disagreement import DisagreementWatch
from procc_annotator.gui.state.live_fit import LiveFit
from procc_annotator.gui.state.metre_map_shapes import MapShapes, map_shapes
from procc_annotator.gui.state.signals import Signals
from procc_annotator.gui.state.store import Store
from procc_annotator.interaction.camera_view import UNCERTAINTY
from procc_annotator.metrics.error_maps import bilinear_value, filled_contours
from procc_annotator.translation import tr


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
        return bilinear_value(known.sd_m, known.xs_m, known.ys_m, ground_x, ground_y)


def know_ground(fit: FitResult, field: Field) -> KnownGround:
    """The map of a fit with its shapes; safe from any thread.

    Raises:
        UsageError: the fit has no camera.
    """
    values = map_ground_uncertainty(fit, field)
    _ = values.statistics  # kept with the values; worked out here, not where it is shown
    x, y = np.meshgrid(values.xs_m, values.ys_m)
    in_sight = filled_contours(values.distance_to_border_px, x, y, (0.0, math.inf))[0]
    px = values.points_px
    return KnownGround(
        values,
        map_shapes(UNCERTAINTY, values.sd_m, px[..., 0], px[..., 1]),
        map_shapes(UNCERTAINTY, values.sd_m, x, y, in_sight),
    )


class UncertaintyWatch(Derived[KnownGround]):
    """The map of the live fit, once a person wants to see it."""

    def __init__(
        self,
        store: Store,
        signals: Signals,
        live_fit: LiveFit,
        blind_lock: BlindLock,
        disagreement: DisagreementWatch,
    ) -> None:
        super().__init__(
            self._made_of,
            know_ground,
            Where.BESIDE,
            store,
            wanted=False,
            after=(
                live_fit.changed,
                signals.annotationChanged,  # never shown of the fit before an edit
                signals.frameChanged,
                signals.modeChanged,
            ),
        )
        self._store, self._live_fit = store, live_fit
        self._blind_lock, self._disagreement = blind_lock, disagreement
        disagreement.changed.connect(self._give_way)

    @property
    def problem(self) -> str:
        """Why there is nothing to be shown, or little, although a person wants to see it."""
        if problem := super().problem:
            return problem
        found = self.value
        nothing = found is not None and found.values.statistics.median is None
        return tr("The fitted camera sees no part of the field.") if nothing else ""

    def set_wanted(self, wanted: bool) -> None:
        """Whether a person wants to see it; it takes the place of the disagreement."""
        if wanted:
            self._disagreement.set_wanted(False)
        super().set_wanted(wanted)

    def _made_of(self) -> Inputs | str | None:
        state, live = self._store.state, self._live_fit
        if state.frame is None:
            return tr("Open a folder of pictures first.")
        if barred := self._blind_lock.no_fit:
            return f"{barred[0].upper()}{barred[1:]}."
        if not live.allowed:
            return tr("Blind: hidden until this frame is committed.")
        if not live.wanted:
            return tr(
                "The live fit is off, so there is no uncertainty map (Ctrl+T switches it on)."
            )
        fit = live.result
        if fit is None:
            if live.working:
                return None
            return tr("There is no fit of this frame, so no uncertainty map.")
        if fit.camera is None:
            return tr("No camera yet, so no uncertainty map: {why}.", why=fit.failure)
        return fit, state.sized_field

    def _give_way(self) -> None:
        if self._disagreement.wanted:
            self.set_wanted(False)
