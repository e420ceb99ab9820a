"""Make a small dataset of one instant seen by three cameras: two wide views and a close-up.

    python docs/examples/three_views.py match/

The pictures are drawn from known cameras, the clicks are 1 px off, as a hand is. Six places of the
stand are clicked in every view; the close-up sees one touchline and the end of the halfway line,
which is too little for a camera. docs/how-to/triangulate-landmarks.md goes on from here.
"""

from __future__ import annotations

import argparse
import json
import math
from pathlib import Path

import cv2
import numpy as np

from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.soccernet import write_camera
from procc_annotator.metrics.projection import project_field
from procc_annotator.metrics.setup import EvaluationSetup

SIZE = (960, 540)
CLICK_PX = 1.0
LANDMARKS = {
    "Board": (9.0, -38.5, -1.0),
    "Clock": (12.0, -52.0, -11.0),
    "Mast": (14.5, -60.0, -11.0),
    "Seat A": (6.0, -46.0, -4.0),
    "Seat B": (20.0, -47.0, -7.0),
    "Tunnel": (19.0, -40.0, -2.2),
}


def looking(
    position: tuple[float, float, float], target: tuple[float, float, float], focal_px: float
) -> PinholeCamera:
    """A level camera at a place (metres, z down) with a target in the middle of its picture."""
    x, y, z = np.subtract(target, position)
    pan, tilt = math.atan2(x, -y), math.atan2(math.hypot(x, y), z)
    middle = ((SIZE[0] - 1) / 2, (SIZE[1] - 1) / 2)
    return PinholeCamera(pan, tilt, 0.0, position, (focal_px, focal_px), middle)


CAMERAS = {
    "17_left": looking((-45.0, 62.0, -18.0), (0.0, -15.0, -2.0), 800.0),
    "17_right": looking((45.0, 62.0, -18.0), (5.0, -15.0, -2.0), 850.0),
    "17_close": looking((5.0, 70.0, -20.0), (14.0, -44.0, -6.0), 3200.0),
}


def make_dataset(folder: Path, seed: int = 4) -> None:
    """Write pictures, ``annotations/`` and the true ``cameras/``."""
    rng = np.random.default_rng(seed)
    for inner in ("annotations", "cameras"):
        (folder / inner).mkdir(parents=True, exist_ok=True)
    for name, camera in CAMERAS.items():
        lines, places = _seen(camera)
        clicked = {
            of: _clicks(points[np.linspace(0, len(points) - 1, 8).astype(int)], rng)
            for of, points in lines.items()
        }
        clicked |= {of: _clicks(place[None], rng) for of, place in places.items()}
        annotation = json.dumps(clicked, indent=1)
        (folder / "annotations" / f"{name}.json").write_text(annotation)
        told = {"image_width": SIZE[0], "image_height": SIZE[1]}
        (folder / "cameras" / f"camera_{name}.json").write_bytes(write_camera(camera, told))
        cv2.imwrite(str(folder / f"{name}.jpg"), _drawn(lines, places))


def _seen(camera: PinholeCamera) -> tuple[dict[str, np.ndarray], dict[str, np.ndarray]]:
    """Polylines of the elements that every field has, and the landmarks; px."""
    field = load_field("soccer")
    projected = project_field(camera, EvaluationSetup(field, SIZE, "procc"))
    usual = {e.name for e in field.elements if not e.optional}
    lines = {name: pieces[0] for name, pieces in projected.pieces.items() if name in usual}
    px, _ = camera.project(np.array(list(LANDMARKS.values())))
    return lines, dict(zip(LANDMARKS, px, strict=True))


def _clicks(points_px: np.ndarray, rng: np.random.Generator) -> list[dict[str, float]]:
    moved = points_px + rng.normal(0.0, CLICK_PX, points_px.shape)
    return [{"x": x / (SIZE[0] - 1), "y": y / (SIZE[1] - 1)} for x, y in moved.tolist()]


def _drawn(lines: dict[str, np.ndarray], places: dict[str, np.ndarray]) -> np.ndarray:
    picture = np.full((SIZE[1], SIZE[0], 3), (58, 110, 62), dtype=np.uint8)
    for points in lines.values():
        course = np.round(points * 16).astype(np.int32)
        cv2.polylines(picture, [course], False, (245, 245, 245), 2, cv2.LINE_AA, 4)
    for place in places.values():
        centre = tuple(np.round(place * 16).astype(int).tolist())
        cv2.circle(picture, centre, 4 * 16, (40, 40, 200), -1, cv2.LINE_AA, 4)
    return picture


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", type=Path, default=Path("match"), help="made anew")
    make_dataset(parser.parse_args().folder)
