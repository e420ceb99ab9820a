"""Convert annotations and cameras to another format."""

from __future__ import annotations

import os
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from procc_annotator.camera.base import ElementProjections
from procc_annotator.dataset.annotation_source import open_files
from procc_annotator.dataset.diagnostics import refuse_other_content
from procc_annotator.dataset.layout import annotations_or_path
from procc_annotator.dataset.picture_sizes import PicturesByName, PictureSizes, picture_size
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import CameraError, ImageError, UsageError
from procc_annotator.field.load import field_fingerprint
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.exchange import ExchangedFrame, ReadContext, Size
from procc_annotator.formats.annotations.label_map import LabelMap
from procc_annotator.formats.annotations.registry import ReadSet, SetReader, format_named
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.loaded_camera import LoadedCamera, fit_to_size
from procc_annotator.formats.cameras.polylines import encode_whole
from procc_annotator.formats.cameras.submissions import (
    FORMAT,
    Manifest,
    encode_manifest,
    names_sha256,
)
from procc_annotator.formats.cameras.writers import ConvertedCameras, write_cameras
from procc_annotator.formats.file_listing import MANIFEST_FILE
from procc_annotator.formats.file_source import FileSource
from procc_annotator.image.headers import PICTURE_SUFFIXES
from procc_annotator.metrics.ground_plane import (
    GroundRectangle,
    NearestHomography,
    nearest_homography,
)
from procc_annotator.metrics.projection import complete_projections
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.conversion_output import (
    ConversionRequest,
    Converted,
    check_paths_apart,
    write_converted,
)
from procc_annotator.report.outputs import is_archive, open_target
from procc_annotator.version import __version__

Progress = Callable[[int, int], None]  # frames done, frames in all


def convert_annotations(
    path: Path,
    out: Path,
    wanted: ConversionRequest,
    field: Field,
    *,
    fmt: str = "auto",
    names: LabelMap | None = None,
    size: Size | None = None,
    progress: Progress | None = None,
) -> Converted:
    """Write the annotations of a dataset, folder, archive or file in another format.

    Args:
        path: what is read; a dataset may keep its annotations in ``annotations/``.
        out: a folder, an archive if it ends in ``.zip``, or the file of a format of one file.
        fmt: format of what is read, or ``auto``.
        names: which classes the labels of the files stand for.
        size: of pictures that are not there and whose size no file says.

    Returns:
        Figures; ``frames`` is 0 if nothing was left to write, and then nothing was written.

    Raises:
        UsageError: nothing to read, formats that cannot be determined, an output that is an input.
        InputError: what is read cannot be opened or listed.
        SaveError: writing failed.
    """
    target = format_named(wanted.to)
    folder = annotations_or_path(path)
    check_paths_apart(path, out)
    with open_files(folder) as source:
        if fmt == "auto":
            refuse_other_content(source)
        sizes = PictureSizes.around(path, folder, size)
        reader = SetReader(
            source, field, names,
            fmt=fmt, size_of=sizes.size, pictures=sizes.names(), called=sizes.called,
        )  # fmt: skip
        complete = (
            replace(f, size=f.size or sizes.size(f.name), picture=f.picture or sizes.name(f.name))
            for f in reader.frames(progress)
        )
        inputs = _input_files(source, reader.files) | {
            os.path.realpath(path) for path in sizes.files()
        }
        if wanted.into is not None:
            inputs.add(os.path.realpath(wanted.into))
        done = write_converted(
            complete, out, target, wanted, field, inputs,
            lambda frame: _picture_among(sizes, frame),
        )  # fmt: skip
    done.source = reader.format.title
    done.problems = [*reader.reading.problems, *done.problems]
    done.losses = [*reader.losses, *done.losses]
    done.unknown = dict(reader.reading.unknown.most_common())
    return done


def export_as(
    workspace: Workspace,
    out: Path,
    wanted: ConversionRequest,
    *,
    drafts: Collection[str] = (),
    progress: Progress | None = None,
) -> Converted:
    """Write a dataset's annotations in any format, to ``out`` as of `convert_annotations`;
    ``drafts``: frames with unconfirmed elements, which are not written.

    Raises:
        UsageError: the output lies in the dataset's annotations.
        SaveError: writing failed.
    """
    target = format_named(wanted.to)
    reading = ReadContext(workspace.field, total=len(workspace.frames))
    inputs = {os.path.realpath(f.annotation_path) for f in workspace.frames}
    sized = target.in_pixels or bool(target.one_file)
    frames = _frames_of(workspace, reading, set(drafts), progress, sized=sized)
    done = write_converted(
        frames, out, target, wanted, workspace.field, inputs,
        lambda frame: _picture_in(workspace, frame.name),
    )  # fmt: skip
    done.source = "the dataset"
    done.problems = [*reading.problems, *done.problems]
    done.losses = [*reading.remarks.lines(), *done.losses]
    return done


def read_annotations(
    path: Path,
    workspace: Workspace,
    *,
    fmt: str = "auto",
    names: LabelMap | None = None,
    progress: Progress | None = None,
) -> ReadSet:
    """Annotations of any format, to be taken into a dataset whose pictures give their sizes.

    Raises:
        UsageError, InputError: as for `convert_annotations`.
    """
    with open_files(annotations_or_path(path)) as source:
        reader = SetReader(
            source,
            workspace.field,
            names,
            fmt=fmt,
            size_of=lambda name: _size_in(workspace, name),
            pictures=sorted(frame.picture for frame in workspace.frames),
            called=PicturesByName(workspace.index).called,
        )
        return reader.read_all(progress)


# ------------------------------------------------------------------------------------- reading


def _frames_of(
    workspace: Workspace,
    reading: ReadContext,
    drafts: set[str],
    progress: Progress | None,
    *,
    sized: bool,
) -> Iterator[ExchangedFrame]:
    """Every frame of a dataset that has an annotation, however short."""
    for index, frame in enumerate(workspace.frames):
        with reading.going_on():
            annotation = workspace.read(index)
            if frame.name in drafts:
                reading.remarks.add("unconfirmed elements are not written", frame.name)
            if annotation.polylines or annotation.extra or workspace.has_file(index):
                # A video's frame is kept as a png when it is kept.
                known = os.path.splitext(frame.image_file)[1].lower() in PICTURE_SUFFIXES
                picture = frame.picture if known else f"{frame.name}.png"
                size = _size_in(workspace, frame.name) if sized else None
                yield ExchangedFrame(frame.name, annotation, size, picture)
        if progress is not None:
            progress(index + 1, len(workspace.frames))


def _size_in(workspace: Workspace, name: str) -> Size | None:
    index = workspace.index.get(name)
    try:
        return None if index is None else picture_size(workspace.frames[index].image_path)
    except ImageError:
        return None


def _picture_among(sizes: PictureSizes, frame: ExchangedFrame) -> Path | None:
    """The picture that a file names, or else the one that is called like its frame."""
    folder, slash, _ = frame.name.rpartition("/")
    told = folder + slash + Path(frame.picture or "").stem
    return sizes.path(told) or sizes.path(frame.name)


def _picture_in(workspace: Workspace, name: str) -> Path | None:
    """The file of a frame's picture; None for frames of a video, which have none."""
    path = workspace.frames[workspace.index[name]].image_path
    return path if path.is_file() else None


def _input_files(source: FileSource, read: Sequence[str]) -> set[str]:
    files = {os.path.realpath(source.display(name)) for name in (*source.files(), *read)}
    return files | {os.path.realpath(source.path)}


def export_cameras(
    cameras: CameraCollection,
    out: Path,
    to: str,
    *,
    size: tuple[int, int] | None = None,
    camera_size: tuple[int, int] | None = None,
    split: str = "test",
    region: GroundRectangle | None = None,
    progress: Progress | None = None,
) -> ConvertedCameras:
    """Write every camera of a collection in another format.

    Args:
        out: a folder (made if needed), or an archive if it ends in ``.zip``.
        to: one of `io.camera_writers.CAMERA_TARGETS`.
        size: (width, height) px the cameras shall be written for; by default their own.
        camera_size: the picture size their pixels belong to, where their files do not say.
        split: the folder inside a submission.
        region: of the ground, metres, over which cameras become homographies; None for none.

    Raises:
        UsageError: no such format, or ``out`` is where the cameras are.
        SaveError: writing failed; an archive is then not there, or the old one.
    """
    _check_apart_from_source(cameras.path, out)
    errors: dict[str, NearestHomography] = {}
    done = write_cameras(
        _read(cameras, camera_size, region, errors),
        out,
        to,
        size=size,
        split=split,
        total=len(cameras.frames),
        progress=progress,
    )
    worst = sorted(errors, key=lambda frame: errors[frame].max_m, reverse=True)
    if worst:
        every = [
            f"{frame} {one.max_m:.2g} m, {one.max_px:.2g} px (mean {one.mean_m:.2g} m,"
            f" {one.mean_px:.2g} px)"
            for frame, one in ((frame, errors[frame]) for frame in worst[:_WORST])
        ]
        what = "largest errors of the homographies in the region, in px of the cameras"
        done.losses[f"{what}: {'; '.join(every)}"] = len(worst)
    return done


_WORST = 10  # frames of which the errors of homographies are listed, the worst first


def _read(
    cameras: CameraCollection,
    camera_size: tuple[int, int] | None,
    region: GroundRectangle | None,
    errors: dict[str, NearestHomography],
) -> Iterator[tuple[str, LoadedCamera | CameraError]]:
    for frame in cameras.frames:
        try:
            loaded = cameras.read(frame)
        except CameraError as error:
            yield frame, error
            continue
        loaded = replace(loaded, size=loaded.size_where(camera_size))
        if region is not None and loaded.size and not isinstance(loaded.camera, ElementProjections):
            found = nearest_homography(loaded.camera, region, loaded.size)
            if found is None:
                place, problem = cameras.display(frame), "shows too little of the region"
                yield frame, CameraError(place, problem, advice="name another --region")
                continue
            errors[frame] = found
            loaded = replace(loaded, camera=found.camera, model="homography")
        yield frame, loaded


def _check_apart_from_source(source: Path, out: Path) -> None:
    target = os.path.realpath(out)
    own = os.path.realpath(source)
    if target == own or (os.path.isfile(own) and target == os.path.dirname(own)):
        raise UsageError(f"{out}: this is where the cameras are, write to another place")


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
    """Write where cameras of any model show the elements, with a manifest.

    Args:
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
            whole = complete_projections(camera, setup, frame)
            archive.write(f"{frame}.json", encode_whole(whole, setup.size, loaded.fitted_on))
            done.written += 1
    return done
