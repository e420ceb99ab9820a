"""Agreement of two annotators, without a camera."""

from __future__ import annotations

from array import array
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from dataclasses import field as dataclass_field
from functools import cached_property

import numpy as np

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.arrays import FloatArray
from procc_annotator.field.model import Field
from procc_annotator.metrics.clicked_curve import ClickedCurve, clicked_curve

# The shorter course is walked in this many steps.
_OVERLAP_SAMPLES = 100


def curve_overlap(
    a: ClickedCurve, clicks_a: FloatArray, b: ClickedCurve, clicks_b: FloatArray
) -> float:
    """Share of the shorter course's length that runs along the longer one: 0 (at most a place in
    common) to 1 (the shorter lies all along the longer). Neither is a single place; clicks are
    (n, 2) and (m, 2) px.

    A part runs along as far as its feet on the other advance: a line across another one, or away
    from its end, hardly does, however near it is. Only what is between clicks counts, not the
    reach beyond them.
    """
    (own, first, last), (other, low, high) = sorted(
        ((a, *clicked_extent(a, clicks_a)), (b, *clicked_extent(b, clicks_b))),
        key=lambda c: c[2] - c[1],
    )
    if not last > first:
        return 0.0
    at = _arc_lengths_of(own)
    walked = np.linspace(first, last, _OVERLAP_SAMPLES + 1)
    places = np.column_stack([np.interp(walked, at, own.vertices[:, axis]) for axis in (0, 1)])
    at_other = np.clip(closest_arc_lengths(other, places), low, high)
    advance = np.abs(np.diff(at_other))
    if other.closed:  # past the first vertex they begin anew
        advance = np.minimum(advance, high - low - advance)
    # A foot that jumps to another branch goes no further along than the walk itself.
    advance = np.minimum(advance, (last - first) / _OVERLAP_SAMPLES)
    beside = ~np.isnan(other.distances(places))
    return float(advance[beside[1:] & beside[:-1]].sum() / (last - first))


def clicked_extent(trace: ClickedCurve, clicks: FloatArray) -> tuple[float, float]:
    """Return where along a course its first and its last click lie, px from its first vertex."""
    if trace.closed:
        return 0.0, float(_arc_lengths_of(trace)[-1])
    at = closest_arc_lengths(trace, clicks)
    return float(at.min()), float(at.max())


def _arc_lengths_of(trace: ClickedCurve) -> FloatArray:
    """(M,) px along the course to each vertex."""
    return np.concatenate(((0.0,), np.hypot(*np.diff(trace.vertices, axis=0).T).cumsum()))


def closest_arc_lengths(trace: ClickedCurve, points: FloatArray) -> FloatArray:
    """(n,) px along the course to its nearest position to each of (n, 2) points."""
    # Coordinate by coordinate: three times as fast as vectors.
    x, y = trace.vertices.T
    along_x, along_y = np.diff(x), np.diff(y)
    off_x, off_y = points[:, :1] - x[:-1], points[:, 1:] - y[:-1]
    share = (off_x * along_x + off_y * along_y) / (along_x * along_x + along_y * along_y)
    share = np.clip(share, 0.0, 1.0)
    off_x -= share * along_x
    off_y -= share * along_y
    nearest = (off_x * off_x + off_y * off_y).argmin(axis=1)
    at = _arc_lengths_of(trace)
    part = share[np.arange(len(points)), nearest]
    return np.asarray(at[nearest] + part * (at[nearest + 1] - at[nearest]), dtype=np.float64)


# Labels seem to be mirrored where turning them gains this much JaC at a threshold so wide that
# clicking does not decide: a hundredth of the picture's width.
_MIRROR_MIN_GAIN = 0.25
_MIRROR_THRESHOLD_SHARE = 0.01

# Two neighbours that meet in a corner share what clicking there is unsure about, a few pixels; two
# who saw a line's opposite ends and both its middle fifth share a third of what each has.
MIN_OVERLAP = 0.1


@dataclass(frozen=True, eq=False)
class ClassAgreement:
    """One element that both annotated.

    Attributes:
        distances: (n,) px: the clicks of the first against the second's course, then the reverse;
            without those beyond the other's ends; none if apart.
        left_out: how many clicks were beyond; all of them if apart.
    """

    class_name: str
    distances: FloatArray
    left_out: int = 0

    @property
    def apart(self) -> bool:
        """Return whether the two polylines have (almost) no stretch in common."""
        return not len(self.distances)

    @property
    def median(self) -> float | None:
        """Median distance, px; None if apart."""
        return sorted_quantile(self._ascending, 0.5)

    @property
    def p95(self) -> float | None:
        """95 % of the distances are no larger, px; None if apart."""
        return sorted_quantile(self._ascending, 0.95)

    @property
    def largest(self) -> float | None:
        """Largest distance, px; None if apart."""
        return sorted_quantile(self._ascending, 1.0)

    def agrees(self, tau: float) -> bool:
        """Return whether all distances are below tau, px; never if apart."""
        return self.largest is not None and self.largest < tau

    @cached_property
    def _ascending(self) -> FloatArray:
        return np.sort(self.distances)


@dataclass(frozen=True, eq=False)
class FrameAgreement:
    """Two annotations of one frame.

    Attributes:
        by_class: the elements both annotated, in the order of the first.
        only_a, only_b: those that only the first, only the second annotated.
        mirrored_hint: whether they agree much better when the second's labels are those of the
            turned field, i.e. one of the two took left for right. Nothing is corrected.
    """

    by_class: Mapping[str, ClassAgreement]
    only_a: tuple[str, ...]
    only_b: tuple[str, ...]
    mirrored_hint: bool = False

    @property
    def element_count(self) -> int:
        """Elements that any of the two annotated."""
        return len(self.by_class) + len(self.only_a) + len(self.only_b)

    @cached_property
    def distances(self) -> FloatArray:
        """(n,) px, of all elements, in their order."""
        found = [c.distances for c in self.by_class.values()]
        return np.concatenate(found) if found else np.empty(0)

    def agreeing(self, tau: float) -> int:
        """Number of elements whose distances are all below tau, px."""
        return sum(c.agrees(tau) for c in self.by_class.values())

    def jac(self, tau: float) -> float:
        """Elements that agree within tau (px) / elements that any of the two annotated.

        What one annotator would score if the other were a camera without any error; 0 when neither
        annotated anything, as for a camera.
        """
        return self.agreeing(tau) / self.element_count if self.element_count else 0.0


@dataclass(frozen=True, eq=False)
class AnnotatedCurve:
    """One element as a person clicked it: (n, 2) px, and the course through them."""

    points: FloatArray
    trace: ClickedCurve

    @cached_property
    def extent(self) -> tuple[float, float]:
        """Return where along the course the first and the last click lie, px from its first
        vertex."""
        return clicked_extent(self.trace, self.points)


def compare_annotations(
    a: FrameAnnotation, b: FrameAnnotation, field: Field, size: tuple[int, int]
) -> FrameAgreement:
    """Compare two annotations of one frame.

    Classes without geometry (``Line unknown``) name no element and do not count. A click beyond the
    end of the other's course (5 % of its length, at least 3 px) is left out. Where both have such
    clicks and less than a tenth of the shorter course runs along the other, the element is apart
    and all its clicks are left out. A polyline of a single place has no course: only its own
    distance to the other's counts; two such are compared directly. A curve of fewer than five
    clicks is no measure for one that has more, only measured by it. On straight elements the chords
    count as they were clicked, bent by a lens or not.

    Args:
        a, b: the annotations; exchanging them exchanges ``only_a`` and ``only_b`` and the order of
            the distances.
        size: (width, height) in px of the picture in which distances are taken.
    """
    first, second = annotated_curves(a, field, size), annotated_curves(b, field, size)
    plain = _compare_frames(first, second)
    tau = _MIRROR_THRESHOLD_SHARE * size[0]
    to_beat = plain.jac(tau) + _MIRROR_MIN_GAIN
    if to_beat > 1.0 or not (first and second):
        return plain
    turned = (
        _compare_frames(first, {turn.name_of(name): clicked for name, clicked in second.items()})
        for turn in field.symmetries
    )
    return replace(plain, mirrored_hint=any(found.jac(tau) >= to_beat for found in turned))


def annotated_curves(
    annotation: FrameAnnotation, field: Field, size: tuple[int, int]
) -> dict[str, AnnotatedCurve]:
    """The courses of the elements that the field knows, by class name; size as (width, height)."""
    found = {}
    for polyline in annotation:
        element = field.element(polyline.class_name)
        if element is not None and polyline.points:
            points = points_px(polyline, size)
            found[polyline.class_name] = AnnotatedCurve(points, clicked_curve(points, element))
    return found


def _compare_frames(
    a: Mapping[str, AnnotatedCurve], b: Mapping[str, AnnotatedCurve]
) -> FrameAgreement:
    return FrameAgreement(
        {name: _compare_class(name, a[name], b[name]) for name in a if name in b},
        tuple(name for name in a if name not in b),
        tuple(name for name in b if name not in a),
    )


def _compare_class(name: str, a: AnnotatedCurve, b: AnnotatedCurve) -> ClassAgreement:
    of_a, of_b = b.trace.distances(a.points), a.trace.distances(b.points)
    # Anyone who says less of the course is measured by the other, not the reverse.
    per_element = [
        *((of_a,) if b.trace.rank >= a.trace.rank else ()),
        *((of_b,) if a.trace.rank >= b.trace.rank else ()),
    ]
    measured = np.concatenate(per_element)
    # Where all clicks of one are next to the other, their distances say what there is to say.
    both_go_beyond = bool(np.isnan(of_a).any() and np.isnan(of_b).any())
    if both_go_beyond and curve_overlap(a.trace, a.points, b.trace, b.points) < MIN_OVERLAP:
        return ClassAgreement(name, np.empty(0), len(measured))
    known = measured[~np.isnan(measured)]
    return ClassAgreement(name, known, len(measured) - len(known))


# ------------------------------------------------------------------------------------------ sets


@dataclass(frozen=True, slots=True)
class AgreementMetrics:
    """One class, or all of them, over a set; distances in px, None where there are none.

    Attributes:
        common: elements both annotated. apart: those of them that share (almost) no stretch.
        only_a, only_b: elements only one annotated, in frames that both annotated.
        points: distances taken.
        left_out: clicks beyond the other's ends, and all clicks of elements apart.
        median, p95, largest: of all those distances together.
    """

    common: int
    apart: int
    only_a: int
    only_b: int
    points: int
    left_out: int
    median: float | None
    p95: float | None
    largest: float | None


@dataclass(frozen=True, slots=True)
class AgreementSummary:
    """Two annotators over a set.

    Attributes:
        frames: frames compared. frames_only_a, frames_only_b: names of those only one annotated.
        mirrored: names of the frames that agree much better with the second's labels turned.
        overall: all classes together; its median and 95 % are the noise floor.
        per_class: by class name, in alphabetical order.
        mean_jac: tau -> mean over the frames in which anything is annotated; None without any.
    """

    frames: int
    frames_only_a: tuple[str, ...]
    frames_only_b: tuple[str, ...]
    mirrored: tuple[str, ...]
    overall: AgreementMetrics
    per_class: Mapping[str, AgreementMetrics]
    mean_jac: Mapping[float, float | None]


@dataclass(slots=True)
class _ClassSums:
    distances: array[float] = dataclass_field(default_factory=lambda: array("d"))
    common: int = 0
    apart: int = 0
    only_a: int = 0
    only_b: int = 0
    left_out: int = 0

    def figures(self) -> AgreementMetrics:
        ascending = np.sort(np.array(self.distances))
        return AgreementMetrics(
            self.common,
            self.apart,
            self.only_a,
            self.only_b,
            len(ascending),
            self.left_out,
            *(sorted_quantile(ascending, share) for share in (0.5, 0.95, 1.0)),
        )


class AgreementAccumulator:
    """Gathers the frames of a set, with the JaC at thresholds (px); of a frame it keeps the
    distances only. ``only_a``, ``only_b``: names of the frames that only one annotated."""

    def __init__(
        self,
        thresholds: Sequence[float],
        only_a: Sequence[str] = (),
        only_b: Sequence[str] = (),
    ) -> None:
        self._jacs = {float(tau): array("d") for tau in thresholds}
        self._only_a, self._only_b = tuple(only_a), tuple(only_b)
        self._mirrored: list[str] = []
        self._frames = 0
        self._classes: defaultdict[str, _ClassSums] = defaultdict(_ClassSums)

    def add(self, name: str, frame: FrameAgreement) -> None:
        """Add a frame that both annotated."""
        self._frames += 1
        if frame.mirrored_hint:
            self._mirrored.append(name)
        if frame.element_count:
            for tau, jacs in self._jacs.items():
                jacs.append(frame.jac(tau))
        for class_name, found in frame.by_class.items():
            sums = self._classes[class_name]
            sums.common += 1
            sums.apart += found.apart
            sums.left_out += found.left_out
            sums.distances.frombytes(found.distances.tobytes())
        for class_name in frame.only_a:
            self._classes[class_name].only_a += 1
        for class_name in frame.only_b:
            self._classes[class_name].only_b += 1

    def summary(self) -> AgreementSummary:
        """The figures of the frames added so far."""
        overall = _ClassSums()
        for sums in self._classes.values():
            overall.distances.extend(sums.distances)
            overall.common += sums.common
            overall.apart += sums.apart
            overall.only_a += sums.only_a
            overall.only_b += sums.only_b
            overall.left_out += sums.left_out
        return AgreementSummary(
            self._frames,
            self._only_a,
            self._only_b,
            tuple(self._mirrored),
            overall.figures(),
            {name: self._classes[name].figures() for name in sorted(self._classes)},
            {tau: sum(jacs) / len(jacs) if jacs else None for tau, jacs in self._jacs.items()},
        )


def sorted_quantile(ascending: FloatArray, share: float) -> float | None:
    """The value below which a share of the (n,) sorted values lies, linear between two; or None."""
    if not len(ascending):
        return None
    position = share * (len(ascending) - 1)
    below = int(position)
    above = min(below + 1, len(ascending) - 1)
    low, high = float(ascending[below]), float(ascending[above])
    return low + (position - below) * (high - low)
