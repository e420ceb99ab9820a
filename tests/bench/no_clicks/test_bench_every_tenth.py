"""Proposals on every 10th frame of all soccer clips:
``pytest tests/bench/no_clicks/test_bench_every_tenth.py --benchmark-only -s``.

A camera is right if at least 70 % of the listed elements lie within 10 px of where it shows them,
at 960x540: those whose paint was measured; in frames in which nobody did, those that the clip's own
track has in sight (`test_bench_tracks` tells how good it is). So the clip that nobody measured is
judged by its track alone. ``CLIPS=River`` takes only clips with that in their names.
"""

import os
import time

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.calibration.single_image.propose import propose_camera
from procc_annotator.calibration.tracking.shot_tracker import track_shot
from procc_annotator.camera.base import Camera, scaled_camera
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import sample_evenly
from tests.bench.no_clicks.clips import JUDGED_AT, Clip, is_right, soccer_clips
from tests.bench.no_clicks.test_bench_proposals import Tally

ONLY = os.environ.get("CLIPS", "")
_EVERY, _SPACING_M = 10, 0.5


def in_sight(camera: Camera, size: tuple[int, int], field: Field) -> FrameAnnotation:
    """What a camera, in px of a picture of ``size``, shows of a field: points of each element."""
    shown, samples = scaled_camera(camera, size, JUDGED_AT), sample_evenly(field, _SPACING_M)
    right, bottom = (side - 1 for side in JUDGED_AT)
    found = []
    for name, index in field.index.items():
        px, ahead = shown.project(samples.of(index))
        inside = ahead & (px >= 0).all(axis=1) & (px <= (right, bottom)).all(axis=1)
        if inside.sum() >= 2:
            points = (px[inside] / (right, bottom)).tolist()
            found.append(Polyline(name, tuple(Point(x, y) for x, y in points)))
    return FrameAnnotation(tuple(found))


def _judges(clip: Clip, field: Field) -> dict[int, FrameAnnotation]:
    """Of every 10th frame that can be judged, what is listed."""
    judges = {}
    for frame in track_shot(clip.frame, range(clip.count), field).frames:
        if frame.number % _EVERY:
            continue
        if frame.number in clip.truth:
            judges[frame.number] = clip.truth[frame.number]
        elif frame.fit is not None and frame.fit.camera is not None:
            judges[frame.number] = in_sight(frame.fit.camera, clip.size, field)
    return judges


def test_every_tenth_frame(benchmark, shared_data):
    """Nothing known, each frame by itself."""
    soccer = load_field("soccer")

    def run() -> tuple[Tally, Tally]:
        by_paint, by_track = Tally(), Tally()
        for clip in soccer_clips(shared_data):
            if ONLY not in clip.name:
                continue
            for number, listed in _judges(clip, soccer).items():
                began = time.process_time()
                found = propose_camera(clip.frame(number), soccer)
                seconds = time.process_time() - began
                right = is_right(listed, found.fit.camera, clip.size, soccer)
                tally = by_paint if number in clip.truth else by_track
                tally.add(f"{clip.name} {number}", found, seconds, right=right)
        return by_paint, by_track

    by_paint, by_track = benchmark.pedantic(run, rounds=1)
    print(
        "\n| judged by | frames | right | wrong | none | sure | sure and wrong | s, median (most) |"
    )
    print(f"| paint | {by_paint.row()} |\n| the track | {by_track.row()} |")
    print(f"sure and wrong: {', '.join(by_paint.wrong + by_track.wrong) or 'none'}")
