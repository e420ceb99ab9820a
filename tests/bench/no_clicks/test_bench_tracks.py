"""How well whole shots are followed: ``pytest tests/bench/no_clicks/test_bench_tracks.py
--benchmark-only -s``.

Listed elements count as within so many px, at 960x540, by their farthest point; those of frames
without a camera count as beyond. Doubtful: of the frames with a listed element more than 5 px off,
and of those with none more than 3 px off. Frames a second are those of the processor's time of one
core.
``CLIPS=River`` takes only clips with that in their names.
"""

import os
import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.tracking.shot_tracker import track_shot
from procc_annotator.calibration.tracking.track import Track, TrackedFrame
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.computed_cameras import review_reason
from procc_annotator.field.load import load_field
from tests.bench.no_clicks.clips import Clip, farthest, soccer_clips

WITHIN_PX = (2.0, 5.0, 10.0)
ONLY = os.environ.get("CLIPS", "")
_JUMP_PX = 10.0  # at 960 px


@dataclass(frozen=True)
class Followed:
    """A clip and its track."""

    clip: Clip
    track: Track
    seconds: float

    def distances(self) -> np.ndarray:
        """Of all listed elements, px at 960x540."""
        soccer = load_field("soccer")
        by_number = {frame.number: frame for frame in self.track.frames}
        found = [
            farthest(truth, _camera(by_number.get(number)), self.clip.size, soccer)
            for number, truth in self.clip.truth.items()
        ]
        return np.concatenate([*found, np.empty(0)])

    def doubted(self) -> np.ndarray:
        """Doubtful wrong frames, all wrong ones, doubtful right ones, all right ones."""
        counts = np.zeros(4, dtype=int)
        by_number = {frame.number: frame for frame in self.track.frames}
        for number, truth in self.clip.truth.items():
            frame, soccer = by_number[number], load_field("soccer")
            most = farthest(truth, _camera(frame), self.clip.size, soccer).max(initial=0.0)
            if most > 5 or most <= 3:
                counts[0 if most > 5 else 2] += bool(review_reason(frame))
                counts[1 if most > 5 else 3] += 1
        return counts

    @property
    def jumps(self) -> int:
        """Frames at which the camera leaps to another place and stays there."""
        return len(jumps_of(self.track.frames, self.clip.size[0]))

    def share(self, *states: str) -> float:
        return float(np.mean([frame.state in states for frame in self.track.frames]))


def _camera(frame: TrackedFrame | None) -> PinholeCamera | None:
    camera = frame.fit.camera if frame is not None and frame.fit is not None else None
    return camera if isinstance(camera, PinholeCamera) else None


def jumps_of(frames: Sequence[TrackedFrame], width_px: int) -> list[int]:
    """Numbers of the frames at which the axis goes much farther in one step than in those before
    and after; a frame that is shown twice makes shorter steps, not longer ones."""
    found = []
    for before, one, after, later in zip(frames, frames[1:], frames[2:], frames[3:], strict=False):
        cameras = [_camera(frame) for frame in (before, one, after, later)]
        if any(camera is None for camera in cameras):
            continue
        angles = np.array([(c.pan_rad, c.tilt_rad) for c in cameras if c is not None])
        angles[:, 0] = np.unwrap(angles[:, 0])
        assert cameras[1] is not None
        scale = cameras[1].focal_px[0] * 960 / width_px
        first, middle, last = np.hypot(*np.diff(angles, axis=0).T) * scale
        if middle > 2 * max(first, last) + _JUMP_PX:
            found.append(after.number)
    return found


def _followed(clip: Clip, anchors: dict[int, Any]) -> Followed:
    began = time.process_time()
    found = track_shot(clip.frame, range(clip.count), load_field("soccer"), anchors=anchors)
    return Followed(clip, found, time.process_time() - began)


@pytest.mark.parametrize("begin", ["no click", "one annotated frame"])
def test_tracks(benchmark, shared_data, begin):
    """Every clip from its own pictures alone, or from the frame with most listed elements."""
    soccer = load_field("soccer")

    def run() -> list[Followed]:
        rows = []
        for clip in soccer_clips(shared_data):
            if ONLY not in clip.name or (begin != "no click" and not clip.truth):
                continue
            anchors = {}
            if begin != "no click":
                number = max(clip.truth, key=lambda n: len(clip.truth[n].polylines))
                fit = fit_camera(clip.truth[number], soccer, size=clip.size)
                assert fit.camera is not None
                anchors[number] = fit.camera
            rows.append(_followed(clip, anchors))
            _print(rows[-1])
        return rows

    print(
        f"\nfrom {begin}\n| | <= 2 / 5 / 10 px % | followed | bridged | lost | jumps"
        " | doubtful: wrong, right | frames/s |"
    )
    rows = benchmark.pedantic(run, rounds=1)
    away = np.concatenate([row.distances() for row in rows])
    frames, seconds = (
        sum(of) for of in ([len(r.track.frames) for r in rows], [r.seconds for r in rows])
    )
    print(
        f"| all, {len(away)} elements | {_shares(away)} | {_mean(rows, 'anchor', 'followed')} |"
        f" {_mean(rows, 'bridged')} | {_mean(rows, 'lost')} | {sum(r.jumps for r in rows)} |"
        f" {_doubted(np.sum([r.doubted() for r in rows], axis=0))} | {frames / seconds:.1f} |"
    )


def _print(row: Followed) -> None:
    away = row.distances()
    print(
        f"| {row.clip.name} | {_shares(away)} | {100 * row.share('anchor', 'followed'):.0f} % |"
        f" {100 * row.share('bridged'):.0f} % | {100 * row.share('lost'):.0f} % | {row.jumps} |"
        f" {_doubted(row.doubted())} | {len(row.track.frames) / row.seconds:.1f} |",
        flush=True,
    )


def _doubted(counts: np.ndarray) -> str:
    return "{} of {}, {} of {}".format(*counts)


def _shares(away: np.ndarray) -> str:
    return " / ".join(f"{100 * np.mean(away <= px):.0f}" for px in WITHIN_PX) if len(away) else "–"


def _mean(rows: Sequence[Followed], *states: str) -> str:
    frames = [frame.state in states for row in rows for frame in row.track.frames]
    return f"{100 * np.mean(frames):.0f} %"
