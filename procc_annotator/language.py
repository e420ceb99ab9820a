"""The language of the window: every text it shows is written in English here, and said through
this module in whatever language was chosen.

Commands, files and the Python interface stay English, since nobody chooses a language there. Qt
is not needed to say something: the window hands over how texts are looked up.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Protocol


class LookUp(Protocol):
    """How a text is found in another language."""

    def __call__(self, text: str, about: str, count: int) -> str:
        """The text in the language that is spoken, or as it is; a count below 0: there is none."""


def _as_it_is(text: str, about: str, count: int) -> str:
    return text


_look_up: LookUp = _as_it_is
_in_english: ContextVar[bool] = ContextVar("in_english", default=False)


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
    said = _found(text, about, -1)
    return said.format(**values) if values else said


def tr_count(count: int, one: str, several: str, /, **values: object) -> str:
    """A text about a number of things, in the form that the language has for that number.

    Args:
        count: how many; it stands where ``{n}`` is.
        one, several: the English forms; ``several`` is the key of the translation.
        values: what stands in other places.
    """
    said = _found(several, "", count)
    if said == several and count == 1:
        said = one
    return said.format(n=count, **values)


def word(text: str, about: str = "") -> str:
    """Mark a text of a table: it is collected for translation, and said by ``tr`` when it is
    shown."""
    return text


@contextmanager
def in_english() -> Iterator[None]:
    """Within it everything is said in English: what is made there goes into a file."""
    token = _in_english.set(True)
    try:
        yield
    finally:
        _in_english.reset(token)


class Kept(str):
    """English words that a file keeps, with ``spoken``: the same in the language of the window."""

    spoken: str


def kept(say: Callable[[], str]) -> Kept:
    """What is shown now and goes into a file, too: the name of a step of undo, say.

    Args:
        say: makes the words by ``tr`` and ``tr_count``; called twice.
    """
    with in_english():
        words = Kept(say())
    words.spoken = say()
    return words


def spoken(words: str) -> str:
    """What is kept in English, as the window says it: what ``kept`` made, or ``word`` marked."""
    return words.spoken if isinstance(words, Kept) else tr(words)


def _found(text: str, about: str, count: int) -> str:
    return text if _in_english.get() else _look_up(text, about, count)
