"""Keys of elements, of every shipped field: no action of the window and no held key has them."""

import pytest
from PySide6.QtGui import QKeySequence

from procc_annotator.field.load import field_names, load_field
from procc_annotator.gui.actions import ACTIONS

HELD = ("X", "Z", ",", "Space")


def strokes(keys: str) -> tuple[str, ...]:
    """The combinations of a sequence, one after the other, as Qt writes them."""
    sequence = QKeySequence(keys)
    return tuple(QKeySequence(sequence[i]).toString() for i in range(sequence.count()))


@pytest.mark.parametrize("name", field_names())
def test_no_key_has_two_meanings(name):
    taken = {strokes(keys)[0] for action in ACTIONS for keys in action.keys} | set(HELD)
    own = {e.name: strokes(e.shortcut) for e in load_field(name).elements if e.shortcut}
    for element, keys in own.items():
        assert keys, f"{element}: Qt does not know the key"
        assert all(keys), f"{element}: Qt does not know the key"
        assert keys[0] not in taken, element
        # A key that begins another one's sequence would wait for it, or never let it be heard.
        for other, theirs in own.items():
            assert other == element or theirs[: len(keys)] != keys, (element, other)
