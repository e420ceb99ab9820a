"""What stands around a field: advertising boards and stands full of people."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import cv2
import numpy as np
from numpy.typing import NDArray

from drawing.rays import Sight

FloatArray = NDArray[np.float32]
Colour = tuple[int, int, int]  # BGR

_ROWS, _SEATS = 64, 512
_FOUR_BOARDS = 4


@dataclass(frozen=True)
class Side:
    """One side of the stadium: outward direction, and where boards and stand begin (metres).

    ``boards_m`` None: without boards.
    """

    outward: tuple[int, int]
    boards_m: float | None
    stand_m: float
    depth_m: float
    half_length_m: float  # how far the boards reach to either side


@dataclass(frozen=True)
class Stands:
    """How stands and boards look.

    Attributes:
        first_row_m: height of the lowest row above the ground.
        slope: rise per metre outwards.
        stairs_m: a stair every so many metres.
        light: of the crowd; 1 is daylight.
        empty: share of the seats.
        board_height_m, board_length_m: of one board.
        boards: words on four of them, with the colour behind.
        front: colour of the wall below the first row; None: one sees through there.
    """

    first_row_m: float
    slope: float
    stairs_m: float
    light: float
    empty: float
    board_height_m: float
    board_length_m: float
    boards: tuple[tuple[str, Colour], ...]
    front: Colour | None = None


def draw_side(picture: FloatArray, sight: Sight, side: Side, look: Stands, seed: int) -> None:
    """Paint a side's stand and boards where they are nearer than what is painted already.

    Args:
        picture: (H, W, 3) BGR, changed in place, and with it what ``sight`` reaches.
        sight: rays of the picture.
        side: where they are.
        look: how they look.
        seed: decides the crowd.
    """
    ox, oy = side.outward
    position, rays, reach = sight.position, sight.rays, sight.reach
    nearest = side.boards_m if side.boards_m is not None else side.stand_m
    if position[0] * ox + position[1] * oy > nearest:
        return  # the camera hangs in this stand
    out = rays[..., 0] * ox + rays[..., 1] * oy
    start = float(position[0] * ox + position[1] * oy)
    # Rays along a plane meet it nowhere; their infinities fail every comparison below.
    with np.errstate(divide="ignore", invalid="ignore"):
        # Height above the ground = first_row_m + slope * (distance outward - stand_m).
        denominator = -rays[..., 2] - look.slope * out
        t = (look.first_row_m + look.slope * (start - side.stand_m) + position[2]) / denominator
    outward = start + t * out
    hit = (t > 0) & (outward > side.stand_m) & (outward < side.stand_m + side.depth_m) & (t < reach)
    along = (position[1] + t * rays[..., 1]) * abs(ox) + (position[0] + t * rays[..., 0]) * abs(oy)
    picture[hit] = _crowd(along[hit], outward[hit] - side.stand_m, look, seed)
    reach[hit] = t[hit]
    if look.front is not None:
        t, height, _ = _on_wall(sight, side, side.stand_m)
        hit = (t > 0) & (height >= 0) & (height < look.first_row_m) & (t < reach)
        picture[hit] = look.front
        reach[hit] = t[hit]
    if side.boards_m is None:
        return
    t, height, along = _on_wall(sight, side, side.boards_m)
    hit = (t > 0) & (height >= 0) & (height < look.board_height_m) & (t < reach)
    hit &= np.abs(along) < side.half_length_m
    reading = 1 if (oy < 0 or ox < 0) else -1
    reading = reading if ox == 0 else -reading
    picture[hit] = board_colours(along[hit] * reading, height[hit], look)
    reach[hit] = t[hit]


def _on_wall(
    sight: Sight, side: Side, distance_m: float
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Where rays meet an upright plane: how far, metres above the ground, metres along it."""
    ox, oy = side.outward
    position, rays = sight.position, sight.rays
    out = rays[..., 0] * ox + rays[..., 1] * oy
    start = float(position[0] * ox + position[1] * oy)
    with np.errstate(divide="ignore", invalid="ignore"):
        t = (distance_m - start) / out
    height = -(position[2] + t * rays[..., 2])
    along = (position[1] + t * rays[..., 1]) * abs(ox) + (position[0] + t * rays[..., 0]) * abs(oy)
    return t, height, along


def _crowd(along: FloatArray, up: FloatArray, look: Stands, seed: int) -> FloatArray:
    """Rows of seats with people: a head, a shirt, and here and there an empty seat or a stair."""
    shirts, empty = _people_on_seats(look.empty, seed)
    row, column = np.floor(up / 0.8), np.floor(along / 0.55)
    r = np.mod(row, _ROWS).astype(np.int32)
    c = np.mod(column, _SEATS).astype(np.int32)
    colour = shirts[r, c] * (0.75 - 0.008 * up[:, None])
    inside_row = up / 0.8 - row
    inside_seat = np.abs(along / 0.55 - column - 0.5)
    head = (inside_row > 0.55) & (inside_seat < 0.26) & ~empty[r, c]
    colour[head] = np.array([120, 148, 190], dtype=np.float32) * 0.72
    stairs = np.mod(along, look.stairs_m) < 1.1
    colour[stairs] = (84, 84, 86)
    return (colour * look.light).astype(np.float32)


def _people_on_seats(share_empty: float, seed: int) -> tuple[FloatArray, NDArray[np.bool_]]:
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
        size=(_ROWS, _SEATS),
    ) * random.uniform(0.5, 1.0, (_ROWS, _SEATS, 1)).astype(np.float32)
    empty = random.random((_ROWS, _SEATS)) < share_empty
    shirts[empty] = (88, 66, 50)
    return shirts, empty


def board_colours(along: FloatArray, height: FloatArray, look: Stands) -> FloatArray:
    """(n, 3) BGR of places on the boards.

    Args:
        along: (n,) metres, growing in the direction one reads.
        height: (n,) metres above the ground.
        look: their words and measures.
    """
    texture = _board_texture(look.boards)
    rows, columns = texture.shape[:2]
    whole = look.board_length_m * _FOUR_BOARDS
    # Rounded, what lies a hair before the first column lies after the last one.
    j = np.minimum(np.mod(along / whole * columns, columns).astype(np.int32), columns - 1)
    i = np.clip((1 - height / look.board_height_m) * rows, 0, rows - 1).astype(np.int32)
    return texture[i, j]


@lru_cache(maxsize=8)
def _board_texture(words: tuple[tuple[str, Colour], ...]) -> FloatArray:
    """Four advertising boards side by side, with words of our own."""
    boards = []
    for word, ground in words:
        board = np.full((96, 1056, 3), ground, dtype=np.uint8)
        (width, height), _ = cv2.getTextSize(word, cv2.FONT_HERSHEY_DUPLEX, 2.2, 5)
        place = ((1056 - width) // 2, (96 + height) // 2)
        cv2.putText(
            board, word, place, cv2.FONT_HERSHEY_DUPLEX, 2.2, (235, 235, 235), 5, cv2.LINE_AA
        )
        boards.append(board)
    return np.concatenate(boards, axis=1).astype(np.float32)
