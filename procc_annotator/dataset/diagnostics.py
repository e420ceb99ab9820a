"""Explain what a path holds instead of the expected input, and which field matches the classes
of a set.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.load import field_names, is_builtin_field, load_field
from procc_annotator.field.model import Field
from procc_annotator.formats.annotations.registry import PLAIN, detect_formats
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.formats.annotations.soccernet_set import WITHOUT_GEOMETRY
from procc_annotator.formats.cameras.registry import ALONE_SUFFIXES, detected_title, suffixes_of
from procc_annotator.formats.file_listing import CAMERA_PREFIX, list_annotations
from procc_annotator.formats.file_source import FileSource, open_source, suffix_of
from procc_annotator.formats.unread_formats import unread_format
from procc_annotator.image.headers import PICTURE_SUFFIXES, VIDEO_SUFFIXES
from procc_annotator.messages import pluralize

# Suffixes that annotations, lists and notes have as well say nothing of cameras.
_NOT_CAMERAS_ALONE = frozenset({".json", ".jsonl", ".xml", ".txt", ".yml", ".yaml", ".bin"})
_ANNOTATIONS = frozenset({".json", ".xml"})
_TEXTS = frozenset({".json", ".xml", ".txt", ".out", ".yaml", ".yml"})
_PACKED = "Frames-v3.zip"  # as SoccerNet-v3 is downloaded, one a game
# So many files are read to identify what a set holds.
_LOOKED_INTO = 3


def found_instead_of_annotations(source: FileSource) -> str:
    """Return what a source without annotations holds, to go on after "nothing to do: .."; empty
    where that says nothing."""
    try:
        names = source.tree()
    except InputError:  # too large or too deep for a set: nothing is to be said of it
        return ""
    pictures = sum(suffix_of(name) in PICTURE_SUFFIXES for name in names)
    videos = sum(suffix_of(name) in VIDEO_SUFFIXES for name in names)
    cameras = sum(name.rpartition("/")[2].startswith(CAMERA_PREFIX) for name in names)
    if cameras:
        return f"; it holds {pluralize(cameras, 'camera')} ({CAMERA_PREFIX}*): give the annotations"
    if unread := _unread(source, names):
        return unread
    if suffixes := {suffix_of(name) for name in names} & camera_suffixes():
        files = sum(suffix_of(name) in suffixes for name in names)
        kinds = ", ".join(sorted(suffixes))
        return f"; it holds {pluralize(files, 'file')} of cameras ({kinds}): give the annotations"
    if pictures or videos:
        what = pluralize(pictures, "picture") if pictures else pluralize(videos, "video")
        return (
            f"; it holds {what}, not annotated yet: procc-annotator open {source.path} to click,"
            " propose and annotate without a click"
        )
    return ""


def camera_suffixes() -> frozenset[str]:
    """Lower-case suffixes of files that hold cameras and nothing else this program reads."""
    return suffixes_of() - _NOT_CAMERAS_ALONE


def refuse_cameras(source: FileSource, names: Sequence[str]) -> None:
    """Refuse, by `UsageError`, files that are cameras, by the first of them, where annotations were
    asked for."""
    first = names[:_LOOKED_INTO]
    titles = [_camera_title(source, name) for name in first]
    if not titles or not all(titles):
        return
    what = pluralize(len(names), "file") if len(names) > 1 else "a file"
    raise UsageError(
        f"nothing to do: no annotation in {source.path}; it holds {what} of cameras ({titles[0]}):"
        " give the annotations"
    )


def refuse_other_content(source: FileSource) -> None:
    """Refuse, by `UsageError`, a source without annotations of any format, where it can be
    determined what it is instead."""
    try:
        names, files = source.tree(), list(list_annotations(source).values())
    except InputError:  # told by the reader of the format, for which it may be no problem
        return
    refuse_cameras(source, files)
    if unread := _unread(source, names):
        raise UsageError(f"nothing to do: no annotation in {source.path}{unread}")
    if any(suffix_of(name) in _ANNOTATIONS for name in names):
        return  # even if damaged: its reader says how
    if instead := found_instead_of_annotations(source):
        raise UsageError(f"nothing to do: no annotation in {source.path}{instead}")


def found_instead_of_cameras(place: Path) -> str:
    """Return what a place without cameras holds, to go on after "nothing to do: .."; empty where
    that says nothing. The program's own annotations are reported by the reader of cameras."""
    try:
        with open_source(place) as source:
            told = [known for known in detect_formats(source) if known.name != PLAIN]
            files = source.tree()
            unread = _unread(source, files)
    except (InputError, UsageError):  # what cannot be opened is told where it is needed
        return ""
    if told:
        titles = " and ".join(known.title for known in told)
        return (
            f"; it holds annotations ({titles}): procc-annotator calibrate {place} OUT fits cameras"
            " to them"
        )
    if unread:
        return unread
    if any(suffix_of(name) in suffixes_of() for name in files):
        return ""
    suffixes = ", ".join(sorted(suffixes_of() | ALONE_SUFFIXES))
    return f"; cameras are looked for in files of {suffixes}"


def _camera_title(source: FileSource, name: str) -> str:
    try:
        return detected_title(source.read(name), source.display(name))
    except InputError:  # told where it is read
        return ""


def _unread(source: FileSource, names: Sequence[str]) -> str:
    """Return how many files are of a program whose files are not read, and the way out; empty if
    the first ones are not."""
    for name in [n for n in names if suffix_of(n) not in PICTURE_SUFFIXES][:_LOOKED_INTO]:
        try:
            data = source.read(name) if suffix_of(name) in _TEXTS else b""
        except InputError:  # told where it is read
            continue
        if (known := unread_format(name, data)) is not None:
            files = pluralize(sum(suffix_of(n) == suffix_of(name) for n in names), "file")
            return f"; it holds {files} of {known.title}, which is not read: {known.advice}"
    return ""


def has_packed_pictures(source: FileSource) -> bool:
    """Return whether pictures of SoccerNet-v3 lie in it that are still packed."""
    return any(name.rpartition("/")[2] == _PACKED for name in source.tree())


def found_instead_of_pictures(place: Path) -> str:
    """Where the pictures of a dataset without any are, or what it holds that is not read; empty if
    nothing says so."""
    with open_source(place) as source:
        if not has_packed_pictures(source):
            return _unread(source, source.tree())
    return f"; they are still packed: unpack each {_PACKED} into a folder v3_frames next to it"


# So many annotated frames show which field a set has.
MOST_FRAMES = 20
_SHOWN = 3
_NEARLY_ALL = 0.8


@dataclass(frozen=True, slots=True)
class FieldMatch:
    """Number of classes that a field knows.

    Attributes:
        name: what `load_field` takes.
        known: of the classes.
        official: how many of its own elements every set has that shows it.
    """

    name: str
    title: str
    known: int
    official: int


@dataclass(frozen=True)
class Mismatch:
    """Classes of a set that its field does not know.

    Attributes:
        field: what it is said to show.
        unknown: the classes, sorted.
        classes: how many there are in all.
        better: the field that knows most of them, if it knows more, and half of them at least;
            None: no field does.
    """

    field: Field
    unknown: tuple[str, ...]
    classes: int
    better: FieldMatch | None

    def words(self) -> str:
        """One sentence: what is wrong, and which field would fit."""
        named = ", ".join(self.unknown[:_SHOWN]) + (", ..." if len(self.unknown) > _SHOWN else "")
        own = self.field.source
        own = own if own is not None and not is_builtin_field(own) else None
        of_file = f" of {own.name}" if own is not None else ""
        said = f"the field {self.field.title}{of_file} does not know"
        if self.classes == 1:
            said += " the one class"
        elif len(self.unknown) == self.classes:
            said += f" any of the {self.classes} classes"
        else:
            said += f" {len(self.unknown)} of the {self.classes} classes"
        said += f" annotated here ({named})"
        if self.better is None:
            return said
        known = "all" if self.better.known == self.classes else f"{self.better.known} of them"
        other = "the program's own " if self.better.title == self.field.title else ""
        return f"{said}; {other}{self.better.title} knows {known}"

    @property
    def is_worth_reporting(self) -> bool:
        """Return whether the field must be wrong: another knows more, or it does not know most."""
        return self.better is not None or 2 * len(self.unknown) > self.classes

    @property
    def is_whole(self) -> bool:
        """Return whether it knows so few that nothing can be said class by class."""
        return len(self.unknown) >= _NEARLY_ALL * self.classes


def distinctive_classes(classes: Iterable[str]) -> frozenset[str]:
    """Classes that say which field a set shows, without spaces around them: those of lines that
    no one could name stand for elements of any sport."""
    names = (name.strip() for name in classes)
    return frozenset(n for n in names if n.partition(" (")[0] not in WITHOUT_GEOMETRY)


def rank_fields(classes: Collection[str], more: Sequence[Field] = ()) -> tuple[FieldMatch, ...]:
    """Fields by how many classes they know, the best one first; those that know none are left out.

    Among equals the field with fewer official elements comes first, as more of it is there.

    Args:
        classes: names as in files; spaces around them do not count.
        more: fields next to those the package ships.
    """
    wanted = distinctive_classes(classes)
    found = []
    for field in (*more, *map(load_field, field_names())):
        known = len(wanted & _stripped(field))
        if known:
            official = sum(not e.optional for e in field.elements)
            found.append(FieldMatch(loadable(field), field.title, known, official))
    return tuple(sorted(found, key=lambda match: (-match.known, match.official)))


def mismatch_of(
    classes: Collection[str], field: Field, more: Sequence[Field] = ()
) -> Mismatch | None:
    """Return the remark on the classes of a set that is said to show a field, None where that knows
    them all; for the arguments see `rank_fields`."""
    wanted = distinctive_classes(classes)
    unknown = wanted - _stripped(field)
    if not unknown:
        return None
    best = next(iter(rank_fields(wanted, more)), None)
    if best is not None and not max(len(wanted) - len(unknown) + 1, len(wanted) / 2) <= best.known:
        best = None
    return Mismatch(field, tuple(sorted(unknown)), len(wanted), best)


def classes_in(
    read: Iterable[Callable[[], FrameAnnotation]], most: int = MOST_FRAMES
) -> frozenset[str]:
    """The classes with points in some frames; frames that cannot be read say nothing.

    Args:
        read: reads the annotation of a frame, raising `InputError`.
        most: annotated frames to look at.
    """
    found: set[str] = set()
    seen = 0
    for read_one in read:
        try:
            names = {p.class_name for p in read_one().polylines if p.points}
        except InputError:
            continue
        found |= names
        seen += bool(names)
        if seen == most:
            break
    return frozenset(found)


def classes_of_source(source: FileSource, field: Field) -> frozenset[str]:
    """The same of annotation files, some from all over the set."""
    files = list(list_annotations(source).values())
    step = max(1, len(files) // MOST_FRAMES)

    def read(file: str) -> FrameAnnotation:
        return read_annotation(source.read(file), path=source.display(file), field=field)

    return classes_in(partial(read, file) for file in files[::step])


def _stripped(field: Field) -> frozenset[str]:
    names = (*(e.name for e in field.elements), *field.classes_without_geometry)
    return frozenset(name.strip() for name in names)


def loadable(field: Field) -> str:
    """Return what `load_field` takes for a field: its name, or the path of the user's own file."""
    own = field.source is not None and not is_builtin_field(field.source)
    return str(field.source) if own else field.name
