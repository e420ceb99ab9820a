"""What stands on the ground: goals with nets, players, referee and ball."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.camera.pinhole import PinholeCamera

FloatArray = NDArray[np.float64]
PixelArray = NDArray[np.uint8]

POST_WIDTH_M = 0.12
_SHIFT = 4
_GOAL_HALF, _GOAL_HEIGHT, _NET_DEPTH = 3.66, 2.44, 2.0
_HOME = ((40, 40, 190), (230, 230, 230))
_AWAY = ((205, 205, 210), (120, 50, 30))
_REFEREE = ((40, 210, 225), (30, 30, 30))
_KEEPER = ((60, 190, 60), (40, 40, 40))


def draw_figures(picture: PixelArray, camera: PinholeCamera, seed: int) -> None:
    """Paint goals and people into a picture, the farthest first.

    Args:
        picture: (H, W, 3) BGR, changed in place.
        camera: in pixels of ``picture``.
        seed: decides where people stand.
    """
    position = np.array(camera.position_world)
    things: list[tuple[float, object]] = [
        (float(np.hypot(sign * 53 - position[0], position[1])), sign) for sign in (-1, 1)
    ]
    things += [(float(np.hypot(*(p[0] - position[:2]))), p) for p in _people(camera, seed)]
    for _, thing in sorted(things, key=lambda t: -t[0]):
        if isinstance(thing, int):
            _draw_goal(picture, camera, thing)
        elif isinstance(thing, tuple):
            _draw_person(picture, camera, *thing)


def _people(camera: PinholeCamera, seed: int) -> list[tuple[FloatArray, tuple, float]]:
    random = np.random.default_rng(seed + 5)
    towards = _looked_at(camera)
    people = []
    for i in range(22):
        spot = towards + random.normal(0, 1, 2) * (17, 12)
        people.append((_on_pitch(spot), _HOME if i % 2 else _AWAY, random.uniform(0, 6.28)))
    people.append((_on_pitch(towards + random.normal(0, 8, 2)), _REFEREE, 1.0))
    for sign in (-1, 1):
        spot = np.array([sign * (50.5 - random.uniform(0, 2)), random.uniform(-2, 2)])
        people.append((spot, _KEEPER, random.uniform(0, 6.28)))
    return people


def _looked_at(camera: PinholeCamera) -> FloatArray:
    direction = camera.rotation_cam_from_world[2]
    position = np.array(camera.position_world)
    reach = -position[2] / max(direction[2], 1e-3)
    return np.clip((position + min(reach, 200.0) * direction)[:2], (-45, -28), (45, 28))


def _on_pitch(spot: FloatArray) -> FloatArray:
    return np.clip(spot, (-51, -33), (51, 33))


def _draw_goal(picture: PixelArray, camera: PinholeCamera, sign: int) -> None:
    x, back = sign * 52.5, sign * (52.5 + _NET_DEPTH)
    net = picture.copy()
    for y in np.linspace(-_GOAL_HALF, _GOAL_HALF, 37):
        upright = [(back, y, z) for z in np.linspace(0, -_GOAL_HEIGHT * 0.92, 8)]
        roof = [(back, y, -_GOAL_HEIGHT * 0.92), (x, y, -_GOAL_HEIGHT)]
        _thin(net, camera, upright)
        _thin(net, camera, roof)
    for z in np.linspace(0, _GOAL_HEIGHT * 0.92, 13):
        _thin(net, camera, [(back, y, -z) for y in np.linspace(-_GOAL_HALF, _GOAL_HALF, 12)])
        for y in (-_GOAL_HALF, _GOAL_HALF):
            _thin(net, camera, [(x, y, -z), (back, y, -z)])
    for depth in np.linspace(0.2, 1, 8):
        along = x + (back - x) * depth
        height = _GOAL_HEIGHT * (1 - 0.08 * depth)
        _thin(net, camera, [(along, y, -height) for y in np.linspace(-_GOAL_HALF, _GOAL_HALF, 12)])
        for y in (-_GOAL_HALF, _GOAL_HALF):
            _thin(net, camera, [(along, y, 0), (along, y, -height)])
    cv2.addWeighted(net, 0.42, picture, 0.58, 0, dst=picture)
    frame = [(x, -_GOAL_HALF, 0), (x, -_GOAL_HALF, -_GOAL_HEIGHT)]
    _bar(picture, camera, frame)
    _bar(picture, camera, [(x, _GOAL_HALF, 0), (x, _GOAL_HALF, -_GOAL_HEIGHT)])
    end = _GOAL_HALF + POST_WIDTH_M / 2  # the crossbar lies on the posts, corners closed
    _bar(picture, camera, [(x, -end, -_GOAL_HEIGHT), (x, end, -_GOAL_HEIGHT)])


def _thin(picture: PixelArray, camera: PinholeCamera, points: list) -> None:
    px, in_front = camera.project(np.array(points, dtype=np.float64))
    if in_front.all() and _near_picture(px, picture):
        cv2.polylines(picture, [_fixed(px)], False, (222, 222, 222), 1, cv2.LINE_AA, _SHIFT)


def _bar(picture: PixelArray, camera: PinholeCamera, ends: list) -> None:
    """A white post or crossbar of true width, its middle exactly on the element."""
    t = np.linspace(0, 1, 25)[:, None]
    points = np.array(ends[0], dtype=np.float64) * (1 - t) + np.array(ends[1]) * t
    px, in_front = camera.project(points)
    if not in_front.all() or not _near_picture(px, picture):
        return
    distance = np.linalg.norm(points - camera.position_world, axis=1)
    half = np.maximum(POST_WIDTH_M * camera.focal_px[0] / distance / 2, 0.8)[:, None]
    along = np.gradient(px, axis=0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    across = along[:, ::-1] * (1, -1) * half
    outline = np.concatenate([px + across, (px - across)[::-1]])
    cv2.fillPoly(picture, [_fixed(outline)], (243, 244, 243), cv2.LINE_AA, _SHIFT)


def _draw_person(
    picture: PixelArray, camera: PinholeCamera, spot: FloatArray, kit: tuple, turn: float
) -> None:
    feet = np.array([[spot[0], spot[1], 0.0]])
    px, in_front = camera.project(feet)
    if not in_front.all() or not _near_picture(px, picture):
        return
    angles = np.linspace(0, 2 * np.pi, 20)
    shadow = np.column_stack(
        [spot[0] + 0.35 + 0.6 * np.cos(angles), spot[1] + 0.2 * np.sin(angles), 0 * angles]
    )
    dark = picture.copy()
    _fill(dark, camera.project(shadow)[0], (30, 70, 45))
    cv2.addWeighted(dark, 0.5, picture, 0.5, 0, dst=picture)
    right = camera.rotation_cam_from_world[0] * (1, 1, 0)
    right /= np.linalg.norm(right)

    def body(outline: list[tuple[float, float]]) -> FloatArray:
        shape = np.array(outline)
        points = feet + shape[:, :1] * right - shape[:, 1:] * (0, 0, 1)
        return camera.project(points)[0]

    stride = 0.2 * np.sin(turn)
    skin = (110, 140, 190) if turn < 4 else (60, 80, 120)
    shirt, shorts = kit
    for side in (-1, 1):
        foot = side * (0.1 + abs(stride))
        leg = [(side * 0.04, 0.85), (side * 0.16, 0.85), (foot + 0.07, 0.0), (foot - 0.05, 0.0)]
        _fill(picture, body(leg), skin)
        sock = [(foot - 0.05, 0.42), (foot + 0.07, 0.42), (foot + 0.08, 0.0), (foot - 0.06, 0.0)]
        _fill(picture, body(sock), shirt)
        swing = side * (0.3 + 0.12 * np.cos(turn))
        arm = [(side * 0.2, 1.46), (side * 0.24, 1.3), (swing + 0.05, 0.9), (swing - 0.03, 0.9)]
        _fill(picture, body(arm), skin)
    _fill(picture, body([(-0.2, 0.98), (0.2, 0.98), (0.22, 0.62), (-0.22, 0.62)]), shorts)
    torso = [(-0.17, 0.92), (-0.24, 1.36), (-0.14, 1.5), (0.14, 1.5), (0.24, 1.36), (0.17, 0.92)]
    _fill(picture, body(torso), shirt)
    head = [(0.11 * np.cos(a), 1.67 + 0.14 * np.sin(a)) for a in angles]
    _fill(picture, body(head), skin)
    hair = [(0.115 * np.cos(a), 1.71 + 0.115 * np.sin(a)) for a in np.linspace(0, np.pi, 10)]
    _fill(picture, body(hair), (30, 35, 45))


def _fill(picture: PixelArray, outline: FloatArray, colour: tuple[int, int, int]) -> None:
    cv2.fillPoly(picture, [_fixed(outline)], colour, cv2.LINE_AA, _SHIFT)


def _fixed(px: FloatArray) -> NDArray[np.int32]:
    return np.round(px * (1 << _SHIFT)).astype(np.int32).reshape(-1, 1, 2)


def _near_picture(px: FloatArray, picture: PixelArray) -> bool:
    size = np.array([picture.shape[1], picture.shape[0]])
    return bool(((px > -2000) & (px < size + 2000)).all())
