"""Annotate and audit sports-camera calibrations.

What this package names is for other programs, and stays: see docs/python.md. It is loaded when it
is first asked for; importing the package costs next to nothing, and nothing here needs Qt or a
display. Every error raised on purpose is a `ProccError`, its text one line for the user.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from procc_annotator.version import __version__

if TYPE_CHECKING:  # for type checkers; each name comes from where `_HOMES` says
    from procc_annotator.annotation import FrameAnnotation as FrameAnnotation
    from procc_annotator.annotation import Point as Point
    from procc_annotator.annotation import Polyline as Polyline
    from procc_annotator.api.calibrating import fit_camera as fit_camera
    from procc_annotator.api.calibrating import propose_camera as propose_camera
    from procc_annotator.api.calibrating import track as track
    from procc_annotator.api.cameras import camera_from_function as camera_from_function
    from procc_annotator.api.cameras import camera_from_homography as camera_from_homography
    from procc_annotator.api.cameras import camera_from_krt as camera_from_krt
    from procc_annotator.api.cameras import camera_from_projection as camera_from_projection
    from procc_annotator.api.checking import check_labels as check_labels
    from procc_annotator.api.drawing import draw_overlay as draw_overlay
    from procc_annotator.api.judging import disagreement as disagreement
    from procc_annotator.api.judging import evaluate as evaluate
    from procc_annotator.api.judging import jac_curve as jac_curve
    from procc_annotator.api.judging import project_field as project_field
    from procc_annotator.api.judging_sets import evaluate_set as evaluate_set
    from procc_annotator.api.reading import Dataset as Dataset
    from procc_annotator.api.reading import load_annotation as load_annotation
    from procc_annotator.api.reading import load_annotations as load_annotations
    from procc_annotator.api.reading import load_camera as load_camera
    from procc_annotator.api.reading import load_cameras as load_cameras
    from procc_annotator.api.reading import load_dataset as load_dataset
    from procc_annotator.api.saving import save_camera as save_camera
    from procc_annotator.api.set_score import SetScore as SetScore
    from procc_annotator.camera.base import Camera as Camera
    from procc_annotator.camera.fisheye import FisheyeCamera as FisheyeCamera
    from procc_annotator.camera.homography import HomographyCamera as HomographyCamera
    from procc_annotator.camera.matrix_camera import MatrixCamera as MatrixCamera
    from procc_annotator.camera.pinhole import PinholeCamera as PinholeCamera
    from procc_annotator.camera.projections import ElementProjections as ElementProjections
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
    from procc_annotator.fit.from_picture.proposal import KnownPosition as KnownPosition
    from procc_annotator.fit.from_picture.proposal import Proposal as Proposal
    from procc_annotator.fit.labels.finding import Finding as Finding
    from procc_annotator.fit.result import FitResult as FitResult
    from procc_annotator.fit.through_shot.track import Track as Track
    from procc_annotator.fit.through_shot.track import TrackedFrame as TrackedFrame
    from procc_annotator.io.camera_files.loaded_camera import LoadedCamera as LoadedCamera
    from procc_annotator.metric.chance.intervals import Interval as Interval
    from procc_annotator.metric.chance.paired import PairedDifference as PairedDifference
    from procc_annotator.metric.chance.paired import corrected_for as corrected_for
    from procc_annotator.metric.disagreement import Disagreement as Disagreement
    from procc_annotator.metric.score import ElementScore as ElementScore
    from procc_annotator.metric.score import FrameScore as FrameScore
    from procc_annotator.metric.sets import ClassSummary as ClassSummary
    from procc_annotator.metric.sets import SetSummary as SetSummary

# Everything that is public, by the module it lies in.
_HOMES = {
    "annotation": ("FrameAnnotation", "Point", "Polyline"),
    "api.calibrating": ("fit_camera", "propose_camera", "track"),
    "api.cameras": (
        "camera_from_function",
        "camera_from_homography",
        "camera_from_krt",
        "camera_from_projection",
    ),
    "api.checking": ("check_labels",),
    "api.drawing": ("draw_overlay",),
    "api.judging": ("disagreement", "evaluate", "jac_curve", "project_field"),
    "api.judging_sets": ("evaluate_set",),
    "api.reading": (
        "Dataset",
        "load_annotation",
        "load_annotations",
        "load_camera",
        "load_cameras",
        "load_dataset",
    ),
    "api.saving": ("save_camera",),
    "api.set_score": ("SetScore",),
    "camera.base": ("Camera",),
    "camera.fisheye": ("FisheyeCamera",),
    "camera.homography": ("HomographyCamera",),
    "camera.matrix_camera": ("MatrixCamera",),
    "camera.pinhole": ("PinholeCamera",),
    "camera.projections": ("ElementProjections",),
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
    "field.load": ("field_names", "load_field"),
    "field.model": ("Element", "Field"),
    "fit.from_picture.proposal": ("KnownPosition", "Proposal"),
    "fit.labels.finding": ("Finding",),
    "fit.result": ("FitResult",),
    "fit.through_shot.track": ("Track", "TrackedFrame"),
    "io.camera_files.loaded_camera": ("LoadedCamera",),
    "metric.chance.intervals": ("Interval",),
    "metric.chance.paired": ("PairedDifference", "corrected_for"),
    "metric.disagreement": ("Disagreement",),
    "metric.score": ("ElementScore", "FrameScore"),
    "metric.sets": ("ClassSummary", "SetSummary"),
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
