"""Cameras of methods by frame name; writing the projections of cameras of any model."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path

from procc_annotator.annotation import as_size
from procc_annotator.api.inputs import (
    AnyCamera,
    as_field,
    as_frame_names,
    as_optional_size,
    as_path,
    camera_at_size,
    kind_of,
    loaded_camera,
)
from procc_annotator.api.loading import load_cameras
from procc_annotator.calibration.fitting import DEFAULT_SIZE
from procc_annotator.calibration.result import FitResult
from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera
from procc_annotator.formats.cameras.polylines import encode_whole
from procc_annotator.formats.frame_names import FrameTable, files_of_frames
from procc_annotator.metrics.projection import complete_projections
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.outputs import open_target

Cameras = Mapping[str, AnyCamera | None]
Method = str | Path | Cameras | Sequence[AnyCamera | None] | Callable[[str], AnyCamera | None]
"""Cameras of a method: a path, cameras by frame name, a list of them in the order of the frames, or
a function of the frame's name."""


def cameras_of(
    method: Method, frames: Iterable[str] | None, name: str = "cameras"
) -> FrameTable[AnyCamera | None]:
    """The cameras of a method by frame name; a fit that failed is None.

    Args:
        method: as a caller gave it.
        frames: names of the frames; None for those of the method itself.
        name: how to call it in messages.

    Raises:
        UsageError: it is no method, or has no names where none are given.
        InputError: a file cannot be used.
    """
    if isinstance(method, str | Path):
        method = load_cameras(method)
    if isinstance(method, Mapping):
        found = method if isinstance(method, FrameTable) else FrameTable(method)
    else:
        names = None if frames is None else list(frames)
        if names is None:
            raise UsageError(f"{name}: give the names of the frames, these cameras have none")
        if callable(method):
            found = FrameTable((frame, method(frame)) for frame in names)
        elif isinstance(method, Sequence) and len(method) == len(names):
            found = FrameTable(zip(names, method, strict=True))
        else:
            what = f"{len(method)} cameras" if isinstance(method, Sequence) else kind_of(method)
            raise UsageError(
                f"{name}: expected a path, cameras by frame name, one for each of the {len(names)}"
                f" frames, or a function of the frame's name, found {what}"
            )
    for frame, camera in found.items():
        if isinstance(camera, FitResult) and camera.camera is None:
            found = FrameTable({**found, frame: None})
    return found


def save_projection(
    path: str | Path,
    cameras: Method,
    frames: Iterable[str] | None = None,
    *,
    field: Field | str | None = None,
    size: tuple[int, int] = DEFAULT_SIZE,
    camera_size: tuple[int, int] | None = None,
    overwrite: bool = False,
) -> tuple[str, ...]:
    """Write where cameras of any model show the field, as a method that every command reads.

    Both protocols need nothing else of a camera: the files hold the points that the official
    evaluation projects, and curves beyond the picture. Evaluated at ``size``, counts and distances
    equal those of the cameras themselves; at another size curves of ``procc`` may differ by 0.003
    px. The commands find the format by themselves.

    Args:
        path: a folder, or an archive that ends in .zip; a file for each frame.
        cameras: frame name -> its camera, of any model, as `evaluate` takes it; or a list of
            cameras, or a function that returns the camera of a frame's name; or the path of camera
            files.
        frames: names of the frames to write; those of ``cameras`` if None.
        field: as of `evaluate`. The files are refused for another field.
        size: (width, height) px at which they are to be evaluated.
        camera_size: as of `evaluate`.
        overwrite: whether files that are there may be replaced.

    Returns:
        Names of the frames that were written; frames without a camera are left out.

    Raises:
        UsageError: no camera, an argument of another kind, or files that are there.
        SaveError: writing failed.
    """
    out, given = as_path(path, "a folder or .zip"), as_frame_names(frames)
    found = cameras_of(cameras, given)
    setup, own = EvaluationSetup(as_field(field), as_size(size)), as_optional_size(camera_size)
    written = [name for name in given or found if found.get(name) is not None]
    if not written:
        raise UsageError(f"{out}: nothing to write: no frame has a camera")
    if out.suffix.lower() == ".json":
        raise UsageError(f"{out}: expected the name of a folder, or one that ends in .zip")
    files = files_of_frames(written, ".json")
    there = [out] if out.is_file() else [p for p in map(out.joinpath, files.values()) if p.exists()]
    if there and not overwrite:
        raise UsageError(f"{there[0]}: is there already (overwrite=True replaces it)")
    with open_target(out) as target:
        for name, file in files.items():
            used = camera_at_size(
                found[name], setup.size, own, f"camera of {name}", field=setup.field
            )
            whole = complete_projections(used.camera, setup, name)
            target.write(file, encode_whole(whole, setup.size, used.fitted_on))
    return tuple(written)


class CamerasInMemory(CameraCollection):
    """Cameras of a program as a collection of files, in the process that has them."""

    def __init__(self, cameras: Mapping[str, AnyCamera | None], name: str, field: Field) -> None:
        self.path, self.format, self.field, self.remarks = Path(name), "values", field, ()
        self._cameras = {frame: one for frame, one in cameras.items() if one is not None}
        self.frames = FrameTable((frame, frame) for frame in self._cameras)

    def read(self, frame: str, field: Field | None = None) -> LoadedCamera:
        """See `CameraCollection`."""
        loaded = loaded_camera(self._cameras[self.frames[frame]], self.display(frame))
        return self._of_field(loaded, frame, field)

    def display(self, frame: str) -> str:
        """See `CameraCollection`."""
        return f"{self.path}: camera of {frame}"

    def folders(self) -> list[str]:
        """See `CameraCollection`."""
        return []

    def files(self) -> Iterable[str]:
        """See `CameraCollection`."""
        return ()

    def __exit__(self, *failure: object) -> None:
        """Nothing is open."""
