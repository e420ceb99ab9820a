"""Which field the classes of a set belong to."""

from __future__ import annotations

from dataclasses import replace

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.dataset.diagnostics import classes_in, mismatch_of, rank_fields
from procc_annotator.errors import InputError
from procc_annotator.field.load import load_field

SOCCER = load_field("soccer")
CLASSES = [e.name for e in SOCCER.elements[:12]]


def other(*names: str):
    """A field that knows these classes."""
    elements = tuple(replace(SOCCER.elements[0], name=name) for name in names)
    return replace(SOCCER, name="other", title="Other", elements=elements, symmetries=())


def test_the_field_that_knows_most_comes_first() -> None:
    ranked = rank_fields([*CLASSES, "net"], [other("net", CLASSES[0])])
    assert [(m.title, m.known) for m in ranked if m.title in ("Soccer", "Other")] == [
        ("Soccer", 12),
        ("Other", 2),
    ]
    assert (ranked[0].title, ranked[0].known) == ("Soccer", 12)
    assert rank_fields(["nobody's class"]) == ()
    assert "soccer" in {m.name for m in rank_fields(["Goal left post left"])}  # spaces do not count


def test_among_equals_the_smaller_field_comes_first() -> None:
    small, large = other("net"), replace(other("net", "post"), title="Large")
    assert [m.title for m in rank_fields(["net"], [large, small])] == ["Other", "Large"]


def test_a_mismatch_names_the_field_that_fits() -> None:
    assert mismatch_of([*CLASSES, "Line unknown"], SOCCER) is None
    found = mismatch_of(CLASSES, other("net"))
    assert found.is_worth_reporting
    assert found.better.name == "soccer"
    assert found.words() == (
        "the field Other does not know any of the 12 classes annotated here"
        " (Big rect. left bottom, Big rect. left main, Big rect. left top, ...);"
        " Soccer knows all"
    )


def test_a_line_that_nobody_could_name_tells_no_sport() -> None:
    assert mismatch_of(["Line unknown", "Line unknown (2)"], load_field("tennis")) is None


def test_no_field_is_named_that_knows_no_more() -> None:
    found = mismatch_of([*CLASSES, "sponsor"], SOCCER)
    assert found.better is None
    assert not found.is_worth_reporting  # a slip of the pen in a soccer set
    mostly = mismatch_of([CLASSES[0], "sponsor", "net"], SOCCER)
    assert mostly.better is None
    assert mostly.is_worth_reporting
    alone = mismatch_of(["sponsor"], SOCCER)
    assert alone.is_worth_reporting
    assert alone.words() == (
        "the field Soccer does not know the one class annotated here (sponsor)"
    )


def test_a_field_that_knows_a_few_of_many_is_no_recommendation() -> None:
    padel = [f"padel {n}" for n in range(11)]
    found = mismatch_of([*padel, *CLASSES[:2]], other("net"))
    assert found.better is None  # soccer knows 2 of the 13
    assert found.is_worth_reporting
    found = mismatch_of([*padel, *CLASSES[:2]], other("net"), [other(*padel)])
    assert found.better.known == 11


def test_classes_are_those_with_points_of_frames_that_can_be_read() -> None:
    points = (Point(0.1, 0.1), Point(0.2, 0.2))

    def unreadable() -> FrameAnnotation:
        raise InputError("1.json", "is damaged")

    def one() -> FrameAnnotation:
        return FrameAnnotation((Polyline("a", points), Polyline("b", ())))

    def two() -> FrameAnnotation:
        return FrameAnnotation((Polyline("c", points),))

    assert classes_in([unreadable, one, FrameAnnotation, two]) == {"a", "c"}
    assert classes_in([one, two], most=1) == {"a"}
