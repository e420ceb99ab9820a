"""What a run over a set has done so far, in a file beside its output, so that it can go on.

The file is of lines of JSON: what the run was asked for, then the results of a chunk of frames a
line, under a digest of all that they were made from. A line that was cut off when the program was
killed does not count; a chunk whose files changed since is done anew. When all is written the file
goes.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import IO, Any, Self

import numpy as np

from procc_annotator.errors import InputError, SaveError, UsageError
from procc_annotator.field.fingerprint import field_fingerprint
from procc_annotator.field.model import Field
from procc_annotator.io.atomic import sibling_path
from procc_annotator.regular_file import open_regular
from procc_annotator.session.runs.kept_values import SerializationError, deserialize, serialize
from procc_annotator.version import __version__

_FORMAT = "procc-unfinished-1"
_KEY_LENGTH = 64


def checkpoint_path(out: Path, command: str) -> Path:
    """Where it lies: in the folder that is written, or beside the archive; hidden, so that no
    listing of cameras or annotations minds it."""
    if out.suffix.lower() == ".zip":
        return sibling_path(out, ".", f".{command}.unfinished")
    return out / f".{command}.unfinished"


class Checkpoint:
    """The results so far of one run; used as a context, which closes the file."""

    def __init__(self, path: Path, terms: Mapping[str, str], *, resume: bool) -> None:
        """Begin, or go on.

        Args:
            path: see `checkpoint_path`; it and its folder are made with the first results.
            terms: what the run was asked for, in words; another one's results are none of this
                one's.
            resume: whether to go on with what is there; else that goes.

        Raises:
            UsageError: what is there was begun with other terms.
            InputError: it cannot be read.
        """
        self.path = path
        self._terms = {**terms, "version": __version__, "numpy": np.__version__}
        self._places: dict[str, tuple[int, int]] = {}  # key -> where its results lie, bytes
        self._file: IO[bytes] | None = None
        self._end = self._read() if resume else 0

    def __contains__(self, key: str) -> bool:
        """Whether a chunk was done before; what is added now does not count."""
        return key in self._places

    def __len__(self) -> int:
        return len(self._places)

    def results(self, key: str) -> list[Any] | None:
        """The results of a chunk that was done before; None if they cannot be read."""
        at, length = self._places[key]
        try:
            with open_regular(self.path) as file:
                file.seek(at)
                found = deserialize(file.read(length))
        except (OSError, SerializationError):
            return None
        return found if isinstance(found, list) else None

    def add(self, key: str, results: list[Any]) -> None:
        """Keep the results of a chunk, before anything is said of them.

        Raises:
            SaveError: the disk is full, say.
        """
        try:
            if self._file is None:
                self._file = self._begun()
            self._write(f"{key} {serialize(results)}".encode())
        except OSError as error:
            raise SaveError(f"{self.path}: cannot be written: {error.strerror or error}") from error

    def finish(self) -> None:
        """All is written: nothing is left to go on with.

        Raises:
            SaveError: the file cannot be removed.
        """
        self.__exit__()
        try:
            self.path.unlink(missing_ok=True)
        except OSError as error:
            raise SaveError(f"{self.path}: could not be removed: {error.strerror}") from error

    def _begun(self) -> IO[bytes]:
        """The file to add to; what a kill cut off is cut off, and a new one says what it is of."""
        self.path.parent.mkdir(parents=True, exist_ok=True)
        self._file = self.path.open("r+b" if self._end else "w+b")
        self._file.seek(self._end)
        self._file.truncate()
        if not self._end:
            self._write(json.dumps({"format": _FORMAT, "terms": self._terms}).encode())
        return self._file

    def _write(self, line: bytes) -> None:
        assert self._file is not None
        self._file.write(line + b"\n")
        self._file.flush()

    def _read(self) -> int:
        """Find what is there; where the last whole line ends, 0 for nothing."""
        try:
            with open_regular(self.path) as file:
                head = file.readline()
                if not head.endswith(b"\n"):
                    return 0
                self._check(head)
                at = len(head)
                for line in file:
                    if not line.endswith(b"\n"):
                        break
                    key = line[:_KEY_LENGTH].decode("ascii", "replace")
                    begin = at + _KEY_LENGTH + 1
                    self._places[key] = (begin, len(line) - _KEY_LENGTH - 2)
                    at += len(line)
                return at
        except FileNotFoundError:
            return 0
        except OSError as error:
            raise InputError(self.path, f"cannot be read: {error.strerror or error}") from error

    def _check(self, head: bytes) -> None:
        try:
            found = json.loads(head)
            terms = found["terms"] if found["format"] == _FORMAT else None
        except (ValueError, KeyError, TypeError):
            terms = None
        if not isinstance(terms, dict):
            raise InputError(
                self.path,
                "is not what a run of this program leaves",
                advice="remove it, or begin anew with --overwrite",
            )
        for name in dict.fromkeys((*self._terms, *terms)):
            before, now = terms.get(name), self._terms.get(name)
            if before != now:
                raise UsageError(
                    f"{self.path.parent}: what is there was begun with another {name}"
                    f" ({before or 'none'}, now {now or 'none'}); ask for the same to go on, or"
                    " begin anew with --overwrite"
                )

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *failure: object) -> None:
        if self._file is not None:
            self._file.close()
            self._file = None


def hex_digest(*parts: object) -> str:
    """SHA-256, in hexadecimal, of bytes, and of the text of anything else; names of files may be no
    UTF-8."""
    digest = hashlib.sha256()
    for part in parts:
        data = part if isinstance(part, bytes) else str(part).encode("utf-8", "surrogatepass")
        digest.update(len(data).to_bytes(8, "big"))
        digest.update(data)
    return digest.hexdigest()


def field_settings(field: Field) -> str:
    """A field as a term of a run: its words and a digest of all that fits and proposals look at,
    which is more than tells fields apart."""
    looked_at = (
        field.cameras,
        [(e.name, e.appearance, e.line_width, e.inside) for e in field.elements],
        [(m.name, m.position, m.covariance, m.instant, m.surveyed) for m in field.landmarks],
        sorted(field.instants.items()),
    )
    return f"{field.described}, {hex_digest(field_fingerprint(field), repr(looked_at))[:12]}"


def stamp_of_file(path: Path) -> str:
    """Size and time of a file, as a text; empty for none."""
    try:
        found = path.stat()
    except OSError:  # what is not there is told where it is wanted
        return ""
    return f"{found.st_size} {found.st_mtime_ns}"
