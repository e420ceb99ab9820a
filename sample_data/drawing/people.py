"""Players and referees: where they stand, and how they look."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from drawing.solids import Colour, PixelArray, Thing, fill, near_picture
from procc_annotator.camera.models import PinholeCamera

FloatArray = NDArray[np.float64]


@dataclass(frozen=True)
class Kit:
    """What somebody wears.

    Attributes:
        shirt, shorts: their colours.
        socks: height of the part of the legs that has the shirt's colour, metres.
        legs: colour of trousers; None: bare.
        helmet: colour; None: hair.
        stick: whether they hold one.
        shade: colour of the shadow on this ground.
    """

    shirt: Colour
    shorts: Colour
    socks: float = 0.42
    legs: Colour | None = None
    helmet: Colour | None = None
    stick: bool = False
    shade: Colour = (30, 70, 45)


@dataclass(frozen=True, eq=False)
class Person:
    """Somebody on the field: (2,) metres, kit, and how far through a stride and turned."""

    spot: FloatArray
    kit: Kit
    turn: float

    def thing(self) -> Thing:
        """To be drawn among others."""
        return Thing((self.spot[0], self.spot[1]), lambda p, c: draw_person(p, c, self))


def looked_at(
    camera: PinholeCamera, half: tuple[float, float], farthest: float = 200.0
) -> FloatArray:
    """(2,) metres: where a camera's axis meets the ground, not far from either it or the centre."""
    direction = camera.rotation_cam_from_world[2]
    position = np.array(camera.position_world)
    reach = -position[2] / max(direction[2], 1e-3)
    return np.clip((position + min(reach, farthest) * direction)[:2], np.negative(half), half)


def draw_person(picture: PixelArray, camera: PinholeCamera, person: Person) -> None:
    """Paint somebody, upright and facing the camera, into a picture (changed in place)."""
    spot, kit, turn = person.spot, person.kit, person.turn
    feet = np.array([[spot[0], spot[1], 0.0]])
    px, in_front = camera.project(feet)
    if not in_front.all() or not near_picture(px, picture):
        return
    angles = np.linspace(0, 2 * np.pi, 20)
    shadow = np.column_stack(
        [spot[0] + 0.35 + 0.6 * np.cos(angles), spot[1] + 0.2 * np.sin(angles), 0 * angles]
    )
    shadow_px, in_front = camera.project(shadow)
    if not in_front.all():
        return
    dark = picture.copy()
    fill(dark, shadow_px, kit.shade)
    cv2.addWeighted(dark, 0.5, picture, 0.5, 0, dst=picture)
    right = camera.rotation_cam_from_world[0] * (1, 1, 0)
    right /= np.linalg.norm(right)

    def body(outline: list[tuple[float, float]]) -> FloatArray:
        shape = np.array(outline)
        points = feet + shape[:, :1] * right - shape[:, 1:] * (0, 0, 1)
        return camera.project(points)[0]

    stride = 0.2 * np.sin(turn)
    skin = (110, 140, 190) if turn < 4 else (60, 80, 120)
    for side in (-1, 1):
        foot = side * (0.1 + abs(stride))
        leg = [(side * 0.04, 0.85), (side * 0.16, 0.85), (foot + 0.07, 0.0), (foot - 0.05, 0.0)]
        fill(picture, body(leg), kit.legs or skin)
        top = kit.socks
        sock = [(foot - 0.05, top), (foot + 0.07, top), (foot + 0.08, 0.0), (foot - 0.06, 0.0)]
        fill(picture, body(sock), kit.shirt)
        swing = side * (0.3 + 0.12 * np.cos(turn))
        arm = [(side * 0.2, 1.46), (side * 0.24, 1.3), (swing + 0.05, 0.9), (swing - 0.03, 0.9)]
        fill(picture, body(arm), kit.shirt if kit.legs else skin)
    fill(picture, body([(-0.2, 0.98), (0.2, 0.98), (0.22, 0.62), (-0.22, 0.62)]), kit.shorts)
    torso = [(-0.17, 0.92), (-0.24, 1.36), (-0.14, 1.5), (0.14, 1.5), (0.24, 1.36), (0.17, 0.92)]
    fill(picture, body(torso), kit.shirt)
    head = [(0.11 * np.cos(a), 1.67 + 0.14 * np.sin(a)) for a in angles]
    fill(picture, body(head), skin)
    hair = [(0.115 * np.cos(a), 1.71 + 0.115 * np.sin(a)) for a in np.linspace(0, np.pi, 10)]
    fill(picture, body(hair), kit.helmet or (30, 35, 45))
    if kit.stick:
        lean = 0.75 if turn < 3 else -0.75
        shaft = [(0.1, 1.15), (0.14, 1.15), (lean + 0.03, 0.04), (lean - 0.01, 0.04)]
        fill(picture, body(shaft), (40, 40, 44))
        blade = [(lean, 0.09), (lean * 1.4, 0.07), (lean * 1.4, 0.0), (lean, 0.0)]
        fill(picture, body(blade), (30, 30, 32))
