"""Annotate and audit sports-camera calibrations.

What this package names is for other programs, and stays: see docs/reference/python.md. It is
loaded when it is first asked for; importing the package costs next to nothing, and nothing here
needs Qt or a display. Every error raised on purpose is a `ProccError`, its text one line for the
user.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from procc_annotator.version import __version__

if TYPE_CHECKING:  # for type checkers; each name comes from where `_HOMES` says
    from procc_annotator.annotation import FrameAnnotation as FrameAnnotation
    from procc_annotator.annotation import Point as Point
    from procc_annotator.annotation import Polyline as Polyline
    from procc_annotator.api.calibration import check_labels as check_labels
    from procc_annotator.api.calibration import fit_camera as fit_camera
    from procc_annotator.api.calibration import leave_one_out as leave_one_out
    from procc_annotator.api.calibration import propose_camera as propose_camera
    from procc_annotator.api.calibration import track as track
    from procc_annotator.api.cameras import camera_from_function as camera_from_function
    from procc_annotator.api.cameras import camera_from_homography as camera_from_homography
    from procc_annotator.api.cameras import camera_from_krt as camera_from_krt
    from procc_annotator.api.cameras import camera_from_projection as camera_from_projection
    from procc_annotator.api.cameras import draw_overlay as draw_overlay
    from procc_annotator.api.cameras import save_camera as save_camera
    from procc_annotator.api.evaluation import disagreement as disagreement
    from procc_annotator.api.evaluation import evaluate as evaluate
    from procc_annotator.api.evaluation import jac_curve as jac_curve
    from procc_annotator.api.evaluation import project_field as project_field
    from procc_annotator.api.ground_points import PlacedPoints as PlacedPoints
    from procc_annotator.api.ground_points import homography_of as homography_of
    from procc_annotator.api.ground_points import to_ground as to_ground
    from procc_annotator.api.ground_points import to_pixels as to_pixels
    from procc_annotator.api.loading import Dataset as Dataset
    from procc_annotator.api.loading import load_annotation as load_annotation
    from procc_annotator.api.loading import load_annotations as load_annotations
    from procc_annotator.api.loading import load_camera as load_camera
    from procc_annotator.api.loading import load_cameras as load_cameras
    from procc_annotator.api.loading import load_dataset as load_dataset
    from procc_annotator.api.methods import save_projection as save_projection
    from procc_annotator.api.set_evaluation import SetScore as SetScore
    from procc_annotator.api.set_evaluation import evaluate_set as evaluate_set
    from procc_annotator.api.set_reports import SetOptions as SetOptions
    from procc_annotator.api.set_reports import compare_annotators as compare_annotators
    from procc_annotator.api.set_reports import compare_cameras as compare_cameras
    from procc_annotator.api.set_reports import compare_methods as compare_methods
    from procc_annotator.api.set_reports import write_report as write_report
    from procc_annotator.calibration.label_check.finding import Finding as Finding
    from procc_annotator.calibration.result import FitResult as FitResult
    from procc_annotator.calibration.single_image.proposal import KnownPosition as KnownPosition
    from procc_annotator.calibration.single_image.proposal import Proposal as Proposal
    from procc_annotator.calibration.tracking.track import Track as Track
    from procc_annotator.calibration.tracking.track import TrackedFrame as TrackedFrame
    from procc_annotator.camera.base import Camera as Camera
    from procc_annotator.camera.base import ElementProjections as ElementProjections
    from procc_annotator.camera.models import FisheyeCamera as FisheyeCamera
    from procc_annotator.camera.models import HomographyCamera as HomographyCamera
    from procc_annotator.camera.models import MatrixCamera as MatrixCamera
    from procc_annotator.camera.models import PinholeCamera as PinholeCamera
    from procc_annotator.errors import AnnotationError as AnnotationError
    from procc_annotator.errors import CameraError as CameraError
    from procc_annotator.errors import FieldError as FieldError
    from procc_annotator.errors import ImageError as ImageError
    from procc_annotator.errors import InputError as InputError
    from procc_annotator.errors import ProccError as ProccError
    from procc_annotator.errors import SaveError as SaveError
    from procc_annotator.errors import UsageError as UsageError
    from procc_annotator.field.load import field_names as field_names
    from procc_annotator.field.load import load_field as load_field
    from procc_annotator.field.model import Element as Element
    from procc_annotator.field.model import Field as Field
    from procc_annotator.formats.cameras.fit_record import LeftOutElement as LeftOutElement
    from procc_annotator.formats.cameras.loaded_camera import LoadedCamera as LoadedCamera
    from procc_annotator.metrics.error_maps import Disagreement as Disagreement
    from procc_annotator.metrics.ground_plane import NearestHomography as NearestHomography
    from procc_annotator.metrics.score import ElementScore as ElementScore
    from procc_annotator.metrics.score import FrameScore as FrameScore
    from procc_annotator.metrics.sets import ClassSummary as ClassSummary
    from procc_annotator.metrics.sets import SetSummary as SetSummary
    from procc_annotator.metrics.statistics.intervals import Interval as Interval
    from procc_annotator.metrics.statistics.significance import PairedDifference as PairedDifference
    from procc_annotator.metrics.statistics.significance import corrected_for as corrected_for

# Everything that is public, by the module it lies in.
_HOMES = {
    "annotation": (
        "FrameAnnotation",
        "Point",
        "Polyline",
    ),
    "api.calibration": (
        "check_labels",
        "fit_camera",
        "leave_one_out",
        "propose_camera",
        "track",
    ),
    "api.cameras": (
        "camera_from_function",
        "camera_from_homography",
        "camera_from_krt",
        "camera_from_projection",
        "draw_overlay",
        "save_camera",
    ),
    "api.evaluation": (
        "disagreement",
        "evaluate",
        "jac_curve",
        "project_field",
    ),
    "api.ground_points": (
        "PlacedPoints",
        "homography_of",
        "to_ground",
        "to_pixels",
    ),
    "api.loading": (
        "Dataset",
        "load_annotation",
        "load_annotations",
        "load_camera",
        "load_cameras",
        "load_dataset",
    ),
    "api.methods": ("save_projection",),
    "api.set_evaluation": (
        "SetScore",
        "evaluate_set",
    ),
    "api.set_reports": (
        "SetOptions",
        "compare_annotators",
        "compare_cameras",
        "compare_methods",
        "write_report",
    ),
    "calibration.label_check.finding": ("Finding",),
    "calibration.result": ("FitResult",),
    "calibration.single_image.proposal": (
        "KnownPosition",
        "Proposal",
    ),
    "calibration.tracking.track": (
        "Track",
        "TrackedFrame",
    ),
    "camera.base": (
        "Camera",
        "ElementProjections",
    ),
    "camera.models": (
        "FisheyeCamera",
        "HomographyCamera",
        "MatrixCamera",
        "PinholeCamera",
    ),
    "errors": (
        "AnnotationError",
        "CameraError",
        "FieldError",
        "ImageError",
        "InputError",
        "ProccError",
        "SaveError",
        "UsageError",
    ),
    "field.load": (
        "field_names",
        "load_field",
    ),
    "field.model": (
        "Element",
        "Field",
    ),
    "formats.cameras.fit_record": ("LeftOutElement",),
    "formats.cameras.loaded_camera": ("LoadedCamera",),
    "metrics.error_maps": ("Disagreement",),
    "metrics.ground_plane": ("NearestHomography",),
    "metrics.score": (
        "ElementScore",
        "FrameScore",
    ),
    "metrics.sets": (
        "ClassSummary",
        "SetSummary",
    ),
    "metrics.statistics.intervals": ("Interval",),
    "metrics.statistics.significance": (
        "PairedDifference",
        "corrected_for",
    ),
}
_HOME_OF = {name: module for module, names in _HOMES.items() for name in names}
__all__ = ["__version__", *sorted(_HOME_OF)]


if not TYPE_CHECKING:  # to a type checker a name that is not told above is a mistake

    def __getattr__(name: str) -> Any:
        if name not in _HOME_OF:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        found = globals()[name] = getattr(import_module(f"{__name__}.{_HOME_OF[name]}"), name)
        return found


def __dir__() -> list[str]:
    return __all__
