"""View > Painted width: borders of the paint beside the projection, in the window and in files."""

import cv2
import numpy as np
import pytest

from procc_annotator.errors import CameraError
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state import maps
from tests.gui.conftest import let_work_end


def borders(window: MainWindow) -> int:
    strokes = window.canvas.overlay_item.overlay.strokes
    return sum(len(s.segments) for s in strokes if s.layer == "paint")


@pytest.fixture
def judged(make_window, annotated) -> MainWindow:
    window = make_window(annotated)
    window.document.live_fit.set_wanted(False)
    assert window.document.camera_sources.load_cameras(annotated / "cameras" / "true")
    window.document.walk.go_to(1)
    return window


def test_it_is_drawn_on_demand_and_follows(judged, qtbot):
    document, action = judged.document, judged.actions_["painted_width"]
    assert borders(judged) == 0
    action.trigger()
    qtbot.waitUntil(lambda: borders(judged) > 0, timeout=20_000)
    before = document.painted_width.value
    document.field_choice.resize({"length": 100.0}, keep=False)
    qtbot.waitUntil(lambda: document.painted_width.value not in (None, before), timeout=20_000)
    document.walk.next_frame()
    document.walk.previous_frame()
    qtbot.waitUntil(lambda: borders(judged) > 0, timeout=20_000)
    document.blind_lock.set_blind(True)
    assert borders(judged) == 0
    document.blind_lock.set_blind(False)
    qtbot.waitUntil(lambda: borders(judged) > 0, timeout=20_000)
    document.camera_sources.set_active_camera(-1)
    assert borders(judged) == 0
    action.trigger()
    document.camera_sources.set_active_camera(0)
    assert borders(judged) == 0


def test_it_is_remembered(judged, make_window, qtbot):
    judged.actions_["painted_width"].trigger()
    judged.close()
    again = make_window()
    assert again.actions_["painted_width"].isChecked()
    assert again.document.painted_width.enabled


def test_the_borders_lie_on_the_edges_of_the_painted_line(judged, qtbot):
    """The sample is drawn with lines of the width that the field says."""
    judged.actions_["painted_width"].trigger()
    document = judged.document
    qtbot.waitUntil(lambda: document.painted_width.value is not None, timeout=20_000)
    shown, projected = document.painted_width.value, document.judge.measurement.projected
    scale = document.state.picture_size[0] / document.state.setup.size[0]
    picture = cv2.cvtColor(
        np.ascontiguousarray(document.walk.picture[:, :, :3]), cv2.COLOR_BGR2GRAY
    )
    (name,) = [n for n in shown.pieces if n.startswith("Side line left\n")]
    border = shown.pieces[name][0] * scale
    line = projected.pieces["Side line left"][0] * scale
    outer = line[len(line) // 2]
    inner = border[np.linalg.norm(border - outer, axis=1).argmin()]
    between = (outer + inner) / 2
    beyond = outer + 2.5 * (outer - inner)
    grey = [float(picture[round(y), round(x)]) for x, y in (between, beyond)]
    assert grey[0] > grey[1] + 20  # white between the borders, grass beyond


def test_what_failed_is_tried_again(judged, qtbot, monkeypatch):
    document, told, tried = judged.document, [], []
    document.store.events.message.connect(lambda m: told.append(m.text))

    def fail(camera: object, setup: object) -> None:
        tried.append(camera)
        raise CameraError("x", "is no camera")

    with monkeypatch.context() as patched:
        patched.setattr(maps, "project_markings", fail)
        judged.actions_["painted_width"].trigger()
        let_work_end(qtbot)
        document.painted_width.retry()
        let_work_end(qtbot)
    assert len(tried) == 2
    assert tried[0] is tried[1]
    assert len([text for text in told if "painted width cannot be drawn" in text]) == 1
    document.painted_width.retry()
    qtbot.waitUntil(lambda: borders(judged) > 0, timeout=20_000)
