"""Basketball: a wooden floor with coloured keys and border, baskets, boards on three sides."""

from __future__ import annotations

import numpy as np

from drawing.gloss import Gloss
from drawing.grounds import planks
from drawing.paint import Area, Disc, Rectangle, strokes_of
from drawing.people import Kit, Person, looked_at
from drawing.scenery import Arena
from drawing.solids import (
    PixelArray,
    Thing,
    blend,
    draw_bar,
    draw_box,
    draw_frame,
    draw_sheet,
    draw_thread,
)
from drawing.sport import Sport
from drawing.surroundings import Side, Stands
from drawing.views import View, looking_at
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field

_FIELD = load_field("basketball_fiba")
_BLUE, _GREY = (104, 58, 26), (70, 66, 64)
_HALF_LENGTH, _HALF_WIDTH, _FRONT, _KEY_HALF = 14.0, 7.5, 8.2, 2.45
_KEYS = ((-_HALF_LENGTH, -_FRONT), (_FRONT, _HALF_LENGTH))
_BOARD_X, _BASKET_X, _RIM_Z, _RIM_RADIUS = 12.8, 12.425, -3.05, 0.225
_TUBE_M, _LINE_M = 0.018, 0.05
_BORDER = 2.05
_ORANGE, _STAND_BLUE, _STEEL = (30, 90, 235), (120, 66, 30), (60, 60, 62)
_HOME = Kit((225, 225, 228), (225, 225, 228), socks=0.25, shade=(60, 80, 100))
_AWAY = Kit((60, 120, 30), (60, 120, 30), socks=0.25, shade=(60, 80, 100))
_REFEREE = Kit((150, 150, 152), (36, 36, 36), socks=0.08, legs=(36, 36, 36), shade=(60, 80, 100))

ARENA = Arena(
    ground=planks((88, 138, 182)),
    areas=(
        *(Area(Rectangle(x, (-_KEY_HALF, _KEY_HALF)), _BLUE, 0.9) for x in _KEYS),
        Area(Disc((0.0, 0.0), 1.8), _BLUE, 0.9),
        Area(Rectangle((-14.0, 14.0), (-7.5, 7.5)), _BLUE, 0.9, outside=True),
        Area(
            Rectangle(
                (-_HALF_LENGTH - _BORDER, _HALF_LENGTH + _BORDER),
                (-_HALF_WIDTH - _BORDER, _HALF_WIDTH + _BORDER),
            ),
            _GREY,
            outside=True,
        ),
    ),
    strokes=tuple(strokes_of(_FIELD.elements, {"": (232, 234, 232)})),
    opacity=0.95,
    sides=(
        Side((0, -1), 10.6, 13.0, 22.0, 15.2),
        Side((-1, 0), 18.9, 20.5, 20.0, 9.4),
        Side((1, 0), 18.9, 20.5, 20.0, 9.4),
        Side((0, 1), None, 13.0, 9.0, 15.2),
    ),
    stands=Stands(
        first_row_m=0.6,
        slope=0.5,
        stairs_m=9.0,
        light=0.62,
        empty=0.2,
        board_height_m=0.8,
        board_length_m=6.0,
        front=(46, 40, 36),
        boards=(
            ("THREE POINTS", (24, 24, 26)),
            ("PROCC", (30, 60, 190)),
            ("CLICK TWICE", (130, 90, 10)),
            ("PICK AND ROLL", (40, 110, 30)),
        ),
    ),
    above=(20, 18, 17),
    gloss=Gloss(
        lamp_height_m=11.0,
        spacing_m=(5.0, 4.5),
        lamp_size_m=0.5,
        brightness=170.0,
        roughness_rad=0.022,
        mirror=0.05,
        blur_px=7.0,
    ),
)


def views() -> tuple[View, ...]:
    """All frames, in order."""
    main = (0.0, 21.5, -6.5)
    cameras = [
        looking_at(main, (0.0, -0.6, 0.0), 700, k1=0.04),
        looking_at(main, (-8.6, -0.8, -0.6), 900, k1=0.1, roll_degrees=0.3),
        looking_at(main, (8.8, -0.4, -0.8), 980),
        looking_at((17.6, -5.6, -1.5), (6.0, 0.4, -1.25), 640, k1=0.03),
        looking_at((-24.5, 1.5, -7.6), (-8.0, 0.0, -0.6), 1000, k1=0.12, roll_degrees=-0.4),
        looking_at((9.5, 18.0, -4.4), (10.2, -0.5, -1.2), 840, k1=0.08),
    ]
    return tuple(
        View(f"{i:05d}", camera, annotated=i != 6, bad_camera=i != 4)
        for i, camera in enumerate(cameras, 1)
    )


def _draw_basket(picture: PixelArray, camera: PinholeCamera, sign: int) -> None:
    """The left (-1) or right (1) basket; what is farther first."""
    from_behind = camera.position_world[0] * sign > _BOARD_X
    stages = [_draw_stand, _draw_board, _draw_rim]
    for draw in reversed(stages) if from_behind else stages:
        draw(picture, camera, sign)


def _draw_stand(picture: PixelArray, camera: PinholeCamera, sign: int) -> None:
    near, far = sorted((sign * 16.2, sign * 18.0))
    draw_box(picture, camera, (near, -0.5, 0.0), (far, 0.5, -1.2), _STAND_BLUE)
    behind = _BOARD_X + 0.1
    draw_bar(picture, camera, [(sign * 17.0, 0, -1.2), (sign * behind, 0, -2.95)], 0.1, _STEEL)
    draw_bar(picture, camera, [(sign * 16.6, 0, -1.2), (sign * behind, 0, -3.6)], 0.14, _STEEL)
    for y in (-0.5, 0.5):
        ends = [(sign * behind, y, -3.0), (sign * behind, y, -3.85)]
        draw_bar(picture, camera, ends, 0.05, _STEEL)
    for z in (-3.0, -3.6):
        ends = [(sign * behind, -0.5, z), (sign * behind, 0.5, z)]
        draw_bar(picture, camera, ends, 0.06, _STEEL)


def _upright(x: float, half: float, low: float, high: float) -> list[tuple[float, float, float]]:
    return [(x, -half, -high), (x, half, -high), (x, half, -low), (x, -half, -low)]


def _draw_board(picture: PixelArray, camera: PinholeCamera, sign: int) -> None:
    whole = _upright(sign * _BOARD_X, 0.9, 2.9, 3.95)
    draw_sheet(picture, camera, whole, (214, 208, 200), opacity=0.3)
    draw_frame(picture, camera, whole, _LINE_M)
    draw_frame(picture, camera, _upright(sign * _BOARD_X, 0.295, 3.0, 3.45), _LINE_M)


def _draw_rim(picture: PixelArray, camera: PinholeCamera, sign: int) -> None:
    """The rules measure the ring's inner edge, and its height at the top of the tube."""
    angles = np.linspace(0, 2 * np.pi, 73)

    def ring(radius: float, z: float) -> list[tuple[float, float, float]]:
        places = zip(np.cos(angles), np.sin(angles), strict=True)
        return [(sign * _BASKET_X + radius * c, radius * s, z) for c, s in places]

    def net(layer: PixelArray) -> None:
        for i in range(0, 72, 6):
            for way in (-6, 6):
                rows = [(0.23, 0.02, 0), (0.17, 0.17, 1), (0.13, 0.3, 2), (0.115, 0.42, 3)]
                turns = [(r, z, angles[0] + np.radians(5 * (i + way * k / 2))) for r, z, k in rows]
                points = [
                    (sign * _BASKET_X + r * np.cos(a), r * np.sin(a), _RIM_Z + z)
                    for r, z, a in turns
                ]
                draw_thread(layer, camera, points, (235, 235, 235))

    blend(picture, net, 0.75)
    arm = [
        (x, y, _RIM_Z + 0.03)
        for x, y in (
            (sign * _BOARD_X, -0.08),
            (sign * _BOARD_X, 0.08),
            (sign * (_BASKET_X + _RIM_RADIUS), 0.08),
            (sign * (_BASKET_X + _RIM_RADIUS), -0.08),
        )
    ]
    draw_sheet(picture, camera, arm, _ORANGE)
    tube = ring(_RIM_RADIUS + _TUBE_M / 2, _RIM_Z + _TUBE_M / 2)
    draw_bar(picture, camera, tube, _TUBE_M, _ORANGE)


def things(camera: PinholeCamera, seed: int) -> list[Thing]:
    """Baskets, two teams of five and two referees."""
    random = np.random.default_rng(seed + 5)
    towards = looked_at(camera, (9.5, 2.0), 22.0 if camera.position_world[2] < -3 else 9.0)
    court = (13.4, 6.9)
    found = [
        Thing((sign * 13.4, 0.0), lambda p, c, sign=sign: _draw_basket(p, c, sign))
        for sign in (-1, 1)
    ]
    for i in range(12):
        spread = (3.2, 3.4) if i < 10 else (5.0, 6.0)
        spot = np.clip(towards + random.normal(0, 1, 2) * spread, np.negative(court), court)
        kit = _REFEREE if i >= 10 else _HOME if i % 2 else _AWAY
        found.append(Person(spot, kit, random.uniform(0, 6.28)).thing())
    return found


BASKETBALL = Sport(
    field_name="basketball_fiba",
    folder="basketball",
    views=views(),
    arena=ARENA,
    things=things,
    sets=("true", "pinhole", "bad", "late", "turned"),
    noise=1.3,
    jpeg_quality=90,
)
