"""Versions are listed newest first, told apart in words, looked at, and one is chosen."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialog, QLabel

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.dataset.records import Version
from procc_annotator.errors import AnnotationError
from procc_annotator.field.load import load_field
from procc_annotator.gui.commands.versions import (
    VersionsDialog,
    comparison,
    difference_words,
)
from procc_annotator.gui.theme import palette

FIELD = load_field("soccer")
SIZE = (640, 360)
LINE = Polyline("Middle line", (Point(0.5, 0.1), Point(0.5, 0.9)))
TOP = Polyline("Side line top", (Point(0.1, 0.2), Point(0.4, 0.2), Point(0.9, 0.2)))
NOW = FrameAnnotation((LINE, TOP))
MOVED = FrameAnnotation((LINE, replace(TOP, points=(Point(0.2, 0.3), *TOP.points[1:]))))
BEFORE = FrameAnnotation((LINE,))
MORE = FrameAnnotation((LINE, TOP, Polyline("Circle central", (Point(0.3, 0.5),))))
CONTENT = {"1": MORE, "2": BEFORE, "3": MOVED, "4": NOW}
ROWS = [
    Version(str(i), "frame", f"Author {i}", 1.7e9 + 60 * i, f"reason {i}") for i in (2, 4, 1, 3)
]


class _Store:
    """Hands out versions, and remembers which were asked for."""

    def __init__(self) -> None:
        self.read: list[str] = []

    def __call__(self, version: str) -> FrameAnnotation:
        self.read.append(version)
        if version not in CONTENT:
            raise AnnotationError("frame.json", "the file is empty, expected an annotation")
        return CONTENT[version]


@pytest.fixture
def store() -> _Store:
    return _Store()


@pytest.fixture
def dialog(qtbot, store) -> VersionsDialog:
    grass = np.full((SIZE[1], SIZE[0], 4), (60, 110, 70, 255), dtype=np.uint8)
    dialog = VersionsDialog(None, ROWS, store, grass, FIELD, SIZE, NOW)
    qtbot.addWidget(dialog)
    dialog.show()
    return dialog


def _note(dialog: VersionsDialog) -> str:
    label = dialog.findChild(QLabel, "versionsNote")
    return label.text()


def _choose(dialog: VersionsDialog, row: int) -> None:
    dialog.list.setCurrentIndex(dialog.model.index(row))


def test_newest_first_with_content_and_difference(dialog):
    lines = [dialog.model.lines(row) for row in range(4)]
    assert [line[1:] for line in lines] == [
        ("Author 4", "reason 4", "2 elements, 5 points  (as now)"),
        ("Author 3", "reason 3", "2 elements, 5 points  (points moved)"),
        ("Author 2", "reason 2", "1 element, 2 points  (−1 element, −3 points)"),
        ("Author 1", "reason 1", "3 elements, 6 points  (+1 element, +1 point)"),
    ]
    assert "2023" in lines[0][0]


def test_the_newest_is_what_is_there_now_and_needs_no_restoring(dialog):
    assert _note(dialog) == "This is what the frame holds now."
    assert not dialog.restore.isEnabled()
    QTest.keyClick(dialog, Qt.Key.Key_Return)
    assert dialog.chosen_id is None


def test_choosing_shows_and_restores(dialog):
    _choose(dialog, 2)
    assert _note(dialog) == (
        "Compared with now: −1 element, −3 points. What differs: Far touchline."
    )
    QTest.mouseClick(dialog.restore, Qt.MouseButton.LeftButton)
    assert dialog.result() == QDialog.DialogCode.Accepted
    assert dialog.chosen_id == "2"


def test_arrows_and_enter_do_too(dialog):
    QTest.keyClick(dialog.list, Qt.Key.Key_Down)
    QTest.keyClick(dialog.list, Qt.Key.Key_Return)
    assert dialog.chosen_id == "3"


def test_closing_chooses_nothing(dialog):
    _choose(dialog, 2)
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    assert not dialog.isVisible()
    assert dialog.result() == QDialog.DialogCode.Rejected
    assert dialog.chosen_id is None


def test_polylines_are_drawn_over_the_picture(dialog):
    _choose(dialog, 3)  # three elements
    more = dialog.preview.grab().toImage()
    _choose(dialog, 2)  # one of them, the line in the middle
    preview = dialog.preview
    image = preview.grab().toImage()
    scale = min(preview.width() / SIZE[0], preview.height() / SIZE[1])
    left = (preview.width() - SIZE[0] * scale) / 2
    top = (preview.height() - SIZE[1] * scale) / 2

    def at(u: float, v: float) -> tuple[int, int]:
        px = u * (SIZE[0] - 1) + 0.5, v * (SIZE[1] - 1) + 0.5
        return int(left + px[0] * scale), int(top + px[1] * scale)

    grass, line = image.pixelColor(*at(0.2, 0.6)), image.pixelColor(*at(0.5, 0.4))
    assert (grass.red(), grass.green(), grass.blue()) == (70, 110, 60)
    assert line.lightness() > grass.lightness() + 60
    assert image.pixelColor(*at(0.6, 0.2)) == grass
    assert more.pixelColor(*at(0.6, 0.2)) != grass


def test_another_annotation_than_the_newest_may_be_the_present_one(qtbot, store):
    dialog = VersionsDialog(None, ROWS, store, None, FIELD, SIZE, BEFORE)
    qtbot.addWidget(dialog)
    assert dialog.model.lines(0)[3] == "2 elements, 5 points  (+1 element, +3 points)"
    assert dialog.restore.isEnabled()


def test_a_version_that_cannot_be_read_says_so(qtbot, store):
    rows = [*ROWS, Version("9", "frame", "Author", 1.0e9, "saved")]
    dialog = VersionsDialog(None, rows, store, None, FIELD, SIZE, NOW)
    qtbot.addWidget(dialog)
    dialog.show()
    _choose(dialog, 4)
    assert dialog.model.lines(4)[3] == "cannot be read"
    assert _note(dialog) == "frame.json: the file is empty, expected an annotation"
    assert not dialog.restore.isEnabled()


def test_versions_are_read_once_and_only_when_in_view(qtbot, store):
    rows = [Version(str(1 + i % 4), "frame", "Author", 1.7e9 + i, "saved") for i in range(500)]
    dialog = VersionsDialog(None, rows, store, None, FIELD, SIZE, NOW)
    qtbot.addWidget(dialog)
    dialog.show()
    dialog.grab()
    seen = len(store.read)
    assert 0 < seen < 30
    dialog.grab()
    assert len(store.read) == seen


def test_without_versions_it_says_so(qtbot, store):
    dialog = VersionsDialog(None, [], store, None, FIELD, SIZE, NOW)
    qtbot.addWidget(dialog)
    dialog.show()
    empty = dialog.findChild(QLabel, "versionsEmpty")
    assert empty.isVisible()
    assert not dialog.list.isVisible()
    assert not dialog.restore.isEnabled()
    assert store.read == []


def test_words_for_what_counts_do_not_tell():
    renamed = FrameAnnotation((replace(LINE, class_name="Side line left"), TOP))
    assert difference_words(renamed, NOW) == "other elements"
    assert difference_words(FrameAnnotation(), NOW) == "−2 elements, −5 points"
    reordered = FrameAnnotation((TOP, LINE))
    assert "another order" in comparison(reordered, NOW, FIELD)
    many = FrameAnnotation(tuple(replace(LINE, class_name=e.name) for e in FIELD.elements[:8]))
    assert comparison(many, FrameAnnotation(), FIELD).endswith(", 4 more.")


@pytest.mark.parametrize("dark", [False, True])
def test_it_fits_its_size_in_both_themes(dialog, dark):
    dialog.setPalette(palette(dark))
    dialog.resize(900, 600)
    assert dialog.minimumSizeHint().width() <= 900
    assert dialog.grab().toImage().pixelColor(3, 3) == palette(dark).window().color()
