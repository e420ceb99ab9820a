"""Real shots, and the places on their paint that cameras are judged by."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.camera.base import Camera, scaled_camera
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.image.pixels import PixelArray
from procc_annotator.image.video import open_shared_video
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.score import score
from procc_annotator.metrics.setup import EvaluationSetup

JUDGED_AT = (960, 540)
NEAR_PX, MOST_ELEMENTS = 10.0, 0.7  # of the listed elements, for a camera to be right
_FAR_PX = 1e4


@dataclass(frozen=True)
class Clip:
    """One shot of a main camera.

    Attributes:
        path: of the video.
        truth: number of a frame -> points on its paint; no frames where nobody measured any.
        field: name of its field.
    """

    path: Path
    truth: Mapping[int, FrameAnnotation]
    field: str = "soccer"

    @property
    def name(self) -> str:
        """Short, for tables."""
        return self.path.stem.removeprefix("soccer_")

    @property
    def count(self) -> int:
        """Number of frames."""
        return open_shared_video(self.path).frame_count

    @property
    def size(self) -> tuple[int, int]:
        """(width, height) px."""
        return open_shared_video(self.path).size

    def frame(self, number: int) -> PixelArray:
        """(H, W, 4) BGRA."""
        return open_shared_video(self.path).frame(number)


def soccer_clips(shared: Path) -> list[Clip]:
    """The nine shots of soccer."""
    folder = shared / "clips"
    points = json.loads((folder / "painted_points.json").read_text())
    found = []
    for path in sorted(folder.glob("soccer_*.mp4")):
        frames = points.get(path.stem, {})
        found.append(Clip(path, {int(n): _annotation(f["elements"]) for n, f in frames.items()}))
    return found


# Points read off the pictures enlarged 8 times, to about 0.5 px, in ten frames of each clip: paint,
# and edges between floors of two colours. Cameras fitted to them leave 0.3 to 1 px on average.
_HALL_POINTS = Path(__file__).parents[2] / "data" / "hall_points.json"
_HALL_FIELDS = {
    "tennis": "tennis",
    "volleyball": "volleyball",
    "basketball_nba": "basketball_nba",
    "hockey_nhl": "ice_hockey_nhl",
}


def hall_clips(shared: Path) -> list[Clip]:
    """One shot each of tennis, volleyball, basketball and ice hockey."""
    points = json.loads(_HALL_POINTS.read_text())
    return [
        Clip(
            shared / "clips" / f"{name}.mp4",
            {int(n): _annotation(elements) for n, elements in points[name].items()},
            field,
        )
        for name, field in _HALL_FIELDS.items()
    ]


def _annotation(elements: Mapping[str, list[list[float]]]) -> FrameAnnotation:
    return FrameAnnotation(
        tuple(
            Polyline(name, tuple(Point(x, y) for x, y in places))
            for name, places in elements.items()
        )
    )


def farthest(
    truth: FrameAnnotation, camera: Camera | None, size: tuple[int, int], field: Field
) -> np.ndarray:
    """The largest distance, px at `JUDGED_AT`, of each listed element's points to its projection;
    very far where the camera does not show it.

    Args:
        truth: the listed elements.
        camera: in px of a picture of ``size``; None for none.
        field: the elements.
    """
    listed = [p.class_name for p in truth.polylines]
    if camera is None:
        return np.full(len(listed), _FAR_PX)
    setup = EvaluationSetup(field, JUDGED_AT, "procc")
    measured = measure(truth, scaled_camera(camera, size, JUDGED_AT), setup)
    found = {e.annotated_name: e.max_distance for e in score(measured, NEAR_PX).elements}
    return np.array([_FAR_PX if found.get(n) is None else found[n] for n in listed], dtype=float)


def is_right(
    truth: FrameAnnotation, camera: Camera | None, size: tuple[int, int], field: Field
) -> bool:
    """Whether most of the listed elements are where a camera shows them; from the other side of a
    field that looks the same from there, too."""
    cameras = [camera]
    if isinstance(camera, PinholeCamera) and field.symmetries:
        cameras.append(half_turned(camera))
    return any(
        float(np.mean(farthest(truth, own, size, field) <= NEAR_PX)) >= MOST_ELEMENTS
        for own in cameras
    )


def half_turned(camera: PinholeCamera) -> PinholeCamera:
    """The camera half a turn about the field's centre."""
    x, y, z = camera.position_world
    return replace(camera, pan_rad=camera.pan_rad + np.pi, position_world=(-x, -y, z))
