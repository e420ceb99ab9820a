"""Everything the window shows, as one frozen value, and what follows from it at a glance."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from operator import is_
from pathlib import Path
from typing import Literal

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.assist.track_anchors import CameraCorrection
from procc_annotator.dataset.camera_set import FrameCameras
from procc_annotator.dataset.editing import PointRef
from procc_annotator.dataset.frames import Frame
from procc_annotator.dataset.locks import LockHolder
from procc_annotator.dataset.review import LockEvent
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import SaveError
from procc_annotator.field.load import field_for_stadium, stadium_of
from procc_annotator.field.model import Field
from procc_annotator.gui.keymap import USUAL, Keymap
from procc_annotator.gui.state.camera_sources import CameraSource, SourceLook
from procc_annotator.image.decoding import HalfSizeImage
from procc_annotator.image.pixels import PixelArray
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.translation import tr

Mode = Literal["draw", "edit"]
Option = Literal["snapping", "pinned", "auto_advance", "two_clicks", "draw_first"]

MIN_TAU, MAX_TAU, DEFAULT_TAU = 0.5, 30.0, 5.0

BENT = "bent"  # the notice that paint runs beside what was clicked just now
UNSAVED = "unsaved"  # the notice that something is not on disk

Level = Literal["info", "warning", "error"]

_EMPTY = FrameAnnotation()


@dataclass(frozen=True, slots=True)
class Notice:
    """A line of text that is so until it is withdrawn; there is one notice a key."""

    key: str
    level: Level
    text: str


@dataclass(frozen=True, slots=True)
class ChosenElement:
    """The element to draw and to look at, and its points that are chosen.

    Attributes:
        point: the one point, or the first of several.
        points: those that are chosen together; empty for one or none.
        last_finished: the element finished on this frame before the next one was offered.
        continues: whether clicks add to the points the element has: the user chose it with these.
    """

    class_name: str | None = None
    point: PointRef | None = None
    points: frozenset[PointRef] = frozenset()
    last_finished: str | None = None
    continues: bool = False


@dataclass(frozen=True, slots=True)
class EditOptions:
    """Options of drawing and editing."""

    snapping: bool = True
    pinned: bool = True
    auto_advance: bool = True
    two_clicks: bool = False
    draw_first: bool = True


@dataclass(frozen=True, slots=True, eq=False)
class State:
    """One moment of the window. It is replaced, never changed (`Store.update`).

    Attributes:
        setup: what scores are computed with; its ``field`` is the one that is shown.
        tau: the threshold, px of the evaluation size.
        noise_floor: median and 95 % of the distances between two annotators, px.
        workspace: the dataset that is open; it knows the files and the histories.
        frame_index: of the frame on screen; -1 for none.
        annotation: of the frame on screen, finished.
        preview: the annotation as it would be if the mouse button were released now.
        damage: why the annotation file of the frame cannot be used.
        counts: whether the frame belongs to the figures of the set.
        picture: (H, W, 4) BGRA; None where it cannot be read, and ``picture_error`` says why, and
            while ``half`` is shown until it is decoded.
        holder: who else is editing the frame.
        unsaved: frame index -> why it is not on disk.
        selection, hovered_class: what is chosen, and what the cursor is on in whatever widget.
        mode, options: what a click does.
        sources: every camera source, in the order they were opened, fits behind; ``looks`` how each
            is shown now, at the same places.
        active: the source that is judged.
        compared_choice: the source that was active before or was chosen to be compared with, and
            whether a person chose it.
        blind: whether nothing of a camera is shown before a frame is committed.
        blind_lock: the lock of the dataset to blind mode, if it has one.
        committed: the frames whose clicks were declared final.
        corrected: frame name -> its camera as a person dragged it; nothing of it is in a file.
        keymap: the keys of one's own.
        author: whose name points, comments and versions bear.
        notices: lines that are so until they are withdrawn.
    """

    setup: EvaluationSetup
    tau: float = DEFAULT_TAU
    noise_floor: tuple[float, float] | None = None
    workspace: Workspace | None = None
    frame_index: int = -1
    annotation: FrameAnnotation = _EMPTY
    preview: FrameAnnotation | None = None
    damage: str = ""
    counts: bool = False
    picture: PixelArray | None = None
    half: HalfSizeImage | None = None
    picture_error: str = ""
    holder: LockHolder | None = None
    unsaved: Mapping[int, SaveError] = field(default_factory=dict)
    selection: ChosenElement = ChosenElement()
    hovered_class: str | None = None
    mode: Mode = "draw"
    options: EditOptions = EditOptions()
    sources: tuple[CameraSource, ...] = ()
    looks: tuple[SourceLook, ...] = ()
    active: CameraSource | None = None
    compared_choice: tuple[CameraSource | None, bool] = (None, False)
    blind: bool = False
    blind_lock: LockEvent | None = None
    committed: frozenset[str] = frozenset()
    corrected: Mapping[str, CameraCorrection] = field(default_factory=dict)
    author: str = ""
    keymap: Keymap = USUAL
    notices: tuple[Notice, ...] = ()

    # --- the frame on screen ------------------------------------------------------------------

    @property
    def field(self) -> Field:
        """The field that is shown."""
        return self.setup.field

    @property
    def frame(self) -> Frame | None:
        """The frame on screen."""
        if self.workspace is None or self.frame_index < 0:
            return None
        return self.workspace.frames[self.frame_index]

    @property
    def frame_name(self) -> str | None:
        """The name of the frame on screen."""
        return frame.name if (frame := self.frame) is not None else None

    @property
    def sized_field(self) -> Field:
        """The field with the dimensions of the stadium of the frame on screen: the same object for
        every frame of a stadium."""
        name = self.frame_name
        return (
            self.field
            if name is None
            else field_for_stadium(self.field, stadium_of(self.field, name))
        )

    def title_of(self, class_name: str) -> str:
        """Return what the field calls a class, in the language of the window."""
        return tr(self.field.title_of(class_name))

    @property
    def selected_class(self) -> str | None:
        """The class of the element that is chosen."""
        return self.selection.class_name

    @property
    def shown_annotation(self) -> FrameAnnotation:
        """The annotation including a gesture under way."""
        return self.preview if self.preview is not None else self.annotation

    @property
    def picture_size(self) -> tuple[int, int] | None:
        """(width, height) of the picture on screen in px; None if absent."""
        if self.picture is None:
            return None if self.half is None else self.half.size
        return self.picture.shape[1], self.picture.shape[0]

    @property
    def why_broken(self) -> str:
        """Why no one can edit the frame on screen; empty when a person can."""
        return self.damage or self.picture_error

    @property
    def why_not_editable(self) -> str:
        """Why the frame on screen cannot be edited here; empty when it can."""
        holder = self.holder
        if self.why_broken or holder is None:
            return self.why_broken
        who = holder.author or holder.host or tr("somebody")
        if holder.author and holder.host:
            who = tr("{who} on {machine}", who=holder.author, machine=holder.host)
        return tr("{who} is editing it; it opens by itself once they leave it", who=who)

    @property
    def editable(self) -> bool:
        """Return whether there is a frame that can be edited."""
        return self.frame is not None and not self.why_not_editable

    @property
    def why_not_judged(self) -> str:
        """Why the frame on screen belongs to no figure of the set, whatever its cameras are; empty
        when it does, and while its first element is drawn."""
        if self.frame is None:
            return ""
        if self.damage:
            return tr("annotation cannot be read")
        if self.counts or self.shown_annotation.annotated:
            return ""
        return tr("nothing annotated yet")

    # --- blind mode: the one gate that everything about a camera passes -----------------------

    def reveals(self, frame: str | None) -> bool:
        """Return whether something of a camera may be shown of a frame."""
        return not self.blind or frame in self.committed

    @property
    def projection_visible(self) -> bool:
        """Return whether something of a camera may be shown of the frame on screen."""
        return self.reveals(self.frame_name)

    @property
    def revealed_frames(self) -> frozenset[str] | None:
        """The frames of which something of a camera may be shown; None: all. In blind mode those
        that are committed."""
        return self.committed if self.blind else None

    # --- camera sources -----------------------------------------------------------------------

    @property
    def compared(self) -> CameraSource | None:
        """The source that the active one is held against: as chosen, else the one that was active
        before, else the first other one."""
        others = [source for source in self.sources if source is not self.active]
        if self.active is None or not others:
            return None
        chosen = self.compared_choice[0]
        return chosen if chosen in others else others[0]

    def look_of(self, source: CameraSource | None) -> SourceLook | None:
        """Return how a source is shown now; None for one that is not among the sources."""
        return next((look for look in self.looks if look.source is source), None)

    def cameras_of(self, source: CameraSource | None) -> FrameCameras | None:
        """The cameras of a source; None for one that is not among the sources."""
        look = self.look_of(source)
        return None if look is None else look.cameras

    @property
    def active_cameras(self) -> FrameCameras | None:
        """The cameras of the active source."""
        return self.cameras_of(self.active)


_VALUES = (
    str,
    int,
    float,
    frozenset,
    Enum,
    Path,
    ChosenElement,
    EditOptions,
    SourceLook,
    Notice,
    LockHolder,
    LockEvent,
)


def same(some: object, other: object) -> bool:
    """Return whether two values of the state are the same: the same thing, or small and equal."""
    if some is other:
        return True
    if type(some) is not type(other):
        return False
    if isinstance(some, tuple) and isinstance(other, tuple):
        if len(some) != len(other):
            return False
        return all(map(is_, some, other)) or all(map(same, some, other))  # mostly the first
    return isinstance(some, _VALUES) and some == other
