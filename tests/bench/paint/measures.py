"""What is counted of snapping, regularising and ghosts against the truth."""

import time
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import partial

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline, points_px
from procc_annotator.arrays import FloatArray
from procc_annotator.assist.ghost_points import accept_all, find_points
from procc_annotator.assist.line_evidence import ExpectedLines
from procc_annotator.assist.regularise import regularise
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.prediction.ghosts import find_ghosts
from procc_annotator.field.geometry import Arc, Circle, Line
from procc_annotator.field.model import BAR
from procc_annotator.image.line_snapping import snap_points_to_lines, snap_to_line
from procc_annotator.image.pixels import PixelArray
from tests.bench.paint.truth import Element, TruthFrame

Place = tuple[float, float]

OFFSET_PX = 4.0
RIGHT_PX, WRONG_PX = 1.0, 2.5
_HAND_PX = 0.7  # how far a hand clicks off the paint, either way
_LONGEST_CLICKS_PX = 140.0
_STAYED_PX = 0.5
_FARTHEST_PX = 4.0  # a ghost with a point so far off is wrong
_END_PX = 2.0
_FOUR = 4
_DRAWS = 6


@dataclass
class Snaps:
    """Of one sport and kind: px from the truth where a click was moved, and how many stayed."""

    away: list[float] = field(default_factory=list)
    stayed: int = 0
    seconds: list[float] = field(default_factory=list)

    def row(self) -> str:
        n = len(self.away) + self.stayed
        away = np.array(self.away)
        median = f"{np.median(away):.2f}" if len(away) else "-"
        right, wrong = (away <= RIGHT_PX).sum() / n, (away > WRONG_PX).sum() / n
        return f"{n} | {median} | {right:.1%} | {wrong:.1%} | {self.stayed / n:.1%}"


@dataclass
class Regular:
    """Of one sport: clicks that the regular elements no longer go through, px off the truth."""

    clicks: int = 0
    lost: int = 0
    lines: list[float] = field(default_factory=list)
    curves: list[float] = field(default_factory=list)
    seconds: list[float] = field(default_factory=list)


@dataclass
class Accepted:
    """Of one sport: ghosts accepted after four elements."""

    ghosts: int = 0
    wrong: list[str] = field(default_factory=list)
    interior: list[float] = field(default_factory=list)
    ends: list[float] = field(default_factory=list)


def camera_of(frame: TruthFrame) -> ExpectedLines:
    """What to look for, as after the whole frame was annotated."""
    fit = fit_camera(whole(frame), frame.field, size=frame.size)
    return ExpectedLines(frame.field, frame.size[0], fit.camera)


def whole(frame: TruthFrame) -> FrameAnnotation:
    """Every element of the field in the frame that is one line."""
    names = [e.name for e in frame.elements]
    return FrameAnnotation(
        tuple(
            frame.polyline(e.name, e.points)
            for e in frame.elements
            if names.count(e.name) == 1 and frame.field.element(e.name) is not None
        )
    )


def snapping(
    frame: TruthFrame, picture: PixelArray, paint: ExpectedLines, *, directed: bool
) -> dict[str, Snaps]:
    """Clicks 4 px to either side of the paint, by kind; and beside hidden paint and bare ground."""
    found: dict[str, Snaps] = defaultdict(Snaps)
    for e in frame.elements:
        names = [e.name] * len(e.points)
        _snap_beside(picture, paint, found[e.kind], names, e.points, e.along, directed)
    of, bare = frame.hidden, frame.bare
    _snap_beside(picture, paint, found["hidden"], of.names, of.points, of.along, directed)
    for name, (x, y), (dx, dy) in zip(bare.names, bare.points, bare.along, strict=True):
        place = _snapped(picture, paint, found["bare"], name, (x, y), (dx, dy), directed)
        if place is None or np.hypot(place[0] - x, place[1] - y) <= _STAYED_PX:
            found["bare"].stayed += 1
        else:  # wherever it went, there is nothing
            found["bare"].away.append(np.inf)
    return found


def _snap_beside(
    picture: PixelArray,
    paint: ExpectedLines,
    into: Snaps,
    names: Sequence[str],
    points: FloatArray,
    along: FloatArray,
    directed: bool,
) -> None:
    for name, (x, y), (dx, dy) in zip(names, points, along, strict=True):
        for side in (-OFFSET_PX, OFFSET_PX):
            click = x - side * dy, y + side * dx
            place = _snapped(picture, paint, into, name, click, (dx, dy), directed)
            if place is None or np.hypot(place[0] - click[0], place[1] - click[1]) <= _STAYED_PX:
                into.stayed += 1
            else:
                into.away.append(abs((place[1] - y) * dx - (place[0] - x) * dy))


def _snapped(
    picture: PixelArray,
    paint: ExpectedLines,
    into: Snaps,
    name: str,
    click: Place,
    direction: Place,
    directed: bool,
) -> Place | None:
    sought, shown = paint.at(name, click)
    began = time.thread_time()
    place = snap_to_line(picture, click, sought, direction=direction if directed else shown)
    into.seconds.append(time.thread_time() - began)
    return place


def clicks_on(element: Element, rng: np.random.Generator) -> FloatArray:
    """(n, 2) px as a hand clicks an element: along it, some px off."""
    points = element.points
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    count = max(6 if _bends(element) else 2, int(lengths[-1] / _LONGEST_CLICKS_PX) + 1)
    rows = np.unique(np.linspace(0, len(points) - 1, min(count, len(points))).round().astype(int))
    return points[rows] + element.across[rows] * rng.normal(0, _HAND_PX, (len(rows), 1))


def _bends(element: Element) -> bool:
    return float((element.along @ element.along[0]).min()) < 0.97


def regular(frame: TruthFrame, picture: PixelArray, rng: np.random.Generator) -> Regular:
    """Every element clicked by a hand and regularised."""
    paint, found = ExpectedLines(frame.field, frame.size[0]), Regular()
    for e in frame.elements:
        known = frame.field.element(e.name)
        if known is None or not isinstance(known.geometry, Line | Arc | Circle):
            continue
        clicks = clicks_on(e, rng)
        before = frame.polyline(e.name, clicks)
        began = time.thread_time()
        after = regularised(before, frame, picture, paint)
        found.seconds.append(time.thread_time() - began)
        course = _dense(points_px(after, frame.size))
        found.clicks += len(clicks)
        found.lost += int((_nearest(clicks, course) > WRONG_PX).sum())
        (found.curves if known.is_curved else found.lines).extend(_nearest(e.points, course))
    return found


def regularised(
    polyline: Polyline, frame: TruthFrame, picture: PixelArray, paint: ExpectedLines
) -> Polyline:
    known = frame.field.element(polyline.class_name)
    sought = paint.of(polyline.class_name)
    snapped = partial(snap_points_to_lines, picture, sought=sought)
    curved, bar = known is not None and known.is_curved, sought.looks.kind == BAR
    return regularise(polyline, curved=curved, size=frame.size, snap=snapped, bar=bar).polyline


def accepted(frame: TruthFrame, picture: PixelArray, rng: np.random.Generator) -> Accepted:
    """Four elements clicked, all ghosts accepted; several draws."""
    found, by_name = Accepted(), {e.name: e for e in frame.elements}
    names = [p.class_name for p in whole(frame).polylines]
    on_ground = [n for n in names if frame.field.element(n).on_ground and by_name[n].kind != "edge"]
    for _ in range(_DRAWS if len(on_ground) >= _FOUR else 0):
        chosen = rng.permutation(on_ground)[:_FOUR].tolist()
        given = FrameAnnotation(
            tuple(frame.polyline(n, clicks_on(by_name[n], rng)) for n in chosen)
        )
        fit = fit_camera(given, frame.field, size=frame.size)
        ghosts = find_ghosts(given, frame.field, fit)
        points = [find_points(g, picture, frame.field, frame.size) for g in ghosts]
        for ghost in accept_all(given, points).accepted:
            if ghost.name in by_name and ghost.name in names:
                course = points_px(Polyline(ghost.name, ghost.points), frame.size)
                _judge(found, by_name[ghost.name], course, f"{frame.clip} {frame.number}")
    return found


def _judge(found: Accepted, element: Element, points: FloatArray, where: str) -> None:
    away = element.away(points)
    away = away[~np.isnan(away)]
    found.ghosts += 1
    found.interior.extend(away)
    for end in element.ends:
        apart = np.hypot(*(points[[0, -1]] - end).T).min()
        # An end in sight that was not reached, or an element that goes on beyond it.
        found.ends.append(float(apart))
    if len(away) and away.max() > _FARTHEST_PX:
        found.wrong.append(f"{where} {element.name}: {away.max():.1f} px")


def _dense(points: FloatArray) -> FloatArray:
    if len(points) < 2:
        return points
    lengths = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    at = np.linspace(0.0, lengths[-1], 2 + int(2 * lengths[-1]))
    return np.column_stack([np.interp(at, lengths, points[:, k]) for k in (0, 1)])


def _nearest(places: FloatArray, course: FloatArray) -> FloatArray:
    return np.array([np.hypot(*(course - place).T).min() for place in places])
