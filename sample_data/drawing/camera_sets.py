"""Methods' cameras for the sample: the truth, a homography, a plain pinhole, and faulty ones."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import cv2
import numpy as np
from numpy.typing import NDArray

from drawing.sport import Sport
from drawing.views import EVALUATION_SIZE, PICTURE_SIZE, View, late, perturbed, turned
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.formats.cameras.soccernet import write_camera

FloatArray = NDArray[np.float64]

_YARD_M = 0.9144
_TEMPLATE_CENTRE_YD = (57.5, 37.0)


def camera_files(sport: Sport, view: View) -> dict[str, bytes]:
    """Relative file name -> content, for every set of the sport that has a camera for the frame."""
    files = {}
    for name in sport.sets:
        if name == "homography":
            files[f"{name}/{view.name}.homographyMatrix"] = _homography(sport, view)
        elif name != "bad" or view.bad_camera:
            camera = _CAMERAS[name](sport, view)
            files[f"{name}/camera_{view.name}.json"] = write_camera(camera)
    return files


def visible_points(
    sport: Sport, camera: PinholeCamera, size: tuple[int, int]
) -> tuple[FloatArray, FloatArray]:
    """Field points in the picture: (n, 3) metres and (n, 2) px."""
    points_world = sample_evenly(judged(sport.field), 0.5).points_world
    px, in_front = camera.project(points_world)
    inside = in_front & (px >= 0).all(axis=1) & (px <= np.array(size) - 1).all(axis=1)
    return points_world[inside], px[inside]


def judged(field: Field) -> Field:
    """A field without the elements that a set need not have."""
    return replace(field, elements=tuple(e for e in field.elements if not e.optional))


def _homography(sport: Sport, view: View) -> bytes:
    """Picture px (1280 x 720) to yards, template 115 x 74, origin in the top left corner."""
    points_world, px = visible_points(sport, view.picture_camera, PICTURE_SIZE)
    ground = points_world[:, 2] == 0
    yards = points_world[ground, :2] / _YARD_M + _TEMPLATE_CENTRE_YD
    yards_from_image = np.linalg.inv(_best_homography(yards, px[ground]))
    yards_from_image /= yards_from_image[2, 2]
    # Far below a millimetre, and the same on every machine; adding zero makes -0 a plain one.
    rounded = [np.round(row, d) + 0.0 for row, d in zip(yards_from_image, (8, 8, 11), strict=True)]
    rows = [" ".join(f"{value:.8e}" for value in row) for row in rounded]
    return ("\n".join(rows) + "\n").encode()


def _best_homography(yards: FloatArray, px: FloatArray) -> FloatArray:
    """The homography (3, 3) from yards to px with the least squared distances in px.

    OpenCV stops before the last digits stand still; Gauss-Newton goes on until they do.
    """
    scale = np.array([_TEMPLATE_CENTRE_YD[0], PICTURE_SIZE[0]])  # makes all numbers about one
    from_yards, from_px = (np.diag([1 / s, 1 / s, 1.0]) for s in scale)
    places = np.column_stack([yards / scale[0], np.ones(len(yards))])
    wanted = px / scale[1]
    matrix = from_px @ cv2.findHomography(yards, px, 0)[0] @ np.linalg.inv(from_yards)
    for _ in range(20):
        matrix /= matrix[2, 2]
        shown = places @ matrix.T
        found, relative = shown[:, :2] / shown[:, 2:], places / shown[:, 2:]
        jacobian = np.zeros((len(places), 2, 8))
        jacobian[:, 0, :3] = jacobian[:, 1, 3:6] = relative
        jacobian[:, :, 6:] = -found[:, :, None] * relative[:, None, :2]
        step = np.linalg.lstsq(jacobian.reshape(-1, 8), (wanted - found).ravel(), rcond=None)[0]
        matrix += np.append(step, 0.0).reshape(3, 3)
    return np.linalg.inv(from_px) @ matrix @ from_yards


def _without_distortion(sport: Sport, view: View) -> PinholeCamera:
    """The pinhole camera without distortion that comes nearest, by Gauss-Newton on the pixels."""
    points_world, px = visible_points(sport, view.camera, EVALUATION_SIZE)
    start = replace(view.camera, radial=(0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    if not view.camera.is_distorted:
        return start
    parameters = np.zeros(7)
    steps = np.array([1e-5, 1e-5, 1e-5, 1e-3, 1e-3, 1e-3, 1e-5])
    for _ in range(40):
        residual = (_moved(start, parameters).project(points_world)[0] - px).ravel()
        columns = []
        for i, step in enumerate(steps):
            ahead = parameters.copy()
            ahead[i] += step
            moved = (_moved(start, ahead).project(points_world)[0] - px).ravel()
            columns.append((moved - residual) / step)
        jacobian = np.column_stack(columns)
        damping = np.diag((jacobian**2).sum(axis=0)) * 1e-3
        parameters -= np.linalg.solve(jacobian.T @ jacobian + damping, jacobian.T @ residual)
    # Far below a thousandth of a pixel, and the same on every machine.
    found = _moved(start, np.round(parameters, 7))
    focal = round(found.focal_px[0], 7)
    return replace(found, focal_px=(focal, focal))


def _moved(camera: PinholeCamera, parameters: FloatArray) -> PinholeCamera:
    pan, tilt, roll, x, y, z, log_focal = (float(p) for p in parameters)
    focal = camera.focal_px[0] * float(np.exp(log_focal))
    px, py, pz = camera.position_world
    return replace(
        camera,
        pan_rad=camera.pan_rad + pan,
        tilt_rad=camera.tilt_rad + tilt,
        roll_rad=camera.roll_rad + roll,
        position_world=(px + x, py + y, pz + z),
        focal_px=(focal, focal),
    )


_CAMERAS: dict[str, Callable[[Sport, View], PinholeCamera]] = {
    "true": lambda _, view: view.camera,
    "pinhole": _without_distortion,
    "bad": lambda _, view: perturbed(view.camera, int(view.name)),
    "late": lambda _, view: late(view.camera, int(view.name)),
    "turned": lambda _, view: turned(view.camera),
}
