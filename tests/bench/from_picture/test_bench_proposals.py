"""Proposals on real shots: ``pytest tests/bench/from_picture --benchmark-only -s``.

Printed are figures of docs/camera_from_picture.md. Truth is where points were measured on paint.
"""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import numpy as np

from procc_annotator.calibration.single_image.propose import propose_camera
from procc_annotator.field.load import load_field
from procc_annotator.image.video import open_shared_video
from tests.bench.from_picture.truth import is_right, painted_frames

_EVERY = 20


def test_proposals_on_soccer_shots(benchmark: Any, shared_data: Path) -> None:
    """Right, wrong and none of every 20th frame, and how many of the sure ones are wrong."""
    field = load_field("soccer")

    def run() -> tuple[list[str], list[bool], list[float]]:
        states, right, seconds = [], [], []
        for frame in painted_frames(shared_data, _EVERY):
            picture = open_shared_video(shared_data / "clips" / f"{frame.clip}.mp4").frame(
                frame.number
            )
            size = picture.shape[1], picture.shape[0]
            began = time.process_time()
            found = propose_camera(picture, field)
            seconds.append(time.process_time() - began)
            camera = found.fit.camera
            states.append(found.state)
            right.append(camera is not None and is_right(frame, camera, size, field))
        return states, right, seconds

    states, found, seconds = benchmark.pedantic(run, rounds=1)
    right, sure = np.array(found), np.array([state == "sure" for state in states])
    none = np.array([state == "none" for state in states])
    print(
        f"\n{len(right)} frames: right {right.mean():.1%}, wrong {(~right & ~none).mean():.1%},"
        f" none {none.mean():.1%}; sure {sure.mean():.1%}, of these wrong {(sure & ~right).sum()};"
        f" {np.median(seconds):.2f} s of processor a frame, the first one {seconds[0]:.1f} s"
    )
    assert right.mean() >= 0.9
    assert (sure & ~right).sum() <= 0.01 * sure.sum()
