"""Pictures laid on the ground."""

import numpy as np

from procc_annotator.image.top_view import panorama


def test_a_panorama_is_the_median_of_what_is_seen():
    """Of an even number the lower of the two middle values; black where nothing is seen."""
    seen = [[[True, k == 1], [k > 2, False]] for k in range(1, 6)]
    views = [(np.full((2, 2, 3), 20 * k, np.uint8), np.array(s)) for k, s in enumerate(seen, 1)]
    assert panorama(views)[..., 0].tolist() == [[60, 20], [80, 0]]
    assert panorama(views[:4])[..., 0].tolist() == [[40, 20], [60, 0]]
