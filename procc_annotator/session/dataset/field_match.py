"""Which field the classes of a set belong to, where its own does not know them."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import dataclass
from functools import partial

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError
from procc_annotator.field.load import field_names, is_builtin_field, load_field
from procc_annotator.field.model import Field
from procc_annotator.io.annotation_files.soccernet_annotation import read_annotation
from procc_annotator.io.annotation_files.soccernet_classes import WITHOUT_GEOMETRY
from procc_annotator.io.collections import list_annotations
from procc_annotator.io.source import FileSource

# So many annotated frames tell which field a set shows.
MOST_FRAMES = 20
_SHOWN = 3
_NEARLY_ALL = 0.8


@dataclass(frozen=True, slots=True)
class FieldMatch:
    """How many of some classes a field knows.

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
        """Whether the field must be wrong: another knows more, or it does not know most."""
        return self.better is not None or 2 * len(self.unknown) > self.classes

    @property
    def is_whole(self) -> bool:
        """Whether it knows so few that nothing can be said class by class."""
        return len(self.unknown) >= _NEARLY_ALL * self.classes


def distinctive_classes(classes: Iterable[str]) -> frozenset[str]:
    """Classes that say which field a set shows, without spaces around them: those of lines that
    nobody could name stand for elements of any sport."""
    names = (name.strip() for name in classes)
    return frozenset(n for n in names if n.partition(" (")[0] not in WITHOUT_GEOMETRY)


def rank_fields(classes: Collection[str], more: Sequence[Field] = ()) -> tuple[FieldMatch, ...]:
    """Fields by how many classes they know, the best one first; those that know none are left out.

    Among equals the field with fewer official elements comes first, as more of it is there.

    Args:
        classes: names as in files; spaces around them do not count.
        more: fields beside those the package ships.
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
    """What is to say of the classes of a set; None where its field knows them all.

    Args:
        classes: names as in files.
        field: the one the set is said to show.
        more: fields beside those the package ships.
    """
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
    """The classes with points in some frames; frames that cannot be read tell nothing.

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


def classes_of_source(source: FileSource, field: Field, most: int = MOST_FRAMES) -> frozenset[str]:
    """The same of annotation files, some from all over the set."""
    files = list(list_annotations(source).values())
    step = max(1, len(files) // most)

    def read(file: str) -> FrameAnnotation:
        return read_annotation(source.read(file), path=source.display(file), field=field)

    return classes_in((partial(read, file) for file in files[::step]), most)


def _stripped(field: Field) -> frozenset[str]:
    names = (*(e.name for e in field.elements), *field.classes_without_geometry)
    return frozenset(name.strip() for name in names)


def loadable(field: Field) -> str:
    """What `load_field` takes for a field: its name, or the path of the user's own file."""
    own = field.source is not None and not is_builtin_field(field.source)
    return str(field.source) if own else field.name
