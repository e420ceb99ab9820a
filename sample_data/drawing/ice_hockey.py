"""Ice hockey: white ice with red and blue lines, boards with rounded corners, glass, goals."""

from __future__ import annotations

import numpy as np

from drawing.gloss import Gloss
from drawing.grounds import ice
from drawing.paint import Area, Colour, Disc, RoundedRectangle, Stroke, strokes_of
from drawing.people import Kit, Person, looked_at
from drawing.rink import Rink
from drawing.scenery import Arena
from drawing.solids import PixelArray, Thing, blend, draw_bar, draw_thread
from drawing.sport import Sport
from drawing.surroundings import Side, Stands
from drawing.views import View, looking_at
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.geometry import Arc, Line, Spot
from procc_annotator.field.load import load_field

_FIELD = load_field("ice_hockey_iihf")
# A rink has one referee crease, on the scorekeeper's side: here the near one.
_ABSENT = frozenset({"Referee crease top"})
_RED: Colour = (52, 44, 188)
_BLUE: Colour = (158, 84, 34)
_CREASE_BLUE: Colour = (226, 190, 138)
_GOAL_LINE, _GOAL_HALF, _GOAL_HEIGHT, _NET_DEPTH = 26.0, 0.915, 1.22, 1.12
_POST_M = 0.06
_SPOT_RADIUS, _CENTRE_SPOT_RADIUS = 0.3, 0.15
_SHADE = (150, 146, 142)
_HOME = Kit(
    (40, 36, 176),
    (36, 34, 34),
    0.5,
    legs=(36, 34, 34),
    helmet=(36, 34, 34),
    stick=True,
    shade=_SHADE,
)
_AWAY = Kit(
    (236, 236, 232),
    (130, 60, 20),
    0.5,
    legs=(130, 60, 20),
    helmet=(236, 236, 232),
    stick=True,
    shade=_SHADE,
)
_REFEREE = Kit(
    (70, 70, 72), (24, 24, 24), 0.08, legs=(24, 24, 24), helmet=(24, 24, 24), shade=_SHADE
)
_BLUE_LINES = ("Line blue left", "Line blue right", "Circle centre")
_STANDS = Stands(
    first_row_m=1.3,
    slope=0.5,
    stairs_m=10.0,
    light=0.66,
    empty=0.15,
    board_height_m=0.6,
    board_length_m=165.407 / 28,  # a whole number of them goes around
    boards=(
        ("PROCC", (150, 60, 20)),
        ("POWER PLAY", (30, 30, 32)),
        ("CLICK TWICE", (40, 40, 170)),
        ("BLUE LINE", (60, 110, 30)),
    ),
    front=(58, 50, 44),
)


def _boards() -> tuple[Line | Arc, ...]:
    def part(name: str) -> Line | Arc:
        geometry = _FIELD.elements[_FIELD.index[f"Board {name}"]].geometry
        assert isinstance(geometry, Line | Arc)
        return geometry

    def backwards(name: str) -> Line:
        line = part(name)
        assert isinstance(line, Line)
        return Line(line.end, line.start)

    return (
        part("side top"),
        part("corner right top"),
        part("end right"),
        part("corner right bottom"),
        backwards("side bottom"),
        part("corner left bottom"),
        backwards("end left"),
        part("corner left top"),
    )


def _spots() -> list[Area]:
    areas = []
    for element in _FIELD.elements:
        if isinstance(element.geometry, Spot):
            x, y, _ = element.geometry.position
            centre = element.name == "Spot centre"
            radius = _CENTRE_SPOT_RADIUS if centre else _SPOT_RADIUS
            areas.append(Area(Disc((x, y), radius), _BLUE if centre else _RED, 0.85))
    return areas


def _angles_beside(x: float, y: float) -> list[Stroke]:
    """The four angles at an end face-off spot that players line up at."""
    strokes = []
    for sx in (-1, 1):
        for sy in (-1, 1):
            corner = (x + sx * 0.6, y + sy * 0.25, 0.0)
            along = (corner[0] + sx * 1.2, corner[1], 0.0)
            aside = (corner[0], corner[1] + sy * 0.9, 0.0)
            strokes += [Stroke(Line(corner, end), 0.05, _RED) for end in (along, aside)]
    return strokes


def _crease(sign: int) -> Area:
    x = (0.0, _GOAL_LINE) if sign > 0 else (-_GOAL_LINE, 0.0)
    return Area(Disc((sign * _GOAL_LINE, 0.0), 1.83, x, (-1.22, 1.22)), _CREASE_BLUE, 0.8)


_RINK = Rink(_boards(), height_m=1.07, glass_m=1.8, look=_STANDS)
ARENA = Arena(
    ground=ice,
    areas=(_crease(-1), _crease(1), *_spots()),
    beyond=(Area(RoundedRectangle((30.0, 15.0), 8.5), (66, 62, 60), outside=True),),
    strokes=(
        *strokes_of(
            (e for e in _FIELD.elements if e.name not in _ABSENT),
            {"": _RED, **dict.fromkeys(_BLUE_LINES, _BLUE)},
        ),
        *(s for x in (-20.0, 20.0) for y in (-7.0, 7.0) for s in _angles_beside(x, y)),
    ),
    opacity=0.86,
    sides=(
        Side((0, -1), None, 17.0, 26.0, 34.0),
        Side((-1, 0), None, 32.5, 24.0, 18.0),
        Side((1, 0), None, 32.5, 24.0, 18.0),
        Side((0, 1), None, 17.0, 16.0, 34.0),
    ),
    stands=_STANDS,
    above=(26, 23, 21),
    gloss=Gloss(
        lamp_height_m=14.0,
        spacing_m=(7.0, 6.0),
        lamp_size_m=0.8,
        brightness=190.0,
        roughness_rad=0.03,
        mirror=0.03,
        blur_px=9.0,
    ),
    rink=_RINK,
)


def views() -> tuple[View, ...]:
    """All frames, in order."""
    main = (0.0, 35.0, -13.0)
    cameras = [
        looking_at(main, (0.0, -2.4, 0.0), 800, k1=0.05),
        looking_at(main, (-18.5, -2.0, 0.0), 1050, k1=0.12, roll_degrees=0.3),
        looking_at(main, (20.0, -1.0, 0.0), 1150),
        looking_at((-45.0, 2.0, -12.5), (-20.0, 0.0, 0.0), 850, k1=0.08, roll_degrees=-0.3),
        looking_at((25.0, 27.5, -8.0), (21.0, -1.5, 0.0), 820, k1=0.06),
    ]
    return tuple(
        View(f"{i:05d}", camera, annotated=i != 5, bad_camera=i != 3)
        for i, camera in enumerate(cameras, 1)
    )


def _draw_goal(picture: PixelArray, camera: PinholeCamera, sign: int) -> None:
    x, back = sign * _GOAL_LINE, sign * (_GOAL_LINE + _NET_DEPTH)
    ends = (-_GOAL_HALF, _GOAL_HALF)

    def net(layer: PixelArray) -> None:
        white = (244, 244, 244)
        for y in np.linspace(*ends, 19):
            top = (sign * (_GOAL_LINE + 0.5), y, -_GOAL_HEIGHT)
            draw_thread(layer, camera, [(x, y, -_GOAL_HEIGHT), top, (back, y, 0)], white)
        for share in np.linspace(0, 1, 13):
            depth = 0.5 + (_NET_DEPTH - 0.5) * share
            along, z = sign * (_GOAL_LINE + depth), -_GOAL_HEIGHT * (1 - share)
            draw_thread(layer, camera, [(along, y, z) for y in np.linspace(*ends, 8)], white)
            for y in ends:
                draw_thread(layer, camera, [(x, y, z), (along, y, z)], white)

    blend(picture, net, 0.6)
    low = [
        (x, -_GOAL_HALF, -0.02),
        (back, -_GOAL_HALF, -0.02),
        (back, _GOAL_HALF, -0.02),
        (x, _GOAL_HALF, -0.02),
    ]
    draw_bar(picture, camera, low[:2], _POST_M, (230, 230, 230))
    draw_bar(picture, camera, low[1:3], _POST_M, (230, 230, 230))
    draw_bar(picture, camera, low[2:], _POST_M, (230, 230, 230))
    red = (44, 36, 200)
    for y in ends:
        draw_bar(picture, camera, [(x, y, 0), (x, y, -_GOAL_HEIGHT)], _POST_M, red)
    end = _GOAL_HALF + _POST_M / 2
    crossbar = [(x, -end, -_GOAL_HEIGHT), (x, end, -_GOAL_HEIGHT)]
    draw_bar(picture, camera, crossbar, _POST_M, red)


def things(camera: PinholeCamera, seed: int) -> list[Thing]:
    """Goals, two teams of five, their keepers, two referees."""
    random = np.random.default_rng(seed + 5)
    towards = looked_at(camera, (18.0, 3.0), 60.0)
    rink = (26.5, 11.0)
    found = [
        Thing((sign * (_GOAL_LINE + 0.5), 0.0), lambda p, c, sign=sign: _draw_goal(p, c, sign))
        for sign in (-1, 1)
    ]
    for i in range(12):
        spot = np.clip(towards + random.normal(0, 1, 2) * (6.0, 5.0), np.negative(rink), rink)
        kit = _REFEREE if i >= 10 else _HOME if i % 2 else _AWAY
        found.append(Person(spot, kit, random.uniform(0, 6.28)).thing())
    for sign, kit in ((-1, _HOME), (1, _AWAY)):
        spot = np.array([sign * (_GOAL_LINE - 0.9), random.uniform(-0.5, 0.5)])
        found.append(Person(spot, kit, random.uniform(0, 6.28)).thing())
    return found


ICE_HOCKEY = Sport(
    field_name="ice_hockey_iihf",
    folder="ice_hockey",
    views=views(),
    arena=ARENA,
    things=things,
    sets=("true", "pinhole", "bad", "late", "turned"),
    noise=1.3,
    jpeg_quality=90,
    hidden=_RINK.hides,
    absent=_ABSENT,
)
