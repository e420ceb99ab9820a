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
from procc_annotator.errors import CameraError
from procc_annotator.formats.cameras.json_values import JsonValues
from procc_annotator.formats.cameras.krt import (
    HALF_TURN,
    KRT_KEYS,
    KrtKeys,
    camera_of_matrices,
    centred_k,
    krt_from,
)
from procc_annotator.formats.cameras.krt_sets import BY_ORDER
from procc_annotator.formats.cameras.lens_curves import (
    distortion_of_inverse,
    fisheye_of_polynomial,
)
from procc_annotator.formats.cameras.loaded_camera import (
    CameraRecord,
    CameraRecords,
    LoadedCamera,
    with_notices,
)
from procc_annotator.formats.strict_json import finite_number, printable
from procc_annotator.messages import pluralize

_EXACT_PX = 0.01  # what a lens that is fitted may differ by without a word
# SynLoc counts x across the field and y along it; here x runs along it and y to the main camera.
_ACROSS = KrtKeys(
    axes=np.array([[0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]]), kind="a SynLoc camera"
)
_MATRIX, _POLY = "camera_matrix", "dist_poly"


def is_synloc(content: object) -> bool:
    """Return whether decoded content is a SynLoc file: COCO whose images have cameras."""
    images = content.get("images") if type(content) is dict else None
    return type(images) is list and any(type(i) is dict and _MATRIX in i for i in images[:20])


def synloc_records(content: Any, path: str) -> CameraRecords:
    """The cameras of the images of a decoded file.

    Raises:
        CameraError: none has one.
    """
    images = content.get("images") if type(content) is dict else None
    own = [
        (str(image.get("file_name", image.get("id", i))), CameraRecord(f"images[{i}]", image))
        for i, image in enumerate(images if type(images) is list else [])
        if type(image) is dict and _MATRIX in image
    ]
    if not own:
        raise CameraError(path, f"holds no image with {_MATRIX}", place="images")
    left = len(images or []) - len(own)
    notices = (f"{pluralize(left, 'image has', 'images have')} no camera",) if left else ()
    return CameraRecords.of(path, own, _synloc_camera, notices)


def _synloc_camera(content: Any, path: str, inside: str) -> LoadedCamera:
    values = JsonValues.of(content, path, inside, _ACROSS.kind)
    size = values.size()
    if size is None:
        raise values.missing("the size of the picture", "width", "height")
    flat = values.numbers(_MATRIX)
    matrix = values.matrix(_MATRIX, 4 if len(flat) == 16 else 3, 4)[:3]
    # Rays are divided by their third coordinate: its sign says nothing.
    matrix = matrix * np.sign(np.linalg.det(matrix[:, :3]))
    poly = np.array(values.numbers(_POLY)) if _POLY in values else np.empty(0)
    width, height = size
    own: dict[str, Any] = {"R": matrix[:, :3].tolist(), "t": matrix[:, 3].tolist()}
    focal, off = float(width), np.zeros(1)
    if len(poly):
        corner = math.hypot(width - 1, height - 1) / 2 / width
        try:
            unit, k, off = fisheye_of_polynomial(poly, corner)
        except ValueError as error:
            raise values.error(str(error), _POLY) from error
        focal, off = unit * width, off * width
        own |= {"model": "fisheye", "dist": k.tolist()}
    own |= {"width": width, "height": height}
    own["K"] = [[focal, 0, (width - 1) / 2], [0, focal, (height - 1) / 2], [0, 0, 1]]
    loaded = krt_from(own, path, inside, _ACROSS)
    # The other polynomial is the inverse of the first.
    notices = values.unused(_MATRIX, _POLY, "undist_poly")
    return with_notices(loaded, (*_fitted(off, _POLY), *notices))


def _fitted(off_px: FloatArray, what: str) -> tuple[str, ...]:
    rms, most = float(np.sqrt(np.mean(off_px**2))), float(np.abs(off_px).max())
    if most <= _EXACT_PX:
        return ()
    return (f"{what}: the closest lens differs by {rms:.2g} px (RMS), {most:.2g} px at most",)


_OTIO = KrtKeys(axes=HALF_TURN, kind="an OpenTrackIO sample")
# Its camera looks along y, x to the right, z up; here x is right, y down, z forward.
_CAMERA_AXES = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
_LENS_USED = (
    "pinholeFocalLength", "distortion", "projectionOffset", "nominalFocalLength",
    "distortionOverscan", "undistortionOverscan", "focusDistance",
)  # fmt: skip


def is_opentrackio(content: object) -> bool:
    """Return whether decoded content is a sample of OpenTrackIO, or a list of them."""
    entries = content if type(content) is list else [content]
    return any(
        type(e) is dict and type(e.get("transforms")) is list and type(e.get("lens")) is dict
        for e in entries[:20]
    )


def opentrackio_records(content: Any, path: str) -> CameraRecords | None:
    """The cameras of a list of samples; None for one sample."""
    if type(content) is not list:
        return None
    found = [(str(i), CameraRecord(f"[{i}]", sample)) for i, sample in enumerate(content)]
    return CameraRecords.of(path, found, opentrackio_from, (BY_ORDER,))


def opentrackio_from(content: Any, path: str, inside: str = "") -> LoadedCamera:
    """The camera of a sample, whose transforms lead from the stage to the sensor.

    Raises:
        CameraError: a part is missing, or is not what it should be.
    """
    sample = JsonValues.of(content, path, inside, _OTIO.kind)
    place = f"{inside}: " if inside else ""

    def part(of: JsonValues, key: str, name: str) -> JsonValues:
        where = f"{of.inside}.{key}" if of is not sample else f"{place}{name}"
        return JsonValues.of(of.content.get(key), path, where, _OTIO.kind)

    camera = part(part(sample, "static", "static"), "camera", "static.camera")
    lens = part(sample, "lens", "lens")
    pixels = part(camera, "activeSensorResolution", "")
    sensor = part(camera, "activeSensorPhysicalDimensions", "")
    size = pixels.size_of("width", "height")
    mm = np.array([sensor.number("width"), sensor.number("height")])
    if not (mm > 0).all():
        raise sensor.error("expected millimetres above 0")
    scale = np.array(size) / mm
    focal_mm = _first(lens, "pinholeFocalLength")
    offset = np.zeros(2)
    if "projectionOffset" in lens:
        shift = part(lens, "projectionOffset", "")
        offset = np.array([shift.number("x"), shift.number("y")])
    fx, fy = (focal_mm * scale).tolist()
    cx, cy = (np.array(size) / 2 + offset * scale).tolist()
    distortion, notices = _brown_conrady(lens, focal_mm, float(np.hypot(*mm) / 2), scale[0])
    rotation, position = _composed(sample, path, place)
    own = {
        "K": centred_k(fx, fy, cx, cy),
        "R": (_CAMERA_AXES @ rotation.T).tolist(),
        "position": position.tolist(),
        "dist": distortion,
        "width": size[0],
        "height": size[1],
    }
    loaded = camera_of_matrices(JsonValues(own, path, inside, _OTIO.kind), _OTIO)
    return with_notices(loaded, (*notices, *lens.unused(*_LENS_USED)))


def _first(values: JsonValues, key: str) -> float:
    """A number, or the first of a list: files of a whole clip hold one for each frame."""
    value = values.content.get(key)
    if type(value) is list and value:
        return JsonValues({key: value[0]}, values.path, values.inside, values.kind).focal(key)
    return values.focal(key)


def _composed(sample: JsonValues, path: str, place: str) -> tuple[FloatArray, FloatArray]:
    """(3, 3) camera -> stage, (3,) position in metres: each transform is relative to the last."""
    rotation, position = np.eye(3), np.zeros(3)
    for i, entry in enumerate(sample.content["transforms"]):
        where = f"{place}transforms[{i}]"
        own = JsonValues.of(entry, path, where, _OTIO.kind)
        moved = JsonValues.of(own.content.get("translation"), path, f"{where}.translation")
        turned = JsonValues.of(own.content.get("rotation"), path, f"{where}.rotation")
        pan, tilt, roll = (math.radians(turned.number(key)) for key in ("pan", "tilt", "roll"))
        if own.content.get("scale", {"x": 1}) not in ({"x": 1}, {"x": 1, "y": 1, "z": 1}):
            raise own.error("expected a scale of 1", "scale")
        position = position + rotation @ np.array([moved.number(key) for key in "xyz"])
        rotation = rotation @ _about(2, pan) @ _about(0, tilt) @ _about(1, roll)
    return rotation, position


def _about(axis: int, angle_rad: float) -> FloatArray:
    """(3, 3) of a right-handed turn about x, y or z."""
    c, s = math.cos(angle_rad), math.sin(angle_rad)
    one, other = (axis + 1) % 3, (axis + 2) % 3
    matrix = np.eye(3)
    matrix[one, one] = matrix[other, other] = c
    matrix[one, other], matrix[other, one] = -s, s
    return matrix


def _brown_conrady(
    lens: JsonValues, focal_mm: float, corner_mm: float, px_per_mm: float
) -> tuple[list[float], tuple[str, ...]]:
    """OpenCV's distortion of the first model of a lens, and remarks.

    Coefficients go by millimetres on the sensor, alternating between numerator and denominator.
    """
    models = lens.content.get("distortion")
    models = models if type(models) is list else [models] if models is not None else []
    if not models:
        return [], ()
    where = f"{lens.inside}.distortion[0]"
    own = JsonValues.of(models[0], lens.path, where, _OTIO.kind)
    model = own.content.get("model", "Brown-Conrady D-U")
    if model not in ("Brown-Conrady D-U", "Brown-Conrady U-D"):
        raise own.error(
            f"is {printable(str(model))!r}, expected Brown-Conrady D-U or U-D", "model",
            "write the lens in one of these models",
        )  # fmt: skip
    radial = np.zeros(6)
    given = own.numbers("radial") if "radial" in own else ()
    if len(given) > 6:
        raise own.error(f"has {len(given)} entries, expected at most 6", "radial")
    radial[: len(given)] = given
    radial = np.array([*radial[::2], *radial[1::2]]) * focal_mm ** np.array([2.0, 4, 6, 2, 4, 6])
    p1, p2 = (*(own.numbers("tangential") if "tangential" in own else ()), 0.0, 0.0)[:2]
    p1, p2 = p1 * focal_mm**2, p2 * focal_mm**2
    more = (f"{len(models)} distortions: the first one is taken",) if len(models) > 1 else ()
    if model.endswith("U-D"):
        n1, n2, n3, d1, d2, d3 = radial.tolist()
        return [n1, n2, p1, p2, n3, d1, d2, d3], more
    try:
        k, off = distortion_of_inverse(radial, corner_mm / focal_mm)
    except ValueError as error:
        raise own.error(str(error), "radial") from error
    # To the first order the inverse of a tangential distortion is its negative.
    remark = _fitted(off * focal_mm * px_per_mm, "distortion from picture to scene")
    k1, k2, k3 = k.tolist()
    return [k1, k2, -p1, -p2, k3], (*remark, *more)


_QUALISYS = KrtKeys(axes=HALF_TURN, unit_m=0.001, kind="a Qualisys camera")
_SUBPIXELS = 64.0


def is_qualisys(content: Any) -> bool:
    """Return whether decoded content is the XML of a Qualisys calibration."""
    return getattr(content, "tag", "") == "calibration" and content.find("cameras") is not None


def qualisys_records(content: Any, path: str) -> CameraRecords:
    """The cameras of a calibration, named by serial number.

    Raises:
        CameraError: it lists none.
    """
    cameras = content.findall("cameras/camera") if hasattr(content, "findall") else []
    found = [
        (camera.get("serial", str(i)), CameraRecord(f"camera {i + 1}", camera))
        for i, camera in enumerate(cameras)
        if camera.find("transform") is not None
    ]
    if not found:
        raise CameraError(path, "lists no camera, expected <calibration><cameras><camera>")
    return CameraRecords.of(path, found, _qualisys_camera)


def _qualisys_camera(content: Any, path: str, inside: str) -> LoadedCamera:
    def numbers(tag: str, *names: str) -> list[float]:
        found = content.find(tag)
        values = []
        for name in names:
            text = found.get(name, "") if found is not None else ""
            number = finite_number(text.strip())
            if number is None:
                problem = f"expected a finite number, found {printable(text, 40)!r}"
                raise CameraError(path, problem, place=f"{inside}: {tag} {name}")
            values.append(number)
        return values

    view = "fov_video" if content.find("fov_video") is not None else "fov"
    left, top, right, bottom = numbers(view, "left", "top", "right", "bottom")
    fx, fy, cx, cy, k1, k2, p1, p2 = (
        number / _SUBPIXELS
        for number in numbers(
            "intrinsic", "focalLengthU", "focalLengthV", "centerPointU", "centerPointV",
            "radialDistortion1", "radialDistortion2",
            "tangentalDistortion1", "tangentalDistortion2",
        )
    )  # fmt: skip
    entries = [f"r{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3)]
    # Its cameras look along -z, y up.
    rotation = HALF_TURN @ np.array(numbers("transform", *entries)).reshape(3, 3)
    own = {
        "K": [[fx, 0, cx - left], [0, fy, cy - top], [0, 0, 1]],
        "R": rotation.tolist(),
        "position": numbers("transform", "x", "y", "z"),
        "dist": [k1, k2, p1, p2],
        "width": right - left + 1,
        "height": bottom - top + 1,
    }
    return krt_from(own, path, inside, _QUALISYS)


POSE2SIM = KrtKeys(
    k=("matrix",), r=("rotation",), t=("translation",), position=(), pose=(), inverse_pose=(),
    distortion=("distortions", "distortion"), model=(), size=("size",), up_or_down=True,
    repeated=("name",), kind="a Pose2Sim, Anipose or Caliscope camera",
)  # fmt: skip
FIFA = KrtKeys(distortion=("k",), up_or_down=True, kind="a camera of FIFA's Skeletal Tracking")
_FIRST_CAMERA = "its world is the first camera's, not the field's: lay it upon the field first"
MODEL_WORLD = KrtKeys(
    k=("intrinsic", "intrinsics"), r=(), t=(), position=(),
    pose=("extrinsic", "extrinsics"), inverse_pose=("cam_c2w", "c2w"), repeated=("motion_prob",),
    kind="a camera of VGGT or MegaSaM", remark=_FIRST_CAMERA,
)  # fmt: skip


def is_fifa(content: object) -> bool:
    """Return whether decoded arrays are a sequence of FIFA's: K and k for each frame, R, t."""
    if type(content) is not dict or not {"K", "k", "R", "t"} <= content.keys():
        return False
    stacked = all(type(content[key]) is list and content[key] for key in ("K", "k"))
    return (
        stacked
        and type(content["K"][0]) is list
        and type(content["k"][0]) is list
        and (type(content["K"][0][0]) is list)
    )


def is_model_world(content: object) -> bool:
    """Return whether decoded arrays are what VGGT or MegaSaM write."""
    own = MODEL_WORLD
    return own.are_in(content) and KRT_KEYS.k[0] not in content  # type: ignore[operator]
