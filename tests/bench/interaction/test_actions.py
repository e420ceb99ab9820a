"""Actions a frame: the World Cup 2014 annotations clicked again, against labelme's way.

Clicks, keys and class choices count one each.

Here: the elements of a frame are drawn one after the other. A class costs nothing when the element
offered by itself is one of those still missing, else one choice. A straight element is its two ends
(the second click finishes it: "2 clicks" in the toolbar), a curve is five clicks (all it has, if
fewer) and Enter; one key at the end of the frame regularises everything, which makes the points
between.

labelme (linestrip mode, chosen once a frame here in its favour not at all): every point of the
annotation is a click; the last one is a double-click, i.e. one more; then the popup asks for the
label, where one double-click on the list chooses and accepts, counted as one.
"""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from pathlib import Path

import pytest

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.load import load_field
from procc_annotator.interact.draw_tool import DrawTool
from procc_annotator.interact.gesture import Context, Modifiers
from procc_annotator.interact.next_element import next_element
from procc_annotator.io.annotation_files.soccernet_annotation import read_annotation

FIELD = load_field()
CURVED = frozenset(e.name for e in FIELD.elements if not e.is_straight)
SIZE = (1280, 720)
CURVE_CLICKS = 5


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
        assert reaction.edit is not None
        assert reaction.finished
        self.annotation = reaction.edit.annotation
        self.selected = next_element(FIELD, self.annotation, name, self.seen_before)

    def context(self, name: str) -> Context:
        return Context(
            self.annotation, SIZE, 1.0, name, curved=CURVED, two_clicks_finish=self.two_clicks
        )


def pixels(annotation: FrameAnnotation, name: str) -> list[tuple[float, float]]:
    polyline = annotation.get(name)
    assert polyline is not None
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
    hand = Annotator(seen_before, two_clicks=two_clicks)
    hand.selected = next_element(FIELD, hand.annotation, None, seen_before)
    missing = [n for n in annotation.annotated if FIELD.knows(n)]
    while missing:
        name = hand.selected if hand.selected in missing else missing[0]
        missing.remove(name)
        hand.draw(name, clicks_for(annotation, name))
    assert set(hand.annotation.annotated) == {n for n in annotation.annotated if FIELD.knows(n)}
    return hand.actions + 1  # regularise the frame


def labelme_actions(annotation: FrameAnnotation) -> int:
    return sum(len(pixels(annotation, n)) + 1 + 1 for n in annotation.annotated if FIELD.knows(n))


def read_frames(folder: Path) -> list[FrameAnnotation]:
    files = sorted(folder.glob("*.json"), key=lambda p: p.name)
    if not files:
        pytest.skip(f"no annotations in {folder}")
    return [read_annotation(f.read_bytes(), path=str(f), field=FIELD) for f in files]


def test_relabelling_takes_at_most_half_of_the_actions(shared_data: Path) -> None:
    frames = read_frames(shared_data / "wc14" / "annotations")
    ours, theirs = [], []
    for frame in frames:
        # The frames of this set are single shots of different moments: nothing is known before.
        ours.append(our_actions(frame, frozenset()))
        theirs.append(labelme_actions(frame))
    with_enter = sum(our_actions(f, frozenset(), two_clicks=False) for f in frames)
    figures = {
        "frames": len(frames),
        "elements": sum(len(f.annotated) for f in frames),
        "actions a frame here": round(sum(ours) / len(ours), 1),
        "actions a frame with labelme": round(sum(theirs) / len(theirs), 1),
        "share": round(sum(ours) / sum(theirs), 3),
        "share with Enter after straight elements too": round(with_enter / sum(theirs), 3),
    }
    print(json.dumps(figures))
    assert sum(ours) <= 0.5 * sum(theirs)
