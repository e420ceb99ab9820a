"""Usual views of a main camera: an example of a detector for procc-annotator.

It looks at no pixel: it says where a camera on the usual tripod looks most of the time. A detector
that does look, such as a network that finds keypoints, has the same form (see README.md).
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from procc_annotator.batch.camera_proposals import PictureProposer
from procc_annotator.calibration.optimization.camera_placement import camera_placement_prior
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.field.model import Field
from procc_annotator.image.pixels import PixelArray

# Where it looks, from the left end of the field to the right, and how much of the field's length
# it shows there.
VIEWS = ((-0.75, 0.45), (-0.35, 0.55), (0.0, 0.6), (0.35, 0.55), (0.75, 0.45))


def usual_views(picture: PixelArray, field: Field) -> Iterator[PinholeCamera]:
    """One camera a view, in px of the picture."""
    height, width = picture.shape[:2]
    around = camera_placement_prior(field)
    x, y, z = 0.0, around.half_width + around.distance[1], -around.height[1]
    for share, shown in VIEWS:
        target = share * around.half_length
        away = math.dist((x, y, z), (target, 0.0, 0.0))
        focal = width * away / (shown * 2 * around.half_length)
        yield PinholeCamera(
            pan_rad=math.atan2(target - x, y),
            tilt_rad=math.acos(-z / away),
            roll_rad=0.0,
            position_world=(x, y, z),
            focal_px=(focal, focal),
            principal_point_px=((width - 1) / 2, (height - 1) / 2),
        )


PROPOSER = PictureProposer("usual_views", "Usual views of the main camera", usual_views)
