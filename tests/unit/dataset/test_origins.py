"""Every new point gets an origin; what is only renamed, split or undone keeps its own."""

from __future__ import annotations

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.dataset import editing
from procc_annotator.dataset.records import OriginKind, count_points_by_origin, new_origins

EMPTY = FrameAnnotation()
DRAWN = FrameAnnotation((Polyline("Middle line", (Point(0.1, 0.1), Point(0.2, 0.2))),))


def test_points_of_an_edit_are_of_its_kind_but_for_the_snapped_ones() -> None:
    found = new_origins(EMPTY, DRAWN, OriginKind.CLICKED, "ann", 5.0, snapped={(0.2, 0.2)})
    assert {key: origin.kind for key, origin in found.items()} == {
        (0.1, 0.1): OriginKind.CLICKED,
        (0.2, 0.2): OriginKind.SNAPPED,
    }
    assert {(o.author, o.time) for o in found.values()} == {("ann", 5.0)}


def test_another_class_is_no_new_point() -> None:
    renamed = editing.change_class(DRAWN, "Middle line", "Circle left")
    assert new_origins(DRAWN, renamed, OriginKind.MOVED, "ann", 5.0) == {}


def test_a_moved_point_is_new_and_the_others_are_not() -> None:
    moved = editing.move_point(DRAWN, "Middle line", 1, Point(0.3, 0.2))
    assert list(new_origins(DRAWN, moved, OriginKind.MOVED, "ann", 5.0)) == [(0.3, 0.2)]


def test_confirmed_points_were_copied_whatever_confirmed_them() -> None:
    waiting = editing.add_unconfirmed(EMPTY, DRAWN.polylines)
    assert new_origins(EMPTY, waiting, OriginKind.COPIED, "ann", 5.0) == {}
    found = new_origins(waiting, editing.confirm_all(waiting), OriginKind.MOVED, "ann", 6.0)
    assert {o.kind for o in found.values()} == {OriginKind.COPIED}


def test_counts_leave_points_of_unknown_origin_to_the_file() -> None:
    known = new_origins(EMPTY, DRAWN, OriginKind.CLICKED, "ann", 5.0)
    del known[0.1, 0.1]
    assert count_points_by_origin(DRAWN, known) == {OriginKind.CLICKED: 1, OriginKind.FILE: 1}


def test_points_without_paint_are_told_as_such_new_or_not() -> None:
    found = new_origins(DRAWN, DRAWN, OriginKind.REGULARISED, "ann", 5.0, unseen={(0.2, 0.2)})
    assert {key: origin.kind for key, origin in found.items()} == {
        (0.2, 0.2): OriginKind.UNCONFIRMED
    }
    waiting = editing.add_unconfirmed(EMPTY, DRAWN.polylines)
    copied = new_origins(EMPTY, waiting, OriginKind.COPIED, "ann", 5.0, unseen={(0.1, 0.1)})
    confirmed = editing.confirm_all(waiting)
    found = new_origins(waiting, confirmed, OriginKind.MOVED, "ann", 6.0, known=copied)
    assert found[0.1, 0.1].kind == OriginKind.UNCONFIRMED
    assert found[0.2, 0.2].kind == OriginKind.COPIED
