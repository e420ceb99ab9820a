"""Tokens of the frame filter: words, number ranges, choices, error messages.

What the words mean is for `frame_query` to say. What is no choice is answered with advice.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import inf

from procc_annotator.errors import UsageError

_KEY = re.compile(r"[A-Za-z][A-Za-z0-9_.@]*")
_NUMBER = re.compile(r"[0-9]+(\.[0-9]+)?|\.[0-9]+")
_OPERATOR = re.compile(r"(<=|>=|==|<|>|=)?\s*(.*)", re.DOTALL)
_QUOTES = frozenset('"“”„')  # texts are pasted from documents too


@dataclass(frozen=True, slots=True)
class Part:
    """One of the alternatives that commas separate, and the character it begins at (from 1)."""

    text: str
    place: int


@dataclass(frozen=True, slots=True)
class Word:
    """One condition: ``-key:value,value`` or, without a key, words to look for in names.

    Attributes:
        parts: the value cut at its commas; commas between quotes do not count.
        value: the whole value, quotes taken off.
        unclosed: whether a quote was opened and not closed.
    """

    place: int
    negated: bool
    key: str
    value: Part
    parts: tuple[Part, ...]
    unclosed: bool


def split_words(text: str) -> list[Word]:
    """The words of a filter, separated by spaces outside quotes; every text has some reading."""
    words = []
    at = 0
    while at < len(text):
        if text[at].isspace():
            at += 1
            continue
        word, at = _word(text, at)
        words.append(word)
    return words


def _word(text: str, start: int) -> tuple[Word, int]:
    """The word that begins at an index, and the index behind it."""
    negated = text[start] == "-"
    at = start + negated
    letters: list[tuple[str, int, bool]] = []  # character, its index, whether it is quoted
    quoted = False
    while at < len(text) and (quoted or not text[at].isspace()):
        if text[at] in _QUOTES:
            quoted = not quoted
        else:
            letters.append((text[at], at, quoted))
        at += 1
    colon = next((i for i, (c, _, q) in enumerate(letters) if c == ":" and not q), -1)
    key = "".join(c for c, _, _ in letters[: max(colon, 0)])
    if colon < 0 or not _KEY.fullmatch(key) or any(q for _, _, q in letters[:colon]):
        key, colon = "", -1
    first = start + negated if colon < 0 else letters[colon][1] + 1
    rest = letters[colon + 1 :]
    value = Part("".join(c for c, _, _ in rest), first + 1)
    return Word(start + 1, negated, key.lower(), value, _parts(rest, first), quoted), at


def _parts(letters: list[tuple[str, int, bool]], first: int) -> tuple[Part, ...]:
    parts = []
    current: list[str] = []
    place = first + 1
    for character, index, quoted in letters:
        if character == "," and not quoted:
            parts.append(Part("".join(current), place))
            current, place = [], index + 2
        else:
            current.append(character)
    parts.append(Part("".join(current), place))
    return tuple(parts)


def cut(text: str) -> str:
    """A text as part of a message: quoted, on one line, not too long."""
    return repr(text if len(text) <= 40 else text[:39] + "…")


def syntax_error(place: int, problem: str) -> UsageError:
    """The error for a filter that cannot be read from some character on."""
    return UsageError(f"filter, character {place}: {problem}")


@dataclass(frozen=True, slots=True)
class NumberRange:
    """The numbers a condition allows."""

    low: float = -inf
    high: float = inf
    low_open: bool = False
    high_open: bool = False

    def holds(self, value: float) -> bool:
        """Return whether a number is among them."""
        above = value > self.low if self.low_open else value >= self.low
        return above and (value < self.high if self.high_open else value <= self.high)


def read_interval(part: Part, *, whole: bool, example: str) -> NumberRange | str:
    """``<0.8``, ``>=2``, ``0.5``, ``0.2..0.8`` (both ends belong to it) as numbers.

    Args:
        whole: only whole numbers are allowed; otherwise shares between 0 and 1, and ``=`` holds for
            what rounds to the number at the decimals given, two at least.
        example: a condition that can be read, for the messages.

    Returns:
        the interval, or what is missing while the text can still become one.

    Raises:
        UsageError: the text cannot become a condition by typing on.
    """
    found = _OPERATOR.fullmatch(part.text.strip())
    operator, rest = (found[1] or "", found[2].strip()) if found else ("", "")
    low, dots, high = rest.partition("..")
    if dots and not operator:
        return _range(low, high, part.place, whole, example)
    if _begun(rest):
        return f"a number is missing, as in {example}"
    value = _number(rest, part.place, whole, example)
    if operator.startswith("<"):
        return NumberRange(high=value, high_open=operator == "<")
    if operator.startswith(">"):
        return NumberRange(low=value, low_open=operator == ">")
    half = 0.0 if whole else 0.5 * 10.0 ** -max(2, len(rest.partition(".")[2]))
    return NumberRange(value - half, value + half)


def _range(low: str, high: str, place: int, whole: bool, example: str) -> NumberRange | str:
    first = _number(low or "0", place, whole, example)  # neither JaC nor counts are below 0
    if _begun(high):
        return f"the end of the range that begins with {first:g} is missing"
    last = _number(high, place, whole, example)
    if last >= first:
        return NumberRange(first, last)
    # 0.8..0 may become 0.8..0.9 and 8..1 may become 8..12 when more is typed
    if whole or float(high + ("9" * 9 if "." in high else ".999999999")) >= first:
        return f"the range {first:g}..{last:g} ends before it begins"
    raise syntax_error(
        place, f"the range {first:g}..{last:g} ends before it begins; turn it around"
    )


def _begun(text: str) -> bool:
    """Return whether a number, or a range, is about to follow: nothing, ``.``, ``0.``."""
    return text in ("", ".") or (text.endswith(".") and bool(_NUMBER.fullmatch(text[:-1])))


def _number(text: str, place: int, whole: bool, example: str) -> float:
    if not _NUMBER.fullmatch(text):
        if _NUMBER.fullmatch(text.replace(",", ".")):
            advice = f"write decimals with a point: {text.replace(',', '.')}"
            raise syntax_error(place, f"{cut(text)} is not a number; {advice}")
        raise syntax_error(place, f"{cut(text)} is not a number; write it as in {example}")
    value = float(text)
    if whole and "." in text:
        raise syntax_error(place, f"{cut(text)} is not a whole number; write it as in {example}")
    if not whole and value > 1:
        advice = f" ({value:g} % is {value / 100:g})" if value <= 100 else ""
        raise syntax_error(place, f"JaC runs from 0 to 1, not to {cut(text)}{advice}")
    return value


def choose(
    parts: Iterable[Part], choices: Mapping[str, str], what: str, others: Mapping[str, str]
) -> tuple[list[str], str]:
    """The alternatives, as they were written, that are choices, and what is missing in the others.

    Args:
        choices: the spelling that is compared -> the one that is shown.
        what: a choice is, with its article.
        others: what belongs behind another key -> how it is written there.

    Raises:
        UsageError: one of them can become no choice, whatever is typed on.
    """
    chosen = []
    missing = ""
    for part in parts:
        given = normalised_text(part.text)
        if given in choices:
            chosen.append(given)
            continue
        begun = [text for key, text in choices.items() if key.startswith(given)]
        if not begun:
            raise syntax_error(part.place, _unknown(part, given, choices, what, others))
        more = ["…"] if len(begun) > 5 else []
        some = ", ".join([*(quoted(text.strip()) for text in begun[:5]), *more])
        lacks = f"{cut(part.text)} is not finished" if given else f"{what} is missing"
        missing = missing or f"character {part.place}: {lacks}: {some}"
    return chosen, missing


def _unknown(
    part: Part, given: str, choices: Mapping[str, str], what: str, others: Mapping[str, str]
) -> str:
    said = f"{cut(part.text)} is not {what}"
    if given in others:
        return f"{said}; did you mean {others[given]}?"
    close = difflib.get_close_matches(given, list(choices), n=1)
    if close:
        return f"{said}; did you mean {quoted(choices[close[0]].strip())}?"
    if what == "a class":
        return f"{said} of this field; with a * at its end it is looked for among all classes"
    return f"{said}; choose one of {', '.join(choices)}"


def other_key_hint(names: Iterable[str], key: str) -> dict[str, str]:
    """Return what belongs behind another key, and how it is written there."""
    return {name: f"{key}:{quoted(name)}" for name in names}


def normalised_text(text: str) -> str:
    """The spelling that is compared: no capitals, single spaces, underscores as spaces."""
    return " ".join(text.replace("_", " ").casefold().split())


def pattern(text: str) -> re.Pattern[str]:
    """``*`` stands for any characters, everything else for itself.

    Atomic groups take the first fit of each middle part, so that many stars cost no more than few.
    """
    first, *others = map(re.escape, re.split(r"\*+", text))
    middle = "".join(f"(?>.*?{part})" for part in others[:-1])
    return re.compile(first + middle + "".join(f".*{part}" for part in others[-1:]), re.DOTALL)


def quoted(text: str) -> str:
    """As it is written in a filter."""
    return f'"{text}"' if " " in text or "," in text else text
