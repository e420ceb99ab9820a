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
    window.services.live_fit.set_wanted(False)
    assert window.services.camera_sources.load_cameras(annotated / "cameras" / "true")
    window.services.navigator.go_to(1)
    return window


def test_it_is_drawn_on_demand_and_follows(judged, qtbot):
    services, action = judged.services, judged.actions_["painted_width"]
    assert borders(judged) == 0
    action.trigger()
    qtbot.waitUntil(lambda: borders(judged) > 0)
    before = services.line_widths.value
    services.field_choice.resize({"length": 100.0}, keep=False)
    qtbot.waitUntil(lambda: services.line_widths.value not in (None, before))
    services.navigator.next_frame()
    services.navigator.previous_frame()
    qtbot.waitUntil(lambda: borders(judged) > 0)
    services.blind_lock.set_blind(True)
    assert borders(judged) == 0
    services.blind_lock.set_blind(False)
    qtbot.waitUntil(lambda: borders(judged) > 0)
    services.camera_sources.set_active_camera(-1)
    assert borders(judged) == 0
    action.trigger()
    services.camera_sources.set_active_camera(0)
    assert borders(judged) == 0


def test_it_is_remembered(judged, make_window, qtbot):
    judged.actions_["painted_width"].trigger()
    judged.close()
    again = make_window()
    assert again.actions_["painted_width"].isChecked()
    assert again.services.line_widths.enabled


def test_the_borders_lie_on_the_edges_of_the_painted_line(judged, qtbot):
    """The sample is drawn with lines of the width that the field says."""
    judged.actions_["painted_width"].trigger()
    services = judged.services
    qtbot.waitUntil(lambda: services.line_widths.value is not None)
    shown, projected = services.line_widths.value, services.scorer.measurement.projected
    scale = services.state.picture_size[0] / services.state.setup.size[0]
    picture = cv2.cvtColor(
        np.ascontiguousarray(services.navigator.picture[:, :, :3]), cv2.COLOR_BGR2GRAY
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
    services, told, tried = judged.services, [], []
    services.store.events.message.connect(lambda m: told.append(m.text))

    def fail(camera: object, setup: object) -> None:
        tried.append(camera)
        raise CameraError("x", "is no camera")

    with monkeypatch.context() as patched:
        patched.setattr(maps, "project_markings", fail)
        judged.actions_["painted_width"].trigger()
        let_work_end(qtbot)
        services.line_widths.retry()
        let_work_end(qtbot)
    assert len(tried) == 2
    assert tried[0] is tried[1]
    assert len([text for text in told if "painted width cannot be drawn" in text]) == 1
    services.line_widths.retry()
    qtbot.waitUntil(lambda: borders(judged) > 0)
