"""Findings over a picture: which signs, where, and with which names."""

from __future__ import annotations

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.calibration.label_check.finding import Finding, Rule, Severity
from procc_annotator.calibration.result import FitResult
from procc_annotator.dataset.review import StoredFinding, store_check
from procc_annotator.field.load import load_field
from procc_annotator.interaction import palette as tones
from procc_annotator.interaction.overlay import OverlayBuilder, OverlayContent
from procc_annotator.interaction.overlay_primitives import Labels, Overlay

SIZE = (101, 51)
FIELD = load_field("soccer")
FRAME = FrameAnnotation(
    (
        Polyline("Middle line", (Point(0.5, 0.0), Point(0.5, 0.5), Point(0.5, 1.0))),
        Polyline("Side line top", (Point(0.0, 0.2), Point(1.0, 0.2))),
    )
)


def found(*findings: Finding) -> tuple[StoredFinding, ...]:
    return store_check(FRAME, findings, FitResult("R", SIZE, None)).found


def finding(name: str, severity: Severity, point: int | None = None) -> Finding:
    return Finding(Rule.POINT, severity, (name,), "it is off", (), point)


def drawn(*findings: Finding, **more: object) -> Overlay:
    annotation = more.pop("annotation", FRAME)
    assert isinstance(annotation, FrameAnnotation)
    return OverlayBuilder().build(
        OverlayContent(
            annotation=annotation,
            size=SIZE,
            field=FIELD,
            picture_size=SIZE,
            found=found(*findings),
            **more,
        )
    )


def signs(overlay: Overlay) -> dict[str, Labels]:
    return {labels.sign: labels for labels in overlay.labels if labels.sign}


def test_an_element_bears_the_sign_of_its_surest_finding() -> None:
    shown = signs(
        drawn(
            finding("Middle line", Severity.WARNING, 0),
            finding("Middle line", Severity.ERROR, 2),
            finding("Side line top", Severity.WARNING),
        )
    )
    assert shown["error"].texts == ("Halfway line",)
    np.testing.assert_allclose(shown["error"].positions, [[50, 50]])
    assert shown["warning"].texts == ("Far touchline",)
    assert shown["hint"].texts == ()


def test_a_hint_is_named_only_where_somebody_looks() -> None:
    hint = finding("Middle line", Severity.HINT)
    assert signs(drawn(hint))["hint"].texts == ("",)
    assert signs(drawn(hint, selection="Middle line"))["hint"].texts == ("Halfway line",)


def test_a_sign_beside_the_picture_is_brought_to_its_edge() -> None:
    beside = FRAME.with_polyline(Polyline("Side line top", (Point(1.4, 0.2),)))
    overlay = drawn(finding("Side line top", Severity.ERROR, 0), annotation=beside)
    np.testing.assert_allclose(signs(overlay)["error"].positions, [[100, 10]])
    np.testing.assert_allclose(overlay.marks[-1].centres, [[140, 10]])  # the point itself


def test_only_a_point_that_is_wrong_by_itself_is_ringed() -> None:
    ring = drawn(
        finding("Middle line", Severity.ERROR, 1), finding("Side line top", Severity.ERROR)
    ).marks[-1]
    assert (ring.shape, ring.colour) == ("ring", tones.FINDING)
    np.testing.assert_allclose(ring.centres, [[50, 25]])


def test_overlays_have_the_same_groups_whatever_was_found() -> None:
    bare, full = drawn(), drawn(finding("Middle line", Severity.ERROR, 1))
    for groups in ("strokes", "marks", "labels"):
        assert len(getattr(bare, groups)) == len(getattr(full, groups))


def test_a_point_that_a_gesture_takes_away_loses_its_sign() -> None:
    shorter = FRAME.with_polyline(Polyline("Middle line", (Point(0.5, 0.0),)))
    overlay = drawn(finding("Middle line", Severity.ERROR, 2), annotation=shorter)
    assert signs(overlay)["error"].texts == ()
    assert not len(overlay.marks[-1].centres)
