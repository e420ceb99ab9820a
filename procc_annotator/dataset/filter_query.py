"""Frame filter language, e.g. ``state:rejected jac5:<0.8 -has:"Circle left"``.

Conditions stand side by side and must all hold; a leading ``-`` turns one around; quotes keep
spaces, commas and colons together; commas separate alternatives. Words without a key are looked
for in the frame's name. What is not finished yet lets every frame through.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from math import inf

from procc_annotator.calibration.label_check.finding import Severity
from procc_annotator.dataset.filter_syntax import (
    Word,
    choose,
    cut,
    normalised_text,
    other_key_hint,
    pattern,
    read_interval,
    split_words,
    syntax_error,
)
from procc_annotator.dataset.records import FaultParty, Status
from procc_annotator.field.model import Field

STATUSES = tuple(str(status) for status in Status)

# Shown by the window next to the search box: what can be written, and what it finds.
QUERY_HELP = (
    ("frame_01", "the name contains it; * stands for anything"),
    ("state:rejected,done", f"status, any of {', '.join(STATUSES)}"),
    ("jac:<0.8", "JaC at the tau in use; < <= > >= = or a range: 0.2..0.8"),
    ("jac5:>=0.9", "JaC at tau 5"),
    ("jac:none", "frames without a score"),
    ('has:"Circle left"', "the class is annotated; its title will do, * stands for anything"),
    ("n:<5", "number of annotated elements"),
    ("comments:open", "comments that are open; comments:none, comments:>2"),
    ("comment:blurred", "a comment contains it"),
    ("verdict:camera", "camera wrong under any source; verdict:annotation, fine, none"),
    ("check:error", "errors of the label check; check:warning, hint, none, unchecked"),
    ("camera:unreadable", "the active source's camera cannot be read; camera:none"),
    ("is:unsaved", "also is:unreadable, is:unconfirmed"),
    ("-has:Middle*", "a minus in front: frames for which it does not hold"),
    ('"in:out 1"', "quotes keep spaces, commas and colons"),
)


@dataclass(frozen=True, slots=True)
class FrameFacts:
    """Properties of one frame that a filter can use.

    Attributes:
        status: one of `STATUSES`; ``in_progress`` is read as ``in progress``.
        annotated: classes with points; None when the annotation is not known or unreadable.
        jac: JaC of the frame at a tau in px, None for the tau in use; None when it has no score.
        verdicts: the parties at fault, under any camera source.
        findings: how sure the label check's findings are; None: it was not checked.
        has_camera: whether the active source has a camera for it; None: one that cannot be read.
    """

    name: str
    status: str
    annotated: tuple[str, ...] | None
    comments: int
    open_comments: int
    comment_text: str
    unsaved: bool
    unreadable: bool
    unconfirmed: bool
    jac: Callable[[float | None], float | None]
    verdicts: frozenset[str] = frozenset()
    findings: frozenset[str] | None = None
    has_camera: bool | None = True


# None: it cannot be determined, so the frame matches neither the condition nor its opposite.
_Test = Callable[[FrameFacts], bool | None]
_NO_VERDICT = "none"
_NO_FINDING, _UNCHECKED = "none", "unchecked"
_CAMERAS: Mapping[str, bool | None] = {"unreadable": None, "none": False}
_NEEDS_NOTHING, _CHECK, _ANNOTATION, _JAC = range(4)  # what a condition needs, cheapest first


@dataclass(frozen=True, slots=True)
class _Term:
    """A parsed word; without a test it is not finished and every frame matches."""

    test: _Test | None
    needs: int = _NEEDS_NOTHING
    missing: str = ""


@dataclass(frozen=True, slots=True)
class _Condition:
    test: _Test
    needs: int
    negated: bool


@dataclass(frozen=True)
class FrameQuery:
    """A filter that was read. Two filters are equal when their texts are.

    Attributes:
        incomplete: what is missing while a person types; empty when all conditions are finished.
    """

    text: str
    incomplete: str = field(default="", compare=False)
    _conditions: tuple[_Condition, ...] = field(default=(), compare=False, repr=False)

    @property
    def is_empty(self) -> bool:
        """Return whether every frame matches because nothing is asked."""
        return not self._conditions

    @property
    def needs_annotation(self) -> bool:
        """Return whether the frames' files must have been read for the answer to be right."""
        return any(c.needs == _ANNOTATION for c in self._conditions)

    @property
    def needs_check(self) -> bool:
        """Return whether it is asked what the label check found."""
        return any(c.needs == _CHECK for c in self._conditions)

    def matches(self, facts: FrameFacts) -> bool:
        """Return whether a frame meets all conditions; costly ones are asked last."""
        for condition in self._conditions:
            result = condition.test(facts)
            if result is None or result is condition.negated:
                return False
        return True


def parse_query(text: str, field: Field) -> FrameQuery:
    """Read a filter; classes are those of the field. `UsageError`, with the character and what to
    write instead, for a condition that typing on cannot fix."""
    conditions = []
    incomplete = ""
    for word in split_words(text):
        term = _term(word, field)
        incomplete = incomplete or term.missing
        if term.test is not None:
            conditions.append(_Condition(term.test, term.needs, word.negated))
    conditions.sort(key=lambda condition: condition.needs)
    return FrameQuery(text, incomplete, tuple(conditions))


def _term(word: Word, field: Field) -> _Term:
    if word.unclosed:
        return _unfinished(word.place, "the closing quote is missing")
    if not word.key:
        return _name(word)
    if word.key in _READERS:
        return _READERS[word.key](word)
    if word.key == "has":
        return _has(word, field)
    jac = re.fullmatch(r"jac@?([0-9]+(?:\.[0-9]+)?)?", word.key)
    if jac:
        return _jac(word, jac[1])
    keys = (*_READERS, "has", "jac")
    close = difflib.get_close_matches(word.key, [*keys, "jac5"], n=1)
    advice = f"did you mean {cut(close[0] + ':')}?" if close else f"there are {', '.join(keys)}"
    quotes = "; put it in quotes to look for it in names"
    raise syntax_error(word.place, f"unknown filter {cut(word.key + ':')}; {advice}{quotes}")


# --------------------------------------------------------------------------------- text


def _name(word: Word) -> _Term:
    if not word.value.text:
        return _unfinished(word.value.place, "a part of a name is missing")
    wanted = word.value.text.casefold()
    if "*" in wanted:
        search = pattern(wanted).search
        return _Term(lambda facts: search(facts.name.casefold()) is not None)
    return _Term(lambda facts: wanted in facts.name.casefold())


def _comment(word: Word) -> _Term:
    if not word.value.text:
        return _unfinished(word.value.place, "a part of a comment is missing")
    wanted = word.value.text.casefold()
    return _Term(lambda facts: wanted in facts.comment_text.casefold())


# ------------------------------------------------------------------------------ choices

# The last two are known for certain only when the frame's file was read.
_FLAGS: Mapping[str, tuple[_Test, int]] = {
    "unsaved": (lambda facts: facts.unsaved, _NEEDS_NOTHING),
    "unreadable": (lambda facts: facts.unreadable or _if_read(facts), _ANNOTATION),
    "unconfirmed": (lambda facts: facts.unconfirmed or _if_read(facts), _ANNOTATION),
}


def _if_read(facts: FrameFacts) -> bool | None:
    return None if facts.annotated is None and not facts.unreadable else False


def _is(word: Word) -> _Term:
    chosen, missing = _chosen(word, _FLAGS, "a property", other_key_hint(STATUSES, "state"))
    tests = [_FLAGS[name][0] for name in chosen]
    needs = max((_FLAGS[name][1] for name in chosen), default=_NEEDS_NOTHING)

    def test(facts: FrameFacts) -> bool | None:
        answers = [test(facts) for test in tests]
        return True if True in answers else None if None in answers else False

    return _Term(test if chosen else None, needs, missing)


def _state(word: Word) -> _Term:
    choices = {normalised_text(status): status for status in STATUSES}
    chosen, missing = choose(word.parts, choices, "a status", other_key_hint(_FLAGS, "is"))
    wanted = {spelling for name in chosen for spelling in (name, name.replace(" ", "_"))}
    return _Term((lambda facts: facts.status in wanted) if chosen else None, missing=missing)


def _verdict(word: Word) -> _Term:
    choices = (*map(str, FaultParty), _NO_VERDICT)
    wanted, missing = _chosen(word, choices, "a verdict", other_key_hint(STATUSES, "state"))

    def test(facts: FrameFacts) -> bool:
        return bool(wanted & facts.verdicts) or (_NO_VERDICT in wanted and not facts.verdicts)

    return _Term(test if wanted else None, missing=missing)


def _check(word: Word) -> _Term:
    choices = (*map(str, Severity), _NO_FINDING, _UNCHECKED)
    wanted, missing = _chosen(word, choices, "a finding", other_key_hint(STATUSES, "state"))

    def test(facts: FrameFacts) -> bool | None:
        if facts.findings is None:
            return True if _UNCHECKED in wanted else None
        return bool(wanted & facts.findings) or (_NO_FINDING in wanted and not facts.findings)

    return _Term(test, _CHECK, missing) if wanted else _Term(None, missing=missing)


def _camera(word: Word) -> _Term:
    hint = other_key_hint(_FLAGS, "is")
    chosen, missing = _chosen(word, _CAMERAS, "a state of a camera", hint)
    wanted = [_CAMERAS[name] for name in chosen]
    return _Term((lambda facts: facts.has_camera in wanted) if wanted else None, missing=missing)


def _chosen(
    word: Word, choices: Iterable[str], what: str, others: Mapping[str, str]
) -> tuple[frozenset[str], str]:
    chosen, missing = choose(word.parts, {name: name for name in choices}, what, others)
    return frozenset(chosen), missing


def _has(word: Word, field: Field) -> _Term:
    known = [*field.index, *field.classes_without_geometry]
    names = {normalised_text(e.title): e.name for e in field.elements} | {
        normalised_text(n): n for n in known
    }
    spelled = {normalised_text(text): text for text in (*known, *(e.title for e in field.elements))}
    written = [part for part in word.parts if "*" not in part.text]
    others = other_key_hint(STATUSES, "state") | {"comment": "comments:>0"}
    chosen, missing = choose(written, spelled, "a class", others)
    patterns = [pattern(normalised_text(part.text)) for part in word.parts if "*" in part.text]
    chosen += [key for key in names if any(p.fullmatch(key) for p in patterns)]
    wanted = frozenset(names[key].strip() for key in chosen)
    if not wanted and not patterns:
        return _Term(None, missing=missing)

    def test(facts: FrameFacts) -> bool | None:
        if facts.annotated is None:
            return None
        return any(
            name.strip() in wanted or any(p.fullmatch(normalised_text(name)) for p in patterns)
            for name in facts.annotated
        )

    return _Term(test, _ANNOTATION, missing)


# ------------------------------------------------------------------------------ numbers


def _in_interval(
    word: Word,
    number: Callable[[FrameFacts], float | None],
    needs: int = _NEEDS_NOTHING,
    *,
    example: str,
    whole: bool = True,
) -> _Term:
    interval = read_interval(word.value, whole=whole, example=example)
    if isinstance(interval, str):
        return _unfinished(word.value.place, interval)
    holds = interval.holds

    def test(facts: FrameFacts) -> bool | None:
        found = number(facts)
        return None if found is None else holds(found)

    return _Term(test, needs)


def _elements(word: Word) -> _Term:
    def count(facts: FrameFacts) -> int | None:
        return None if facts.annotated is None else len(facts.annotated)

    return _in_interval(word, count, _ANNOTATION, example="<5")


def _comments(word: Word) -> _Term:
    given = normalised_text(word.value.text)
    if given == "open":
        return _Term(lambda facts: facts.open_comments > 0)
    if given == "none":
        return _Term(lambda facts: facts.comments == 0)
    if given and ("open".startswith(given) or "none".startswith(given)):
        return _unfinished(word.value.place, f"{cut(given)} is not finished: open, none")
    return _in_interval(word, lambda facts: facts.comments, example=">0 (or open, none)")


def _jac(word: Word, written_tau: str | None) -> _Term:
    tau = None if written_tau is None else float(written_tau)
    if tau is not None and not 0 < tau < inf:
        raise syntax_error(
            word.place, f"tau is a distance above 0 px, not {cut(written_tau or '')}"
        )
    given = normalised_text(word.value.text)
    if given == "none":
        return _Term(lambda facts: facts.jac(tau) is None, _JAC)
    if given and "none".startswith(given):
        return _unfinished(word.value.place, f"{cut(given)} is not finished: none")
    return _in_interval(word, lambda facts: facts.jac(tau), _JAC, example="<0.8", whole=False)


_READERS: Mapping[str, Callable[[Word], _Term]] = {
    "state": _state,
    "status": _state,
    "n": _elements,
    "elements": _elements,
    "comment": _comment,
    "comments": _comments,
    "is": _is,
    "verdict": _verdict,
    "check": _check,
    "camera": _camera,
    "name": _name,
}


def _unfinished(place: int, missing: str) -> _Term:
    return _Term(None, missing=f"character {place}: {missing}")
