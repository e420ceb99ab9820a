"""With ghosts an annotator needs at most a third of the actions, for the same accuracy."""

from __future__ import annotations

from itertools import islice

import numpy as np
import pytest

from tests.bench.interaction.replay import (
    accuracy_px,
    drawn_frames,
    known_names,
    labelme_actions,
    with_ghosts,
)


@pytest.mark.parametrize("every", [2, pytest.param(1, marks=pytest.mark.soak)])
def test_at_most_a_third_of_labelmes_actions(sample_data, every) -> None:
    ours, theirs = 0, 0
    accepted_px, clicked_px = [], []
    for frame in islice(drawn_frames(sample_data), 0, None, every):
        done = with_ghosts(frame.clicked, frame.accept_all)
        assert set(done.annotation.annotated) == set(known_names(frame.clicked))
        ours += done.actions
        theirs += labelme_actions(frame.clicked)
        for name in done.accepted:
            accepted_px.append(accuracy_px(done.annotation, frame.exact, name))
            clicked_px.append(accuracy_px(frame.clicked, frame.exact, name))
    assert ours <= theirs / 3
    assert len(accepted_px) > 50 / every
    assert np.median(accepted_px) <= 1.0
    assert np.median(accepted_px) < np.median(clicked_px)
    assert np.mean(np.array(accepted_px) <= 1.0) >= 0.95
