"""The cameras that the clicks of a dataset's frames gave, beside those that come from files."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from functools import cached_property

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.fit.result import FitResult
from procc_annotator.io.camera_files.cameras import fit_to_size
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera
from procc_annotator.language import translatable
from procc_annotator.session.dataset.camera_set import CameraForFrame

FIT_NAME = "fit"  # no cameras from files are called so


@dataclass(frozen=True, eq=False)
class FittedFrame:
    """A fit, or the reason why there is none, with the clicks it belongs to."""

    annotation: FrameAnnotation
    fit: FitResult


@dataclass(frozen=True, eq=False)
class FittedCameras:
    """Fits by frame name; never changed, so that any thread may read it.

    Attributes:
        fits: of the frames that were looked at.
    """

    fits: Mapping[str, FittedFrame] = field(default_factory=dict)

    @property
    def name(self) -> str:
        """Shown to the user; always the same."""
        return FIT_NAME

    @property
    def origin(self) -> str:
        """Where the cameras come from, for people."""
        return translatable("Fitted to the clicks of each frame; nothing of it is in a file")

    @cached_property
    def frames(self) -> Mapping[str, FittedFrame]:
        """The frames that have a camera."""
        return {n: fitted for n, fitted in self.fits.items() if fitted.fit.camera is not None}

    def camera(self, frame_name: str, size: tuple[int, int]) -> CameraForFrame | None:
        """A frame's camera in px of an evaluation size, or None when there is none."""
        fitted = self.frames.get(frame_name)
        found = fitted.fit.camera if fitted is not None else None
        if fitted is None or found is None:
            return None
        camera, _ = fit_to_size(LoadedCamera(found, fitted.fit.model, fitted.fit.size), size)
        return CameraForFrame(camera, fitted.fit.model, None)

    def why_none(self, frame_name: str) -> str:
        """Why a frame has no camera, for people."""
        fitted = self.fits.get(frame_name)
        if fitted is None or not fitted.fit.failure:
            return translatable("no fit of {frame} yet", frame=frame_name)
        return fitted.fit.failure

    def with_fit(self, frame_name: str, fitted: FittedFrame) -> FittedCameras:
        """The same with another fit of a frame."""
        return FittedCameras({**self.fits, frame_name: fitted})

    def without(self, frame_names: Collection[str]) -> FittedCameras:
        """The same without the fits of some frames."""
        kept = {n: fitted for n, fitted in self.fits.items() if n not in frame_names}
        return FittedCameras(kept) if len(kept) < len(self.fits) else self
