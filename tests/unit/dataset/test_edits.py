"""Edits of several points and whole elements; unconfirmed elements count for nothing."""

import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.dataset import editing
from procc_annotator.dataset.records import OriginKind, count_points_by_origin, new_origins
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation, write_annotation

MIDDLE, TOP, ARC = "Middle line", "Side line top", "Circle left"


def line(name: str, *points: tuple[float, float]) -> Polyline:
    return Polyline(name, tuple(Point(u, v) for u, v in points))


BOTH = FrameAnnotation((line(MIDDLE, (0.1, 0.1), (0.2, 0.2), (0.3, 0.3)), line(TOP, (0.5, 0.5))))


def places(annotation: FrameAnnotation, name: str) -> list[tuple[float, float]]:
    polyline = annotation.get(name)
    return [(p.u, p.v) for p in polyline.points] if polyline is not None else []


class TestSeveralPoints:
    def test_points_of_several_classes_move_together(self):
        moved = editing.move_points(BOTH, [(MIDDLE, 0), (MIDDLE, 2), (TOP, 0)], 0.25, -0.125)
        assert places(moved, MIDDLE) == [
            (0.1 + 0.25, 0.1 - 0.125),
            (0.2, 0.2),
            (0.3 + 0.25, 0.3 - 0.125),
        ]
        assert places(moved, TOP) == [(0.75, 0.375)]

    def test_deleting_all_points_of_a_class_deletes_the_class(self):
        left = editing.delete_points(BOTH, [(MIDDLE, 0), (MIDDLE, 1), (TOP, 0)])
        assert places(left, MIDDLE) == [(0.3, 0.3)]
        assert left.get(TOP) is None

    def test_a_point_that_is_not_there_is_an_error(self):
        with pytest.raises(IndexError):
            editing.delete_points(BOTH, [(TOP, 3)])
        with pytest.raises(IndexError):
            editing.move_points(BOTH, [(TOP, 1)], 0, 0)


class TestWholeElements:
    def test_splitting_shares_the_corner(self):
        parted = editing.split(BOTH, MIDDLE, 1, ARC)
        assert places(parted, MIDDLE) == [(0.1, 0.1), (0.2, 0.2)]
        assert places(parted, ARC) == [(0.2, 0.2), (0.3, 0.3)]

    @pytest.mark.parametrize("index", [0, 2, 7])
    def test_there_is_nothing_to_split_at_an_end(self, index):
        with pytest.raises(IndexError):
            editing.split(BOTH, MIDDLE, index, ARC)

    def test_the_rest_of_a_split_needs_a_free_class(self):
        with pytest.raises(ValueError):
            editing.split(BOTH, MIDDLE, 1, TOP)

    def test_merging_undoes_a_split(self):
        merged = editing.merge(editing.split(BOTH, MIDDLE, 1, ARC), ARC, MIDDLE)
        assert places(merged, MIDDLE) == places(BOTH, MIDDLE)
        assert merged.get(ARC) is None

    @pytest.mark.parametrize("turned", [False, True])
    @pytest.mark.parametrize("before", [False, True])
    def test_merging_joins_the_nearest_ends(self, turned, before):
        first, second = [(0.1, 0.1), (0.2, 0.1)], [(0.3, 0.1), (0.4, 0.1)]
        kept, taken = (second, first) if before else (first, second)
        both = FrameAnnotation((line(TOP, *kept), line(ARC, *(taken[::-1] if turned else taken))))
        assert places(editing.merge(both, ARC, TOP), TOP) == [*first, *second]

    def test_merging_needs_two_elements(self):
        for source, target in ((MIDDLE, ARC), (ARC, MIDDLE), (MIDDLE, MIDDLE)):
            with pytest.raises(ValueError):
                editing.merge(BOTH, source, target)

    def test_reversing_twice_changes_nothing(self):
        once = editing.reverse(BOTH, MIDDLE)
        assert places(once, MIDDLE) == places(BOTH, MIDDLE)[::-1]
        assert editing.reverse(once, MIDDLE) == BOTH

    def test_swapping_classes_swaps_their_points(self):
        swapped = editing.swap_classes(BOTH, MIDDLE, TOP)
        assert places(swapped, TOP) == places(BOTH, MIDDLE)
        assert places(swapped, MIDDLE) == places(BOTH, TOP)
        assert places(editing.swap_classes(BOTH, MIDDLE, ARC), ARC) == places(BOTH, MIDDLE)
        with pytest.raises(ValueError):
            editing.swap_classes(BOTH, ARC, "Circle right")


class TestUnconfirmed:
    WAITING = editing.add_unconfirmed(
        BOTH, [line(ARC, (0.7, 0.7), (0.8, 0.8)), line(TOP, (0.9, 0.9))]
    )

    def test_a_class_that_is_annotated_is_not_proposed(self):
        assert [p.class_name for p in self.WAITING.unconfirmed] == [ARC]
        assert places(self.WAITING, TOP) == [(0.5, 0.5)]

    def test_it_is_neither_counted_nor_written(self):
        assert self.WAITING.annotated == BOTH.annotated
        assert write_annotation(self.WAITING) == write_annotation(BOTH)
        assert self.WAITING.same_content(BOTH)
        assert self.WAITING != BOTH

    def test_confirming_makes_it_an_element_like_any_other(self):
        confirmed = editing.confirm(self.WAITING, ARC)
        assert places(confirmed, ARC) == [(0.7, 0.7), (0.8, 0.8)]
        assert not confirmed.unconfirmed
        assert editing.confirm_all(self.WAITING) == confirmed
        data = write_annotation(confirmed)
        assert read_annotation(data, path="x", field=load_field()) == confirmed

    def test_drawing_the_class_takes_its_place(self):
        drawn = editing.append_points(self.WAITING, ARC, [Point(0.1, 0.9)])
        assert places(drawn, ARC) == [(0.1, 0.9)]
        assert not drawn.unconfirmed

    def test_deleting_the_class_removes_it(self):
        assert editing.drop_unconfirmed(self.WAITING) == BOTH


# Every new point gets an origin; what is only renamed, split or undone keeps its own.

EMPTY = FrameAnnotation()
DRAWN = FrameAnnotation((Polyline("Middle line", (Point(0.1, 0.1), Point(0.2, 0.2))),))


def test_points_of_an_edit_are_of_its_kind_but_for_the_snapped_ones():
    found = new_origins(EMPTY, DRAWN, OriginKind.CLICKED, "ann", 5.0, snapped={(0.2, 0.2)})
    assert {key: origin.kind for key, origin in found.items()} == {
        (0.1, 0.1): OriginKind.CLICKED,
        (0.2, 0.2): OriginKind.SNAPPED,
    }
    assert {(o.author, o.time) for o in found.values()} == {("ann", 5.0)}


def test_another_class_is_no_new_point():
    renamed = editing.change_class(DRAWN, "Middle line", "Circle left")
    assert new_origins(DRAWN, renamed, OriginKind.MOVED, "ann", 5.0) == {}


def test_a_moved_point_is_new_and_the_others_are_not():
    moved = editing.move_point(DRAWN, "Middle line", 1, Point(0.3, 0.2))
    assert list(new_origins(DRAWN, moved, OriginKind.MOVED, "ann", 5.0)) == [(0.3, 0.2)]


def test_confirmed_points_were_copied_whatever_confirmed_them():
    waiting = editing.add_unconfirmed(EMPTY, DRAWN.polylines)
    assert new_origins(EMPTY, waiting, OriginKind.COPIED, "ann", 5.0) == {}
    found = new_origins(waiting, editing.confirm_all(waiting), OriginKind.MOVED, "ann", 6.0)
    assert {o.kind for o in found.values()} == {OriginKind.COPIED}


def test_counts_leave_points_of_unknown_origin_to_the_file():
    known = new_origins(EMPTY, DRAWN, OriginKind.CLICKED, "ann", 5.0)
    del known[0.1, 0.1]
    assert count_points_by_origin(DRAWN, known) == {OriginKind.CLICKED: 1, OriginKind.FILE: 1}


def test_points_without_paint_are_told_as_such_new_or_not():
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
