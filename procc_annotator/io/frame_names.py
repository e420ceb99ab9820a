"""Things by the name of their frame, however its letters are composed.

``é`` is one character to most programs and ``e`` with an accent to a Mac's file system; both look
the same, and files of one frame may be named in both ways.
"""

from __future__ import annotations

import unicodedata
from typing import TypeVar, overload

T = TypeVar("T")
D = TypeVar("D")


class ByFrame(dict[str, T]):
    """A dict that finds a name in another composition where the very name is not there.

    Iterating gives the names as they are.
    """

    _composed: tuple[int, dict[str, str]] | None = None

    def name_there(self, frame: str) -> str | None:
        """How a frame is called here; None where there is nothing of it."""
        if dict.__contains__(self, frame):
            return frame
        if frame.isascii():  # composed in one way only
            return None
        if self._composed is None or self._composed[0] != len(self):
            names: dict[str, str] = {}
            for name in self:
                if not name.isascii():
                    names.setdefault(unicodedata.normalize("NFC", name), name)
            self._composed = len(self), names
        return self._composed[1].get(unicodedata.normalize("NFC", frame))

    def __contains__(self, frame: object) -> bool:
        return isinstance(frame, str) and self.name_there(frame) is not None

    def __missing__(self, frame: str) -> T:
        name = self.name_there(frame)
        if name is None:
            raise KeyError(frame)
        return dict.__getitem__(self, name)

    @overload
    def get(self, frame: str, default: None = None, /) -> T | None: ...
    @overload
    def get(self, frame: str, default: T, /) -> T: ...
    @overload
    def get(self, frame: str, default: D, /) -> T | D: ...
    def get(self, frame: str, default: D | None = None, /) -> T | D | None:
        name = self.name_there(frame)
        return default if name is None else dict.__getitem__(self, name)
