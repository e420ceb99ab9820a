"""Cameras of a shot that was followed: what of them is in doubt, and what a frame is told."""

from __future__ import annotations

import pytest

from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.tracking.track import FrameState, TrackedFrame
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.computed_cameras import TrackedCameras, review_reason

SIZE = (1280, 720)
CAMERA = PinholeCamera(0.1, 1.4, 0.0, (0.0, 60.0, -15.0), (1500.0, 1500.0), (639.5, 359.5))


def frame(
    state: FrameState = "followed", coverage: float = 0.9, residual_px: float | None = 0.4
) -> TrackedFrame:
    fit = None if state == "lost" else FitResult("R", SIZE, CAMERA)
    reason = "a close-up" if state == "lost" else ""
    return TrackedFrame(7, state, reason, fit, coverage, residual_px, 7)


@pytest.mark.parametrize(
    ("found", "doubt"),
    [
        (frame(), ""),
        (frame("anchor", coverage=0.1), ""),  # somebody clicked there
        (frame("lost"), "a close-up"),
        (frame("bridged"), "carried over by the picture's motion, not measured on paint"),
        (frame(coverage=0.59), "only 59% of the lines in sight are on paint"),
        (frame(residual_px=2.5), "the paint is 2.5 px from the lines"),
        (frame(residual_px=None), ""),
    ],
)
def test_what_should_be_looked_at(found, doubt) -> None:
    assert review_reason(found) == doubt


def test_a_camera_is_scaled_to_the_evaluation_and_bears_its_doubt() -> None:
    cameras = TrackedCameras({"a": frame(), "b": frame("bridged"), "c": frame("lost")})

    assert set(cameras.frames) == {"a", "b"}
    found = cameras.camera("a", (960, 540))
    assert isinstance(found.camera, PinholeCamera)
    assert found.camera.focal_px[0] == pytest.approx(1500 * 959 / 1279)
    assert found.notice is None
    doubtful = cameras.camera("b", (960, 540))
    assert "carried over" in str(doubtful.notice)
    assert cameras.camera("c", (960, 540)) is None
    assert cameras.why_none("c") == "no track here: a close-up"
    assert cameras.why_none("d") == "not followed so far"
