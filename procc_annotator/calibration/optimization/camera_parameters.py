"""Camera models that can be fitted, and their parameters as vectors.

A pinhole vector, (11,), holds in this order:

| index | what | unit |
|---|---|---|
| PAN, TILT, ROLL | angles | rad |
| X, Y, Z (together CENTRE) | where the camera stands, world frame | metres |
| LOG_FOCAL | logarithm of the focal length | of solver px |
| KAPPA | radial coefficient | - |
| ASPECT | aspect ratio less one | - |
| PRINCIPAL_X, PRINCIPAL_Y | principal point less the picture's centre | solver px |

A strong lens takes two more, (13,): SECOND, its second coefficient, and FISHEYE, 1 for OpenCV's
fisheye and 0 for a radial lens, which is never free. A fisheye's KAPPA and SECOND are k1 and k2 of
its angles, a radial lens's second one is scaled as kappa is: k2 = SECOND (f / h)^4.

kappa is scaled so that it is of the same size for every zoom: a pixel lies at v (1 + kappa |v|^2 /
h^2) from the principal point, where v is its undistorted place and h half the picture's diagonal;
k1 = kappa (f / h)^2.
"""

from __future__ import annotations

import math

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.calibration.optimization.observations import ImageFrame
from procc_annotator.camera.models import FisheyeCamera, HomographyCamera, PinholeCamera

PARAMETERS = (
    "pan",
    "tilt",
    "roll",
    "x",
    "y",
    "z",
    "log_focal",
    "kappa",
    "aspect",
    "principal_x",
    "principal_y",
)
PAN, TILT, ROLL, X, Y, Z, LOG_FOCAL, KAPPA, ASPECT, PRINCIPAL_X, PRINCIPAL_Y = range(11)
SECOND_KAPPA, FISHEYE_FLAG = 11, 12  # of a strong lens
POSITION_SLICE = slice(X, Z + 1)
# Barrel distortion of this size shows places up to 1.11 h from the principal point; below -4 / 27
# it would not reach the picture's corners.
MIN_KAPPA = -0.12
# The first so many parameters of a pinhole model are free, the others stay at zero.
FREE_PARAMETERS = {"P": 7, "R": 8, "R+": 11, "R2": 12, "F": 12}
MODELS = ("H", *FREE_PARAMETERS)
WIDE_ANGLE_MODELS = ("R2", "F")


def is_wide_angle(vectors: FloatArray) -> bool:
    """Return whether parameters, of one camera or several, are those of a strong lens."""
    return bool(vectors.shape[-1] > SECOND_KAPPA)


def is_fisheye(vectors: FloatArray) -> bool:
    """Return whether they are those of fisheyes."""
    return is_wide_angle(vectors) and bool(vectors[..., FISHEYE_FLAG].all())


def lower_bounded_parameter(vectors: FloatArray) -> int | None:
    """The parameter that may not fall below 0 unless it starts there: of a lens of one coefficient,
    which would fold."""
    return None if is_wide_angle(vectors) else KAPPA


def parameter_names(model: str) -> tuple[str, ...]:
    """Names of a pinhole model's free parameters."""
    names = {"R2": (*PARAMETERS, "kappa2"), "F": (*PARAMETERS, "k2")}
    plain = names.get(model, PARAMETERS)[: FREE_PARAMETERS[model]]
    return tuple("k1" if model == "F" and name == "kappa" else name for name in plain)


def camera_from_vector(vector: FloatArray, frame: ImageFrame) -> PinholeCamera:
    """The camera, in px of the picture, of a pinhole vector (11,), or (13,) of a radial lens."""
    focal = math.exp(vector[LOG_FOCAL])
    k1 = float(vector[KAPPA]) * (focal / frame.half_diagonal) ** 2
    k2 = (
        float(vector[SECOND_KAPPA]) * (focal / frame.half_diagonal) ** 4
        if is_wide_angle(vector)
        else 0.0
    )
    fy = focal / frame.scale
    (cx, cy), scale_x = frame.centre_px, frame.scales[0]
    return PinholeCamera(
        math.remainder(float(vector[PAN]), math.tau),
        float(vector[TILT]),
        float(vector[ROLL]),
        (float(vector[X]), float(vector[Y]), float(vector[Z])),
        (fy / frame.pixel_aspect * (1 + float(vector[ASPECT])), fy),
        (
            cx + float(vector[PRINCIPAL_X] / scale_x),
            cy + float(vector[PRINCIPAL_Y]) / frame.scale,
        ),
        (k1, k2, 0.0, 0.0, 0.0, 0.0),
    )


def fisheye_from_vector(vector: FloatArray, frame: ImageFrame) -> FisheyeCamera:
    """The camera of a fisheye's vector (13,), in pixels of the picture."""
    lens = float(vector[KAPPA]), float(vector[SECOND_KAPPA])
    plain = camera_from_vector(vector[:SECOND_KAPPA], frame)
    return FisheyeCamera(
        plain.pan_rad,
        plain.tilt_rad,
        plain.roll_rad,
        plain.position_world,
        plain.focal_px,
        plain.principal_point_px,
        (*lens, 0.0, 0.0),
    )


def wide_angle_vector_from_camera(
    camera: PinholeCamera | FisheyeCamera, frame: ImageFrame
) -> FloatArray:
    """The vector (13,) of a strong lens closest to a camera: higher terms are dropped."""
    if isinstance(camera, FisheyeCamera):
        place = camera.position_world
        pinhole = PinholeCamera(
            camera.pan_rad, camera.tilt_rad, camera.roll_rad, place, camera.focal_px,
            camera.principal_point_px,
        )  # fmt: skip
        first, second = camera.coefficients[:2]
        vector = np.concatenate([vector_from_camera(pinhole, frame), (second, 1.0)])
    else:
        plain = vector_from_camera(camera, frame)
        reach = frame.half_diagonal / math.exp(plain[LOG_FOCAL])
        first, second = camera.radial[0] * reach**2, camera.radial[1] * reach**4
        vector = np.concatenate([plain, (second, 0.0)])
    vector[KAPPA] = first
    return vector


def rotated_180(vectors: FloatArray) -> FloatArray:
    """(B, 11) pinhole parameters after half a turn of the camera about the field's centre."""
    other = vectors.copy()
    other[:, PAN] += math.pi
    other[:, [X, Y]] *= -1
    return other


def vector_from_camera(camera: PinholeCamera, frame: ImageFrame) -> FloatArray:
    """The pinhole vector (11,) closest to a camera in px of the picture: higher distortion terms
    are dropped."""
    fx, fy = camera.focal_px
    focal = abs(fy) * frame.scale
    centre = frame.centre_px
    return np.array(
        [
            camera.pan_rad,
            camera.tilt_rad,
            camera.roll_rad,
            *camera.position_world,
            math.log(focal),
            max(camera.radial[0] * (frame.half_diagonal / focal) ** 2, MIN_KAPPA),
            fx * frame.pixel_aspect / fy - 1,
            (camera.principal_point_px[0] - centre[0]) * frame.scales[0],
            (camera.principal_point_px[1] - centre[1]) * frame.scale,
        ]
    )


def rotation_matrices(vectors: FloatArray) -> FloatArray:
    """(B, >= 3) pan, tilt, roll -> (B, 3, 3) world to camera, as `rotation_cam_from_world`."""
    turn = np.empty((2, 3, len(vectors)))  # cosines, then sines
    np.cos(vectors[:, :3].T, out=turn[0])
    np.sin(vectors[:, :3].T, out=turn[1])
    pan, (ct, st), roll = turn[:, 0], turn[:, 1], turn[:, 2]
    panned = roll[:, None] * pan  # by cosine and sine of the roll, of the pan
    tilted = roll[:, None] * (pan * ct)
    found = np.empty((len(vectors), 3, 3))
    found[:, 0, 0] = panned[0, 0] - tilted[1, 1]
    found[:, 0, 1] = panned[0, 1] + tilted[1, 0]
    found[:, 1, 0] = -panned[1, 0] - tilted[0, 1]
    found[:, 1, 1] = tilted[0, 0] - panned[1, 1]
    found[:, 0, 2], found[:, 1, 2] = st * roll[::-1]
    found[:, 2, 0], found[:, 2, 1] = st * pan[1], -pan[0] * st
    found[:, 2, 2] = ct
    return found


def homography_from_pinhole(vector: FloatArray) -> FloatArray:
    """(3, 3) ground (x, y, 1) in metres -> solver px, of a pinhole vector; no distortion."""
    rotation = rotation_matrices(vector[None])[0]
    focal = math.exp(vector[LOG_FOCAL])
    lens = np.array(
        [
            [focal * (1 + vector[ASPECT]), 0.0, vector[PRINCIPAL_X]],
            [0.0, focal, vector[PRINCIPAL_Y]],
            [0.0, 0.0, 1.0],
        ]
    )
    from_ground = np.column_stack([rotation[:, :2], -rotation @ vector[POSITION_SLICE]])
    return np.asarray(lens @ from_ground)


def homography_camera(image_from_ground: FloatArray, frame: ImageFrame) -> HomographyCamera:
    """The camera of a homography in solver px."""
    (sx, sy), (cx, cy) = frame.scales, frame.centre_px
    picture = np.array([[1 / sx, 0.0, cx], [0.0, 1 / sy, cy], [0.0, 0.0, 1.0]])
    return HomographyCamera(picture @ image_from_ground)


def homography_from_camera(camera: HomographyCamera, frame: ImageFrame) -> FloatArray:
    """(3, 3) ground -> solver px; the inverse of `homography_camera`.

    Scaled so that the depth of ground points is about that in metres.
    """
    (sx, sy), (cx, cy) = frame.scales, frame.centre_px
    solver = np.array([[sx, 0.0, -cx * sx], [0.0, sy, -cy * sy], [0.0, 0.0, 1.0]])
    matrix = solver @ camera.image_from_world
    norm = float(np.hypot(matrix[2, 0], matrix[2, 1]))
    return np.asarray(matrix / norm if norm > 0 else matrix)
