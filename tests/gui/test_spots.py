"""Single places in the real window: one click each, and on to the next element."""

import numpy as np
import pytest
from PySide6.QtCore import Qt

from tests.gui.conftest import heard

MARK = "Penalty mark left"


def test_one_click_annotates_a_spot_and_goes_on(window, hand, saved):
    services = window.services
    services.selection.select_class(MARK)
    at = hand.click(200, 150)
    assert saved(MARK) == pytest.approx(np.array([at]), abs=1e-6)
    assert not window.canvas.editor.drawing
    assert services.state.selected_class not in (None, MARK)  # the next one is offered
    services.selection.select_class(MARK, continues=True)
    there = hand.double_click(300, 180)
    assert saved(MARK) == pytest.approx(np.array([there]), abs=1e-6)
    assert not window.canvas.editor.drawing
    services.editing.undo()
    assert saved(MARK) == pytest.approx(np.array([at]), abs=1e-6)


def test_a_spot_is_moved_and_removed_like_any_point(window, hand, saved):
    services = window.services
    hand.draw(MARK, (200, 150))
    services.selection.set_mode("edit")
    hand.drag((200, 150), (240, 170))
    assert saved(MARK) == pytest.approx(np.array([hand.picture(240, 170)]), abs=1.5)
    hand.key(Qt.Key.Key_Delete)
    assert len(saved(MARK)) == 0
    assert services.state.annotation.get(MARK) is None


def test_a_spot_is_not_regularised(window, hand, saved):
    told = heard(window.services)
    hand.draw(MARK, (200, 150))
    window.services.selection.select_class(MARK)
    window.actions_["regularise"].trigger()
    assert "Left penalty mark has corners or is one place: it stays as it is" in told
    assert len(saved(MARK)) == 1
