"""Elements carried to another picture end where their lines leave it, and nowhere else."""

import cv2
import numpy as np
import pytest

from procc_annotator.annotation import Polyline, point_from_px, points_px
from procc_annotator.assist.copying import copy_moved
from procc_annotator.assist.line_evidence import ExpectedLines
from procc_annotator.field.load import load_field
from procc_annotator.image.pixels import PixelArray, bgra_from_bgr

SIZE = (960, 540)
SHIFT = 80


@pytest.fixture(scope="module")
def views() -> tuple[PixelArray, PixelArray]:
    """The same scene, the second picture 80 px further to the right; without any painted line."""
    rng = np.random.default_rng(4)
    small = rng.integers(0, 255, (60, 130, 3), dtype=np.uint8)
    wide = cv2.resize(small, (SIZE[0] + 200, SIZE[1]), interpolation=cv2.INTER_LINEAR)
    first, second = wide[:, : SIZE[0]], wide[:, SHIFT : SIZE[0] + SHIFT]
    return bgra_from_bgr(np.ascontiguousarray(first)), bgra_from_bgr(np.ascontiguousarray(second))


def carried(
    views: tuple[PixelArray, PixelArray],
    *points: tuple[float, float],
    name: str = "Goal left post left ",
) -> np.ndarray:
    polyline = Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in points))
    copied = copy_moved((polyline,), *views, frozenset(), ExpectedLines(load_field(), SIZE[0]))
    assert copied.moved
    (moved,) = copied.polylines
    return points_px(moved, SIZE)


def test_a_line_along_the_edge_keeps_its_length(views):
    found = carried(views, (957, 200), (956, 300))
    assert found == pytest.approx(np.array([(957 - SHIFT, 200), (956 - SHIFT, 300)]), abs=7)


@pytest.mark.parametrize(("end", "reached"), [(1150, SIZE[0] - 1), (985, 955 - SHIFT)])
def test_a_line_that_left_the_picture_is_continued_to_its_edge_if_it_is_seen_there(
    views, end, reached
):
    """Else its own end came into sight."""
    drawn = [view // 4 for view in views]
    for picture, shift in zip(drawn, (0, SHIFT), strict=True):
        begin, last = (600 - shift, 250), (end - shift, round(250 + (end - 600) * 12 / 355))
        cv2.line(picture, begin, last, (235, 235, 235, 255), 4, cv2.LINE_AA)
    found = carried((drawn[0], drawn[1]), (600, 250), (955, 262), name="Side line top")
    assert found[0] == pytest.approx([600 - SHIFT, 250], abs=7)
    assert found[-1, 0] == pytest.approx(reached, abs=7)


def test_what_leaves_the_picture_is_cut_off_at_its_edge(views):
    found = carried(views, (20, 300), (400, 300))
    assert found[0, 0] == pytest.approx(0, abs=1)
    assert found[-1] == pytest.approx([400 - SHIFT, 300], abs=7)


ANGLES = np.linspace(0.1, 3.0, 9)
ARC = np.column_stack([480 + 260 * np.cos(ANGLES), 200 + 110 * np.sin(ANGLES)])


def drawn_arc(shift: int, *players: tuple[int, int]) -> PixelArray:
    """A painted arc on grass that can be told apart; players stand where told."""
    rng = np.random.default_rng(4)
    small = rng.integers(90, 140, (60, 130), dtype=np.uint8)
    grass = cv2.resize(small, (SIZE[0] + 200, SIZE[1]), interpolation=cv2.INTER_LINEAR)
    scene = np.stack([grass // 3, grass, grass // 3], axis=-1)
    angles = np.linspace(0.1, 3.0, 400)
    arc = np.column_stack([480 + 260 * np.cos(angles), 200 + 110 * np.sin(angles)])
    cv2.polylines(
        scene, [np.round(arc * 16).astype(np.int32)], False, (235,) * 3, 4, cv2.LINE_AA, 4
    )
    for x, y in players:
        cv2.rectangle(scene, (x - 9, y - 26), (x + 9, y + 26), (180, 30, 30), -1)
        cv2.line(scene, (x - 4, y - 26), (x + 6, y + 26), (240, 240, 240), 4)
    return bgra_from_bgr(np.ascontiguousarray(scene[:, shift : SIZE[0] + shift]))


def test_a_bend_behind_a_player_stays_and_is_told():
    x, y = ARC[6].round().astype(int).tolist()
    polyline = Polyline("Circle right", tuple(point_from_px(*p, SIZE) for p in ARC.tolist()))
    field, views = load_field(), [drawn_arc(0), drawn_arc(40, (x, y))]
    copied = copy_moved(
        (polyline,), *views, frozenset({"Circle right"}), ExpectedLines(field, SIZE[0])
    )
    (moved,) = copied.polylines
    points = points_px(moved, SIZE)
    assert points == pytest.approx(ARC - [40, 0], abs=1.5)
    assert copied.unseen == {(p.u, p.v) for p in moved.points[6:7]}
