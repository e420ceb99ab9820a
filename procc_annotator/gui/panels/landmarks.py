"""The landmarks of the dataset: where they are, how surely, and in which views they are clicked."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from PySide6.QtCore import QSignalBlocker, Qt, SignalInstance
from PySide6.QtGui import QAction, QColor, QIcon, QPalette, QPixmap
from PySide6.QtWidgets import (
    QAbstractItemView,
    QGridLayout,
    QHeaderView,
    QLabel,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
)

from procc_annotator.field.model import Landmark
from procc_annotator.gui.messages import ask_to_delete
from procc_annotator.gui.panels.widgets import (
    LEFT_BY_ESCAPE,
    Panel,
    empty_state,
    hbox,
    make_button,
    make_label,
    named,
    note_label,
    show_note,
    vbox,
)
from procc_annotator.gui.state.availability import as_sentence
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr, tr_count, word

_COLUMNS = (word("Landmark"), "x, y, z  m", "± m", word("Views"))
_NAME = Qt.ItemDataRole.UserRole
_EMPTY = word(
    "No landmarks. A landmark is a place of this stadium that the field does not have: a seat, the"
    " corner of a board, a floodlight. Name one below, and click it in two calibrated views."
)
_TRIANGULATE = word(
    "Find its place from the views it is clicked in; cameras are those of the active source, else"
    " fits to the clicks"
)
_HERE = word("Other views of this instant")
_ALONE = word("No other views")
_MOST_NAMED = 4
_LOST = word("Its place cannot be brought back with undo. Clicks on it stay in the annotations.")
_SWATCH = 12


class LandmarksPanel(Panel):
    """Lists the landmarks; adds, places, names, triangulates and forgets them."""

    def __init__(self, services: Services) -> None:
        super().__init__(services, "landmarks_panel")
        self._build()
        self._follow(
            lambda s: (s.workspace, s.frame_index, s.annotation, s.field, s.selection),
            services.landmarks.changed,
        )
        self._refresh()

    def _build(self) -> None:
        self.empty = empty_state(tr(_EMPTY), "landmarksEmpty")
        self.list = named(QTreeWidget(), "landmarksList", title=tr("Landmarks"))
        self.list.setHeaderLabels([tr(column) for column in _COLUMNS])
        self.list.setRootIsDecorated(False)
        self.list.setFocusPolicy(Qt.FocusPolicy.TabFocus)  # as the list of findings
        self.list.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.list.header().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.list.header().setStretchLastSection(True)
        self.list.currentItemChanged.connect(self._choose)
        self.name = _line(tr("New landmark"), "landmarkName", self._add)
        self.add = make_button(
            tr("Add"), self._add, tip=tr("Have a new landmark, to be clicked (Enter)")
        )
        self.title = _line(tr("What people call it"), "landmarkTitle", self.left)
        self.title.editingFinished.connect(self._retitle)
        self.place = _line(tr("x, y, z in metres, z down"), "landmarkPlace", self._survey)
        self.survey = make_button(
            tr("Set"),
            self._survey,
            tip=tr("The place was measured: it stays as it is from now on (Enter)"),
        )
        self.triangulate = make_button(tr("Triangulate"), self._triangulate, tip=tr(_TRIANGULATE))
        self.remove = make_button(
            tr("Delete"),
            self._remove,
            tip=tr("Forget this landmark; clicks on it stay in the annotations"),
        )
        tip = tr("Other views of this instant: go to one with a click")
        self.views = named(QListWidget(), "landmarkViews", tip=tip, title=tr(_HERE))
        self.views.itemClicked.connect(self._go)
        self.views.itemActivated.connect(self._go)
        self.views_title = make_label(tr(_HERE), wrap=True)
        self.group = named(QPushButton(), "landmarksGroup")
        self.note = note_label("landmarksNote")
        self.hint = note_label("landmarksHint")  # why Triangulate cannot be pressed
        self.hint.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        grid = QGridLayout()
        grid.addWidget(QLabel(tr("Title")), 0, 0)
        grid.addWidget(self.title, 0, 1, 1, 2)
        grid.addWidget(QLabel(tr("Place")), 1, 0)
        grid.addWidget(self.place, 1, 1)
        grid.addWidget(self.survey, 1, 2)
        vbox(
            self.note,
            (self.empty, 2),
            (self.list, 2),
            hbox((self.name, 1), self.add),
            grid,
            hbox(self.triangulate, self.remove, None),
            self.hint,
            hbox((self.views_title, 1), self.group),
            (self.views, 1),
            of=self,
            margins=6,
        )

    def add_actions(self, group: QAction) -> None:
        """Offer grouping next to the views."""
        self.group.setText(group.text())
        self.group.setToolTip(group.toolTip())
        self.group.clicked.connect(group.trigger)

    # --- showing --------------------------------------------------------------------------

    def _refresh(self) -> None:
        landmarks, opened = self._services.landmarks, self._services.state.workspace is not None
        entries = landmarks.entries
        self.empty.setVisible(not entries)
        self.list.setVisible(bool(entries))
        chosen = self._chosen
        with QSignalBlocker(self.list):
            self.list.clear()
            for mark in entries:
                item = self._item(mark)
                self.list.addTopLevelItem(item)
                if mark.name == (self._services.state.selected_class or chosen):
                    self.list.setCurrentItem(item)
        self.name.setEnabled(opened and not landmarks.problem)
        self.add.setEnabled(opened and not landmarks.problem)
        show_note(self.note, "\n".join(filter(None, (landmarks.problem, landmarks.strange))))
        self._refresh_chosen()
        self._refresh_views()

    def _item(self, mark: Landmark) -> QTreeWidgetItem:
        landmarks = self._services.landmarks
        frames = landmarks.frames_with(mark.name)
        place = "" if mark.position is None else "{:.2f}, {:.2f}, {:.2f}".format(*mark.position)
        worst = _worst_m(mark)
        item = QTreeWidgetItem(
            [
                mark.shown_title,
                place,
                "" if worst is None else f"{worst:.2f}",
                "…" if frames is None else str(len(frames)),
            ]
        )
        item.setData(0, _NAME, mark.name)
        item.setToolTip(0, mark.note or mark.name)
        item.setToolTip(1, _origin(mark))
        item.setToolTip(2, tr("Standard deviation in the direction where it is largest"))
        item.setToolTip(3, ", ".join(frames or ()) or tr("Not clicked in any frame yet"))
        element = self._services.scorer.frame_setup.field.element(mark.name)
        if element is not None:
            swatch = QPixmap(_SWATCH, _SWATCH)
            swatch.fill(QColor(element.colour))
            item.setIcon(0, QIcon(swatch))
        return item

    def _refresh_chosen(self) -> None:
        landmarks, name = self._services.landmarks, self._chosen
        mark = next((m for m in landmarks.entries if m.name == name), None)
        usable = mark is not None and not landmarks.problem
        for part in (self.title, self.place, self.survey, self.remove):
            part.setEnabled(usable)
        why_not = self._why_not_triangulated(mark)
        self.triangulate.setEnabled(not why_not)
        self.triangulate.setToolTip(why_not or tr(_TRIANGULATE))
        opened = self._services.state.workspace is not None and not landmarks.problem
        show_note(self.hint, why_not if opened else "")
        self.triangulate.setText(
            tr("Triangulating…") if landmarks.triangulation.working else tr("Triangulate")
        )
        _show(self.title, "" if mark is None else mark.shown_title)
        position = None if mark is None else mark.position
        _show(
            self.place, "" if position is None else ", ".join(f"{round(v, 4):g}" for v in position)
        )

    def _why_not_triangulated(self, mark: Landmark | None) -> str:
        """Return what is to be done before a landmark can be triangulated; empty for nothing."""
        landmarks = self._services.landmarks
        if landmarks.problem:
            return as_sentence(landmarks.problem)
        if mark is None:
            return self._what_to_name()
        title, frames = mark.shown_title, landmarks.frames_with(mark.name)
        if landmarks.triangulation.working:
            return tr("{name} is being triangulated.", name=landmarks.triangulation.working.strip())
        if kept := landmarks.triangulation.why_kept(mark.name):
            return tr(
                "{why}. Delete the landmark and name it again to have it triangulated.", why=kept
            )
        if frames is None:
            return tr("Looking for the frames in which {title} is clicked…", title=title)
        if len(frames) > 1:
            return ""
        if frames:
            return tr(
                "{title} is clicked in {frame} alone: click it in another calibrated view to have"
                " it triangulated.",
                title=title,
                frame=frames[0],
            )
        return tr(
            "{title} is clicked in no frame yet: click it in two calibrated views to have it"
            " triangulated.",
            title=title,
        )

    def _what_to_name(self) -> str:
        if self._services.landmarks.entries:
            return tr("Choose a landmark in the list to have it triangulated.")
        field, clicked = self._services.state.field, self._services.state.annotation.polylines
        names = [
            p.class_name.strip()
            for p in clicked
            if len(p.points) == 1 and not field.knows(field.canonical_name(p.class_name))
        ]
        if not names:
            return tr("Only a landmark that has a name can be triangulated: write one next to Add.")
        named = ", ".join(names[:_MOST_NAMED])
        if (more := len(names) - _MOST_NAMED) > 0:
            named = tr_count(more, "{names} and {n} more", "{names} and {n} more", names=named)
        return tr(
            "Clicked here, but no landmarks yet: {names}. Write a name next to Add to"
            " triangulate it.",
            names=named,
        )

    def _refresh_views(self) -> None:
        views = self._services.landmarks.other_views()
        self.views.clear()
        for index, name, view in views:
            item = QListWidgetItem(f"{view}  ({name})" if view else name)
            item.setData(_NAME, index)
            self.views.addItem(item)
        self.views.setVisible(bool(views))
        self.views_title.setText(tr(_HERE) if views else tr(_ALONE))
        self.views_title.setVisible(self._services.state.frame is not None)
        self.group.setVisible(self._services.state.frame is not None)

    # --- editing --------------------------------------------------------------------------

    @property
    def _chosen(self) -> str | None:
        item = self.list.currentItem()
        return None if item is None else str(item.data(0, _NAME))

    def _choose(self) -> None:
        if (name := self._chosen) is not None:
            self._services.selection.select_class(name, continues=True)
        self._refresh_chosen()

    def _add(self) -> None:
        name = self.name.text().strip()
        if not name:
            self._services.say(tr("a landmark needs a name: write one next to Add"), "warning")
            self.name.setFocus()
        elif self._services.landmarks.add(name):
            self.name.clear()
            self._services.selection.select_class(name, continues=True)
            self.left.emit()

    def _retitle(self) -> None:
        if (name := self._chosen) is not None and self.title.isModified():
            self.title.setModified(False)
            self._services.landmarks.retitle(name, self.title.text())

    def _survey(self) -> None:
        if (name := self._chosen) is not None and self._services.landmarks.survey(
            name, self.place.text()
        ):
            self.place.setModified(False)
            self.left.emit()

    def _triangulate(self) -> None:
        if (name := self._chosen) is not None:
            self._services.landmarks.triangulation.start(name)

    def _remove(self) -> None:
        """Forget the chosen landmark; one that has a place only if that is meant."""
        landmarks, name = self._services.landmarks, self._chosen
        mark = next((m for m in landmarks.entries if m.name == name), None)
        if mark is None:
            return
        if mark.position is not None and not ask_to_delete(
            self, tr("the landmark {title}", title=mark.shown_title), tr(_LOST)
        ):
            return
        if landmarks.remove(mark.name):
            self._services.say(
                tr(
                    "deleted the landmark {title}; clicks on it stay in the annotations",
                    title=mark.shown_title,
                )
            )

    def _go(self, item: QListWidgetItem) -> None:
        self._services.navigator.go_to(int(item.data(_NAME)))


def _worst_m(mark: Landmark) -> float | None:
    """Standard deviation in the direction where it is largest, metres."""
    if mark.covariance is None:
        return None
    return float(np.sqrt(np.linalg.eigvalsh(np.array(mark.covariance))[-1]))


def _origin(mark: Landmark) -> str:
    if mark.position is None:
        return tr("Its place is not known yet")
    if mark.surveyed:
        return tr("Surveyed")
    return tr("Triangulated from {frames}", frames=", ".join(mark.frames))


def _show(line: QLineEdit, text: str) -> None:
    """Put text into a line, unless a person is writing there."""
    if line.text() != text and not (line.hasFocus() and line.isModified()):
        line.setText(text)
        line.setCursorPosition(0)


def _line(hint: str, name: str, entered: Callable[[], object] | SignalInstance) -> QLineEdit:
    line = named(QLineEdit(placeholderText=hint), name, title=hint)
    line.setProperty(LEFT_BY_ESCAPE, True)
    line.returnPressed.connect(entered)
    return line
