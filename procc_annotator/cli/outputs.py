"""Guards of output files: never over what it reads, nor among it."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING, cast

from procc_annotator.batch.unit_store import unfinished_path
from procc_annotator.errors import InputError, SaveError, UsageError
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.atomic import make_folder, write_atomic
from procc_annotator.formats.file_listing import CAMERA_PREFIX, list_annotations
from procc_annotator.formats.file_source import FileSource, open_source
from procc_annotator.report.outputs import is_archive
from procc_annotator.report.scores.score_files import score_format

if TYPE_CHECKING:
    from procc_annotator.dataset.camera_set import CameraSet
    from procc_annotator.formats.cameras.collection import CameraCollection

    Input = FileSource | CameraCollection | CameraSet | Path

# Of a folder's JSON files so many are looked into: what a folder of annotations holds is alike.
_LOOKED_INTO = 20


def output_files(
    paths: Iterable[Path] | None, check_suffix: Callable[[Path], object] = score_format
) -> list[Path]:
    """The files that are written, one that is named twice once; UsageError for one of another
    suffix (usually ``.json`` and ``.csv``), or that cannot be written where it is named."""
    files = list({os.path.abspath(path): path for path in paths or ()}.values())
    for path in files:
        check_suffix(path)
        check_output_folder(path)
    return files


def check_output_folder(path: Path) -> None:
    """Make the folder of an output file if absent, before the work; UsageError if the output is a
    folder, SaveError if its folder cannot be made."""
    if path.is_dir():
        raise UsageError(f"{path}: is a folder, a file name is needed")
    make_folder(path.parent)


def check_not_inputs(paths: Iterable[Path], inputs: Iterable[Input]) -> None:
    """Raise UsageError for an output that is one of the files of an input or its archive, under
    this name or another, or that would be a new ``.json`` among the files of one, to be read with
    it the next time."""
    opened = list(inputs)
    for path in paths:
        if path.exists():
            own = path.stat()
            if any(_is_same(file, own) for one in opened for file in _files(one)):
                raise UsageError(f"{path}: is one of the files to be read, write to another one")
        elif path.suffix.lower() == ".json":
            check_folder_apart(path.parent, opened)


def _is_same(file: str, other: os.stat_result) -> bool:
    try:
        return os.path.samestat(os.stat(file), other)
    except OSError:  # gone meanwhile: nothing to lose
        return False


def check_folder_apart(folder: Path, inputs: Iterable[Input]) -> None:
    """Raise UsageError if the files of an input lie directly in a folder that is written to."""
    target = os.path.realpath(folder)
    if any(target in _folders(one) for one in inputs):
        raise UsageError(f"{folder}: holds the files to be read, write to another folder")


def check_no_annotations(folder: Path) -> None:
    """Raise UsageError for a folder of annotations, of whatever set: no cameras are written there.
    InputError if it cannot be listed."""
    field = load_field()  # points are points, whatever the field
    with open_source(folder) as source:
        files = [f for f in list_annotations(source).values() if "/" not in f]
        for file in files[:_LOOKED_INTO]:
            try:
                found = read_annotation(source.read(file), path=source.display(file), field=field)
            except InputError:  # not one, or a damaged one
                continue
            if found.annotated:
                raise UsageError(
                    f"{folder}: holds annotations ({Path(file).name}), write to another folder"
                )


def holds_cameras(
    out: Path, frames: Iterable[str], kinds: Iterable[str] = (f"{CAMERA_PREFIX}*.json",)
) -> bool:
    """Return whether cameras, of whatever frames, lie in a folder (which need not be there) that
    those of some frames would go to: frames of a tree go to folders of it."""
    folders = {"", *(frame.rpartition("/")[0] for frame in frames)}
    found = (place for folder in folders for kind in kinds for place in (out / folder).glob(kind))
    return any(True for _ in found)


def check_replaces_nothing(out: Path, names: Iterable[str], *, overwrite: bool) -> None:
    """Raise UsageError before the work where files are there that no one asked to replace: an
    archive, if ``out`` ends in ``.zip``, else the named files of a folder."""
    if overwrite:
        return
    if is_archive(out):
        if out.exists():
            raise UsageError(
                f"{out}: exists already, choose another name, or --overwrite to replace it"
            )
        return
    if found := [name for name in names if os.path.lexists(out / name)]:
        more = f" and {len(found) - 1} more of the files to be written" if len(found) > 1 else ""
        raise UsageError(
            f"{out}: holds {found[0]}{more} already, choose another folder, or --overwrite to"
            " replace them"
        )


@contextmanager
def replacing_nothing(
    out: Path, names: Iterable[str], command: str, *, overwrite: bool
) -> Iterator[None]:
    """Check as above, and mark a folder as unfinished by a hidden file until all is written: after
    a run was stopped or killed, the same command may replace what that run wrote."""
    unfinished, is_new = unfinished_path(out, command), not out.exists()
    check_replaces_nothing(out, names, overwrite=overwrite or unfinished.exists())
    if is_archive(out):
        yield
        return
    make_folder(out)
    write_atomic(unfinished, b"")
    is_stopped = False
    try:
        yield
    except (KeyboardInterrupt, SaveError):
        is_stopped = True
        raise
    finally:
        if not is_stopped:
            unfinished.unlink(missing_ok=True)
        if is_new:
            with suppress(OSError):  # it holds files, as it should
                out.rmdir()


def check_place(out: Path, inputs: Iterable[Input]) -> None:
    """As above, for an output that is a folder, or an archive if it ends in ``.zip``."""
    if is_archive(out):
        check_not_inputs([out], inputs)
    else:
        check_folder_apart(out, inputs)


def check_is_folder(out: Path) -> None:
    """Raise UsageError for an output that is a file or an archive."""
    if is_archive(out) or (out.exists() and not out.is_dir()):
        raise UsageError(f"{out}: a folder is needed")


def check_camera_folder(out: Path, inputs: Iterable[Path | None]) -> None:
    """Fail before cameras are found (UsageError) if OUT is no folder, or holds pictures,
    annotations or what else is read."""
    check_is_folder(out)
    for given in inputs:
        if given is not None and given.is_dir():
            with open_source(given) as source:
                check_folder_apart(out, [source])
    if out.is_dir():
        check_no_annotations(out)


def _files(one: Input) -> list[str]:
    path = one if isinstance(one, Path) else one.path
    if isinstance(one, Path) or not path.is_dir():
        return [str(path)]
    if not hasattr(one, "decoded"):  # cameras
        return list(one.files())
    source = cast(FileSource, one)
    with open_source(path) as files:
        names = dict.fromkeys((*files.files(), *source.decoded, *list_annotations(source).values()))
    return [os.path.join(path, name) for name in names]


def _folders(one: Input) -> set[str]:
    """The folder of an input, and the split folder its files may lie in."""
    path = one if isinstance(one, Path) else one.path
    if not path.is_dir():
        return set()
    folders = [str(path)]
    if not isinstance(one, Path):
        folders += dict.fromkeys(os.path.dirname(file) for file in _files(one))
    return {os.path.realpath(folder) for folder in folders}
