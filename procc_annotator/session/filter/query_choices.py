"""Words of a filter that must be one of several; what is not is answered with advice."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Mapping

from procc_annotator.session.filter.query_words import Part, cut, wrong


def choose(
    parts: Iterable[Part], choices: Mapping[str, str], what: str, others: Mapping[str, str]
) -> tuple[list[str], str]:
    """The alternatives that are choices, and what is missing in the others.

    Args:
        parts: as they were written.
        choices: the spelling that is compared -> the one that is shown.
        what: a choice is, with its article.
        others: what belongs behind another key -> how it is written there.

    Raises:
        UsageError: one of them can become no choice, whatever is typed on.
    """
    chosen = []
    missing = ""
    for part in parts:
        given = plain(part.text)
        if given in choices:
            chosen.append(given)
            continue
        begun = [text for key, text in choices.items() if key.startswith(given)]
        if not begun:
            raise wrong(part.place, _unknown(part, given, choices, what, others))
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


def elsewhere(names: Iterable[str], key: str) -> dict[str, str]:
    """What belongs behind another key, and how it is written there."""
    return {name: f"{key}:{quoted(name)}" for name in names}


def plain(text: str) -> str:
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
