"""Places on the paint of real frames, measured by eye at 8x: numbers only, the pictures stay away.

One JSON a clip: of each frame its elements, with points on the middle of the paint (of an area: on
its edge), the direction there, and their true ends (with what they end at); places beside an
element where nothing of it can be seen ("hidden"), and bare ground ("bare").

Where two lines meet at a shallow angle, an eye sees the end to 3 px only: there both middles were
measured from 14 to 70 px beside it (half the height of profiles across), and continued straight.
"""

import json
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path

import numpy as np

from procc_annotator.annotation import Polyline, point_from_px
from procc_annotator.arrays import FloatArray
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Field
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.pixels import PixelArray
from procc_annotator.image.video import open_shared_video

FOLDER = Path(__file__).parents[2] / "data" / "paint"
_LONGEST_GAP_PX = 130.0  # between two points, over which a course may be drawn
_PER_GAP = 40


@dataclass(frozen=True, eq=False)
class Element:
    """What of one element (or of one side of it) can be seen.

    Attributes:
        name: its class.
        kind: "line", "dark line", "post", "crossbar", "edge" of an area, or "net".
        points: (n, 2) px on its paint, along it.
        along: (n, 2) unit vectors.
        ends: (m, 2) px, where it ends; as the middles of both paints meet.
    """

    name: str
    kind: str
    points: FloatArray
    along: FloatArray
    ends: FloatArray

    @property
    def across(self) -> FloatArray:
        """(n, 2) unit vectors."""
        return np.column_stack([-self.along[:, 1], self.along[:, 0]])

    @cached_property
    def course(self) -> FloatArray:
        """(n, 2) px: the element between its points, but for wide gaps; as smooth as paint."""
        pieces: list[FloatArray] = []
        t = np.linspace(0.0, 1.0, _PER_GAP)[:, None]
        for i in range(len(self.points) - 1):
            p, q = self.points[i], self.points[i + 1]
            length = float(np.hypot(*(q - p)))
            if length > _LONGEST_GAP_PX:
                continue
            # Hermite: through both points in their directions.
            u, v = length * self.along[i], length * self.along[i + 1]
            pieces.append(
                (2 * t**3 - 3 * t**2 + 1) * p
                + (t**3 - 2 * t**2 + t) * u
                + (3 * t**2 - 2 * t**3) * q
                + (t**3 - t**2) * v
            )
        return np.concatenate(pieces) if pieces else self.points

    def away(self, places: FloatArray) -> FloatArray:
        """(n,) px across from places to the course; NaN for those beside none of it."""
        if not len(places):
            return np.zeros(0)
        apart = np.hypot(*(places[:, None] - self.course[None]).transpose(2, 0, 1))
        nearest = apart.argmin(axis=1)
        step = np.gradient(self.course, axis=0)[nearest]
        step /= np.maximum(np.hypot(*step.T), 1e-9)[:, None]
        offset = places - self.course[nearest]
        along = np.abs((offset * step).sum(axis=1))
        across = np.abs(offset[:, 0] * step[:, 1] - offset[:, 1] * step[:, 0])
        return np.where(along > 4.0, np.nan, across)


@dataclass(frozen=True, eq=False)
class Places:
    """Places where a click is to stay: (n,) classes, (n, 2) px, (n, 2) directions."""

    names: tuple[str, ...]
    points: FloatArray
    along: FloatArray


@dataclass(frozen=True, eq=False)
class TruthFrame:
    """One annotated frame."""

    clip: str
    number: int
    sport: str
    size: tuple[int, int]
    elements: tuple[Element, ...]
    hidden: Places
    bare: Places

    @property
    def field(self) -> Field:
        return load_field(self.sport)

    def picture(self, shared_data: Path) -> PixelArray:
        """(H, W, 4) BGRA of the folder of real data."""
        still = shared_data / "frames" / f"{self.clip}.jpg"
        if still.is_file():
            return decode_bgra(still)
        return _frame(shared_data / "clips" / f"{self.clip}.mp4", self.number)

    def polyline(self, name: str, points: FloatArray) -> Polyline:
        return Polyline(name, tuple(point_from_px(x, y, self.size) for x, y in points.tolist()))


@cache
def _frame(clip: Path, number: int) -> PixelArray:
    return open_shared_video(clip).frame(number)


@cache
def truth_frames() -> tuple[TruthFrame, ...]:
    """All annotated frames, clip by clip."""
    return tuple(
        _of(services, int(number), frame)
        for path in sorted(FOLDER.glob("*.json"))
        for services in [json.loads(path.read_text())]
        for number, frame in services["frames"].items()
    )


def _of(services: dict, number: int, frame: dict) -> TruthFrame:
    elements = []
    for e in frame["elements"]:
        rows = np.array(e["points"], dtype=np.float64)
        ends = np.array([end[:2] for end in e["ends"]], dtype=np.float64).reshape(-1, 2)
        elements.append(Element(e["name"], e["kind"], rows[:, :2], rows[:, 2:], ends))
    width, height = frame["size"]
    return TruthFrame(
        services["clip"],
        number,
        services["field"],
        (width, height),
        tuple(elements),
        _places(frame["hidden"]),
        _places(frame["bare"]),
    )


def _places(rows: list) -> Places:
    numbers = np.array([row[1:] for row in rows], dtype=np.float64).reshape(-1, 4)
    return Places(tuple(row[0] for row in rows), numbers[:, :2], numbers[:, 2:])
