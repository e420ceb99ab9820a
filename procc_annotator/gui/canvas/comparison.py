"""Overlays of sources other than the judged one: wireframes, blink, split view."""

from __future__ import annotations

from time import monotonic

from PySide6.QtCore import QObject, QRect, QRectF
from PySide6.QtWidgets import QGraphicsScene, QWidget

from procc_annotator.gui.canvas.overlay_item import OverlayItem
from procc_annotator.gui.canvas.viewport_overlays import NamePlate, SplitView
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.services import Services
from procc_annotator.interaction.overlay_lines import build_wireframes
from procc_annotator.interaction.overlay_primitives import EMPTY_OVERLAY
from procc_annotator.metrics.measurement import Measurement
from procc_annotator.metrics.projection import ProjectedField
from procc_annotator.metrics.score import FrameScore
from procc_annotator.translation import tr

_TAP_S = 0.3  # a key held longer than that is let go of, not tapped
_PLACE = 10

Judged = tuple[Measurement | None, FrameScore | None]


class OtherSources(QObject):
    """Belongs to the canvas, which draws the source in front; this draws everything else.

    The source in front is the active one, or the compared one while it is being examined (a key
    held). In a split view the source in front has the left side, the other of the two the right.
    """

    def __init__(
        self, services: Services, viewport: QWidget, scene: QGraphicsScene, front: OverlayItem
    ) -> None:
        super().__init__(viewport)
        self._services = services
        self._viewport = viewport
        self._front_item = front
        self.wireframes = EMPTY_OVERLAY
        self.other_side = OverlayItem()
        self.other_side.setVisible(False)
        scene.addItem(self.other_side)
        self.split = SplitView(viewport)
        self.split.moved.connect(self._move_divider)
        self._plate = NamePlate(viewport, "blinkName")
        self.split_wanted = False
        self.others_wanted = True
        self._held_since: float | None = None
        self._wired: tuple[object, ...] = ()

    # --- which source is where ------------------------------------------------------------

    @property
    def looking(self) -> bool:
        """Return whether the compared source is in front for as long as a key is held."""
        return self._held_since is not None and self._services.state.compared is not None

    @property
    def divided(self) -> bool:
        """Return whether the picture is divided between two sources."""
        services = self._services
        visible = services.state.projection_visible and services.state.frame is not None
        return self.split_wanted and visible and services.state.compared is not None

    @property
    def front(self) -> CameraSource | None:
        """The source with its verdicts drawn; the left one of two sides."""
        services = self._services
        return services.state.compared if self.looking else services.state.active

    @property
    def right(self) -> CameraSource | None:
        """The source of the right side."""
        services = self._services
        return services.state.active if self.looking else services.state.compared

    @property
    def judged(self) -> Judged:
        """Measurement and score of the source in front."""
        services = self._services
        if self.looking:
            return services.scorer.compared
        return services.scorer.measurement, services.scorer.score

    @property
    def judged_right(self) -> Judged:
        """Measurement and score of the source on the right."""
        services = self._services
        if self.looking:
            return services.scorer.measurement, services.scorer.score
        return services.scorer.compared

    # --- blinking -------------------------------------------------------------------------

    def hold(self) -> bool:
        """Look at the compared source until `let_go`; False if absent."""
        if self._services.state.compared is None:
            return False
        self._held_since = monotonic()
        return True

    def let_go(self) -> bool:
        """Back to the active source; True after a mere tap, which means to stay."""
        since, self._held_since = self._held_since, None
        return since is not None and monotonic() - since < _TAP_S

    # --- drawing --------------------------------------------------------------------------

    def refresh(self, *, hidden: bool) -> None:
        """Draw anew what changed, except the overlays of both sides, which the canvas makes."""
        was_divided = self.split.shown
        self._make_wireframes(hidden=hidden)
        self._name_sides(hidden=hidden)
        divided = self.split.shown
        self._front_item.set_wireframes(self.wireframes)
        self.other_side.set_wireframes(self.wireframes if divided else EMPTY_OVERLAY)
        self._take_sides()
        if divided != was_divided:
            self.other_side.setVisible(divided)
            self._viewport.update()

    def view_changed(self) -> None:
        """Place or zoom of the picture changed: what is painted scrolled, but not the divider."""
        if self.split.shown:
            self.split.place()
            self._viewport.update()
        else:
            self._front_item.place_labels()

    def place(self) -> None:
        """Arrange everything in the viewport as it is now."""
        self.split.place()
        self._take_sides()

    def set_top(self, top: int) -> None:
        """Place the names of the sides below ``top`` screen px, which bars cover."""
        self.split.top = top
        self.split.place()
        if not self._plate.isHidden():
            self._plate.put(self._plate.geometry().translated(0, _PLACE + top - self._plate.y()))

    def item_at(self, x: float) -> OverlayItem:
        """The item that paints the overlay at a place of the viewport."""
        return self.other_side if self.split.shown and x >= self.split.x else self._front_item

    def _make_wireframes(self, *, hidden: bool) -> None:
        services, size = self._services, self._services.state.picture_size
        shown: list[tuple[ProjectedField, str]] = []
        if size is not None and not hidden and self.others_wanted:
            shown = [(projected, source.colour) for source, projected in self._others()]
        wired = (size, services.state.setup.size, *shown)
        if wired == self._wired:
            return
        self._wired = wired
        self.wireframes = EMPTY_OVERLAY
        if shown and size is not None:
            self.wireframes = build_wireframes(shown, services.state.setup.size, size)

    def _others(self) -> list[tuple[CameraSource, ProjectedField]]:
        """Return what the visible sources that have no place of their own show of this frame."""
        services = self._services
        if services.state.active is None or not services.state.projection_visible:
            return []
        placed = {self.front, self.right} if self.divided else {self.front}
        shown = []
        for source in services.state.sources:
            known = services.source_frames.of(source) if source.visible else None
            if source not in placed and known is not None and known.projected is not None:
                shown.append((source, known.projected))
        return shown

    def names_of_others(self) -> tuple[tuple[str, str], ...]:
        """Names and colours of the sources drawn as wireframes."""
        drawn = self._others() if self.others_wanted else ()
        return tuple((source.name, source.colour) for source, _ in drawn)

    def _name_sides(self, *, hidden: bool) -> None:
        front, right = self.front, self.right
        if self.divided and not hidden and front is not None and right is not None:
            self.split.show_names(
                (self._caption(front, self.judged), front.colour),
                (self._caption(right, self.judged_right), right.colour),
            )
        elif self.split.shown:
            self.split.hide()
        looking = self.looking and self._services.state.projection_visible
        if looking and not self.split.shown and not hidden and front is not None:
            self._plate.say(self._caption(front, self.judged), front.colour)
            wanted = self._plate.wanted_size()
            room = self._viewport.width() - 2 * _PLACE
            top = _PLACE + self.split.top
            self._plate.put(QRect(_PLACE, top, min(wanted.width(), room), wanted.height()))
            self._plate.show()
            self._plate.raise_()
        else:
            self._plate.hide()

    def _caption(self, source: CameraSource, judged: Judged) -> str:
        known, score = self._services.source_frames.of(source), judged[1]
        if score is not None:
            jac = "–" if self._services.state.why_not_judged else f"{score.jac:.3f}"
            return f"{source.name}  ·  JaC {jac}"
        unreadable = known is not None and known.error
        return (
            f"{source.name}  ·  {tr('camera unreadable') if unreadable else tr('no camera here')}"
        )

    def _take_sides(self) -> None:
        """Which part of the viewport each source is drawn in."""
        if not self.split.shown:
            self._front_item.side = self.other_side.side = None
            return
        x, size = self.split.x, self._viewport.size()
        self._front_item.side = QRectF(0, 0, x, size.height())
        self.other_side.side = QRectF(x, 0, size.width() - x, size.height())

    def _move_divider(self, before: float, after: float) -> None:
        self._take_sides()
        left, right = sorted((int(before), int(after)))
        self._viewport.update(QRect(left - 2, 0, right - left + 4, self._viewport.height()))
        for item in (self._front_item, self.other_side):
            item.place_labels()
