"""Cameras of a set as a submission of projected polylines."""

from __future__ import annotations

from collections.abc import Callable, Collection
from pathlib import Path

from procc_annotator.errors import CameraError, UsageError
from procc_annotator.field.fingerprint import field_fingerprint
from procc_annotator.io.camera_files.camera_collection import CameraCollection
from procc_annotator.io.camera_files.camera_writers import ConvertedCameras
from procc_annotator.io.camera_files.cameras import fit_to_size
from procc_annotator.io.camera_files.fitted_on import SIDECAR_SUFFIX, sidecar_content
from procc_annotator.io.camera_files.polyline_submission import (
    FORMAT,
    Manifest,
    encode_manifest,
    encode_polylines,
    names_sha256,
)
from procc_annotator.io.collections import MANIFEST_FILE
from procc_annotator.metric.project import project_measured
from procc_annotator.metric.setup import EvaluationSetup
from procc_annotator.report.targets import is_archive, open_target
from procc_annotator.version import __version__


def export_polylines(
    cameras: CameraCollection,
    out: Path,
    setup: EvaluationSetup,
    method: str,
    frames: Collection[str] | None = None,
    *,
    camera_size: tuple[int, int] | None = None,
    progress: Callable[[int, int], None] = lambda done, total: None,
) -> ConvertedCameras:
    """Write where cameras show the elements, with a manifest.

    Args:
        cameras: of any model.
        out: a ``.zip``.
        setup: field, protocol and size it is to be evaluated with.
        method: its name in tables.
        frames: names of the frames that are to be judged; those of the cameras unless given.
        camera_size: the picture size pixels belong to, where camera files do not say.

    Raises:
        UsageError: no ``.zip``.
        SaveError: writing failed; the archive is then not there, or the old one.
    """
    if not is_archive(out):
        raise UsageError(f"{out}: a submission is an archive, its name must end in .zip")
    wanted = list(cameras.frames if frames is None else frames)
    done = ConvertedCameras(out)
    with open_target(out) as archive:
        manifest = Manifest(
            FORMAT, method, setup.protocol, setup.field.described, field_fingerprint(setup.field),
            setup.size, len(wanted), names_sha256(wanted), __version__,
        )  # fmt: skip
        archive.write(MANIFEST_FILE, encode_manifest(manifest))
        for number, frame in enumerate(wanted, 1):
            progress(number, len(wanted))
            if frame not in cameras.frames:
                continue
            try:
                loaded = cameras.read(frame, setup.field)
                camera, notice = fit_to_size(loaded, setup.size, camera_size)
            except CameraError as error:
                done.problems.append(str(error))
                continue
            done.losses.update([*loaded.notices, *([notice] if notice else [])])
            pieces = project_measured(camera, setup.of_frame(frame))
            archive.write(f"{frame}.json", encode_polylines(pieces, setup.size))
            if loaded.fitted_on is not None:
                archive.write(f"{frame}{SIDECAR_SUFFIX}", sidecar_content(loaded.fitted_on))
            done.written += 1
    return done
