"""The label check, ghosts and suggestions for other sports than soccer."""

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Polyline, point_from_px, points_px
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.label_check.candidate_classes import (
    MIRROR_X,
    MIRROR_Y,
    mirrored_names,
    relabelled,
)
from procc_annotator.calibration.label_check.check import check_labels
from procc_annotator.calibration.label_check.finding import Finding, RemedyKind, Rule, Severity
from procc_annotator.calibration.prediction.ghosts import find_ghosts
from procc_annotator.calibration.prediction.suggestions import suggest_annotations
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.editing import change_class, swap_classes
from procc_annotator.field.landmarks import with_landmarks
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field, Landmark
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

SIZE = (960, 540)
SPORTS = ("basketball_fiba", "ice_hockey_iihf", "volleyball", "tennis")
# Shares of the field's length: where the camera stands beyond the near side line, how high, and
# where it looks.
PLACES = ((0.3, 0.2, -0.2), (0.5, 0.25, 0.1), (0.4, 0.12, 0.25))


def camera_of(field: Field, place: tuple[float, float, float]) -> PinholeCamera:
    length, width = (field.dimension(name).value for name in ("length", "width"))
    away, height, look = (length * share for share in place)
    position = np.array([0.1 * length, width / 2 + away, -height])
    toward = np.array([look, 0.0, 0.0]) - position
    distance = np.linalg.norm(toward)
    toward /= distance
    focal = 960 * distance / (1.2 * length)
    return PinholeCamera(
        float(np.arctan2(toward[0], -toward[1])), float(np.arccos(toward[2])), 0.01,
        tuple(position.tolist()), (focal, focal), (479.5, 269.5),
    )  # fmt: skip


def clicks(field: Field, camera: PinholeCamera, *, optional: bool = True) -> FrameAnnotation:
    """What somebody would click, to about a pixel: chains along each of their parts in sight."""
    rng = np.random.default_rng(7)
    found = []
    for name, pieces in project_field(camera, EvaluationSetup(field, SIZE, "procc")).pieces.items():
        element = field.element(name)
        if element.optional and not optional:
            continue
        if element.is_spot:
            points = pieces[0][:1]
        else:
            long = [p for p in pieces if np.hypot(*np.ptp(p, axis=0)) > 25]
            if not long:
                continue
            many = 9 if element.is_curved and len(long) == 1 else 3
            points = np.concatenate(
                [p[np.linspace(0, len(p) - 1, many).round().astype(int)] for p in long]
            )
        noisy = points + rng.normal(0, 0.7, points.shape)
        found.append(Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in noisy)))
    return FrameAnnotation(tuple(found))


def check(annotation: FrameAnnotation, field: Field) -> tuple[Finding, ...]:
    fit = fit_camera(annotation, field, size=SIZE)
    found = check_labels(annotation, field, size=SIZE, fit=fit)
    return tuple(f for f in found if f.severity is not Severity.HINT)


@pytest.fixture(scope="module", params=SPORTS)
def sport(request) -> Field:
    return load_field(request.param)


@pytest.mark.parametrize("place", PLACES)
def test_right_labels_are_left_alone(sport, place):
    annotation = clicks(sport, camera_of(sport, place))
    assert len(annotation.polylines) > 5
    assert check(annotation, sport) == ()


@pytest.mark.parametrize("place", PLACES)
def test_two_exchanged_labels_are_found(sport, place):
    annotation = clicks(sport, camera_of(sport, place))
    shape = {n: (sport.element(n).is_straight, sport.element(n).is_spot)
             for n in annotation.annotated}  # fmt: skip
    lines = [n for n in annotation.annotated if shape[n] == (True, False)]
    one, other = lines[0], lines[-1]
    (found,) = check(swap_classes(annotation, one, other), sport)
    assert (found.rule, found.severity) == (Rule.SWAPPED, Severity.ERROR)
    assert set(found.elements) == {one, other}
    assert dict(found.remedies[0].renamed) == {one: other, other: one}


@pytest.mark.parametrize("signs", [MIRROR_Y, MIRROR_X])
def test_a_frame_seen_the_wrong_way_round_is_found(sport, signs):
    annotation = clicks(sport, camera_of(sport, PLACES[0]))
    becomes = mirrored_names(sport, signs, annotation.annotated)
    assert becomes is not None
    (found,) = check(relabelled(annotation, becomes), sport)
    assert found.rule is Rule.REFLECTED
    assert len(found.remedies) == 2


def test_what_has_no_reflection_is_never_called_reflected():
    track = load_field("athletics")
    assert mirrored_names(track, MIRROR_Y, ["Finish line"]) is None
    hockey = load_field("ice_hockey_iihf")
    assert mirrored_names(hockey, MIRROR_Y) is not None


# ------------------------------------------------------------------------------ spots and chains


@pytest.fixture(scope="module")
def hockey() -> tuple[Field, FrameAnnotation]:
    field = load_field("ice_hockey_iihf")
    return field, clicks(field, camera_of(field, PLACES[0]))


def spots_of(field: Field, annotation: FrameAnnotation) -> list[str]:
    return [n for n in annotation.annotated if field.element(n).is_spot]


def test_a_spot_under_another_ones_name_is_found(hockey):
    field, annotation = hockey
    spots = spots_of(field, annotation)
    one, other = spots[0], spots[-1]
    (found,) = check(swap_classes(annotation, one, other), field)
    assert found.rule is Rule.SWAPPED
    assert set(found.elements) == {one, other}
    free = next(e.name for e in field.elements if e.is_spot and e.name not in annotation.annotated)
    (found,) = check(change_class(annotation, one, free), field)
    assert found.elements == (free,)
    assert found.remedies[0].renamed == ((free, one),)


def test_a_line_under_a_spot_s_name_is_offered_the_line(hockey):
    field, annotation = hockey
    line = next(n for n in annotation.annotated if field.element(n).is_straight)
    free = next(e.name for e in field.elements if e.is_spot and e.name not in annotation.annotated)
    findings = {f.rule: f for f in check(change_class(annotation, line, free), field)}
    assert findings[Rule.RESIDUAL].remedies[0].renamed == ((free, line),)
    assert findings[Rule.MANY_POINTS].elements == (free,)


def test_two_places_for_one_spot_are_a_finding(hockey):
    field, annotation = hockey
    name = spots_of(field, annotation)[0]
    ((x, y),) = points_px(annotation.get(name), SIZE)
    for apart, rules in ((1.0, []), (6.0, [Rule.MANY_POINTS])):
        points = (point_from_px(x, y, SIZE), point_from_px(x + apart, y, SIZE))
        changed = annotation.with_polyline(Polyline(name, points))
        assert [f.rule for f in check(changed, field)] == rules


def test_going_round_three_sides_is_not_going_back_and_forth():
    """A chain whose way is long although its ends are near each other."""
    court = load_field("basketball_fiba")
    annotation = clicks(court, camera_of(court, PLACES[0]))
    chains = [e.name for e in court.elements if e.is_curved and annotation.get(e.name) is not None]
    fit = fit_camera(annotation, court, size=SIZE)
    found = check_labels(annotation, court, size=SIZE, fit=fit)
    assert len(chains) > 2
    assert not [f for f in found if f.rule is Rule.REPEATED and "Backboard" in f.elements[0]]


def test_a_hoop_seen_edge_on_is_where_it_is():
    """From the height of the rim its circle is a line in the picture; every click lies on it."""
    court = load_field("basketball_fiba")
    camera = camera_of(court, (0.35, 3.05 / 28.0, 0.2))
    annotation = clicks(court, camera)
    assert any(n.startswith("Rim") or "rim" in n.lower() for n in annotation.annotated)
    assert check(annotation, court) == ()


# ------------------------------------------------------------------------- ghosts and suggestions


def test_ghosts_are_neither_spots_nor_optional_and_lie_where_the_elements_are(sport):
    camera = camera_of(sport, PLACES[1])
    every = clicks(sport, camera, optional=False)
    some = FrameAnnotation(every.polylines[3:])
    fit = fit_camera(some, sport, size=SIZE)
    ghosts = find_ghosts(some, sport, fit)
    assert ghosts
    shown = project_field(camera, EvaluationSetup(sport, SIZE, "procc")).pieces
    for ghost in ghosts:
        element = sport.element(ghost.name)
        assert not element.is_spot
        assert not element.optional
        assert ghost.name in shown
        for piece in ghost.pieces:
            away = np.concatenate(shown[ghost.name])
            middle = piece.points_px[len(piece.points_px) // 2]
            assert np.hypot(*(away - middle).T).min() < 60


def test_a_chain_is_offered_side_by_side():
    """One piece for each side of a backboard, which ends at its corners."""
    court = load_field("basketball_fiba")
    camera = camera_of(court, PLACES[0])
    every = clicks(court, camera)
    some = FrameAnnotation(tuple(p for p in every if "Backboard" not in p.class_name))
    fit = fit_camera(some, court, size=SIZE)
    boards = [g for g in find_ghosts(some, court, fit) if "Backboard" in g.name]
    for ghost in boards:
        assert len(ghost.pieces) > 1
        for piece in ghost.pieces:
            ends = piece.points_px[[0, -1]]
            straight = np.hypot(*(ends[1] - ends[0]))
            way = np.hypot(*np.diff(piece.points_px, axis=0).T).sum()
            assert way < 1.01 * straight
    assert boards


def test_a_landmark_is_suggested_where_it_helps():
    from procc_annotator.field.landmarks import with_landmarks
    from procc_annotator.field.model import Landmark

    court = load_field("volleyball")
    camera = camera_of(court, PLACES[0])
    some = FrameAnnotation(clicks(court, camera, optional=False).polylines[:3])
    seat = Landmark("Seat 12", position=(3.0, -6.0, -1.5))
    field = with_landmarks(court, [seat])
    fit = fit_camera(some, field, size=SIZE)
    suggested = {s.name: s for s in suggest_annotations(some, field, fit)}
    optional = {e.name for e in court.elements if e.optional}
    assert "Seat 12" in suggested
    assert optional.isdisjoint(suggested)
    assert suggested["Seat 12"].sd_after_px < suggested["Seat 12"].sd_before_px
    assert suggested["Seat 12"].place_world == (3.0, -6.0, -1.5)


# Landmarks are judged by what their own uncertainty allows where it is seen.

CAMERA = PinholeCamera(
    np.deg2rad(25.0), np.deg2rad(79.0), 0.01, (0.0, 55.0, -16.0), (1150.0, 1150.0), (479.5, 269.5)
)
LANDMARK_PLACES = {
    "Clock": (30.0, -44.0, -8.0),
    "Mast": (42.0, -42.0, -4.0),
    "Seat": (36.0, -38.0, -1.0),
}
SD_M = 2.0  # 20 px


def field_of(field: Field, off_m: np.ndarray, sd_m: float | None = SD_M) -> Field:
    """With landmarks whose places, as they are known, are off by (3, 3) metres."""
    square = None if sd_m is None else tuple(map(tuple, (np.eye(3) * sd_m**2).tolist()))
    known = np.array(list(LANDMARK_PLACES.values())) + off_m
    return with_landmarks(
        field,
        [
            Landmark(name, position=tuple(place), covariance=square)
            for name, place in zip(LANDMARK_PLACES, known.tolist(), strict=True)
        ],
    )


def landmark_clicks(field: Field, rng: np.random.Generator) -> FrameAnnotation:
    """What somebody clicks of the field and of the places where they are, to about a pixel."""
    found = []
    for name, pieces in project_field(CAMERA, EvaluationSetup(field, SIZE, "procc")).pieces.items():
        if (element := field.element(name)) is None or element.is_spot:
            continue
        piece = max(pieces, key=len)
        many = 7 if element.is_curved else 3
        points = piece[np.linspace(0, len(piece) - 1, many).round().astype(int)]
        if np.hypot(*np.ptp(points, axis=0)) > 40:
            found.append((name, points))
    shown, _ = CAMERA.project(np.array(list(LANDMARK_PLACES.values())))
    found += [(name, place[None]) for name, place in zip(LANDMARK_PLACES, shown, strict=True)]
    return FrameAnnotation(
        tuple(
            Polyline(name, tuple(point_from_px(*p, SIZE) for p in points))
            for name, noisy in found
            for points in [noisy + rng.normal(0, 1.0, noisy.shape)]
        )
    )


def check_fitted(annotation: FrameAnnotation, field: Field) -> list[Finding]:
    fit = fit_camera(annotation, field, size=SIZE)
    found = check_labels(annotation, field, size=SIZE, fit=fit)
    return [f for f in found if f.severity is not Severity.HINT]


def test_what_its_own_uncertainty_allows_is_no_mistake(field):
    rng = np.random.default_rng(0)
    for _ in range(8):
        off = rng.normal(0, SD_M, (3, 3))
        annotation = landmark_clicks(field, rng)
        assert check_fitted(annotation, field_of(field, off)) == []
    assert check_fitted(annotation, field_of(field, off, None))  # off what is said to be exact


def test_more_than_that_is_one(field):
    rng = np.random.default_rng(1)
    off = np.zeros((3, 3))
    off[0] = (20.0, 0.0, -10.0)
    (finding,) = check_fitted(landmark_clicks(field, rng), field_of(field, off))
    assert (finding.rule, finding.elements[0]) == (Rule.RESIDUAL, "Clock")
    assert "more than its own place is uncertain" in finding.reason
    places = np.array([LANDMARK_PLACES["Clock"], np.array(LANDMARK_PLACES["Clock"]) + off[0]])
    seen = CAMERA.project(places)[0]
    # What is told is what one sees, not what counts of it.
    assert finding.error_px == pytest.approx(float(np.hypot(*(seen[0] - seen[1]))), rel=0.05)
    assert f"up to {finding.error_px:.0f} px" in finding.reason


def test_two_that_are_swapped_are_found(field):
    rng = np.random.default_rng(2)
    off = rng.normal(0, 0.4, (3, 3))
    swapped = swap_classes(landmark_clicks(field, rng), "Clock", "Mast")
    (finding,) = check_fitted(swapped, field_of(field, off, 0.4))
    assert finding.rule is Rule.SWAPPED
    assert set(finding.elements) == {"Clock", "Mast"}
    assert finding.remedies[0].kind is RemedyKind.SWAP


def test_mistakes_elsewhere_are_found_beside_them(field):
    rng = np.random.default_rng(3)
    known = field_of(field, rng.normal(0, SD_M, (3, 3)))
    wrong = swap_classes(
        landmark_clicks(field, rng), "Big rect. right top", "Small rect. right top"
    )
    (finding,) = check_fitted(wrong, known)
    assert finding.rule is Rule.SWAPPED
    assert finding.severity is Severity.ERROR


@pytest.mark.parametrize(("along_px", "across_px", "told"), [(14.0, 0.0, False), (0.0, 14.0, True)])
def test_the_end_of_a_line_that_leads_into_another_may_lie_on_that_one(along_px, across_px, told):
    field, name = load_field("basketball_nba"), "3-points right top"
    annotation = clicks(field, camera_of(field, PLACES[1]))
    points = points_px(annotation.get(name), SIZE)
    points = points if points[0, 0] > points[-1, 0] else points[::-1]  # away from the baseline
    along = (points[-1] - points[0]) / np.hypot(*(points[-1] - points[0]))
    points[-1] += along_px * along + across_px * np.array([-along[1], along[0]])
    wrong = Polyline(name, tuple(point_from_px(x, y, SIZE) for x, y in points))
    found = check(annotation.with_polyline(wrong), field)
    assert any(name in f.elements for f in found) is told
