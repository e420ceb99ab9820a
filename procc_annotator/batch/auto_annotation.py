"""Annotate pictures from given cameras and visible line markings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.assist.ghost_points import accept_all, find_points
from procc_annotator.batch.set_run import ReopenableHandle, SetRun, reopenable_cameras
from procc_annotator.calibration.prediction.ghosts import find_ghosts
from procc_annotator.calibration.result import external_camera_fit
from procc_annotator.camera.models import HomographyCamera, PinholeCamera
from procc_annotator.dataset.frames import Frame
from procc_annotator.errors import InputError
from procc_annotator.field.load import field_for_frame
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.loaded_camera import fit_to_size
from procc_annotator.formats.cameras.writers import OFFICIAL_SIZE
from procc_annotator.image.decoding import decode_bgra
from procc_annotator.image.pixels import PixelArray
from procc_annotator.metrics.camera_origin import with_origin

_NOTHING = FrameAnnotation(())


@dataclass(frozen=True, slots=True)
class AnnotatedPicture:
    """Result for one picture.

    Attributes:
        name: of the frame.
        annotation: the elements whose paint was seen; none without any.
        unseen: elements that the camera shows and the picture does not.
        error: why there is nothing: picture or camera cannot be used.
        notices: remarks on the camera.
    """

    name: str
    annotation: FrameAnnotation = _NOTHING
    unseen: int = 0
    error: str = ""
    notices: tuple[str, ...] = ()


@dataclass(frozen=True)
class AnnotatePictures:
    """Annotates chunks of frames.

    Attributes:
        cameras: where those of the frames are.
        field: the elements, metres.
        camera_size: (width, height) the cameras' pixels belong to; None goes by their files, and
            takes those that say nothing for the official evaluation's size.
    """

    cameras: ReopenableHandle[CameraCollection]
    field: Field
    camera_size: tuple[int, int] | None = None

    def __call__(self, chunk: Sequence[Frame]) -> tuple[list[AnnotatedPicture], None]:
        return [self._annotate(frame) for frame in chunk], None

    def _annotate(self, frame: Frame) -> AnnotatedPicture:
        try:
            loaded = self.cameras.opened.read(frame.name, self.field)
            picture = decode_bgra(frame.image_path)
        except InputError as error:
            return AnnotatedPicture(frame.name, error=str(error))
        size = picture.shape[1], picture.shape[0]
        camera, _ = fit_to_size(loaded, size, self.camera_size, OFFICIAL_SIZE)
        if not isinstance(camera, PinholeCamera | HomographyCamera):
            shown = self.cameras.opened.display(frame.name)
            why = f"{shown}: a camera of the kind {loaded.model} is of no use here"
            return AnnotatedPicture(
                frame.name, error=f"{why} (convert it to a pinhole or a homography)"
            )
        found = annotate_picture(frame.name, picture, camera, self.field)
        return replace(found, notices=loaded.notices)

    def close(self) -> None:
        """Close what a worker opened."""
        self.cameras.close()


def annotate_picture(
    name: str, picture: PixelArray, camera: PinholeCamera | HomographyCamera, field: Field
) -> AnnotatedPicture:
    """The elements of a picture, (H, W, 4) BGRA, whose paint is seen where a camera, px of the
    picture, shows them."""
    size = picture.shape[1], picture.shape[0]
    shown = field_for_frame(field, name)
    ghosts = find_ghosts(_NOTHING, shown, external_camera_fit(camera, size))
    found = [find_points(ghost, picture, shown, size) for ghost in ghosts]
    accepted = accept_all(_NOTHING, found)
    marked = with_origin(accepted.annotation, camera, size)
    return AnnotatedPicture(name, marked, len(accepted.left))


class AnnotationRun(SetRun[Frame, AnnotatedPicture, None]):
    """One pass over pictures that have a camera; iterate it once."""

    chunk = 1  # a second's work, and what is found is written as it comes
    task: AnnotatePictures

    def __init__(
        self,
        frames: Sequence[Frame],
        cameras: CameraCollection,
        field: Field,
        camera_size: tuple[int, int] | None = None,
    ) -> None:
        super().__init__(frames, AnnotatePictures(reopenable_cameras(cameras), field, camera_size))
