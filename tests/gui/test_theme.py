"""Text is read on whatever is behind it, in both themes (WCAG 2, 1.4.3)."""

from __future__ import annotations

from itertools import product

import pytest
from PySide6.QtGui import QPalette

from procc_annotator.gui.plots.looks import contrast
from procc_annotator.gui.theme import blend, muted, palette

ROLE = QPalette.ColorRole
TEXTS = (ROLE.WindowText, ROLE.PlaceholderText, ROLE.Link)
GROUNDS = (ROLE.Window, ROLE.Base, ROLE.AlternateBase, ROLE.Button, ROLE.ToolTipBase)


@pytest.mark.parametrize("dark", [False, True])
def test_every_text_has_enough_contrast(dark: bool) -> None:
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
