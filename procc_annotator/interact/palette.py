"""What each colour and dash means; the one table for canvas, field map, tables and pictures.

Tones are those of Okabe and Ito's colour-blind safe palette. Dash patterns are in points, on and
off in turn, () is solid, so that colour is never the only sign.
"""

from __future__ import annotations

PASSES = "#009E73"
TOO_FAR = "#D55E00"
NOT_ANNOTATED = "#E69F00"
MISSED = "#CC79A7"

STATUS_COLOURS: dict[str, str] = {
    "tp": PASSES,
    "too_far": TOO_FAR,
    "not_annotated": NOT_ANNOTATED,
    "missed": MISSED,
}
STATUS_DASHES: dict[str, tuple[float, ...]] = {
    "tp": (),
    "too_far": (),
    "not_annotated": (12.0, 6.0),
    "missed": (2.0, 4.0),
}
UNKNOWN_CLASS_DASH = (8.0, 4.0)
CURSOR_LINE_DASH = (4.0, 4.0)
STATUS_WORDS: dict[str, str] = {
    "tp": "passes",
    "too_far": "too far",
    "not_annotated": "not annotated",
    "missed": "missed",
}

HALO = "#FFFFFF"  # the selected element, never red
RIM = "#202020"
LABEL = "#FFFFFF"
UNKNOWN_CLASS = "#B0B0B0"  # classes of the file that the field does not know

ANNOTATION_WIDTH = 2.0
PROJECTION_WIDTH = 1.0
WHISKER_WIDTH = 1.0
HANDLE_SIZE = 6.0
SELECTED_POINT_SIZE = 13.0
PICK_RADIUS_PX = 10.0  # on the screen
