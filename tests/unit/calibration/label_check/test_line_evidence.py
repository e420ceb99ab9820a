"""What a picture shows under elements, given as data: findings where it is none, or beside."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px
from procc_annotator.calibration.label_check.check import add_line_evidence, check_without_camera
from procc_annotator.calibration.label_check.evidence import LineEvidence, LinePresence
from procc_annotator.calibration.label_check.finding import Finding, Rule, Severity
from procc_annotator.calibration.result import FitResult

SIZE = (960, 540)
NO_FIT = FitResult("", SIZE, None, failure="not asked for")
NAMES = ("Goal left crossbar", "Side line left", "Big rect. left main")
NOTHING = (np.zeros(0), np.zeros(0))
NAN = float("nan")


def line(name: str, *places: tuple[float, float]) -> Polyline:
    return Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in places))


def seen(*offsets: float, length: float = 200.0) -> LineEvidence:
    count = len(offsets)
    places = np.column_stack([np.linspace(100, 100 + length, count), np.full(count, 200.0)])
    each = np.full(count, length / count)
    zeros = np.zeros(count, dtype=np.intp)
    return LineEvidence(SIZE, places, np.array(offsets), zeros, each, (NOTHING, NOTHING))


GOOD = seen(*[0.1] * 12)


def findings(field, paint: dict[str, LineEvidence]) -> list[Finding]:
    polylines = [line(n, (100, 100 + 80 * k), (300, 100 + 80 * k)) for k, n in enumerate(NAMES)]
    annotation = FrameAnnotation(tuple(polylines))
    told = add_line_evidence((), annotation, field, size=SIZE, fit=NO_FIT, paint=paint)
    return [f for f in told if f.elements[0] == NAMES[0]]


def found(field, paint: dict[str, LineEvidence]) -> list[tuple[Rule, Severity, str]]:
    return [(f.rule, f.severity, f.reason) for f in findings(field, paint)]


def test_a_crossbar_on_spectators_is_found_with_share_and_length(field) -> None:
    crowd = seen(3.1, NAN, -4.0, 5.5, NAN, -2.0, 4.4, NAN, 0.2, -5.0, NAN, 2.6)
    (told,) = found(field, {NAMES[0]: crowd, NAMES[1]: GOOD, NAMES[2]: GOOD})
    assert told[:2] == (Rule.NO_PAINT, Severity.WARNING)
    assert "100 % of it" in told[2]
    assert "200 px on end" in told[2]
    half = seen(*[0.2] * 5, *[NAN] * 7)
    (told,) = found(field, {NAMES[0]: half, NAMES[1]: GOOD, NAMES[2]: GOOD})
    assert told[:2] == (Rule.NO_PAINT, Severity.HINT)


@pytest.mark.parametrize(
    "offsets", [[0.4] * 12, [*[0.3] * 8, *[NAN] * 4], [1.5, 1.2, 0.9, 0.5, 0.2, 0.0] * 2]
)
def test_what_players_hide_is_no_finding(field, offsets) -> None:
    assert found(field, {NAMES[0]: seen(*offsets), NAMES[1]: GOOD, NAMES[2]: GOOD}) == []


def test_a_picture_in_which_hardly_any_paint_is_found_says_nothing(field) -> None:
    dark = seen(*[NAN] * 12)
    assert found(field, dict.fromkeys(NAMES, dark)) == []
    assert found(field, {}) == []


def test_bent_paint_beside_a_straight_element_is_told_with_what_mends_it(field) -> None:
    t = np.linspace(-1, 1, 12)
    bent = seen(*(4.0 * (1 - t**2)))
    (told,) = found(field, {NAMES[0]: bent, NAMES[1]: GOOD, NAMES[2]: GOOD})
    assert told[:2] == (Rule.BESIDE_PAINT, Severity.WARNING)
    assert "up to 4 px" in told[2]
    assert "(R)" in told[2]
    assert set(bent.paint) == {LinePresence.UNDER, LinePresence.RIGHT}
    missing = seen(*np.where(np.abs(t) > 0.4, NAN, 4.0))
    assert Rule.BESIDE_PAINT not in [
        f[0] for f in found(field, {NAMES[0]: missing, NAMES[1]: GOOD, NAMES[2]: GOOD})
    ]


@pytest.mark.parametrize("at_first", [True, False])
def test_an_end_beside_its_paint_is_told_with_its_point(field, at_first) -> None:
    """The way there leaves the paint steadily, until it is too far off to be looked for."""
    off = [*(7.0 * (np.arange(9) + 0.5) / 12), NAN, NAN, NAN]
    astray = seen(*(off[::-1] if at_first else off))
    (told,) = findings(field, {NAMES[0]: astray, NAMES[1]: GOOD, NAMES[2]: GOOD})
    assert (told.rule, told.severity) == (Rule.BESIDE_PAINT, Severity.WARNING)
    assert "about 7 px beside its paint" in told.reason
    assert told.point == (0 if at_first else 1)
    near = seen(*(2.0 * (np.arange(12) + 0.5) / 12))  # as a hand clicks
    assert found(field, {NAMES[0]: near, NAMES[1]: GOOD, NAMES[2]: GOOD}) == []


def test_an_end_without_paint_is_told_where_all_else_has_some(field) -> None:
    places = replace(seen(*[0.1] * 9, *[NAN] * 3), segments=np.repeat([0, 1, 2, 3], 3))
    (told,) = findings(field, {NAMES[0]: places, NAMES[1]: GOOD, NAMES[2]: GOOD})
    assert (told.rule, told.severity, told.point) == (Rule.NO_PAINT, Severity.HINT, 1)
    assert "towards one of its ends" in told.reason


def test_a_short_post_without_paint_is_told(field) -> None:
    nothing = seen(NAN, NAN, NAN, length=24.0)
    (told,) = found(field, {NAMES[0]: nothing, NAMES[1]: GOOD, NAMES[2]: GOOD})
    assert told[:2] == (Rule.NO_PAINT, Severity.HINT)
    assert found(field, {NAMES[1]: nothing, NAMES[0]: GOOD, NAMES[2]: GOOD}) == []


def test_an_end_is_short_only_where_paint_goes_on(field) -> None:
    annotation = FrameAnnotation((line("Side line top", (20, 100), (700, 120)),))
    told = check_without_camera(annotation, field, size=SIZE)
    assert [f.rule for f in told] == [Rule.SHORT]
    ahead = np.arange(3.0, 24.0, 6.0)
    for offsets, rules in ((np.full(4, NAN), []), (np.full(4, 0.3), [Rule.SHORT])):
        paint = {"Side line top": replace(GOOD, ahead=((ahead, offsets), NOTHING))}
        again = add_line_evidence(told, annotation, field, size=SIZE, fit=NO_FIT, paint=paint)
        assert [f.rule for f in again] == rules
