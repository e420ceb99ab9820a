"""The table of actions as menus and shortcuts, bound to what they call, ticked as things are."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import asdict
from operator import attrgetter
from typing import cast

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QAction, QActionGroup, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu, QWidget

from procc_annotator.gui.actions import ACTIONS, MENUS, ActionSpec
from procc_annotator.gui.keymap import NATIVE, Keymap
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.store import When
from procc_annotator.translation import tr


class Actions:
    """The table as QActions, in menus, bound to what they call."""

    def __init__(self, window: QMainWindow, canvas: QWidget) -> None:
        self._by_name: dict[str, QAction] = {}
        self._reasons: dict[str, str] = {}
        self._texts: dict[str, str] = {}
        self._groups: dict[str, QActionGroup] = {}
        self.menus: dict[str, QMenu] = {
            name: window.menuBar().addMenu(said) for name, said in mnemonics(MENUS).items()
        }
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

    def set_keys(self, keymap: Keymap) -> None:
        """Have other keys call the actions."""
        for spec in ACTIONS:
            action = self._by_name[spec.name]
            reason = self._reasons.get(spec.name, "")
            _give_keys(action, spec, keymap.of_action(spec))
            self.set_reason(spec.name, reason)

    def set_checked(self, name: str, checked: bool) -> None:
        """Show a state that changed elsewhere, without calling anything."""
        action = self._by_name[name]
        if action.isChecked() != checked:
            action.setChecked(checked)  # slots hang on `triggered`, which only a person sends

    def set_step(self, name: str, step: str | None) -> None:
        """Say behind an action's text which step it is about; None: there is none."""
        action = self._by_name[name]
        text = self._texts.setdefault(name, action.text())
        said = tr("{action}: {step}", action=text, step=step).replace("&", "&&")
        action.setText(said if step else text)

    def set_reason(self, name: str, reason: str) -> None:
        """Say in an action's tip why it does not do what it says; empty: it does."""
        action = self._by_name[name]
        tip = action.toolTip().split("\n")[0]
        self._reasons[name] = reason
        action.setToolTip(f"{tip}\n{reason}" if reason else tip)

    def _make(self, spec: ActionSpec, window: QMainWindow, canvas: QWidget) -> QAction:
        action = QAction(tr(spec.text.lstrip("-")), window)
        action.setObjectName(f"action_{spec.name}")
        _give_keys(action, spec, spec.keys)
        action.setAutoRepeat(spec.repeat)
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
            menu = self.menus[path] = self._menu(parent).addMenu(tr(title))
        return menu


def in_menu(menu: str, title: str) -> str:
    """An action's title behind that of its submenu, if it stands in one."""
    _, _, place = menu.partition("/")
    return tr("{menu}: {action}", menu=tr(place), action=title) if place else title


def _give_keys(action: QAction, spec: ActionSpec, keys: Sequence[str]) -> None:
    """Have keys call an action, and its tip name the first of them."""
    action.setShortcuts([QKeySequence(key) for key in keys])
    first = f" ({action.shortcut().toString(NATIVE)})" if keys else ""
    action.setToolTip(f"{tr(spec.tip)}{first}")


def mnemonics(titles: Iterable[str]) -> dict[str, str]:
    """Titles of menus as they are said, each with the letter that opens it: the first that no menu
    before has; where a language has none, that of the English title stands behind."""
    taken: set[str] = set()
    said = {}
    for title in titles:
        words = tr(title)
        bare = not any(map(_is_key, words))
        letters = filter(_is_key, title if bare else words)
        key = next((letter for letter in letters if letter.lower() not in taken), "")
        taken.add(key.lower())
        said[title] = f"{words}(&{key.upper()})" if bare else words.replace(key, f"&{key}", 1)
    return said


def _is_key(letter: str) -> bool:
    return letter.isascii() and letter.isalpha()


class ActionStates(QObject):
    """Keeps the ticks of the menus in step with the state."""

    def __init__(self, services: Services, actions: Actions, parent: QObject) -> None:
        super().__init__(parent)
        self._services = services
        self._actions = actions
        services.store.watch(lambda s: (s.workspace, select.mode(s)), self._show_mode)
        services.blind_lock.refused.connect(self._show_mode)
        services.store.watch(select.annotation, self._show_steps, When.AFTER_PAINT)
        services.store.watch(lambda s: s.keymap, self._take_keys)
        services.store.watch(lambda s: s.setup, self._show_evaluation)
        services.live_fit.changed.connect(self._show_live_fit)
        services.disagreement.changed.connect(self._show_maps)
        services.uncertainty.changed.connect(self._show_maps)

    def _show_mode(self) -> None:
        services, actions = self._services, self._actions
        actions.set_checked("draw_mode", services.state.mode == "draw")
        actions.set_checked("edit_mode", services.state.mode == "edit")
        actions.set_checked("blind", services.state.blind)
        for name, on in asdict(services.state.options).items():
            actions.set_checked(name, on)
        reason = services.blind_lock.reason
        actions.set_checked("lock_blind", bool(reason))
        actions.set_reason("blind", reason)
        actions.set_reason("live_fit", services.blind_lock.no_fit)

    def _take_keys(self) -> None:
        self._actions.set_keys(self._services.state.keymap)

    def _show_steps(self) -> None:
        undone, redone = self._services.editing.steps
        self._actions.set_step("undo", undone and tr(undone))
        self._actions.set_step("redo", redone and tr(redone))

    def _show_evaluation(self) -> None:
        setup = self._services.state.setup
        self._actions.set_checked(f"protocol_{setup.protocol}", True)
        self._actions.set_checked(f"off_plane_{setup.off_plane}", True)

    def _show_live_fit(self) -> None:
        self._actions.set_checked("live_fit", self._services.live_fit.wanted)

    def _show_maps(self) -> None:
        self._actions.set_checked("disagreement", self._services.disagreement.enabled)
        self._actions.set_checked("uncertainty", self._services.uncertainty.enabled)
