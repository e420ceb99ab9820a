"""States of elements are told apart on both themes, without colour, and by every eye."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPalette
from PySide6.QtWidgets import QApplication

from procc_annotator.field.model import colour_difference
from procc_annotator.gui.panels.element_states import (
    WORDS,
    ElementState,
    paint_symbol,
    state_colour,
)
from procc_annotator.gui.panels.field_map.painting import ground_colour
from procc_annotator.gui.theme import alarm_colours, contrast, palette
from procc_annotator.interaction import palette as tones
from tests.unit.interaction.test_palette import SEEN_BY, as_seen

ROLE = QPalette.ColorRole
SIDE = 32
SHOWN = [state for state in ElementState if state is not ElementState.UNTOUCHED]


@pytest.mark.parametrize("dark", [False, True])
@pytest.mark.parametrize("state", ElementState)
def test_a_sign_is_seen_on_every_ground(
    qapp: QApplication, state: ElementState, dark: bool
) -> None:
    """WCAG 2, 1.4.11: at least 3:1."""
    colours = palette(dark)
    grounds = {
        role.name: colours.color(role) for role in (ROLE.Base, ROLE.Window, ROLE.AlternateBase)
    }
    grounds["field map"] = ground_colour(colours)
    sign = state_colour(state, colours)
    found = {name: round(contrast(sign, ground), 2) for name, ground in grounds.items()}
    assert min(found.values()) >= 3.0, (sign.name(), found)


@pytest.mark.parametrize("dark", [False, True])
def test_a_warning_is_read(qapp: QApplication, dark: bool) -> None:
    ground, text = alarm_colours(palette(dark))
    assert contrast(QColor(ground), QColor(text)) >= 4.5


def drawn(state: ElementState) -> np.ndarray:
    """A sign in black on white, as 0 and 1."""
    image = QImage(SIDE, SIDE, QImage.Format.Format_Grayscale8)
    image.fill(Qt.GlobalColor.white)
    painter = QPainter(image)
    paint_symbol(painter, QRectF(0, 0, SIDE, SIDE), state, QColor("black"))
    painter.end()
    pixels = np.frombuffer(image.constBits(), np.uint8).reshape(SIDE, image.bytesPerLine())
    return pixels[:, :SIDE] < 128


def test_every_state_has_a_sign_of_its_own_shape(qapp: QApplication) -> None:
    """The share of the pixels of two signs that only one of them has."""
    signs = {state: drawn(state) for state in SHOWN}
    assert all(sign.sum() > 15 for sign in signs.values())
    apart = {
        (a.name, b.name): (signs[a] ^ signs[b]).sum() / (signs[a] | signs[b]).sum()
        for a, b in itertools.combinations(SHOWN, 2)
    }
    assert min(apart.values()) > 0.4, min(apart, key=apart.get)
    assert len({WORDS[state] for state in SHOWN}) == len(SHOWN)


@pytest.mark.parametrize("eyes", SEEN_BY)
def test_tones_of_states_differ_for_every_eye(eyes: str) -> None:
    """About 2 can just be seen when two tones lie side by side."""
    kept = {**tones.STATUS_COLOURS, "unconfirmed": tones.UNCONFIRMED, "ghost": tones.GHOST}
    apart = {
        (a, b): round(colour_difference(as_seen(kept[a], eyes), as_seen(kept[b], eyes)), 1)
        for a, b in itertools.combinations(kept, 2)
    }
    assert min(apart.values()) >= 10, sorted(apart.items(), key=lambda pair: pair[1])[:3]
