"""Every metric and count that a table can show, defined once."""

from __future__ import annotations

from typing import Literal

from procc_annotator.report.tables.table import Metric

FAR = 1000.0  # metres or px: next to a horizon distances are as large as one likes

# --- a frame at a threshold: attributes of `FrameScore`, keys of score files ----------------------

JAC = Metric(
    "jac", "JaC", "%", "higher",
    definition="The Jaccard index for camera calibration of a frame, TP / (TP + FP + FN).",
)  # fmt: skip
TP = Metric(
    "tp", "tp", "", None, 0,
    "An annotated and projected element all of whose annotated points have an error below tau.",
)  # fmt: skip
FP = Metric(
    "fp", "fp", "", None, 0,
    "An element that is projected and annotated but has a point tau or more away (too far), or one"
    " that is projected and not annotated.",
)  # fmt: skip
FN = Metric(
    "fn", "fn", "", None, 0, "An element that is annotated and not projected (missed)."
)  # fmt: skip
PRECISION = Metric("precision", "precision", "%", "higher", definition="TP / (TP + FP).")
RECALL = Metric("recall", "recall", "%", "higher", definition="TP / (TP + FN).")
_COUNTED = (
    " Where mirrored labels score as high as the labels as annotated, the official evaluation"
    " counts those: their errors are half a field, and it depends on tau how many such frames there"
    " are."
)
_READ = (
    " Under the labels as annotated, or mirrored ones where they score higher at the threshold"
    " of the column."
)
FRAME_ERROR_COUNTED = Metric(
    "mean_reprojection_error", "official error", "px", "lower",
    definition="The mean reprojection error of a frame's points under the labelling that counts."
    + _COUNTED,
)  # fmt: skip
FRAME_ERROR = Metric(
    "mean_error", "mean error", "px", "lower",
    definition="The mean reprojection error of a frame's points." + _READ,
)  # fmt: skip
# Besides JaC and the counts it comes from.
OF_FRAME = (PRECISION, RECALL, FRAME_ERROR_COUNTED, FRAME_ERROR)

# --- how much of a frame is annotated, whatever the threshold: attributes of `AnnotatedElement`
# ------------

ANNOTATED = Metric(
    "annotated_elements", "elements annotated", "", None, 0,
    "Elements of the field that have points in the frame.",
)  # fmt: skip
SPREAD = Metric(
    "spread", "spread", "%", "higher", 1,
    "The share of the picture that the annotated points enclose (their convex hull).",
)  # fmt: skip
OF_ANNOTATION = (ANNOTATED, SPREAD)

# --- a set at a threshold: attributes of `SetSummary`, keys of score files and reports ------------

MEAN_JAC = Metric(
    "mean_jac", "JaC", "%", "higher",
    definition="The mean of the frames' JaC over the frames that have a camera. In tables of"
    " classes points are counted instead of elements, as the official code does.",
)  # fmt: skip
SD_JAC = Metric(
    "sd_jac", "sd", "%", definition="The standard deviation of the frames' JaC, divided by n."
)
MEDIAN_JAC = Metric(
    "median_jac", "median", "%", "higher", definition="The median of the frames' JaC."
)
COMPLETENESS = Metric(
    "completeness", "completeness", "%", "higher",
    definition="Frames with a usable camera over all annotated frames.",
)  # fmt: skip
FINAL_SCORE = Metric(
    "final_score", "final score", "%", "higher",
    definition="Completeness times mean JaC, as the SoccerNet challenge ranks methods.",
)  # fmt: skip
MEAN_PRECISION = Metric(
    "mean_precision", "precision", "%", "higher",
    definition="The mean of TP / (TP + FP) over the frames in which it is defined.",
)  # fmt: skip
MEAN_RECALL = Metric(
    "mean_recall", "recall", "%", "higher",
    definition="The mean of TP / (TP + FN) over the frames in which it is defined.",
)  # fmt: skip
ERROR_COUNTED = Metric(
    "mean_reprojection_error", "official error", "px", "lower",
    definition="The mean error under the labelling that counts at the threshold of the column."
    + _COUNTED,
)  # fmt: skip
MEAN_ERROR = Metric(
    "mean_error", "mean error", "px", "lower",
    definition="The distance of an annotated point to the nearest place of its element as the"
    " camera projects it, mean over all points of the set together of elements that are annotated"
    " and projected." + _READ,
)  # fmt: skip

OF_SET = (
    MEAN_JAC, SD_JAC, MEDIAN_JAC, COMPLETENESS, FINAL_SCORE, MEAN_PRECISION, MEAN_RECALL,
    ERROR_COUNTED, MEAN_ERROR,
)  # fmt: skip
OF_CLASS = (TP, FP, FN, JAC, PRECISION, RECALL)
# Metrics of sets that are reported with intervals: keys of `batch.frame_sums.RATIOS`.
WITH_INTERVAL = (MEAN_JAC, COMPLETENESS, FINAL_SCORE, MEAN_ERROR)
# Metrics that compare sources on the page of a report, and the thresholds they are shown at. The
# error is that of the largest one, where mirrored labels score higher least often.
COMPARED_ON_PAGE: tuple[tuple[Metric, Literal["every", "largest", "leading", "none"]], ...] = (
    (MEAN_JAC, "every"), (MEAN_ERROR, "largest"), (COMPLETENESS, "none"), (FINAL_SCORE, "leading"),
)  # fmt: skip

# --- how errors are spread and where they lean ----------------------------------------------------

MEDIAN_PX = Metric("median", "median", "px", "lower", definition="Half of the distances are below.")
P95_PX = Metric("p95", "95 %", "px", "lower", definition="95 of 100 distances are below.")
LARGEST_PX = Metric(
    "max", "max", "px", "lower", definition="The largest distance.", attribute="largest"
)
DISTANCES = (MEDIAN_PX, P95_PX, LARGEST_PX)
BIAS_RIGHT = Metric(
    "bias_right", "bias right", "px", signed=True,
    definition="The median of the differences, projection minus click, to the right.",
)  # fmt: skip
BIAS_DOWN = Metric(
    "bias_down", "bias down", "px", signed=True,
    definition="The median of the differences, projection minus click, down the picture.",
)  # fmt: skip

# --- two annotators: attributes of `AgreementMetrics`, keys of agreements -------------------------

COMMON = Metric("common", "elements in common", "", None, 0, "Elements both annotated.")
APART = Metric("apart", "apart", "", None, 0, "Elements both annotated, sharing hardly a stretch.")
ONLY_A = Metric("only_a", "only A", "", None, 0, "Elements only the first annotated.")
ONLY_B = Metric("only_b", "only B", "", None, 0, "Elements only the second annotated.")
POINTS = Metric("points", "points", "", None, 0, "Points whose distance was taken.")
LEFT_OUT = Metric("left_out", "beyond", "", None, 0, "Clicks beyond the other's ends.")
ADDED = Metric(
    "added", "added", "", None, 0,
    "Elements that an annotator has, and at least half of the others, or the answer, not.",
    attribute="only_a",
)  # fmt: skip
MISSED = Metric(
    "missed", "missed", "", None, 0,
    "Elements that more than half of the others, or the answer, have, and an annotator not.",
    attribute="only_b",
)  # fmt: skip
OF_AGREEMENT = (COMMON, APART, ONLY_A, ONLY_B, POINTS, LEFT_OUT, *DISTANCES)

# --- two sources of cameras: attributes of `MapSummary` and `LegacyMetrics`, keys of comparisons
# ------

METRES, PIXELS = (
    tuple(
        Metric(key, title, unit, most=FAR, definition=f"The {words} distance {where}.")
        for key, title, words in (
            ("minimum", "min", "least"),
            ("median", "median", "median"),
            ("maximum", "max", "largest"),
        )
    )
    for unit, where in (("m", "on the ground"), ("px", "in the picture"))
)
WITHIN = Metric(
    "within_offside_accuracy", "within 0.5 m", "%", None, 1,
    "The share of the compared area in which two cameras are at most 0.5 m apart on the ground.",
)  # fmt: skip
LEGACY = (
    Metric(
        "iou_part", "IoU part", "%", "higher",
        definition="Overlap on the ground of the part of the field that the reference shows and the"
        " part that the camera shows.",
    ),
    Metric(
        "iou_whole", "IoU whole", "%", "higher",
        definition="Overlap of the field's rectangle with itself projected by the reference and"
        " traced back by the camera.",
    ),
    Metric(
        "projection_m", "projection error", "m", "lower", most=FAR,
        definition="Mean distance on the ground of pixels that show the visible field.",
    ),
    Metric(
        "reprojection", "reprojection error, of image height", "%", "lower", most=FAR,
        definition="Mean distance in the picture of points of the visible field, over the picture's"
        " height.",
    ),
    Metric(
        "six_point_rmse_cm", "six points, root mean square", "cm", "lower", most=FAR,
        definition="Root of the mean squared difference of six ground points, as the basketball"
        " challenge has it.",
    ),
)  # fmt: skip

# --- cameras found in pictures: medians in tables, keys of tables of cameras ----------------------

PROBABILITY = Metric(
    "probability", "P(right)", "%", "higher", 0, "The probability that the camera is right."
)
COVERAGE = Metric(
    "coverage", "coverage", "%", "higher", 0,
    "The share of the projected lines on which paint was found.",
)  # fmt: skip
EXPLAINED = Metric(
    "explained", "explained", "%", "higher", 0,
    "The share of the paint found on the field that is on a projected line.",
)  # fmt: skip
RESIDUAL = Metric(
    "residual_px", "residual", "px", "lower", definition="How far paint is off the lines."
)
MARGIN = Metric(
    "margin", "margin", better="higher", definition="How much better than the next best camera."
)
SECONDS = Metric("seconds", "s", better="lower", definition="Time it took.")

# --- how surely a camera is known: standard deviations, keys of tables of cameras -----------------

DEVIATIONS = tuple(
    Metric(
        f"sd_{key}", title, unit, digits=3, significant=True,
        definition=f"Standard deviation of the {words}, from the fit's covariance.",
    )
    for key, title, unit, words in (
        ("pan_degrees", "pan", "°", "pan angle"),
        ("tilt_degrees", "tilt", "°", "tilt angle"),
        ("roll_degrees", "roll", "°", "roll angle"),
        ("focal_px", "focal", "px", "focal length"),
        ("x_m", "x", "m", "position along the field"),
        ("y_m", "y", "m", "position across the field"),
        ("z_m", "z", "m", "height"),
    )
)  # fmt: skip

# --- how steady cameras are over a shot: second differences, as the error of one frame ------------

JITTER_PX = Metric(
    "jitter_px", "jitter", "px", "lower",
    definition="How far the field's points in sight lie from where steady motion from the frame"
    " before to the frame after would have them: second differences divided by the root of 6, root"
    " mean square; frames of a jump left out.",
)  # fmt: skip
JITTER_M = Metric(
    "jitter_m", "jitter on the ground", "m", "lower", 3,
    "The same on the ground: how far away the pixels of these points then mean.",
)  # fmt: skip
POSE_JITTER = tuple(
    Metric(
        f"jitter_{key}", title, unit, "lower", 3,
        f"Second differences of the {words} over a shot, as the error of one frame.",
    )
    for key, title, unit, words in (
        ("pan_degrees", "pan", "°", "pan angle"),
        ("tilt_degrees", "tilt", "°", "tilt angle"),
        ("roll_degrees", "roll", "°", "roll angle"),
        ("zoom", "zoom", "%", "focal length, as a share of it"),
        ("position_m", "position", "m", "position, implied by the homography if there is no other"),
    )
)  # fmt: skip
OUTAGE_SHARE = Metric(
    "outage_share", "without a camera", "%", "lower", 1, "Frames of the shot without a camera."
)
OFFSET_COST = Metric(
    "offset_cost_px", "then", "px", "lower",
    definition="Mean distance of the clicks at the shift that fits best; what is farther off than"
    " 20 px, or not shown, counts as 20.",
)  # fmt: skip
OFFSET_AS_IS = Metric(
    "offset_cost_as_is_px", "as it is", "px", "lower", definition="The same without a shift."
)
OFFSET_MARGIN = Metric(
    "offset_margin_px", "margin", "px", "higher",
    definition="By how much the next best shift is worse.",
)  # fmt: skip
STEP_PX = Metric(
    "step_px", "moved", "px", definition="How far the field moved since the frame before."
)

# --- is a difference real: two sources on the frames both have ------------------------------------

JAC_DIFFERENCE = Metric(
    "jac_difference", "JaC, A − B", "%", signed=True,
    definition="The mean JaC of A − that of B, on the frames both have a camera for.",
)  # fmt: skip
SCORE_DIFFERENCE = Metric(
    "final_score_difference", "final score, A − B", "%", signed=True,
    definition="The final score of A − that of B, over all annotated frames.",
)  # fmt: skip
LEFT_OUT_SCORE = Metric(
    "held_out", "held out", "%", "higher",
    definition="The share of elements that are correct under the camera of the other elements.",
)  # fmt: skip
HELD_OUT_DIFFERENCE = Metric(
    "held_out_difference", "held out, A − B", "%", signed=True,
    definition="The share of elements that are correct held out under A − that under B, on the"
    " elements that both determine.",
)  # fmt: skip
IN_SAMPLE = Metric(
    "in_sample", "in sample", "%", "higher",
    definition="The share of the same elements that are correct under the camera of all elements.",
)  # fmt: skip
ERROR_DIFFERENCE = Metric(
    "mean_error_difference", "mean error, A − B", "px", signed=True,
    definition="The mean reprojection error of A − that of B, on the frames both have.",
)  # fmt: skip
# Differences of sources, each with the metric of `SetSummary` that it is the difference of.
DIFFERENCES = (
    (JAC_DIFFERENCE, MEAN_JAC.key),
    (SCORE_DIFFERENCE, FINAL_SCORE.key),
    (ERROR_DIFFERENCE, MEAN_ERROR.key),
)
VERDICT = Metric(
    "verdict", "verdict",
    definition="Significant: the 95 % interval excludes 0 and the Holm-corrected p is below 0.05.",
)  # fmt: skip
P_VALUE = Metric(
    "p", "p", digits=4,
    definition="The share of exchanges of the two sources, whole clusters at once, that differ at"
    " least as much (permutation test).",
)  # fmt: skip
P_CORRECTED = Metric(
    "p_holm", "p, Holm", digits=4,
    definition="The same, corrected for as many comparisons as the table makes at a tau.",
)  # fmt: skip
BEST_IN = Metric(
    "best_in", "best in", "%", digits=1,
    definition="The share of bootstrap resamples in which the method has the highest mean JaC, on"
    " the frames all methods have; none where these are fewer than two clusters.",
)  # fmt: skip
MINIMUM_DETECTABLE_DIFFERENCE = Metric(
    "least_difference", "minimum detectable difference", "%", digits=2,
    definition="The true difference that is significant in 80 of 100 sets like this one.",
)  # fmt: skip
CLICKED_JAC = Metric(
    "moved_jac", "JaC, points moved", "%",
    definition="The mean JaC after every point was moved at random, mean over the repeats.",
)  # fmt: skip
CLICK_DEVIATION = Metric(
    "click_sd", "sd of clicks", "%",
    definition="The standard deviation of a set's figure from repeat to repeat, each with every"
    " point moved at random.",
)  # fmt: skip
CLICK_SHARE = Metric(
    "click_share", "share of clicks", "%", digits=1,
    definition="How much of the variance of a set's figure comes from where points were clicked;"
    " the rest from which frames the set has.",
)  # fmt: skip
DISTINGUISHABLE_FROM = Metric(
    "told_apart_from", "significant from tau", "px", digits=1,
    definition="The smallest threshold at which the band of the difference excludes 0, and so does"
    " what other clicks on these frames would make of it.",
)  # fmt: skip


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
    "unmatched_cameras", "Cameras without annotation", "Cameras of frames without annotation."
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
    "Frames of the mean and median in this row, if these are not all.",
)  # fmt: skip
RANK = _count(
    "rank", "rank",
    "One more than the methods that are significantly better; those that the data cannot tell"
    " apart share it.",
)  # fmt: skip
FRAMES_FOR = _count(
    "frames_for", "frames for points",
    "Frames of a set like this one with which a difference of so many points of JaC is found in 80"
    " of 100 cases; of a single source, with which its JaC is known to so many.",
)  # fmt: skip
HELD_OUT_ELEMENTS = _count(
    "elements", "Elements", "Elements that were left out in turn and judged by the others' camera."
)
