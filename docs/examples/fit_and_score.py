"""Fit a camera to every annotated frame of a folder, score it, and write it beside the others.

    python docs/examples/fit_and_score.py [FOLDER] [--cameras OUT] [--model auto] [--tau 5]
                                          [--size 960x540]

FOLDER holds annotations ({frame}.json); no picture is needed, but its shape: --size 960x720 for
pictures of 4:3. Without OUT nothing is written. What cannot be read is told and left out.
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path

from procc_annotator import (
    PinholeCamera,
    ProccError,
    evaluate,
    fit_camera,
    load_annotation,
    save_camera,
)

SAMPLE_DATA = Path(__file__).parents[2] / "sample_data"


def size_of(text: str) -> tuple[int, int]:
    """``960x540`` as (960, 540)."""
    width, height = text.split("x")
    return int(width), int(height)


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path, nargs="?", default=SAMPLE_DATA)
    parser.add_argument("--cameras", type=Path, help="folder to write camera_{frame}.json to")
    parser.add_argument("--model", default="auto", choices=["P", "R", "R+", "auto"])
    parser.add_argument("--size", type=size_of, default=(960, 540), metavar="WxH")
    parser.add_argument("--tau", type=float, default=5.0, help="threshold in pixels")
    return parser.parse_args()


def main() -> None:
    asked = arguments()
    files = [p for p in sorted(asked.folder.glob("*.json")) if not p.stem.startswith("camera_")]
    if not files:
        raise SystemExit(f"{asked.folder}: no annotation (*.json)")
    if asked.cameras is not None:
        asked.cameras.mkdir(parents=True, exist_ok=True)
    unread = 0
    print("frame  model  JaC   pan sd  focal sd  position sd")
    for path in files:
        try:
            annotation = load_annotation(path)
        except ProccError as error:
            unread += 1
            print(f"{path.stem}  unreadable: {error}")
            continue
        fit = fit_camera(annotation, model=asked.model, size=asked.size)
        # A failed fit is a value, not an error; nothing is written for it.
        if not isinstance(fit.camera, PinholeCamera) or fit.deviations is None:
            print(f"{path.stem}  no camera: {fit.failure}")
            continue
        score = evaluate(annotation, fit, threshold=asked.tau)
        known = fit.deviations
        print(
            f"{path.stem}  {fit.model:5}  {score.jac:.2f}  {math.degrees(known.pan_rad):.2f} deg"
            f"  {known.focal_px:.0f} px  {math.hypot(*known.position_m):.2f} m"
        )
        if asked.cameras is not None:
            out = asked.cameras / f"camera_{path.stem}.json"
            save_camera(fit, out, fitted_to=annotation, overwrite=True)
    if unread:
        raise SystemExit(1)


if __name__ == "__main__":
    main()
