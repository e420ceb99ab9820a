"""Other JSON among annotations: a table of the match, a list of pictures, another tool's settings.

An annotation is an object whose values are lists of points. An object without any such list is
none, unless it is empty: that is a frame in which nothing is annotated.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping
from typing import Any

import msgspec

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import AnnotationError, InputError
from procc_annotator.io.annotation_files.soccernet_annotation import CAMERA_KEY, may_be_points
from procc_annotator.io.json_text import printable, strip_bom
from procc_annotator.io.source import FileSource

_NUMBER = re.compile(r"\d+")
# So many files with names alike but for their numbers are frames; only names unlike them are worth
# a look, so that 20,000 frames are listed without opening one.
_ALIKE = 20
_MOST_READ = 200
_SHOWN = 3
# What the files of a whole game are always called.
_SETS = frozenset({"Labels-v3.json", "Labels-GameState.json"})


def other_json_among(source: FileSource, files: Mapping[str, str]) -> tuple[str, ...]:
    """The frames of a listing whose files are JSON of another kind.

    Only files whose names are unlike those of the others are read, the rarest kinds of names first.
    Files of whole sets of another program are other files where single frames lie beside them.

    Args:
        source: where the files are.
        files: frame name -> file.
    """
    kinds = {frame: _NUMBER.sub("0", frame) for frame in files}
    alike = Counter(kinds.values())
    odd = [frame for frame in files if alike[kinds[frame]] <= _ALIKE]
    if len(odd) > _MOST_READ:
        odd = sorted(odd, key=lambda frame: alike[kinds[frame]])[:_MOST_READ]
    sets = {frame for frame, file in files.items() if file.rpartition("/")[2] in _SETS}
    found = set[str]()
    for frame in odd:
        content = _content(source, files[frame])
        if is_other_json(content):
            found.add(frame)
        elif _is_set(content):
            sets.add(frame)
    if len(found | sets) < len(files):
        found |= sets
    return tuple(frame for frame in files if frame in found)


def other_json_notices(names: tuple[str, ...]) -> tuple[str, ...]:
    """What a person should know of files that were set apart; nothing where there are none."""
    if not names:
        return ()
    shown = ", ".join(f"{printable(name)}.json" for name in names[:_SHOWN])
    if len(names) == 1:
        return (f"{shown} holds no list of points: taken for another file, not for an annotation",)
    more = ", ..." if len(names) > _SHOWN else ""
    return (
        f"{len(names)} files hold no list of points: taken for other files, not for annotations"
        f" ({shown}{more})",
    )


def is_other_json(content: Any) -> bool:
    """Whether a decoded value certainly is no annotation, neither a good nor a damaged one."""
    if type(content) is not dict or not content or CAMERA_KEY in content:
        return False
    return not any(_could_be_points(value) for value in content.values())


def require_lists(annotation: FrameAnnotation, path: str) -> None:
    """Refuse an annotation of a set that has no list of points but other content.

    Raises:
        AnnotationError: it is such.
    """
    if annotation.extra and not annotation.polylines:
        raise AnnotationError(
            path,
            "holds no list of points, expected an object of class names",
            advice="is this an annotation?",
        )


def _could_be_points(value: Any) -> bool:
    # null and a single point without its list are what careless writers make of a class.
    return (
        value is None or may_be_points(value) or (type(value) is dict and {"x", "y"} <= set(value))
    )


def _is_set(content: Any) -> bool:
    """Whether it is one file of many pictures, as COCO and game state write it, or CVAT's list of
    labels."""
    if type(content) is list:
        return bool(content) and all(type(e) is dict and not {"x", "y"} & set(e) for e in content)
    return type(content) is dict and all(
        type(content.get(key)) is list for key in ("images", "annotations")
    )


def _content(source: FileSource, file: str) -> Any:
    """What JSON holds; None where it is damaged: whoever reads the set says so."""
    try:
        return msgspec.json.decode(strip_bom(source.read(file)))
    except (InputError, msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return None
