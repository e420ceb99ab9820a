"""Whether lines are brighter than what they are painted on, or darker, as those on ice are."""

from __future__ import annotations

import cv2
import numpy as np

from procc_annotator.image.decode import PixelArray

# Ice is neutral and bright, more so than boards and shirts mostly are.
_LEAST, _MOST = np.array([145.0]), np.array([255.0])


def has_bright_ground(smallest: PixelArray) -> bool:
    """Whether most of a picture's part is bright in each of its colours.

    Args:
        smallest: (H, W) the smallest of the three channels.
    """
    return 2 * cv2.countNonZero(cv2.inRange(smallest, _LEAST, _MOST)) > smallest.size
