"""The context menu of the canvas, and tips of findings under the cursor."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from functools import partial

from PySide6.QtCore import QObject, QPointF
from PySide6.QtGui import QAction, QHelpEvent
from PySide6.QtWidgets import QMenu, QToolTip, QWidget

from procc_annotator.annotation import points_px
from procc_annotator.calibration.label_check.finding import Remedy
from procc_annotator.dataset.review import StoredFinding
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import touching_elements
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.commands.element_edits import ElementEdits
from procc_annotator.gui.commands.ghosts import GhostCommands
from procc_annotator.gui.commands.label_check import LabelCheckCommands
from procc_annotator.gui.element_keys import key_text
from procc_annotator.gui.keymap import USUAL, Keymap
from procc_annotator.gui.panels.element_states import class_swatch, class_title
from procc_annotator.gui.panels.findings.finding_rows import reasons_of
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.window.menus import Actions
from procc_annotator.translation import tr, tr_count, word

_REACH = 32.0  # screen px: a sign stands beside its point, on whichever side there is room


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
_WHOLE = ("regularise", "close_gaps", "reverse", "duplicate", "delete_element")
_FRAME = ("copy_previous", "regularise_all", "close_gaps", "versions")
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
    menu = QMenu(parent)

    def add(*names: str) -> None:
        for each in names:
            menu.addAction(actions[each])

    name, annotation = services.state.selected_class, services.state.annotation
    waiting = annotation.get_unconfirmed(name) if name is not None else None
    polyline = waiting or (annotation.get(name) if name is not None else None)
    if drawing:
        menu.addSection(tr("Drawing {title}", title=class_title(services.state.field, name or "")))
        add(*_DRAWING)
    elif on_ground or name is None or polyline is None or not polyline.points:
        if ghost_tasks is not None and ghost is not None:
            _add_ghost(menu, services, ghost_tasks, ghost)
        add(*_FRAME, *(_UNCONFIRMED if annotation.unconfirmed else ()))
        if ghost_tasks is not None:
            _add_not_visible(menu, services, ghost_tasks)
    else:
        title = class_title(services.state.field, name)
        if waiting is not None:
            menu.addSection(tr("{title}, unconfirmed", title=title))
            add("confirm", *_UNCONFIRMED)
        if (point := services.state.selection.point) is not None:
            count = len(services.state.selection.points)
            this = tr("Point {number} of {title}", number=point[1] + 1, title=title)
            menu.addSection(tr_count(count, "{n} point", "{n} points") if count > 1 else this)
            add(*_POINT)
            if count < 2 and 0 < point[1] < len(polyline.points) - 1:
                _add_split(menu, services, element_edits, name)
        _add_remedies(menu, services, label_check, name)
        menu.addSection(title)
        add_class_menus(menu, services, element_edits)
        add(*_WHOLE)
    return menu


def _add_split(menu: QMenu, services: Services, element_edits: ElementEdits, name: str) -> None:
    free = [
        e
        for e in touching_elements(services.state.field, name)
        if services.state.annotation.get(e) is None
    ]
    menu.addMenu(
        class_menu(
            menu,
            services.state.field,
            tr("Split here: the rest becomes"),
            first=free,
            disabled=services.state.annotation.annotated,
            keymap=services.state.keymap,
            chosen=element_edits.split,
        )
    )


def _add_remedies(
    menu: QMenu, services: Services, label_check: LabelCheckCommands | None, name: str
) -> None:
    """Add remedies for the findings of an element, the surest first."""
    concerned = [f for f in services.label_check.shown if name in f.finding.elements]
    if label_check is None:
        return
    for found in concerned:
        reason = tr(found.finding.reason)
        short = reason if len(reason) <= _LONGEST_REASON else f"{reason[: _LONGEST_REASON - 1]}…"
        heading = menu.addSection(short)
        heading.setToolTip(reason)
        for remedy in found.finding.remedies:
            text = tr(remedy.text)
            action = menu.addAction(text[:1].upper() + text[1:])
            action.setToolTip(reason)
            action.triggered.connect(partial(_apply, label_check, found, remedy))
        action = menu.addAction(tr("Ignore this finding"))
        action.triggered.connect(partial(_ignore, label_check, services, found))


def _apply(label_check: LabelCheckCommands, found: StoredFinding, remedy: Remedy) -> None:
    label_check.apply(found, remedy)


def _ignore(label_check: LabelCheckCommands, services: Services, found: StoredFinding) -> None:
    if services.state.frame is not None:
        label_check.ignore(services.state.frame.name, found)


def _add_ghost(menu: QMenu, services: Services, tasks: GhostCommands, name: str) -> None:
    menu.addSection(tr("Ghost of {title}", title=class_title(services.state.field, name)))
    menu.addAction(tr("Accept"), lambda: tasks.accept_named(name))
    menu.addAction(tr("Look closely"), lambda: services.ghosts.go_to(name))
    menu.addAction(tr("Not visible here"), lambda: tasks.set_not_visible(name, True))
    menu.addSection(tr("Frame"))


def _add_not_visible(menu: QMenu, services: Services, tasks: GhostCommands) -> None:
    """The elements said to be not visible: choosing one takes that back."""
    names = tasks.not_visible()
    if names:
        hidden = menu.addMenu(tr("Not visible here: take back"))
        for name in names:
            take_back = partial(tasks.set_not_visible, name, False)
            hidden.addAction(class_title(services.state.field, name)).triggered.connect(take_back)


def add_class_menus(menu: QMenu, services: Services, element_edits: ElementEdits) -> None:
    """Submenus that give the selected element another class, or join it to another element."""
    field, name = services.state.field, services.state.selected_class or ""
    likely = list(element_edits.symmetric_classes())
    met = touching_elements(field, name)  # worked out once: it takes time on large fields
    likely += [c for c in met if c not in likely]
    menu.addMenu(
        class_menu(
            menu,
            field,
            tr("Change class to (swaps with an annotated one)"),
            first=likely[:4],
            disabled=(name,),
            keymap=services.state.keymap,
            chosen=element_edits.change_class,
        )
    )
    others = [c for c in services.state.annotation.annotated if c != name]
    if others:
        every = [e.name for e in field.elements] + list(field.classes_without_geometry)
        menu.addMenu(
            class_menu(
                menu,
                field,
                tr("Merge into"),
                first=[c for c in others if c in met],
                disabled=[c for c in every if c not in others],
                keymap=services.state.keymap,
                chosen=element_edits.merge_into,
            )
        )


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
    """A menu of all classes: suggestions, then a submenu for every group of the field.

    Args:
        parent: owner of the menu.
        field: its groups, in their order, then its classes without geometry.
        title: of the menu, as in "Change class to".
        first: class names offered at the top, best first; they may be unknown to the field.
        disabled: class names that cannot be chosen now; they stay where they are, in grey.
        keymap: whose keys stand next to the names.
        chosen: called with the class name of the chosen entry.

    Returns:
        The menu; the ``data()`` of its entries are class names.
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
    action.triggered.connect(lambda: chosen(name))
    return action


def _literal(text: str) -> str:
    """Text whose ampersands are shown instead of marking a key."""
    return text.replace("&", "&&")
