"""Translation of window texts; texts that keep their English original for files.

Commands, files and the Python interface stay English, since no one chooses a language there. Qt
is not needed to say something: the window hands over how texts are looked up.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Protocol


class Translator(Protocol):
    """How a text is found in another language."""

    def __call__(self, text: str, about: str, count: int) -> str:
        """The text in the language that is spoken, or as it is; a count below 0: there is none."""


def _as_it_is(text: str, about: str, count: int) -> str:
    return text


_look_up: Translator = _as_it_is
_in_english: ContextVar[bool] = ContextVar("in_english", default=False)


def set_translator(look_up: Translator | None) -> None:
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
            where they stand in a table. Or what ``said`` made elsewhere, or a file kept.
        about: distinguishes two meanings of the same English words ("left": a side, or remaining).
        values: what stands in the places; without any, braces are braces.
    """
    if isinstance(text, TranslatableText):
        return text.spoken()
    return _filled(_found(text, about, -1), values)


def tr_count(count: int, one: str, several: str, /, **values: object) -> str:
    """A text about a number of things, in the form that the language has for that number.

    Args:
        count: how many; it stands where ``{n}`` is.
        one, several: the English forms; ``several`` is the key of the translation.
        values: what stands in other places.
    """
    found = _found(several, "", count)
    if found == several and count == 1:
        found = one
    return _filled(found, {"n": count, **values})


def word(text: str, about: str = "") -> str:
    """Mark a text of a table: it is collected for translation, and said by ``tr`` when it is
    shown."""
    return text


class TranslatableText(str):
    """English words for files and commands, that know what they are made of: ``tr`` says them, and
    what stands in their places, in the language of the window."""

    _made_of: tuple[str, str, str, int, Mapping[str, object]]  # with one form, and how many

    def spoken(self) -> str:
        """The words in the language of the window."""
        text, about, one, count, values = self._made_of
        if count < 0:
            return tr(text, about, **values)
        return tr_count(count, one, text, **values)

    def __reduce__(self) -> tuple[Callable[..., TranslatableText], tuple[object, ...]]:
        return _translatable, (str(self), *self._made_of)


def translatable(text: str, /, about: str = "", **values: object) -> TranslatableText:
    """Words made without knowing who reads them, or that are shown and go into a file, too (the
    name of a step of undo, say): as ``tr``, but English until ``tr`` says them.

    Args:
        text, about: as of ``tr``; or a title, which is said if the tables have it.
        values: may be made by this, too.
    """
    return _translatable(text.format(**values) if values else text, text, about, "", -1, values)


def translatable_count(count: int, one: str, several: str, /, **values: object) -> TranslatableText:
    """The same for ``tr_count``."""
    english = (one if count == 1 else several).format(n=count, **values)
    return _translatable(english, several, "", one, count, values)


def translatable_joined(between: str, words: Sequence[str]) -> TranslatableText:
    """Phrases that stand on their own, one after the other."""
    places = {f"w{i}": phrase for i, phrase in enumerate(words)}
    return translatable(between.join(f"{{{name}}}" for name in places), **places)


def translatable_all(names: Sequence[str]) -> TranslatableText:
    """Names as a sentence names them: "one", "one and two", "one, two and three"; at least one."""
    if len(names) == 1:
        return translatable_joined("", names)
    return translatable(
        "{names} and {last}", names=translatable_joined(", ", names[:-1]), last=names[-1]
    )


def _translatable(
    english: str, text: str, about: str, one: str, count: int, values: Mapping[str, object]
) -> TranslatableText:
    words = TranslatableText(english)
    words._made_of = text, about, one, count, values
    return words


@contextmanager
def in_english() -> Iterator[None]:
    """Within it everything is said in English: what is made there goes into a file."""
    token = _in_english.set(True)
    try:
        yield
    finally:
        _in_english.reset(token)


def _filled(text: str, values: Mapping[str, object]) -> str:
    if not values:
        return text
    spoken_values = {
        k: v.spoken() if isinstance(v, TranslatableText) else v for k, v in values.items()
    }
    return text.format(**spoken_values)


def _found(text: str, about: str, count: int) -> str:
    return text if _in_english.get() else _look_up(text, about, count)
