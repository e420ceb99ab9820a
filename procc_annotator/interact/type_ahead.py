"""What a few letters mean: things found by the beginnings of their words, or nearly so."""

from __future__ import annotations

from difflib import SequenceMatcher

_LETTERS = 5  # the rank of names that hold the letters in order
_ALIKE = 0.75  # of two words of which one is a misspelling of the other
_SHORTEST = 4  # letters of a word that may be misspelt


def match_rank(query: str, *names: str) -> int | None:
    """How well a query fits one thing of several names: lower is better, None is not at all.

    A query fits when each of its words begins a word of one name (``l p b`` finds "Left penalty
    area, bottom"), or when a name contains it.
    """
    wanted = query.casefold().split()
    if not wanted:
        return 0
    ranks = [_rank_name(wanted, " ".join(wanted), _plain(name)) for name in names]
    return min((r for r in ranks if r is not None), default=None)


def loose_rank(query: str, name: str) -> int | None:
    """As `match_rank`, and then names that hold the letters in order, the first one at the
    beginning of a word: ``regall`` finds "Regularise all"."""
    rank = match_rank(query, name)
    if rank is None and _letters_in_order("".join(query.casefold().split()), _plain(name)):
        return _LETTERS
    return rank


def misspelt(query: str, name: str) -> bool:
    """Whether every word of a query is nearly one of a name: ``regulraise all``."""
    words = _plain(name).split()
    return all(_misspelt_one_of(wanted, words) for wanted in query.casefold().split())


def _plain(name: str) -> str:
    return " ".join(name.casefold().replace(",", " ").replace(".", " ").split())


def _rank_name(wanted: list[str], text: str, name: str) -> int | None:
    if not name:
        return None
    if name == text:
        return 0
    if name.startswith(text):
        return 1
    words = name.split()
    at = 0
    for word in words:
        if at < len(wanted) and word.startswith(wanted[at]):
            at += 1
    if at == len(wanted):
        return 2
    if all(any(w.startswith(part) for w in words) for part in wanted):
        return 3
    return 4 if text in name else None


def _letters_in_order(letters: str, name: str) -> bool:
    """Whether a name holds the letters in order, from the beginning of one of its words on; not
    further apart than three places each, or every long name would hold every short word."""
    starts = [i for i in range(len(name)) if i == 0 or name[i - 1] == " "]
    return any(_follows(letters, name[start:]) for start in starts)


def _follows(letters: str, text: str) -> bool:
    at = -1
    for i, letter in enumerate(letters):
        found = text.find(letter, at + 1)
        if found < 0 or (i == 0 and found > 0):
            return False
        at = found
    return at < 3 * len(letters)


def _misspelt_one_of(wanted: str, words: list[str]) -> bool:
    if len(wanted) < _SHORTEST:
        return wanted in words
    matcher = SequenceMatcher(b=wanted)
    for word in words:
        if word[0] != wanted[0]:
            continue  # first letters are seldom the wrong ones
        matcher.set_seq1(word[: len(wanted) + 1])
        if matcher.real_quick_ratio() >= _ALIKE and matcher.ratio() >= _ALIKE:
            return True
    return False
