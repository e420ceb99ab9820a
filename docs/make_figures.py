"""Draw the figures of the explanations, in both themes: ``make screenshots``.

They are computed by the program's own functions from the sample data, not drawn by hand.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import cv2
import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Rectangle

import procc_annotator as procc
from procc_annotator.annotation import points_px
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.model import Element
from procc_annotator.field.sampling import sample_evenly
from procc_annotator.metrics.measurement import measure
from procc_annotator.metrics.setup import EvaluationSetup

ROOT = Path(__file__).resolve().parent.parent
SAMPLE, PICTURES = ROOT / "sample_data", ROOT / "docs" / "pictures"
SIZE = (960, 540)
GREEN, RED, ORANGE, BLUE = "#009E73", "#D55E00", "#E69F00", "#0072B2"
THEMES = {"": ("#1b1f24", "#ffffff"), "-dark": ("#d7dce2", "#1e2129")}  # text, ground
FIELD = procc.load_field("soccer")


def _projected(camera: Any, name: str) -> list[np.ndarray]:
    return list(procc.project_field(camera, FIELD, size=SIZE, clipped=False)[name])


def _tp_fp(figure: Figure) -> None:
    """One element that passes and one that fails, at 5 px, from a frame of the sample."""
    tau, arcs = 5.0, (("00006", "Circle right"), ("00011", "Circle left"))
    cameras = procc.load_cameras(SAMPLE / "cameras" / "bad")
    for axes, (frame, name) in zip(figure.subplots(1, 2), arcs, strict=True):
        annotation, camera = procc.load_annotation(SAMPLE / f"{frame}.json"), cameras[frame].camera
        clicks = points_px(annotation.get(name), SIZE)
        labels = measure(annotation, camera, EvaluationSetup(FIELD, SIZE, "procc")).plain
        distances = np.asarray(labels.distances[labels.names.index(name)])
        verdict, colour = ("TP", GREEN) if distances.max() < tau else ("FP", RED)
        for piece in _projected(camera, name):
            axes.plot(*piece.T, color=colour, lw=1.5)
        for click, distance in zip(clicks, distances, strict=True):
            axes.add_patch(Circle(tuple(click), tau, fill=False, color="gray", lw=1))
            axes.plot(*click, "o" if distance < tau else "x", color=colour, ms=4)
            axes.annotate(f"{distance:.1f}", click - (0, tau + 1), fontsize=8, ha="center")
        low, high = clicks.min(axis=0) - 18, clicks.max(axis=0) + 18
        axes.set(xlim=(low[0], high[0]), ylim=(high[1], low[1]), aspect="equal")
        axes.set_title(f"{verdict}: farthest point {distances.max():.1f} px", fontsize=10)
        axes.set_xlabel("px; circles: tau = 5 px")


def _clipping(figure: Figure) -> None:
    """A line that leaves the picture at a shallow angle, and a click that the clipping moves."""
    axes: Axes = figure.subplots()
    line = np.array([(-20.0, 90.0), (140.0, 104.0)])
    axes.add_patch(Rectangle((0, 0), 160, 100, fill=False, color="gray", lw=1.5))
    axes.text(150, 97, "border of the picture", color="gray", ha="right", fontsize=8)
    border = line[0] + (line[1] - line[0]) * (100 - 90) / (104 - 90)
    axes.plot(*line.T, color=BLUE, lw=1.5, ls="--", label="procc: the whole projection")
    axes.plot(*np.array([line[0], border]).T, color=ORANGE, lw=3, label="soccernet: inside only")
    click = np.array([118.0, 99.0])
    share = np.dot(click - line[0], line[1] - line[0]) / np.sum((line[1] - line[0]) ** 2)
    foot = line[0] + share * (line[1] - line[0])
    for end, colour in ((border, ORANGE), (foot, BLUE)):
        axes.annotate("", end, click, arrowprops={"arrowstyle": "->", "color": colour, "lw": 1.5})
    axes.plot(*click, "o", color="gray")
    far, near = np.linalg.norm(border - click), np.linalg.norm(foot - click)
    axes.set_title(f"the same click: {far:.1f} px to the stump, {near:.1f} px to the line")
    axes.set(xlim=(-25, 165), ylim=(108, 74), xlabel="px", ylabel="px")
    axes.legend(fontsize=8, loc="upper right")


def _paired(figure: Figure) -> None:
    """Simulated JaC of two methods on the same frames: their intervals, and that of the pair."""
    random = np.random.default_rng(4)
    difficulty = random.normal(0.8, 0.12, 60)
    first = np.clip(difficulty + random.normal(0.02, 0.03, 60), 0, 1)
    second = np.clip(difficulty + random.normal(0.0, 0.03, 60), 0, 1)
    left, right = figure.subplots(1, 2, width_ratios=(3, 2))
    for row, (name, values) in enumerate((("A", first), ("B", second))):
        half = 2.0 * values.std(ddof=1) / np.sqrt(len(values))
        left.errorbar(values.mean(), row, xerr=half, fmt="o", color=BLUE, capsize=4)
        left.text(values.mean(), row + 0.15, name, ha="center")
    left.set(ylim=(-0.6, 1.6), yticks=(), xlabel="mean JaC, 95 % interval")
    left.set_title("each method alone", fontsize=10)
    paired = first - second
    half = 2.0 * paired.std(ddof=1) / np.sqrt(len(paired))
    right.errorbar(paired.mean(), 0, xerr=half, fmt="o", color=GREEN, capsize=4)
    right.axvline(0, color="gray", lw=1)
    right.set(ylim=(-1, 1), yticks=(), xlabel="A − B on the same frames")
    right.set_title("paired difference", fontsize=10)


def _jitter(figure: Figure) -> None:
    """A projected point over frames, and its distance from steady motion."""
    random = np.random.default_rng(2)
    frames = np.arange(24)
    steady = 300 + 3.0 * frames + 0.05 * frames**2
    seen = steady + random.normal(0, 0.5, len(frames))
    seen[15:] += 6
    second = (seen[:-2] - 2 * seen[1:-1] + seen[2:]) / np.sqrt(6)
    top, bottom = figure.subplots(2, 1, sharex=True)
    top.plot(frames, seen, "o-", ms=3, color=BLUE)
    top.set_ylabel("x of a point, px")
    bottom.bar(frames[1:-1], second, color=[RED if abs(v) > 1.5 else GREEN for v in second])
    bottom.set(xlabel="frame", ylabel="2nd difference / √6")
    bottom.annotate("jump", (14.5, second[np.abs(second).argmax()]), ha="center", fontsize=9)


def _distortion(figure: Figure) -> None:
    """The penalty area through three lenses."""
    for axes, (k1, title) in zip(
        figure.subplots(1, 3), ((-0.25, "barrel"), (0.0, "none"), (0.5, "pincushion")), strict=True
    ):
        camera = PinholeCamera(
            pan_rad=0.0, tilt_rad=1.3, roll_rad=0.0, position_world=(0.0, 50.0, -14.0),
            focal_px=(560.0, 560.0), principal_point_px=(479.5, 269.5), radial=(k1, 0, 0, 0, 0, 0),
        )  # fmt: skip
        for pieces in procc.project_field(camera, FIELD, size=SIZE).values():
            for piece in pieces:
                axes.plot(*np.asarray(piece).T, color=BLUE, lw=1)
        axes.set(xlim=(0, 959), ylim=(539, 0), aspect="equal", xticks=(), yticks=())
        axes.set_title(f"{title}, k1 = {k1:g}", fontsize=9)


def _uncertainty(figure: Figure) -> None:
    """A fit to four elements of a frame: the others, with two standard deviations."""
    annotation = procc.load_annotation(SAMPLE / "00002.json")
    for name in annotation.annotated[4:]:
        annotation = annotation.without(name)
    fit = procc.fit_camera(annotation, model="R", size=SIZE)
    axes: Axes = figure.subplots()
    picture = cv2.imread(str(SAMPLE / "00002.jpg"))
    axes.imshow(cv2.resize(picture, SIZE, interpolation=cv2.INTER_AREA)[..., ::-1], alpha=0.5)
    for element in FIELD.elements:
        if element.name in annotation.annotated:
            axes.plot(*points_px(annotation.get(element.name), SIZE).T, "o", color=GREEN, ms=4)
            continue
        world = _points_along(element)
        pixels, valid = fit.camera.project(world)
        if valid.sum() < 2:
            continue
        deviation = np.asarray(fit.projected_sd(world)).reshape(len(world), -1).max(axis=1)
        for point, sd in zip(pixels[valid], deviation[valid], strict=True):
            axes.add_patch(Circle(tuple(point), min(2 * sd, 60), color=BLUE, alpha=0.25, lw=0))
        axes.plot(*pixels[valid].T, color=BLUE, lw=1, ls="-.")
    axes.set(xlim=(0, 959), ylim=(539, 0), xticks=(), yticks=())
    axes.set_title("four annotated elements (dots), the others ± 2 standard deviations", fontsize=9)


def _points_along(element: Element) -> np.ndarray:
    """Return points along an element, (N, 3) metres."""
    samples = sample_evenly(replace(FIELD, elements=(element,)), 1.0)
    return samples.points_world


def _profile(figure: Figure) -> None:
    """Brightness across a near line of the sample: its pixels, and the centre of the band."""
    size = (1280, 720)
    camera = procc.load_cameras(SAMPLE / "cameras" / "true")["00002"].camera
    camera = camera.scaled(SIZE, size)
    element = next(e for e in FIELD.elements if e.name == "Big rect. left main")
    pixels, _ = camera.project(_points_along(element))
    inside = pixels[(pixels > 60).all(axis=1) & (pixels < (1220, 660)).all(axis=1)]
    middle = len(inside) // 2
    along = inside[middle + 1] - inside[middle - 1]
    normal = np.array((-along[1], along[0])) / np.linalg.norm(along)
    offsets = np.arange(-8, 8.01, 0.25)
    places = (inside[middle] + offsets[:, None] * normal).astype(np.float32)
    grey = cv2.imread(str(SAMPLE / "00002.jpg")).min(axis=2).astype(np.float32)
    cut = cv2.remap(grey, places[None, :, 0], places[None, :, 1], cv2.INTER_CUBIC)[0]
    axes: Axes = figure.subplots()
    half = (cut.max() + np.median(cut)) / 2
    band = offsets[cut > half]
    axes.plot(offsets, cut, color=BLUE)
    axes.axhline(half, color="gray", lw=1, ls=":")
    axes.axvspan(band[0], band[-1], color=GREEN, alpha=0.2, label="the band at half contrast")
    axes.axvline((band[0] + band[-1]) / 2, color=GREEN, label="its centre: where the click goes")
    axes.set(xlabel="px across the line", ylabel="smallest colour channel")
    axes.legend(fontsize=8)


def _conventions(figure: Figure) -> None:
    """The field from above with its axes; a picture four pixels wide."""
    left, right = figure.subplots(1, 2, width_ratios=(3, 2))
    for element in FIELD.elements:
        points = _points_along(element)
        if np.abs(points[:, 2]).max() == 0:
            left.plot(points[:, 0], points[:, 1], color="gray", lw=1)
    arrow = {"arrowstyle": "->", "lw": 2}
    for tip, text, colour in (((25, 0), "x", RED), ((0, 25), "y, main camera", GREEN)):
        left.annotate("", tip, (0, 0), arrowprops={**arrow, "color": colour})
        left.text(*tip, f" {text}", color=colour)
    left.plot(0, 0, "x", color=BLUE)
    left.text(1, -3, "z down", color=BLUE)
    left.set(xlim=(-56, 56), ylim=(40, -38), aspect="equal", xlabel="m", ylabel="m")
    for x in range(4):
        for y in range(3):
            right.add_patch(Rectangle((x - 0.5, y - 0.5), 1, 1, fill=False, color="gray"))
            right.plot(x, y, "+", color="gray")
    right.plot((0, 3), (0, 2), "o", color=BLUE)
    right.text(0.1, -0.1, "(0, 0): u = v = 0", fontsize=8)
    right.text(1.4, 1.8, "(3, 2): u = v = 1", fontsize=8)
    right.set(xlim=(-0.8, 3.8), ylim=(2.8, -0.8), aspect="equal", title="W = 4, H = 3")


FIGURES: dict[str, tuple[Callable[[Figure], None], tuple[float, float]]] = {
    "tp-fp": (_tp_fp, (8, 3.4)),
    "clipping": (_clipping, (7, 2.8)),
    "paired-difference": (_paired, (7, 2.2)),
    "jitter": (_jitter, (6, 3.2)),
    "distortion": (_distortion, (9, 2.1)),
    "uncertainty": (_uncertainty, (6.4, 3.8)),
    "profile": (_profile, (5, 2.8)),
    "conventions": (_conventions, (8, 3.2)),
}


def _outputs(folder: Path) -> None:
    """Take pictures from the commands of the recipes: of drawn and written files."""
    bad, pinhole = SAMPLE / "cameras" / "bad", SAMPLE / "cameras" / "pinhole"
    shot = SAMPLE / "shot" / "match.mp4"
    recipe = (ROOT / "docs" / "how-to" / "offside-line.md").read_text(encoding="utf-8")
    tutorial = ROOT / "docs" / "tutorials" / "a-sport-of-your-own.md"
    padel = "\n".join(re.findall(r"```toml\n(.*?)```", tutorial.read_text(encoding="utf-8"), re.S))
    (folder / "padel.toml").write_text(padel, encoding="utf-8")
    (folder / "sample_data").symlink_to(SAMPLE)
    program = [sys.executable, "-m", "procc_annotator"]
    for command in (
        [*program, "figure", SAMPLE, "figure.png", "--cameras", f"pinhole={pinhole}",
         "--cameras", f"bad={bad}"],
        [*program, "track", shot, "tracked"],
        [*program, "render", shot, "top-view.png", "--cameras", "tracked", "--top-view"],
        [*program, "field", "show", "padel.toml", "--output", "padel.png"],
        [sys.executable, "-c", re.findall(r"```python\n(.*?)```", recipe, re.S)[0]],
    ):  # fmt: skip
        environment = {**os.environ, "PYTHONPATH": str(ROOT)}
        subprocess.run(command, cwd=folder, env=environment, check=True, stdout=subprocess.DEVNULL)
    for name in ("figure", "top-view", "padel", "offside"):
        picture = cv2.imread(str(folder / f"{name}.png"))
        scale = min(1.0, 1200 / picture.shape[1])
        small = cv2.resize(picture, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA)
        path = PICTURES / f"output-{name}.webp"
        cv2.imwrite(str(path), small, [cv2.IMWRITE_WEBP_QUALITY, 85])


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        _outputs(Path(folder))
    for suffix, (text, ground) in THEMES.items():
        colours = dict.fromkeys(
            ("text.color", "axes.labelcolor", "axes.edgecolor", "xtick.color", "ytick.color"), text
        )
        grounds = dict.fromkeys(("figure.facecolor", "axes.facecolor", "legend.facecolor"), ground)
        settings = {**colours, **grounds, "svg.hashsalt": "procc", "font.size": 9}
        with mpl.rc_context(settings):
            for name, (draw, inches) in FIGURES.items():
                figure = plt.figure(figsize=inches, layout="constrained", dpi=150)
                draw(figure)
                if any(axes.images for axes in figure.axes):  # a photograph is smaller as WebP
                    figure.canvas.draw()
                    pixels = np.asarray(figure.canvas.buffer_rgba())[..., 2::-1]
                    path = PICTURES / f"{name}{suffix}.webp"
                    cv2.imwrite(str(path), pixels, [cv2.IMWRITE_WEBP_QUALITY, 88])
                else:
                    figure.savefig(PICTURES / f"{name}{suffix}.svg", metadata={"Date": None})
                plt.close(figure)


if __name__ == "__main__":
    main()
