"""Cameras of capture systems: Spiideo SynLoc, OpenTrackIO, Qualisys.

Facts: SynLoc https://github.com/Spiideo/sskit (``camera_matrix`` maps the world to rays,
``dist_poly`` the angle of a ray to its radius in widths of the picture from its centre);
OpenTrackIO 1.0.1 https://www.opentrackio.org and its note on OpenCV's parameters; Qualisys
``.qca.txt`` as Pose2Sim reads it (intrinsics in 1/64 px, millimetres). All worlds have z up.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.formats.cameras.json_values import JsonValues, lists_objects
from procc_annotator.formats.cameras.krt import HALF_TURN, KRT_KEYS, KrtKeys, centred_k, krt_from
from procc_annotator.formats.cameras.krt_sets import BY_ORDER, depth_of
from procc_annotator.formats.cameras.lens_curves import distortion_of_inverse, fisheye_of_polynomial
from procc_annotator.formats.cameras.loaded_camera import (
    CameraRecord,
    CameraRecords,
    LoadedCamera,
    with_notices,
)
from procc_annotator.formats.strict_json import finite_number
from procc_annotator.messages import pluralize

_EXACT_PX = 0.01  # what a lens that is fitted may differ by without a word
# RMS in widths of the picture, beyond which it is another lens: 19 px of 1920, no camera to judge.
_NO_LENS = 0.01
_FURTHEST = 2.0  # times its distance from the axis a lens of 134 degrees moves the picture's corner
_UNIT = "give radial coefficients by powers of mm on the sensor, not of the focal length"
# SynLoc counts x across the field and y along it; here x runs along it and y to the main camera.
_ACROSS = KrtKeys(
    axes=np.array([[0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]]), kind="a SynLoc camera"
)
_MATRIX, _POLY = "camera_matrix", "dist_poly"


def synloc_records(content: Any, path: str) -> CameraRecords:
    """The cameras of the images of a decoded file.

    Raises:
        CameraError: none has one.
    """
    images = content["images"] if lists_objects(content, {_MATRIX}, "images") else []
    own = [(str(e.get("file_name", i)), CameraRecord(f"images[{i}]", e))
           for i, e in enumerate(images) if type(e) is dict and _MATRIX in e]  # fmt: skip
    left = len(images) - len(own)
    notices = (f"{pluralize(left, 'image has', 'images have')} no camera",) if left else ()
    return CameraRecords.of(path, own, _synloc_camera, notices, f"images with {_MATRIX}")


def _synloc_camera(content: Any, path: str, inside: str) -> LoadedCamera:
    values = JsonValues.of(content, path, inside, _ACROSS.kind)
    size = values.size()
    if size is None:
        raise values.missing("the size of the picture", "width", "height")
    matrix = values.matrix(_MATRIX, 4 if len(values.numbers(_MATRIX)) == 16 else 3, 4)[:3]
    # Rays are divided by their third coordinate: its sign says nothing.
    matrix = matrix * np.sign(np.linalg.det(matrix[:, :3]))
    width, height = size
    try:
        focal, k, off = fisheye_of_polynomial(
            np.array(values.numbers(_POLY)), math.hypot(width - 1, height - 1) / 2 / width
        )
    except ValueError as error:
        raise values.error(str(error), _POLY) from error
    focal *= width
    own = {
        "K": [[focal, 0, (width - 1) / 2], [0, focal, (height - 1) / 2], [0, 0, 1]],
        "R": matrix[:, :3].tolist(), "t": matrix[:, 3].tolist(), "model": "fisheye",
        "dist": k.tolist(), "width": width, "height": height,
    }  # fmt: skip
    loaded = krt_from(own, path, inside, _ACROSS)
    # The other polynomial is the inverse of the first.
    notices = values.unused(_MATRIX, _POLY, "undist_poly")
    return with_notices(loaded, (*_fitted(off * width, width, values, _POLY), *notices))


def _fitted(
    off_px: FloatArray, width: float, values: JsonValues, key: str, advice: str = "correct it"
) -> tuple[str, ...]:
    rms, most = float(np.sqrt(np.mean(off_px**2))), float(np.abs(off_px).max())
    off = f"the closest lens differs by {rms:.2g} px (RMS), {most:.2g} px at most"
    if not rms <= _NO_LENS * width:
        raise values.error(off, key, advice)
    return (f"{key}: {off}",) if most > _EXACT_PX else ()


_OTIO = KrtKeys(axes=HALF_TURN, kind="an OpenTrackIO sample")
# Its camera looks along y, x to the right, z up; here x is right, y down, z forward.
_CAMERA_AXES = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
_USUAL_WIDTH, _PUPIL = 1920, "entrancePupilOffset"
_LENS_USED = (
    "pinholeFocalLength", "distortion", "projectionOffset", "nominalFocalLength",
    "distortionOverscan", "undistortionOverscan", "focusDistance",
)  # fmt: skip


def is_opentrackio(content: Any) -> bool:
    """Return whether decoded content is a sample of OpenTrackIO, or a list of them."""
    entries = content if type(content) is list else [content]
    return lists_objects(entries, {"transforms", "lens"})


def opentrackio_records(content: Any, path: str) -> CameraRecords | None:
    """The cameras of a list of samples, of which some repeat what is static; None for one."""
    if type(content) is not list:
        return None
    found: list[tuple[str, CameraRecord]] = []
    static: object = {}
    for i, sample in enumerate(content):
        if type(sample) is dict:
            static = sample.get("static", static)
            sample = {"static": static, **sample}
        found.append((str(i), CameraRecord(f"[{i}]", sample)))
    return CameraRecords.of(path, found, opentrackio_from, (BY_ORDER,))


def opentrackio_from(content: Any, path: str, inside: str = "") -> LoadedCamera:
    """The camera of a sample, whose transforms lead from the stage to the sensor. `CameraError` if
    a part is missing, or is not what it should be."""
    import cv2  # most sets have none of these files

    sample = JsonValues.of(content, path, inside, _OTIO.kind)
    camera = sample.part("static").part("camera")
    lens, sensor = sample.part("lens"), camera.part("activeSensorPhysicalDimensions")
    mm = np.array([sensor.focal("width"), sensor.focal("height")])
    pixels = "activeSensorResolution"
    size = camera.part(pixels).size() if pixels in camera else None
    unsized = () if size else (f"names no {pixels}: a width of {_USUAL_WIDTH} px is taken",)
    size = size or (_USUAL_WIDTH, round(float(_USUAL_WIDTH * mm[1] / mm[0])))
    offset = np.zeros(2)
    if "projectionOffset" in lens:
        shift = lens.part("projectionOffset")
        offset = np.array([shift.number("x"), shift.number("y")])
    focal_mm = lens.focal("pinholeFocalLength")
    fx, fy = (focal_mm * np.array(size) / mm).tolist()
    cx, cy = (np.array(size) / 2 + offset * size / mm).tolist()
    distortion, notices = _brown_conrady(lens, focal_mm, float(np.hypot(*mm) / 2), fx, size[0])
    # Each transform is relative to the one before it: camera -> stage.
    rotation, position = np.eye(3), np.zeros(3)
    transforms = sample.content.get("transforms")
    for i in range(len(transforms) if type(transforms) is list else 1):
        own = sample.part("transforms", i)
        moved, turned = own.part("translation"), own.part("rotation")
        if set(own.content.get("scale", {"x": 1}).values()) != {1}:
            raise own.error("expected a scale of 1", "scale")
        pan, tilt, roll = turned.radians("pan", "tilt", "roll")
        position = position + rotation @ np.array([moved.number(key) for key in "xyz"])
        for turn in ((0.0, 0.0, pan), (tilt, 0.0, 0.0), (0.0, roll, 0.0)):
            rotation = rotation @ cv2.Rodrigues(np.array(turn))[0]
    pupil_m = lens.number(_PUPIL) if _PUPIL in lens else 0.0  # in front of the sensor
    position = position + rotation @ np.array([0.0, pupil_m, 0.0])
    own_parts = {
        "K": centred_k(fx, fy, cx, cy), "R": (_CAMERA_AXES @ rotation.T).tolist(),
        "position": position.tolist(), "dist": distortion, "width": size[0], "height": size[1],
    }  # fmt: skip
    loaded = krt_from(own_parts, path, inside, _OTIO)
    return with_notices(loaded, (*unsized, *notices, *lens.unused(*_LENS_USED)))


def _brown_conrady(
    lens: JsonValues, focal_mm: float, corner_mm: float, focal_px: float, width: int
) -> tuple[list[float], tuple[str, ...]]:
    """OpenCV's distortion of the first model of a lens, and remarks.

    Coefficients go by millimetres on the sensor, alternating between numerator and denominator.
    """
    models = lens.content.get("distortion") or []
    if type(models) is not list or not models:
        return [], ()
    own = lens.part("distortion", 0)
    model = own.content.get("model", _MODELS[0])
    if model not in _MODELS:
        raise own.error(f"expected {' or '.join(_MODELS)}", "model", "write it as one of these")
    given, more = (own.numbers(k) if k in own else () for k in ("radial", "tangential"))
    if len(given) > 6 or len(more) > 2:
        raise own.error("has more than 6 radial or 2 tangential coefficients")
    radial = np.array([*given, *[0.0] * (6 - len(given))])
    radial *= focal_mm ** np.array([2.0, 2, 4, 4, 6, 6])
    p1, p2 = (np.array([*more, 0.0, 0.0])[:2] * focal_mm**2).tolist()
    up, down, corner = radial[::2], radial[1::2], corner_mm / focal_mm
    at = corner ** np.array([2, 4, 6])
    moved = float((1 + up @ at) / (1 + down @ at))
    if not 1 / _FURTHEST < moved < _FURTHEST:
        what = f"moves the corner of the picture to {moved:.3g} times its distance from the axis"
        raise own.error(what, "radial", _UNIT)
    if model == _MODELS[1]:
        n1, d1, n2, d2, n3, d3 = radial.tolist()
        return [n1, n2, p1, p2, n3, d1, d2, d3], ()
    try:
        k, off = distortion_of_inverse(up, down, corner)
    except ValueError as error:
        raise own.error(str(error), "radial") from error
    k1, k2, k3 = k.tolist()
    # To the first order the inverse of a tangential distortion is its negative.
    return [k1, k2, -p1, -p2, k3], _fitted(off * focal_px, width, own, "radial", _UNIT)


_MODELS = ("Brown-Conrady D-U", "Brown-Conrady U-D")  # from picture to scene, and back
_QUALISYS = KrtKeys(axes=HALF_TURN, unit_m=0.001, kind="a Qualisys camera")
_SUBPIXELS = 64.0
_INTRINSIC = (
    "focalLengthU", "focalLengthV", "centerPointU", "centerPointV", "radialDistortion1",
    "radialDistortion2", "tangentalDistortion1", "tangentalDistortion2",
)  # fmt: skip
_ROTATION = tuple(f"r{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3))


def is_qualisys(content: Any) -> bool:
    """Return whether decoded content is the XML of a Qualisys calibration."""
    return getattr(content, "tag", "") == "calibration" and content.find("cameras") is not None


def qualisys_records(content: Any, path: str) -> CameraRecords:
    """The cameras of a calibration, named by serial number. `CameraError` if it lists none."""
    cameras = content.findall("cameras/camera") if is_qualisys(content) else []
    found = [(c.get("serial", str(i)), CameraRecord(f"camera {i}", c))
             for i, c in enumerate(cameras, 1)]  # fmt: skip
    return CameraRecords.of(path, found, _qualisys_camera, (), "<calibration><cameras><camera>")


def _qualisys_camera(content: Any, path: str, inside: str) -> LoadedCamera:
    def part(tag: str) -> JsonValues:
        found = content.find(tag)
        own = {} if found is None else {k: finite_number(v.strip()) for k, v in found.items()}
        return JsonValues(own, path, f"{inside}: {tag}", _QUALISYS.kind)

    view = part("fov_video" if content.find("fov_video") is not None else "fov")
    left, top, right, bottom = map(view.number, ("left", "top", "right", "bottom"))
    lens, pose = part("intrinsic"), part("transform")
    fx, fy, cx, cy, *distortion = (lens.number(name) / _SUBPIXELS for name in _INTRINSIC)
    # Its cameras look along -z, y up.
    rotation = HALF_TURN @ np.array([*map(pose.number, _ROTATION)]).reshape(3, 3)
    own = {
        "K": [[fx, 0, cx - left], [0, fy, cy - top], [0, 0, 1]], "R": rotation.tolist(),
        "position": [*map(pose.number, "xyz")], "dist": distortion,
        "width": right - left + 1, "height": bottom - top + 1,
    }  # fmt: skip
    return with_notices(krt_from(own, path, inside, _QUALISYS), lens.unused(*_INTRINSIC))


POSE2SIM = KrtKeys(
    k=("matrix",), r=("rotation",), t=("translation",), position=(), pose=(), inverse_pose=(),
    distortion=("distortions", "distortion"), model=(), size=("size",), up_or_down=True,
    repeated=("name",), kind="a Pose2Sim, Anipose or Caliscope camera",
)  # fmt: skip
FIFA = KrtKeys(distortion=("k",), up_or_down=True, kind="a camera of FIFA's Skeletal Tracking")
_FIRST_CAMERA = "its world is the first camera's, not the field's: lay it upon the field first"
MODEL_WORLD = KrtKeys(
    k=("intrinsic", "intrinsics"), r=(), t=(), position=(),
    pose=("extrinsic", "extrinsics"), inverse_pose=("cam_c2w", "c2w"), repeated=("pose_enc",),
    kind="a camera of VGGT or MegaSaM", remark=_FIRST_CAMERA,
)  # fmt: skip


def is_fifa(content: Any) -> bool:
    """Return whether decoded arrays are a sequence of FIFA's: K and k for each frame, R, t."""
    has_keys = type(content) is dict and {"K", "k", "R", "t"} <= content.keys()
    return has_keys and depth_of(content["K"]) == 3 and depth_of(content["k"]) == 2


def is_model_world(content: Any) -> bool:
    """Return whether decoded arrays are what VGGT or MegaSaM write: stacks, without a size."""
    if not MODEL_WORLD.are_in(content) or {KRT_KEYS.k[0], "width"} & content.keys():
        return False
    poses = (*MODEL_WORLD.pose, *MODEL_WORLD.inverse_pose)
    return any(depth_of(content.get(key)) > 2 for key in poses)
