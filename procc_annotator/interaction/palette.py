"""Colours, dashes and sizes of everything drawn.

Tones are those of Okabe and Ito's colour-blind safe palette. Dash patterns are in points, on and
off in turn, () is solid, so that colour is never the only sign.
"""

from __future__ import annotations

from procc_annotator.translation import word

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
    "tp": word("passes"),
    "too_far": word("too far"),
    "not_annotated": word("not annotated"),
    "missed": word("missed"),
}

UNCONFIRMED = "#0072B2"  # copied, nobody has touched it yet
UNCONFIRMED_DASH = (5.0, 3.0)
# Where the fitted camera expects an element that is not annotated yet.
GHOST = "#56B4E9"
UNSURE_GHOST = "#E69F00"  # of a camera that was found without clicks and may be wrong
GHOST_DASH = (9.0, 5.0, 2.0, 5.0)
GHOST_OUTLINE = "#78202020"  # the dashes stand out from the painted line, which is seen through it
GHOST_BAND = 0.15  # opacity of what it may be off by
CURRENT_GHOST_BAND = 0.35
CURSOR, CONTROL_POINT = "#56B4E9", "#FFFFFF"  # a camera that can be dragged, and what holds it
FINDING = "#F0E442"  # signs of the label check; their shapes say how sure it is
BAD_POINT_SIZE = 17.0
SECOND = "#FFFFFF"  # what a second annotator clicked
COMMENT = "#FFD27F"
LANDING, LANDING_SIZE = "#FFFFFF", 9.0  # where snapping would put a click

# How a point came to be, by the values of `OriginKind`: its tone and shape.
ORIGINS: dict[str, tuple[str, str]] = {
    "clicked": ("#56B4E9", "handle"),
    "snapped": ("#009E73", "dot"),
    "regularised": ("#F0E442", "dot"),
    "copied": ("#0072B2", "ring"),
    "moved": ("#E69F00", "handle"),
    "accepted suggestion": ("#CC79A7", "ring"),  # not shown
    "proposed": ("#CC79A7", "cross"),
    "accepted proposal": ("#CC79A7", "dot"),  # not shown
    "unconfirmed by paint": ("#D55E00", "cross"),  # not shown
    "from the file": ("#B0B0B0", "handle"),  # not shown
}
AUTHORS: tuple[tuple[str, str], ...] = (
    ("#56B4E9", "handle"),
    ("#E69F00", "dot"),
    ("#009E73", "ring"),
    ("#F0E442", "handle"),
    ("#CC79A7", "dot"),
    ("#D55E00", "ring"),
)

FIT = "#56B4E9"  # the camera fitted to the clicks
TRACK = "#F5A9D0"  # the cameras of a shot that was followed

# Camera sources, in the order they are opened: wireframes, curves and rows of one source alike.
# None can be taken for a tone of the criterion, also where red is not seen from green.
SOURCE_COLOURS: tuple[str, ...] = (
    "#fff23d",
    "#7a22ff",
    "#4a8dff",
    "#baf7cb",
    "#0b4a80",
    "#22e6ff",
)

# Disagreement of two cameras, one tone a band of `metrics.error_maps.DISAGREEMENT_LEVELS_M`: from
# little (light) to much (dark). The lightness falls in even steps, so that the order can be read
# without seeing the hues, and no tone is that of grass.
DISAGREEMENT_COLOURS: tuple[str, ...] = (
    "#FDF4C9",
    "#FECB8A",
    "#FB9A67",
    "#E4666A",
    "#B63679",
    "#7A1F82",
    "#3B0F70",
)
DISAGREEMENT_OPACITY = 0.6
# How surely a fitted camera knows the ground, one tone a band between 0.1, 0.5 and 1 m: dark where
# little is known, and where much is known so pale that painted lines show through.
UNCERTAINTY_COLOURS: tuple[str, ...] = ("#F4F7FF", "#9CBBF2", "#3F66C8", "#0E1650")
UNCERTAINTY_OPACITY = 0.4
UNCERTAINTY_DASHES: tuple[tuple[float, ...], ...] = ((), (9.0, 6.0), (2.0, 4.0))
PAIR_COLOURS = SOURCE_COLOURS[:2]  # the first and the second of two cameras
LIMIT_DASH = (9.0, 6.0)  # the line of the accuracy asked for
LIMIT_WIDTH = 2.0

HALO = "#FFFFFF"  # the selected element, never red
OUTLINE = "#202020"
LABEL = "#FFFFFF"
UNKNOWN_CLASS = "#B0B0B0"  # classes of the file that the field does not know

ANNOTATION_WIDTH = 2.0
PROJECTION_WIDTH = 1.0
LINE_MARKING_WIDTH = 0.9  # of the borders of painted lines
WIREFRAME_WIDTH = 1.2
CURSOR_WIDTH, CONTROL_POINT_SIZE = 1.5, 9.0
GHOST_WIDTH, CURRENT_GHOST_WIDTH = 1.3, 2.2
GHOST_POINT_SIZE = 8.0  # where accepting it would put points
EVIDENCE_WIDTH, EVIDENCE_OUTLINE = 1.6, "#B0202020"  # strips that tell of paint, beside the lines
EVIDENCE_OFFSET_DASH, EVIDENCE_NONE_DASH = (7.0, 3.0), (1.5, 3.5)
NEXT_SIZE = 16.0  # the ring around the element to draw next
ERROR_VECTOR_WIDTH = 1.0
HANDLE_SIZE = 6.0
SELECTED_POINT_SIZE = 13.0
PICK_RADIUS_PX = 10.0  # on the screen
