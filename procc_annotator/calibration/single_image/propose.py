"""Propose a camera from one image, and classify the proposal as sure, unsure or none."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace

from procc_annotator.calibration.optimization.camera_parameters import (
    POSITION_SLICE,
    camera_from_vector,
)
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.single_image.candidates import BestCandidate, best_candidate
from procc_annotator.calibration.single_image.field_points import (
    field_line_points,
)
from procc_annotator.calibration.single_image.icp_refinement import (
    line_pixels_for_field,
)
from procc_annotator.calibration.single_image.pixel_aspect import (
    SQUARE_PIXELS,
    AspectSample,
    fit_in_picture,
    most_probable_aspect,
    possible_pixel_aspects,
    with_square_pixels,
)
from procc_annotator.calibration.single_image.probability import (
    POSSIBLE_FROM,
    SURE_FROM,
    ProposalEvidence,
    main_doubt,
    probability_right,
)
from procc_annotator.calibration.single_image.proposal import (
    NONE,
    SURE,
    UNSURE,
    KnownPosition,
    Proposal,
    ProposalState,
)
from procc_annotator.field.model import Field, PixelAspect
from procc_annotator.image.pixels import PixelArray
from procc_annotator.translation import translatable, translatable_joined


def classify_proposal(
    seen: ProposalEvidence, pixels: PixelAspect, sure_from: float = SURE_FROM
) -> tuple[ProposalState, str, float]:
    """Return whether a camera is sure, unsure or none, why, in a sentence, and the probability that
    it is right."""
    shares = translatable(
        "{lines:.0f} % of expected lines found, {paint:.0f} % of visible paint matched",
        lines=100 * seen.coverage,
        paint=100 * seen.explained,
    )
    on_lines = probability_right(seen)
    if on_lines < POSSIBLE_FROM:
        why = translatable("no camera fits the lines (best: {shares})", shares=shares)
        return NONE, why, on_lines
    probability = on_lines * pixels.probability
    if probability >= sure_from:
        return SURE, shares, probability
    doubt = main_doubt(seen)
    if on_lines >= sure_from:
        doubt = translatable("the picture is nearly square: its pixels may not be")
    return UNSURE, translatable_joined("", (doubt, " (", shares, ")")), probability


_MIN_LINE_PIXELS = 60  # places of paint


def propose_camera(
    picture: PixelArray,
    field: Field,
    *,
    known: Sequence[KnownPosition] = (),
    elsewhere: bool = True,
    sure_from: float = SURE_FROM,
    go_on: Callable[[], None] = lambda: None,
) -> Proposal:
    """Find the camera of a picture from the paint on the ground.

    Args:
        picture: (H, W, 4) BGRA.
        field: the elements, metres, and the pixels of the picture; where these are not known and
            its shape is none that cameras make, they are found out.
        known: where its camera may be known to stand: more hypotheses, which replace the camera
            found without them only by a better one.
        elsewhere: also search all positions that the field's file allows; always without ``known``.
        sure_from: the probability of being right from which on the camera is called sure.
        go_on: called between steps; what it raises ends the search.

    Returns:
        The camera and how sure it is; state ``none`` without one. Where a field looks the same
        from several sides it is the one on the main camera's.
    """
    size = (picture.shape[1], picture.shape[0])
    if field_line_points(field) is None:
        return _no_proposal(size, f"{field.title} has no painted lines to look for")
    pixels = field.pixels
    possible = possible_pixel_aspects(size) if pixels is None else (pixels,)
    elsewhere = elsewhere or not known
    for wide in (False, True):
        found = [
            found_camera(
                picture, field, aspect.value,
                known=known, elsewhere=elsewhere, wide=wide, go_on=go_on,
            )
            for aspect in possible
        ]  # fmt: skip
        if not elsewhere or any(one is None or one.is_possible for one in found):
            break
    if len(found) > 1:
        pixels = most_probable_aspect(possible, [[one.sample if one else None] for one in found])
    best = found[[one.value for one in possible].index(pixels.value)] if pixels else found[0]
    if best is None:
        why = "no camera has its lines on the paint of this picture"
        if len(line_pixels_for_field(picture, field).on_ground) < _MIN_LINE_PIXELS:
            why = "there is hardly any paint on the ground in this picture"
        return _with_sport_hint(_no_proposal(size, why), field)
    return _with_sport_hint(_proposal(best, size, pixels or SQUARE_PIXELS, sure_from), field)


@dataclass(frozen=True, eq=False)
class FoundCamera:
    """The best camera of a picture with square pixels, px of that picture."""

    candidate: BestCandidate
    evidence: ProposalEvidence

    @property
    def is_possible(self) -> bool:
        """Whether it is more likely right than wrong."""
        return probability_right(self.evidence) >= POSSIBLE_FROM

    @property
    def sample(self) -> AspectSample:
        """What it says of the pixels."""
        return AspectSample(self.evidence, self.candidate.candidate.vector[POSITION_SLICE])


def found_camera(
    picture: PixelArray,
    field: Field,
    aspect: float = 1.0,
    *,
    known: Sequence[KnownPosition] = (),
    elsewhere: bool = True,
    wide: bool = False,
    go_on: Callable[[], None] = lambda: None,
) -> FoundCamera | None:
    """The best camera of a picture with pixels so many times as wide as high, searched ``wide``
    from more starts; None without any."""
    size = (picture.shape[1], picture.shape[0])
    picture = with_square_pixels(picture, aspect)
    lines, paint = field_line_points(field), line_pixels_for_field(picture, field)
    if lines is None or len(paint.on_ground) < _MIN_LINE_PIXELS:
        return None
    go_on()
    known = [
        replace(place, camera=place.camera and place.camera.scaled(size, paint.frame.size))
        for place in known
    ]
    best = best_candidate(
        picture, field, lines, paint, known=known, elsewhere=elsewhere, wide=wide, go_on=go_on
    )
    return None if best is None else FoundCamera(best, best.evidence(picture, field))


ASPECT_PICTURES = 12  # of a set, to estimate its pixel aspect; fewer if it is certain before
_CERTAIN = 0.999


def estimate_pixel_aspect(
    pictures: Iterable[tuple[PixelArray, Field]], go_on: Callable[[], None] = lambda: None
) -> PixelAspect | None:
    """Estimate how wide the pixels of pictures (H, W, 4) BGRA of one source are; None where they
    have a shape that cameras make. What ``go_on``, called between steps, raises ends the search."""
    possible: Sequence[PixelAspect] = ()
    samples: list[list[AspectSample | None]] = []
    for picture, field in pictures:
        own = possible_pixel_aspects((picture.shape[1], picture.shape[0]))
        if len(own) == 1 or (possible and own != possible):
            return None
        possible, samples = own, samples or [[] for _ in own]
        for aspect, of_pictures in zip(own, samples, strict=True):
            best = found_camera(picture, field, aspect.value, go_on=go_on)
            of_pictures.append(best.sample if best else None)
        if most_probable_aspect(possible, samples).probability > _CERTAIN:
            break
    return most_probable_aspect(possible, samples) if possible else None


def _proposal(
    found: FoundCamera, size: tuple[int, int], pixels: PixelAspect, sure_from: float
) -> Proposal:
    """What is proposed for a picture (width, height)."""
    refined, other, seen = found.candidate.candidate.refined, found.candidate.other, found.evidence
    state, reason, probability = classify_proposal(seen, pixels, sure_from)
    if state == NONE:
        return replace(_no_proposal(size, reason), probability=probability)
    square = refined.fit.size
    rival = None if other is None else camera_from_vector(other, ImageFrame(square))
    return Proposal(
        state,
        reason,
        fit_in_picture(refined.fit, size),
        seen.coverage,
        seen.explained,
        refined.residual_px,
        seen.margin,
        None if rival is None else rival.scaled(square, size),
        probability,
    )


def _with_sport_hint(found: Proposal, field: Field) -> Proposal:
    """Ask for the sport where no camera was found."""
    if found.state != NONE:
        return found
    hint = translatable("is this {field}? {why}", field=field.title, why=found.reason)
    return replace(found, fit=replace(found.fit, failure=hint), reason=hint)


def _no_proposal(size: tuple[int, int], reason: str) -> Proposal:
    fit = FitResult("R", size, None, reason)
    return Proposal(NONE, reason, fit, 0.0, 0.0, None, 0.0, None)
