"""Drawn pictures and shots whose cameras are known to the last digit: of any field.

The sample's own painter draws them. `stage_of` sets the scene, `random_camera` picks a camera that
the field file allows, `draw` makes one picture, `DrawnShot` a shot of many that pans, zooms and may
be cut. The same arguments give the same pixels.
"""

import math
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.geometry import Arc, Line, parts_of, points_at_angles
from procc_annotator.field.load import load_field, with_lines
from procc_annotator.field.model import (
    BLACK,
    BLUE,
    MIDDLE_LINE,
    NOTHING,
    ORANGE,
    RED,
    WHITE,
    YELLOW,
    Field,
)
from procc_annotator.image.pixels import PixelArray
from tests.bench.sports.views import SIZE as VIEW_SIZE
from tests.bench.sports.views import Views

PICTURE_SIZE = (1280, 720)
FPS = 25.0
# Fields that the sample has an arena of, with people, stands, boards and what stands on the ground.
ARENAS = ("soccer", "basketball_fiba", "volleyball", "ice_hockey_iihf")
_COLOURS = {
    WHITE: (235, 238, 236),
    BLACK: (30, 30, 32),
    RED: (50, 45, 190),
    ORANGE: (30, 110, 230),
    YELLOW: (60, 205, 225),
    BLUE: (160, 85, 35),
}
_BAR_M, _LARGE_FIELD_M = 0.1, 30.0  # thickness of a bar nobody knows; half a length, for grass
_SPEED_MPS = 1.5  # of people
_OPEN_STEPS = 9  # pictures that a shutter's time is made of


@contextmanager
def _drawing_importable() -> Iterator[None]:
    before = list(sys.path)
    sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "sample_data"))
    try:
        yield
    finally:
        sys.path[:] = before


with _drawing_importable():
    from drawing import grounds, people, rays, scenery, soccer, solids, sports  # noqa: F401
    from drawing import paint as painter


# (camera, seed) -> what stands and who is there
Things = Callable[[PinholeCamera, int], "Sequence[Any]"]


@dataclass(frozen=True)
class Stage:
    """What is drawn, and the field as which its paint is to be read.

    Attributes:
        field: its elements lie in the middle of the paint that is drawn.
        arena: ground, paint, and what is around.
        things: what stands there, and people around what a camera looks at.
        noise: of a picture's values.
    """

    field: Field
    arena: Any
    things: Things
    noise: float = 1.5


@cache
def stage_of(name: str | Path) -> Stage:
    """The scene of a field: the sample's arena of it, or the plain ground with its paint.

    Args:
        name: of a shipped field, or a field file.
    """
    if name in sports.SPORTS:
        sport = sports.SPORTS[str(name)]
        # Soccer's lines are drawn with their middle where the rules measure, as they are annotated.
        field = sport.field if name == "soccer" else with_lines(sport.field, MIDDLE_LINE)
        return Stage(field, sport.arena, sport.things, sport.noise)
    return plain_stage(load_field(name))


def plain_stage(field: Field) -> Stage:
    """A field on plain ground: its paint, its bars, two teams; nothing around."""
    large = camera_placement_prior(field).half_length > _LARGE_FIELD_M
    ground = grounds.grass if large else grounds.sheet((110, 96, 60))
    visible = [e for e in field.elements if e.appearance.kind != NOTHING and not e.optional]
    colours = {e.name: _colour(e.appearance.colour) for e in visible}
    arena = scenery.Arena(
        ground=ground,
        strokes=tuple(painter.strokes_of(visible, {"": _COLOURS[WHITE], **colours})),
        sides=(),
        stands=sports.SPORTS["soccer"].arena.stands,
    )
    bars = [e for e in visible if not e.on_ground and not e.is_spot]

    def things(camera: PinholeCamera, seed: int) -> list[Any]:
        found = [
            _bar(part, e.appearance.width_m, colours[e.name])
            for e in bars
            for part in parts_of(e.geometry)
        ]
        return [*found, *_teams(field, camera, seed)]

    return Stage(with_lines(field, MIDDLE_LINE), arena, things)


def _colour(name: str) -> tuple[int, int, int]:
    return _COLOURS.get(name, _COLOURS[WHITE])


def _bar(part: Any, width_m: float, colour: tuple[int, int, int]) -> Any:
    if isinstance(part, Line):
        places = np.array([part.start, part.end])
    else:
        first, last = (part.start_rad, part.end_rad) if isinstance(part, Arc) else (0.0, math.tau)
        places = points_at_angles(part, np.linspace(first, last, 40))
    middle = places.mean(axis=0)

    def draw(picture: PixelArray, camera: PinholeCamera) -> None:
        solids.draw_bar(picture, camera, places, width_m or _BAR_M, colour)

    return solids.Thing((float(middle[0]), float(middle[1])), draw)


def _teams(field: Field, camera: PinholeCamera, seed: int) -> list[Any]:
    random = np.random.default_rng(seed + 5)
    around = camera_placement_prior(field)
    half = (around.half_length, around.half_width)
    kits = (people.Kit((40, 40, 190), (230, 230, 230)), people.Kit((205, 205, 210), (120, 50, 30)))
    towards = people.looked_at(camera, half)
    found = []
    for number in range(12):
        spot = towards + random.normal(0, 0.35, 2) * half
        spot = np.clip(spot, np.negative(half), half)
        found.append(people.Person(spot, kits[number % 2], random.uniform(0, math.tau)).thing())
    return found


# --- cameras ------------------------------------------------------------------------------------


def random_camera(
    field: Field, rng: np.random.Generator, size: tuple[int, int] = PICTURE_SIZE
) -> PinholeCamera:
    """A camera that the field file allows and that has at least four elements in sight, in px of
    ``size``; where the field looks the same from the other side, on that of the main camera."""
    camera = Views(field).random(rng).camera
    x, y, z = camera.position_world
    half_turn = any(abs(turn.turn_rad - math.pi) < 1e-6 for turn in field.symmetries)
    if half_turn and y < 0:
        pan = (camera.pan_rad + 2 * math.pi) % (2 * math.pi) - math.pi
        camera = replace(camera, pan_rad=pan, position_world=(-x, -y, z))
    return at_size(camera, VIEW_SIZE, size)


def at_size(
    camera: PinholeCamera, from_size: tuple[int, int], size: tuple[int, int]
) -> PinholeCamera:
    """The camera in px of another size, its pixels still as wide as high."""
    focal = camera.focal_px[0] * (size[0] - 1) / (from_size[0] - 1)
    middle = ((size[0] - 1) / 2, (size[1] - 1) / 2)
    return replace(camera, focal_px=(focal, focal), principal_point_px=middle)


def looking_at(
    position: Sequence[float],
    target: Sequence[float],
    focal_px: float,
    size: tuple[int, int] = PICTURE_SIZE,
    *,
    kappa: float = 0.0,
    roll_rad: float = 0.0,
) -> PinholeCamera:
    """A camera at a place (metres, z down) whose axis goes through another.

    Args:
        kappa: radial distortion at half the picture's diagonal; the same at every focal length
            means the same lens to a fit.
    """
    direction = np.array(target, dtype=float) - np.array(position, dtype=float)
    direction /= np.linalg.norm(direction)
    half_diagonal = math.hypot(size[0] - 1, size[1] - 1) / 2
    x, y, z = (float(value) for value in position)
    return PinholeCamera(
        math.atan2(direction[0], -direction[1]),
        math.acos(direction[2]),
        roll_rad,
        (x, y, z),
        (focal_px, focal_px),
        ((size[0] - 1) / 2, (size[1] - 1) / 2),
        (kappa * (focal_px / half_diagonal) ** 2, 0.0, 0.0, 0.0, 0.0, 0.0),
    )


@dataclass(frozen=True)
class Aim:
    """Where a camera looks at a moment of a shot (metres on the ground), and how far it zooms."""

    x: float
    y: float
    focal_px: float
    position: tuple[float, float, float] | None = None  # where it moves; None: stays


def course(
    position: tuple[float, float, float],
    aims: Sequence[Aim],
    frames: int,
    size: tuple[int, int] = PICTURE_SIZE,
    *,
    kappa: float = 0.0,
    roll_rad: float = 0.0,
) -> tuple[PinholeCamera, ...]:
    """Cameras that turn and zoom smoothly from one aim to the next, resting at each.

    Args:
        position: of the tripod, metres, z down.
        aims: at least two, at equal times.
        frames: how many cameras.
    """
    knots = np.array([(a.x, a.y, math.log(a.focal_px), *(a.position or position)) for a in aims])
    cameras = []
    for at in np.linspace(0, len(aims) - 1, frames):
        first = min(int(at), len(aims) - 2)
        share = at - first
        share = share * share * (3 - 2 * share)
        x, y, log_focal, *stand = knots[first] * (1 - share) + knots[first + 1] * share
        cameras.append(
            looking_at(stand, (x, y, 0), math.exp(log_focal), size, kappa=kappa, roll_rad=roll_rad)
        )
    return tuple(cameras)


# --- pictures -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Look:
    """What stands between a scene and its picture.

    Attributes:
        noise: of the values; None for the scene's own.
        shutter: share of the time between two frames that it is open; 0 is no motion blur.
        jpeg_quality: 0 to 100, of a loss like that of a broadcast; None: none.
        people: whether somebody is there.
        sharpness: standard deviation, px, that the lens spreads a point by.
        finer: pictures are drawn so many times as large and made smaller.
    """

    noise: float | None = None
    shutter: float = 0.0
    jpeg_quality: int | None = None
    people: bool = True
    sharpness: float = 0.7
    finer: int = 1


PLAIN = Look()


def draw(
    stage: Stage,
    camera: PinholeCamera,
    size: tuple[int, int] = PICTURE_SIZE,
    *,
    seed: int = 1,
    look: Look = PLAIN,
) -> PixelArray:
    """A picture: (H, W, 4) BGRA, as pictures are decoded."""
    clean = _scene(stage, camera, size, seed, look, camera, 0.0)
    return _recorded(clean, stage, seed, look)


def _scene(
    stage: Stage,
    camera: PinholeCamera,
    size: tuple[int, int],
    seed: int,
    look: Look,
    towards: PinholeCamera,
    seconds: float,
) -> PixelArray:
    """(H, W, 3) BGR without noise; people are around what ``towards`` looks at."""
    fine = (size[0] * look.finer, size[1] * look.finer)
    camera = _finer(camera, look.finer)
    picture = scenery.draw_scenery(stage.arena, camera, fine, seed)
    picture = np.clip(picture, 0, 255).astype(np.uint8)
    solids.draw_things(picture, camera, _moved(stage, towards, seed, look.people, seconds))
    if look.finer > 1:
        picture = cv2.resize(picture, size, interpolation=cv2.INTER_AREA)
    if look.sharpness > 0:
        picture = cv2.GaussianBlur(picture, (0, 0), look.sharpness)
    return np.asarray(picture, dtype=np.uint8)


def _moved(
    stage: Stage, towards: PinholeCamera, seed: int, with_people: bool, seconds: float
) -> list[Any]:
    """The things of a scene after some time: who stands elsewhere for another seed has moved."""
    things, others = stage.things(towards, seed), stage.things(towards, seed + 1)
    fixed = {thing.at for thing in things} & {thing.at for thing in others}
    random = np.random.default_rng(seed + 9)
    found = []
    for thing in things:
        way = random.normal(0, _SPEED_MPS, 2) * seconds
        if thing.at in fixed:
            found.append(thing)
        elif with_people:
            found.append(_shifted(thing, float(way[0]), float(way[1])))
    return found


def _shifted(thing: Any, dx: float, dy: float) -> Any:
    """A thing elsewhere: drawn by a camera that has moved the other way."""

    def draw_it(picture: PixelArray, camera: PinholeCamera) -> None:
        x, y, z = camera.position_world
        thing.draw(picture, replace(camera, position_world=(x - dx, y - dy, z)))

    return solids.Thing((thing.at[0] + dx, thing.at[1] + dy), draw_it)


def _finer(camera: PinholeCamera, times: int) -> PinholeCamera:
    fx, fy = camera.focal_px
    cx, cy = camera.principal_point_px
    middle = ((cx + 0.5) * times - 0.5, (cy + 0.5) * times - 0.5)
    return replace(camera, focal_px=(fx * times, fy * times), principal_point_px=middle)


def _recorded(clean: PixelArray, stage: Stage, seed: int, look: Look) -> PixelArray:
    noise = stage.noise if look.noise is None else look.noise
    random = np.random.default_rng(seed + 77)
    noisy = np.clip(clean + random.normal(0, noise, clean.shape), 0, 255).astype(np.uint8)
    if look.jpeg_quality is not None:
        quality = [cv2.IMWRITE_JPEG_QUALITY, look.jpeg_quality]
        noisy = cv2.imdecode(cv2.imencode(".jpg", noisy, quality)[1], cv2.IMREAD_COLOR)
    return np.asarray(cv2.cvtColor(noisy, cv2.COLOR_BGR2BGRA), dtype=np.uint8)


def _blurred(
    clean: PixelArray, camera: PinholeCamera, before: PinholeCamera, after: PinholeCamera
) -> PixelArray:
    """The mean of what an open shutter sees from one camera over ``camera`` to another."""
    size = clean.shape[1], clean.shape[0]
    total = np.zeros(clean.shape, dtype=np.float32)
    for share in np.linspace(-1, 1, _OPEN_STEPS):
        other = after if share > 0 else before
        moment = between(camera, other, abs(float(share)))
        directions = rays._rays_world(moment, size).reshape(-1, 3).astype(np.float64)
        px, _ = camera.project(directions * 1e3 + np.array(camera.position_world))
        places = px.reshape(size[1], size[0], 2).astype(np.float32)
        total += cv2.remap(
            clean, places[..., 0], places[..., 1], cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE
        )
    return np.clip(total / _OPEN_STEPS + 0.5, 0, 255).astype(np.uint8)


def between(first: PinholeCamera, second: PinholeCamera, share: float) -> PinholeCamera:
    """The camera on the way from one to another, from 0 to 1."""

    def mixed(one: float, other: float) -> float:
        return one * (1 - share) + other * share

    focal = mixed(first.focal_px[0], second.focal_px[0])
    x, y, z = (
        mixed(a, b) for a, b in zip(first.position_world, second.position_world, strict=True)
    )
    return replace(
        first,
        pan_rad=mixed(first.pan_rad, second.pan_rad),
        tilt_rad=mixed(first.tilt_rad, second.tilt_rad),
        roll_rad=mixed(first.roll_rad, second.roll_rad),
        position_world=(x, y, z),
        focal_px=(focal, focal),
        radial=(mixed(first.radial[0], second.radial[0]), 0.0, 0.0, 0.0, 0.0, 0.0),
    )


# --- shots --------------------------------------------------------------------------------------


@dataclass(frozen=True)
class DrawnShot:
    """Frames with their cameras; one shot, or several with cuts between them.

    Attributes:
        stage: what is drawn.
        courses: the cameras of each shot, one after the other.
        size: (width, height) px.
        look: of the pictures.
        seed: decides ground, crowd, people, noise.
    """

    stage: Stage
    courses: tuple[tuple[PinholeCamera, ...], ...]
    size: tuple[int, int] = PICTURE_SIZE
    look: Look = PLAIN
    seed: int = 1

    @cached_property
    def cameras(self) -> tuple[PinholeCamera, ...]:
        """The true camera of every frame, in px of the picture."""
        return tuple(camera for course_ in self.courses for camera in course_)

    @property
    def shots(self) -> tuple[tuple[int, int], ...]:
        """First and last frame of each."""
        ends = np.cumsum([len(course_) for course_ in self.courses]).tolist()
        return tuple(zip([0, *ends[:-1]], [end - 1 for end in ends], strict=True))

    def __len__(self) -> int:
        return len(self.cameras)

    def frame(self, number: int) -> PixelArray:
        """(H, W, 4) BGRA."""
        first, last = next(shot for shot in self.shots if shot[0] <= number <= shot[1])
        camera = self.cameras[number]
        towards = self.cameras[(first + last) // 2]
        # The ground's grain stays; so do people's kits and ways over a shot.
        seconds = (number - first) / FPS
        clean = _scene(
            self.stage, camera, self.size, self.seed + first, self.look, towards, seconds
        )
        if self.look.shutter > 0:
            half = self.look.shutter / 2
            before = between(camera, self.cameras[max(first, number - 1)], half)
            after = between(camera, self.cameras[min(last, number + 1)], half)
            clean = _blurred(clean, camera, before, after)
        return _recorded(clean, self.stage, self.seed + 1000 * number, self.look)

    def write_video(self, path: Path, code: str = "mp4v") -> Path:
        """All frames as a video; its loss is the encoder's."""
        return write_video(path, (self.frame(n) for n in range(len(self))), code)

    def write_pictures(self, folder: Path) -> Path:
        """All frames as PNG files ``00000.png``, ..."""
        folder.mkdir(parents=True, exist_ok=True)
        for number in range(len(self)):
            cv2.imwrite(str(folder / f"{number:05d}.png"), self.frame(number)[..., :3])
        return folder


def write_video(path: Path, frames: Iterable[PixelArray], code: str = "mp4v") -> Path:
    """Pictures, (H, W, 3 or 4) BGR, as a video."""
    writer: cv2.VideoWriter | None = None
    for picture in frames:
        if writer is None:
            size = picture.shape[1], picture.shape[0]
            kind = cv2.VideoWriter.fourcc(*code)
            writer = cv2.VideoWriter(str(path), cv2.CAP_FFMPEG, kind, FPS, size)
            assert writer.isOpened(), f"this OpenCV has no encoder for {code}"
        writer.write(np.ascontiguousarray(picture[..., :3]))
    writer.release()
    return path


MAIN_SOCCER = (0.0, 62.0, -17.0)


def soccer_shot(frames: int = 50, **choices: Any) -> DrawnShot:
    """From the centre circle to the right penalty area, zooming in; choices as `DrawnShot` has."""
    aims = (Aim(2, -2, 1500), Aim(20, 0, 1700), Aim(38, 2, 2100))
    size = choices.get("size", PICTURE_SIZE)
    scaled = [replace(aim, focal_px=aim.focal_px * size[0] / PICTURE_SIZE[0]) for aim in aims]
    cameras = course(MAIN_SOCCER, scaled, frames, size, kappa=0.04)
    return DrawnShot(stage_of("soccer"), (cameras,), **choices)


def cut_shot(frames: int = 40, **choices: Any) -> DrawnShot:
    """Two shots of one tripod, the first to the left and the second to the right goal."""
    size = choices.get("size", PICTURE_SIZE)
    scale = size[0] / PICTURE_SIZE[0]
    left = (Aim(-20, 0, 1600 * scale), Aim(-38, 2, 2000 * scale))
    right = (Aim(36, 4, 1900 * scale), Aim(30, -4, 1700 * scale))
    half = frames // 2
    # However short, they pan no faster: a cut must stand out of the motion around it.
    courses = tuple(
        course(MAIN_SOCCER, aims, max(count, 50), size, kappa=0.04)[:count]
        for aims, count in ((left, half), (right, frames - half))
    )
    return DrawnShot(stage_of("soccer"), courses, **choices)
