"""Fit the probability that a proposed camera is right, and print its reliability:
``python -m tests.bench.no_clicks.fit_probability SHARED KEPT [--held] [--write]``.

SHARED is the folder of real data; evidence is collected once and kept in KEPT (JSON lines).
Each picture gives the evidence for its best camera, and for the best of those that show something
else: what would be proposed if the search had missed the first. Searches miss the right camera in
some 3 % of real frames, so that is what the second ones weigh. Matches in `HELD_OUT` are not used,
``--held`` judges them too.
"""

import json
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import cv2
import numpy as np
from scipy.optimize import minimize

from procc_annotator.calibration.single_image.candidates import (
    BestCandidate,
    refine_candidates,
    search_scene,
)
from procc_annotator.calibration.single_image.field_points import field_line_points
from procc_annotator.calibration.single_image.icp_refinement import line_pixels_for_field
from procc_annotator.calibration.single_image.probability import (
    FEATURES,
    MODEL_FILE,
    POSSIBLE_FROM,
    SURE_FROM,
    LogisticModel,
    probability_right,
)
from procc_annotator.camera.base import Camera, scaled_camera
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.image.pixels import PixelArray
from procc_annotator.resources import resources_dir
from tests.bench.no_clicks.clips import half_turned, hall_clips, is_right, soccer_clips
from tests.bench.sports.views import Views
from tests.drawn_shots import ARENAS, Look, draw, random_camera, stage_of

HELD_OUT = ("Italia-Alemania", "Chelsea-Milan", "42ba34", "2e57b9")
MISSED = 0.03
_DRAWN, _SIZE, _SEED = 30, (960, 540), 31
_PLAIN = ("tennis", "handball", "futsal", "american_football", "basketball_nba", "ice_hockey_nhl")
_PENALTY = 0.1  # on squared weights of features with unit variance


@dataclass(frozen=True)
class Judged:
    """A picture, and whether a camera of it is right."""

    name: str
    group: str
    picture: Callable[[], PixelArray]
    field: str
    is_right: Callable[[Camera], bool]


# --- pictures -------------------------------------------------------------------------------------

_PA, _GA = 20.16, 9.16  # half widths of penalty and goal areas
_END = [-34, -_PA, -_GA, _GA, _PA, 34]
KEYPOINTS = np.array(
    [(-52.5, y) for y in _END]
    + [(-47, -_GA), (-47, _GA), (-41.5, 0)]
    + [(-36, y) for y in _END[1:5]]
    + [(0, y) for y in (-34, -9.15, 9.15, 34)]
    + [(36, y) for y in _END[1:5]]
    + [(41.5, 0), (47, -_GA), (47, _GA)]
    + [(52.5, y) for y in _END]
    + [(-9.15, 0), (9.15, 0)]
)
"""(32, 2) metres, the places of the keypoints of `keypoints32`."""


def keypoints_fit(points: np.ndarray, size: tuple[int, int], camera: Camera) -> bool:
    """Whether a camera shows at least 70 % of the keypoints (32, 3: x, y, visibility) within 15 px
    at 960x540, from either side: people set them to some px, and pitches differ in size."""
    if not isinstance(camera, PinholeCamera):
        return False
    seen = (points[:, 2] > 1) & ((points[:, :2] > 0) & (points[:, :2] < 1)).all(axis=1)
    world = np.column_stack([KEYPOINTS, np.zeros(len(KEYPOINTS))])
    for one in (camera, half_turned(camera)):
        px, ahead = scaled_camera(one, size, _SIZE).project(world)
        away = np.hypot(*(px - points[:, :2] * (np.array(_SIZE) - 1)).T)
        if np.mean((ahead & (away < 15))[seen]) >= 0.7:
            return True
    return False


def judged_pictures(shared: Path) -> Iterator[Judged]:
    """Real frames with measured points or keypoints, frames of one sport taken for another, and
    drawn frames of all sports."""
    for clip in (*soccer_clips(shared), *hall_clips(shared)):
        for number, truth in clip.truth.items():
            right = partial(is_right, truth, size=clip.size, field=load_field(clip.field))
            group = next((p for p in clip.path.stem.split("_") if "-" in p), clip.path.stem)
            picture = partial(clip.frame, number)
            yield Judged(f"{clip.path.stem} {number}", group, picture, clip.field, right)
    for path in sorted((shared / "keypoints32" / "images").iterdir()):
        values = (shared / "keypoints32" / "labels" / f"{path.stem}.txt").read_text().split()
        points = np.array(values[5:], dtype=float).reshape(32, 3)
        right = partial(keypoints_fit, points, (1280, 720))
        yield Judged(path.stem, path.stem[:6], partial(_stretched, path), "soccer", right)
    for clip in hall_clips(shared):
        for other in ("soccer", "handball", "tennis", "volleyball", "basketball_fiba"):
            for number in [*clip.truth][::4] if other.split("_")[0] not in clip.field else []:
                name, picture = f"{clip.name} {number} as {other}", partial(clip.frame, number)
                yield Judged(name, f"{clip.name} as another", picture, other, _never)
    for sport in (*ARENAS, *_PLAIN):
        rng, stage = np.random.default_rng(_SEED), stage_of(sport)
        for number in range(_DRAWN if sport in ARENAS else _DRAWN // 3):
            camera = random_camera(stage.field, rng, _SIZE)
            look = Look(noise=float(rng.uniform(1, 6)), jpeg_quality=int(rng.integers(40, 95)))
            truth = Views(stage.field).clicks(camera, np.random.default_rng(number), 0.0)
            yield Judged(
                f"drawn {sport} {number}",
                f"drawn {sport} {number % 5}",
                partial(draw, stage, camera, _SIZE, seed=1000 * _SEED + number, look=look),
                f"stage {sport}",
                partial(is_right, truth, size=_SIZE, field=stage.field),
            )


def _never(camera: Camera) -> bool:
    del camera
    return False


def _stretched(path: Path) -> PixelArray:
    picture = cv2.resize(cv2.imread(str(path)), (1280, 720), interpolation=cv2.INTER_CUBIC)
    return np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2BGRA), dtype=np.uint8)


def _field(name: str) -> Field:
    return stage_of(name.removeprefix("stage ")).field if " " in name else load_field(name)


# --- evidence -------------------------------------------------------------------------------------


def examples(judged: Judged) -> list[dict[str, object]]:
    """The evidence for the best camera of a picture, and for the best other one."""
    cv2.setNumThreads(1)
    picture, field = judged.picture(), _field(judged.field)
    lines, paint = field_line_points(field), line_pixels_for_field(picture, field)
    assert lines is not None
    rows: list[dict[str, object]] = []
    if len(paint.on_ground) < 60:
        return rows
    for wide in (False, True):  # as `propose_camera` does
        scene, found = search_scene(field, lines, paint, None, lambda: None, wide=wide)
        best = refine_candidates(picture, field, scene, found)
        if best and probability_right(best.evidence(picture, field)) >= POSSIBLE_FROM:
            break
    for first in (True, False):
        if best is None:
            break
        rows.append({"first": first, **_row(judged, picture, field, best)})
        best = refine_candidates(picture, field, scene, found, best.candidate.vector)
    return rows


def _row(
    judged: Judged, picture: PixelArray, field: Field, best: BestCandidate
) -> dict[str, object]:
    camera = best.candidate.refined.fit.camera
    assert camera is not None
    return {
        "name": judged.name,
        "group": judged.group,
        "right": judged.is_right(camera=camera),
        "features": best.evidence(picture, field).features.tolist(),
    }


def collect(shared: Path, kept: Path, *, held: bool) -> list[dict[str, object]]:
    """The examples of all pictures; those in the file are not collected again."""
    rows = [json.loads(line) for line in kept.read_text().splitlines()] if kept.exists() else []
    done = {row["name"] for row in rows}
    wanted = [
        one
        for one in judged_pictures(shared)
        if one.name not in done and (held or not one.group.startswith(HELD_OUT))
    ]
    with kept.open("a") as file:
        for judged in wanted:
            found = examples(judged) or [{"name": judged.name, "group": judged.group}]
            rows += found
            file.writelines(json.dumps(row) + "\n" for row in found)
            file.flush()
    return rows


# --- fit ------------------------------------------------------------------------------------------


def fit_logistic(features: np.ndarray, right: np.ndarray, weights: np.ndarray) -> LogisticModel:
    """The model of the largest penalised likelihood whose weights are not negative."""
    typical, scale = features[right].mean(axis=0), features.std(axis=0) + 1e-9
    unit, sign = (features - typical) / scale, np.where(right, 1.0, -1.0)

    def loss(x: np.ndarray) -> tuple[float, np.ndarray]:
        odds = sign * (x[0] + unit @ x[1:])
        slope = -sign * weights / (1 + np.exp(odds))
        value = (weights * np.logaddexp(0, -odds)).sum() + _PENALTY / 2 * (x[1:] ** 2).sum()
        return float(value), np.r_[slope.sum(), unit.T @ slope + _PENALTY * x[1:]]

    start = np.r_[2.0, np.full(len(scale), 0.5)]
    bounds = [(None, None)] + [(0, None)] * len(scale)
    found = minimize(loss, start, jac=True, bounds=bounds, method="L-BFGS-B").x
    return LogisticModel(float(found[0]), typical, found[1:] / scale)


@dataclass(frozen=True)
class Examples:
    """N examples: features (N, F), whether right, whether the best of its picture, group."""

    features: np.ndarray
    right: np.ndarray
    first: np.ndarray
    group: np.ndarray

    @classmethod
    def of(cls, rows: list[dict[str, object]]) -> "Examples":
        # A second camera that is right as well has most elements where the first has them.
        some = [row for row in rows if "features" in row and (row["first"] or not row["right"])]
        names = ("features", "right", "first", "group")
        return cls(*(np.array([row[name] for row in some]) for name in names))

    def chosen(self, rows: np.ndarray) -> "Examples":
        return Examples(self.features[rows], self.right[rows], self.first[rows], self.group[rows])

    def fit(self) -> LogisticModel:
        return fit_logistic(self.features, self.right, np.where(self.first, 1.0, MISSED))


def cross_validated(all_: Examples, parts: int = 8) -> np.ndarray:
    """(N,) the probability of each example by a model of other groups."""
    groups = np.random.default_rng(0).permutation(sorted(set(all_.group)))
    found = np.zeros(len(all_.right))
    for part in range(parts):
        own = np.isin(all_.group, groups[part::parts])
        found[own] = all_.chosen(~own).fit().probability(all_.features[own])
    return found


def reliability(title: str, probability: np.ndarray, right: np.ndarray) -> None:
    """Print how many of the examples in each range of probability are right."""
    sure = probability >= SURE_FROM
    print(f"\n{title}: {right.sum()} right, {(~right).sum()} wrong;", end=" ")
    print(f"sure {sure[right].sum()} and {(sure & ~right).sum()} of these;", end=" ")
    print(f"right and below 0.5: {(probability[right] < 0.5).sum()}")
    print("| probability | frames | mean | right |\n|---|---|---|---|")
    for low, high in ((0, 0.1), (0.1, 0.5), (0.5, 0.9), (0.9, 0.99), (0.99, 0.999), (0.999, 1.01)):
        own = (probability >= low) & (probability < high)
        if own.any():
            print(
                f"| {low:g} to {min(high, 1):g} | {own.sum()} |"
                f" {100 * probability[own].mean():.1f} % | {100 * right[own].mean():.1f} % |"
            )


def main(shared: Path, kept: Path, *, held: bool, write: bool) -> None:
    rows = collect(shared, kept, held=held)
    missing = [row["name"] for row in rows if "features" not in row]
    every = Examples.of(rows)
    unused = np.array([group.startswith(HELD_OUT) for group in every.group])
    used, other = every.chosen(~unused), every.chosen(unused)
    model = used.fit()
    print(f"{len(missing)} pictures without a camera; intercept {model.intercept:.2f}")
    for name, typical, weight in zip(FEATURES, model.typical, model.weights, strict=True):
        print(f"  {name:12s} typical {typical:6.3f} weight {weight:6.3f}")
    validated = cross_validated(used)
    drawn = np.array([group.startswith("drawn") for group in used.group])
    for title, rows_ in (("real, cross-validated", ~drawn), ("drawn, cross-validated", drawn)):
        own = used.first & rows_
        reliability(title, validated[own], used.right[own])
    reliability("others, cross-validated", validated[~used.first], used.right[~used.first])
    if other.first.any():
        first = other.chosen(other.first)
        reliability("held out", model.probability(first.features), first.right)
    if write:
        path = resources_dir() / MODEL_FILE
        head = [line for line in path.read_text().splitlines() if line.startswith("#")]
        table = [
            f"{name} = {{typical = {typical:.4f}, weight = {weight:.4f}}}"
            for name, typical, weight in zip(FEATURES, model.typical, model.weights, strict=True)
        ]
        text = [*head, f"intercept = {model.intercept:.4f}", "", "[features]", *table]
        path.write_text("\n".join(text) + "\n")


if __name__ == "__main__":
    options = sys.argv[3:]
    main(Path(sys.argv[1]), Path(sys.argv[2]), held="--held" in options, write="--write" in options)
