"""A menu of the field's classes, for commands that need one."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QWidget

from procc_annotator.field.model import Field
from procc_annotator.gui.element_keys import key_text
from procc_annotator.gui.panels.states import class_swatch, class_title

_WITHOUT_GEOMETRY = "Without geometry"


def class_menu(
    parent: QWidget | None,
    field: Field,
    title: str,
    *,
    first: Sequence[str] = (),
    disabled: Collection[str] = (),
    chosen: Callable[[str], None],
) -> QMenu:
    """A menu of all classes: suggestions, then a submenu for every group of the field.

    Args:
        parent: owner of the menu.
        field: its groups, in their order, then its classes without geometry.
        title: of the menu, as in "Change class to".
        first: class names offered at the top, best first; they may be unknown to the field.
        disabled: class names that cannot be chosen now; they stay where they are, in grey.
        chosen: called with the class name of the chosen entry.

    Returns:
        The menu; the ``data()`` of its entries are class names.
    """
    menu = QMenu(title, parent)
    for name in dict.fromkeys(first):
        _add(menu, field, name, disabled, chosen)
    if first:
        menu.addSeparator()
    groups: dict[str, list[str]] = {}
    for element in field.elements:
        groups.setdefault(element.group, []).append(element.name)
    if field.classes_without_geometry:
        groups.setdefault(_WITHOUT_GEOMETRY, []).extend(field.classes_without_geometry)
    for group, names in groups.items():
        submenu = menu.addMenu(_literal(group))
        for name in names:
            _add(submenu, field, name, disabled, chosen)
        submenu.setEnabled(any(a.isEnabled() for a in submenu.actions()))
    return menu


def _add(
    menu: QMenu,
    field: Field,
    name: str,
    disabled: Collection[str],
    chosen: Callable[[str], None],
) -> QAction:
    text = _literal(class_title(field, name))
    if keys := key_text(field, name):
        # As text only: the keys themselves belong to choosing an element to draw.
        text += "\t" + keys
    action = menu.addAction(class_swatch(field, name), text)
    action.setData(name)
    action.setIconVisibleInMenu(True)
    action.setEnabled(name not in disabled)
    action.triggered.connect(lambda: chosen(name))
    return action


def _literal(text: str) -> str:
    """Text whose ampersands are shown instead of marking a key."""
    return text.replace("&", "&&")
