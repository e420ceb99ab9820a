"""The field of the dataset, chosen in the menu; the bar that says, or asks, when another fits."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject
from PySide6.QtGui import QAction, QActionGroup
from PySide6.QtWidgets import QFileDialog, QMenu, QPushButton, QToolButton, QWidget

from procc_annotator.field.load import field_titles, is_builtin_field
from procc_annotator.gui.messages import Bar
from procc_annotator.gui.settings import FIELD_FOLDER, OWN_FIELDS, Settings
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.availability import as_sentence
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr


class FieldBar(Bar):
    """Shows why the field may be the wrong one, or why its file cannot be used."""

    def __init__(self) -> None:
        super().__init__("fieldBar")
        self.switch_button = QPushButton()
        self.close_button = QToolButton(autoRaise=True)
        self.close_button.setText("✕")
        self.close_button.setToolTip(tr("Keep the field, and say nothing more of these classes"))
        self.no_button = QPushButton()
        self.no_button.setToolTip(tr("The dataset remembers it, and is not asked about again"))
        self.row.addWidget(self.switch_button)
        self.row.addWidget(self.no_button)
        self.row.addWidget(self.close_button)

    def ask(self, text: str, field: str, shown: str, keys: str = "") -> None:
        """Ask whether the dataset shows a field, and not the one that is shown."""
        self.tell(text, field, keys)
        self.switch_button.setText(_with_keys(tr("Yes, {field}", field=field), keys))
        self.no_button.setText(tr("No, {field}", field=shown))
        self.no_button.show()

    def tell(self, text: str, better: str = "", keys: str = "", *, closable: bool = False) -> None:
        """Show what is wrong, and the field that fits where there is one; nothing without text."""
        self.label.setText(as_sentence(text))
        self.switch_button.setText(_with_keys(tr("Switch to {field}", field=better), keys))
        self.switch_button.setVisible(bool(better))
        self.no_button.hide()
        self.close_button.setVisible(closable)
        self.setVisible(bool(text))


def _with_keys(text: str, keys: str) -> str:
    return f"{text} ({keys})" if keys else text


class FieldChoosing(QObject):
    """Slots of the menu File > Field; fills it, and the bar."""

    def __init__(
        self, services: Services, settings: Settings, bar: FieldBar, parent: QWidget
    ) -> None:
        super().__init__(parent)
        self._services = services
        self._settings = settings
        self._parent = parent
        self._choice = services.field_choice
        self._bar = bar
        self._switch_keys = ""
        self._group = QActionGroup(self)
        self._own: list[QAction] = []
        self._menu: QMenu | None = None
        self._choice.own_files = settings.get(OWN_FIELDS)
        self._choice.changed.connect(self._refresh_bar)
        services.store.watch(select.field, self._note_own)
        services.store.watch(select.frame, self._refresh_bar)
        bar.switch_button.clicked.connect(self._choice.switch)
        bar.no_button.clicked.connect(self._choice.leave)
        bar.close_button.clicked.connect(self._choice.leave)

    def fill(self, menu: QMenu, before: QAction, switch: QAction) -> None:
        """Put the fields into a menu, before an action of it; the one on screen is ticked."""
        self._menu = menu
        self._switch_keys = switch.shortcut().toString()
        for name, title in field_titles().items():
            menu.insertAction(before, self._action(tr(title), name))
        self._last = menu.insertSeparator(before)
        menu.aboutToShow.connect(self.refresh_menu)

    def refresh_menu(self) -> None:
        """List the user's own files, and tick the field on screen."""
        menu = self._menu
        if menu is None:
            return
        for action in self._own:
            menu.removeAction(action)
            action.deleteLater()
        field = self._services.state.field
        shipped = field.source is None or is_builtin_field(field.source)
        shown = field.name if shipped or field.source is None else field.source.absolute()
        paths = self._settings.get(OWN_FIELDS)
        if isinstance(shown, Path) and shown not in paths:
            paths = [shown, *paths]
        paths = [path for path in paths if path == shown or path.is_file()]
        self._own = [self._action(path.name, path) for path in paths]
        for action, path in zip(self._own, paths, strict=True):
            action.setToolTip(str(path))
            menu.insertAction(self._last, action)
        for action in self._group.actions():
            action.setChecked(action.data() == shown)

    def ask_file(self) -> None:
        """Ask for a description of the user's own."""
        chosen, _ = QFileDialog.getOpenFileName(
            self._parent,
            tr("The field of this dataset"),
            self._settings.get(FIELD_FOLDER),
            tr("Descriptions of fields (*.toml)"),
        )
        if chosen:
            self._settings.set(FIELD_FOLDER, str(Path(chosen).parent))
            self._choice.choose(Path(chosen))

    # --- inside ---

    def _action(self, title: str, source: str | Path) -> QAction:
        action = QAction(title.replace("&", "&&"), self, checkable=True)
        action.setData(source)
        action.triggered.connect(lambda: self._choose(source))
        self._group.addAction(action)
        return action

    def _choose(self, source: str | Path) -> None:
        self._choice.choose(source)
        self.refresh_menu()  # the tick stays where the field is until it is another one

    def _note_own(self) -> None:
        """A file of the user's own is offered from now on, also to datasets whose classes fit."""
        source = self._services.state.field.source
        if source is not None and not is_builtin_field(source):
            self._settings.put_first(OWN_FIELDS, source.absolute())
            self._choice.own_files = self._settings.get(OWN_FIELDS)

    def _refresh_bar(self) -> None:
        choice = self._choice
        if choice.problem:
            self._bar.tell(
                tr(
                    "{problem}; the field stays as it was: {field}",
                    problem=choice.problem,
                    field=tr(self._services.state.field.title),
                )
            )
            return
        if (asked := choice.question) is not None:
            title = tr(asked.title)
            said = tr(
                "Is this {field}? The classes annotated here are those of {field}", field=title
            )
            self._bar.ask(said, title, tr(self._services.state.field.title), self._switch_keys)
            return
        mismatch = choice.mismatch
        if mismatch is None:
            self._bar.tell("")
            return
        better, text = tr(mismatch.better.title) if mismatch.better else "", mismatch.words()
        if better and (own := choice.decided_by_file) is not None:
            better = ""
            text = tr("{why}, but {file} in the dataset's folder decides", why=text, file=own.name)
        self._bar.tell(text, better, self._switch_keys, closable=True)
