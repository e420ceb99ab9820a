"""A camera as read from a file, several cameras of one file, and plausibility remarks."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import PurePosixPath
from typing import Any

import numpy as np

from procc_annotator.arrays import FloatArray
from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.camera.base import CameraOrProjections, ElementProjections, scaled_camera
from procc_annotator.camera.models import (
    FisheyeCamera,
    HomographyCamera,
    MatrixCamera,
    PinholeCamera,
)
from procc_annotator.errors import CameraError
from procc_annotator.field.load import field_titles, is_builtin_field
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.fit_record import LeftOutResult
from procc_annotator.formats.frame_names import (
    PICTURE_FOLDERS,
    PICTURE_SUFFIX,
    picture_folders_of,
    posix_path,
)
from procc_annotator.formats.strict_json import printable


@dataclass(frozen=True, eq=False)
class LoadedCamera:
    """A camera as read.

    Attributes:
        camera: expressed in pixels of ``size``.
        model: ``pinhole``, ``fisheye``, ``homography``, ``projections``, or what a plug-in
            calls its own; for people.
        size: (width, height) of the picture the pixels refer to; None when the file does not say,
            which for SoccerNet cameras means the evaluation size. Projections are given as shares
            of the picture, whatever its size; their ``size`` is the one that makes these pixels.
        extra: keys of the file that are not part of the model, written back on saving.
        notices: remarks a person should see.
        assumed_field: name of the field that the world coordinates are of, where the format alone
            says so and no one named it; empty otherwise.
        content: all of the file's keys and values, so that saving spells unchanged numbers alike.
        fitted_on: `annotation_digest` of the annotation it was fitted to, where that is reported.
        held_out: how well the elements it was fitted to are shown by the cameras of the others,
            where that is reported.
        size_is_usual: whether no file says ``size``, which is the usual one of the format.
    """

    camera: CameraOrProjections
    model: str
    size: tuple[int, int] | None = None
    extra: Mapping[str, Any] = field(default_factory=dict, repr=False)
    notices: tuple[str, ...] = ()
    content: Mapping[str, Any] = field(default_factory=dict, repr=False)
    fitted_on: str | None = None
    held_out: LeftOutResult | None = None
    assumed_field: str = ""
    size_is_usual: bool = False

    def size_where(self, stated: tuple[int, int] | None) -> tuple[int, int] | None:
        """(width, height) of the picture the pixels refer to; None where nothing says it. A file
        knows better than what the user states, what is usual for its format does not."""
        return (stated or self.size) if self.size_is_usual else (self.size or stated)

    def ground_from_px(self, points_px: FloatArray) -> FloatArray:
        """(N, 2) px of ``size`` -> (N, 2) metres on the ground; NaN for pixels that do not show
        it."""
        return ground_from_px(self.camera, points_px)


def with_notices(loaded: LoadedCamera, notices: Iterable[str]) -> LoadedCamera:
    """The same with more remarks for a person."""
    return replace(loaded, notices=(*loaded.notices, *notices))


# Decoded content of one camera, the file, the place in it -> the camera.
ReadRecord = Callable[[Any, str, str], LoadedCamera]


@dataclass(frozen=True)
class CameraRecord:
    """One camera of a file, decoded but not yet examined; place is where it stands."""

    place: str
    content: Any


@dataclass(frozen=True, eq=False)
class CameraRecords:
    """The cameras of one file, by frame name; a damaged one fails when it is read.

    Attributes:
        path: the file, for messages.
        entries: frame name -> what the file holds for it; more than one entry cannot be read.
        notices: remarks on parts of the file that belong to no frame.
        only_folder: that all pictures lie in by their names, while frames are called without it.
        passed_over: damaged records whose frames are unknown.
        shots: frame -> its shot, in their order, where the file says so; also of frames without a
            camera.
    """

    path: str
    entries: Mapping[str, tuple[CameraRecord, ...]]
    read_record: ReadRecord
    notices: tuple[str, ...] = field(default=())
    only_folder: str = ""
    passed_over: Sequence[CameraError] = ()
    shots: Mapping[str, str] = field(default_factory=dict)

    @classmethod
    def of(
        cls,
        path: str,
        found: Iterable[tuple[str, CameraRecord]],
        read_record: ReadRecord,
        notices: tuple[str, ...] = (),
        expected: str = "",
        passed_over: Sequence[CameraError] = (),
    ) -> CameraRecords:
        """From (picture's name, record) pairs in file order; frames are called by the last parts of
        these names, or by their paths where they lie in several folders. `CameraError` if there is
        none, and something was expected."""
        pairs = list(found)
        if expected and not pairs:
            raise CameraError(path, f"holds no camera, expected {expected}")
        folders = picture_folders_of(posix_path(name) for name, _ in pairs)
        by_path = len(folders) > 1
        only = next(iter(folders - {*PICTURE_FOLDERS}), "") if len(folders) == 1 else ""
        entries: dict[str, tuple[CameraRecord, ...]] = {}
        for name, record in pairs:
            frame = frame_of_image(name, by_path)
            entries[frame] = (*entries.get(frame, ()), record)
        return cls(path, entries, read_record, notices, only, passed_over)

    def below(self, folder: str) -> CameraRecords:
        """The same cameras of frames in a folder of a tree."""
        if not folder:
            return self
        entries = {f"{folder}/{name}": found for name, found in self.entries.items()}
        shots = {f"{folder}/{name}": f"{folder}/{shot}" for name, shot in self.shots.items()}
        return replace(self, entries=entries, only_folder="", shots=shots)

    def read(self, frame: str) -> LoadedCamera:
        """The camera of a frame. `CameraError` if it is damaged, or the frame has two."""
        records = self.entries[frame]
        if len(records) > 1:
            places = " and ".join(record.place for record in records[:3])
            raise CameraError(
                self.path,
                f"holds {len(records)} cameras for frame {printable(frame)!r}",
                place=places,
                advice="keep one of them; pictures of several folders are distinguished by paths"
                " below the dataset",
            )
        return self.read_record(records[0].content, self.path, records[0].place)

    def place(self, frame: str) -> str:
        """Return where in the file a frame's camera stands."""
        return self.entries[frame][0].place


@dataclass(frozen=True)
class CameraFormat:
    """One file format of cameras.

    Attributes:
        name: value of ``--camera-format``.
        suffixes: of the files that may hold it, lower case.
        default_for: the suffixes ``auto`` reads with it.
        read: ``read(data, path=...)``, the camera of a file that holds one; None in the table for
            a format whose content is decoded first, for which `registry` has the reader.
        records: ``records(data, path=...)``, the cameras of a file that holds several, or None for
            a file that holds one; None for a format without such files.
        always_many: whether its files always hold several.
        recognises: whether decoded content is of this format; None where content does not tell.
        one: reads the camera of decoded content; None for a format of files with many.
        many: the cameras of decoded content that holds several; None where it holds one.
        pairs: names of the two files, poses and lenses, of a format that keeps these apart.
        read_pair: the cameras of the bytes of both, with their names for messages.
        keys: by which content is recognised, in messages and in the documentation.
        world: units and axes of the file's world, and what is made of them.
        example: names of files, for the documentation.
    """

    name: str
    title: str
    suffixes: tuple[str, ...]
    default_for: tuple[str, ...]
    read: Callable[..., LoadedCamera] | None
    records: Callable[..., CameraRecords | None] | None = None
    always_many: bool = False
    recognises: Callable[[Any], bool] | None = None
    one: ReadRecord | None = None
    many: Callable[[Any, str], CameraRecords | None] | None = None
    pairs: tuple[tuple[str, str], ...] = ()
    read_pair: Callable[[bytes, bytes, str, str], CameraRecords] | None = None
    keys: str = ""
    world: str = ""
    example: str = ""


def frame_of_image(name: str, by_path: bool = False) -> str:
    """The frame a picture's name stands for: without the suffix of a picture, and without folders
    unless it is called by its path."""
    frame = PICTURE_SUFFIX.sub("", posix_path(name))
    return str(PurePosixPath(frame)) if by_path else PurePosixPath(frame).name


NAME_THE_FORMAT = "choose its camera format: world takes metres from the field's centre"


def field_mismatch(assumed: str, field: Field) -> str:
    """Why a camera cannot be taken for one of a field; empty if it can.

    A field of the user's own may be any, soccer too.
    """
    if not assumed or field.name == assumed:
        return ""
    if field.source is not None and not is_builtin_field(field.source):
        return ""
    titles = field_titles()
    return (
        f"nothing says which ground it is of, so that it would be taken for a"
        f" {titles[assumed].lower()} field's, and this is {titles.get(field.name, field.title)}"
    )


_FAR_M = 1000.0
_MIRRORED = (
    "mirrors the ground, as if seen from below: expected y towards the main camera (negate its y,"
    " unless the picture is mirrored)"
)


def with_plausibility_remark(loaded: LoadedCamera) -> LoadedCamera:
    """The same with a remark where no camera stands: below the ground, or a kilometre away; a
    homography shows the former by its orientation.

    Structure from motion finds a world up to its place, turn and size; only who laid it upon the
    field can know whether that was done.
    """
    camera = loaded.camera
    if isinstance(camera, HomographyCamera):
        # From above, x, y and the picture turn the same way round; from below they are mirrored.
        mirrored = np.linalg.det(camera.image_from_world) < 0
        return with_notices(loaded, (_MIRRORED,)) if mirrored else loaded
    if isinstance(camera, MatrixCamera):
        matrix = camera.image_from_world
        x, y, z = -np.linalg.solve(matrix[:, :3], matrix[:, 3])
    elif isinstance(camera, PinholeCamera | FisheyeCamera):
        x, y, z = camera.position_world
    else:
        return loaded
    doubt = ""
    if z > 0:
        doubt = f"stands {z:.3g} m below the ground: expected metres with z down"
        turn = getattr(camera, "rotation_cam_from_world", None)
        if turn is not None and turn[1, 2] < 0:  # the picture's lower edge is up there
            doubt += ", and its z is up: negate y and z of its world"
    elif max(abs(x), abs(y), abs(z)) > _FAR_M:
        doubt = "stands more than a kilometre from the field's centre: expected metres"
    if not doubt:
        return loaded
    told = f"{doubt} (is the world of the file the field's?)"
    return with_notices(loaded, (told,))


_FAR = 0.2  # of the picture's size
_EXACT = 1e-6  # px


def fit_to_size(
    loaded: LoadedCamera,
    size: tuple[int, int],
    camera_size: tuple[int, int] | None = None,
    unsized: tuple[int, int] | None = None,
) -> tuple[CameraOrProjections, str | None]:
    """The camera in pixels of the evaluation size, and a remark when it had to be scaled.

    Args:
        size: (width, height) of the evaluation, px.
        camera_size: what the user says the camera's pixels belong to, where its file does not say.
        unsized: what they belong to where nothing says it; None for ``size``.
    """
    camera = loaded.camera
    if isinstance(camera, ElementProjections):
        # Shares of the picture, which belong to any size: nothing to remark.
        return scaled_camera(camera, loaded.size or size, size), None
    told = loaded.size_where(camera_size)
    own = told or unsized or size
    said = f"{own[0]}x{own[1]}"
    if loaded.size not in (None, own):
        said += f" (usual: {loaded.size[0]}x{loaded.size[1]})"
    if own != size:
        return scaled_camera(camera, own, size), f"scaled from {said} to {size[0]}x{size[1]}"
    if told is None:
        return camera, _doubt(camera, size)
    return camera, None if loaded.size in (None, own) else f"taken for {said}"


def _doubt(camera: CameraOrProjections, size: tuple[int, int]) -> str | None:
    """A remark when a camera that names no picture size hardly belongs to this one.

    It is still taken as it is, as the official evaluation does: guessing would fail silently.
    """
    if not isinstance(camera, PinholeCamera | FisheyeCamera):
        return None
    x, y = camera.principal_point_px
    width, height = size
    off_x, off_y = abs(x - width / 2), abs(y - height / 2)
    if off_x > _FAR * width or off_y > _FAR * height:
        place = f"far from the middle of {width}x{height}"
    elif (own := _exact_middle_of(x, y)) is not None and max(off_x, off_y) > 1:
        place = f"in the exact middle of {own[0]}x{own[1]}, not of {width}x{height}"
    else:
        return None
    return (
        f"principal point {place}: if the camera belongs to another picture size, name it"
        " (camera size)"
    )


def _exact_middle_of(x: float, y: float) -> tuple[int, int] | None:
    """The (width, height) px a principal point was put in the middle of, be that (width - 1) / 2 or
    width / 2; None for one that was fitted."""
    twice = round(2 * x), round(2 * y)
    if min(twice) < 2 or any(abs(2 * v - t) > _EXACT for v, t in zip((x, y), twice, strict=True)):
        return None
    return twice[0] + twice[0] % 2, twice[1] + twice[1] % 2
