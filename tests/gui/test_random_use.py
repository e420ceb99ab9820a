"""Random use of the real window against a plain model of what the annotation must be.

A sequence is 50 random valid actions by mouse and keys over three frames. At its end the files hold
the model's annotation, and undoing everything restores the first state exactly.
"""

import json
import math
import random
from dataclasses import dataclass, field
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.gui.main_window import MainWindow
from tests.gui.conftest import Hand

SEQUENCES, ACTIONS = 5, 50
SIZE = (640, 360)
CELL = 40  # picture px: clicks stay farther apart than the pick radius reaches
CLASSES = ("Middle line", "Circle central", "Side line top", "Goal left post left ", "Line unknown")
CTRL, ALT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.AltModifier
SHIFT = Qt.KeyboardModifier.ShiftModifier
FRAMES = 3

XY = tuple[float, float]
Elements = dict[str, list[XY]]


@dataclass
class FrameModel:
    """What a frame must hold: every state it had, and which of them is the current one."""

    states: list[Elements] = field(default_factory=lambda: [{}])
    at: int = 0

    @property
    def now(self) -> Elements:
        return self.states[self.at]

    def push(self, elements: Elements) -> None:
        elements = {name: points for name, points in elements.items() if points}
        if elements != self.now:
            del self.states[self.at + 1 :]
            self.states.append(elements)
            self.at += 1

    def changed(self, name: str, points: list[XY]) -> None:
        self.push({**self.now, name: points})


class Player:
    """Does random things with the window and the same things with the model."""

    def __init__(self, window: MainWindow, hand: Hand, seed: int) -> None:
        self.window, self.hand = window, hand
        self.services = window.services
        self.random = random.Random(seed)
        self.frames = [FrameModel() for _ in range(FRAMES)]
        self.log: list[str] = []

    @property
    def model(self) -> FrameModel:
        return self.frames[self.services.state.frame_index]

    def play(self) -> None:
        actions = (
            self.draw, self.draw, self.draw, self.draw_and_leave, self.give_up, self.drag,
            self.drag, self.insert, self.delete_point, self.delete_element, self.nudge, self.undo,
            self.undo, self.redo, self.go, self.reverse, self.change_class, self.move_several,
        )  # fmt: skip
        for _ in range(ACTIONS):
            action = self.random.choice(actions)
            self.log.append(action.__name__)
            action()
            assert_same(in_px(self.services.state.annotation), self.model.now, " ".join(self.log))

    # --- actions --------------------------------------------------------------------------

    def draw(self) -> None:
        name, points = self.click_some()
        if points is None:
            return
        if self.random.random() < 0.5:
            self.hand.key(Qt.Key.Key_Return)
        else:
            self.hand.key(Qt.Key.Key_Return, SHIFT)
        self.model.changed(name, points)

    def draw_and_leave(self) -> None:
        """A new element stays unfinished until it is chosen and finished; one that was there is
        continued."""
        name, points = self.click_some()
        if points is None:
            return
        new = self.services.state.annotation.get(name) is None
        here = self.services.state.frame_index
        self.services.navigator.go_to((here + 1) % FRAMES)
        self.services.navigator.go_to(here)
        if new:
            self.services.selection.select_class(name)
            self.hand.key(Qt.Key.Key_Return)
        self.model.changed(name, points)

    def give_up(self) -> None:
        _, points = self.click_some()
        if points is not None:
            self.hand.key(Qt.Key.Key_Escape)

    def click_some(self, least: int = 1) -> tuple[str, list[XY] | None]:
        """Click a few points, sometimes one too many and back; the element's points afterwards."""
        self.services.selection.set_mode("draw")
        name = self.random.choice(CLASSES)
        cells = self.free_cells()
        if len(cells) < 6:
            return name, None
        self.services.selection.select_class(name, continues=True)
        clicked = [self.hand.click(*cells.pop()) for _ in range(self.random.randint(least, 4))]
        if self.random.random() < 0.3:
            self.hand.click(*cells.pop())
            self.hand.key(Qt.Key.Key_Backspace)
        return name, [*self.model.now.get(name, []), *clicked]

    def drag(self) -> None:
        target, cells = self.any_point(), self.free_cells()
        if target is None or not cells:
            return
        name, index = target
        self.services.selection.select_point(None)  # or all chosen points would come along
        begin, end = self.model.now[name][index], cells.pop()
        self.hand.drag(begin, end)
        pressed, released = self.hand.picture(*begin), self.hand.picture(*end)
        moved = (begin[0] + released[0] - pressed[0], begin[1] + released[1] - pressed[1])
        points = list(self.model.now[name])
        points[index] = moved
        self.model.changed(name, points)

    def insert(self) -> None:
        found = self.any_segment()
        if found is None:
            return
        name, index, at = found
        landed = self.hand.click(*at, ALT)
        points = list(self.model.now[name])
        points.insert(index + 1, foot(points[index], points[index + 1], landed))
        self.model.changed(name, points)

    def delete_point(self) -> None:
        target = self.any_point()
        if target is None:
            return
        name, index = target
        self.hand.click(*self.model.now[name][index])
        self.hand.key(Qt.Key.Key_Delete)
        points = list(self.model.now[name])
        del points[index]
        self.model.changed(name, points)

    def delete_element(self) -> None:
        name = self.any_element()
        if name is not None:
            self.services.selection.set_mode("edit")
            self.services.selection.select_class(name)
            self.services.selection.select_point(None)
            self.hand.key(Qt.Key.Key_Delete, CTRL)
            self.model.changed(name, [])

    def nudge(self) -> None:
        target = self.any_point()
        if target is None:
            return
        name, index = target
        self.hand.click(*self.model.now[name][index])
        self.hand.key(Qt.Key.Key_Right, SHIFT)
        points = list(self.model.now[name])
        points[index] = (points[index][0] + 0.1, points[index][1])
        self.model.changed(name, points)

    def move_several(self) -> None:
        """Choose all points of an element and nudge them."""
        name = self.any_element()
        if name is None:
            return
        self.services.selection.set_mode("edit")
        self.services.selection.select_point(None)
        self.services.selection.select_class(name)
        self.hand.key(Qt.Key.Key_A, CTRL)
        self.hand.key(Qt.Key.Key_Down, SHIFT)
        self.model.changed(name, [(x, y + 0.1) for x, y in self.model.now[name]])

    def reverse(self) -> None:
        name = self.any_element()
        if name is not None:
            self.services.selection.select_class(name)
            self.hand.key(Qt.Key.Key_R, CTRL)
            self.model.changed(name, self.model.now[name][::-1])

    def change_class(self) -> None:
        name = self.any_element()
        if name is None:
            return
        new = self.random.choice([c for c in CLASSES if c != name])
        self.services.selection.select_class(name)
        self.window.element_edits.change_class(new)
        now = self.model.now
        swapped = {new if n == name else name if n == new else n: p for n, p in now.items()}
        self.model.push(swapped)

    def undo(self) -> None:
        """Clicks that Escape cancelled come back first, and go one by one."""
        self._step(CTRL)
        if self.window.canvas.editor.drawing:
            while self.window.canvas.editor.drawing:
                self._step(CTRL)
            self._step(CTRL)
        self.model.at = max(0, self.model.at - 1)

    def redo(self) -> None:
        self._step(CTRL | SHIFT)
        self.model.at = min(len(self.model.states) - 1, self.model.at + 1)

    def _step(self, held: Qt.KeyboardModifier) -> None:
        """One step, or two past an unfinished element, which the model does not know."""
        self.hand.key(Qt.Key.Key_Z, held)
        if self.services.state.annotation.unconfirmed:
            self.hand.key(Qt.Key.Key_Z, held)

    def go(self) -> None:
        self.services.navigator.go_to(self.random.randrange(FRAMES))

    # --- choosing -------------------------------------------------------------------------

    def any_element(self) -> str | None:
        names = sorted(self.model.now)
        return self.random.choice(names) if names else None

    def any_point(self) -> tuple[str, int] | None:
        self.services.selection.set_mode("edit")
        now = self.model.now
        every = [(n, i) for n in sorted(now) for i in range(len(now[n]))]
        places = [now[n][i] for n, i in every]
        alone = [
            ref
            for ref, place in zip(every, places, strict=True)
            if sum(math.dist(place, other) < 30 for other in places) == 1
        ]
        return self.random.choice(alone) if alone else None

    def any_segment(self) -> tuple[str, int, XY] | None:
        """The middle of a segment that lies far from every point and from other segments."""
        self.services.selection.set_mode("edit")
        now = self.model.now
        segments = [(n, i) for n in sorted(now) for i in range(len(now[n]) - 1)]
        self.random.shuffle(segments)
        for name, i in segments:
            a, b = now[name][i], now[name][i + 1]
            middle = ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
            clear = all(math.dist(middle, p) > 30 for points in now.values() for p in points)
            others = [
                foot(now[n][j], now[n][j + 1], middle) for n, j in segments if (n, j) != (name, i)
            ]
            if clear and all(math.dist(middle, f) > 30 for f in others):
                return name, i, middle
        return None

    def free_cells(self) -> list[XY]:
        taken = [p for points in self.model.now.values() for p in points]
        cells = [
            (float(x), float(y))
            for x in range(CELL, SIZE[0] - 20, CELL)
            for y in range(CELL, SIZE[1] - 20, CELL)
            if all(math.dist((x, y), p) > 30 for p in taken)
        ]
        self.random.shuffle(cells)
        return cells


def foot(a: XY, b: XY, at: XY) -> XY:
    step = (b[0] - a[0], b[1] - a[1])
    squared = max(step[0] ** 2 + step[1] ** 2, 1e-12)
    along = ((at[0] - a[0]) * step[0] + (at[1] - a[1]) * step[1]) / squared
    along = min(max(along, 0.0), 1.0)
    return a[0] + along * step[0], a[1] + along * step[1]


def in_px(annotation: FrameAnnotation) -> Elements:
    return {
        p.class_name: [(q.u * (SIZE[0] - 1), q.v * (SIZE[1] - 1)) for q in p.points]
        for p in annotation.polylines
        if p.points
    }


def on_disk(path: Path) -> Elements:
    entries = json.loads(path.read_text()) if path.exists() else {}
    return {
        name: [(p["x"] * (SIZE[0] - 1), p["y"] * (SIZE[1] - 1)) for p in points]
        for name, points in entries.items()
        if points
    }


def assert_same(found: Elements, expected: Elements, why: str) -> None:
    assert sorted(found) == sorted(expected), why
    for name, points in expected.items():
        assert len(found[name]) == len(points), f"{name}: {why}"
        assert np.allclose(found[name], points, atol=1e-6), f"{name}: {why}"


def make_dataset(folder: Path) -> Path:
    folder.mkdir()
    picture = np.full((SIZE[1], SIZE[0], 3), (40, 110, 40), dtype=np.uint8)
    for i in range(FRAMES):
        cv2.imwrite(str(folder / f"{i}.png"), picture)
    return folder


@pytest.mark.laps
def test_any_sequence_of_actions_ends_as_the_model_says(make_window, hand_on, tmp_path, lap):
    window = make_window(make_dataset(tmp_path / "first"), size=(1100, 700))
    window.actions_["snapping"].trigger()  # there is nothing to snap to; the model knows no lines
    window.panels.hide_all(True)
    hand = hand_on(window)
    for seed in range(lap * SEQUENCES, (lap + 1) * SEQUENCES):
        folder = make_dataset(tmp_path / f"sequence_{seed}")
        assert window.opening.open_path(folder)
        player = Player(window, hand, seed)
        player.play()
        window.services.editing.save_now()
        why = f"sequence {seed}: {' '.join(player.log)}"
        for i, model in enumerate(player.frames):
            assert_same(on_disk(folder / f"{i}.json"), model.now, why)
        for i, model in enumerate(player.frames):
            window.services.navigator.go_to(i)
            while model.at > 0:
                player.undo()
            assert window.services.state.annotation == FrameAnnotation(), why
            window.services.editing.save_now()
            assert on_disk(folder / f"{i}.json") == {}, why
            for _ in model.states:
                player.redo()
            assert_same(in_px(window.services.state.annotation), model.now, why)
            window.services.editing.save_now()
            assert_same(on_disk(folder / f"{i}.json"), model.now, why)
