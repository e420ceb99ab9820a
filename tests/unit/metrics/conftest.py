"""A field and cameras small enough to reckon with by hand."""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import pytest

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.arrays import BoolArray, FloatArray
from procc_annotator.field.geometry import Circle, Geometry, Line
from procc_annotator.field.load import load_field
from procc_annotator.field.model import Element, Field, Symmetry

SIZE = (101, 51)

Points = Sequence[tuple[float, float]]
Annotate = Callable[[Mapping[str, Points]], FrameAnnotation]


@dataclass(frozen=True)
class MapCamera:
    """Looks straight down: a metre is a pixel; points below the ground (z > 0) are behind."""

    shift: tuple[float, float] = (0.0, 0.0)
    turned: bool = False
    ground_only: bool = False

    def project(self, points_world: FloatArray) -> tuple[FloatArray, BoolArray]:
        sign = -1.0 if self.turned else 1.0
        return sign * points_world[:, :2] + self.shift, points_world[:, 2] <= 0


def make_element(name: str, geometry: Geometry) -> Element:
    return Element(name, name, "test", "#ffffff", "", geometry)


def make_field(elements: Mapping[str, Geometry], mirror: Mapping[str, str]) -> Field:
    return Field(
        name="test",
        title="Test",
        dimensions=(),
        elements=tuple(make_element(name, shape) for name, shape in elements.items()),
        symmetries=(Symmetry(math.pi, mirror),) if mirror else (),
        classes_without_geometry=("Line unknown",),
    )


@pytest.fixture(scope="session")
def small_field() -> Field:
    """Two lines that mirror each other, a line and a circle in the centre, and a raised bar."""
    shapes: dict[str, Geometry] = {
        "left": Line((-20.0, -10.0, 0.0), (-20.0, 10.0, 0.0)),
        "right": Line((20.0, -10.0, 0.0), (20.0, 10.0, 0.0)),
        "middle": Line((0.0, -10.0, 0.0), (0.0, 10.0, 0.0)),
        "Circle": Circle((0.0, 0.0, 0.0), 9.0),
        "bar": Line((-20.0, -3.0, -2.0), (-20.0, 3.0, -2.0)),
    }
    mirror = {
        "left": "right",
        "right": "left",
        "middle": "middle",
        "Circle": "Circle",
        "bar": "bar",
    }
    return make_field(shapes, mirror)


@pytest.fixture(scope="session")
def one_line() -> Callable[[Line | Circle], Field]:
    """A field of a single element, "it", its own mirror image."""
    return lambda shape: make_field({"it": shape}, {"it": "it"})


@pytest.fixture(scope="session")
def soccer() -> Field:
    return load_field("soccer")


@pytest.fixture(scope="session")
def annotate() -> Annotate:
    """An annotation from points in pixels of a 101 x 51 picture (u * 100, v * 50)."""

    def build(polylines: Mapping[str, Points]) -> FrameAnnotation:
        return FrameAnnotation(
            tuple(
                Polyline(name, tuple(Point(x / 100, y / 50) for x, y in points))
                for name, points in polylines.items()
            )
        )

    return build


@pytest.fixture(scope="session")
def map_camera() -> type[MapCamera]:
    return MapCamera
