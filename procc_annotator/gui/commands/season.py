"""The matches of a season: a list that shows how far they are tracked, and opens them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QDialogButtonBox, QFileDialog, QTableView, QWidget

from procc_annotator.batch.unit_store import SOURCE, WAITING, MatchUnits, UnitStore
from procc_annotator.dataset.season import STORE_FILE, Match, list_matches
from procc_annotator.field.load import load_field_of
from procc_annotator.field.model import Field
from procc_annotator.formats.cameras.packed import PACKED_SUFFIX
from procc_annotator.gui.commands.dialogs import CLOSE, DialogTask, TaskDialog, dialog_buttons
from procc_annotator.gui.panels import widgets
from procc_annotator.gui.settings import RECENT, Settings
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr, tr_count, word

_SORTED = widgets.SEARCHED + 1
_AGAIN_MS = 5000  # track may write meanwhile
_STATES = {
    "waiting": word("waiting"),
    "begun": word("begun"),
    "done": word("done"),
    "failed": word("failed"),
}
_COLUMNS = (word("Match"), word("Stadium"), word("Start"), word("State"), word("Frames"),
            word("Tracked"), word("On paint"), word("Failed units"))  # fmt: skip
_NONE = MatchUnits("", WAITING, 0, 0, 0, 0, 0, 0.0, None, 0.0)


class _Row(NamedTuple):
    match: Match
    field: Field | None
    cells: tuple[str | float | None, ...]


class Season(NamedTuple):
    """Matches, the ``path`` that lists their videos and, if known, the folder that track writes to
    and the files of their cameras there, by video."""

    path: Path
    tracked: Path | None
    rows: tuple[_Row, ...]
    cameras: dict[Path, Path]


def read_season(path: Path, tracked: Path | None) -> Season | None:
    """List matches, of a folder that track writes to those of its source; None if there are none.
    `UsageError` or `InputError` as of `list_matches`, and for a store or field of no use."""
    units: dict[str, MatchUnits] = {}
    if tracked is None and (path / STORE_FILE).is_file():
        tracked = path
    if tracked is not None:
        with UnitStore.read(tracked / STORE_FILE) as store:
            units = {one.match: one for one in store.matches()}
            path = Path(store.terms.get(SOURCE, path)) if path == tracked else path
    matches = list_matches(path)
    if matches is None and units and path != tracked:  # a single one was tracked
        matches = (Match(next(iter(units)), path),)
    if matches is None:
        return None
    fields = {match.field: load_field_of(match.field) for match in matches if match.field}
    rows = (_Row(m, fields.get(m.field), _cells(m, units.get(m.name, _NONE))) for m in matches)
    files = {m.pictures: tracked / f"{m.name}{PACKED_SUFFIX}" for m in matches} if tracked else {}
    return Season(path, tracked, tuple(rows), files)


def _cells(match: Match, units: MatchUnits) -> tuple[str | float | None, ...]:
    words = match.name, match.stadium, match.start, tr(_STATES[units.progress])
    return *words, units.frames or None, units.frames_tracked, units.evidence, units.failed


class _Matches(widgets.RowsModel[_Row]):
    def data(self, index: widgets.Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        row, column = self.rows[index.row()], index.column()
        if role == _SORTED:
            cell = row.cells[column] if column else index.row()
            return -1 if cell is None else cell
        return " ".join(self.texts(row)) if role == widgets.SEARCHED else super().data(index, role)

    def texts(self, row: _Row) -> list[str]:
        return [
            "–" if one is None else one if isinstance(one, str) else
            f"{one:.0%}" if isinstance(one, float) else f"{one:,}" for one in row.cells
        ]  # fmt: skip


class SeasonDialog(TaskDialog):
    """A table of matches, to be sorted and searched; Enter or a double click opens one."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent, "season", tr("Season"))
        self.search = widgets.search_line(tr("Search: match, stadium, state"), "seasonSearch")
        self.model = _Matches(_COLUMNS, first_figure=4)
        found = widgets.searched_rows(self.model, self.search)
        found.setSortRole(_SORTED)
        self.table = widgets.named(QTableView(), "seasonTable", title=tr("Matches"))
        self.table.setModel(found)
        widgets.list_rows(self.table, widest=0)
        self.table.horizontalHeader().setSortIndicator(-1, Qt.SortOrder.AscendingOrder)
        self.table.setSortingEnabled(True)
        self.table.doubleClicked.connect(self.accept)
        self.search.textChanged.connect(lambda: self.table.selectRow(0))
        buttons, _ = dialog_buttons(self, QDialogButtonBox.StandardButton.Open, CLOSE)
        reset = QDialogButtonBox.ButtonRole.ResetRole
        self.tracked = buttons.addButton(tr("Tracked cameras…"), reset)
        self.tracked.setAutoDefault(False)
        widgets.vbox(self.search, (self.table, 1), self.note, buttons, of=self)
        self.resize(900, 560)


class SeasonTask(DialogTask):
    """Lists the season that was opened last, and opens its matches."""

    dialog: SeasonDialog | None
    season: Season | None = None
    field: Field | None = None  # of matches of which the list names none

    def __init__(
        self, services: Services, settings: Settings, parent: QWidget,
        opens: Callable[[Path, Field | None], object],
    ) -> None:  # fmt: skip
        super().__init__(services, parent)
        self._settings, self._opens = settings, opens

    def read(
        self, path: Path, tracked: Path | None = None, none: Callable[[], object] = lambda: None
    ) -> None:
        """Show what `read_season` reads; ``none`` is called if it is no season."""
        self._work.start(
            lambda _: read_season(path, tracked),
            lambda season: self._show(season) if season else none(),
        )

    def read_again(self) -> None:
        """Show the season that was read last, as it is now."""
        if self.season is None:
            self._fail(tr("open a season first: a folder in which videos lie, or a list of them"))
        elif not self._work.running:
            self.read(self.season.path, self.season.tracked)

    def _show(self, season: Season) -> None:
        if self.season is None or season[:2] != self.season[:2]:
            self._settings.put_first(RECENT, season.tracked or season.path)
        self.season = season
        if self.dialog is None:
            self.dialog = dialog = SeasonDialog(self._parent)
            dialog.tracked.clicked.connect(self._ask_tracked)
            dialog.accepted.connect(self._open)
            dialog.finished.connect(self._leave)
            again = QTimer(dialog, interval=_AGAIN_MS)
            again.timeout.connect(lambda: self.read_again() if dialog.isVisible() else None)
            again.start()
        self.dialog.model.replace(season.rows)
        self.dialog.tell(tr_count(len(season.rows), "{n:,} match", "{n:,} matches"))
        self.dialog.open()  # before a row is chosen: columns are as wide as the texts in sight
        if not self.dialog.table.currentIndex().isValid():
            self.dialog.table.selectRow(0)
            self.dialog.table.setFocus()  # arrows choose a match

    def _open(self) -> None:
        at = self.dialog.table.currentIndex().siblingAtColumn(0) if self.dialog else None
        if at is not None and at.isValid() and self.season is not None:
            row = self.season.rows[at.data(_SORTED)]
            self._leave()
            self._opens(row.match.pictures, row.field or self.field)

    def _ask_tracked(self) -> None:
        if self.season is not None:
            start = str(self.season.tracked or self.season.path.parent)
            title = tr("The folder that track writes to")
            if chosen := QFileDialog.getExistingDirectory(self.dialog, title, start):
                self.read(self.season.path, Path(chosen))
