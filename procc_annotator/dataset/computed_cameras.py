"""Fitted and tracked cameras as methods, by frame name."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from functools import cached_property

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.calibration.result import FitResult
from procc_annotator.calibration.tracking.track import MIN_COVERAGE, TrackedFrame
from procc_annotator.dataset.camera_set import CameraForFrame
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera, fit_to_size
from procc_annotator.translation import translatable


def _for_size(
    fit: FitResult | None,
    size: tuple[int, int],
    doubt: str | None = None,
    clicks: str | None = None,
) -> CameraForFrame | None:
    if fit is None or fit.camera is None:
        return None
    camera, _ = fit_to_size(LoadedCamera(fit.camera, fit.model, fit.size), size)
    return CameraForFrame(camera, fit.model, doubt, clicks)


FIT_NAME = "fit"  # no cameras from files are called so


@dataclass(frozen=True, eq=False)
class FittedFrame:
    """A fit, or the reason why it failed, with the clicks it belongs to."""

    annotation: FrameAnnotation
    fit: FitResult


@dataclass(frozen=True, eq=False)
class FittedCameras:
    """Fits by frame name; never changed, so that any thread may read it."""

    fits: Mapping[str, FittedFrame] = field(default_factory=dict)

    @property
    def name(self) -> str:
        """Shown to the user; always the same."""
        return FIT_NAME

    @property
    def origin(self) -> str:
        """Return where the cameras come from, for people."""
        return translatable("Fitted to the clicks of each frame; nothing of it is in a file")

    @cached_property
    def frames(self) -> Mapping[str, FittedFrame]:
        """The frames that have a camera."""
        return {n: fitted for n, fitted in self.fits.items() if fitted.fit.camera is not None}

    def camera(self, frame_name: str, size: tuple[int, int]) -> CameraForFrame | None:
        """A frame's camera in px of an evaluation size, or None if absent."""
        fitted = self.fits.get(frame_name)
        return None if fitted is None else _for_size(fitted.fit, size)

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


TRACK_NAME = "track"  # no cameras from files are called so

# Of the line pixels on the field, explained: of right cameras nine in ten are. Then nothing speaks
# for lines elsewhere: those that were not found are worn, or too thin to be seen, unless hardly any
# of the visible model was found.
_LEAST_EXPLAINED, _HARDLY_ANY = 0.9, 0.3
_MOST_RESIDUAL = 2.0 / 1280  # of the picture's width


def most_residual_px(width: float) -> float:
    """Return how far the paint may be from the lines in a frame that is sure, in px of a picture so
    many px wide."""
    return _MOST_RESIDUAL * width


def review_reason(frame: TrackedFrame) -> str:
    """Why a person should look at a frame before its camera is used; empty where no one need."""
    if frame.fit is None or frame.fit.camera is None:
        return frame.reason or translatable("no camera was found")
    if frame.state == "anchor":
        return ""
    if frame.state != "followed":
        return frame.reason or translatable(
            "carried over by the picture's motion, not measured on paint"
        )
    worn = frame.coverage >= _HARDLY_ANY and (frame.explained or 0.0) >= _LEAST_EXPLAINED
    if frame.coverage < MIN_COVERAGE and not worn:
        share = frame.coverage
        return translatable("only {share:.0%} of the lines in sight are on paint", share=share)
    most = most_residual_px(frame.fit.size[0] * frame.fit.pixel_aspect)
    if frame.residual_px is not None and frame.residual_px > most:
        return translatable("the paint is {px:.1f} px from the lines", px=frame.residual_px)
    return frame.reason


@dataclass(frozen=True, eq=False)
class TrackedCameras:
    """Cameras by frame name; never changed, so that any thread may read it.

    Attributes:
        tracked: of the dataset's frames that were followed, with a camera or without.
    """

    tracked: Mapping[str, TrackedFrame] = field(default_factory=dict)

    @property
    def name(self) -> str:
        """Shown to the user; always the same."""
        return TRACK_NAME

    @property
    def origin(self) -> str:
        """Return where the cameras come from, for people."""
        return translatable("Followed through the shot; nothing of it is in a file")

    @cached_property
    def frames(self) -> Mapping[str, TrackedFrame]:
        """The frames that have a camera."""
        return {
            name: frame
            for name, frame in self.tracked.items()
            if frame.fit is not None and frame.fit.camera is not None
        }

    def camera(self, frame_name: str, size: tuple[int, int]) -> CameraForFrame | None:
        """A frame's camera in px of an evaluation size, or None if absent."""
        frame = self.tracked.get(frame_name)
        if frame is None:
            return None
        return _for_size(frame.fit, size, review_reason(frame) or None, frame.clicks or None)

    def why_none(self, frame_name: str) -> str:
        """Why a frame has no camera, for people."""
        frame = self.tracked.get(frame_name)
        if frame is None:
            return translatable("not followed so far")
        return translatable("no track here: {why}", why=frame.reason)

    def updated(self, changed: Mapping[str, TrackedFrame | None]) -> TrackedCameras:
        """The same with other cameras in some frames, or (None) without these frames."""
        tracked = dict(self.tracked)
        for name, frame in changed.items():
            if frame is None:
                tracked.pop(name, None)
            else:
                tracked[name] = frame
        return TrackedCameras(tracked)
