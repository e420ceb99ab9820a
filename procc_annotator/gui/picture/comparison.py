"""What is drawn of the sources beside the one that is judged: wireframes, blink, split view."""

from __future__ import annotations

from time import monotonic

from PySide6.QtCore import QObject, QRect, QRectF
from PySide6.QtWidgets import QGraphicsScene, QWidget

from procc_annotator.gui.picture.overlay_item import NOTHING, OverlayItem
from procc_annotator.gui.picture.split_view import NamePlate, SplitView
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.document import Document
from procc_annotator.interact.overlay_wireframe import build_wireframes
from procc_annotator.metric.measure import Measurement
from procc_annotator.metric.project import ProjectedField
from procc_annotator.metric.score import FrameScore

_TAP_S = 0.3  # a key held longer than that is let go of, not tapped
_PLACE = 10

Judged = tuple[Measurement | None, FrameScore | None]


class Comparison(QObject):
    """Belongs to the canvas, which draws the source in front; this draws everything else.

    The source in front is the active one, or the compared one while it is being looked at (a key
    held). In a split view the source in front has the left side, the other of the two the right.
    """

    def __init__(self, document: Document, viewport: QWidget, scene: QGraphicsScene) -> None:
        super().__init__(viewport)
        self._document = document
        self._viewport = viewport
        self.wireframes = NOTHING
        self.other_side = OverlayItem()
        scene.addItem(self.other_side)
        self.split = SplitView(viewport)
        self._plate = NamePlate(viewport, "blinkName")
        self.split_wanted = False
        self.others_wanted = True
        self._held_since: float | None = None
        self._wired: tuple[object, ...] = ()

    # --- which source is where ------------------------------------------------------------

    @property
    def looking(self) -> bool:
        """Whether the compared source is in front for as long as a key is held."""
        return self._held_since is not None and self._document.compared is not None

    @property
    def divided(self) -> bool:
        """Whether the picture is divided between two sources."""
        document = self._document
        visible = document.projection_visible and document.frame is not None
        return self.split_wanted and visible and document.compared is not None

    @property
    def front(self) -> CameraSource | None:
        """The source whose verdicts are drawn, on the left if there are two sides."""
        document = self._document
        return document.compared if self.looking else document.active_source

    @property
    def right(self) -> CameraSource | None:
        """The source of the right side."""
        document = self._document
        return document.active_source if self.looking else document.compared

    @property
    def judged(self) -> Judged:
        """Measurement and score of the source in front."""
        document = self._document
        if self.looking:
            return document.compared_drawing
        return document.measurement, document.score

    @property
    def judged_right(self) -> Judged:
        """Measurement and score of the source on the right."""
        document = self._document
        if self.looking:
            return document.measurement, document.score
        return document.compared_drawing

    # --- blinking -------------------------------------------------------------------------

    def hold(self) -> bool:
        """Look at the compared source until `let_go`; False when there is none."""
        if self._document.compared is None:
            return False
        self._held_since = monotonic()
        return True

    def let_go(self) -> bool:
        """Back to the active source; True after a mere tap, which means to stay."""
        since, self._held_since = self._held_since, None
        return since is not None and monotonic() - since < _TAP_S

    # --- drawing --------------------------------------------------------------------------

    def set_area(self, area: QRectF) -> None:
        """Where anything may be painted, scene coordinates."""
        self.other_side.set_area(area)

    def refresh(self, *, hidden: bool) -> None:
        """Make wireframes and names anew if they changed."""
        self._make_wireframes(hidden=hidden)
        self._name_sides(hidden=hidden)

    def _make_wireframes(self, *, hidden: bool) -> None:
        document, size = self._document, self._document.picture_size
        shown: list[tuple[ProjectedField, str]] = []
        if size is not None and not hidden and self.others_wanted:
            shown = self._others()
        wired = (size, document.setup.size, *shown)
        if wired == self._wired:
            return
        self._wired = wired
        self.wireframes = NOTHING
        if shown and size is not None:
            self.wireframes = build_wireframes(shown, document.setup.size, size)

    def _others(self) -> list[tuple[ProjectedField, str]]:
        """What the visible sources that have no place of their own show of this frame."""
        document = self._document
        if document.active_source is None or not document.projection_visible:
            return []
        placed = {self.front, self.right} if self.divided else {self.front}
        shown = []
        for source in document.sources:
            known = document.source_frames.of(source) if source.visible else None
            if source not in placed and known is not None and known.projected is not None:
                shown.append((known.projected, source.colour))
        return shown

    def _name_sides(self, *, hidden: bool) -> None:
        front, right = self.front, self.right
        if self.divided and not hidden and front is not None and right is not None:
            self.split.show_names(
                (_caption(front, self.judged), front.colour),
                (_caption(right, self.judged_right), right.colour),
            )
        elif self.split.shown:
            self.split.hide()
        looking = self.looking and self._document.projection_visible
        if looking and not self.split.shown and not hidden and front is not None:
            self._plate.say(_caption(front, self.judged), front.colour)
            wanted = self._plate.wanted_size()
            room = self._viewport.width() - 2 * _PLACE
            self._plate.put(QRect(_PLACE, _PLACE, min(wanted.width(), room), wanted.height()))
            self._plate.show()
            self._plate.raise_()
        else:
            self._plate.hide()

    def side_of_front(self) -> QRectF | None:
        """The part of the viewport where the source in front is drawn; None: all of it."""
        if not self.split.shown:
            return None
        return QRectF(0, 0, self.split.x, self._viewport.height())

    def side_of_right(self) -> QRectF | None:
        """The part of the viewport where the other one is drawn."""
        if not self.split.shown:
            return None
        x = self.split.x
        return QRectF(x, 0, self._viewport.width() - x, self._viewport.height())


def _caption(source: CameraSource, judged: Judged) -> str:
    score = judged[1]
    return f"{source.name}  ·  {f'JaC {score.jac:.3f}' if score is not None else 'no camera here'}"
