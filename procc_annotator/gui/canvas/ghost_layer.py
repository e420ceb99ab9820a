"""How the canvas shows ghosts: built anew only when they, the current one or its points change."""

from __future__ import annotations

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.assist.ghost_points import GhostPoints
from procc_annotator.gui.state.document import Document
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.overlay_predictions import build_ghosts, with_next
from procc_annotator.interaction.overlay_primitives import EMPTY_OVERLAY, NO_POINTS, Overlay
from procc_annotator.translation import tr


class GhostLayer:
    """Makes the overlay of ghosts from what the document knows of them."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._made_of: tuple[object, ...] = ()
        self._overlay = EMPTY_OVERLAY

    def overlay(self, *, hidden: bool) -> Overlay:
        """Return what to draw; the same object as long as nothing changed."""
        ghosts, size = self._document.ghosts, self._document.state.picture_size
        painted, current = ghosts.painted, ghosts.current
        found = ghosts.found(current.name) if current is not None else None
        best = ghosts.suggestion
        at = ghosts.suggested_at if ghosts.wanted else None
        if hidden or size is None or not (painted or at):
            self._made_of, self._overlay = (), EMPTY_OVERLAY
            return EMPTY_OVERLAY
        foresight = self._document.foresight
        unsure = foresight.stands_in and bool(foresight.doubt)
        made_of = (*painted, current, found, size, best, at, unsure)
        if made_of != self._made_of:
            self._made_of = made_of
            self._overlay = build_ghosts(
                painted,
                current=current,
                label=self._label(current.name, current.sd_px) if current is not None else "",
                points_px=_points_px(found, size),
                tone=tones.UNSURE_GHOST if unsure else tones.GHOST,
            )
            if best is not None and at is not None and current is None:
                title = tr(self._document.state.field.title_of(best.name))
                label = tr("next: {title}", title=title)
                self._overlay = with_next(self._overlay, at, label, size)
        return self._overlay

    def _label(self, name: str, sd_px: float) -> str:
        foresight, title = self._document.foresight, tr(self._document.state.field.title_of(name))
        if foresight.stands_in and foresight.doubt:
            return tr("{title}  ±{sd:.1f} px  unsure", title=title, sd=sd_px)
        return f"{title}  ±{sd_px:.1f} px"


def _points_px(found: GhostPoints | None, size: tuple[int, int]) -> FloatArray:
    """(N, 2) picture px of what accepting would add."""
    if found is None or not found.points:
        return NO_POINTS
    return np.array([p[:2] for p in found.points]) * (size[0] - 1, size[1] - 1)
