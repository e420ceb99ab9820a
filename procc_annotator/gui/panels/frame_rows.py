"""The frames of the dataset and their folders as rows, with thumbnails, read when painted."""

from __future__ import annotations

import itertools
import math
from bisect import bisect_left, bisect_right
from collections import OrderedDict, deque
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
from PySide6.QtCore import QAbstractListModel, QModelIndex, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication

from procc_annotator.calibration.label_check.finding import Severity
from procc_annotator.dataset.frames import Folder, folders_of, rows_of
from procc_annotator.dataset.records import FaultParty, Status
from procc_annotator.dataset.workspace import Workspace
from procc_annotator.errors import ImageError, InputError
from procc_annotator.gui.panels.widgets import Index
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask, after_paint
from procc_annotator.gui.state.services import Services
from procc_annotator.image.decoding import FrameCache, decode_thumbnail, downscale_to
from procc_annotator.image.pixels import PixelArray
from procc_annotator.translation import tr, tr_count

_KEPT = 150  # 192 x 108 x 4 bytes each: 12 MB
_BATCH = 4
_MOST_WANTED = 60  # more were only scrolled past
_SOON_MS, _HAND_MS = 20, 100  # after a frame is painted; after another look at a busy hand
_SIDE = 192

Decoded = list[tuple[Path, PixelArray | None]]


class Thumbnails(QObject):
    """Small pictures by path. Ask with `image`; `arrived` says of which paths an answer came."""

    arrived = Signal(list)

    def __init__(self, cache: FrameCache, parent: QObject) -> None:
        super().__init__(parent)
        self._cache = cache
        self._images: OrderedDict[Path, QImage | None] = OrderedDict()
        self._wanted: dict[Path, tuple[int, int]] = {}  # what is wanted sooner has less
        self._asked = itertools.count()
        self._looks = 0
        self._look_over = QTimer(self, singleShot=True, interval=0)
        self._work = LatestOnlyTask(self, None)  # unreadable pictures are part of the outcome
        self._start_soon = QTimer(self, singleShot=True, interval=_SOON_MS)
        self._start_soon.timeout.connect(self._start)

    def image(self, path: Path) -> QImage | None:
        """The thumbnail if it is here, else None, and it is fetched; a null image: unreadable."""
        if path in self._images:
            self._images.move_to_end(path)
            return self._images[path] or QImage()
        if not self._look_over.isActive():  # rows are painted together, in one turn
            self._looks += 1
            self._look_over.start()
        self._wanted[path] = (-self._looks, next(self._asked))
        if len(self._wanted) > _MOST_WANTED:
            del self._wanted[max(self._wanted, key=self._wanted.__getitem__)]
        # Anyone who asks again and again, as rows do that are painted often, puts nothing off.
        if not self._start_soon.isActive() and not self._work.running:
            self._start_soon.start(_SOON_MS)
        return None

    def clear(self) -> None:
        """Forget everything; another dataset was opened."""
        self._work.cancel()
        self._images.clear()
        self._wanted.clear()

    def _start(self) -> None:
        if not self._wanted or self._work.running:
            return
        if QApplication.mouseButtons() != Qt.MouseButton.NoButton:
            self._start_soon.start(_HAND_MS)  # whatever the mouse holds comes first
            return
        batch = sorted(self._wanted, key=self._wanted.__getitem__)[:_BATCH]
        for path in batch:
            del self._wanted[path]
        cache = self._cache
        self._work.start(lambda control: _decode(batch, cache, control), self._arrive)

    def _arrive(self, decoded: Decoded) -> None:
        for path, pixels in decoded:
            self._images[path] = None if pixels is None else _to_image(pixels)
            self._wanted.pop(path, None)  # its row was painted again meanwhile
        while len(self._images) > _KEPT:
            self._images.popitem(last=False)
        self.arrived.emit([path for path, _ in decoded])
        self._start()


def _decode(paths: list[Path], cache: FrameCache, control: JobControl) -> Decoded:
    decoded: Decoded = []
    for path in paths:
        if control.cancelled:
            break
        try:
            picture = cache.peek(path)
            small = (
                decode_thumbnail(path, _SIDE) if picture is None else downscale_to(picture, _SIDE)
            )
            decoded.append((path, small))
        except ImageError:
            decoded.append((path, None))
    return decoded


def _to_image(pixels: PixelArray) -> QImage:
    height, width = pixels.shape[:2]
    pixels = np.ascontiguousarray(pixels)
    image = QImage(pixels.data, width, height, 4 * width, QImage.Format.Format_RGB32)
    return image.copy()  # owns its memory, whatever becomes of the array


_FIGURES_BUDGET_S = 0.003
_SETTLED_MS = 150
_DONE = frozenset({Status.DONE, Status.APPROVED})


class FolderFigures(QObject):
    """Status and score of the frames, by number; `changed` when they differ."""

    changed = Signal()

    def __init__(self, services: Services, parent: QObject) -> None:
        super().__init__(parent)
        self._services = services
        self._names: list[str] = []
        self._done = np.zeros(0, dtype=bool)
        self._jac = np.zeros(0)
        self._at = 0
        self._soon = QTimer(self, singleShot=True, interval=_SETTLED_MS)
        self._soon.timeout.connect(self._begin)
        self._go_on = after_paint(self, self._count)

    def reset(self, names: list[str]) -> None:
        """Other frames; none, where no folder is shown."""
        self._names = names
        self._done = np.zeros(len(names), dtype=bool)
        self._jac = np.full(len(names), math.nan)
        self._soon.stop()
        self._begin()

    def look_again(self) -> None:
        """Statuses or scores of some frames are other ones."""
        if self._services.scoring.frame_scores.allowed is not None:
            self._jac[:] = math.nan  # while blind nothing that was known before stays in sight
        if self._names:
            self._soon.start()

    def done(self, folder: Folder) -> int:
        """Return how many of a folder's frames are done or approved."""
        return int(self._done[folder.first : folder.past].sum())

    def jac(self, folder: Folder) -> float | None:
        """The mean of a folder's frames that have a score which may be seen; None without any."""
        known = self._jac[folder.first : folder.past]
        known = known[~np.isnan(known)]
        return float(known.mean()) if known.size else None

    def _begin(self) -> None:
        self._at = 0
        if self._names:
            self._go_on.start()

    def _count(self) -> None:
        review, scores = self._services.review, self._services.scoring.frame_scores
        end = perf_counter() + _FIGURES_BUDGET_S
        while self._at < len(self._names) and perf_counter() < end:
            name = self._names[self._at]
            self._done[self._at] = review.status(name) in _DONE
            self._jac[self._at] = scores.get(name, math.nan)
            self._at += 1
        if self._at < len(self._names):
            self._go_on.start()
        else:
            self.changed.emit()


_BUDGET_S = 0.004
_MAX_WAITING = 60  # rows on a large screen; others were only scrolled past


@dataclass(frozen=True, slots=True)
class RowInfo:
    """Contents of a row. ``count`` is None until known; ``thumbnail`` as in `Thumbnails.image`."""

    name: str
    thumbnail: QImage | None
    count: int | None
    unreadable: str
    dirty: bool
    jac: float | None
    status: Status = Status.UNTOUCHED
    comments: int = 0
    verdict: FaultParty | None = None  # under the active source
    has_errors: bool = False  # the label check is sure that something is wrong
    camera_problem: str = ""  # why the active source's camera cannot be used
    depth: int = 0  # how many folders it is shown in


@dataclass(frozen=True, slots=True)
class FolderInfo:
    """Contents of a folder's row. ``shown`` of its ``frames`` pass the filter."""

    label: str
    depth: int
    folded: bool
    frames: int
    shown: int
    done: int
    jac: float | None


class FramesModel(QAbstractListModel):
    """Rows of the frames that the filter lets through; in a tree also of their folders, which may
    be folded: then the frames in them have no row."""

    def __init__(self, services: Services, cache: FrameCache) -> None:
        super().__init__()
        self._services = services
        self._rows: range | list[int] = range(0)
        self.total = 0  # frames, shown or not
        self._row_of: dict[int, int] | None = None
        self._shown: list[int] | None = None
        self.folders: tuple[Folder, ...] = ()
        self._folded: set[str] = set()  # while all frames are shown
        self._folded_found: set[str] = set()  # while a filter shows some
        self.figures = FolderFigures(services, self)
        self._counts: dict[int, int | str] = {}
        self._wanted: deque[int] = deque(maxlen=_MAX_WAITING)
        self._unsaved: frozenset[int] = frozenset()
        self._thumbnails = Thumbnails(cache, self)
        self._thumbnails.arrived.connect(self._show_thumbnails)
        self._without_thumbnail: dict[Path, int] = {}  # frames
        self._count_soon = after_paint(self, self._count_some)
        self.scores = services.scoring.frame_scores

    # --- rows and frames -----------------------------------------------------------------------

    def reset(self) -> None:
        """Another dataset was opened."""
        workspace = self._services.state.workspace
        self._thumbnails.clear()
        self._counts.clear()
        self._without_thumbnail.clear()
        self._wanted.clear()
        frames = workspace.frames if workspace is not None else ()
        self.total = len(frames)
        self._shown = None
        self.scores = self._services.scoring.frame_scores
        names = [frame.name for frame in frames]
        self.folders = folders_of(names)
        here = self._services.state.frame_index
        self._folded = {folder.path for folder in self.folders if here not in folder}
        self._folded_found.clear()
        self.figures.reset(names if self.folders else [])
        self._find_rows()

    def show_only(self, shown: list[int] | None) -> None:
        """Show these frames only, or all of them (None)."""
        if shown != self._shown:
            self._shown = shown
            if shown is None:
                self._folded_found.clear()
            self._find_rows()

    def _find_rows(self) -> None:
        self.beginResetModel()
        self._row_of = None
        if self.folders:
            self._rows = rows_of(self.folders, self._now_folded, self._shown)
        else:
            self._rows = range(self.total) if self._shown is None else self._shown
        self.endResetModel()

    @property
    def shown(self) -> int:
        """Return how many frames the filter lets through, in folded folders, too."""
        return self.total if self._shown is None else len(self._shown)

    def frame_index(self, row: int) -> int:
        """The frame shown in a row; negative where that is a folder's."""
        return self._rows[row]

    # --- folders -------------------------------------------------------------------------------

    @property
    def _now_folded(self) -> set[str]:
        return self._folded if self._shown is None else self._folded_found

    def folder_at(self, row: int) -> Folder | None:
        """The folder shown in a row; None where that is a frame's."""
        shown = self._rows[row]
        return self.folders[-1 - shown] if shown < 0 else None

    def folder_of(self, row: int) -> int:
        """The row of the folder that a frame or a folder lies in, -1 without one."""
        folder = self.folder_at(row)
        depth = folder.depth if folder is not None else len(self.folders) + 1
        for above in range(row - 1, -1, -1):
            found = self.folder_at(above)
            if found is not None and found.depth < depth:
                return above
        return -1

    def is_folded(self, folder: Folder) -> bool:
        """Return whether a folder's frames are not shown."""
        return folder.path in self._now_folded

    def fold(self, folder: Folder, folded: bool) -> int:
        """Fold or unfold a folder; its row."""
        (self._now_folded.add if folded else self._now_folded.discard)(folder.path)
        self._find_rows()
        return self.row_of(-1 - self.folders.index(folder))

    def fold_all(self, folded: bool) -> None:
        """Fold or unfold all folders."""
        self._now_folded.clear()
        if folded:
            self._now_folded.update(folder.path for folder in self.folders)
        self._find_rows()

    def reveal(self, frame_index: int) -> None:
        """Unfold the folders that a frame lies in."""
        closed = {f.path for f in self.folders if frame_index in f} & self._now_folded
        if closed:
            self._now_folded.difference_update(closed)
            self._find_rows()

    def row_showing(self, frame_index: int) -> int:
        """The row of a frame, or of the folded folder around it; -1 if the filter hides it."""
        if (row := self.row_of(frame_index)) >= 0 or not self.folders:
            return row
        if self._shown is not None and frame_index not in self._shown:
            return -1
        around = (k for k, folder in enumerate(self.folders) if frame_index in folder)
        return max((self.row_of(-1 - k) for k in around), default=-1)

    def folder_info(self, row: int) -> FolderInfo | None:
        """Return what the row of a folder shows now; None where it is a frame's."""
        folder = self.folder_at(row)
        if folder is None:
            return None
        frames = shown = folder.past - folder.first
        if self._shown is not None:
            shown = bisect_left(self._shown, folder.past) - bisect_left(self._shown, folder.first)
        return FolderInfo(
            folder.label,
            folder.depth,
            self.is_folded(folder),
            frames,
            shown,
            self.figures.done(folder),
            self.figures.jac(folder),
        )

    # --- rows and their frames -----------------------------------------------------------------

    def row_of(self, frame_index: int) -> int:
        """The row of a frame, -1 if the filter hides it."""
        if isinstance(self._rows, range):
            return frame_index if frame_index in self._rows else -1
        if self._row_of is None:
            self._row_of = {frame: row for row, frame in enumerate(self._rows)}
        return self._row_of.get(frame_index, -1)

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008 (Qt's signature)
        return 0 if parent.isValid() else len(self._rows)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        workspace = self._services.state.workspace
        if workspace is None or role not in (
            Qt.ItemDataRole.DisplayRole,
            Qt.ItemDataRole.ToolTipRole,
            Qt.ItemDataRole.AccessibleTextRole,
        ):
            return None
        if (folder := self.folder_at(index.row())) is not None:
            return self._folder_words(folder, role)
        frame = workspace.frames[self._rows[index.row()]]
        if role == Qt.ItemDataRole.ToolTipRole:
            count = self._counts.get(self._rows[index.row()])
            problems = (count if isinstance(count, str) else "", self._camera_problem(frame.name))
            found = self._services.label_check.known.of(frame.name)
            errors = (tr(f.finding.reason) for f in found if f.finding.severity is Severity.ERROR)
            return "\n".join(filter(None, (str(frame.image_path), *problems, *errors)))
        return frame.name

    def _folder_words(self, folder: Folder, role: int) -> str:
        if role == Qt.ItemDataRole.DisplayRole:
            return folder.path
        count, done = folder.past - folder.first, self.figures.done(folder)
        words = [folder.path, tr_count(count, "{n:,} frame", "{n:,} frames")]
        words.append(tr_count(done, "{n:,} done", "{n:,} done"))
        if (jac := self.figures.jac(folder)) is not None:
            words.append(tr("mean JaC {jac:.3f}", jac=jac))
        words.append(tr("folded") if self.is_folded(folder) else tr("unfolded"))
        return ", ".join(words)

    # --- details -------------------------------------------------------------------------------

    def info(self, row: int) -> RowInfo | None:
        """Return what a row shows now; what is missing is fetched, and the row reported to be
        another one."""
        workspace = self._services.state.workspace
        if workspace is None:
            return None
        index = self._rows[row]
        if index < 0:
            return None
        frame = workspace.frames[index]
        count = self._counts.get(index)
        if count is None:
            if index not in self._wanted:
                self._wanted.append(index)
            if not self._count_soon.isActive():
                self._count_soon.start()
        thumbnail = self._thumbnails.image(frame.image_path)
        if thumbnail is None:
            self._without_thumbnail[frame.image_path] = index
        unreadable = count if isinstance(count, str) else ""
        if not unreadable and thumbnail is not None and thumbnail.isNull():
            unreadable = tr("the picture cannot be read")
        verdict = self._services.review.shown_verdict(frame.name)
        return RowInfo(
            frame.name.rpartition("/")[2] if self.folders else frame.name,
            thumbnail,
            count if isinstance(count, int) else None,
            unreadable,
            index in self._unsaved,
            self.scores.get(frame.name),
            (record := self._services.review.record(frame.name)).status,
            record.open_comments,
            None if verdict is None else verdict.fault,
            self._services.label_check.known.worst(frame.name) is Severity.ERROR,
            self._camera_problem(frame.name),
            self._depth(index),
        )

    def _depth(self, frame_index: int) -> int:
        """Return how many folders a frame is shown in."""
        if not self.folders:
            return 0
        place = bisect_right(self.folders, frame_index, key=lambda folder: folder.first) - 1
        return next(
            self.folders[k].depth + 1
            for k in range(place, -1, -1)
            if self.folders[k].first <= frame_index < self.folders[k].own_past
        )

    def _camera_problem(self, name: str) -> str:
        source = self._services.state.active
        if source is None or not self._services.state.reveals(name):
            return ""
        return source.problems.get(name, "")

    def recount(self, frame_index: int) -> None:
        """The frame's annotation changed. In memory it costs nothing to count; a file is read when
        its row is shown."""
        workspace = self._services.state.workspace
        if workspace is None or not 0 <= frame_index < len(workspace.frames):
            return
        if workspace.loaded_annotation(frame_index) is not None:
            self._counts[frame_index] = _count(workspace, frame_index)
        else:
            self._counts.pop(frame_index, None)

    def take_save_state(self) -> None:
        """Look again which frames are not saved."""
        before, self._unsaved = self._unsaved, frozenset(self._services.state.unsaved)
        for index in before ^ self._unsaved:
            self.repaint(index)

    def take_scores(self) -> None:
        """Look again at the per-frame scores."""
        self.scores = self._services.scoring.frame_scores
        self.figures.look_again()

    def repaint(self, frame_index: int) -> None:
        """Have one row painted again: all of them would cost as much as the canvas."""
        if (row := self.row_of(frame_index)) >= 0:
            self.dataChanged.emit(self.index(row), self.index(row))

    def _show_thumbnails(self, paths: list[Path]) -> None:
        for path in paths:
            if (index := self._without_thumbnail.pop(path, None)) is not None:
                self.repaint(index)

    def _count_some(self) -> None:
        """Count elements of waiting rows for a few milliseconds, the newest wish first."""
        workspace = self._services.state.workspace
        if workspace is None:
            return
        end = perf_counter() + _BUDGET_S
        while self._wanted and perf_counter() < end:
            index = self._wanted.pop()
            self._counts[index] = _count(workspace, index)
            self.repaint(index)
        if self._wanted:
            self._count_soon.start()


def _count(workspace: Workspace, frame_index: int) -> int | str:
    """Annotated elements of a frame, or why its file cannot be read."""
    try:
        return workspace.annotated_count(frame_index)
    except InputError as error:
        return str(error)
