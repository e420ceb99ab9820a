"""Track all frames of a shot from anchors and proposals, forwards and backwards."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from dataclasses import field as dataclass_field
from itertools import pairwise
from typing import cast

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.line_alignment.expected_lines import MarkingPoints, marking_points
from procc_annotator.calibration.line_alignment.gaussian_state import (
    GaussianState,
    fit_from_covariance,
)
from procc_annotator.calibration.line_alignment.refinement import displaced_elements_text
from procc_annotator.calibration.optimization.camera_parameters import POSITION_SLICE, X, Z
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.field_points import field_line_points
from procc_annotator.calibration.single_image.icp_refinement import (
    AGREEMENT_POINTS,
    ImageLinePixels,
    explained_on_field,
    line_pixels_for_field,
)
from procc_annotator.calibration.single_image.pixel_aspect import (
    SQUARE_PIXELS,
    fit_in_picture,
    stretched_size,
    with_square_pixels,
)
from procc_annotator.calibration.single_image.probability import SURE_FROM
from procc_annotator.calibration.single_image.proposal import SURE, KnownPosition, Proposal
from procc_annotator.calibration.single_image.propose import (
    ASPECT_PICTURES,
    estimate_pixel_aspect,
    propose_camera,
)
from procc_annotator.calibration.tracking.filter_step import (
    FilterStep,
    nearest_pinhole_vector,
    projection_difference_px,
    remeasured_step,
    state_from_camera,
    unexplained_beside,
)
from procc_annotator.calibration.tracking.forward_pass import (
    FrameChain,
    TrackedRun,
    build_chain,
    neighbour_vector,
    track_run,
)
from procc_annotator.calibration.tracking.frame_reader import ReadFrame, decoded_frames
from procc_annotator.calibration.tracking.motion_model import (
    MOVING_NOISE,
    TRIPOD_NOISE,
    ProcessNoise,
)
from procc_annotator.calibration.tracking.smoother import (
    GIVEN_REACHED_PX,
    SmoothedChain,
    smooth_chain,
)
from procc_annotator.calibration.tracking.track import (
    MIN_COVERAGE,
    FrameState,
    Track,
    TrackedFrame,
)
from procc_annotator.camera.base import Camera, scaled_camera
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.translation import translatable

# Shots of one match agree on the tripod to about a metre; standard deviation of each axis.
_MIN_SEPARATION_M = 0.7
_MAX_MAHALANOBIS, _MAX_DISTANCE_M = 3.5, 5.0


def is_at_known_position(
    fit: FitResult | None, coverages: Sequence[float], places: Sequence[KnownPosition]
) -> bool:
    """Return whether what all frames of a shot show of their camera (the fit of one of them, solved
    with all the others) is a place that is known, and its lines are on their paint (coverages, 0 to
    1)."""
    if fit is None or fit.vector is None or fit.covariance is None:
        return False
    if np.mean(coverages) < MIN_COVERAGE:
        return False
    for place in places:
        away = fit.vector[POSITION_SLICE] - place.position_m
        spread = (
            fit.covariance[POSITION_SLICE, POSITION_SLICE]
            + place.covariance
            + np.eye(3) * _MIN_SEPARATION_M**2
        )
        in_sd = float(np.sqrt(away @ np.linalg.solve(spread, away)))
        if in_sd <= _MAX_MAHALANOBIS and np.linalg.norm(away) <= _MAX_DISTANCE_M:
            return True
    return False


CameraProposer = Callable[[np.ndarray, Field, Sequence[KnownPosition]], Proposal]

# Frames after the first of a shot, or after one that was lost, at which a camera is proposed.
_PROPOSAL_OFFSETS = (*range(0, 200, 20), *range(200, 1000, 50), *range(1000, 20000, 250))

# Circle, halfway line and touchline suit cameras near and far, zoomed accordingly: a sure camera
# stood 15 m off (with lines known to 1 px its standard deviation is 5.7 m), and lines that came
# into sight were missed. Where a position is known worse than this, more cameras are proposed, so
# many frames apart: another view is needed, and a proposal takes as long as following 30 frames.
_MAX_POSITION_SD_M, _POSITION_TRIES, _TRIED_FRAMES = 3.0, 5, 40
# For a missed line the whole picture is searched once a second: it takes as long as ten frames do.
# For the share of its line pixels that a doubtful frame explains, twice a second.
_LOOKED_FRAMES, _EXPLAINED_FRAMES = 25, 12
# When a camera that moves is tried: elements lie so far next to the model, solver px, or less of
# the frames asked for is explained, or less of the model is found on paint than in the best frames:
# where a position is held that is not, lines are left behind one by one.
_MOVING_DISPLACEMENT_PX, _MOVING_HELD_SHARE, _MOVING_FOUND_SHARE = 0.7, 0.96, 0.8
# Edge points are measured again around smoothed cameras, so far off at first; then around those
# that moved by more, solver px. The second round moved 0 and 0.8 % of the elements of two shots to
# within 2 px.
_ASSOCIATION_RADII_PX, _SAME_VIEW_PX = (10.0, 5.0), 0.5
# Where a position is held that is not, the line pixels of some pictures are explained less, of the
# best one's 0.86 on a drawn rail of 5 m.
_MOVING_EXPLAINED_SHARE = 0.9
# Two standard errors of a share of 800 line pixels, of which 90 % are explained.
_EXPLAINED_ERROR = 0.02
# Whole pictures are judged once in two seconds, for that takes as long as several frames; in short
# shots more often.
_JUDGED_FRAMES, _LEAST_JUDGED = 50, 4
# What it may leave of what a tripod does not find: a field that is not as its file says is a little
# better explained by whatever is free, by the right camera nearly all of it.
_SKIPPED_SHARE = 0.5


def _unsure_pixels_text(field: Field) -> str:
    if field.pixels is None or field.pixels.probability >= SURE_FROM:
        return ""
    return translatable(
        "the pixels may not be {aspect:.3f} times as wide as high ({percent:.0f} %)",
        aspect=field.pixels.value,
        percent=100 * field.pixels.probability,
    )


def _is_recent(number: int, looked: tuple[int, float] | None, frames: int) -> bool:
    return looked is not None and number - looked[0] < frames


class _TooManyMissing(Exception):
    """The tracked work is outdated."""


def track_shot(
    frame: ReadFrame,
    numbers: range,
    field: Field,
    *,
    anchors: Mapping[int, Camera] | None = None,
    known: Sequence[KnownPosition] = (),
    propose: CameraProposer | None = None,
    on_frame: Callable[[TrackedFrame], None] = lambda _: None,
    go_on: Callable[[], None] = lambda: None,
) -> Track:
    """The camera of every frame that can be followed from a known one, or that is found.

    What is between two anchors is followed from them alone: when an anchor changes, only what
    lies between its neighbours has to be followed again.

    Args:
        frame: number -> (H, W, 4) BGRA; is called by another thread, one call at a time.
        numbers: the frames, consecutive.
        field: the elements, taken for the middle of their paint, see `marking_points`; pictures
            whose pixels are not square are stretched, cameras are in px of those as they are.
        anchors: cameras that are known, px of the pictures; those outside ``numbers`` do not count.
        known: where cameras of other shots of the same source stand. One that is not given is
            looked for there only, and counts if its own shot then shows that place.
        propose: finds a camera where none is known; None for `propose_camera`.
        on_frame: called for each frame as soon as it was followed, in the order in which they are;
            what is returned at the end is surer, and replaces it.
        go_on: called at least once a frame; what it raises ends everything.

    Raises:
        UsageError: an anchor is no camera of this field.
    """
    if not len(numbers):
        return Track((), ())
    height, width = frame(numbers[0]).shape[:2]
    size = width, height
    given = {n: c for n, c in sorted((anchors or {}).items()) if n in numbers}
    if field.pixels is None:
        some = numbers[:: max(len(numbers) // ASPECT_PICTURES, 1)]
        pixels = estimate_pixel_aspect(((frame(number), field) for number in some), go_on)
        field = replace(field, pixels=pixels or SQUARE_PIXELS)
    if field.pixel_aspect != 1:
        return _track_stretched(frame, numbers, field, given, known, propose, on_frame, go_on)
    work = _ShotTracker(
        frame,
        field,
        marking_points(field),
        ImageFrame(size),
        tuple(known),
        propose or _default_proposer,
        on_frame,
        go_on,
    )
    work.from_anchors(numbers, given)
    for gap in _untracked_runs(numbers, work.found):
        work.fill(gap)
    begins = sorted({numbers[0], *work.begins})
    ends = [n - 1 for n in begins[1:]] + [numbers[-1]]
    return Track(
        tuple(work.found[n] for n in sorted(work.found)), tuple(zip(begins, ends, strict=True))
    )


def _track_stretched(
    frame: ReadFrame,
    numbers: range,
    field: Field,
    anchors: Mapping[int, Camera],
    known: Sequence[KnownPosition],
    propose: CameraProposer | None,
    on_frame: Callable[[TrackedFrame], None],
    go_on: Callable[[], None],
) -> Track:
    """`track_shot` in pictures stretched until their pixels are square, in px of those as they
    are."""
    height, width = frame(numbers[0]).shape[:2]
    aspect, size = field.pixel_aspect, (width, height)
    square, unsure = stretched_size(size, aspect), _unsure_pixels_text(field)

    def in_picture(one: TrackedFrame) -> TrackedFrame:
        off = one.residual_px and one.residual_px * (height - 1) / (square[1] - 1)
        own = replace(one, fit=one.fit and fit_in_picture(one.fit, size), residual_px=off)
        if one.state == "anchor":
            return _anchor_frame(own, anchors[one.number])
        return replace(own, reason=own.reason or unsure)

    stretched = track_shot(
        lambda number: with_square_pixels(frame(number), aspect),
        numbers,
        replace(field, pixels=SQUARE_PIXELS),
        anchors={n: cast(Camera, scaled_camera(c, size, square)) for n, c in anchors.items()},
        known=known,
        propose=propose,
        on_frame=lambda one: on_frame(in_picture(one)),
        go_on=go_on,
    )
    return replace(stretched, frames=tuple(map(in_picture, stretched.frames)))


def _default_proposer(
    picture: np.ndarray, field: Field, known: Sequence[KnownPosition]
) -> Proposal:
    return propose_camera(picture, field, known=known, elsewhere=False)


def _untracked_runs(numbers: range, found: Mapping[int, TrackedFrame]) -> list[range]:
    """Runs of frames of which nothing is known yet."""
    missing = [n for n in numbers if n not in found]
    breaks = [i for i in range(1, len(missing)) if missing[i] != missing[i - 1] + 1]
    bounds = [0, *breaks, len(missing)]
    return [range(missing[a], missing[b - 1] + 1) for a, b in pairwise(bounds) if b > a]


@dataclass(eq=False)
class _ShotTracker:
    """State of tracking, with what has been found."""

    frame: ReadFrame
    field: Field
    painted: MarkingPoints
    picture: ImageFrame
    known: tuple[KnownPosition, ...]
    propose: CameraProposer
    on_frame: Callable[[TrackedFrame], None]
    go_on: Callable[[], None]
    found: dict[int, TrackedFrame] = dataclass_field(default_factory=dict)
    begins: set[int] = dataclass_field(default_factory=set)

    def from_anchors(self, numbers: range, anchors: Mapping[int, Camera]) -> None:
        """Follow what is around and between anchors."""
        vectors = {
            n: nearest_pinhole_vector(c, self.field, self.picture) for n, c in anchors.items()
        }
        given = {
            n: state_from_camera(vector, self.field, self.painted, self.picture)
            for n, vector in vectors.items()
        }
        places = list(given)
        if not places:
            return
        runs = [self._follow(range(places[0], numbers[0] - 1, -1), given)]
        for one, other in pairwise(places):
            forwards, backwards = self._between(one, other, given)
            runs.append(forwards)
            if backwards is not None:  # a cut, some are lost, or both ways disagree
                self._keep(runs, given)
                runs = [backwards]
        runs.append(self._follow(range(places[-1], numbers[-1] + 1), given))
        self._keep(runs, given)
        for number, camera in anchors.items():
            self.found[number] = _anchor_frame(self.found[number], camera)
            self.on_frame(self.found[number])

    def _between(
        self, one: int, other: int, given: Mapping[int, GaussianState]
    ) -> tuple[TrackedRun, TrackedRun | None]:
        """Follow what is between two anchors from the first one, and from the second one what
        cannot be followed from there."""
        near = {n: given[n] for n in (one, other)}
        forwards = self._follow(range(one, other + 1), near)
        last = forwards.numbers[-1]
        if last == other:
            arrived = forwards.steps[-1].belief.vector
            away = projection_difference_px(
                arrived, given[other].vector, self.painted, self.picture
            )
            if away <= GIVEN_REACHED_PX:
                return forwards, None
            last = (one + other) // 2
            forwards = forwards.until(last)
        return forwards, self._follow(range(other, last, -1), near)

    def _follow(
        self,
        numbers: Sequence[int],
        given: Mapping[int, GaussianState],
        stand: ProcessNoise = TRIPOD_NOISE,
        watch: Callable[[int, FilterStep], None] = lambda _, __: None,
    ) -> TrackedRun:
        """Follow frames from the first of them, whose camera was given; what ``watch`` raises ends
        it."""
        begin, places = numbers[0], np.array(list(given))

        def on_step(number: int, step: FilterStep) -> None:
            watch(number, step)
            if number not in given:
                distance = int(np.abs(places - number).min())
                self.on_frame(self._tracked(number, step, distance))

        followed = track_run(
            self.frame,
            numbers,
            given[begin],
            self.painted,
            self.picture,
            on_step,
            self.go_on,
            stand,
        )
        if followed.cut:
            ahead = len(numbers) < 2 or numbers[1] > begin
            self.begins.add(followed.numbers[-1] + (1 if ahead else 0))
        return followed

    def _keep(self, runs: Sequence[TrackedRun], given: Mapping[int, GaussianState]) -> None:
        """Smooth together what was followed, and keep it."""
        found = smooth_chain(build_chain(runs, given), self.field, self.picture)
        asked = len({number for run in runs for number in run.asked})
        if _camera_may_move(found, asked):
            start = _states_of_frames(found.chain, given)
            if len(found.chain.numbers) < asked:
                # Once more from what all frames showed of its place: lines that it lost on the way
                # stay.
                again = [self._follow(run.asked, start) for run in runs]
                second = smooth_chain(build_chain(again, given), self.field, self.picture)
                found = max(found, second, key=lambda one: one.explained)
            found, explained = self._associated_again(found)
            unequal = min(explained) < _MOVING_EXPLAINED_SHARE * max(explained)
            if unequal or _camera_may_move(found, asked):
                most = _SKIPPED_SHARE * _missing_share(found, asked)
                moving = self._moving(runs, given, start, most * asked)
                if moving is not None and _missing_share(moving, asked) < most:
                    found = moving
        chain = found.chain
        # All together they are worse where the camera is known.
        if self._skipped_frames(chain, given):
            chain = build_chain(runs, given)
        left = self._skipped_frames(chain, given)
        missed = self._missed_anchors(chain)
        places = np.array(list(given))
        looked = dict[int, tuple[int, float]]()
        judged: tuple[int, float] | None = None
        for number, step in zip(chain.numbers, chain.steps, strict=True):
            nearest = int(places[np.abs(places - number).argmin()])
            own = replace(step, belief=given[number]) if number in left else step
            one = self._tracked(number, own, abs(nearest - number))
            if not one.reason and nearest in missed:
                missed_anchor = translatable(
                    "the track is {px:.0f} px off the nearest frame whose camera was known",
                    px=missed[nearest] / self.picture.scale,
                )
                one = replace(one, reason=missed_anchor)
            if not one.reason and (off := self._unexplained(number, own, looked)):
                one = replace(one, reason=displaced_elements_text(off, self.painted, self.picture))
            if not one.reason and one.coverage < MIN_COVERAGE:
                if judged is None or not _is_recent(number, judged, _EXPLAINED_FRAMES):
                    judged = number, self._explained(number, own)
                one = replace(one, explained=judged[1])
            self.found[number] = one
        # What looked like a cut and could be followed across is none: a banner that slid in.
        self.begins -= set(chain.numbers[1:])

    def _associated_again(self, found: SmoothedChain) -> tuple[SmoothedChain, list[float]]:
        """Measure the edge points around the smoothed cameras and smooth again, unless that
        explains less of some whole pictures; and the shares that are explained of these, 0 to 1."""
        count, lines = len(found.chain.steps), field_line_points(self.field)
        every = min(max(count // _LEAST_JUDGED, 1), _JUDGED_FRAMES)
        seen = dict[int, ImageLinePixels]()
        before: list[FloatArray | None] = [None] * count

        def explained(chain: FrameChain) -> list[float]:
            return [
                explained_on_field(pixels, chain.steps[place].belief.vector, lines)
                for place, pixels in seen.items()
                if lines is not None
            ] or [0.0]

        for reach in _ASSOCIATION_RADII_PX:
            steps = list(found.chain.steps)
            for place, (number, step) in enumerate(zip(found.chain.numbers, steps, strict=True)):
                self.go_on()
                if self._is_same_view(before[place], step.belief.vector):
                    continue
                before[place] = step.belief.vector
                picture = self.frame(number)
                if place % every == 0 and place not in seen:
                    pixels = line_pixels_for_field(picture, self.field)
                    seen[place] = pixels.thinned(AGREEMENT_POINTS)
                steps[place] = remeasured_step(picture, step, self.painted, self.picture, reach)
            again = smooth_chain(replace(found.chain, steps=steps), self.field, self.picture)
            less = np.mean(explained(found.chain)) - np.mean(explained(again.chain))
            if less > _EXPLAINED_ERROR:
                break
            found = again
        return found, explained(found.chain)

    def _is_same_view(self, one: FloatArray | None, other: FloatArray) -> bool:
        if one is None:
            return False
        away = projection_difference_px(one, other, self.painted, self.picture)
        return away <= _SAME_VIEW_PX

    def _unexplained(
        self, number: int, step: FilterStep, looked: dict[int, tuple[int, float]]
    ) -> dict[int, float]:
        """Return the elements that a frame's camera misses and whose line lies elsewhere: solver px
        by which. The whole picture is examined once in `_LOOKED_FRAMES` only; ``looked`` keeps at
        which frame it was for each element, and the result, 0 if nothing."""
        missed = step.missed(self.painted, self.picture)
        now = [
            own
            for own in missed.tolist()
            if not _is_recent(number, looked.get(own), _LOOKED_FRAMES)
        ]
        if now:
            self.go_on()
            seen = line_pixels_for_field(self.frame(number), self.field)
            found = unexplained_beside(seen, step.belief.vector, missed, self.painted, self.picture)
            looked |= {own: (number, found.get(own, 0.0)) for own in missed.tolist()}
        return {own: looked[own][1] for own in missed.tolist() if looked[own][1]}

    def _explained(self, number: int, step: FilterStep) -> float:
        """Return the share of the line pixels on the field that a frame's camera explains."""
        self.go_on()
        lines = field_line_points(self.field)
        seen = line_pixels_for_field(self.frame(number), self.field).thinned(AGREEMENT_POINTS)
        return 0.0 if lines is None else explained_on_field(seen, step.belief.vector, lines)

    def _skipped_frames(self, chain: FrameChain, given: Mapping[int, GaussianState]) -> set[int]:
        """Frames whose known camera shows an element on its paint, and that of the chain does
        not."""
        left = set()
        for number, step in zip(chain.numbers, chain.steps, strict=True):
            if number in given:
                known = step.beside(given[number].vector, self.picture)
                beside = step.beside(step.belief.vector, self.picture)
                if any(px > GIVEN_REACHED_PX and own not in known for own, px in beside.items()):
                    left.add(number)
        return left

    def _missed_anchors(self, chain: FrameChain) -> dict[int, float]:
        """Frames whose known camera is not where the frames next to it lead -> solver px between
        them."""
        off = {}
        for place, known in chain.given.items():
            around = [neighbour_vector(chain, place, way) for way in (-1, 1)]
            off[chain.numbers[place]] = min(
                (
                    projection_difference_px(known.vector, other, self.painted, self.picture)
                    for other in around
                    if other is not None
                ),
                default=0.0,
            )
        return {number: px for number, px in off.items() if px > GIVEN_REACHED_PX}

    def _moving(
        self,
        runs: Sequence[TrackedRun],
        given: Mapping[int, GaussianState],
        start: Mapping[int, GaussianState],
        most_missing: float,
    ) -> SmoothedChain | None:
        """The same runs with a camera that moves; None as soon as more of the model is missing than
        may be, in frames' worth: solved all together, frames find no more than when followed."""
        found = dict[int, float]()

        def watch(number: int, step: FilterStep) -> None:
            found[number] = max(found.get(number, 0.0), step.coverage)
            if len(found) - sum(found.values()) > most_missing:
                raise _TooManyMissing

        try:
            again = [self._follow(run.asked, start, MOVING_NOISE, watch) for run in runs]
        except _TooManyMissing:
            return None
        return smooth_chain(build_chain(again, given), self.field, self.picture, MOVING_NOISE)

    def _tracked(self, number: int, step: FilterStep, distance: int) -> TrackedFrame:
        return tracked_frame(number, step, distance, self.painted, self.picture)

    def fill(self, gap: range) -> None:
        """Find cameras in a run of frames of which nothing is known, and follow them."""
        begin = gap[0]
        while begin <= gap[-1]:
            at, found, probability = self._find_start(begin, gap[-1])
            if found is None:
                return
            start = {at: found}
            back = self._follow(range(at, begin - 1, -1), start)
            onwards = self._follow(range(at, gap[-1] + 1), start)
            # All its paint is measured once more by following: it must not count twice.
            given = {at: state_from_camera(found.vector, self.field, self.painted, self.picture)}
            self._keep([back, onwards], given)
            self.found[at] = replace(self.found[at], probability=probability)
            if self.known:
                self._reject_other_positions(at, {*back.numbers, *onwards.numbers})
            for number in range(begin, at):
                if number not in self.found:
                    self._lose(number, "no camera was found yet")
            begin = onwards.numbers[-1] + 1

    def _find_start(self, begin: int, end: int) -> tuple[int, GaussianState | None, float]:
        """The first frame for which a camera is proposed, sure, and determined in its position, its
        state and probability; else of some sure ones the one whose position is known best."""
        since, reason = begin, ""
        least, tries, tried = np.inf, 0, begin
        best: tuple[int, GaussianState, float] | None = None
        known = self._position_near(begin) or self.known
        for now in decoded_frames(self.frame, range(begin, end + 1)):
            self.go_on()
            if best is not None and (now.begins or tries == _POSITION_TRIES):
                return best
            if now.begins:
                since, known = now.number, self.known
                self.begins.add(now.number)
            is_view_new = best is None or now.number - tried >= _TRIED_FRAMES
            if is_view_new and now.number - since in _PROPOSAL_OFFSETS:
                tried = now.number
                proposal = self.propose(now.picture, self.field, known)
                reason = proposal.reason
                tries += best is not None
                if proposal.state == SURE and (vector := proposal.fit.vector) is not None:
                    wide = state_from_camera(vector, self.field, self.painted, self.picture)
                    sd = float(np.sqrt(np.diag(wide.covariance)[X : Z + 1].max()))
                    if sd <= _MAX_POSITION_SD_M or known:
                        found = self._state_from_proposal(vector, proposal.fit)
                        return now.number, found, proposal.probability
                    if sd < least:
                        least, best = sd, (now.number, wide, proposal.probability)
            if now.number not in self.found:
                self._lose(now.number, reason)
        return best or (end, None, 0.0)

    def _state_from_proposal(self, vector: FloatArray, fit: FitResult) -> GaussianState:
        """Return what is believed of a proposed camera (11,): what the paint of its picture
        reported, if its fit says how much that is."""
        if fit.covariance is None:
            return state_from_camera(vector, self.field, self.painted, self.picture)
        return GaussianState(vector, np.asarray(np.linalg.inv(fit.covariance)))

    def _position_near(self, number: int) -> tuple[KnownPosition, ...]:
        """Return where the camera of the frame before stood, if it is of the same shot."""
        before = self.found.get(number - 1)
        if number in self.begins or before is None or before.fit is None:
            return ()
        fit = before.fit
        if fit.vector is None or fit.covariance is None:
            return ()
        place = slice(X, Z + 1)
        return (KnownPosition(fit.vector[place], fit.covariance[place, place]),)

    def _reject_other_positions(self, at: int, numbers: Iterable[int]) -> None:
        """Give back cameras of a run of frames that do not stand where any is known to."""
        run = sorted(numbers)
        coverages = [self.found[number].coverage for number in run]
        if not is_at_known_position(self.found[at].fit, coverages, self.known):
            for number in run:
                self._lose(number, "its camera does not stand where those of other shots do")

    def _lose(self, number: int, reason: str) -> None:
        self.found[number] = TrackedFrame(number, "lost", reason, None, 0.0, None, None)
        self.on_frame(self.found[number])


def _states_of_frames(chain: FrameChain, numbers: Iterable[int]) -> dict[int, GaussianState]:
    """Return what is believed of the cameras of those frames that a chain has got to."""
    places = {number: place for place, number in enumerate(chain.numbers)}
    return {number: chain.steps[places[number]].belief for number in numbers if number in places}


def _camera_may_move(still: SmoothedChain, asked: int) -> bool:
    """Return whether one position leaves so much open that a camera that moves has to be tried."""
    found = still.coverages
    return (
        still.beside_px > _MOVING_DISPLACEMENT_PX
        or still.explained < _MOVING_HELD_SHARE * asked
        or float(found.mean()) < _MOVING_FOUND_SHARE * float(np.percentile(found, 95))
    )


def _missing_share(found: SmoothedChain, asked: int) -> float:
    """The share of the visible model that was not found on paint, of all frames asked for; all of
    it in those that were not followed."""
    return 1 - float(found.coverages.sum()) / asked


def tracked_frame(
    number: int, step: FilterStep, distance: int, painted: MarkingPoints, frame: ImageFrame
) -> TrackedFrame:
    """A frame as it is returned."""
    belief = step.belief
    fit = fit_from_covariance(belief.vector, belief.covariance, frame, step.worth.error_px)
    residual = None if step.residual_px is None else step.residual_px / frame.scale
    state: FrameState = "bridged" if step.marks is None else "followed"
    reason = step.reason or displaced_elements_text(
        step.beside(belief.vector, frame), painted, frame
    )
    return TrackedFrame(number, state, reason, fit, step.coverage, residual, distance)


def _anchor_frame(found: TrackedFrame, camera: Camera) -> TrackedFrame:
    """A frame whose camera was given keeps it to the digit."""
    fit: FitResult | None = found.fit
    if fit is not None and isinstance(camera, PinholeCamera):
        fit = replace(fit, camera=camera)
    return replace(found, state="anchor", reason="", fit=fit, anchor_distance=0)
