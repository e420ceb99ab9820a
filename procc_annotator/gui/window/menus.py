"""The table of actions as menus and shortcuts, bound to what they call."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from operator import attrgetter
from typing import cast

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu, QWidget

from procc_annotator.gui.actions import ACTIONS, MENUS, ActionSpec


class Actions:
    """The table as QActions, in menus, bound to what they call."""

    def __init__(self, window: QMainWindow, canvas: QWidget) -> None:
        self._by_name: dict[str, QAction] = {}
        self._tips: dict[str, str] = {}
        self._groups: dict[str, QActionGroup] = {}
        self.menus: dict[str, QMenu] = {m: window.menuBar().addMenu(_mnemonic(m)) for m in MENUS}
        for spec in ACTIONS:
            action = self._make(spec, window, canvas)
            menu = self._menu(spec.menu)
            if spec.text.startswith("-"):
                menu.addSeparator()
            menu.addAction(action)
            (canvas if spec.scope == "canvas" else window).addAction(action)
            self._by_name[spec.name] = action

    def __getitem__(self, name: str) -> QAction:
        return self._by_name[name]

    def __iter__(self) -> Iterator[QAction]:
        return iter(self._by_name.values())

    def set_checked(self, name: str, checked: bool) -> None:
        """Show a state that changed elsewhere, without calling anything."""
        action = self._by_name[name]
        if action.isChecked() != checked:
            action.setChecked(checked)  # slots hang on `triggered`, which only a person sends

    def set_reason(self, name: str, reason: str) -> None:
        """Say in an action's tip why it does not do what it says; empty: it does."""
        action = self._by_name[name]
        tip = self._tips.setdefault(name, action.toolTip())
        action.setToolTip(f"{tip}\n{reason}" if reason else tip)

    def _make(self, spec: ActionSpec, window: QMainWindow, canvas: QWidget) -> QAction:
        action = QAction(spec.text.lstrip("-"), window)
        action.setObjectName(f"action_{spec.name}")
        action.setShortcuts([QKeySequence(k) for k in spec.keys])
        action.setAutoRepeat(spec.repeat)
        keys = (
            f" ({action.shortcut().toString(QKeySequence.SequenceFormat.NativeText)})"
            if spec.keys
            else ""
        )
        action.setToolTip(f"{spec.tip}{keys}")
        action.setStatusTip("")
        if spec.scope == "canvas":
            action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        if spec.choice:
            self._groups.setdefault(spec.choice, QActionGroup(window)).addAction(action)
        action.setCheckable(spec.checkable)
        action.setChecked(spec.checked)
        slot = cast(Callable[..., object], attrgetter(spec.slot)(window))
        if spec.checkable and not spec.choice:
            action.triggered.connect(lambda checked: slot(*spec.args, checked))
        else:
            action.triggered.connect(lambda: slot(*spec.args))
        return action

    def _menu(self, path: str) -> QMenu:
        menu = self.menus.get(path)
        if menu is None:
            parent, _, title = path.rpartition("/")
            menu = self.menus[path] = self._menu(parent).addMenu(title)
        return menu


def _mnemonic(title: str) -> str:
    return f"&{title}" if title != "Element" else "E&lement"
