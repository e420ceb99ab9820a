"""The table of formats that are not read: how each is recognised, and the way out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import PurePath

from procc_annotator.formats.annotations.yolo_pose import is_pose_label

_COLMAP = "export a COLMAP model (images, cameras) and give its folder"
_NUMPY = "load it where it comes from and save the arrays K, R, t, dist with numpy.savez"


@dataclass(frozen=True)
class UnreadFormat:
    """A format of another program.

    Attributes:
        suffixes: of files that are of no other format, lower case.
        marks: of which the first 4 kB hold one.
        is_of: whether the bytes of a file are of the format.
    """

    title: str
    advice: str
    suffixes: tuple[str, ...] = ()
    marks: tuple[bytes, ...] = ()
    is_of: Callable[[bytes], bool] = lambda _: False

    @property
    def problem(self) -> str:
        """Return what is wrong with such a file."""
        return f"is a file of {self.title}, which is not read"


_U = UnreadFormat
UNREAD_FORMATS: tuple[UnreadFormat, ...] = (
    _U("Metashape (project or cameras)", f"File > Export > Export Cameras: {_COLMAP}",
       (".psx", ".psz"), (b"<chunk ", b"<calibration><projection>", b"<chunks")),
    _U("RealityScan or RealityCapture", f"Workflow > Export > Registration: {_COLMAP}",
       (".rcproj", ".xmp"), (b"xcr:", b"RealityCapture")),
    _U("OpenMVG or Meshroom", f"convert it (openMVG_main_openMVG2Colmap): {_COLMAP}",
       (".sfm",), (b'"sfm_data_version"', b'"featuresFolders"')),
    _U("Bundler or VisualSFM", f"open it in COLMAP or MeshLab: {_COLMAP}",
       (".nvm",), (b"# Bundle file", b"NVM_V3")),
    _U("Blender", "write the cameras as transforms.json (a NeRF export add-on)",
       (".blend",), (b"BLENDER",)),
    _U("a scene (FBX, Alembic, USD, glTF)", "open it in Blender and write the cameras as"
       " transforms.json", (".fbx", ".abc", ".usd", ".usda", ".usdc", ".usdz", ".gltf", ".glb"),
       (b"Kaydara FBX",)),
    _U("PTGui or Hugin", "it has lenses without a place: click the field in the panorama",
       (".pts", ".pto"), (b"# ptGui", b"# hugin project")),
    _U("Kinovea", "it has a grid in the picture: click the field's elements instead",
       (".kva",), (b"<KinoveaVideoAnalysis",)),
    _U("tracking data (TRACAB, EPTS, SkillCorner, StatsBomb 360)",
       "it has positions of players, no camera", (),
       (b"<TracabMetaData", b"<TracabData", b"<ManagedObjects", b"<EPTS", b'"player_data"',
        b'"freeze_frame"')),
    _U("MVSNet or Pix4D", 'write the matrices as {"K": ..., "w2c": ...} in JSON',
       (), (b"extrinsic\n", b"fileName imageWidth imageHeight")),
    _U("Nuke", "import it in Blender and write the cameras as transforms.json", (".chan",)),
    _U("Vicon, OptiTrack or Theia", "convert it with Pose2Sim to Calib.toml",
       (".xcp", ".cal", ".mcal"), (b"VICON_RADIAL", b"<OptitrackCalibration")),
    _U("ROS or Kalibr", "it has a lens without a place: add R and tvec as"
       " cv::FileStorage writes them", (), (b"distortion_model: ", b"cam_overlaps")),
    _U("pictures in HEIC, JPEG XL, OpenEXR or of a camera's sensor", "write them as PNG, for"
       " example with ImageMagick: magick IN.heic OUT.png", (".heic", ".heif", ".jxl", ".exr",
       ".cr2", ".cr3", ".nef", ".arw", ".dng", ".raf", ".rw2", ".psd", ".dpx", ".svg", ".tga",
       ".ico")),
    _U("an archive other than zip", "unpack it; frames are also read from a .tar that is not"
       " compressed (gunzip)", (".gz", ".bz2", ".xz", ".7z", ".rar", ".tar",
       ".tgz")),
    _U("pickles, which may run any program", _NUMPY, (".pkl", ".pickle", ".p", ".pt",
       ".pth")),
    _U("HDF5 or Parquet", _NUMPY, (".h5", ".hdf5", ".parquet"), (b"\x89HDF", b"PAR1")),
    _U("Supervisely", "export the project as COCO or as Datumaro",
       (), (b'"classTitle"',)),
    _U("VIA 3", "draw in VIA 2, or export from VIA 3 as COCO", (), (b'"fid_list"',)),
    _U("YOLO pose", "get it as COCO keypoints, and procc-annotator propose-map says what its places"
       " are", (), (), is_pose_label),
    _U("V7 Darwin", "export it as COCO", (), (b"darwin",)),
    _U("Pascal VOC", "it has boxes, no lines: export polylines as CVAT or COCO",
       (), (b"<annotation>\n\t<folder", b"<bndbox>")),
    _U("ImageJ", "export the points as CSV of VIA or as COCO",
       (".roi",), ()),
)  # fmt: skip


def unread_format(path: str, data: bytes = b"") -> UnreadFormat | None:
    """The format of a file that is not read, by its suffix and its bytes; None where nothing
    tells."""
    suffix, head = PurePath(path).suffix.lower(), data[:4096]
    for known in UNREAD_FORMATS:
        if suffix in known.suffixes or any(m in head for m in known.marks) or known.is_of(data):
            return known
    return None
