"""Fit a camera to every annotated frame of a folder, score it, and write it beside the others.

    python docs/examples/fit_and_score.py [FOLDER] [--cameras OUT] [--model auto] [--tau 5]

FOLDER holds annotations ({frame}.json); no picture is needed. Without OUT nothing is written.
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path

from procc_annotator import evaluate, fit_camera, load_annotation
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.io.camera_files.soccernet_camera import write_camera

SAMPLE_DATA = Path(__file__).parents[2] / "sample_data"
SIZE = (960, 540)


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, nargs="?", default=SAMPLE_DATA)
    parser.add_argument("--cameras", type=Path, help="folder to write camera_{frame}.json to")
    parser.add_argument("--model", default="auto", choices=["P", "R", "R+", "auto"])
    parser.add_argument("--tau", type=float, default=5.0, help="threshold in pixels")
    return parser.parse_args()


def main() -> None:
    asked = arguments()
    files = sorted(asked.folder.glob("*.json"))
    if not files:
        raise SystemExit(f"{asked.folder}: no annotation (*.json)")
    if asked.cameras is not None:
        asked.cameras.mkdir(parents=True, exist_ok=True)
    print("frame  model  JaC   pan sd  focal sd  position sd")
    for path in files:
        annotation = load_annotation(path)
        fit = fit_camera(annotation, model=asked.model, size=SIZE)
        # A failed fit is a value, not an error; nothing is written for it.
        if not isinstance(fit.camera, PinholeCamera) or fit.deviations is None:
            print(f"{path.stem}  no camera: {fit.failure}")
            continue
        score = evaluate(annotation, fit.camera, size=SIZE, tau=asked.tau)
        known = fit.deviations
        print(
            f"{path.stem}  {fit.model:5}  {score.jac:.2f}  {math.degrees(known.pan_rad):.2f} deg"
            f"  {known.focal_px:.0f} px  {math.hypot(*known.position_m):.2f} m"
        )
        if asked.cameras is not None:
            size = {"image_width": SIZE[0], "image_height": SIZE[1]}
            out = asked.cameras / f"camera_{path.stem}.json"
            out.write_bytes(write_camera(fit.camera, size))


if __name__ == "__main__":
    main()
