"""A remedy is one pure edit: names exchanged all at once, points untouched, nothing lost."""

from __future__ import annotations

import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.assist.frame_analysis import apply_remedy, rename_classes
from procc_annotator.calibration.label_check.finding import (
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
)
from procc_annotator.errors import UsageError
from procc_annotator.field.load import load_field

FIELD = load_field()
A, B, C = "Big rect. left main", "Small rect. left main", "Middle line"


def polyline(name: str, *us: float) -> Polyline:
    return Polyline(name, tuple(Point(u, 0.5, (("seen", True),)) for u in us))


ANNOTATION = FrameAnnotation(
    (polyline(A, 0.1, 0.2), polyline(B, 0.3, 0.4, 0.5)), extra=(("note", "x"),)
)


def finding(*elements: str, point: int | None = None) -> Finding:
    return Finding(Rule.RESIDUAL, Severity.ERROR, elements, "why", (), point)


def remedy(kind: RemedyKind, *renamed: tuple[str, str]) -> Remedy:
    return Remedy(kind, "swap one and the other", renamed)


def test_a_swap_exchanges_names_and_keeps_points_and_order() -> None:
    swap = remedy(RemedyKind.SWAP, (A, B), (B, A))
    mended = apply_remedy(ANNOTATION, finding(A, B), swap)
    assert [p.class_name for p in mended] == [B, A]
    assert [p.points for p in mended] == [p.points for p in ANNOTATION]
    assert mended.extra == ANNOTATION.extra
    assert apply_remedy(mended, finding(A, B), swap) == ANNOTATION


def test_many_classes_are_renamed_at_once() -> None:
    three = FrameAnnotation((*ANNOTATION.polylines, polyline(C, 0.7)))
    mended = rename_classes(three, {A: B, B: C, C: A})
    assert [p.class_name for p in mended] == [B, C, A]


def test_an_empty_class_and_an_unconfirmed_one_give_way() -> None:
    annotation = FrameAnnotation(
        (*ANNOTATION.polylines, Polyline(C, ())), unconfirmed=(polyline(C, 0.9),)
    )
    mended = rename_classes(annotation, {A: C})
    assert [p.class_name for p in mended] == [C, B]
    assert mended.unconfirmed == ()


@pytest.mark.parametrize(
    ("names", "message"),
    [
        ({A: B}, "Left goal area front is annotated already"),
        ({A: C, B: C}, "Halfway line is annotated already"),
        ({C: "Circle left"}, "Halfway line is not annotated any more"),
    ],
)
def test_two_elements_never_become_one(names, message) -> None:
    with pytest.raises(UsageError, match=message):
        rename_classes(ANNOTATION, names, FIELD)
    with pytest.raises(UsageError, match="annotated"):
        apply_remedy(ANNOTATION, finding(A), remedy(RemedyKind.RELABEL, *names.items()))


def test_a_point_is_removed() -> None:
    mended = apply_remedy(ANNOTATION, finding(B, point=1), remedy(RemedyKind.REMOVE_POINT))
    assert [p.u for p in mended.get(B).points] == [0.3, 0.5]
    assert mended.get(A) == ANNOTATION.get(A)
    for gone in (finding(B, point=3), finding(C, point=0), finding(B)):
        with pytest.raises(UsageError, match="no such point"):
            apply_remedy(ANNOTATION, gone, remedy(RemedyKind.REMOVE_POINT), FIELD)


def test_looking_changes_nothing() -> None:
    assert apply_remedy(ANNOTATION, finding(A), remedy(RemedyKind.LOOK)) is ANNOTATION
