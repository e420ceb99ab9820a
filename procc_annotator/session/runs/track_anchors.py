"""Frames whose camera is known before a track begins: from annotations and from camera files."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from procc_annotator.camera.base import Camera
from procc_annotator.camera.projections import ElementProjections
from procc_annotator.errors import CameraError, InputError
from procc_annotator.field.model import Field
from procc_annotator.field.stadiums import field_for_frame
from procc_annotator.io.camera_files.camera_collection import CameraCollection
from procc_annotator.io.camera_files.camera_writers import OFFICIAL_SIZE
from procc_annotator.io.camera_files.cameras import fit_to_size
from procc_annotator.io.camera_files.fitted_on import annotation_digest
from procc_annotator.session.clicks.anchors import anchor_camera
from procc_annotator.session.dataset.frame_annotations import FrameAnnotations
from procc_annotator.session.dataset.frames import Frame
from procc_annotator.session.dataset.picture_sizes import picture_size


@dataclass
class TrackAnchors:
    """Cameras that are known.

    Attributes:
        cameras: by number of the frame, px of the pictures.
        clicks: of those that are fits to an annotation, its `annotation_digest`.
        remarks: on cameras, and annotated frames that give none with the reason, one line each.
        errors: annotations, pictures and cameras that cannot be used, one line each.
    """

    cameras: dict[int, Camera] = field(default_factory=dict)
    clicks: dict[int, str] = field(default_factory=dict)
    remarks: list[str] = field(default_factory=list)
    errors: list[str] = field(default_factory=list)

    def add_cameras(
        self,
        frames: Sequence[Frame],
        collection: CameraCollection,
        camera_size: tuple[int, int] | None,
    ) -> None:
        """Add the cameras of files; an anchor that is there already stays.

        Args:
            frames: by number.
            collection: of cameras.
            camera_size: (width, height) their pixels belong to, where their files do not say.
        """
        for number, frame in enumerate(frames):
            if number in self.cameras or frame.name not in collection.frames:
                continue
            try:
                loaded = collection.read(frame.name)
                size = picture_size(frame.image_path)
            except (CameraError, InputError) as error:
                self.errors.append(str(error))
                continue
            self.remarks += [n for n in loaded.notices if n not in self.remarks]
            camera, _ = fit_to_size(loaded, size, camera_size, OFFICIAL_SIZE)
            if isinstance(camera, ElementProjections):
                self.errors.append(f"{collection.display(frame.name)}: holds no camera to follow")
            else:
                self.cameras[number] = camera

    def add_annotated(self, frames: Sequence[Frame], given: FrameAnnotations, field: Field) -> None:
        """Add a fit to every annotated frame that gives a camera to rely on.

        Args:
            frames: by number.
            given: what is annotated in them.
            field: the elements, metres.
        """
        for number, frame in enumerate(frames):
            try:
                annotation = given.read(frame, field)
                if annotation is None or not annotation.annotated:
                    continue
                size = picture_size(frame.image_path)
            except InputError as error:
                self.errors.append(str(error))
                continue
            camera, why = anchor_camera(annotation, field_for_frame(field, frame.name), size=size)
            if camera is None:
                self.remarks.append(f"{frame.name}: its annotation is no anchor: {why}")
                continue
            self.cameras[number] = camera
            self.clicks[number] = annotation_digest(annotation)
