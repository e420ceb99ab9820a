"""Text is read on whatever is behind it, in both themes (WCAG 2, 1.4.3)."""

from collections.abc import Iterator
from itertools import product

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QApplication, QCheckBox, QListWidgetItem, QRadioButton, QWidget

from procc_annotator.gui.panels.review import CommentList
from procc_annotator.gui.theme import blend, contrast, is_dark, muted, palette, wear

ROLE = QPalette.ColorRole
TEXTS = (ROLE.WindowText, ROLE.PlaceholderText, ROLE.Link)
GROUNDS = (ROLE.Window, ROLE.Base, ROLE.AlternateBase, ROLE.Button, ROLE.ToolTipBase)


@pytest.mark.parametrize("dark", [False, True])
def test_every_text_has_enough_contrast(dark):
    colours = palette(dark)
    chosen = blend(colours.color(ROLE.Window), colours.color(ROLE.Highlight), 0.16)
    pairs = {
        f"{text.name} on {ground.name}": (colours.color(text), colours.color(ground))
        for text, ground in product(TEXTS, GROUNDS)
    }
    pairs["chosen text"] = colours.color(ROLE.HighlightedText), colours.color(ROLE.Highlight)
    pairs["details of the judged source"] = colours.color(ROLE.PlaceholderText), chosen
    for ground in (ROLE.Window, ROLE.Base):
        pairs[f"hint on {ground.name}"] = muted(colours), colours.color(ground)
    found = {name: round(contrast(*pair), 2) for name, pair in pairs.items()}
    assert {name: value for name, value in found.items() if value < 4.5} == {}


@pytest.fixture
def application(qapp) -> Iterator[QApplication]:
    """Wears afterwards what it wore before."""
    style, before = qapp.style().name(), is_dark(qapp.palette())
    qapp.setStyle("Fusion")
    yield qapp
    qapp.setStyle(style)
    wear(qapp, before)


def comments() -> CommentList:
    made = CommentList()
    item = QListWidgetItem("")
    item.setCheckState(Qt.CheckState.Unchecked)
    made.addItem(item)
    return made


@pytest.mark.parametrize("dark", [False, True])
@pytest.mark.parametrize("make", [QCheckBox, QRadioButton, comments])
def test_a_box_that_is_not_ticked_is_seen(application, qtbot, make, dark):
    """Its edge stands out from what is around it and from what is within (WCAG 2, 1.4.11)."""
    wear(application, dark)
    parent = QWidget()  # which paints the ground
    qtbot.addWidget(parent)
    box = make()
    box.setParent(parent)
    box.setGeometry(20, 20, 60, 40)
    parent.resize(100, 80)
    picture = parent.grab().toImage()
    ground = picture.pixelColor(5, 5)
    assert ground == palette(dark).color(ROLE.Window)
    left = 24 if isinstance(box, CommentList) else 18  # within the list's own frame
    colours = [picture.pixelColor(x, y) for x, y in product(range(left, 50), range(24, 56))]
    within = palette(dark).color(ROLE.Base)
    seen = [c for c in colours if min(contrast(c, ground), contrast(c, within)) >= 3]
    assert len(seen) >= 8  # of a circle the pixels that are not shared with what is around
