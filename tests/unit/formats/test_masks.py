"""Masks: which pixels belong to a line, whatever its width and wherever its points lie."""

from __future__ import annotations

import json

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.annotation import FrameAnnotation, Point, Polyline, point_from_px
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations import masks
from procc_annotator.formats.annotations.exchange import ExchangedFrame, WriteContext

SOCCER = load_field("soccer")
SIZE = (80, 60)
A, B = "Side line top", "Middle line"


def polyline(name: str, *points_px: tuple[float, float]) -> Polyline:
    return Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in points_px))


def distances(a: tuple[float, float], b: tuple[float, float]) -> np.ndarray:
    """(H, W) distance of each pixel's centre to a segment, px."""
    grid = np.stack(np.meshgrid(np.arange(SIZE[0]), np.arange(SIZE[1])), axis=-1).astype(float)
    start, along = np.array(a), np.subtract(b, a)
    squared = float(along @ along)
    t = np.clip((grid - start) @ along / squared, 0, 1) if squared else np.zeros(grid.shape[:2])
    return np.linalg.norm(grid - start - t[..., None] * along, axis=-1)


position = st.floats(-40, 120)
place = st.tuples(position, position)


@given(place, place, st.floats(1, 20))
def test_pixels_within_half_the_width_are_the_line(a, b, width) -> None:
    mask = masks.draw_mask([polyline(A, a, b)], {A: 7}, SIZE, width)
    points = polyline(A, a, b).points
    exact = [(p.u * (SIZE[0] - 1), p.v * (SIZE[1] - 1)) for p in points]
    apart = distances(exact[0], exact[1])
    clear = abs(apart - width / 2) > 1e-6  # a pixel just on the edge may be either
    assert np.array_equal(mask[clear] == 7, (apart <= width / 2)[clear])
    assert set(np.unique(mask)) <= {0, 7}


def test_points_a_million_pictures_away_are_drawn_to_the_border() -> None:
    far = Polyline(A, (Point(-1e6, 30 / 59), Point(1e6, 30 / 59)))
    mask = masks.draw_mask([far], {A: 1}, SIZE, 2.9)
    assert mask.sum(axis=1).tolist() == [SIZE[0] if 29 <= y <= 31 else 0 for y in range(SIZE[1])]


def test_a_single_point_is_a_dot() -> None:
    mask = masks.draw_mask([polyline(A, (10, 20))], {A: 1}, SIZE, 3.1)
    assert np.argwhere(mask).tolist() == [[y, x] for y in (19, 20, 21) for x in (9, 10, 11)]


def test_the_order_of_the_file_does_not_matter() -> None:
    lines = [polyline(A, (0, 30), (79, 30)), polyline(B, (40, 0), (40, 59))]
    values = {A: 1, B: 2}
    first = masks.draw_mask(lines, values, SIZE, 4)
    assert np.array_equal(first, masks.draw_mask(lines[::-1], values, SIZE, 4))
    assert first[30, 40] == 2


def test_files_and_legend() -> None:
    written: dict[str, bytes] = {}

    def put(name: str, data: bytes) -> bool:
        written[name] = data
        return True

    annotation = FrameAnnotation(
        (polyline(A, (0, 10), (79, 10)), polyline("advert", (0, 40), (90, 40)), Polyline(B, ()))
    )
    writing = WriteContext(SOCCER, put, line_width=2)
    masks.write_many([ExchangedFrame("7", annotation, SIZE)], writing)
    assert list(written) == ["7.png", "classes.json"]
    mask = cv2.imdecode(np.frombuffer(written["7.png"], np.uint8), cv2.IMREAD_UNCHANGED)
    assert mask.shape == (60, 80)
    assert mask.dtype == np.uint8
    legend = json.loads(written["classes.json"])
    values = {entry["class"]: entry["value"] for entry in legend["classes"]}
    assert legend["background"] == 0
    assert sorted(values.values()) == list(range(1, len(values) + 1))
    assert [e.name for e in SOCCER.elements] == list(values)[: len(SOCCER.elements)]
    assert set(np.unique(mask)) == {0, values[A], values["advert"]}
    assert mask[10, 40] == values[A]
    told = writing.remarks.lines()
    assert any("not read back" in line for line in told)
    assert "what lies outside the picture is not in its mask (1 frame: 7)" in told


def test_more_classes_than_grey_values_are_told() -> None:
    many = tuple(polyline(f"class {i}", (0, 0), (9, 9)) for i in range(300))
    writing = WriteContext(SOCCER, lambda name, data: True)
    masks.write_many([ExchangedFrame("7", FrameAnnotation(many), SIZE)], writing)
    assert any("255 values" in line for line in writing.remarks.lines())
    assert writing.elements == 255 - len(SOCCER.elements) - 2


@pytest.mark.parametrize("width", [0, 0.5, 201, float("nan")])
def test_widths_that_cannot_be_drawn(width) -> None:
    from procc_annotator.errors import UsageError

    with pytest.raises(UsageError, match="line width"):
        masks.write_many([], WriteContext(SOCCER, lambda name, data: True, line_width=width))
