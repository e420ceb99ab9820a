"""Soccer: a stadium with mown grass, goals with nets, two teams and a referee."""

from __future__ import annotations

import numpy as np

from drawing.grounds import grass
from drawing.paint import Stroke
from drawing.people import Kit, Person, looked_at
from drawing.scenery import Arena
from drawing.solids import Colour, PixelArray, Thing, blend, draw_bar, draw_thread
from drawing.sport import Sport
from drawing.surroundings import Side, Stands
from drawing.views import View, looking_at
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.geometry import Spot
from procc_annotator.field.load import load_field

LINE_WIDTH_M = 0.12
_PAINT = (226, 232, 230)
_MARKS = ((0.0, 0.0, 0.0), (-41.5, 0.0, 0.0), (41.5, 0.0, 0.0))
_MARK_WIDTH_M = 0.26
_GOAL_HALF, _GOAL_HEIGHT, _NET_DEPTH = 3.66, 2.44, 2.0
_NET: Colour = (222, 222, 222)
_HOME = Kit((40, 40, 190), (230, 230, 230))
_AWAY = Kit((205, 205, 210), (120, 50, 30))
_REFEREE = Kit((40, 210, 225), (30, 30, 30))
_KEEPER = Kit((60, 190, 60), (40, 40, 40))

# The official classes are drawn with their lines' middle on the geometry, as they are annotated.
ARENA = Arena(
    ground=grass,
    strokes=(
        *(
            Stroke(e.geometry, LINE_WIDTH_M, _PAINT)
            for e in load_field("soccer").elements
            if e.on_ground and not e.optional
        ),
        *(Stroke(Spot(mark), _MARK_WIDTH_M, _PAINT) for mark in _MARKS),
    ),
    sides=(
        Side((0, -1), 38.5, 43.0, 30.0, 57.5),
        Side((-1, 0), 57.5, 63.0, 26.0, 38.5),
        Side((1, 0), 57.5, 63.0, 26.0, 38.5),
        Side((0, 1), 39.5, 44.0, 24.0, 57.5),
    ),
    stands=Stands(
        first_row_m=1.2,
        slope=0.55,
        stairs_m=14.0,
        light=1.0,
        empty=0.16,
        board_height_m=0.95,
        board_length_m=11.0,
        boards=(
            ("PROCC", (120, 40, 20)),
            ("FIELD LINES", (30, 30, 160)),
            ("CLICK TWICE", (40, 40, 40)),
            ("JAC 1.00", (20, 110, 150)),
        ),
    ),
)
MAIN = (0.0, 62.0, -17.0)


def views() -> tuple[View, ...]:
    """All frames of the sample, in order."""
    cameras = [
        looking_at(MAIN, (0, 2, 0), 1150, k1=0.16),
        looking_at(MAIN, (-36, -2, 0), 1500, k1=0.22, roll_degrees=0.3),
        looking_at(MAIN, (36, 0, 0), 1450),
        looking_at(MAIN, (-19, 0, 0), 1300, k1=0.18),
        looking_at(MAIN, (22, -4, 0), 1700, k1=0.3),
        looking_at(MAIN, (41, 4, 0), 2300, k1=0.5, roll_degrees=-0.4),
        looking_at((-36.0, 58.0, -12.0), (-41, 4, 0), 1250, k1=0.2),
        looking_at((36.0, 58.0, -12.0), (43, -2, 0), 1500),
        looking_at((-78.0, 2.0, -19.0), (-38, 0, 0), 1000, k1=0.12),
        looking_at((82.0, -4.0, -21.0), (40, 2, 0), 1150),
        looking_at(MAIN, (-47, 2, -1), 3600),
        looking_at((60.0, 24.0, -5.0), (49, -2, 0), 1500, k1=0.15),
        looking_at(MAIN, (3, 4, 0), 2500, k1=0.4),
        looking_at(MAIN, (-43, 12, 0), 1900, k1=0.35),
    ]
    unannotated = {5, 10, 14}
    without_bad_camera = {4, 9, 12}
    return tuple(
        View(f"{i:05d}", camera, i not in unannotated, i not in without_bad_camera)
        for i, camera in enumerate(cameras, 1)
    )


def people(camera: PinholeCamera, seed: int) -> list[Person]:
    """Two teams and a referee around what a camera looks at, and the keepers."""
    random = np.random.default_rng(seed + 5)
    towards = looked_at(camera, (45, 28))
    pitch = (51, 33)
    found = []
    for i in range(22):
        spot = np.clip(towards + random.normal(0, 1, 2) * (17, 12), np.negative(pitch), pitch)
        found.append(Person(spot, _HOME if i % 2 else _AWAY, random.uniform(0, 6.28)))
    spot = np.clip(towards + random.normal(0, 8, 2), np.negative(pitch), pitch)
    found.append(Person(spot, _REFEREE, 1.0))
    for sign in (-1, 1):
        spot = np.array([sign * (50.5 - random.uniform(0, 2)), random.uniform(-2, 2)])
        found.append(Person(spot, _KEEPER, random.uniform(0, 6.28)))
    return found


def draw_goal(picture: PixelArray, camera: PinholeCamera, sign: int) -> None:
    """Paint the left (-1) or right (1) goal into a picture."""
    x = sign * 52.5
    blend(picture, lambda layer: _draw_net(layer, camera, sign), 0.42)
    for y in (-_GOAL_HALF, _GOAL_HALF):
        draw_bar(picture, camera, [(x, y, 0), (x, y, -_GOAL_HEIGHT)], LINE_WIDTH_M)
    end = _GOAL_HALF + LINE_WIDTH_M / 2  # the crossbar lies on the posts, corners closed
    crossbar = [(x, -end, -_GOAL_HEIGHT), (x, end, -_GOAL_HEIGHT)]
    draw_bar(picture, camera, crossbar, LINE_WIDTH_M)


def _draw_net(picture: PixelArray, camera: PinholeCamera, sign: int) -> None:
    def thread(points: list[tuple[float, float, float]]) -> None:
        draw_thread(picture, camera, points, _NET)

    x, back = sign * 52.5, sign * (52.5 + _NET_DEPTH)
    low, ends = _GOAL_HEIGHT * 0.92, (-_GOAL_HALF, _GOAL_HALF)
    across = np.linspace(*ends, 12)
    for y in np.linspace(*ends, 37):
        thread([(back, y, z) for z in np.linspace(0, -low, 8)])
        thread([(back, y, -low), (x, y, -_GOAL_HEIGHT)])
    for z in np.linspace(0, low, 13):
        thread([(back, y, -z) for y in across])
        for y in ends:
            thread([(x, y, -z), (back, y, -z)])
    for depth in np.linspace(0.2, 1, 8):
        along = x + (back - x) * depth
        height = _GOAL_HEIGHT * (1 - 0.08 * depth)
        thread([(along, y, -height) for y in across])
        for y in ends:
            thread([(along, y, 0), (along, y, -height)])


def things(camera: PinholeCamera, seed: int) -> list[Thing]:
    """Goals and people."""
    goals = [
        Thing((sign * 53.0, 0.0), lambda p, c, sign=sign: draw_goal(p, c, sign)) for sign in (-1, 1)
    ]
    return [*goals, *(person.thing() for person in people(camera, seed))]


SOCCER = Sport(
    field_name="soccer",
    folder="",
    views=views(),
    arena=ARENA,
    things=things,
    sets=("true", "homography", "pinhole", "bad"),
    shortest_px=14.0,
    absent=frozenset(e.name for e in load_field("soccer").elements if e.optional),
)
