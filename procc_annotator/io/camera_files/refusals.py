"""Why decoded content is a camera of none of the formats that are told by what is in it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any

from procc_annotator.io.camera_files.krt_camera import KrtKeys
from procc_annotator.io.camera_files.projection_camera import KEYS as PROJECTION_KEYS
from procc_annotator.io.json_text import kind_of, printable

# What an object is refused for, or what is to say of a list, text, number.
Why = Callable[[object], str]

_KRT = KrtKeys()


def refusals(content: object, tried: Iterable[tuple[str, Why, bool]]) -> str:
    """Every format that was tried and why it does not know the content, in one line.

    Args:
        content: decoded, of no known format.
        tried: the formats' names, what each of them wants, and whether files may hold such a camera
            for each frame: of an object of nothing but objects the first is looked at then.
    """
    name, entry = _first_entry(content)
    alike: dict[str, list[str]] = {}
    for tried_name, why, by_frame in tried:
        inside = entry is not None and by_frame
        said = f"{name!r} {why(entry)}" if inside else why(content)
        alike.setdefault(said, []).append(tried_name)
    return "; ".join(f"{', '.join(names)}: {said}" for said, names in alike.items())


def lacks(*keys: str) -> Why:
    """For a format that is an object with some keys: which of them are not there."""

    def why(content: object) -> str:
        if type(content) is not dict:
            return _no_object(content)
        return "lacks " + _quoted(key for key in keys if key not in content)

    return why


def entries_lack(*keys: str) -> Why:
    """For a format that is a list, or an object, of objects with some keys."""

    def why(content: object) -> str:
        if type(content) not in (dict, list):
            return _no_object(content)
        missing = _missing_of_nearest(_objects_in(content), keys)
        return f"no entry has {_quoted(missing)}"

    return why


def no_list_of(*keys: str) -> Why:
    """For a format that is a list of objects with some keys."""
    inside = entries_lack(*keys)
    return lambda content: (
        inside(content) if type(content) is list else f"is {kind_of(content)}, not a list"
    )


def entries_below_lack(holder: str, *keys: str) -> Why:
    """For a format whose objects lie in a list or object below a key."""
    inside = entries_lack(*keys)

    def why(content: object) -> str:
        if type(content) is not dict or holder not in content:
            return lacks(holder)(content)
        below = content[holder]
        below = [below] if type(below) is dict else below
        return f"{holder!r}: {inside(below)}"

    return why


def no_krt(content: object) -> str:
    """Why an object is none of K, R and t, alone or under ``cameras``."""
    if type(content) is not dict:
        return _no_object(content)
    cameras = content.get("cameras")
    if type(cameras) in (dict, list):
        missing = _missing_of_nearest(_objects_in(cameras), ("K", "R"))
        return f"'cameras': no entry has {_quoted(missing)}"
    spelled = (("K", _KRT.k), ("R", _KRT.r))
    return "lacks " + _quoted(
        name for name, spellings in spelled if not any(key in content for key in spellings)
    )


def no_projection(content: object) -> str:
    """Why content is no 3 x 4 matrix."""
    if type(content) is not dict:
        return "is not 3 x 4" if type(content) is list else _no_object(content)
    key = next((key for key in PROJECTION_KEYS if key in content), None)
    if key is None:
        return f"lacks {PROJECTION_KEYS[0]!r}"
    return f"has 'K', too, and is no {key!r} alone" if "K" in content else f"{key!r} is not 3 x 4"


def _first_entry(content: object) -> tuple[str, dict[str, Any] | None]:
    """The first object of an object of nothing but objects, and its name; None for any other."""
    if type(content) is not dict or not content or "cameras" in content:
        return "", None
    if any(type(value) is not dict for value in content.values()):
        return "", None
    name, entry = next(iter(content.items()))
    return printable(str(name), 40), entry


def _objects_in(content: object) -> list[dict[str, Any]]:
    values = content.values() if isinstance(content, dict) else content
    return [v for v in values if type(v) is dict] if isinstance(values, Iterable) else []


def _missing_of_nearest(entries: list[dict[str, Any]], keys: tuple[str, ...]) -> tuple[str, ...]:
    """What the entry that has most of the keys is still without."""
    missing = [tuple(key for key in keys if key not in entry) for entry in entries]
    return min(missing, key=len, default=keys)


def _quoted(keys: Iterable[str]) -> str:
    return ", ".join(map(repr, keys))


def _no_object(content: object) -> str:
    return f"is {kind_of(content)}, not an object"
