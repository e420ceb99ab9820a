"""Volleyball: an orange court in a coloured free zone, a net with its antennae, posts."""

from __future__ import annotations

import numpy as np

from drawing.gloss import Gloss
from drawing.grounds import sheet
from drawing.paint import Area, Rectangle, strokes_of
from drawing.people import Kit, Person
from drawing.scenery import Arena
from drawing.solids import (
    PixelArray,
    Thing,
    blend,
    draw_bar,
    draw_box,
    draw_sheet,
    draw_thread,
)
from drawing.sport import Sport
from drawing.surroundings import Side, Stands
from drawing.views import View, looking_at
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.load import load_field

_ORANGE, _TEAL, _GREY = (52, 108, 204), (122, 112, 34), (74, 70, 68)
_HALF_LENGTH, _HALF_WIDTH = 9.0, 4.5
_NET_TOP, _NET_BOTTOM, _NET_HALF, _POST_Y = 2.43, 1.43, 5.0, 5.5
_TOP_BAND_M, _BOTTOM_BAND_M, _MESH_M = 0.07, 0.05, 0.1
_ANTENNA_M, _ANTENNA_TOP, _STRIPE_M = 0.01, 3.23, 0.1
_POST_M, _POST_TOP = 0.1, 2.55
_CANVAS, _THREAD, _RED = (240, 240, 240), (52, 50, 50), (40, 36, 200)
_POST_BLUE, _CHAIR = (150, 84, 30), (96, 92, 90)
_SHADE = (70, 70, 80)
_HOME = Kit((170, 60, 30), (30, 28, 28), socks=0.3, shade=_SHADE)
_AWAY = Kit((236, 236, 236), (60, 40, 160), socks=0.3, shade=_SHADE)
_LIBERO = Kit((40, 200, 230), (30, 28, 28), socks=0.3, shade=_SHADE)
_JUDGE = Kit((150, 60, 50), (40, 38, 38), socks=0.08, legs=(40, 38, 38), shade=_SHADE)

ARENA = Arena(
    ground=sheet(_ORANGE),
    areas=(
        Area(Rectangle((-9.0, 9.0), (-4.5, 4.5)), _TEAL, 0.97, outside=True),
        Area(Rectangle((-15.5, 15.5), (-9.5, 9.5)), _GREY, outside=True),
    ),
    strokes=tuple(strokes_of(load_field("volleyball").elements, {"": (236, 238, 236)})),
    opacity=0.97,
    sides=(
        Side((0, -1), 9.9, 12.5, 22.0, 15.0),
        Side((-1, 0), 16.0, 18.5, 20.0, 9.0),
        Side((1, 0), 16.0, 18.5, 20.0, 9.0),
        Side((0, 1), 9.9, 12.5, 10.0, 15.0),
    ),
    stands=Stands(
        first_row_m=1.4,
        slope=0.5,
        stairs_m=8.0,
        light=0.66,
        empty=0.26,
        board_height_m=0.9,
        board_length_m=7.0,
        boards=(
            ("SET POINT", (120, 30, 90)),
            ("PROCC", (150, 100, 20)),
            ("SPIKE", (30, 30, 32)),
            ("CLICK TWICE", (30, 110, 200)),
        ),
        front=(64, 52, 44),
    ),
    above=(24, 21, 19),
    gloss=Gloss(
        lamp_height_m=12.5,
        spacing_m=(4.0, 4.0),
        lamp_size_m=0.7,
        brightness=110.0,
        roughness_rad=0.05,
        mirror=0.035,
        blur_px=11.0,
    ),
)


def views() -> tuple[View, ...]:
    """All frames, in order."""
    main = (-1.8, 17.5, -5.2)
    cameras = [
        looking_at(main, (0.0, -0.4, -0.7), 790, k1=0.06),
        looking_at(main, (-4.6, -0.2, -0.5), 1050, k1=0.14, roll_degrees=-0.3),
        looking_at((-19.0, 0.8, -6.2), (-0.6, 0.0, -0.5), 900, k1=0.08),
        looking_at((14.2, 5.2, -1.7), (1.0, -0.6, -1.1), 640, k1=0.03),
        looking_at((-12.5, 13.0, -4.8), (-1.2, 0.0, -0.6), 860, k1=0.1, roll_degrees=0.4),
    ]
    return tuple(
        View(f"{i:05d}", camera, annotated=i != 5, bad_camera=i != 3)
        for i, camera in enumerate(cameras, 1)
    )


def _upright(y0: float, y1: float, low: float, high: float) -> list[tuple[float, float, float]]:
    return [(0.0, y0, -high), (0.0, y1, -high), (0.0, y1, -low), (0.0, y0, -low)]


def _draw_net(picture: PixelArray, camera: PinholeCamera) -> None:
    """The net hangs on its posts: mesh, bands, antennae; its upper edge is 2.43 m high."""

    def mesh(layer: PixelArray) -> None:
        for y in np.arange(-_NET_HALF, _NET_HALF + 0.01, _MESH_M):
            draw_thread(layer, camera, [(0, y, -_NET_BOTTOM), (0, y, -_NET_TOP)], _THREAD)
        across = np.linspace(-_NET_HALF, _NET_HALF, 21)
        for z in np.arange(_NET_BOTTOM, _NET_TOP, _MESH_M):
            draw_thread(layer, camera, [(0, y, -z) for y in across], _THREAD)

    posts = sorted((-_POST_Y, _POST_Y), key=lambda y: -abs(camera.position_world[1] - y))
    for y in posts:
        draw_box(picture, camera, (-0.35, y - 0.2, 0.0), (0.35, y + 0.2, -0.12), _POST_BLUE)
        for z in (_NET_TOP - 0.03, _NET_BOTTOM + 0.02):
            draw_bar(picture, camera, [(0, y, -z), (0, np.sign(y) * _NET_HALF, -z)], 0.012, _THREAD)
    draw_bar(picture, camera, [(0, posts[0], 0), (0, posts[0], -_POST_TOP)], _POST_M, _POST_BLUE)
    blend(picture, mesh, 0.6)
    ends = (-_NET_HALF, _NET_HALF)
    draw_sheet(picture, camera, _upright(*ends, _NET_TOP - _TOP_BAND_M, _NET_TOP), _CANVAS)
    draw_sheet(picture, camera, _upright(*ends, _NET_BOTTOM, _NET_BOTTOM + _BOTTOM_BAND_M), _CANVAS)
    for y in (-_HALF_WIDTH, _HALF_WIDTH):
        draw_sheet(picture, camera, _upright(y - 0.025, y + 0.025, _NET_BOTTOM, _NET_TOP), _CANVAS)
        steps = np.arange(_NET_BOTTOM, _ANTENNA_TOP - 0.01, _STRIPE_M)
        for i, z in enumerate(steps):
            colour = _RED if (len(steps) - i) % 2 else _CANVAS
            stripe = [(0, y, -z), (0, y, -(z + _STRIPE_M))]
            draw_bar(picture, camera, stripe, _ANTENNA_M, colour)
    draw_bar(picture, camera, [(0, posts[1], 0), (0, posts[1], -_POST_TOP)], _POST_M, _POST_BLUE)


def _draw_chair(picture: PixelArray, camera: PinholeCamera) -> None:
    """Where the first referee stands."""
    draw_box(picture, camera, (-0.35, -7.1, 0.0), (0.35, -6.4, -1.25), _CHAIR)


def things(camera: PinholeCamera, seed: int) -> list[Thing]:
    """The net, two teams of six, line judges."""
    random = np.random.default_rng(seed + 5)
    del camera  # all of them are in sight, or could be
    found = [Thing((0.0, 0.0), _draw_net), Thing((0.0, -6.7), _draw_chair)]
    places = [(2.0, -2.8), (1.6, 0.2), (2.2, 3.0), (6.4, -2.6), (6.9, 0.3), (6.0, 2.8)]
    for sign in (-1, 1):
        for i, (x, y) in enumerate(places):
            spot = np.array([sign * x, y]) + random.normal(0, 0.5, 2)
            kit = _LIBERO if i == 4 else _HOME if sign < 0 else _AWAY
            found.append(Person(spot, kit, random.uniform(0, 6.28)).thing())
    for x, y in ((-11.2, -5.2), (11.5, 7.6), (-10.6, 6.4), (10.8, -6.0)):
        found.append(Person(np.array([x, y]), _JUDGE, random.uniform(0, 6.28)).thing())
    return found


VOLLEYBALL = Sport(
    field_name="volleyball",
    folder="volleyball",
    views=views(),
    arena=ARENA,
    things=things,
    sets=("true", "pinhole", "bad", "late", "turned"),
    noise=1.3,
    jpeg_quality=90,
)
