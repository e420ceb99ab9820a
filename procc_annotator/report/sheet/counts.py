"""Every count that tables tell beside their figures: of frames, of points, of elements."""

from __future__ import annotations

from procc_annotator.report.sheet.figure import Metric


def _count(key: str, title: str, definition: str) -> Metric:
    return Metric(key, title, "", None, 0, definition)


# --- what a source of cameras rests on ------------------------------------------------------------

FRAMES = _count("frames", "frames", "Frames that the figures of the row are of.")
IMAGES = _count("images", "Annotated frames", "Frames with an annotation that could be read.")
EVALUATED = _count("evaluated", "With a camera", "Annotated frames with a usable camera.")
WITHOUT = _count("without", "Without", "Annotated frames without a usable camera.")
MIRRORED = _count(
    "mirrored", "Labels mirrored",
    "Frames whose score is that of the mirrored labels.",
)  # fmt: skip
UNMATCHED = _count(
    "unmatched_cameras", "Cameras without annotation", "Cameras of frames that nobody annotated."
)
ERROR_POINTS = _count(
    "points", "Points",
    "Annotated points of elements that the camera projects: those that have a distance.",
)  # fmt: skip
UNDEFINED = _count(
    "undefined", "without distance",
    "Annotated points of projected elements to which the protocol gives no distance.",
)  # fmt: skip

# --- two sources of cameras, several sources ------------------------------------------------------

SHARED = _count("shared", "frames of both", "Annotated frames for which both have a camera.")
FRAMES_ONLY_A = _count("only_a", "only A", "Annotated frames for which only A has a camera.")
FRAMES_ONLY_B = _count("only_b", "only B", "Annotated frames for which only B has a camera.")
HAVING = _count(
    "frames_having", "frames with it",
    "Frames that mean and median beside it are of, where these are not all frames of the row.",
)  # fmt: skip
RANK = _count(
    "rank", "rank",
    "One more than the sources that are better beyond chance: those that the data cannot tell apart"
    " share it.",
)  # fmt: skip
FRAMES_FOR = _count(
    "frames_for", "frames for points",
    "Frames of a set like this one with which a difference of so many points of JaC is found in 80"
    " of 100 cases; of a single source, with which its JaC is known to so many.",
)  # fmt: skip
HELD_OUT_ELEMENTS = _count(
    "elements", "Elements", "Elements that were left out in turn and judged by the others' camera."
)
