"""The command palette: a line to type in above the picture, what fits below it, Enter runs it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import islice
from pathlib import Path

from PySide6.QtCore import QEvent, QObject, QSize, Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import (
    QApplication,
    QFrame,
    QTableView,
    QWidget,
)

from procc_annotator.gui.actions import ACTIONS
from procc_annotator.gui.keymap import NATIVE, key_text
from procc_annotator.gui.panels.widgets import (
    Index,
    RowsModel,
    list_rows,
    make_label,
    named,
    search_line,
    vbox,
)
from procc_annotator.gui.settings import CALLED, OFFERED, RECENT, SWITCHES, Settings
from procc_annotator.gui.state.prediction.live_fit import MODELS
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import muted
from procc_annotator.gui.window.menus import Actions, in_menu
from procc_annotator.gui.window.welcome import described
from procc_annotator.gui.window.workspaces import TITLES
from procc_annotator.interaction.class_choice import loose_rank, match_rank, misspelt
from procc_annotator.translation import tr, word

# What sorts of things there are besides actions, which are of the sort of their menu.
_CAMERAS, _PANEL, _SETTING, _OPEN = word("Cameras"), word("Panel"), word("Setting"), word("Open")
_ELEMENT, _FRAME, _CAMERA = word("Element"), word("Frame"), word("Camera")

_MOST_FRAMES = 30  # that are listed of those with a fitting name
_BY_DETAIL = 10  # the rank of what fits by what is said of it, behind all that fit by name
_SELF = "palette"  # the action that shows the list, which need not be in it


@dataclass(frozen=True, slots=True)
class Entry:
    """One thing that can be called.

    Attributes:
        kind: what sort of thing it is, its menu or another sort, marked by ``word``.
        title: its name, as menus and panels have it.
        detail: what it does, or where it lies.
        keys: what else calls it, as people write it.
        key: what it is remembered by as called last; "" for things of one dataset.
        on: whether it is on; None for what is neither.
        english: its name in English, which finds it whatever the language.
    """

    kind: str
    title: str
    run: Callable[[], object]
    detail: str
    keys: str = ""
    key: str = ""
    on: bool | None = None
    enabled: bool = True
    english: str = ""

    @property
    def names(self) -> tuple[str, ...]:
        """Return what it is called by: its name, and the English one if that is another."""
        return (self.title,) if self.english in ("", self.title) else (self.title, self.english)


class PaletteEntries:
    """Lists what a window can be asked for, by what is typed."""

    def __init__(
        self,
        services: Services,
        actions: Actions,
        settings: Settings,
        show_panel: Callable[[str], object],
        open_path: Callable[[Path], object],
        show_setting: Callable[[str], object],
    ) -> None:
        self._services = services
        self._actions = actions
        self._settings = settings
        self._show_panel = show_panel
        self._open_path = open_path
        self._show_setting = show_setting

    def found(self, text: str, called: Iterable[str] = ()) -> list[Entry]:
        """Return what fits a text, best first; for an empty one what was called last (keys, newest
        first), then all actions."""
        if not text.strip():
            actions = {entry.key: entry for entry in self._of_actions()}
            last = [actions.pop(key) for key in called if key in actions]
            return [*last, *actions.values()]
        entries = [*self._of_actions(), *self._of_the_window()]
        fitting = [*entries, *islice(self._of_frames(text), _MOST_FRAMES)]
        best = [*self._of_numbers(text), *_ranked(text, fitting)]
        return best or [e for e in entries if any(misspelt(text, name) for name in e.names)]

    def elements(self, text: str, choose: Callable[[str], object]) -> list[Entry]:
        """Return the elements of the field that fit a text, best first, to be chosen by their
        class."""
        entries = [replace(e, run=partial(choose, e.detail)) for e in self._of_elements()]
        return _ranked(text, entries) if text.strip() else entries

    # --- what there is ------------------------------------------------------------------------

    def _of_actions(self) -> Iterator[Entry]:
        for spec in ACTIONS:
            if spec.name == _SELF:
                continue
            action, place = self._actions[spec.name], spec.menu.partition("/")[2]
            english = spec.text.lstrip("-")
            yield Entry(
                spec.menu.split("/")[0],
                in_menu(spec.menu, action.text()),
                action.trigger,
                tr(spec.tip),
                "  ".join(keys.toString(NATIVE) for keys in action.shortcuts()),
                f"action:{spec.name}",  # not shown
                action.isChecked() if action.isCheckable() else None,
                action.isEnabled(),
                f"{place}: {english}" if place else english,
            )

    def _of_the_window(self) -> Iterator[Entry]:
        yield from self._of_elements()
        yield from self._of_cameras()
        yield from self._of_panels()
        yield from self._of_settings()
        for path in self._settings.get(RECENT):
            yield Entry(_OPEN, described(path), partial(self._open_path, path), str(path))

    def _of_elements(self) -> Iterator[Entry]:
        services = self._services
        field = services.state.field
        for name in (*(e.name for e in field.elements), *field.classes_without_geometry):
            yield Entry(
                _ELEMENT,
                tr(field.title_of(name)),
                partial(services.selection.select_class, name, continues=True),
                name,
                key_text(field, name, services.state.keymap),
                on=services.state.selected_class == name,
                english=field.title_of(name),
            )

    def _of_cameras(self) -> Iterator[Entry]:
        services = self._services
        for index, source in enumerate(services.state.sources):
            yield Entry(
                _CAMERAS,
                tr("Judge {source}", source=source.name),
                partial(services.camera_sources.set_active_camera, index),
                tr("Judge with this source"),
                on=source is services.state.active,
                english=f"Judge {source.name}",  # not shown
            )
        for model, words in MODELS.items():
            yield Entry(
                _CAMERA,
                tr("Live fit: model {model}", model=model),
                partial(services.live_fit.set_model, model),
                tr(words),
                key=f"model:{model}",  # not shown
                on=services.live_fit.model == model,
                english=f"Live fit: model {model}",  # not shown
            )

    def _of_panels(self) -> Iterator[Entry]:
        for name, title in TITLES.items():
            yield Entry(
                _PANEL,
                tr("Panel {title}", title=tr(title)),
                partial(self._show_panel, name),
                tr("Open this panel and bring it to the front"),
                key=f"panel:{name}",  # not shown
                english=f"Panel {title}",  # not shown
            )

    def _of_settings(self) -> Iterator[Entry]:
        for setting in OFFERED:
            if setting.shown is not None and setting.key not in SWITCHES:  # those are actions
                yield Entry(
                    _SETTING,
                    f"{tr(setting.shown.title)}…",
                    partial(self._show_setting, setting.key),
                    tr(setting.text),
                    key=f"setting:{setting.key}",  # not shown
                    english=f"{setting.shown.title}…",
                )

    def _of_numbers(self, text: str) -> Iterator[Entry]:
        """Return what a number alone may mean: a threshold, a frame."""
        services = self._services
        try:
            number = float(text.replace(",", "."))
        except ValueError:
            return
        if 0 < number <= 100:
            title = tr("Threshold {px:g} px", px=number)
            set_tau = partial(services.evaluation.set_tau, number)
            tip, on = tr("Judge elements by this tau"), services.state.tau == number
            yield Entry(_CAMERA, title, set_tau, tip, on=on)
        count = len(services.state.workspace.frames) if services.state.workspace is not None else 0
        if number.is_integer() and 1 <= number <= count:
            index = int(number) - 1
            title = tr("Frame {number} of {count}", number=int(number), count=count)
            yield self._frame(index, title)

    def _of_frames(self, text: str) -> Iterator[Entry]:
        workspace = self._services.state.workspace
        wanted = text.casefold().split()
        for index, frame in enumerate(workspace.frames if workspace is not None else ()):
            name = frame.name.casefold()
            if all(word in name for word in wanted):
                yield self._frame(index, frame.name)

    def _frame(self, index: int, title: str) -> Entry:
        services = self._services
        assert services.state.workspace is not None
        name = services.state.workspace.frames[index].name
        go = partial(services.navigator.go_to, index)
        detail = name if name != title else tr("Go to this frame")
        return Entry(_FRAME, title, go, detail, on=index == services.state.frame_index)


def _ranked(text: str, entries: Iterable[Entry]) -> list[Entry]:
    ranked = [(rank, e) for e in entries if (rank := _rank(text, e)) is not None]
    return [e for _, e in sorted(ranked, key=lambda pair: (pair[0], len(pair[1].title)))]


def _rank(text: str, entry: Entry) -> int | None:
    ranks = [rank for name in entry.names if (rank := loose_rank(text, name)) is not None]
    if 0 in ranks or match_rank(text, entry.keys) == 0:
        return 0
    if ranks:
        return min(ranks)
    if match_rank(text, f"{entry.kind} {' '.join(entry.names)} {entry.detail}") is not None:
        return _BY_DETAIL
    return None


_WIDTH = 920
_ROWS = 12
_PAD = 8
_MARGIN = 24  # of the window that stays in sight around it
_KIND, _TITLE, _DETAIL, _KEYS = range(4)
_HINT = word("Enter runs it · ↑ ↓ choose · Esc closes")
_MOVES = {
    Qt.Key.Key_Up: -1,
    Qt.Key.Key_Down: 1,
    Qt.Key.Key_PageUp: -_ROWS,
    Qt.Key.Key_PageDown: _ROWS,
}


class CommandPalette(QFrame):
    """Lies over the top of a window while something is looked for; goes when the keyboard goes."""

    def __init__(
        self,
        window: QWidget,
        found: Callable[[str, Sequence[str]], list[Entry]],
        settings: Settings,
    ) -> None:
        super().__init__(window)
        self._window = window
        self.setObjectName("commandPalette")
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setAutoFillBackground(True)
        self._found = self._asked = found
        self._settings = settings
        self._before: QWidget | None = None  # who had the keyboard
        hint = tr("An action, element, frame, camera source, folder, number")
        title = tr("Find anything")
        self.search = search_line(hint, "paletteSearch", self._show, title)
        self.search.installEventFilter(self)
        self.model = _Entries()
        self.list = named(QTableView(), "paletteList", title=tr("What fits"))
        self.list.setModel(self.model)
        list_rows(self.list, room=_PAD, widest=_DETAIL)
        self.list.setFrameShape(QFrame.Shape.NoFrame)
        self.list.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # the line keeps the keyboard
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.horizontalHeader().hide()
        self.list.clicked.connect(self._call)
        self.hint = make_label(tr(_HINT), faint=True)
        vbox(self.search, self.list, self.hint, of=self, margins=_PAD)
        window.installEventFilter(self)
        application = QApplication.instance()
        assert isinstance(application, QApplication)
        application.focusChanged.connect(self._follow)
        self.hide()

    def ask(self, found: Callable[[str, Sequence[str]], list[Entry]] | None = None) -> None:
        """Show it with an empty line, for anything or for what is ``found``; once more puts it
        away."""
        if self.isVisible():
            self.put_away()
            return
        self._asked, self._before = found or self._found, QApplication.focusWidget()
        self.search.clear()
        self._show()
        self.place()
        self.show()
        self.raise_()
        self.search.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def put_away(self) -> None:
        """Hide it; the keyboard goes back to who had it."""
        before, self._before = self._before, None
        self.hide()
        if before is not None:
            before.setFocus(Qt.FocusReason.OtherFocusReason)

    def place(self) -> None:
        """In the middle of the window's width, below its top, no larger than its room."""
        room = self._window.size() - QSize(2 * _MARGIN, 2 * _MARGIN)
        self.list.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + _PAD)
        self.list.setFixedHeight(_ROWS * self.list.verticalHeader().defaultSectionSize())
        size = self.sizeHint().expandedTo(QSize(_WIDTH, 0)).boundedTo(room)
        self.setFixedSize(size)
        self.move((self._window.width() - size.width()) // 2, 2 * _MARGIN)

    # --- inside ---

    def _show(self) -> None:
        text = self.search.text()
        self.model.replace(self._asked(text, self._settings.get(CALLED)))
        self.list.setCurrentIndex(self.model.index(0, _TITLE))
        self.list.scrollToTop()
        found = self.model.rowCount() > 0
        nothing = tr("Nothing is called “{text}”.", text=text.strip())
        self.hint.setText(tr(_HINT) if found else nothing)

    def _call(self, index: Index) -> None:
        entry = self.model.rows[index.row()] if index.isValid() else None
        if entry is None or not entry.enabled:
            return
        if entry.key:
            others = (key for key in self._settings.get(CALLED) if key != entry.key)
            self._settings.set(CALLED, (entry.key, *others)[: CALLED.most])
        self.put_away()  # first: what is called may ask for the keyboard itself
        entry.run()

    def _follow(self, _old: QWidget | None, new: QWidget | None) -> None:
        if self.isVisible() and new is not None and not self.isAncestorOf(new):
            self._before = None  # the user clicked elsewhere
            self.hide()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self._window and event.type() == QEvent.Type.Resize:
            if self.isVisible():
                self.place()
            return False
        if watched is not self.search or not isinstance(event, QKeyEvent):
            return False
        held = event.modifiers() == Qt.KeyboardModifier.ControlModifier
        calls_palette = held and event.key() == Qt.Key.Key_K
        if event.type() == QEvent.Type.ShortcutOverride and not calls_palette:
            event.accept()  # every key is the line's, or it would do something unseen below it
            return True
        return event.type() == QEvent.Type.KeyPress and self._key(Qt.Key(event.key()))

    def _key(self, key: Qt.Key) -> bool:
        """Return whether a key was for the list."""
        if key in _MOVES:
            last = self.model.rowCount() - 1
            row = self.list.currentIndex().row() + _MOVES[key]
            self.list.setCurrentIndex(self.model.index(min(max(row, 0), last), _TITLE))
        elif key in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._call(self.list.currentIndex())
        elif key == Qt.Key.Key_Escape:
            self.put_away()
        else:
            return key in (Qt.Key.Key_Tab, Qt.Key.Key_Backtab)
        return True


class _Entries(RowsModel[Entry]):
    """Entries as kind, title, detail and keys; screen readers get all of them."""

    def __init__(self) -> None:
        super().__init__(("",) * 4)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> object:
        entry, column = self.rows[index.row()], index.column()
        if role == Qt.ItemDataRole.ForegroundRole and column in (_KIND, _DETAIL):
            return muted(QApplication.palette())
        if role == Qt.ItemDataRole.AccessibleTextRole:
            state = {None: "", True: tr("on"), False: tr("off")}[entry.on]
            parts = (tr(entry.kind), entry.title, state, entry.keys, entry.detail)
            return ", ".join(part for part in parts if part)
        return super().data(index, role)

    def texts(self, row: Entry) -> tuple[str, ...]:
        title = f"✓ {row.title}" if row.on else row.title
        return tr(row.kind), title, row.detail, row.keys

    def tip(self, row: Entry) -> str:
        return row.detail

    def flags(self, index: Index) -> Qt.ItemFlag:
        enabled = self.rows[index.row()].enabled
        return super().flags(index) if enabled else Qt.ItemFlag.NoItemFlags
