"""Names of the camera formats of this program; apart, so that help texts load no reader."""

CAMERA_FORMAT_NAMES = (
    "soccernet", "tvcalib", "broadtrack", "deepsportradar", "krt", "polylines",
    "projection", "transforms", "sccvsd", "ptz-slam", "opencv", "wc14", "carwc", "world",
    "colmap", "easymocap",
)  # fmt: skip
