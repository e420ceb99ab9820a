"""Homography files with their world conventions, and matrix files of unknown kind."""

from __future__ import annotations

from dataclasses import dataclass
from functools import partial

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.camera.models import HomographyCamera
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.arrays import NPY_MAGIC, npy_array
from procc_annotator.formats.cameras.json_values import JsonValues
from procc_annotator.formats.cameras.krt import projection_from
from procc_annotator.formats.cameras.krt_sets import BY_ORDER
from procc_annotator.formats.cameras.loaded_camera import CameraRecord, CameraRecords, LoadedCamera
from procc_annotator.formats.strict_json import finite_number, printable, utf8_text

YARD_M = 0.9144
HOMOGRAPHY_SIZE = (1280, 720)
_LARGEST_FILE = 64 * 1024  # of text on one line
_ROTATION_TOLERANCE = 1e-3  # numbers of three digits
_TURNED = "takes the ground to the picture, not the picture to the ground"
_CHOOSE = " (expected metres from the field's centre, or the units of the camera format)"
# Half the length and width of the largest field, soccer's, and how far next to it a camera may
# look.
_BESIDE_M = 50.0
_SEEN = np.array([52.5, 34.0]) + _BESIDE_M


@dataclass(frozen=True)
class WorldConvention:
    """World coordinates of a data set: ``metres = (units - centre) * unit_m``."""

    title: str
    unit_m: float
    centre: tuple[float, float]

    @property
    def world_from_units(self) -> FloatArray:
        """(3, 3) the data set's world -> metres of ours."""
        x, y = self.centre
        return np.array(
            [
                [self.unit_m, 0.0, -x * self.unit_m],
                [0.0, self.unit_m, -y * self.unit_m],
                [0.0, 0.0, 1.0],
            ]
        )


CONVENTIONS = {
    "wc14": WorldConvention(
        "World Cup 2014: yards, 115 x 74, origin top left", YARD_M, (57.5, 37.0)
    ),
    "carwc": WorldConvention(
        "CARWC, TS-WorldCup: yards, 114.83 x 74.37, origin top left", YARD_M, (57.415, 37.185)
    ),
    "world": WorldConvention("world metres, origin at the field's centre", 1.0, (0.0, 0.0)),
}


def read_homography(data: bytes, *, path: str, convention: str) -> LoadedCamera:
    """Read a homography that maps picture pixels (of a 1280 x 720 picture) to the ground.

    Text holds nine numbers separated by white space or commas; ``.npy`` is recognised by its
    content and never unpickled.

    Raises:
        CameraError: not nine finite numbers, or a matrix that cannot be inverted.
    """
    matrix = _matrices(data, path)
    if matrix.shape != (3, 3):
        raise _wrong_shape(matrix, path)
    return _of_matrix(matrix, path, "", convention, assumed=False)


def camera_from_homography(
    units_from_image: FloatArray,
    world_from_units: FloatArray,
    size: tuple[int, int],
    *,
    path: str,
    place: str = "",
    assumed: bool = False,
) -> LoadedCamera:
    """A camera from a matrix picture -> field and one field -> world metres; where it sees no
    ground of a field, a remark says what the numbers look like.

    Args:
        units_from_image: (3, 3). world_from_units: (3, 3).
        size: (width, height) of the picture, px; the usual one.
        path: for error messages. place: likewise.
        assumed: whether no one said what the matrix is: one of a soccer field, and read the other
            way round where it takes the ground to the picture.

    Raises:
        CameraError: a matrix that cannot be inverted.
    """
    # Only the ratios of the entries count; without the factor, huge ones would overflow below.
    matrix = units_from_image / (np.abs(units_from_image).max() or 1.0)
    try:
        camera = HomographyCamera.from_world_from_image(world_from_units @ matrix, size)
    except ValueError as error:
        raise CameraError(
            path,
            f"is not a homography: {error}",
            place=place,
            advice="expected picture to field, 3 x 3",
        ) from error
    notice = ""
    if not _shows_field(camera, size):
        turned = _turned(matrix, world_from_units, size)
        if turned is None:
            notice = _looks_like(matrix, size)
        else:
            notice = f"{_TURNED}: {'it is inverted' if assumed else 'give the inverse'}"
            camera = turned if assumed else camera
    return LoadedCamera(
        camera,
        "homography",
        size,
        notices=(notice,) if notice else (),
        assumed_field="soccer" if assumed else "",
        size_is_usual=True,
    )


def _shows_field(camera: HomographyCamera, size: tuple[int, int]) -> bool:
    """Return whether the middle of a picture's lower edge is ground within sight of a field."""
    ground = camera.ground_from_px(np.array([[(size[0] - 1) / 2, size[1] - 1.0]]))
    with np.errstate(invalid="ignore"):
        return bool((np.abs(ground) < _SEEN).all())


def _turned(
    units_from_image: FloatArray, world_from_units: FloatArray, size: tuple[int, int]
) -> HomographyCamera | None:
    """The camera of the same nine numbers read the other way round, where that shows a field."""
    try:
        inverse = world_from_units @ np.linalg.inv(units_from_image)
        camera = HomographyCamera.from_world_from_image(inverse, size)
    except (ValueError, np.linalg.LinAlgError):
        return None
    return camera if _shows_field(camera, size) else None


def _looks_like(units_from_image: FloatArray, size: tuple[int, int]) -> str:
    centimetres = np.diag([0.01, 0.01, 1.0]) @ units_from_image
    camera = HomographyCamera.from_world_from_image(centimetres, size)
    if _shows_field(camera, size):
        xs, ys = np.linspace(0, size[0] - 1, 5), np.linspace(size[1] / 2, size[1] - 1, 5)
        seen = camera.ground_from_px(np.stack(np.meshgrid(xs, ys), axis=-1).reshape(-1, 2))
        seen = seen[(np.abs(seen) < _SEEN).all(axis=1)]
        corner = (seen > -_BESIDE_M).all()
        return f"looks like centimetres from {'a corner' if corner else 'the centre'}{_CHOOSE}"
    return f"does not look at a field{_CHOOSE}"


def numbers_of_text(data: bytes, path: str) -> list[float]:
    """The numbers of a text, separated by white space or commas; # begins a comment. `CameraError`
    for no text, or something else than finite numbers."""
    text = utf8_text(data, path)
    numbers: list[float] = []
    for line_number, line in enumerate(text.splitlines(), 1):
        for word in line.partition("#")[0].replace(",", " ").split():
            number = finite_number(word)
            if number is None:
                problem = f"expected a finite number, found {word[:40]!r}"
                raise JsonValues({}, path).error(problem, f"line {line_number}")
            numbers.append(number)
    return numbers


_SHAPES = {9: (3, 3), 12: (3, 4), 16: (4, 4)}  # by the numbers of a matrix


def _matrices(data: bytes, path: str) -> FloatArray:
    """The numbers of a file: one of `_SHAPES`, or a stack; text has one of these a line."""
    if data.startswith(NPY_MAGIC):
        array = npy_array(data, path, "3 x 3 numbers")
        if array.dtype.kind not in "fiu":
            found = printable(str(array.dtype))
            raise CameraError(path, f"expected an array of real numbers, found {found}")
        with np.errstate(over="ignore"):  # a longer float may become infinite, and is refused
            matrices = array.astype(np.float64)
    elif len(data) > _LARGEST_FILE and data.count(b"\n") < 2:
        problem = f"is larger than {_LARGEST_FILE // 1024} kB, expected 9 numbers (3 x 3)"
        raise CameraError(path, problem, advice="is it this file?")
    else:
        lines = [n for n in (line.partition(b"#")[0] for line in data.splitlines()) if n.strip()]
        numbers = np.array(numbers_of_text(data, path))
        alone = _SHAPES.get(len(numbers))
        stacked = _SHAPES.get(len(numbers) // len(lines)) if lines else None
        if alone is None and stacked is not None and len(numbers) % len(lines) == 0:
            matrices = numbers.reshape(-1, *stacked)
        else:
            matrices = numbers.reshape(alone) if alone else numbers
    return matrices


def _finite(matrix: FloatArray, path: str, inside: str) -> FloatArray:
    if len(bad := np.argwhere(~np.isfinite(np.atleast_2d(matrix)))):
        place = f"row {bad[0][-2] + 1} column {bad[0][-1] + 1}"
        problem = f"expected a finite number, found {np.atleast_2d(matrix)[tuple(bad[0])]}"
        raise JsonValues({}, path, inside).error(problem, place)
    return matrix


def _wrong_shape(matrix: FloatArray, path: str) -> CameraError:
    shape = " x ".join(str(n) for n in matrix.shape) or "a single value"
    problem = f"expected a 3 x 3 matrix, found {printable(shape)}"
    if matrix.ndim == 1:
        worlds, count = ", ".join(CONVENTIONS), len(matrix)
        problem = f"{worlds}: expected 9 numbers (3 x 3), found {count}; projection: expected 12"
    return CameraError(path, problem, advice="the file may be cut off")


def _assumed(data: bytes, path: str) -> str:
    """The convention of a homography that no one named."""
    is_npy = data.startswith(NPY_MAGIC) or path.lower().endswith(".npy")
    return "carwc" if is_npy else "wc14"


def read_matrix_file(data: bytes, *, path: str) -> LoadedCamera:
    """The camera of a matrix in a file that no one named the format of. `CameraError` for no matrix
    of a camera."""
    matrix = _matrices(data, path)
    if matrix.shape not in _SHAPES.values():
        raise _wrong_shape(matrix, path)
    return _of_matrix(matrix, path, "", _assumed(data, path))


def matrix_records(data: bytes, *, path: str) -> CameraRecords | None:
    """The cameras of an ``.npy`` with a matrix a frame, or of text with one a line; None for a file
    of one. `CameraError` if it is damaged."""
    matrices = _matrices(data, path)
    if matrices.ndim != 3 or matrices.shape[1:] not in _SHAPES.values():
        return None
    found = [(str(i), CameraRecord(f"[{i}]", matrix)) for i, matrix in enumerate(matrices)]
    read = partial(_of_matrix, convention=_assumed(data, path))
    return CameraRecords.of(path, found, read, (BY_ORDER,))


def _of_matrix(
    matrix: FloatArray, path: str, inside: str, convention: str, assumed: bool = True
) -> LoadedCamera:
    matrix = _finite(matrix, path, inside)
    if matrix.shape != (3, 3):
        return _of_projection(matrix, path, inside)
    world = CONVENTIONS[convention].world_from_units
    return camera_from_homography(
        matrix, world, HOMOGRAPHY_SIZE, path=path, place=inside, assumed=assumed
    )


def _of_projection(matrix: FloatArray, path: str, inside: str) -> LoadedCamera:
    """The camera of (3, 4), or of (4, 4) with a last row that counts for nothing; CameraError for
    no camera, or a pose alone."""
    left = matrix[:3, :3]
    if np.allclose(left @ left.T, np.eye(3), atol=_ROTATION_TOLERANCE):
        raise CameraError(
            path,
            "holds a pose (a rotation and a translation) without a lens, expected K [R | t]",
            place=inside,
            advice="save both: numpy.savez(name, K=K, w2c=pose), or c2w for camera to world",
        )
    return projection_from(matrix[:3].tolist(), path, inside)
