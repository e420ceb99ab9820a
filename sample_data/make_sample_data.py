"""Draw the sample dataset: pictures, annotations and four camera sets, the same on every run.

python sample_data/make_sample_data.py            draws everything beside this file
python sample_data/make_sample_data.py --golden   writes the scores the tests hold it to
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import cv2
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from drawing.camera_sets import camera_files  # noqa: E402
from drawing.clicks import annotation_of  # noqa: E402
from drawing.figures import draw_figures  # noqa: E402
from drawing.scenery import draw_scenery  # noqa: E402
from drawing.views import EVALUATION_SIZE, PICTURE_SIZE, View, views  # noqa: E402
from procc_annotator.io.annotation_files.soccernet_annotation import write_annotation  # noqa: E402

SUPERSAMPLING = 2
JPEG_QUALITY = 92
GOLDEN = HERE.parent / "tests" / "unit" / "golden_sample_scores.json"


def draw(view: View) -> np.ndarray:
    """A frame as a broadcast shows it: (720, 1280, 3) BGR uint8."""
    fine_size = (PICTURE_SIZE[0] * SUPERSAMPLING, PICTURE_SIZE[1] * SUPERSAMPLING)
    # A fine pixel X covers the picture's x = (X + 0.5) / 2 - 0.5: focal lengths double exactly,
    # the principal point moves with the pixel centres.
    coarse = view.picture_camera
    camera = type(coarse)(
        coarse.pan_rad,
        coarse.tilt_rad,
        coarse.roll_rad,
        coarse.position_world,
        (coarse.focal_px[0] * SUPERSAMPLING, coarse.focal_px[1] * SUPERSAMPLING),
        (
            (coarse.principal_point_px[0] + 0.5) * SUPERSAMPLING - 0.5,
            (coarse.principal_point_px[1] + 0.5) * SUPERSAMPLING - 0.5,
        ),
        coarse.radial,
    )
    seed = int(view.name)
    with np.errstate(divide="ignore", invalid="ignore"):  # rays that meet a plane nowhere
        scenery = draw_scenery(camera, fine_size, seed)
    fine = np.clip(scenery, 0, 255).astype(np.uint8)
    draw_figures(fine, camera, seed)
    picture = cv2.resize(fine, PICTURE_SIZE, interpolation=cv2.INTER_AREA)
    picture = cv2.GaussianBlur(picture, (0, 0), 0.7)
    noise = np.random.default_rng(seed).normal(0, 1.6, picture.shape)
    return np.clip(picture + noise, 0, 255).astype(np.uint8)


def write(view: View, folder: Path) -> None:
    """Write a frame's picture, annotation and cameras below a folder."""
    jpeg = [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY]
    _, encoded = cv2.imencode(".jpg", draw(view), jpeg)
    (folder / f"{view.name}.jpg").write_bytes(encoded.tobytes())
    write_data(view, folder)


def write_data(view: View, folder: Path) -> None:
    """Write a frame's annotation and cameras, without its picture."""
    if view.annotated:
        (folder / f"{view.name}.json").write_bytes(write_annotation(annotation_of(view)))
    for name, content in camera_files(view).items():
        path = folder / "cameras" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def scores(folder: Path = HERE) -> dict[str, dict[str, dict[str, float]]]:
    """Mean JaC of each camera set: set -> protocol -> tau -> JaC."""
    from procc_annotator.field.load import load_field
    from procc_annotator.metric.measure import measure
    from procc_annotator.metric.score import score
    from procc_annotator.metric.setup import PROTOCOLS, EvaluationSetup
    from procc_annotator.session.camera_set import CameraSet
    from procc_annotator.session.workspace import Workspace

    field = load_field()
    workspace = Workspace.open(folder, field)
    result: dict[str, dict[str, dict[str, float]]] = {}
    for name in ("true", "homography", "pinhole", "bad"):
        cameras = CameraSet.open(folder / "cameras" / name)
        for protocol in PROTOCOLS:
            setup = EvaluationSetup(field, EVALUATION_SIZE, protocol)
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


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--golden", action="store_true", help="write the expected scores instead")
    parser.add_argument("--out", type=Path, default=HERE, help="folder to draw into")
    arguments = parser.parse_args()
    if arguments.golden:
        GOLDEN.write_text(json.dumps(scores(), indent=2) + "\n")
        print(GOLDEN.read_text())
        return
    arguments.out.mkdir(parents=True, exist_ok=True)
    for view in views():
        write(view, arguments.out)
        print(view.name, "drawn", flush=True)
    total = sum(p.stat().st_size for p in arguments.out.rglob("*") if p.is_file())
    print(f"{len(views())} frames, {total / 1e6:.1f} MB with cameras and annotations")


if __name__ == "__main__":
    main()
