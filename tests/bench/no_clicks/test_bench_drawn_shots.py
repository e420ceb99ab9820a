"""Drawn shots whose cameras are known: ``pytest tests/bench/no_clicks/test_bench_drawn_shots.py
--benchmark-only -s``.

How far off tracks are, px at 960x540 of the lines in sight, degrees and metres; whether their
standard deviations are true (bands of 95 % should hold 90 to 98 % of the errors); and whether the
same shot gives the same cameras in other chunks and processes.
"""

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from procc_annotator.calibration.tracking.shot_tracker import track_shot
from procc_annotator.calibration.tracking.track import Track
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.image.pixels import PixelArray
from tests.drawn_shots import (
    Aim,
    DrawnShot,
    Look,
    course,
    cut_shot,
    soccer_shot,
    stage_of,
)

SIZE = (960, 540)
FRAMES = 40
_BAND = 1.96
_CALM = Look(people=False, noise=1.5)
_BROADCAST = Look(noise=4.0, jpeg_quality=60)


def _court_shot(
    name: str, position: tuple[float, float, float], aims: tuple[Aim, ...]
) -> DrawnShot:
    stage = stage_of(name)
    return DrawnShot(
        stage, (course(position, aims, FRAMES, SIZE, kappa=0.03),), SIZE, Look(noise=2.0)
    )


def _moving() -> DrawnShot:
    """A camera on a rail along the touchline."""
    x, y, z = -20.0, 50.0, -12.0
    aims = tuple(Aim(x + 0.5 * dx, 0, 900.0, (x + dx, y, z)) for dx in (0.0, 6.0, 12.0))
    return DrawnShot(stage_of("soccer"), (course((x, y, z), aims, FRAMES, SIZE),), SIZE)


SHOTS: dict[str, Callable[[], DrawnShot]] = {
    "calm": lambda: soccer_shot(FRAMES, size=SIZE, look=_CALM),
    "players, noise, loss": lambda: soccer_shot(FRAMES, size=SIZE, look=_BROADCAST),
    "motion blur": lambda: soccer_shot(FRAMES, size=SIZE, look=replace(_BROADCAST, shutter=0.5)),
    "a cut": lambda: cut_shot(FRAMES, size=SIZE, look=_BROADCAST),
    "a rail": _moving,
    "basketball": lambda: _court_shot(
        "basketball_fiba", (0, 21.5, -6.5), (Aim(-8, 0, 700), Aim(0, 0, 560), Aim(8, 0, 700))
    ),
    "ice hockey": lambda: _court_shot(
        "ice_hockey_iihf", (0, 35, -13), (Aim(-18, 0, 850), Aim(0, 0, 700), Aim(18, 0, 850))
    ),
    "volleyball": lambda: _court_shot(
        "volleyball", (-18, 2, -7), (Aim(-4, 0, 800), Aim(0, 1, 900), Aim(-2, 0, 800))
    ),
    "tennis": lambda: _court_shot("tennis", (-28, 0, -9), (Aim(0, -1, 1400), Aim(0, 1, 1500))),
}


@cache
def _pictures(name: str) -> tuple[DrawnShot, tuple[PixelArray, ...]]:
    shot = SHOTS[name]()
    return shot, tuple(shot.frame(number) for number in range(len(shot)))


def _tracked(name: str, anchored: bool) -> Track:
    shot, pictures = _pictures(name)
    anchors = {first: shot.cameras[first] for first, _ in shot.shots} if anchored else {}
    return track_shot(pictures.__getitem__, range(len(shot)), shot.stage.field, anchors=anchors)


def _errors(shot: DrawnShot, found: Track) -> dict[str, np.ndarray]:
    """Of the frames with a camera that was not given: px, degrees, metres, focal length in %, and
    each parameter's error in its standard deviations."""
    world = sample_evenly(shot.stage.field, 0.5).points_world
    rows: dict[str, list[float]] = {k: [] for k in ("px", "degrees", "metres", "focal %", "sds")}
    for frame in found.frames:
        fit = frame.fit
        if frame.state == "anchor" or fit is None or not isinstance(fit.camera, PinholeCamera):
            continue
        true, own = shot.cameras[frame.number], fit.camera
        there, seen = true.project(world)
        here, known = own.project(world)
        seen &= known & ((there >= 0) & (there <= np.array(shot.size) - 1)).all(axis=1)
        rows["px"].append(float(np.median(np.hypot(*(there - here)[seen].T))))
        pan = (own.pan_rad - true.pan_rad + np.pi) % (2 * np.pi) - np.pi
        angles = np.array([pan, own.tilt_rad - true.tilt_rad, own.roll_rad - true.roll_rad])
        place = np.subtract(own.position_world, true.position_world)
        focal = own.focal_px[0] - true.focal_px[0]
        rows["degrees"].append(float(np.degrees(np.abs(angles[:2]).max())))
        rows["metres"].append(float(np.linalg.norm(place)))
        rows["focal %"].append(100 * abs(focal) / true.focal_px[0])
        sd = fit.deviations
        by = np.array([sd.pan_rad, sd.tilt_rad, sd.roll_rad, *sd.position_m, sd.focal_px])
        rows["sds"] += (np.abs([*angles, *place, focal]) / np.maximum(by, 1e-12)).tolist()
    return {name: np.array(values) for name, values in rows.items()}


@pytest.mark.parametrize("anchored", [True, False], ids=["one camera given", "no click"])
@pytest.mark.parametrize("name", SHOTS)
def test_errors_and_bands(benchmark, name, anchored):
    """Each shot from its first frame's camera, and from nothing."""
    shot, _ = _pictures(name)
    found = benchmark.pedantic(lambda: _tracked(name, anchored), rounds=1)
    with_camera = sum(frame.fit is not None for frame in found.frames)
    row = f"| {name} | {'given' if anchored else 'no click'} | {with_camera} of {len(shot)} |"
    if not with_camera:
        print(f"\n{row} – |")
        return
    errors = _errors(shot, found)
    held = 100 * float(np.mean(errors["sds"] <= _BAND))
    figures = [
        f"{np.median(errors[k]):.2f} ({np.percentile(errors[k], 95):.2f})"
        for k in ("px", "degrees", "metres", "focal %")
    ]
    cuts = "right" if found.shots == shot.shots else str(found.shots)
    print(f"\n{row} {' | '.join(figures)} | {held:.0f} % | {cuts} |")


def test_the_same_cameras_in_other_chunks_and_processes(benchmark, tmp_path):
    """A video of two shots: once more, in two processes, and only one of its shots."""
    from typer.testing import CliRunner

    from procc_annotator.cli.main import app

    shot = cut_shot(40, size=SIZE, look=_BROADCAST)
    video = shot.write_video(tmp_path / "match.mp4")

    def run(name: str, *more: str) -> dict[str, bytes]:
        done = CliRunner().invoke(app, ["track", str(video), str(tmp_path / name), *more])
        assert done.exit_code == 0, done.output
        return {path.name: path.read_bytes() for path in (tmp_path / name).glob("camera_*")}

    first = benchmark.pedantic(lambda: run("first"), rounds=1)
    ways = {
        "decoded again": run("again"),
        "two processes": run("two", "--workers", "2"),
        "one shot alone": run("alone", "--from", "30"),
    }
    print()
    for words, found in ways.items():
        same = sum(first.get(name) == data for name, data in found.items())
        print(f"| {words} | {same} of {len(found)} cameras the same |")
