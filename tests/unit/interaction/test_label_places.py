"""Texts on a picture do not cover each other as long as there is room."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from procc_annotator.interaction.overlay_figure import place_apart
from procc_annotator.interaction.overlay_primitives import Box

ROOM = (0.0, 0.0, 400.0, 300.0)


def covers(a: Box, b: Box) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def test_what_is_free_stays_where_it_would_go() -> None:
    assert place_apart((10, 10, 50, 22), [(60, 10, 90, 22)], ROOM) == (10, 10, 50, 22)


@given(st.lists(st.tuples(st.floats(0, 360), st.floats(0, 280)), min_size=2, max_size=12))
def test_none_covers_another(points) -> None:
    taken: list[Box] = []
    for x, y in points:
        taken.append(place_apart((x, y, x + 30, y + 12), taken, ROOM))
    for number, box in enumerate(taken):
        assert all(not covers(box, other) for other in taken[:number])


def test_without_room_it_stays() -> None:
    box = (0.0, 0.0, 10.0, 10.0)
    assert place_apart(box, [box], box) == box
