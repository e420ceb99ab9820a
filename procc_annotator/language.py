"""The language of the window: every text it shows is written in English here, and said through
this module in whatever language was chosen.

Commands, files and the Python interface stay English, since nobody chooses a language there. Qt
is not needed to say something: the window hands over how texts are looked up.
"""

from __future__ import annotations

from typing import Protocol


class LookUp(Protocol):
    """How a text is found in another language."""

    def __call__(self, text: str, about: str, count: int) -> str:
        """The text in the language that is spoken, or as it is; a count below 0: there is none."""


def _as_it_is(text: str, about: str, count: int) -> str:
    return text


_look_up: LookUp = _as_it_is


def speak(look_up: LookUp | None) -> None:
    """Say texts as they are looked up from now on; None: in English."""
    global _look_up
    _look_up = look_up or _as_it_is


def is_english() -> bool:
    """Whether texts are said as they are written."""
    return _look_up is _as_it_is


def tr(text: str, /, about: str = "", **values: object) -> str:
    """A text in the language of the window.

    Args:
        text: the English words, with ``{name}`` (or ``{name:.1f}``) where a value stands. They are
            the key of the translation: written out where this is called, or marked by ``word``
            where they stand in a table.
        about: tells two meanings of the same English words apart ("left": a side, or remaining).
        values: what stands in the places; without any, braces are braces.
    """
    said = _look_up(text, about, -1)
    return said.format(**values) if values else said


def tr_count(count: int, one: str, several: str, /, **values: object) -> str:
    """A text about a number of things, in the form that the language has for that number.

    Args:
        count: how many; it stands where ``{n}`` is.
        one, several: the English forms; ``several`` is the key of the translation.
        values: what stands in other places.
    """
    said = _look_up(several, "", count)
    if said == several and count == 1:
        said = one
    return said.format(n=count, **values)


def word(text: str, about: str = "") -> str:
    """Mark a text of a table: it is collected for translation, and said by ``tr`` when it is
    shown."""
    return text
