"""Draw the sample datasets: pictures, annotations and camera sets, the same on every run.

python sample_data/make_sample_data.py            draws everything beside this file
python sample_data/make_sample_data.py --golden   writes the scores the tests hold it to
"""

from __future__ import annotations

import argparse
import json
import sys
from dataclasses import replace
from pathlib import Path

import av
import cv2
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from drawing.camera_sets import camera_files  # noqa: E402
from drawing.clicks import annotation_of  # noqa: E402
from drawing.scenery import draw_scenery  # noqa: E402
from drawing.solids import draw_things  # noqa: E402
from drawing.sport import Sport  # noqa: E402
from drawing.sports import SPORTS  # noqa: E402
from drawing.views import EVALUATION_SIZE, PICTURE_SIZE, View  # noqa: E402
from procc_annotator.camera.models import PinholeCamera  # noqa: E402
from procc_annotator.field.load import default_field_name  # noqa: E402
from procc_annotator.formats.annotations.soccernet import write_annotation  # noqa: E402

SUPERSAMPLING = 2
VIDEO_FRAMES = 60
SECOND_ANNOTATOR = "second_annotator"  # of soccer's first frames
SECOND_FRAMES = 6
OTHER_NAMES = {  # as another program might call them
    "Big rect. left main": "left penalty area front",
    "Big rect. left top": "left penalty area far side",
    "Big rect. right main": "right penalty area front",
    "Big rect. right top": "right penalty area far side",
    "Side line top": "far touchline",
    "Circle left": "left penalty arc",
    "Circle right": "right penalty arc",
    "Goal right crossbar": "right crossbar",
}
TRACKS = """\
frame,id,x,y,w,h
00002,7,610,310,22,60
00002,9,800,280,20,55
00003,7,500,260,22,58
00003,9,930,330,24,64
"""  # boxes of people, px of the pictures
GOLDEN = HERE.parent / "tests" / "unit" / "golden_sample_scores.json"


def draw(sport: Sport, view: View) -> np.ndarray:
    """A frame as a broadcast shows it: (720, 1280, 3) BGR uint8."""
    fine_size = (PICTURE_SIZE[0] * SUPERSAMPLING, PICTURE_SIZE[1] * SUPERSAMPLING)
    camera = _finer(view.picture_camera)
    seed = int(view.name)
    fine = np.clip(draw_scenery(sport.arena, camera, fine_size, seed), 0, 255).astype(np.uint8)
    draw_things(fine, camera, sport.things(camera, seed))
    picture = cv2.resize(fine, PICTURE_SIZE, interpolation=cv2.INTER_AREA)
    picture = cv2.GaussianBlur(picture, (0, 0), 0.7)
    noise = np.random.default_rng(seed).normal(0, sport.noise, picture.shape)
    return np.clip(picture + noise, 0, 255).astype(np.uint8)


def _finer(camera: PinholeCamera) -> PinholeCamera:
    # A fine pixel X covers the picture's x = (X + 0.5) / 2 - 0.5: focal lengths double exactly,
    # the principal point moves with the pixel centres.
    fx, fy = camera.focal_px
    cx, cy = camera.principal_point_px
    return replace(
        camera,
        focal_px=(fx * SUPERSAMPLING, fy * SUPERSAMPLING),
        principal_point_px=(
            (cx + 0.5) * SUPERSAMPLING - 0.5,
            (cy + 0.5) * SUPERSAMPLING - 0.5,
        ),
    )


def write(sport: Sport, view: View, folder: Path) -> None:
    """Write a frame's picture, annotation and cameras below a dataset's folder."""
    jpeg = [cv2.IMWRITE_JPEG_QUALITY, sport.jpeg_quality]
    _, encoded = cv2.imencode(".jpg", draw(sport, view), jpeg)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / f"{view.name}.jpg").write_bytes(encoded.tobytes())
    write_data(sport, view, folder)


def write_field(sport: Sport, folder: Path) -> None:
    """Write the description of the field a dataset shows; the default field needs none."""
    folder.mkdir(parents=True, exist_ok=True)
    if sport.field_name != default_field_name():
        assert sport.field.source is not None
        (folder / "field.toml").write_bytes(sport.field.source.read_bytes())


def write_data(sport: Sport, view: View, folder: Path) -> None:
    """Write a frame's annotation and cameras, without its picture."""
    folder.mkdir(parents=True, exist_ok=True)
    if view.annotated:
        content = write_annotation(annotation_of(sport, view))
        (folder / f"{view.name}.json").write_bytes(content)
    for name, content in camera_files(sport, view).items():
        path = folder / "cameras" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def write_second(folder: Path) -> None:
    """Write what another person would have clicked, other names of labels, and a table of boxes."""
    sport = SPORTS["soccer"]
    (folder / SECOND_ANNOTATOR).mkdir(parents=True, exist_ok=True)
    for view in sport.views[:SECOND_FRAMES]:
        if view.annotated:
            content = write_annotation(annotation_of(sport, view, annotator=2))
            (folder / SECOND_ANNOTATOR / f"{view.name}.json").write_bytes(content)
    (folder / "other_names").mkdir(exist_ok=True)
    for name in ("00002", "00003"):
        content = (folder / f"{name}.json").read_text(encoding="utf-8")
        for own, other in OTHER_NAMES.items():
            content = content.replace(f'"{own}"', f'"{other}"')
        (folder / "other_names" / f"{name}.json").write_text(content, encoding="utf-8")
    (folder / "tracks.csv").write_text(TRACKS, encoding="utf-8")


def scores(sport: Sport, sample: Path = HERE) -> dict[str, dict[str, dict[str, float]]]:
    """Mean JaC of each camera set of a sport: set -> protocol -> tau -> JaC."""
    from procc_annotator.dataset.camera_set import CameraSet
    from procc_annotator.dataset.workspace import Workspace
    from procc_annotator.metrics.measurement import measure
    from procc_annotator.metrics.score import score
    from procc_annotator.metrics.setup import PROTOCOLS, EvaluationSetup

    folder = sample / sport.folder
    workspace = Workspace.open(folder, sport.field)
    result: dict[str, dict[str, dict[str, float]]] = {}
    for name in sport.sets:
        cameras = CameraSet.open(folder / "cameras" / name)
        for protocol in PROTOCOLS:
            setup = EvaluationSetup(sport.field, EVALUATION_SIZE, protocol)
            measured = []
            for index, frame in enumerate(workspace.frames):
                camera = cameras.camera(frame.name, EVALUATION_SIZE)
                if camera is not None and workspace.annotated_count(index):
                    measured.append(measure(workspace.read(index), camera.camera, setup))
            result.setdefault(name, {})[protocol] = {
                f"{tau:g}": sum(score(m, tau).jac for m in measured) / len(measured)
                for tau in (2.0, 5.0, 10.0)
            }
    return result


def write_views(folder: Path) -> None:
    """Write three views of one instant, annotated with six places of the stand."""
    sys.path.insert(0, str(HERE.parent / "docs" / "examples"))
    from three_views import make_dataset

    make_dataset(folder)


def write_video(path: Path) -> None:
    """Write a broadcast clip of two shots: two goals, a camera that pans, people who run."""
    sys.path.insert(0, str(HERE.parent))
    from tests.drawn_shots import FPS, cut_shot

    shot = cut_shot(VIDEO_FRAMES)
    path.parent.mkdir(parents=True, exist_ok=True)
    with av.open(str(path), "w") as container:
        stream = container.add_stream("libx264", rate=round(FPS))
        stream.width, stream.height, stream.pix_fmt = *PICTURE_SIZE, "yuv420p"
        stream.options = {"crf": "29", "preset": "slow", "g": "25"}
        stream.codec_context.thread_count = 1  # the same bytes on every machine
        for number in range(VIDEO_FRAMES):
            pixels = np.ascontiguousarray(shot.frame(number)[..., :3])
            container.mux(stream.encode(av.VideoFrame.from_ndarray(pixels, format="bgr24")))
        container.mux(stream.encode())


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--golden", action="store_true", help="write the expected scores instead")
    parser.add_argument("--out", type=Path, default=HERE, help="folder to draw into")
    parser.add_argument("--sport", choices=sorted(SPORTS), action="append", help="only this one")
    parser.add_argument("--frame", action="append", help="only frames of this name")
    arguments = parser.parse_args()
    if arguments.golden:
        found = {name: scores(sport) for name, sport in SPORTS.items()}
        GOLDEN.write_text(json.dumps(found, indent=2) + "\n")
        print(GOLDEN.read_text())
        return
    for name in arguments.sport or SPORTS:
        sport = SPORTS[name]
        write_field(sport, arguments.out / sport.folder)
        for view in sport.views:
            if not arguments.frame or view.name in arguments.frame:
                write(sport, view, arguments.out / sport.folder)
                print(name, view.name, "drawn", flush=True)
    if not arguments.sport and not arguments.frame:
        write_second(arguments.out)
        write_views(arguments.out / "views")
        write_video(arguments.out / "shot" / "match.mp4")
    total = sum(p.stat().st_size for p in arguments.out.rglob("*") if p.is_file())
    print(f"{total / 1e6:.1f} MB with cameras and annotations")


if __name__ == "__main__":
    main()
