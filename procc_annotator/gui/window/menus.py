"""The table of actions as menus and shortcuts, ticked as the state is; the menu of the canvas."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import asdict
from functools import partial
from operator import attrgetter
from typing import cast

from PySide6.QtCore import QObject, QPointF, Qt
from PySide6.QtGui import QAction, QActionGroup, QHelpEvent, QKeySequence
from PySide6.QtWidgets import QMainWindow, QMenu, QMenuBar, QSizePolicy, QToolTip, QWidget

from procc_annotator.annotation import points_px
from procc_annotator.dataset.review import StoredFinding
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import touching_elements
from procc_annotator.gui.actions import ACTIONS, MENUS, ActionSpec
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.commands.element_edits import ElementEdits
from procc_annotator.gui.commands.ghosts import GhostCommands
from procc_annotator.gui.commands.label_check import LabelCheckCommands
from procc_annotator.gui.keymap import NATIVE, USUAL, Keymap, key_text
from procc_annotator.gui.panels.element_states import class_swatch, class_title
from procc_annotator.gui.panels.finding_rows import reasons_of
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.store import When
from procc_annotator.translation import tr, tr_count, word


class Actions:
    """The table as QActions, in menus, bound to what they call."""

    def __init__(self, window: QMainWindow, canvas: QWidget) -> None:
        self._by_name: dict[str, QAction] = {}
        self._reasons: dict[str, str] = {}
        self._texts: dict[str, str] = {}
        self._groups: dict[str, QActionGroup] = {}
        self.bar = QMenuBar(window)
        preferred = QSizePolicy.Policy.Preferred  # where there is no room menus go behind an arrow
        self.bar.setSizePolicy(preferred, preferred)
        self.menus: dict[str, QMenu] = {
            name: self.bar.addMenu(said) for name, said in mnemonics(MENUS).items()
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
        """Name the step of an action behind its text; None: no step."""
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


_REACH = 32.0  # screen px: a sign stands next to its point, on the side with room


class FindingTips(QObject):
    """Answers when the canvas is asked for a tip."""

    def __init__(self, services: Services, canvas: Canvas) -> None:
        super().__init__(canvas)
        self._services, self._canvas = services, canvas
        canvas.tipWanted.connect(self._tell)

    def _tell(self, event: QHelpEvent) -> None:
        if text := self.tip_at(QPointF(event.pos())):
            QToolTip.showText(event.globalPos(), text, self._canvas.viewport())

    def tip_at(self, cursor: QPointF) -> str:
        """Return what was found at a place of the viewport; empty where no sign is."""
        if self._canvas.drawing.hidden:
            return ""
        if (comment := self._canvas.comment_at(cursor)) is not None:
            return comment.text
        near = [f for f in self._services.label_check.shown if self._stands_at(f, cursor)]
        return reasons_of(near)

    def _stands_at(self, found: StoredFinding, cursor: QPointF) -> bool:
        size, annotation = self._services.state.picture_size, self._services.state.annotation
        for name, row in found.places:
            drawn = annotation.get(name)
            if drawn is None or size is None or row >= len(drawn.points):
                continue
            at = self._canvas.to_view(*points_px(drawn, size)[row].tolist())
            if (at - cursor).manhattanLength() <= _REACH:
                return True
        return False


_POINT = ("delete", "select_all")
_WHOLE = ("regularise", "close_gaps", "reverse", "duplicate", "delete_element", "comment_here")
_FRAME = ("copy_previous", "regularise_all", "close_gaps", "versions", "comment_here")
_UNCONFIRMED = ("confirm_all", "drop_unconfirmed")
_LONGEST_REASON = 90
_DRAWING = ("finish", "finish_stay", "back", "cancel")


def canvas_menu(
    parent: QWidget,
    services: Services,
    actions: Actions,
    element_edits: ElementEdits,
    label_check: LabelCheckCommands | None = None,
    *,
    drawing: bool = False,
    on_ground: bool = False,
    ghost_tasks: GhostCommands | None = None,
    ghost: str | None = None,
) -> QMenu:
    """The menu for what is selected, for the polyline that is being drawn, or for the frame
    (``on_ground``), with what can be done to a ``ghost`` (its class) that lies there; the canvas
    selects what is under the cursor first."""
    menu = _CanvasMenu(parent, services, actions, element_edits)
    name, annotation = services.state.selected_class, services.state.annotation
    waiting = annotation.get_unconfirmed(name) if name is not None else None
    polyline = waiting or (annotation.get(name) if name is not None else None)
    if drawing:
        menu.addSection(tr("Drawing {title}", title=menu.title_of(name or "")))
        menu.add(*_DRAWING)
    elif on_ground or name is None or polyline is None or not polyline.points:
        if ghost_tasks is not None and ghost is not None:
            menu.add_ghost(ghost_tasks, ghost)
        menu.add(*_FRAME, *(_UNCONFIRMED if annotation.unconfirmed else ()))
        if ghost_tasks is not None:
            menu.add_not_visible(ghost_tasks)
    else:
        title = menu.title_of(name)
        if waiting is not None:
            menu.addSection(tr("{title}, unconfirmed", title=title))
            menu.add("confirm", *_UNCONFIRMED)
        if (point := services.state.selection.point) is not None:
            count = len(services.state.selection.points)
            this = tr("Point {number} of {title}", number=point[1] + 1, title=title)
            menu.addSection(tr_count(count, "{n} point", "{n} points") if count > 1 else this)
            menu.add(*_POINT)
            if count < 2 and 0 < point[1] < len(polyline.points) - 1:
                menu.add_split(name)
        if label_check is not None:
            menu.add_remedies(label_check, name)
        menu.addSection(title)
        menu.add_classes(name)
        menu.add(*_WHOLE)
    return menu


class _CanvasMenu(QMenu):
    """A menu, and the parts it may have."""

    def __init__(
        self, parent: QWidget, services: Services, actions: Actions, element_edits: ElementEdits
    ) -> None:
        super().__init__(parent)
        self._services, self._actions, self._edits = services, actions, element_edits
        self._state = services.state

    def title_of(self, name: str) -> str:
        return class_title(self._state.field, name)

    def add(self, *names: str) -> None:
        for name in names:
            self.addAction(self._actions[name])

    def _add_choice(
        self,
        title: str,
        chosen: Callable[[str], None],
        first: Sequence[str],
        disabled: Collection[str],
    ) -> None:
        field, keymap = self._state.field, self._state.keymap
        self.addMenu(
            class_menu(
                self, field, title, first=first, disabled=disabled, keymap=keymap, chosen=chosen
            )
        )

    def add_split(self, name: str) -> None:
        touching = touching_elements(self._state.field, name)
        free = [e for e in touching if self._state.annotation.get(e) is None]
        title, annotated = tr("Split here: the rest becomes"), self._state.annotation.annotated
        self._add_choice(title, self._edits.split, free, annotated)

    def add_remedies(self, label_check: LabelCheckCommands, name: str) -> None:
        """Add remedies for the findings of an element, the surest first."""
        for found in self._services.label_check.shown:
            if name not in found.finding.elements:
                continue
            reason = tr(found.finding.reason)
            short = reason
            if len(reason) > _LONGEST_REASON:
                short = f"{reason[: _LONGEST_REASON - 1]}…"
            self.addSection(short).setToolTip(reason)
            for remedy in found.finding.remedies:
                text = tr(remedy.text)
                text, do = text[:1].upper() + text[1:], partial(label_check.apply, found, remedy)
                self.addAction(text, do).setToolTip(reason)
            if (frame := self._state.frame) is not None:
                ignore = partial(label_check.ignore, frame.name, found)
                self.addAction(tr("Ignore this finding"), ignore)

    def add_ghost(self, tasks: GhostCommands, name: str) -> None:
        self.addSection(tr("Ghost of {title}", title=self.title_of(name)))
        self.addAction(tr("Accept"), partial(tasks.accept_named, name))
        self.addAction(tr("Look closely"), partial(self._services.ghosts.go_to, name))
        self.addAction(tr("Not visible here"), partial(tasks.set_not_visible, name, True))
        self.addSection(tr("Frame"))

    def add_not_visible(self, tasks: GhostCommands) -> None:
        """Add the elements said to be not visible: choosing one takes that back."""
        if names := tasks.not_visible():
            hidden = self.addMenu(tr("Not visible here: take back"))
            for name in names:
                hidden.addAction(self.title_of(name), partial(tasks.set_not_visible, name, False))

    def add_classes(self, name: str) -> None:
        """Add menus that give an element another class, or join it to another element."""
        field, edits = self._state.field, self._edits
        met = touching_elements(field, name)  # once: it takes time on large fields
        likely = list(dict.fromkeys([*edits.symmetric_classes(), *met]))[:4]
        words = tr("Change class to (swaps with an annotated one)")
        self._add_choice(words, edits.change_class, likely, (name,))
        if others := [c for c in self._state.annotation.annotated if c != name]:
            every = [e.name for e in field.elements] + list(field.classes_without_geometry)
            first = [c for c in others if c in met]
            disabled = [c for c in every if c not in others]
            self._add_choice(tr("Merge into"), edits.merge_into, first, disabled)


_WITHOUT_GEOMETRY = word("Without geometry")


def class_menu(
    parent: QWidget | None,
    field: Field,
    title: str,
    *,
    first: Sequence[str] = (),
    disabled: Collection[str] = (),
    keymap: Keymap = USUAL,
    chosen: Callable[[str], None],
) -> QMenu:
    """A menu of all classes: suggestions, then a submenu for every group of the field, in their
    order, then its classes without geometry. The ``data()`` of its entries are class names.

    Args:
        title: of the menu, as in "Change class to".
        first: class names offered at the top, best first; they may be unknown to the field.
        disabled: class names that cannot be chosen now; they stay where they are, in grey.
        keymap: of the keys next to the names.
        chosen: called with the class name of the chosen entry.
    """
    menu = QMenu(title, parent)
    for name in dict.fromkeys(first):
        _add(menu, field, name, disabled, keymap, chosen)
    if first:
        menu.addSeparator()
    groups: dict[str, list[str]] = {}
    for element in field.elements:
        groups.setdefault(element.group, []).append(element.name)
    if field.classes_without_geometry:
        groups.setdefault(_WITHOUT_GEOMETRY, []).extend(field.classes_without_geometry)
    for group, names in groups.items():
        submenu = menu.addMenu(_literal(tr(group)))
        for name in names:
            _add(submenu, field, name, disabled, keymap, chosen)
        submenu.setEnabled(any(a.isEnabled() for a in submenu.actions()))
    return menu


def _add(
    menu: QMenu,
    field: Field,
    name: str,
    disabled: Collection[str],
    keymap: Keymap,
    chosen: Callable[[str], None],
) -> QAction:
    text = _literal(class_title(field, name))
    if keys := key_text(field, name, keymap):
        # As text only: the keys themselves belong to choosing an element to draw.
        text += "\t" + keys
    action = menu.addAction(class_swatch(field, name), text)
    action.setData(name)
    action.setIconVisibleInMenu(True)
    action.setEnabled(name not in disabled)
    action.triggered.connect(partial(chosen, name))
    return action


def _literal(text: str) -> str:
    """Escape ampersands, which mark keys in menus."""
    return text.replace("&", "&&")
