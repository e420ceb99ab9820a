"""Ground, lines, boards and stands: a colour for every pixel, by following its ray."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.field.geometry import Circle, Geometry, Line
from procc_annotator.field.load import load_field

FloatArray = NDArray[np.float32]

LINE_WIDTH_M = 0.12
_BOARD_HEIGHT_M = 0.95
_BOARD_LENGTH_M = 11.0
_STAND_SLOPE = 0.55
_NOISE_SIDE = 1024


@dataclass(frozen=True)
class Side:
    """One side of the stadium: outward direction, and where boards and stand begin (metres)."""

    outward: tuple[int, int]
    boards_m: float
    stand_m: float
    depth_m: float
    half_length_m: float  # how far the boards reach to either side


SIDES = (
    Side((0, -1), 38.5, 43.0, 30.0, 57.5),
    Side((-1, 0), 57.5, 63.0, 26.0, 38.5),
    Side((1, 0), 57.5, 63.0, 26.0, 38.5),
    Side((0, 1), 39.5, 44.0, 24.0, 57.5),
)


def draw_scenery(camera: PinholeCamera, size: tuple[int, int], seed: int) -> FloatArray:
    """The empty stadium seen by a camera.

    Args:
        camera: in pixels of ``size``.
        size: (width, height) px.
        seed: decides the crowd and the grain of the grass.

    Returns:
        (height, width, 3) BGR, 0 to 255.
    """
    rays = _rays_world(camera, size)
    position = np.array(camera.position_world, dtype=np.float32)
    with np.errstate(divide="ignore", invalid="ignore"):
        reach = np.where(rays[..., 2] > 1e-6, -position[2] / rays[..., 2], np.inf)
    reach = reach.astype(np.float32)
    ground = position[:2] + np.where(np.isfinite(reach), reach, 0)[..., None] * rays[..., :2]
    picture = _grass(ground, seed)
    paint = _lines(ground)[..., None]
    white = np.array([226, 232, 230], dtype=np.float32)
    picture = picture * (1 - 0.93 * paint) + white * 0.93 * paint
    picture[~np.isfinite(reach)] = (52, 40, 34)  # the dark below the roof
    for side in SIDES:
        _draw_side(picture, reach, rays, position, side, seed)
    return picture


def _rays_world(camera: PinholeCamera, size: tuple[int, int]) -> FloatArray:
    """(H, W, 3) directions; only k1 is undone, by fixed-point iteration."""
    u, v = np.meshgrid(np.arange(size[0], dtype=np.float32), np.arange(size[1], dtype=np.float32))
    xd = (u - camera.principal_point_px[0]) / camera.focal_px[0]
    yd = (v - camera.principal_point_px[1]) / camera.focal_px[1]
    x, y = xd, yd
    for _ in range(12 if camera.is_distorted else 0):
        factor = 1 + camera.radial[0] * (x * x + y * y)
        x, y = xd / factor, yd / factor
    rays_cam = np.stack([x, y, np.ones_like(x)], axis=-1).astype(np.float32)
    return rays_cam @ camera.rotation_cam_from_world.astype(np.float32)


def _grass(ground: FloatArray, seed: int) -> FloatArray:
    x, y = ground[..., 0], ground[..., 1]
    random = np.random.default_rng(seed)
    grain = _noise_tile(random, 1.2)
    patches = _noise_tile(random, 22)
    # Far beyond the stands the ground runs to infinity; nothing of it is seen.
    i = np.floor(np.clip(x, -1e4, 1e4) * 9).astype(np.int32) % _NOISE_SIDE
    j = np.floor(np.clip(y, -1e4, 1e4) * 9).astype(np.int32) % _NOISE_SIDE
    stripe = np.tanh(6 * np.sin(np.pi * (x + 52.5) / 5.5))
    light = 1 + 0.075 * stripe + 0.035 * grain[j, i] + 0.03 * patches[j, i]
    off_pitch = (np.abs(x) > 56) | (np.abs(y) > 37.5)
    light = np.where(off_pitch, 0.8 + 0.02 * grain[j, i], light)
    colour = np.array([52, 128, 78], dtype=np.float32)
    return (light[..., None] * colour).astype(np.float32)


def _noise_tile(random: np.random.Generator, blur: float) -> FloatArray:
    """Smooth noise of unit spread that continues across its borders: a seam would look painted."""
    noise = random.normal(0, 1, (_NOISE_SIDE, _NOISE_SIDE)).astype(np.float32)
    margin = int(5 * blur)
    smooth = cv2.GaussianBlur(np.pad(noise, margin, mode="wrap"), (0, 0), blur)
    tile = smooth[margin:-margin, margin:-margin]
    return (tile / tile.std()).astype(np.float32)


def _lines(ground: FloatArray) -> FloatArray:
    """(H, W) share of each pixel covered by paint, from the distance to each element's middle."""
    cover = np.zeros(ground.shape[:2], dtype=np.float32)
    across, down = np.gradient(ground, axis=1), np.gradient(ground, axis=0)
    for element in load_field().elements:
        if not element.on_ground:
            continue
        distance, normal = _distance(ground, element.geometry)
        near = distance < 1.0
        direction = normal[near] if normal.ndim == 3 else normal
        per_pixel = np.hypot(
            (across[near] * direction).sum(axis=-1), (down[near] * direction).sum(axis=-1)
        )
        share = (LINE_WIDTH_M / 2 - distance[near]) / np.maximum(per_pixel, 1e-5) + 0.5
        cover[near] = np.maximum(cover[near], np.clip(share, 0, 1))
    for spot in ((0.0, 0.0), (-41.5, 0.0), (41.5, 0.0)):
        away = np.hypot(ground[..., 0] - spot[0], ground[..., 1] - spot[1])
        cover = np.maximum(cover, np.clip((0.13 - away) * 12, 0, 1))
    return cover


def _distance(ground: FloatArray, geometry: Geometry) -> tuple[FloatArray, FloatArray]:
    """(H, W) metres to an element, and the direction across it, constant or (H, W, 2)."""
    x, y = ground[..., 0], ground[..., 1]
    if isinstance(geometry, Line):
        ax, ay = geometry.start[:2]
        bx, by = geometry.end[:2]
        along = np.hypot(bx - ax, by - ay)
        ux, uy = (bx - ax) / along, (by - ay) / along
        t = (x - ax) * ux + (y - ay) * uy
        beyond = np.maximum(np.maximum(-t, t - along), 0)
        normal = np.array([uy, -ux], dtype=np.float32)
        return np.hypot((x - ax) * uy - (y - ay) * ux, beyond), normal
    offset = ground - np.array(geometry.centre[:2], dtype=np.float32)
    away = np.maximum(np.hypot(offset[..., 0], offset[..., 1]), 1e-3)
    distance = np.abs(away - geometry.radius)
    if not isinstance(geometry, Circle):
        middle = (geometry.start_rad + geometry.end_rad) / 2
        half = (geometry.end_rad - geometry.start_rad) / 2
        axis = np.array([np.cos(middle), np.sin(middle)], dtype=np.float32)
        distance[(offset @ axis) / away < np.cos(half)] = 10.0
    return distance, offset / away[..., None]


def _draw_side(
    picture: FloatArray,
    reach: FloatArray,
    rays: FloatArray,
    position: FloatArray,
    side: Side,
    seed: int,
) -> None:
    """Paint a side's stand and boards where they are nearer than what is painted already."""
    ox, oy = side.outward
    if position[0] * ox + position[1] * oy > side.boards_m:
        return  # the camera hangs in this stand
    out = rays[..., 0] * ox + rays[..., 1] * oy
    start = float(position[0] * ox + position[1] * oy)
    # Rays along a plane meet it nowhere; their infinities fail every comparison below.
    with np.errstate(divide="ignore", invalid="ignore"):
        # Stand: height above the ground = 1.2 + slope * (distance outward - stand_m).
        denominator = -rays[..., 2] - _STAND_SLOPE * out
        t = (1.2 + _STAND_SLOPE * (start - side.stand_m) + position[2]) / denominator
    outward = start + t * out
    hit = (t > 0) & (outward > side.stand_m) & (outward < side.stand_m + side.depth_m) & (t < reach)
    along = (position[1] + t * rays[..., 1]) * abs(ox) + (position[0] + t * rays[..., 0]) * abs(oy)
    picture[hit] = _crowd(along[hit], outward[hit] - side.stand_m, seed)
    reach[hit] = t[hit]
    with np.errstate(divide="ignore", invalid="ignore"):
        t = (side.boards_m - start) / out
    height = -(position[2] + t * rays[..., 2])
    along = (position[1] + t * rays[..., 1]) * abs(ox) + (position[0] + t * rays[..., 0]) * abs(oy)
    hit = (t > 0) & (height >= 0) & (height < _BOARD_HEIGHT_M) & (t < reach)
    hit &= np.abs(along) < side.half_length_m
    reading = 1 if (oy < 0 or ox < 0) else -1
    reading = reading if ox == 0 else -reading
    picture[hit] = _boards(along[hit] * reading, height[hit])
    reach[hit] = t[hit]


def _crowd(along: FloatArray, up: FloatArray, seed: int) -> FloatArray:
    """Rows of seats with people: a head, a shirt, and here and there an empty seat or a stair."""
    random = np.random.default_rng(seed + 77)
    shirts = random.choice(
        np.array(
            [
                [150, 60, 40],
                [60, 60, 170],
                [200, 200, 200],
                [60, 50, 45],
                [90, 110, 140],
                [40, 90, 60],
            ],
            dtype=np.float32,
        ),
        size=(64, 512),
    ) * random.uniform(0.5, 1.0, (64, 512, 1)).astype(np.float32)
    empty = random.random((64, 512)) < 0.16
    shirts[empty] = (88, 66, 50)
    row, column = np.floor(up / 0.8), np.floor(along / 0.55)
    r = np.mod(row, 64).astype(np.int32)
    c = np.mod(column, 512).astype(np.int32)
    colour = shirts[r, c] * (0.75 - 0.008 * up[:, None])
    inside_row = up / 0.8 - row
    inside_seat = np.abs(along / 0.55 - column - 0.5)
    head = (inside_row > 0.55) & (inside_seat < 0.26) & ~empty[r, c]
    colour[head] = np.array([120, 148, 190], dtype=np.float32) * 0.72
    stairs = np.mod(along, 14.0) < 1.1
    colour[stairs] = (84, 84, 86)
    return colour.astype(np.float32)


def _boards(along: FloatArray, height: FloatArray) -> FloatArray:
    texture = _board_texture()
    rows, columns = texture.shape[:2]
    j = np.mod(along / (_BOARD_LENGTH_M * 4) * columns, columns).astype(np.int32)
    i = np.clip((1 - height / _BOARD_HEIGHT_M) * rows, 0, rows - 1).astype(np.int32)
    return texture[i, j]


def _board_texture() -> FloatArray:
    """Four advertising boards side by side, with words of our own."""
    words = ("PROCC", "FIELD LINES", "CLICK TWICE", "JAC 1.00")
    grounds = ((120, 40, 20), (30, 30, 160), (40, 40, 40), (20, 110, 150))
    boards = []
    for word, ground in zip(words, grounds, strict=True):
        board = np.full((96, 1056, 3), ground, dtype=np.uint8)
        (width, height), _ = cv2.getTextSize(word, cv2.FONT_HERSHEY_DUPLEX, 2.2, 5)
        place = ((1056 - width) // 2, (96 + height) // 2)
        cv2.putText(
            board, word, place, cv2.FONT_HERSHEY_DUPLEX, 2.2, (235, 235, 235), 5, cv2.LINE_AA
        )
        boards.append(board)
    return np.concatenate(boards, axis=1).astype(np.float32)
