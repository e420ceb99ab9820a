"""What is remembered of a label check: how long it holds, and where its marks stand."""

import math
from dataclasses import replace

import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.calibration.label_check.finding import (
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
)
from procc_annotator.calibration.result import ElementResidual, FitResult
from procc_annotator.dataset.review import (
    BlindCommit,
    BlindStatus,
    LockEvent,
    blind_status,
    check_frame,
    check_without_fit,
    content_of,
    lock_of,
    read_commit,
    read_events,
    setting_of,
    still_valid,
    store_check,
    worst_severity,
    write_commit,
    write_events,
)
from procc_annotator.field.load import load_field

SIZE = (1920, 1080)


def line(name: str, *places: tuple[float, float]) -> Polyline:
    return Polyline(name, tuple(Point(u, v) for u, v in places))


MIDDLE = line("Middle line", (0.5, 0.1), (0.5, 0.5), (0.5, 0.9))
TOP = line("Side line top", (0.1, 0.2), (0.9, 0.2))
FRAME = FrameAnnotation((MIDDLE, TOP))
LOOK = Remedy(RemedyKind.LOOK, "look at it")


def finding(
    *elements: str,
    rule: Rule = Rule.RESIDUAL,
    severity: Severity = Severity.ERROR,
    point: int | None = None,
) -> Finding:
    error = 20.0 if rule is Rule.RESIDUAL else None
    return Finding(rule, severity, elements, "it is off", (LOOK,), point, error)


def fitted(**distances: tuple[float, ...]) -> FitResult:
    elements = tuple(ElementResidual(n.replace("_", " "), d, False) for n, d in distances.items())
    return FitResult("R", SIZE, None, elements=elements)


def test_content_is_the_same_as_long_as_all_points_are():
    assert content_of(FRAME) == content_of(FrameAnnotation((TOP, MIDDLE)))  # order does not matter
    waiting = FrameAnnotation(FRAME.polylines, unconfirmed=(line("Circle central", (0.4, 0.4)),))
    assert content_of(waiting) == content_of(FRAME)
    moved = FRAME.with_polyline(line("Side line top", (0.1, 0.2), (math.nextafter(0.9, 1.0), 0.2)))
    assert content_of(moved) != content_of(FRAME)
    renamed = FrameAnnotation((MIDDLE, line("Side line bottom", (0.1, 0.2), (0.9, 0.2))))
    assert content_of(renamed) != content_of(FRAME)


def test_points_that_go_over_to_another_element_are_another_content():
    one = FrameAnnotation((line("a", (0.1, 0.1), (0.2, 0.2)), line("b", (0.3, 0.3))))
    other = FrameAnnotation((line("a", (0.1, 0.1)), line("b", (0.2, 0.2), (0.3, 0.3))))
    assert content_of(one) != content_of(other)


def test_a_finding_keeps_its_key_while_its_elements_stay_as_they_are():
    found = store_check(FRAME, [finding("Middle line")], fitted()).found[0]
    elsewhere = FRAME.with_polyline(line("Side line top", (0.1, 0.3), (0.9, 0.2)))
    again = store_check(elsewhere, [finding("Middle line")], fitted()).found[0]
    assert again.key == found.key
    there = FRAME.with_polyline(line("Middle line", (0.5, 0.1), (0.6, 0.9)))
    assert store_check(there, [finding("Middle line")], fitted()).found[0].key != found.key


def test_keys_tell_rules_elements_and_points_apart():
    findings = [
        finding("Middle line"),
        finding("Middle line", rule=Rule.BENT),
        finding("Middle line", "Side line top"),
        finding("Middle line", point=0),
        finding("Middle line", point=1),
    ]
    keys = {found.key for found in store_check(FRAME, findings, fitted()).found}
    assert len(keys) == len(findings)


def test_after_an_edit_only_findings_of_untouched_elements_are_left():
    checked = store_check(FRAME, [finding("Middle line"), finding("Side line top")], fitted())
    edited = FRAME.with_polyline(line("Side line top", (0.1, 0.3), (0.9, 0.2)))
    left = still_valid(checked, edited)
    assert [f.finding.elements for f in left.found] == [("Middle line",)]
    assert left.content != content_of(edited)  # nobody has checked that


@pytest.mark.parametrize(
    ("point", "distances", "index"),
    [
        (2, (9.0, 1.0, 1.0), 2),  # the finding says which
        (None, (9.0, 1.0, 1.0), 0),  # the farthest
        (None, (1.0, 9.0), 1),  # of another polyline: the middle one
        (None, None, 1),  # no camera
        (7, (1.0, 1.0, 9.0), 2),  # no such point
    ],
)
def test_marks_stand_at_the_worst_point(point, distances, index):
    fit = fitted(Middle_line=distances) if distances else fitted()
    found = store_check(FRAME, [finding("Middle line", point=point)], fit).found[0]
    assert found.places == (("Middle line", index),)


def test_marks_stand_at_the_worst_point_beside_repeated_ones():
    again = FrameAnnotation(
        (line("Middle line", (0.5, 0.1), (0.5, 0.1), (0.5, 0.5), (0.5, 0.1), (0.5, 0.9)),)
    )
    found = store_check(again, [finding("Middle line")], fitted(Middle_line=(1.0, 2.0, 9.0))).found[
        0
    ]
    assert found.places == (("Middle line", 4),)


def test_marks_stand_inside_the_picture_if_any_point_does():
    leaving = FrameAnnotation((line("Side line top", (0.9, 0.2), (1.1, 0.2), (1.3, 0.2)),))
    fit = fitted(Side_line_top=(1.0, 5.0, 9.0))
    checked = store_check(leaving, [finding("Side line top")], fit)
    assert checked.found[0].places == (("Side line top", 0),)


def test_elements_that_are_not_annotated_have_no_marks():
    found = store_check(FRAME, [finding("Side line top", "Circle central")], fitted()).found[0]
    assert [name for name, _ in found.places] == ["Side line top"]


def test_the_surest_severity_wins():
    findings = [
        finding("Middle line", severity=Severity.HINT),
        finding("Side line top", severity=Severity.WARNING),
    ]
    checked = store_check(FRAME, findings, fitted())
    assert worst_severity(checked.found) is Severity.WARNING
    assert worst_severity(()) is None


def test_without_a_camera_only_rules_that_need_none_are_looked_at():
    bent = line("Side line top", (0.1, 0.2), (0.3, 0.3), (0.5, 0.2), (0.7, 0.3), (0.9, 0.2))
    checked = check_without_fit(FRAME.with_polyline(bent), load_field("soccer"), size=SIZE)
    assert not checked.fitted
    assert [f.finding.rule for f in checked.found if f.finding.elements[0] == bent.class_name] == [
        Rule.BENT
    ]
    assert all(found.finding.model is None for found in checked.found)


def test_a_frame_that_cannot_have_a_camera_says_why():
    checked = check_frame(FRAME, load_field("soccer"), size=SIZE)
    assert checked.fitted
    assert "elements" in checked.failure


# Who locked a dataset to blind mode and who took it back.

LOCKED, UNLOCKED = LockEvent(True, "Ada", 1.5), LockEvent(False, "Béla", 2.0)


@pytest.mark.parametrize(
    ("events", "lock"),
    [
        ((), None),
        ((LOCKED,), LOCKED),
        ((LOCKED, UNLOCKED), None),
        ((LOCKED, UNLOCKED, LOCKED),) * 2,
    ],
)
def test_the_last_word_holds(events, lock):
    expected = events[-1] if isinstance(lock, tuple) else lock
    assert read_events(write_events(events)) == events
    assert lock_of(events) is expected


def test_what_cannot_be_read_locks():
    assert lock_of(read_events("[{")) is not None
    assert read_events(None) == ()


# Whether a frame's clicks are still those of its commit in blind mode.

LINE = Polyline("Middle line", (Point(0.1, 0.2), Point(0.3, 0.4)))
COMMITTED = FrameAnnotation((LINE,))
COMMIT = BlindCommit("Ana Müller", 1.5, content_of(COMMITTED))


def test_a_commit_is_read_as_it_was_written():
    assert read_commit(write_commit(COMMIT)) == COMMIT
    assert read_commit(None) is None
    assert setting_of("1") != setting_of("2")


def test_the_points_decide():
    text = write_commit(COMMIT)
    moved = replace(LINE, points=(Point(0.1, 0.2), Point(0.3, 0.41)))
    more = FrameAnnotation((LINE, Polyline("Side line top", (Point(0.5, 0.5),))))
    assert blind_status(text, COMMITTED) is BlindStatus.BLIND
    assert blind_status(text, FrameAnnotation((LINE,), unconfirmed=(moved,))) is BlindStatus.BLIND
    assert blind_status(text, FrameAnnotation((moved,))) is BlindStatus.EDITED
    assert blind_status(text, more) is BlindStatus.EDITED
    assert blind_status(text, FrameAnnotation()) is BlindStatus.EDITED
    assert blind_status(None, COMMITTED) is BlindStatus.UNKNOWN


@pytest.mark.parametrize("text", ["", "{", "[]", '{"author": "x"}', "null"])
def test_of_a_damaged_commit_nothing_is_claimed(text):
    assert blind_status(text, COMMITTED) is BlindStatus.EDITED
    assert blind_status(text, FrameAnnotation()) is BlindStatus.EDITED
