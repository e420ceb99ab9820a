"""Camera motion between two images, and scene-cut detection."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.image.pixels import PixelArray

_THUMBNAIL_SIZE = (48, 27)  # 16:9, so small that players hardly count
_HISTOGRAM_BINS = 6  # per colour channel
_MIN_CUT_DIFFERENCE = (
    0.055  # a pan by 1.5 % of the width stays below 0.05, cuts between views start at 0.06
)
_CUT_RATIO = 2.5  # a cut stands out of the motion before and after it
_CUT_WINDOW = 6  # frames to either side: a quarter of a second
CUT_MARGIN = _CUT_WINDOW + 4  # frames around one that decide whether it begins a scene


@dataclass(frozen=True, eq=False)
class FrameSignature:
    """Signature of a picture: its layout in small, and its colours."""

    layout: FloatArray  # (27, 48, 3), 0 to 1
    colours: FloatArray  # (216,) shares


def frame_signature(pixels: PixelArray) -> FrameSignature:
    """The look of a (H, W, 3) BGR picture."""
    stride = max(1, min(pixels.shape[0] // 180, pixels.shape[1] // 320))
    fewer = np.ascontiguousarray(pixels[::stride, ::stride])
    small = cv2.resize(fewer, _THUMBNAIL_SIZE, interpolation=cv2.INTER_AREA)
    step = 256 / _HISTOGRAM_BINS
    bins = (small / step).astype(np.int64) @ np.array(
        [1, _HISTOGRAM_BINS, _HISTOGRAM_BINS * _HISTOGRAM_BINS]
    )
    shares = np.bincount(bins.ravel(), minlength=_HISTOGRAM_BINS**3) / bins.size
    return FrameSignature(small.astype(np.float64) / 255, shares)


def signature_distance(a: FrameSignature, b: FrameSignature) -> float:
    """0 for the same picture, 0.06 to 0.4 for another camera's."""
    layout = float(np.abs(a.layout - b.layout).mean())
    colours = float(np.abs(a.colours - b.colours).sum()) / 2
    return layout + colours / 4


def is_same_scene(a: FrameSignature, b: FrameSignature) -> bool:
    """Return whether two pictures, one right after the other, may be of one camera that moves."""
    return signature_distance(a, b) < _MIN_CUT_DIFFERENCE


def frame_differences(looks: Iterable[FrameSignature]) -> tuple[FloatArray, FloatArray]:
    """Return how much each picture of a row differs from those around it, as `cut_indices` takes
    it.

    Returns:
        (N,) difference to the one before it, and (N,) least difference among pictures shortly
        before and after.
    """
    recent: deque[FrameSignature] = deque(maxlen=4)
    steps: list[float] = []
    lasting: list[float] = []
    for look in looks:
        past = list(recent)[1:-1]
        steps.append(signature_distance(recent[-1], look) if recent else 0.0)
        recent.append(look)
        # Small where a flash ends...
        lasting.append(min((signature_distance(old, look) for old in past), default=1.0))
        if len(recent) == 4:  # ... and where it begins
            lasting[-3] = min(lasting[-3], signature_distance(recent[0], look))
    return np.array(steps), np.array(lasting)


def cut_indices(steps: FloatArray, lasting: FloatArray) -> list[int]:
    """The first picture of each scene, 0 included.

    Args:
        steps: (N,) difference of each picture to the one before it; the first is ignored.
        lasting: (N,) least difference among pictures shortly before and after: small where a
            flash begins or ends, which is no cut.
    """
    cuts = [0]
    for n in range(1, len(steps)):
        if steps[n] < _MIN_CUT_DIFFERENCE or lasting[n] < max(_MIN_CUT_DIFFERENCE, steps[n] / 2):
            continue
        around = steps[max(1, n - _CUT_WINDOW) : n + _CUT_WINDOW + 1]
        usual = float(np.median(around)) if len(around) > 2 else 0.0
        near = steps[max(1, n - 2) : n + 3]
        if steps[n] >= near.max() and steps[n] > _CUT_RATIO * usual:
            cuts.append(n)
    return cuts


_WORKING_SIDE_PX = 960  # pictures are matched with their longer side reduced to this
_GRID_CELLS = (16, 9)  # square in a 16:9 picture: features come from all of it
_FEATURES_PER_CELL = 14  # 2,016 in all
_INLIER_PX = 2.5  # of the consensus among matches, at the reduced size
_FINE_INLIER_PX = 1.2  # of the consensus among tracked points
_STATIC_PX = 1.5  # a match that moves less could belong to a graphic
_OVERLAY_GRAPHIC_PX = 4.0  # what moves so far and yet looks the same where it was is a graphic
_FINE_STATIC_PX = 0.35  # the same of a tracked point
_MIN_MATCHES = 12  # whatever their share: tracking shows whether they were right
_MIN_TRACKED = 24  # three per degree of freedom of a homography
_MIN_CELLS = 8
_MIN_SHARE = 0.3


@dataclass(frozen=True, eq=False)
class CameraMotion:
    """The motion of a camera between two pictures, as far as it turns and zooms in one place."""

    current_from_previous: FloatArray  # (3, 3) homography of pixels
    inliers: int
    matches: int


@dataclass(frozen=True, eq=False)
class _RefinedHomography:
    """A homography of the reduced pictures, and how many tracked points agree with it."""

    homography: FloatArray
    inliers: int
    tracked: int


def estimate_motion(previous: PixelArray, current: PixelArray) -> CameraMotion | None:
    """Return where the previous picture's points are in the current picture.

    Players are left out, and graphics that stay in place while the rest moves do not count.

    Args:
        previous: (H, W, 4) uint8 BGRA.
        current: (h, w, 4) uint8 BGRA, possibly of another size.

    Returns:
        None if there is no motion to be trusted: another camera, or too little in common.
    """
    before, scale_before = _working_image(previous)
    now, scale_now = _working_image(current)
    still_before, still_now = _static_mask(before), _static_mask(now)
    grey_before, grey_now = _grey(before), _grey(now)
    matches = _match_features(grey_before, still_before, grey_now, still_now)
    starts = list(_consensus_homographies(*matches, grey_now.shape, _INLIER_PX, _STATIC_PX))
    if len(starts) == 2 and 3 * starts[0][1] < starts[1][1]:
        starts.reverse()  # hardly anything moved
    for start, count in starts:
        fine = None
        if count >= _MIN_MATCHES:
            fine = _refine_by_tracking(start, grey_before, still_before, grey_now, still_now)
        if fine is not None:
            full = np.linalg.inv(scale_now) @ fine.homography @ scale_before
            return CameraMotion(full / full[2, 2], fine.inliers, fine.tracked)
    return None


def transfer_points(motion: CameraMotion, points: FloatArray) -> FloatArray:
    """(N, 2) px of the current picture for (N, 2) px of the previous one.

    A point that the motion takes behind the camera becomes NaN.
    """
    return _apply_homography(motion.current_from_previous, np.asarray(points, dtype=np.float64))


def _apply_homography(homography: FloatArray, points: FloatArray) -> FloatArray:
    image = points @ homography[:, :2].T + homography[:, 2]
    depth = np.where(image[:, 2:] > 1e-9, image[:, 2:], np.nan)
    return np.asarray(image[:, :2] / depth, dtype=np.float64)


def _working_image(picture: PixelArray) -> tuple[PixelArray, FloatArray]:
    """(H, W, 3) BGR of the working size, and (3, 3) its pixels from those of the picture."""
    height, width = picture.shape[:2]
    scale = _WORKING_SIDE_PX / max(width, height)
    size = max(_GRID_CELLS[0], round(width * scale)), max(_GRID_CELLS[1], round(height * scale))
    shrinks = scale < 1
    small = cv2.resize(picture, size, interpolation=cv2.INTER_AREA if shrinks else cv2.INTER_LINEAR)
    sx, sy = size[0] / width, size[1] / height
    # Pixel centres are whole numbers, so x = -0.5 stays the left edge.
    reduced_from_full = np.array([[sx, 0, (sx - 1) / 2], [0, sy, (sy - 1) / 2], [0, 0, 1]])
    return np.asarray(cv2.cvtColor(small, cv2.COLOR_BGRA2BGR), dtype=np.uint8), reduced_from_full


def _grey(picture: PixelArray) -> PixelArray:
    return np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY), dtype=np.uint8)


def _static_mask(picture: PixelArray) -> PixelArray:
    """(H, W) 255 where nothing moves by itself, 0 on small things on the grass, lines excepted."""
    half = picture[::2, ::2]
    hue, saturation, value = cv2.split(cv2.cvtColor(half, cv2.COLOR_BGR2HSV))
    green = (hue >= 30) & (hue <= 90) & (saturation > 50) & (value > 30)
    field = cv2.morphologyEx(green.astype(np.uint8), cv2.MORPH_OPEN, np.ones((5, 5), np.uint8))
    field = cv2.morphologyEx(field, cv2.MORPH_CLOSE, np.ones((25, 25), np.uint8))
    others = cv2.morphologyEx(
        ((field > 0) & ~green).astype(np.uint8), cv2.MORPH_OPEN, np.ones((3, 3), np.uint8)
    )
    _, labels, boxes, _ = cv2.connectedComponentsWithStats(others)
    height, width = green.shape
    wide, tall = boxes[:, cv2.CC_STAT_WIDTH], boxes[:, cv2.CC_STAT_HEIGHT]
    person = (wide < width / 6) & (tall < height / 2) & (boxes[:, cv2.CC_STAT_AREA] >= 8)
    person[0] = False  # the rest of the picture
    moving = cv2.dilate(person[labels].astype(np.uint8), np.ones((7, 7), np.uint8))
    still = cv2.resize(255 * (1 - moving), (picture.shape[1], picture.shape[0]))
    return np.asarray((still > 127) * np.uint8(255), dtype=np.uint8)


def _strongest_per_cell(
    points: FloatArray, strength: FloatArray, shape: tuple[int, ...]
) -> NDArray[np.int64]:
    """Indices of the strongest points of every cell: a crowd must not be all that is examined."""
    order = np.argsort(-strength, kind="stable")
    cell = _cell_indices(points[order], shape)
    by_cell = np.argsort(cell, kind="stable")
    ordered = cell[by_cell]
    rank = np.arange(len(ordered)) - np.searchsorted(ordered, ordered)
    return np.sort(order[by_cell[rank < _FEATURES_PER_CELL]])


def _cell_indices(points: FloatArray, shape: tuple[int, ...]) -> NDArray[np.int64]:
    size = np.array([shape[1], shape[0]])
    cell = np.clip((points + 0.5) / size * _GRID_CELLS, 0, np.array(_GRID_CELLS) - 1).astype(
        np.int64
    )
    return np.asarray(cell[:, 1] * _GRID_CELLS[0] + cell[:, 0], dtype=np.int64)


def _match_features(
    before: PixelArray, still_before: PixelArray, now: PixelArray, still_now: PixelArray
) -> tuple[FloatArray, FloatArray]:
    """Points that look alike, (N, 2) and (N, 2) px."""
    points_before, described_before = _detect_features(before, still_before)
    points_now, described_now = _detect_features(now, still_now)
    if described_before is None or described_now is None:
        return np.empty((0, 2)), np.empty((0, 2))
    found = cv2.BFMatcher(cv2.NORM_HAMMING, crossCheck=True).match(described_before, described_now)
    return (
        points_before[[match.queryIdx for match in found]],
        points_now[[match.trainIdx for match in found]],
    )


def _detect_features(grey: PixelArray, still: PixelArray) -> tuple[FloatArray, PixelArray | None]:
    detector = cv2.ORB.create(nfeatures=4000, scaleFactor=1.2, nlevels=5, fastThreshold=6)
    found = detector.detect(grey, still)
    if not found:
        return np.empty((0, 2)), None
    points = np.array([point.pt for point in found])
    kept = _strongest_per_cell(points, np.array([point.response for point in found]), grey.shape)
    chosen, described = detector.compute(grey, [found[i] for i in kept])
    return np.array([point.pt for point in chosen]), np.asarray(described, dtype=np.uint8)


def _consensus_homographies(
    before: FloatArray, now: FloatArray, shape: tuple[int, ...], reach: float, still_px: float
) -> Iterator[tuple[FloatArray, int]]:
    """Homographies that what moved agrees on, then everything; each with for how many points.

    A graphic agrees on "nothing moved", and with a homography's freedom it bends one that is right
    elsewhere. So what stood still counts only if nothing else agrees on a motion.
    """
    moved = np.hypot(*(now - before).T) > still_px
    for chosen in (moved, np.ones(len(moved), dtype=bool)):
        found = _ransac_homography(before[chosen], now[chosen], reach)
        if found is None:
            continue
        homography, agree = found
        if len(np.unique(_cell_indices(now[chosen][agree], shape))) >= _MIN_CELLS:
            yield homography, int(agree.sum())


def _ransac_homography(
    before: FloatArray, now: FloatArray, reach: float
) -> tuple[FloatArray, BoolArray] | None:
    if len(before) < _MIN_MATCHES:
        return None
    homography, agree = cv2.findHomography(
        before, now, cv2.USAC_MAGSAC, reach, maxIters=4000, confidence=0.999
    )
    if homography is None or not np.isfinite(homography).all():
        return None
    return np.asarray(homography, dtype=np.float64), agree.ravel().astype(bool)


def _refine_by_tracking(
    start: FloatArray,
    before: PixelArray,
    still_before: PixelArray,
    now: PixelArray,
    still_now: PixelArray,
) -> _RefinedHomography | None:
    """A better homography, from points tracked over what ``start`` leaves.

    None if too few points are where ``start`` says: then it was chance.
    """
    warped = _warp(before, start, now.shape)
    seen = np.minimum(_warp(still_before, start, now.shape), still_now)
    points = _detect_corners(warped, seen)
    origin = _apply_homography(np.asarray(np.linalg.inv(start)), points)
    graphic = _unchanged_mask(before, now)
    overlaid = _mask_values_at(graphic, points) | _mask_values_at(graphic, origin)
    scene = ~(overlaid & (np.hypot(*(points - origin).T) > _OVERLAY_GRAPHIC_PX))
    points, origin = points[scene], origin[scene]
    if len(points) < _MIN_TRACKED:
        return None
    guess = points.astype(np.float32).reshape(-1, 1, 2)
    tracked, done, _ = cv2.calcOpticalFlowPyrLK(
        warped, now, guess, guess.copy(), winSize=(15, 15), maxLevel=1
    )
    followed = np.asarray(done).ravel() == 1
    after = np.asarray(tracked, dtype=np.float64).reshape(-1, 2)[followed]
    for homography, inliers in _consensus_homographies(
        origin[followed], after, now.shape, _FINE_INLIER_PX, _FINE_STATIC_PX
    ):
        enough = inliers >= max(_MIN_TRACKED, _MIN_SHARE * len(points))
        if enough and _is_plausible_homography(homography, (now.shape[1], now.shape[0])):
            return _RefinedHomography(homography, inliers, len(points))
    return None


def _detect_corners(grey: PixelArray, seen: PixelArray) -> FloatArray:
    """(N, 2) px where there is something to track."""
    inner = cv2.erode(seen, np.ones((9, 9), np.uint8), borderValue=0)
    found = cv2.goodFeaturesToTrack(grey, 2000, 0.002, 6, mask=inner)
    points = np.asarray([] if found is None else found, dtype=np.float64).reshape(-1, 2)
    # They come strongest first.
    return points[
        _strongest_per_cell(points, -np.arange(len(points), dtype=np.float64), grey.shape)
    ]


def _warp(grey: PixelArray, homography: FloatArray, shape: tuple[int, ...]) -> PixelArray:
    return np.asarray(cv2.warpPerspective(grey, homography, (shape[1], shape[0])), dtype=np.uint8)


def _unchanged_mask(before: PixelArray, now: PixelArray) -> BoolArray:
    """(H, W) where there is something to see, and both pictures show the same there."""
    if before.shape != now.shape:
        return np.zeros(now.shape, dtype=np.bool_)
    side = (11, 11)
    changed = cv2.blur(cv2.absdiff(before, now), side).astype(np.float32)
    values = now.astype(np.float32)
    mean = cv2.blur(values, side)
    spread = np.sqrt(np.maximum(cv2.blur(values * values, side) - mean * mean, 0))
    return np.asarray((spread > 10) & (changed < 0.3 * spread), dtype=np.bool_)


def _mask_values_at(mask: BoolArray, points: FloatArray) -> BoolArray:
    limit = np.array([mask.shape[1], mask.shape[0]]) - 1
    x, y = np.clip(np.round(points), 0, limit).astype(np.int64).T
    return np.asarray(mask[y, x], dtype=np.bool_)


def _is_plausible_homography(homography: FloatArray, size: tuple[int, int]) -> bool:
    """Return whether no part is turned over and the zoom is between a half and two where both
    see."""
    x, y = np.meshgrid(np.linspace(0, size[0] - 1, 9), np.linspace(0, size[1] - 1, 7))
    points = np.column_stack([x.ravel(), y.ravel()])
    ends = [_apply_homography(homography, points + step) for step in ((0, 0), (1, 0), (0, 1))]
    here, right, down = ends
    area = (right - here)[:, 0] * (down - here)[:, 1] - (right - here)[:, 1] * (down - here)[:, 0]
    seen = ((here >= 0) & (here <= np.array(size) - 1)).all(axis=1)
    return bool(seen.sum() >= 6 and ((area[seen] > 0.25) & (area[seen] < 4)).all())
