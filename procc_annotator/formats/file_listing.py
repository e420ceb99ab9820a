"""Assign annotation and camera files to frames; set other JSON files apart."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from functools import lru_cache
from posixpath import splitext
from typing import Any

import msgspec

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import AnnotationError, InputError
from procc_annotator.formats.annotations.soccernet import CAMERA_KEY, may_be_points
from procc_annotator.formats.cameras.registry import ALONE_SUFFIXES, PAIR_NAMES, suffixes_of
from procc_annotator.formats.file_source import FileSource
from procc_annotator.formats.frame_names import (
    PICTURE_SUFFIX,
    ByFrame,
    FrameTable,
    file_of_frame,
    frame_of_file,
)
from procc_annotator.formats.landmark_file import LANDMARKS_FILE
from procc_annotator.formats.strict_json import printable, strip_bom
from procc_annotator.messages import list_names

_NUMBER = re.compile(r"\d+")
_CALIBRATION = re.compile(r"calib.*\.toml", re.IGNORECASE)
# So many files with names alike but for their numbers are frames; only names unlike them are worth
# a look, so that 20,000 frames are listed without opening one.
_ALIKE = 20
_MOST_READ = 200
_SHOWN = 3
# What the files of a whole game are always called.
_SETS = frozenset({"Labels-v3.json", "Labels-GameState.json"})


def other_json_among(source: FileSource, files: Mapping[str, str]) -> tuple[str, ...]:
    """The frames of a listing with JSON of another kind.

    Only files with names unlike those of the others are read, the rarest kinds of names first.
    Files of whole sets of another program are other files where single frames lie next to them.
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
    """Return what a person should know of files that were set apart; nothing where there are
    none."""
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
    """Return whether a decoded value certainly is no annotation, neither a good nor a damaged
    one."""
    if type(content) is not dict or not content or CAMERA_KEY in content:
        return False
    return not any(_could_be_points(value) for value in content.values())


def require_lists(annotation: FrameAnnotation, path: str) -> None:
    """Refuse an annotation of a set that has no list of points but other content. `AnnotationError`
    if it is such."""
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
    """Return whether it is one file of many pictures, as COCO and game state write it, or CVAT's
    list of labels."""
    if type(content) is list:
        return bool(content) and all(type(e) is dict and not {"x", "y"} & set(e) for e in content)
    return type(content) is dict and all(
        type(content.get(key)) is list for key in ("images", "annotations")
    )


def _content(source: FileSource, file: str) -> Any:
    try:
        return msgspec.json.decode(strip_bom(source.read(file)))
    except (InputError, msgspec.DecodeError, UnicodeDecodeError, RecursionError):
        return None


CAMERA_PREFIX = "camera_"
_ENDING = ".json"
_JSON = frozenset({".json", ".jsonl"})
_PACKED = ".npz"
_STORAGE = frozenset({".yml", ".yaml", ".xml"})
_HOMOGRAPHY_ENDING = "_homography"
# What this program writes next to annotations; a frame cannot have these names.
MANIFEST_FILE = "manifest.json"
OWN_FILES = frozenset({"jac.json", "procc.json", MANIFEST_FILE, LANDMARKS_FILE})


# A folder with this name belongs to the one it lies in: its files are of that one's frames.
ANNOTATIONS_FOLDER = "annotations"
CAMERAS_FOLDER = "cameras"
UNSURE_FOLDER = "unsure"  # of cameras that are looked at before they are used


def files_of(source: FileSource, wanted: Callable[[str], bool]) -> tuple[list[str], bool]:
    """The files of a kind in a source, in natural order, and whether it is a tree of them.
    `InputError` if the source cannot be listed."""
    top = source.files()
    found = [name for name in top if wanted(_file_of(name))]
    if found or any(map(PICTURE_SUFFIX.search, top)):  # what lies below pictures is not theirs
        return found, False
    return [name for name in source.tree() if wanted(_file_of(name))], True


def frame_in_tree(file: str, own_folder: str, prefix: str = "") -> str:
    """The frame that a file of a tree belongs to; as `frame_of_file`, and a folder that only keeps
    such files apart is left out: ``game/annotations/00037.json`` is of game/00037."""
    folder, _, name = file.rpartition("/")
    above, _, last = folder.rpartition("/")
    kept = above if last == own_folder else folder
    return frame_of_file(f"{kept}/{name}" if kept else name, prefix)


class CameraFiles(ByFrame[str]):
    """Frame name -> camera file; ``notices`` are remarks a person should see."""

    notices: tuple[str, ...] = ()


def may_be_annotation(file_name: str) -> bool:
    """Return whether a JSON file of this name can be a frame's annotation, and so whether a picture
    of this stem can be a frame: not cameras, nor what this program writes itself."""
    return not file_name.startswith(CAMERA_PREFIX) and file_name not in OWN_FILES


class AnnotationFiles(FrameTable[str]):
    """Frame name -> annotation file; ``notices`` are remarks a person should see, ``in_tree`` says
    whether the frames are called by their paths."""

    notices: tuple[str, ...] = ()
    in_tree: bool = False

    def is_part_of(self, other: ByFrame[str]) -> bool:
        """Return whether all lie in an only folder that the tree of others has."""
        called = (name.startswith(self.only_folder) for name in other)
        return bool(self.only_folder) and any(called)

    def by_path(self) -> AnnotationFiles:
        """The same, frames called with the only folder that they lie in."""
        found = AnnotationFiles((self.only_folder + name, file) for name, file in self.items())
        found.notices, found.in_tree = self.notices, True
        return found


def qualify_by_folder(lists: Sequence[AnnotationFiles]) -> list[AnnotationFiles]:
    """The same lists of several annotators, in each of which frames are called by their paths where
    they lie in an only folder that the tree of another has."""
    return [own.by_path() if any(map(own.is_part_of, lists)) else own for own in lists]


def list_annotations(source: FileSource) -> AnnotationFiles:
    """Frame name -> annotation file, in natural order; camera files next to them do not count.

    Nor does JSON of another kind (`procc_annotator.formats.file_listing`): it is named in a notice.

    Raises:
        InputError: two files claim to be the annotation of the same frame.
    """
    found = list_frame_files(source)
    strays = other_json_among(source, found)
    for frame in strays:
        del found[frame]
    if strays and not found and not found.in_tree:  # a table of the matches at the top of a tree
        deeper = _frame_files(source, source.tree(), in_tree=True)
        for frame in other_json_among(source, deeper):
            deeper.pop(frame)
        found = deeper or found
    found.notices = (*source.notices, *other_json_notices(strays))
    return found


def list_frame_files(source: FileSource) -> AnnotationFiles:
    """The same, whatever the JSON holds: annotations of other formats than SoccerNet's, too."""
    return _frame_files(source, *files_of(source, _is_frame_file))


def _frame_files(source: FileSource, names: Sequence[str], in_tree: bool) -> AnnotationFiles:
    found = AnnotationFiles(_unique_by_frame(_names_in_tree(tuple(names), in_tree), source))
    found.in_tree = in_tree
    found.only_folder = "" if in_tree else _only_folder(names)
    return found


@lru_cache(maxsize=4)
def _names_in_tree(names: tuple[str, ...], in_tree: bool) -> tuple[tuple[str, str], ...]:
    """The frames of files, and these; a command lists the same folders several times."""
    return tuple(
        (frame_in_tree(name, ANNOTATIONS_FOLDER) if in_tree else splitext(file)[0], name)
        for name in names
        if _is_frame_file(file := _file_of(name))
    )


def _is_frame_file(name: str) -> bool:
    is_json = len(name) > len(_ENDING) and name.lower().endswith(_ENDING)
    return is_json and may_be_annotation(name)


def list_cameras(source: FileSource, fmt: str = "auto") -> CameraFiles:
    """Frame name -> camera file, in natural order.

    Plain ``00037.json`` are cameras too, unless there are ``camera_*.json`` or files of another
    kind for the same frames: then they are annotations. Of a frame's JSON camera and another file
    (a homography) the former is taken, with a notice.

    Raises:
        InputError: two files of one kind claim to be the camera of the same frame.
    """
    names, in_tree = _camera_names(source, fmt)
    frame_of = _frame_of_camera_in_tree if in_tree else camera_frame
    called = [(frame_of(name), name) for name in names]
    json = [one for one in called if splitext(one[1])[1].lower() in _JSON]
    named = [one for one in json if _file_of(one[1]).startswith(CAMERA_PREFIX)]
    plain = [one for one in json if not _file_of(one[1]).startswith(CAMERA_PREFIX)]
    others = _unique_by_frame((c for c in called if splitext(c[1])[1].lower() not in _JSON), source)
    passed_over: list[str] = []
    if named or any(frame in others for frame, _ in plain):
        if named:
            frames = {frame for frame, _ in named} | others.keys()
            passed_over = [name for frame, name in plain if frame not in frames]
        plain = []
    cameras = _unique_by_frame((*named, *plain), source)
    chosen = others | cameras
    # Both lists are in natural order; one pass over all files restores it for their union.
    order = dict(called)
    found = CameraFiles((frame, chosen[frame]) for frame in order if frame in chosen)
    found.only_folder = "" if in_tree else _only_folder(names)
    if passed_over:
        count = len(passed_over)
        found.notices = (
            f"{count} {'file' if count == 1 else 'files'} like {_file_of(passed_over[0])} taken for"
            f" {'an annotation, not a camera' if count == 1 else 'annotations, not cameras'},"
            f" because of camera_*.json next to {'it' if count == 1 else 'them'}",
        )
    if found and not in_tree and (below := _cameras_below(source, {*found.values()})):
        left_out = f"{list_names(below, 'file')} in folders below left out: keep all at one depth"
        found.notices = (*found.notices, left_out)
    both = len(others.keys() & cameras.keys())
    if both:
        found.notices = (
            *found.notices,
            f"{both} {'frame has' if both == 1 else 'frames have'} a JSON camera and"
            f" {_kind(others)}; the JSON camera is taken"
            " (choose a camera format to have the other)",
        )
    return found


def _camera_names(source: FileSource, fmt: str) -> tuple[list[str], bool]:
    """Files of a format that may hold cameras, and whether they are those of a tree."""
    suffixes = suffixes_of(fmt)

    def wanted(name: str) -> bool:
        suffix = splitext(name)[1].lower()
        other = suffix == ".bin" and name not in PAIR_NAMES  # weights, points: of anything
        return suffix in suffixes and name not in OWN_FILES and not other

    names, in_tree = files_of(source, wanted)
    if names and all(name.endswith(_PACKED) for name in names):  # of a season, at any depth
        names = [name for name in source.tree() if name.endswith(_PACKED)]
        in_tree = in_tree or any("/" in name for name in names)
    names = [name for name in names if f"/{UNSURE_FOLDER}/" not in f"/{name}"]
    if not names and fmt == "auto":
        alone = [name for name in source.files() if splitext(name)[1].lower() in ALONE_SUFFIXES]
        names, in_tree = (alone, False) if len(alone) == 1 else (names, in_tree)
        if not alone:  # Calib.toml in the folder of each match
            names = [n for n in source.tree() if _CALIBRATION.fullmatch(_file_of(n))]
            in_tree = True
    texts = {name for name in names if name.endswith(".txt")}
    return [n for n in names if not (n.endswith(".bin") and f"{n[:-4]}.txt" in texts)], in_tree


def _cameras_below(source: FileSource, names: Collection[str]) -> list[str]:
    """Files like those of a folder of cameras that lie deeper, unless they are next to pictures or
    may be annotations."""
    try:
        files = source.tree()
    except InputError:  # a disk
        return []
    if any(map(PICTURE_SUFFIX.search, files)):
        return []
    kinds = {splitext(name)[1] for name in names}
    below = [n for n in files if "/" in n and n not in names and splitext(n)[1] in kinds]
    apart = ANNOTATIONS_FOLDER, UNSURE_FOLDER
    return [name for name in below if not any(f"{own}/" in name for own in apart)]


def camera_name(frame: str) -> str:
    """The file of a frame's camera below a folder of cameras."""
    return file_of_frame(frame, ".json", CAMERA_PREFIX)


def camera_names(frame: str) -> tuple[str, ...]:
    """The same with those of fits that such a file does not hold."""
    return camera_name(frame), file_of_frame(frame, ".npy"), file_of_frame(frame, ".yml")


def _only_folder(names: Sequence[str]) -> str:
    folder, slash, _ = names[0].rpartition("/") if names else ("", "", "")
    return folder + slash


def camera_frame(file_name: str) -> str:
    """The frame a camera file belongs to: its stem without ``camera_`` and ``_homography``."""
    stem, _ = splitext(_file_of(file_name))
    return stem.removeprefix(CAMERA_PREFIX).removesuffix(_HOMOGRAPHY_ENDING)


def _frame_of_camera_in_tree(name: str) -> str:
    frame = frame_in_tree(name, CAMERAS_FOLDER, CAMERA_PREFIX)
    return frame.removesuffix(_HOMOGRAPHY_ENDING)


def _kind(files: dict[str, str]) -> str:
    storage = any(splitext(name)[1].lower() in _STORAGE for name in files.values())
    return "another camera file" if storage else "a homography"


def _file_of(name: str) -> str:
    return name.rpartition("/")[2]


def _unique_by_frame(called: Iterable[tuple[str, str]], source: FileSource) -> dict[str, str]:
    """Frame -> file. Raises InputError for a second file of one frame."""
    found: dict[str, str] = {}
    for frame, name in called:
        if frame in found:  # letters composed otherwise are another file's business
            raise InputError(
                source.display(name),
                f"is the second file for frame {frame!r}, after {found[frame]}",
                advice="keep one of them, or choose a camera format",
            )
        found[frame] = name
    return found
