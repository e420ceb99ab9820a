"""The error tree.

ProccError                     anything the user sees in one line
+-- InputError                 a file that cannot be used: path, place in it, what was expected
|   +-- FieldError             a field description (resources/field/*.toml)
|   +-- AnnotationError        an annotation file
|   +-- CameraError            a camera or homography file
|   +-- ImageError             a picture
+-- SaveError                  writing failed; the last good file is untouched
|   +-- ChangedOnDiskError     the file is not the one that was read; nothing was written
+-- UsageError                 a request that makes no sense (unknown protocol, no such folder)
"""

from __future__ import annotations

from pathlib import Path, PurePath


class ProccError(Exception):
    """Base of every error this program raises on purpose; its text is one line for the user.

    Names of files and quoted content stay as they are, but for characters that would break the
    line or command a terminal: those are escaped.
    """

    def __init__(self, text: str) -> None:
        super().__init__(printable(text))


class InputError(ProccError):
    """A file that cannot be used.

    Args:
        path: the file (inside an archive: ``archive.zip/member.json``).
        problem: what is wrong and what was expected, without a full stop.
        place: where in the file (``radial_distortion[2]``, ``line 3``); empty for all of it.
        advice: what to do about it; may be empty.
    """

    def __init__(
        self, path: PurePath | str, problem: str, *, place: str = "", advice: str = ""
    ) -> None:
        self.path = str(path)
        self.place = place
        self.problem = problem
        self.advice = advice
        where = f"{self.path}: {place}" if place else self.path
        # Libraries explain themselves in several lines.
        said = " ".join(line.strip() for line in problem.splitlines())
        text = f"{where}: {said}" + (f" ({advice})" if advice else "")
        super().__init__(text)

    def __reduce__(self) -> tuple[object, ...]:
        """Survive the trip out of a worker process, keyword arguments included."""
        return _rebuild, (type(self), self.path, self.problem, self.place, self.advice)


def _rebuild(
    kind: type[InputError], path: str, problem: str, place: str, advice: str
) -> InputError:
    return kind(path, problem, place=place, advice=advice)


class FieldError(InputError):
    """A field description that cannot be used."""


class AnnotationError(InputError):
    """An annotation file that cannot be used."""


class CameraError(InputError):
    """A camera or homography file that cannot be used."""


class ImageError(InputError):
    """A picture that cannot be decoded."""


class SaveError(ProccError):
    """A file could not be written; whatever was there before is intact."""


class ChangedOnDiskError(SaveError):
    """The file changed since it was read; it was not overwritten."""


class UsageError(ProccError):
    """The request itself makes no sense."""


def printable(text: str, keep: str = "") -> str:
    """Text with every character escaped that would break its line or command a terminal.

    Args:
        text: of anyone.
        keep: such characters that may stay.
    """
    if text.isprintable():
        return text
    return "".join(c if c.isprintable() or c in keep else ascii(c)[1:-1] for c in text)


def require_existing(*paths: Path | None) -> None:
    """UsageError for a path, of those that are given, at which there is nothing."""
    for path in paths:
        if path is not None and not path.exists():
            raise UsageError(f"{path}: does not exist")
