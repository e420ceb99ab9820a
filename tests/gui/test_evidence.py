"""What the picture shows of paint: strips beside the segments, and what is told of it."""

import shutil
from collections.abc import Callable

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt

from procc_annotator.annotation import Polyline
from procc_annotator.assist import line_evidence as evidence_module
from procc_annotator.calibration.label_check.evidence import LinePresence
from procc_annotator.calibration.label_check.finding import Rule
from procc_annotator.dataset.review import StoredFinding
from procc_annotator.gui.main_window import MainWindow
from procc_annotator.gui.state.state import BENT
from procc_annotator.interaction import palette as tones
from tests.gui.conftest import heard

MakeWindow = Callable[..., MainWindow]


@pytest.fixture(autouse=True)
def paint_looked_for_once() -> None:
    """It is looked for in every test: they are about that."""


@pytest.fixture
def annotated(make_window, sample_data, tmp_path) -> MainWindow:
    folder = tmp_path / "one"
    folder.mkdir()
    for name in ("00002.jpg", "00002.json"):
        shutil.copy(sample_data / name, folder)
    return make_window(folder)


@pytest.fixture
def bent(make_window, tmp_path) -> MainWindow:
    """Grass with one white line that a lens bends by 5 px."""
    folder = tmp_path / "bent"
    folder.mkdir()
    picture = np.full((540, 960, 3), (60, 120, 70), dtype=np.uint8)
    x = np.arange(100, 861)
    y = 300 + 5.0 * (1 - ((x - 480) / 380.0) ** 2)
    eighths = np.round(np.column_stack([x, y]) * 8).astype(int)
    cv2.polylines(picture, [eighths], False, (235, 240, 238), 4, cv2.LINE_AA, 3)
    cv2.imwrite(str(folder / "frame.png"), picture)
    return make_window(folder)


def strips(window: MainWindow) -> set[str]:
    """Colours of the strips that are drawn."""
    drawn = window.canvas.overlay_item.overlay.strokes
    return {s.colour for s in drawn if s.width == tones.EVIDENCE_WIDTH and len(s.segments)}


def test_strips_are_drawn_once_they_are_asked_for(annotated, qtbot):
    services = annotated.services
    qtbot.waitUntil(lambda: services.line_pixels.value is not None)
    assert strips(annotated) == set()
    annotated.actions_["evidence"].trigger()
    qtbot.waitUntil(lambda: tones.PASSES in strips(annotated))
    seen = services.line_pixels.value
    assert set(seen) == set(services.state.annotation.polylines) - {
        p for p in services.state.annotation.polylines if p not in seen
    }
    under = np.concatenate([one.paint == LinePresence.UNDER for one in seen.values()])
    assert under.mean() > 0.6
    annotated.actions_["evidence"].trigger()
    qtbot.waitUntil(lambda: strips(annotated) == set())


def test_blind_mode_may_see_it(annotated, qtbot):
    annotated.services.blind_lock.set_blind(True)
    annotated.actions_["evidence"].trigger()
    qtbot.waitUntil(lambda: tones.PASSES in strips(annotated))


def test_only_what_changed_is_looked_at_again(annotated, hand_on, qtbot, monkeypatch):
    services, looked_at = annotated.services, []
    qtbot.waitUntil(lambda: services.line_pixels.value is not None)
    really = evidence_module._along

    def along(polyline: Polyline, *rest, **more):
        looked_at.append(polyline.class_name)
        return really(polyline, *rest, **more)

    monkeypatch.setattr(evidence_module, "_along", along)
    name = services.state.annotation.polylines[0].class_name
    services.selection.select_point(name, 0)
    hand_on(annotated).key(Qt.Key.Key_Right)
    qtbot.waitUntil(lambda: services.line_pixels.value is not None)
    assert looked_at == [name]


def test_bent_paint_under_two_clicks_is_told_at_once_and_r_mends_it(bent, hand_on, qtbot):
    services, hand = bent.services, hand_on(bent)
    told = heard(services)
    qtbot.waitUntil(lambda: services.label_check.checked is not None)
    hand.draw("Side line top", (102, 300), (858, 300))

    def found() -> list[Rule]:
        return [f.finding.rule for f in services.label_check.shown]

    qtbot.waitUntil(lambda: Rule.BESIDE_PAINT in found())
    assert any("Press R" in text and "5 px" in text for text in told)
    assert BENT in {notice.key for notice in services.state.notices}
    services.selection.select_class("Side line top")
    hand.key(Qt.Key.Key_R)
    qtbot.waitUntil(lambda: len(services.state.annotation.get("Side line top").points) > 2)
    qtbot.waitUntil(lambda: services.label_check.checked is not None)
    assert Rule.BESIDE_PAINT not in found()
    qtbot.waitUntil(lambda: BENT not in {notice.key for notice in services.state.notices})


def test_the_remedy_puts_its_points_along_the_paint(bent, hand_on, qtbot):
    """One key, or the button of the list, whatever else is chosen; and one step of undo."""
    services, hand = bent.services, hand_on(bent)
    qtbot.waitUntil(lambda: services.label_check.checked is not None)
    hand.draw("Side line top", (102, 300), (858, 300))
    two = services.state.annotation

    def found() -> list[StoredFinding]:
        every = services.label_check.shown
        return [f for f in every if f.finding.rule is Rule.BESIDE_PAINT]

    qtbot.waitUntil(lambda: bool(found()))
    services.selection.select_class("Side line bottom")
    remedy = found()[0].finding.remedies[0]
    bent.label_check.apply(found()[0], remedy)
    qtbot.waitUntil(lambda: len(services.state.annotation.get("Side line top").points) > 2)
    qtbot.waitUntil(lambda: services.label_check.checked is not None and not found())
    hand.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert services.state.annotation == two


def test_a_line_clicked_where_there_is_none_is_no_bent_one(bent, hand_on, qtbot):
    services, hand = bent.services, hand_on(bent)
    hand.draw("Side line top", (102, 400), (858, 420))
    qtbot.waitUntil(lambda: services.line_pixels.value is not None)
    qtbot.waitUntil(lambda: services.label_check.checked is not None)
    assert Rule.BESIDE_PAINT not in [f.finding.rule for f in services.label_check.shown]
