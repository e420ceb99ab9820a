"""All classes as a list to search: type a few letters, Enter chooses the best match."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from PySide6.QtCore import QEvent, QModelIndex, QObject, QRect, QSize, Qt
from PySide6.QtGui import QBrush, QFont, QIcon, QResizeEvent
from PySide6.QtWidgets import (
    QHeaderView,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTreeWidget,
    QTreeWidgetItem,
)

from procc_annotator.dataset.review import StoredFinding
from procc_annotator.field.sampling import distances_from
from procc_annotator.gui.canvas.finding_sign import finding_icon
from procc_annotator.gui.keymap import NATIVE, element_keys, short_text
from procc_annotator.gui.panels.element_states import (
    EXPLANATIONS,
    SIDE,
    ElementState,
    class_swatch,
    element_states,
    short_titles,
    symbol_icon,
    words_for,
)
from procc_annotator.gui.panels.finding_rows import findings_by_element, reasons_of
from procc_annotator.gui.panels.widgets import (
    NARROW,
    Index,
    Pages,
    Panel,
    named,
    search_line,
    vbox,
)
from procc_annotator.gui.state.selectors import judged
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import muted
from procc_annotator.interaction.class_choice import match_rank
from procc_annotator.translation import tr, word

NAME, KEY, POINTS, STATUS = range(4)
_CLASS = Qt.ItemDataRole.UserRole
_OTHER_GROUP = word("Without geometry")
_UNKNOWN_GROUP = word("Unknown to the field (unknown classes)")


class _WholeTitles(QStyledItemDelegate):
    """Breaks a title that is wider than its column into lines."""

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        tree = option.widget
        assert isinstance(tree, QTreeWidget)
        whole = not index.parent().isValid()  # a group's title has all columns
        room = tree.width() if whole else tree.columnWidth(NAME) - tree.indentation()
        option.rect = QRect(0, 0, room, 1)
        return super().sizeHint(option, index)


class ElementsPanel(Panel):
    """Every class of the field, and those of the file that the field does not know."""

    def __init__(self, services: Services) -> None:
        super().__init__(services, "elements_panel", (300, 320))
        self._items: dict[str, QTreeWidgetItem] = {}
        self._groups: dict[str, QTreeWidgetItem] = {}
        self._shown: dict[str, tuple[ElementState, int, bool, tuple[StoredFinding, ...]]] = {}
        self._narrow: bool | None = None
        self._room: tuple[object, ...] = ()  # what the widths of the columns follow from
        self._shaded: str | None = None
        self._build()
        self._fill()
        self._follow(
            lambda s: (judged(s), s.selection),
            services.label_check.changed,
            services.ghosts.changed,
            services.review.notVisibleChanged,
        )
        services.store.watch_visible(self, self._show_hover, lambda s: s.hovered_class)
        services.store.watch(lambda s: (s.field, s.keymap), self._take_field)

    def focus_search(self) -> None:
        """Put the keyboard into the search box, its text ready to be replaced."""
        self.search.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self.search.selectAll()

    # --- building ------------------------------------------------------------------------------

    def _build(self) -> None:
        hint = tr("Find an element")
        self.search = search_line(
            hint, "elements_search", self._apply_search, keys=self._search_key
        )
        self.tree = named(QTreeWidget(columnCount=4), "elements_tree", title=tr("Elements"))
        self.tree.setWordWrap(True)
        self.tree.setItemDelegateForColumn(NAME, _WholeTitles(self.tree))
        self.tree.setRootIsDecorated(False)
        self.tree.setHeaderLabels([tr("Element"), tr("Key", "keyboard"), "", ""])
        self.tree.headerItem().setToolTip(POINTS, tr("Annotated points"))
        self.tree.setIndentation(4)
        self.tree.setIconSize(QSize(SIDE, SIDE))
        self.tree.setMouseTracking(True)
        self.tree.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # a click leaves the keys to the canvas
        self.tree.setEditTriggers(QTreeWidget.EditTrigger.NoEditTriggers)
        self.tree.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        header = self.tree.header()
        header.setStretchLastSection(False)
        header.setMinimumSectionSize(4)  # an empty column leaves its room to the names
        header.setSectionResizeMode(NAME, QHeaderView.ResizeMode.Stretch)
        header.sectionResized.connect(self.tree.scheduleDelayedItemsLayout)
        for column in (KEY, POINTS, STATUS):
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.ResizeToContents)
        self.tree.itemClicked.connect(self._choose)
        self.tree.itemActivated.connect(self._choose)
        self.tree.itemEntered.connect(
            lambda item: self._services.selection.hover_class(item.data(0, _CLASS))
        )
        self.tree.viewport().installEventFilter(self)
        self._pages = Pages(self.tree, "elements_empty")
        self.nothing = self._pages.empty
        vbox(self.search, self._pages, of=self, spacing=4, margins=2)

    def _take_field(self) -> None:
        """List the classes of another field, or those of the same with other dimensions."""
        if self._listed_classes() != self._filled:
            self._outdated = True
            self._refresher.request()

    def _listed_classes(self) -> tuple[object, ...]:
        field = self._services.state.field
        looks = ((e.name, e.title, e.group, e.colour, e.shortcut) for e in field.elements)
        return (*looks, field.classes_without_geometry, self._services.state.keymap)

    def _fill(self) -> None:
        field = self._services.state.field
        self._filled, self._outdated = self._listed_classes(), False
        self.tree.clear()
        for known in (self._items, self._groups, self._shown):
            known.clear()
        self._room = ()
        keys = element_keys(field, self._services.state.keymap)
        self._keys = {name: key.toString(NATIVE) for name, key in keys.items()}
        self._short = short_titles(field)
        listed = {e.name: e.group for e in field.elements}
        self._add(listed | dict.fromkeys(field.classes_without_geometry, _OTHER_GROUP))

    def _add(self, listed: Mapping[str, str]) -> None:
        font = QFont(self.font())
        font.setBold(True)
        added = []
        rows: dict[str, list[QTreeWidgetItem]] = {}
        for name, group in listed.items():
            rows.setdefault(group, []).append(self._row(name))
        for group, items in rows.items():
            if group not in self._groups:
                parent = self._groups[group] = QTreeWidgetItem([tr(group)])
                parent.setFlags(Qt.ItemFlag.ItemIsEnabled)
                parent.setFont(NAME, font)
                added.append(parent)
            self._groups[group].addChildren(items)
        # All at once: signalled row by row, the view takes several times as long.
        self.tree.addTopLevelItems(added)
        for parent in added:
            parent.setFirstColumnSpanned(True)
            parent.setExpanded(True)

    def _row(self, name: str) -> QTreeWidgetItem:
        field = self._services.state.field
        title = tr(field.title_of(name)) if field.knows(name) else field.title_of(name)
        item = QTreeWidgetItem([self._short.get(name, title)])
        item.setData(0, _CLASS, name)
        item.setToolTip(NAME, tr("{title}\nClass in files: {name}", title=title, name=name))
        item.setIcon(NAME, class_swatch(field, name))
        item.setText(KEY, short_text(self._keys.get(name, "")))
        item.setToolTip(KEY, self._keys.get(name, ""))
        item.setTextAlignment(POINTS, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._items[name] = item
        return item

    def _match_unknown_classes(self) -> None:
        """List the classes of this file that the field does not know, and only those."""
        field = self._services.state.field
        present = [p.class_name for p in self._services.state.shown_annotation]
        unknown = {name for name in present if not field.knows(name)}
        listed = {name for name in self._items if not field.knows(name)}
        for name in listed - unknown:
            self._groups[_UNKNOWN_GROUP].removeChild(self._items.pop(name))
            self._shown.pop(name, None)
        self._add(dict.fromkeys(sorted(unknown - listed), _UNKNOWN_GROUP))
        group = self._groups.get(_UNKNOWN_GROUP)
        if group is not None and not group.childCount():
            self.tree.takeTopLevelItem(self.tree.indexOfTopLevelItem(group))
            del self._groups[_UNKNOWN_GROUP]
        if unknown != listed:
            self._apply_search()

    # --- showing -------------------------------------------------------------------------------

    def _refresh(self) -> None:
        if self._outdated:
            self._fill()
            self._apply_search()
        self._match_unknown_classes()
        states = element_states(self._services)
        annotation = self._services.state.shown_annotation
        counts = {p.class_name: len(p.points) for p in annotation}
        findings = findings_by_element(self._services)
        best = self._services.ghosts.suggestion
        following = None if best is None else best.name
        # Signalled cell by cell, the view spends milliseconds a frame on it.
        model = self.tree.model()
        model.blockSignals(True)
        others: list[QTreeWidgetItem] = []
        ratio = self.devicePixelRatioF()
        for name, item in self._items.items():
            state = states.get(name, ElementState.UNTOUCHED)
            if name == following:
                state = ElementState.NEXT
            found = findings.get(name, ())
            shown = (state, counts.get(name, 0), bool(self._narrow), found)
            if self._shown.get(name) != shown:
                self._shown[name] = shown
                others.append(item)
                # Where room is short, the sign of a finding stands for the number of points.
                item.setText(POINTS, "" if self._narrow and found else str(shown[1] or ""))
                item.setText(STATUS, "" if self._narrow else words_for(state))
                item.setToolTip(STATUS, tr(EXPLANATIONS[state]))
                item.setIcon(STATUS, symbol_icon(state, self))
                sign = finding_icon(found[0].finding.severity, ratio) if found else QIcon()
                item.setIcon(POINTS, sign)
                item.setToolTip(POINTS, reasons_of(found))
        model.blockSignals(False)
        self._tell_view(others, bool(findings))
        self._show_selection()

    def _tell_view(self, others: list[QTreeWidgetItem], signs: bool) -> None:
        """Have rows painted again, and the columns laid out if they need other room."""
        most = max((count for _, count, *_ in self._shown.values()), default=0)
        states = {state for state, _, narrow, _ in self._shown.values() if not narrow}
        widest = max(map(self.fontMetrics().horizontalAdvance, map(words_for, states)), default=0)
        symbols = any(state is not ElementState.UNTOUCHED for state, *_ in self._shown.values())
        room = len(str(most or "")), widest, symbols, self._narrow, signs
        if room != self._room:
            self._room = room
            self.tree.scheduleDelayedItemsLayout()
        viewport = self.tree.viewport()
        for item in others:
            row = self.tree.visualItemRect(item)
            viewport.update(0, row.top(), viewport.width(), row.height())

    def _show_selection(self) -> None:
        item = self._items.get(self._services.state.selected_class or "")
        if item is None:
            self.tree.setCurrentIndex(QModelIndex())
        elif item is not self.tree.currentItem() and not item.isHidden():
            self.tree.setCurrentItem(item)
            self.tree.scrollToItem(item)

    def _show_hover(self) -> None:
        hovered, shade = self._services.state.hovered_class, QBrush(muted(self.palette(), 0.82))
        for name, brush in ((self._shaded, QBrush()), (hovered, shade)):
            if (item := self._items.get(name or "")) is not None:
                for column in (NAME, KEY, POINTS, STATUS):
                    item.setBackground(column, brush)
        self._shaded = hovered

    def resizeEvent(self, event: QResizeEvent) -> None:
        narrow = event.size().width() < NARROW
        if narrow != self._narrow:
            self._narrow = narrow
            for column, title in ((POINTS, tr("Pts")), (STATUS, tr("Status"))):
                self.tree.headerItem().setText(column, "" if narrow else title)
            self._refresher.request()
        super().resizeEvent(event)

    def changeEvent(self, event: QEvent) -> None:
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "_refresher"):
            self._shown.clear()
            self._refresher.request()
        super().changeEvent(event)

    # --- choosing ------------------------------------------------------------------------------

    def _choose(self, item: QTreeWidgetItem, column: int = 0) -> None:
        name = item.data(0, _CLASS)
        if name is not None:
            self._services.selection.select_class(name, continues=True)
        elif column >= 0:
            item.setExpanded(not item.isExpanded())

    def _apply_search(self) -> None:
        query = self.search.text()
        likeliness = self._likeliness() if query.strip() else {}
        best: tuple[tuple[float, ...], QTreeWidgetItem] | None = None
        title_of = self._services.state.field.title_of
        for name, item in self._items.items():
            fit = match_rank(query, tr(title_of(name)), name, self._keys.get(name, ""))
            item.setHidden(fit is None)
            if fit is None:
                continue
            rank = (fit, *likeliness[name]) if likeliness else (fit,)
            if best is None or rank < best[0]:
                best = (rank, item)
        for group in self._groups.values():
            group.setHidden(all(child.isHidden() for child in _children(group)))
        if query.strip():
            if best:
                self.tree.setCurrentItem(best[1])
            else:
                self.tree.setCurrentIndex(QModelIndex())
        else:
            self._show_selection()
        why = tr("No element matches “{query}”.\nEsc clears the search.", query=query.strip())
        self._pages.explain("" if best else why)

    def _likeliness(self) -> dict[str, tuple[bool, float]]:
        """Between classes that fit as well: first what is missing, and near what is annotated."""
        field, annotated = self._services.state.field, self._services.state.annotation.annotated
        apart = distances_from(field, annotated)
        near = dict(
            zip(field.index, np.where(np.isfinite(apart), apart, 0.0).tolist(), strict=True)
        )
        return {name: (name in annotated, near.get(name, 0.0)) for name in self._items}

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self.tree.viewport() and event.type() == QEvent.Type.Leave:
            self._services.selection.hover_class(None)
        return super().eventFilter(watched, event)

    def _search_key(self, key: Qt.Key) -> None:
        if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            item = self.tree.currentItem()
            if self.search.text().strip() and item is not None and not item.isHidden():
                self._choose(item, -1)
                self._leave_search()
        elif key == Qt.Key.Key_Escape:
            self._leave_search()
        else:
            self._step(1 if key == Qt.Key.Key_Down else -1)

    def _step(self, step: int) -> None:
        groups = [self.tree.topLevelItem(i) for i in range(self.tree.topLevelItemCount())]
        items = [item for group in groups if group is not None for item in _children(group)]
        visible = [item for item in items if not item.isHidden()]
        if not visible:
            return
        current = self.tree.currentItem()
        at = visible.index(current) + step if current in visible else 0
        self.tree.setCurrentItem(visible[max(0, min(at, len(visible) - 1))])

    def _leave_search(self) -> None:
        self.search.clear()
        self._show_selection()
        self.left.emit()


def _children(group: QTreeWidgetItem) -> list[QTreeWidgetItem]:
    children = (group.child(i) for i in range(group.childCount()))
    return [child for child in children if child is not None]
