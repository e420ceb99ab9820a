"""Dragging the camera: with Ctrl and Alt held, a place of its wireframe goes where it belongs."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent

from procc_annotator.arrays import FloatArray
from procc_annotator.assist.track_anchors import correct_camera
from procc_annotator.calibration.line_alignment.control_points import (
    ControlPoint,
    fit_control_points,
)
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.gui.canvas.editor import Editor
from procc_annotator.gui.canvas.overlay_item import OverlayItem
from procc_annotator.gui.canvas.view import PictureView
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.availability import hidden
from procc_annotator.gui.state.services import Services
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.camera_view import (
    Wireframe,
    WireframePoint,
    segments_in_sight,
    wireframe_of,
)
from procc_annotator.interaction.hints import SEPARATOR
from procc_annotator.interaction.overlay_lines import build_camera_handles
from procc_annotator.interaction.overlay_primitives import EMPTY_OVERLAY, NO_POINTS
from procc_annotator.translation import tr, tr_count

Position = tuple[float, float]

_HELD = Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier
_KEYS = {
    Qt.Key.Key_Control: Qt.KeyboardModifier.ControlModifier,
    Qt.Key.Key_Alt: Qt.KeyboardModifier.AltModifier,
}
_CLICK_PX = 3.0  # on the screen: a shorter way counts as a click
_HAND_PX = 1.0  # on the screen, standard deviation: precision of a position set by mouse
_BESIDE = 0.02  # of the picture's width
_NO_LINES = np.empty((0, 4))


class CameraDrag(QObject):
    """Follows keys and mouse of the picture before the tools do, and takes what is meant for the
    camera. A place that was dragged stays as a peg: the next one turns and zooms about it.

    Attributes:
        held: whether the wireframe is shown, to be taken hold of.
    """

    changed = Signal()  # held or not, or what is under the cursor: the hint, and what is drawn
    moved = Signal(object)  # (x, y) px: the mouse moved, and no tool is to hear of it

    def __init__(self, services: Services, view: PictureView, editor: Editor) -> None:
        super().__init__(view)
        self._services, self._view, self._editor = services, view, editor
        self._at: Position | None = None  # the cursor, px of the picture
        self._hidden = False  # whether only the bare picture is shown
        self.item = OverlayItem()
        self.item.setZValue(2)
        view.scene().addItem(self.item)
        self.held = False
        self._wireframe: Wireframe | None = None
        self._under: WireframePoint | None = None
        self._grabbed: ControlPoint | None = None  # the one under the cursor
        self._pressed_at: Position | None = None
        self._moved = False
        self._begun: PinholeCamera | None = None  # the camera when the button went down
        self._others: tuple[ControlPoint, ...] = ()  # the control points that are not dragged
        self._dragged: PinholeCamera | None = None
        self._put: ControlPoint | None = None  # the dragged point as that camera shows it
        self._fresh = False  # nothing else was done since the last drag
        view.installEventFilter(self)
        view.viewport().installEventFilter(self)
        services.store.watch(lambda s: (select.annotation(s), s.selection), self._age)
        services.store.watch(lambda s: (select.frame(s), select.mode(s)), self._let_go)
        services.corrections.changed.connect(self._follow_pegs)
        services.prediction.changed.connect(self._follow_camera)

    @property
    def dragging(self) -> bool:
        """Return whether a place is dragged by the mouse."""
        return self._pressed_at is not None

    @property
    def hint(self) -> str:
        """Return what the user can do here; empty while it is about something else."""
        if not self.held:
            return ""
        pegs = len(self._pegs)
        if self.dragging:
            words = [tr("release leaves it here"), tr("Esc puts it back")]
        elif self._wireframe is None:
            words = [self._why_none()]
        elif self._grabbed is not None:
            words = [tr("drag moves this peg"), tr("click takes it away")]
        elif self._under is not None:
            title = self._services.state.title_of(self._under.name)
            words = [tr("drag {title} to where it belongs: the camera follows", title=title)]
        else:
            drag = tr("drag a place of the wireframe to where it belongs")
            words = [drag, tr("Ctrl+Z takes it back")]
        if pegs and not self.dragging:
            words.append(tr_count(pegs, "{n} peg holds the camera", "{n} pegs hold the camera"))
        return SEPARATOR.join([tr("CAMERA"), *words])

    def key(self, name: str, _shift: bool) -> bool:
        """Take Escape and Undo while a place is dragged, and right after; Undo also later, as long
        as nothing was annotated since."""
        if name not in ("Escape", "Undo"):
            return False
        if self.dragging:
            self._put_back()
            return True
        corrections = self._services.corrections
        meant = self._fresh if name == "Escape" else self._fresh or corrections.rules
        if not meant or not corrections.take_back():
            return False
        self._services.say(tr("taken back: the camera is as before it was dragged"))
        return True

    def refresh(self, *, hidden: bool) -> None:
        """Paint what there is, unless only the bare picture is to be shown."""
        self._hidden = hidden
        self._paint()

    def _follow_pegs(self, _: str) -> None:
        if not self.dragging:
            self._look_under()
        self._show()

    def _follow_camera(self) -> None:
        if self.held:
            self._show()
        else:
            self._paint()  # pegs count as long as no clicks say more

    # --- events ---------------------------------------------------------------------------

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and watched is self._view:
            self._follow_key(event)
            return False
        if isinstance(event, QMouseEvent) and watched is not self._view:
            return self._follow_mouse(event)
        if event.type() == QEvent.Type.FocusOut:
            self._let_go()
        elif event.type() == QEvent.Type.Leave and not self.dragging:
            self._at = None
            self._look_under()
        return False

    def _follow_key(self, event: QKeyEvent) -> None:
        own = _KEYS.get(Qt.Key(event.key()))
        if own is None or event.isAutoRepeat():
            return
        if event.type() == QEvent.Type.KeyPress:
            self._hold((event.modifiers() | own) & _HELD == _HELD)
        elif event.type() == QEvent.Type.KeyRelease and not self.dragging:
            self._hold(False)

    def _follow_mouse(self, event: QMouseEvent) -> bool:
        """Return whether an event was meant for the camera."""
        kind, self._at = event.type(), self._view.to_picture(event.position())
        released = kind == QEvent.Type.MouseButtonRelease
        if self._editor.holding or (self._view.panning and not (self.dragging and released)):
            return False
        if not self.dragging:
            self._hold(event.modifiers() & _HELD == _HELD)
        if not self.held:
            return False
        if kind == QEvent.Type.MouseMove:
            if not self.dragging:
                self._look_under()
            elif event.buttons() & Qt.MouseButton.LeftButton:
                self._drag(self._at)
            else:
                self._release()  # another window had it
            self.moved.emit(self._at)
        elif event.button() != Qt.MouseButton.LeftButton:
            return False
        elif released:
            self._release()
        else:
            self._press(self._at)
        return True

    # --- taking hold ----------------------------------------------------------------------

    def _hold(self, held: bool) -> None:
        if held != self.held:
            self.held = held
            self._wireframe = None
            self._look_under()
            self._show()

    def _let_go(self) -> None:
        """Another frame, or the keys went elsewhere."""
        self._fresh = self._fresh and self._services.corrections.here is not None
        if self.dragging:
            self._put_back()
        self._hold(False)  # where it was not held, the canvas paints what there is

    def _age(self) -> None:
        self._fresh = False

    @property
    def _pegs(self) -> tuple[ControlPoint, ...]:
        services = self._services
        found = services.corrections.here
        if found is None:
            return ()
        return found.pegs if services.corrections.rules or services.prediction.stands_in else ()

    def _camera(self) -> PinholeCamera | None:
        """The camera in view: the corrected one, that of ghosts, that of the chosen source."""
        services, size = self._services, self._services.state.picture_size
        if size is None or not services.proposals.allowed or self._hidden:
            return None
        insight = services.prediction.insight
        found = services.corrections.here if services.corrections.rules else None
        fit = insight.fit if insight is not None else services.prediction.found
        if found is not None:
            fit = found.fit
        camera = fit.camera if fit is not None else None
        if camera is None and isinstance(services.scorer.camera, PinholeCamera):
            return services.scorer.camera.scaled(services.state.setup.size, size)
        return camera if isinstance(camera, PinholeCamera) else None

    def _why_none(self) -> str:
        services = self._services
        if why := services.blind_lock.reason or hidden(services.state):
            return why
        if self._hidden:
            return tr("overlays are hidden (Ctrl+H)")
        insight = services.prediction.insight
        if insight is not None and insight.fit.camera is not None:
            return tr("a homography cannot be turned: choose another model (panel Fit)")
        return tr("no camera is known here that could be dragged")

    def _look_under(self) -> None:
        """Find the control point or line that the next press grabs."""
        at = self._at if self.held else None
        before = self._under, self._grabbed
        self._under = self._grabbed = None
        if self.held and self._wireframe is None:
            self._wireframe = self._make_wireframe()
        if at is not None and self._wireframe is not None:
            reach = tones.PICK_RADIUS_PX / self._view.view_scale
            away = [np.hypot(p.px[0] - at[0], p.px[1] - at[1]) for p in self._pegs]
            if away and min(away) <= reach:
                self._grabbed = self._pegs[int(np.argmin(away))]
            else:
                self._under = self._wireframe.at(at, reach)
        if (self._under, self._grabbed) != before:  # the cursor says so
            over = self._under is not None or self._grabbed is not None
            self._view.update_cursor()
            if over:
                self._view.viewport().setCursor(Qt.CursorShape.SizeAllCursor)
            self._show()

    def _make_wireframe(self) -> Wireframe | None:
        camera, size = self._camera(), self._services.state.picture_size
        if camera is None or size is None:
            return None
        if self._wireframe is not None and self._wireframe.camera == camera:
            return self._wireframe
        return wireframe_of(camera, self._services.scorer.frame_setup.field, size)

    # --- dragging -------------------------------------------------------------------------

    def _press(self, at: Position) -> None:
        self._look_under()
        if self._wireframe is None or (self._under is None and self._grabbed is None):
            self._services.say(
                tr("press on a line of the wireframe") if self._wireframe else self._why_none()
            )
            return
        self._begun, self._dragged = self._wireframe.camera, None
        self._others = tuple(peg for peg in self._pegs if not self._is_replaced(peg))
        self._pressed_at, self._moved = at, False
        self.changed.emit()

    def _is_replaced(self, peg: ControlPoint) -> bool:
        """Return whether a peg gives way to the place in hand: it is that one, or so near that both
        would roll and zoom the camera by what a click is off."""
        size, under = self._services.state.picture_size, self._under
        if peg is self._grabbed or under is None or size is None:
            return peg is self._grabbed
        away = np.hypot(peg.px[0] - under.px[0], peg.px[1] - under.px[1])
        return bool(away < _BESIDE * size[0])

    def _drag(self, at: Position) -> None:
        pressed = self._pressed_at
        assert pressed is not None
        assert self._begun is not None
        far = np.hypot(at[0] - pressed[0], at[1] - pressed[1]) * self._view.view_scale
        if not self._moved and far <= _CLICK_PX:
            return
        self._moved = True
        put = self._in_hand(at)
        found = fit_control_points(self._begun, self._others, put)
        if found is not self._begun:  # else no camera shows it there: the last one stays
            self._dragged, self._put = found, put
            self._paint()

    def _in_hand(self, at: Position) -> ControlPoint:
        sd = _HAND_PX / self._view.view_scale
        if self._grabbed is not None:
            return ControlPoint(self._grabbed.world, at, self._grabbed.along, sd)
        assert self._under is not None
        return ControlPoint(self._under.world, at, self._under.along, sd)

    def _release(self) -> None:
        if not self.dragging:
            return
        services, camera, moved = self._services, self._dragged, self._moved
        size, put = services.state.picture_size, self._put
        others, grabbed = self._others, self._grabbed
        self._end_drag()
        if not moved and grabbed is not None:
            self._take_away(others)
        elif moved and camera is not None and put is not None and size is not None:
            services.corrections.put(
                correct_camera(camera, (*others, put), size, services.state.annotation)
            )
            self._fresh = True
        self._look_under()
        self._show()

    def _take_away(self, others: tuple[ControlPoint, ...]) -> None:
        """A peg holds the camera no more; where it was the last one, nothing does."""
        services, size = self._services, self._services.state.picture_size
        camera = self._camera()
        if camera is None or size is None:
            return
        left = correct_camera(camera, others, size, services.state.annotation) if others else None
        services.corrections.put(left)
        self._fresh = True
        if others:
            left_over = len(others)
            services.say(
                tr_count(left_over, "peg taken away: {n} peg left", "peg taken away: {n} pegs left")
            )
        else:
            services.say(tr("peg taken away: the camera is as it was found"))

    def _put_back(self) -> None:
        self._end_drag()
        self._look_under()
        self._show()

    def _end_drag(self) -> None:
        self._pressed_at = self._begun = self._dragged = self._put = None
        self._moved = False
        self._wireframe = None

    # --- painting -------------------------------------------------------------------------

    def _show(self, *_: object) -> None:
        self._paint()
        self.changed.emit()

    def _paint(self) -> None:
        """Paint the wireframe while it can be dragged, and the pegs as long as there are any."""
        if not self.dragging and self.held:
            self._wireframe = self._make_wireframe()
        overlay, moving = EMPTY_OVERLAY, self._dragged is not None
        pegs = self._others if moving else self._pegs
        if not self._hidden and (self.held or pegs):
            places = np.array([peg.px for peg in pegs]) if pegs else NO_POINTS
            under = self._shown_under()
            overlay = build_camera_handles(self._lines(), places, under, pressed=self.dragging)
        self.item.set_overlay(overlay, self._view.view_scale, everywhere=moving)
        self.item.setVisible(overlay is not EMPTY_OVERLAY)

    def _lines(self) -> FloatArray:
        """The wireframe, (N, 4) px; none while no modifier is held."""
        services, size = self._services, self._services.state.picture_size
        camera = self._dragged
        if camera is None and self._wireframe is not None:
            camera = self._wireframe.camera
        if not self.held or camera is None or size is None:
            return _NO_LINES
        return segments_in_sight(camera, services.scorer.frame_setup.field, size)

    def _shown_under(self) -> tuple[Position, str] | None:
        """Return where the dragged point, or the one under the cursor, is seen."""
        if self._dragged is not None:
            world = self._in_hand((0.0, 0.0)).world
            x, y = self._dragged.project(np.array([world]))[0][0].tolist()
            return (x, y), ""
        if self._grabbed is not None:
            return self._grabbed.px, tr("peg")
        if self._under is not None:
            return self._under.px, self._services.state.title_of(self._under.name)
        return None
