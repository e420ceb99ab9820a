"""A fit never takes long: its work is bounded, whatever was clicked."""

from __future__ import annotations

import numpy as np
import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.optimization import robust_fit
from procc_annotator.calibration.optimization.observations import (
    MAX_POINTS,
    ImageFrame,
    build_observations,
)

# Times that residuals are computed (for any number of cameras at once), at most: 4 + 5 steps of the
# search, 20 robust ones, 20 final ones, one look at the start of each of these four stages, and one
# at who is mistaken.
COLD = 54
# A start that misleads: up to 8 + 3 x 20 steps in vain before; the choice compares two more models,
# and has up to 8 + 20 steps of its own in vain.
MISLED, CHOICE, CHOICE_MISLED = COLD + 73, 42, 73
# Where the picture may be cut out of a larger one: 20 more robust steps, 20 more final ones.
CUT_OUT = 42
# Where there may be barrel distortion: one look at its promise, 20 more robust steps, 20 more final
# ones, and one look at the start of both.
BARREL = 43
# Where lines are bent as by a strong lens: three searches for points made straight again, and a
# fisheye and a radial lens with 40 robust steps and 20 final ones each, with a look at each start.
STRONG = 3 * COLD + 2 * 62


class Work:
    """Counts the residuals that are computed."""

    def __init__(self, monkeypatch) -> None:
        self.calls = self.points = 0
        computed = robust_fit.pinhole_residuals

        def counted(vectors, seen, **options):
            self.calls += 1
            self.points += len(vectors) * seen.points.shape[1]
            return computed(vectors, seen, **options)

        monkeypatch.setattr(robust_fit, "pinhole_residuals", counted)

    def of(self, annotation, field, **options) -> int:
        self.calls = 0
        fit_camera(annotation, field, **options)
        return self.calls


@pytest.fixture
def work(monkeypatch) -> Work:
    return Work(monkeypatch)


def shuffled(annotation: FrameAnnotation, rng: np.random.Generator) -> FrameAnnotation:
    names = rng.permutation([p.class_name for p in annotation])
    return FrameAnnotation(
        tuple(Polyline(str(n), p.points) for n, p in zip(names, annotation, strict=True))
    )


def scattered(annotation: FrameAnnotation, rng: np.random.Generator) -> FrameAnnotation:
    def moved(points: tuple[Point, ...]) -> tuple[Point, ...]:
        return tuple(Point(p.u + rng.normal(0, 0.05), p.v + rng.normal(0, 0.05)) for p in points)

    return FrameAnnotation(tuple(Polyline(p.class_name, moved(p.points)) for p in annotation))


@pytest.mark.parametrize("model", ["R+", "auto"])
def test_the_work_is_bounded_whatever_the_labels_say(views, field, work, model) -> None:
    rng = np.random.default_rng(40)
    most = COLD + CUT_OUT + BARREL + (CHOICE + STRONG if model == "auto" else 0)
    for _ in range(3):
        annotation = views.random(rng, at_least=3).annotation
        for spoilt in (annotation, shuffled(annotation, rng), scattered(annotation, rng)):
            assert 0 < work.of(spoilt, field, model=model) <= most


@pytest.mark.parametrize("model", ["R", "auto"])
def test_so_is_that_of_a_start_that_misleads(views, field, work, model) -> None:
    rng = np.random.default_rng(41)
    most = MISLED + BARREL + (CUT_OUT + CHOICE_MISLED if model == "auto" else 0)
    counts: list[int] = []
    for _ in range(3):
        view, other = views.random(rng), views.random(rng)
        both = (view.annotation, shuffled(view.annotation, rng))
        counts += [work.of(a, field, model=model, start=other.camera) for a in both]
    assert 0 < max(counts) <= most


def test_a_warm_fit_takes_a_few_steps(views, field, work) -> None:
    rng = np.random.default_rng(42)
    counts = {"R": [], "auto": []}
    for _ in range(4):
        view = views.random(rng, at_least=6)
        for model, found in counts.items():
            start = fit_camera(view.annotation, field, model=model).camera
            again = views.clicks(view.camera, rng)
            found.append(work.of(again, field, model=model, start=start))
    assert np.median(counts["R"]) <= 8
    assert np.median(counts["auto"]) <= 18


def test_thousands_of_points_cost_no_more_than_many(views, field, work, median_error) -> None:
    """Masks and regularised lines may come with a point a pixel."""
    view = views.main(np.random.default_rng(43), noise_px=0.3)

    def dense(polyline: Polyline, count: int) -> Polyline:
        given = np.array([(p.u, p.v) for p in polyline.points])
        at = np.linspace(0, len(given) - 1, count)
        along = np.arange(len(given))
        uv = [np.interp(at, along, given[:, k]) for k in (0, 1)]
        return Polyline(polyline.class_name, tuple(Point(*p) for p in zip(*uv, strict=True)))

    many = FrameAnnotation(tuple(dense(p, 1500) for p in view.annotation))
    seen = build_observations(many, field, ImageFrame((960, 540)))
    assert max(seen.counts) == MAX_POINTS
    ends = seen.points[:, [0, seen.counts[0] - 1]]
    first = many.get(seen.elements[0].name).points
    expected = [[(p.u - 0.5) * 959, (p.v - 0.5) * 539] for p in (first[0], first[-1])]
    np.testing.assert_allclose(ends.T, expected, atol=1e-9)
    assert median_error(view.camera, fit_camera(many, field).camera) < 2
