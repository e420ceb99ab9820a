"""The table of camera formats, from which detection and messages are made."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from procc_annotator.formats.cameras import published_sets as sets
from procc_annotator.formats.cameras import soccernet
from procc_annotator.formats.cameras import tracking_systems as systems
from procc_annotator.formats.cameras.content import ARRAY_SUFFIXES, TABLE_SUFFIXES, TOML_SUFFIX
from procc_annotator.formats.cameras.homography import CONVENTIONS, read_homography
from procc_annotator.formats.cameras.json_values import lists_objects, maps_objects
from procc_annotator.formats.cameras.krt import (
    KRT_KEYS,
    KrtKeys,
    is_projection,
    krt_from,
    projection_from,
)
from procc_annotator.formats.cameras.krt_sets import is_krt_file, krt_records
from procc_annotator.formats.cameras.loaded_camera import (
    CameraFormat,
    CameraRecord,
    CameraRecords,
    ReadRecord,
)
from procc_annotator.formats.cameras.matrix_tables import is_matrix_table, table_records
from procc_annotator.formats.cameras.opencv import is_storage, read_opencv
from procc_annotator.formats.cameras.packed import PackedCameras, packed_records
from procc_annotator.formats.cameras.paired_files import (
    both_names,
    colmap_records,
    easymocap_records,
    raise_half_of_pair,
)
from procc_annotator.formats.cameras.polylines import is_whole, polylines_from, polylines_records

JSON = (".json", ".jsonl", *ARRAY_SUFFIXES)
STORAGE_SUFFIXES = (".yml", ".yaml", ".xml")
HOMOGRAPHY_SUFFIXES = (".homographymatrix", ".txt", ".npy")
_OURS = "metres, z down, origin at the field's centre"
_UP = "metres, z up, origin at the field's centre; turned by half about x"
_UP_IF_ABOVE = f"{_UP} where the camera stands at z > 0"
_YARDS = "yards, origin top left; moved to the centre"


_Recognises = Callable[[Any], bool] | None
_Many = Callable[[Any, str], CameraRecords | None]


def _row(
    name: str, title: str, keys: str, world: str, example: str, recognises: _Recognises,
    one: ReadRecord | None, many: _Many, suffixes: tuple[str, ...] = JSON,
) -> CameraFormat:  # fmt: skip
    return CameraFormat(
        name, title, suffixes, (), None, None, one is None, recognises, one, many,
        keys=keys, world=world, example=example,
    )  # fmt: skip


def _parts(
    name: str, title: str, keys: str, world: str, example: str, parts: KrtKeys,
    recognises: _Recognises = None, suffixes: tuple[str, ...] = JSON,
) -> CameraFormat:  # fmt: skip
    """A format that is K, R, t under other names, in other units or axes."""
    return _row(
        name, title, keys, world, example, recognises or partial(is_krt_file, keys=parts),
        partial(krt_from, keys=parts), partial(krt_records, keys=parts), suffixes,
    )  # fmt: skip


def _by_frame(
    is_one: Callable[[object], bool], read: ReadRecord, content: object, path: str
) -> CameraRecords | None:
    if type(content) is not dict or is_one(content) or not any(map(is_one, content.values())):
        return None
    found = [(name, CameraRecord(name, v)) for name, v in content.items()]
    return CameraRecords.of(path, found, read)


def _is_a(kind: type, content: object) -> bool:
    return isinstance(content, kind)


def _is_soccernet(content: object) -> bool:
    return type(content) is dict and soccernet.is_soccernet(content)


SOCCERNET = _row(
    "soccernet", "SoccerNet camera JSON", "pan_degrees", _OURS,
    "camera_FRAME.json, or {FRAME: camera}", _is_soccernet, soccernet.camera_from,
    partial(_by_frame, _is_soccernet, soccernet.camera_from),
)  # fmt: skip
TVCALIB = _row(
    "tvcalib", "TVCalib per_sample_output.json", "image_ids", _OURS,
    "one record a line, or a list of them", soccernet.is_tvcalib, None, soccernet.tvcalib_records,
)  # fmt: skip
STORAGE = CameraFormat(
    "opencv", "OpenCV FileStorage, YAML, XML or JSON", (*STORAGE_SUFFIXES, ".json"),
    STORAGE_SUFFIXES, read_opencv, recognises=is_storage, world=_OURS,
    keys="camera_matrix: !!opencv-matrix", example="FRAME.yml of cv::FileStorage",
)  # fmt: skip

# In the order in which content is recognised.
ROWS: tuple[CameraFormat, ...] = (
    SOCCERNET,
    TVCALIB,
    STORAGE,
    _row(
        "packed", "packed cameras of a match", "procc_cameras", _OURS,
        "MATCH.npz, as track writes it", partial(_is_a, PackedCameras), None, packed_records,
        ARRAY_SUFFIXES,
    ),
    _row(
        "broadtrack", "BroadTrack JSON", "PICTURE.cp", _OURS, '{PICTURE: {"cp": camera}}',
        partial(maps_objects, keys={"cp"}), None, soccernet.broadtrack_records,
    ),
    _row(
        "deepsportradar", "DeepSportRadar K, R, T list", "[].K, [].T",
        "cm, z down, origin at the far left corner of a FIBA court; moved to the centre",
        "[size, {K, R, T, kc}, ...]: frames 0, 1, 2, ...",
        partial(lists_objects, keys={"K", "R", "T"}), None, sets.deepsportradar_records,
    ),
    _row(
        "synloc", "SoccerNet SynLoc (Spiideo)", "images[].camera_matrix",
        "metres, z up, x across the field, y along it; turned", "val.json of COCO",
        partial(lists_objects, keys={"camera_matrix"}, under="images"), None,
        systems.synloc_records,
    ),
    _row(
        "opentrackio", "OpenTrackIO 1.0", "transforms, lens", _UP,
        "a sample, a list, or one a line", systems.is_opentrackio, systems.opentrackio_from,
        systems.opentrackio_records,
    ),
    _parts(
        "fifa", "FIFA Skeletal Tracking, K and k for each frame", "K[], k[], R, t", _UP_IF_ABOVE,
        "SEQUENCE.npz; R and t may be of the first frame alone", systems.FIFA, systems.is_fifa,
        ARRAY_SUFFIXES,
    ),
    _parts(
        "pose2sim", "Pose2Sim, Anipose, Caliscope TOML", "NAME.matrix, NAME.rotation",
        _UP_IF_ABOVE, "Calib.toml: one camera a section", systems.POSE2SIM,
        suffixes=(TOML_SUFFIX, *JSON),
    ),
    _parts(
        "panoptic", "Panoptic Studio", "cameras[].distCoef", "cm, y down, floor at y = 0; turned",
        "calibration_SCENE.json", sets.PANOPTIC,
        partial(
            lists_objects, keys={"K", "R", "t", "distCoef", "resolution"}, under="cameras"
        ),
    ),
    _parts(
        "vggt", "VGGT, MegaSaM", "intrinsic, extrinsic[] or cam_c2w[]",
        "the first camera's, no unit: lay it upon the field first",
        "predictions.npz, SCENE_sgd_cvd_hr.npz", systems.MODEL_WORLD, systems.is_model_world,
        ARRAY_SUFFIXES,
    ),
    _parts(
        "krt", "K, R, t and distortion", "K, R", _OURS,
        "a camera, {FRAME: camera}, {cameras: ...}, or arrays with one more axis", KRT_KEYS,
        suffixes=(*JSON, TOML_SUFFIX),
    ),
    _row(
        "polylines", "projections of elements, JSON", "format: procc-annotator projection",
        "none: where elements are in the picture",
        "whole projections; {CLASS: points} and {FRAME: {CLASS: points}} must be named", is_whole,
        polylines_from, polylines_records,
    ),
    _row(
        "projection", "3 x 4 projection matrix", "P", _OURS,
        "{P: matrix}, .npy, 12 numbers, KITTI's P0: lines", is_projection, projection_from,
        partial(_by_frame, is_projection, projection_from), (*JSON, ".npy", ".txt"),
    ),
    _row(
        "transforms", "transforms.json of radiance fields", "frames[].transform_matrix",
        f"camera -> world, axes of OpenGL; {_UP}", "transforms.json",
        partial(lists_objects, keys={"transform_matrix"}, under="frames"), None,
        sets.transforms_records,
    ),
    _row(
        "sccvsd", "World Cup 2014 homographies, MATLAB", "annotation[].homography",
        f"115 x 74 {_YARDS}", "annotation(i) in .mat",
        partial(sets.is_annotation_set, "homography"), None,
        partial(sets.annotation_records, sets.read_set_homography), ARRAY_SUFFIXES,
    ),
    _row(
        "ptz-slam", "frames of one tripod, MATLAB", "annotation[].camera",
        "metres, z up, origin at the near left corner of 115 x 74 yards; moved, turned",
        "annotation(i) in .mat", partial(sets.is_annotation_set, "camera"), None,
        partial(sets.annotation_records, sets.read_ptz), ARRAY_SUFFIXES,
    ),
    _row(
        "qualisys", "Qualisys calibration", "<calibration>, <cameras>",
        "mm, z up; turned by half about x", "NAME.qca.txt: serial numbers", systems.is_qualisys,
        None, systems.qualisys_records, (".txt", ".xml"),
    ),
    _row(
        "table", "homographies or DLT parameters, CSV", "homography_matrix, h11, dlt_param_1",
        "metres from the field's centre; ShuttleSet's court is moved to its centre",
        "homography.csv; frame, h11 ... h33; .dlt2d, .dlt3d", is_matrix_table, None, table_records,
        TABLE_SUFFIXES,
    ),
    *(
        CameraFormat(
            name, f"homography, {rule.title}", HOMOGRAPHY_SUFFIXES, (),
            partial(read_homography, convention=name), world=rule.title.partition(": ")[2]
            or rule.title, example=example,
        )
        for (name, rule), example in zip(CONVENTIONS.items(), (
            "FRAME.homographyMatrix, .txt: 3 x 3 numbers", "FRAME.npy, FRAME_homography.npy",
            "as the two above; it must be named",
        ), strict=True)
    ),
    *(
        CameraFormat(
            name, title, suffixes, suffixes[1:], partial(raise_half_of_pair, known=pairs),
            pairs=pairs, read_pair=read, world=world, example=both_names(pairs),
        )
        for name, title, suffixes, pairs, read, world in (
            ("colmap", "COLMAP model, text or binary", (".txt", ".bin"),
             (("images.txt", "cameras.txt"), ("images.bin", "cameras.bin")), colmap_records,
             "whatever the model was laid in: taken for metres, z down"),
            ("easymocap", "EasyMocap, extri.yml and intri.yml", (".yml",),
             (("extri.yml", "intri.yml"),), easymocap_records, _OURS),
        )
    ),
)  # fmt: skip
