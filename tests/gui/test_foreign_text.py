"""Names and texts of files are shown as they are, also where they look like HTML."""

import json
import os

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication, QLabel, QToolTip

from tests.gui.conftest import all_done

pytestmark = pytest.mark.skipif(os.name == "nt", reason="no such names of files on this system")

EVIL = "<img src=a>x"


@pytest.mark.new_window
def test_labels_and_tips_show_foreign_text_as_it_is(make_window, dataset, qtbot):
    (dataset / "frame_0.png").rename(dataset / f"{EVIL}.png")
    point = [{"x": 0.5, "y": 0.5}]
    (dataset / f"{EVIL}.json").write_text(json.dumps({EVIL: point, "Middle line": point}))
    window = make_window(dataset)
    cameras = dataset / EVIL
    cameras.mkdir()
    (cameras / "camera_frame_1.json").write_text("{" + EVIL)
    window.services.camera_sources.load_cameras(cameras)
    all_done(qtbot)
    shown = [label for label in window.findChildren(QLabel) if EVIL in label.text()]
    assert shown
    for label in window.findChildren(QLabel):
        label.ensurePolished()
        if label.textFormat() != Qt.TextFormat.PlainText:  # a text of this program, with places
            assert "<img" not in label.text(), label.objectName()
    QToolTip.showText(QPoint(5, 5), EVIL, window)
    (tip,) = (w for w in QApplication.topLevelWidgets() if w.inherits("QTipLabel"))
    assert (tip.text(), tip.textFormat()) == (EVIL, Qt.TextFormat.PlainText)
    QToolTip.hideText()
