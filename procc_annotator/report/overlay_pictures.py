"""Render overlay pictures of a dataset with a given painter."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.frames import Frame
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import ImageError, InputError, UsageError
from procc_annotator.formats.atomic import make_folder, write_atomic
from procc_annotator.formats.frame_names import file_of_frame
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.projection import project_markings
from procc_annotator.metrics.score import display_score
from procc_annotator.metrics.setup import EvaluationSetup
from procc_annotator.report.overlay_scene import Paint, Scene


@dataclass
class Rendered:
    """Pictures written, problems (one line each), and frames without anything to draw."""

    folder: Path
    pictures: list[Path] = field(default_factory=list)
    problems: list[str] = field(default_factory=list)
    notices: Counter[str] = field(default_factory=Counter)
    bare: list[str] = field(default_factory=list)


def render_pictures(
    workspace: Workspace,
    out: Path,
    paint: Paint,
    *,
    setup: EvaluationSetup,
    threshold: float,
    cameras: CameraSet | None = None,
    suffix: str = ".png",
    painted_width: bool = False,
) -> Iterator[Rendered]:
    """Write one overlay picture a frame, yielding what is done so far after each.

    Args:
        out: folder of the pictures, made if needed.
        threshold: px, decides the colours.
        suffix: the encoding that ``paint`` produces.
        painted_width: whether the borders of painted lines are drawn, too.

    Raises:
        SaveError: a picture cannot be written.
        UsageError: the pictures would replace those of the dataset.
    """
    if any(folder.resolve() == out.resolve() for folder in workspace.own_folders):
        raise UsageError(f"{out}: this is the dataset itself, choose another folder")
    make_folder(out)
    rendered = Rendered(out)
    for index, frame in enumerate(workspace.frames):
        scene = _scene(
            workspace, index, frame, setup, threshold, cameras, rendered, painted=painted_width
        )
        if scene.measurement is None and not scene.annotation.annotated:
            rendered.bare.append(frame.name)
        try:
            data = paint(scene)
        except ImageError as error:
            rendered.problems.append(str(error))
        else:
            target = out / file_of_frame(frame.name, suffix)
            make_folder(target.parent)
            write_atomic(target, data)
            rendered.pictures.append(target)
        yield rendered


def _scene(
    workspace: Workspace,
    index: int,
    frame: Frame,
    setup: EvaluationSetup,
    threshold: float,
    cameras: CameraSet | None,
    rendered: Rendered,
    *,
    painted: bool,
) -> Scene:
    annotation, measurement, paint, annotated = FrameAnnotation(), None, None, False
    setup = setup.of_frame(frame.name)
    try:
        annotation = workspace.read(index)
        annotated = bool(annotation.polylines or annotation.extra) or workspace.has_file(index)
        loaded = None if cameras is None else cameras.camera(frame.name, setup.size)
        if loaded is not None:
            measurement = measure(annotation, loaded.camera, setup)
            paint = project_markings(loaded.camera, setup) if painted else None
            rendered.notices.update([loaded.notice] if loaded.notice else [])
    except InputError as error:  # the picture is drawn all the same, with what could be read
        rendered.problems.append(str(error))
    judged = None
    if measurement is not None and annotated:  # else it belongs to no figure
        judged = display_score(measurement, threshold)
    source = "" if cameras is None else cameras.name
    return Scene(
        frame.image_path, annotation, setup, measurement, judged, frame.name, source, paint
    )
