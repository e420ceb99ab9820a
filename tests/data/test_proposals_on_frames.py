"""On a real frame the camera is found without a click."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np

from procc_annotator.calibration.single_image.propose import propose_camera
from procc_annotator.field.load import load_field
from procc_annotator.image.decoding import decode_bgra
from tests.bench.from_picture.truth import PaintedFrame, is_right


def test_the_camera_of_a_real_frame(shared_data: Path) -> None:
    field = load_field("soccer")
    picture = decode_bgra(shared_data / "frames" / "bra_mex.jpg")
    clicked = json.loads((shared_data / "frames" / "bra_mex.json").read_text("utf-8"))
    elements = {
        name: np.array([(point["x"], point["y"]) for point in points])
        for name, points in clicked.items()
    }
    found = propose_camera(picture, field)
    assert found.fit.camera is not None
    size = picture.shape[1], picture.shape[0]
    assert is_right(PaintedFrame("bra_mex", 0, elements), found.fit.camera, size, field)
