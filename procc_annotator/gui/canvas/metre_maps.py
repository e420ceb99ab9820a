"""The map in metres over the picture, whichever is wanted, and what its colours mean."""

from __future__ import annotations

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QGraphicsScene, QWidget

from procc_annotator.gui.canvas.metre_map_item import MetreMapItem
from procc_annotator.gui.canvas.metre_map_legend import MapWords, MetreMapLegend
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.maps import KnownGround
from procc_annotator.interaction.camera_view import DISAGREEMENT, UNCERTAINTY
from procc_annotator.metrics.error_maps import OFFSIDE_ACCURACY_M
from procc_annotator.translation import tr


class MetreMaps(QObject):
    """Belongs to the canvas: shows the disagreement of two cameras, or the uncertainty of the
    fitted one; never both."""

    def __init__(self, document: Document, viewport: QWidget, scene: QGraphicsScene) -> None:
        super().__init__(viewport)
        self._document = document
        self._hidden = False
        self.item = MetreMapItem()
        scene.addItem(self.item)
        self.legend = MetreMapLegend(viewport)
        document.disagreement.changed.connect(self._show)
        document.uncertainty.changed.connect(self._show)

    def set_hidden(self, hidden: bool) -> None:
        """Whether overlays are hidden."""
        if hidden != self._hidden:
            self._hidden = hidden
            self._show()

    def place(self) -> None:
        """Arrange everything in the viewport as it is now."""
        self.legend.place()

    def _show(self) -> None:
        if self._hidden or self._document.state.frame is None:
            self._show_nothing()
        elif self._document.uncertainty.enabled:
            self._show_uncertainty()
        else:
            self._show_disagreement()

    def _show_nothing(self) -> None:
        self.item.show_shapes(None, (0, 0), None)
        self.legend.hide()

    def _show_disagreement(self) -> None:
        document, watch = self._document, self._document.disagreement
        found = watch.value
        shown = found.picture if found is not None else None
        self.item.show_shapes(shown, document.state.setup.size, document.state.picture_size)
        if found is not None:
            title = f"{found.names[0]} ↔ {found.names[1]}"
            limit = tr("{metres:g} m, asked of offside technology", metres=OFFSIDE_ACCURACY_M)
            words = MapWords(title, tr("metres on the ground"), (limit,))
            self.legend.show_for(DISAGREEMENT, words, watch.problem)
        elif watch.problem:
            self.legend.show_for(DISAGREEMENT, None, watch.problem)
        else:
            self.legend.hide()

    def _show_uncertainty(self) -> None:
        watch = self._document.uncertainty
        found = watch.value
        if found is None:
            self.item.show_shapes(None, (0, 0), None)
        else:
            size = found.values.fit.size
            self.item.show_shapes(found.picture, size, self._document.state.picture_size)
        if watch.problem:
            self.legend.show_for(UNCERTAINTY, None, watch.problem)
        else:
            self.legend.show_for(UNCERTAINTY, _words(found))


def _words(found: KnownGround | None) -> MapWords:
    """Return what the legend says of the ground; the same room is taken while it is worked out."""
    title, unit = tr("How good the fitted camera is"), tr("metres on the ground, 1 sd")
    lines = []
    for line in UNCERTAINTY.lines:
        share = found.values.share_within_m(line.metres) if found is not None else None
        if share is None:
            lines.append(f"{line.metres:g} m: …")
        else:
            lines.append(
                tr(
                    "{metres:g} m: {percent:.0f} % of the field in sight",
                    metres=line.metres,
                    percent=100 * share,
                )
            )
    if found is not None:
        title = tr("How good the fitted camera ({model}) is", model=found.values.fit.model)
        if (median := found.values.statistics.median) is not None:
            unit = tr("metres on the ground, 1 sd, median {median:.2f}", median=median)
    return MapWords(title, unit, tuple(lines))
