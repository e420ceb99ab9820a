"""Frames annotated again by a hand that counts what it does, and the same in labelme.

Clicks, keys and class choices count one each.

Here: the elements of a frame are drawn one after the other. A class costs nothing when the element
offered by itself is one of those still missing, else one choice. A straight element is its two ends
(the second click finishes it: "Two clicks" in the rail), a curve is five clicks (all it has, if
fewer) and Enter; one key at the end of the frame regularises everything, which makes the points
between.

With ghosts (`with_ghosts`) Shift+Enter accepts all that the picture supports, one action.

labelme (linestrip mode, chosen once a frame here in its favour not at all): every point of the
annotation is a click; the last one is a double-click, i.e. one more; then the popup asks for the
label, where one double-click on the list chooses and accepts, counted as one.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.assist.frame_analysis import analyse_frame
from procc_annotator.assist.ghost_points import accept_all, find_points
from procc_annotator.calibration.prediction.ghosts import Ghost
from procc_annotator.calibration.prediction.visible_elements import visible_stretches
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.pixels import PixelArray
from procc_annotator.interaction.class_choice import next_element
from procc_annotator.interaction.draw_tool import DrawTool
from procc_annotator.interaction.gestures import Modifiers, ToolContext

FIELD = load_field()
CURVED = frozenset(e.name for e in FIELD.elements if not e.is_straight)
SIZE = (1280, 720)
CURVE_CLICKS = 5

# The annotation and the ghosts shown -> the annotation with those accepted that have support.
AcceptAll = Callable[[FrameAnnotation, tuple[Ghost, ...]], FrameAnnotation]


@dataclass
class Annotator:
    """Draws with the real tool and counts what the hands do."""

    seen_before: frozenset[str] = frozenset()
    actions: int = 0
    annotation: FrameAnnotation = field(default_factory=FrameAnnotation)
    selected: str | None = None
    two_clicks: bool = True

    def draw(self, name: str, points: list[tuple[float, float]]) -> None:
        if self.selected != name:
            self.actions += 1  # field map, key, or type-ahead
        tool = DrawTool()
        for point in points:
            self.actions += 1
            reaction = tool.press(point, Modifiers(), self.context(name))
        if tool.busy:
            self.actions += 1
            reaction = tool.key("Enter", self.context(name))
        assert reaction.finished
        self.annotation = reaction.edit.annotation
        self.selected = next_element(FIELD, self.annotation, name, self.seen_before)

    def context(self, name: str) -> ToolContext:
        return ToolContext(
            self.annotation, SIZE, 1.0, name, curved=CURVED, is_two_point_element=self.two_clicks
        )


def known_names(annotation: FrameAnnotation) -> list[str]:
    return [n for n in annotation.annotated if FIELD.knows(n)]


def pixels(annotation: FrameAnnotation, name: str) -> list[tuple[float, float]]:
    polyline = annotation.get(name)
    return [(p.u * (SIZE[0] - 1), p.v * (SIZE[1] - 1)) for p in polyline.points]


def clicks_for(annotation: FrameAnnotation, name: str) -> list[tuple[float, float]]:
    points = pixels(annotation, name)
    if name not in CURVED:
        return points if len(points) < 2 else [points[0], points[-1]]
    if len(points) <= CURVE_CLICKS:
        return points
    return [points[round(i * (len(points) - 1) / (CURVE_CLICKS - 1))] for i in range(CURVE_CLICKS)]


def our_actions(
    annotation: FrameAnnotation, seen_before: frozenset[str], *, two_clicks: bool = True
) -> int:
    """Every element drawn by hand."""
    hand = Annotator(seen_before, two_clicks=two_clicks)
    hand.selected = next_element(FIELD, hand.annotation, None, seen_before)
    missing = known_names(annotation)
    while missing:
        name = hand.selected if hand.selected in missing else missing[0]
        missing.remove(name)
        hand.draw(name, clicks_for(annotation, name))
    assert set(hand.annotation.annotated) == set(known_names(annotation))
    return hand.actions + 1  # regularise the frame


def labelme_actions(annotation: FrameAnnotation) -> int:
    return sum(len(pixels(annotation, n)) + 1 + 1 for n in known_names(annotation))


@dataclass(frozen=True)
class WithGhosts:
    """A frame annotated with the help of ghosts.

    Attributes:
        actions: of the hands.
        annotation: what came out.
        drawn: elements drawn by hand; accepted: ghosts accepted that the frame really shows;
            removed: ghosts accepted that it does not, taken out again.
    """

    actions: int
    annotation: FrameAnnotation
    drawn: tuple[str, ...]
    accepted: tuple[str, ...]
    removed: tuple[str, ...]


def with_ghosts(clicked: FrameAnnotation, accept_all: AcceptAll) -> WithGhosts:
    """Annotate what ``clicked`` holds: draw, accept all ghosts, and so on.

    Shift+Enter is pressed, and counted, whenever ghosts appear that were not among those left at
    the last time. An element that was accepted although the frame does not show it costs two
    actions: select it, "not visible here". Between, one element is drawn: the one that is offered
    for nothing before there is a camera, then the one that is suggested.
    """
    hand = Annotator()
    drawn: list[str] = []
    accepted: list[str] = []
    removed: list[str] = []
    declined: frozenset[str] = frozenset()
    while missing := [n for n in known_names(clicked) if hand.annotation.get(n) is None]:
        insight = analyse_frame(hand.annotation, FIELD, size=SIZE, not_visible=frozenset(removed))
        shown = frozenset(g.name for g in insight.ghosts)
        if shown - declined:
            hand.actions += 1
            before = set(hand.annotation.annotated)
            hand.annotation = accept_all(hand.annotation, insight.ghosts)
            new = [n for n in hand.annotation.annotated if n not in before]
            declined = shown.difference(new)
            for name in new:
                if clicked.get(name) is None:
                    hand.actions += 2
                    hand.annotation = hand.annotation.without(name)
                    removed.append(name)
                else:
                    accepted.append(name)
            if new:
                continue
        wanted = [s.name for s in insight.suggestions if s.name in missing]
        name = hand.selected if hand.selected in missing else missing[0]
        if wanted:
            name = wanted[0]
        hand.draw(name, clicks_for(clicked, name))
        drawn.append(name)
    actions = hand.actions + 1  # regularise the frame
    return WithGhosts(actions, hand.annotation, tuple(drawn), tuple(accepted), tuple(removed))


@dataclass(frozen=True, eq=False)
class DrawnFrame:
    """A drawn frame: what a careful person would have clicked, and the exact geometry.

    Attributes:
        name: of the frame.
        clicked: the annotation that comes with it.
        picture: (720, 1280, 4) BGRA.
        exact: (n, 2) px courses of each element in sight, by the true camera.
    """

    name: str
    clicked: FrameAnnotation
    picture: PixelArray
    exact: dict[str, list[np.ndarray]]

    def accept_all(self, annotation: FrameAnnotation, ghosts: tuple[Ghost, ...]) -> FrameAnnotation:
        """What Shift+Enter does."""
        found = [find_points(ghost, self.picture, FIELD, SIZE) for ghost in ghosts]
        return accept_all(annotation, found).annotation


def drawn_frames(sample_data: Path) -> Iterator[DrawnFrame]:
    """The annotated frames of the sample."""
    cameras = CameraSet.open(sample_data / "cameras" / "true", camera_size=(960, 540))
    for path in sorted(sample_data.glob("*.json")):
        loaded = cameras.camera(path.stem, SIZE)
        exact: dict[str, list[np.ndarray]] = {}
        for stretch in visible_stretches(FIELD, loaded.camera, SIZE):
            exact.setdefault(stretch.name, []).append(stretch.points_px)
        clicked = read_annotation(path.read_bytes(), path=str(path), field=FIELD)
        yield DrawnFrame(path.stem, clicked, decode_bgra(path.with_suffix(".jpg")), exact)


def accuracy_px(
    annotation: FrameAnnotation, exact: dict[str, list[np.ndarray]], name: str
) -> float:
    """Median distance of an element's points to its exact geometry, px."""
    polyline = annotation.get(name)
    assert polyline is not None
    dense = np.concatenate([_dense(course) for course in exact[name]])
    points = points_px(polyline, SIZE)
    return float(np.median([np.hypot(*(dense - point).T).min() for point in points]))


def _dense(course: np.ndarray) -> np.ndarray:
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(course, axis=0).T))])
    at = np.linspace(0.0, lengths[-1], 2 + int(lengths[-1] * 5))
    return np.column_stack([np.interp(at, lengths, course[:, k]) for k in (0, 1)])
