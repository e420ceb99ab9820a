"""Earlier versions of a frame: previewed and restored."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from datetime import datetime
from typing import Any

from PySide6.QtCore import QAbstractListModel, QModelIndex, QSize, Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import (
    QApplication,
    QListView,
    QWidget,
)

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.dataset import editing
from procc_annotator.dataset.records import OriginKind, Version
from procc_annotator.dataset.workspace import restore_version
from procc_annotator.errors import InputError, ProccError, SaveError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.gui.canvas.annotation_preview import AnnotationPreview
from procc_annotator.gui.commands.dialogs import CLOSE, NamedDialog, dialog_buttons
from procc_annotator.gui.panels.element_states import class_title
from procc_annotator.gui.panels.widgets import (
    Index,
    Pages,
    hbox,
    named,
    note_label,
    show_note,
    vbox,
)
from procc_annotator.gui.state.availability import no_frame
from procc_annotator.gui.state.services import Services
from procc_annotator.image.pixels import PixelArray
from procc_annotator.translation import tr, tr_count, translatable, word

_LIST_WIDTH = 350
_PAD = 7
_MOST_NAMES = 4
_NO_VERSION = word("There is no earlier version of this frame.")

_ROOT = QModelIndex()


class VersionsDialog(NamedDialog):
    """Choose an earlier version; ``chosen_id`` is its id once the dialog was accepted."""

    def __init__(
        self,
        parent: QWidget | None,
        versions: Sequence[Version],
        preview: Callable[[str], FrameAnnotation],
        picture: PixelArray | None,
        field: Field,
        size: tuple[int, int],
        current: FrameAnnotation,
    ) -> None:
        """Build the dialog.

        Args:
            versions: in any order; shown newest first.
            preview: reads a version by its id, once and only when it is examined; may raise a
                ProccError, which is shown in place of the version.
            picture: (H, W, 4) BGRA of the frame, or None if it cannot be shown.
            size: (width, height) of the picture, px; counts when there is no picture.
            current: the annotation as it is now.
        """
        super().__init__(parent, "versionsDialog", tr("Earlier versions"))
        self.chosen_id: str | None = None
        self._field = field
        self.model = VersionsModel(versions, preview, current)
        self.list = named(QListView(), "versionsList")
        self.list.setModel(self.model)
        self.list.setAlternatingRowColors(True)
        self.list.setUniformItemSizes(True)
        self.list.setFixedWidth(_LIST_WIDTH)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.preview = AnnotationPreview(picture, field, size)
        self.note = note_label("versionsNote")
        self.buttons, self.restore = dialog_buttons(self, tr("Restore"), CLOSE)
        self.restore.setObjectName("versionsRestore")
        self.restore.clicked.connect(self.accept)
        self._arrange()
        self.list.selectionModel().currentChanged.connect(self._show)
        self.list.setCurrentIndex(self.model.index(0))
        self._show()
        self.list.setFocus()  # the arrows go through the versions at once
        self.resize(900, 600)

    def accept(self) -> None:
        """Close and remember the version that is shown, unless it cannot be restored."""
        if self.restore.isEnabled():
            self.chosen_id = self.model.rows[self.list.currentIndex().row()].id
            super().accept()

    def _arrange(self) -> None:
        right = vbox((self.preview, 1), self.note, spacing=8)
        content = QWidget()
        content.setLayout(hbox(self.list, (right, 1), spacing=10, margins=0))
        self.pages = Pages(content, "versionsEmpty")
        self.pages.explain("" if self.model.rows else tr(_NO_VERSION))
        vbox((self.pages, 1), self.buttons, of=self)

    def _show(self) -> None:
        row = self.list.currentIndex().row()
        version = self.model.annotation(row) if row >= 0 else None
        current = self.model.current
        if isinstance(version, FrameAnnotation):
            self.preview.set_annotation(version)
            self.restore.setEnabled(version.polylines != current.polylines)
            show_note(self.note, comparison(version, current, self._field))
        else:
            self.preview.set_annotation(FrameAnnotation())
            self.restore.setEnabled(False)
            show_note(self.note, str(version or ""))


class VersionsModel(QAbstractListModel):
    """Versions, newest first; what a row holds is read when the row comes into view."""

    def __init__(
        self,
        versions: Sequence[Version],
        preview: Callable[[str], FrameAnnotation],
        current: FrameAnnotation,
    ) -> None:
        super().__init__()
        self.rows = sorted(versions, key=lambda v: (v.time, v.id), reverse=True)
        self._preview = preview
        self._read: dict[int, FrameAnnotation | ProccError] = {}
        self.current = current
        self._line_height = QFontMetrics(QApplication.font()).lineSpacing()

    def annotation(self, row: int) -> FrameAnnotation | ProccError:
        """The annotation of a row, or why it cannot be read."""
        if row not in self._read:
            try:
                self._read[row] = self._preview(self.rows[row].id)
            except ProccError as error:
                self._read[row] = error
        return self._read[row]

    def rowCount(self, parent: Index = _ROOT) -> int:
        return 0 if parent.isValid() else len(self.rows)

    def data(self, index: Index, role: int = Qt.ItemDataRole.DisplayRole) -> Any:
        row = index.row()
        if role == Qt.ItemDataRole.DisplayRole:
            when, author, reason, content = self.lines(row)
            return f"{when}   {author}\n{reason}\n{content}"
        if role == Qt.ItemDataRole.SizeHintRole:  # narrower than the list: longer lines are elided
            return QSize(_LIST_WIDTH - 20, 3 * self._line_height + 2 * _PAD)
        if role == Qt.ItemDataRole.ToolTipRole:
            return tr(self.rows[row].reason)
        return None

    def lines(self, row: int) -> tuple[str, str, str, str]:
        """Time, author, reason and content of a row, in words."""
        version, annotation = self.rows[row], self.annotation(row)
        when = datetime.fromtimestamp(version.time).strftime(
            tr("%d %b %Y, %H:%M:%S", "a moment; the month as %b is English, as %m a number")
        )
        content = tr("cannot be read")
        if isinstance(annotation, FrameAnnotation):
            difference = difference_words(annotation, self.current)
            content = f"{content_words(annotation)}  ({difference})"
        return when, version.author, tr(version.reason), content


def content_words(annotation: FrameAnnotation) -> str:
    """Return how much is annotated: "12 elements, 84 points"."""
    elements, points = _counts(annotation)
    if not elements:
        return tr("empty", "a version")
    return f"{_elements(elements)}, {_points(points)}"


def _elements(count: int) -> str:
    return tr_count(count, "{n} element", "{n} elements")


def _points(count: int) -> str:
    return tr_count(count, "{n} point", "{n} points")


def difference_words(version: FrameAnnotation, current: FrameAnnotation) -> str:
    """Return what restoring a version would add and take away: "+2 elements, −5 points"."""
    if version.polylines == current.polylines:
        return tr("as now")
    both = zip(_counts(version), _counts(current), (_elements, _points), strict=True)
    more = [(then - now, words) for then, now, words in both if then != now]
    changes = [f"{'+' if n > 0 else '−'}{words(abs(n))}" for n, words in more]
    if changes:
        return ", ".join(changes)
    return (
        tr("other elements")
        if set(version.annotated) != set(current.annotated)
        else tr("points moved")
    )


def comparison(version: FrameAnnotation, current: FrameAnnotation, field: Field) -> str:
    """A version against what is there now, with the names of the elements that differ."""
    if version.polylines == current.polylines:
        return tr("This is what the frame holds now.")
    was, now = (
        {p.class_name: p.points for p in a.polylines if p.points} for a in (version, current)
    )
    names = [n for n in {**now, **was} if was.get(n) != now.get(n)]
    if not names:
        return tr("Compared with now: the same points in another order of elements.")
    titles = [class_title(field, n) for n in names[:_MOST_NAMES]]
    if len(names) > _MOST_NAMES:
        titles.append(tr("{n} more", n=len(names) - _MOST_NAMES))
    words = difference_words(version, current)
    return tr(
        "Compared with now: {changes}. What differs: {elements}.",
        changes=words,
        elements=", ".join(titles),
    )


def _counts(annotation: FrameAnnotation) -> tuple[int, int]:
    return len(annotation.annotated), sum(len(p.points) for p in annotation)


class Versions:
    """Slot of the action."""

    def __init__(self, services: Services, parent: QWidget) -> None:
        self._services = services
        self._parent = parent

    def ask(self) -> None:
        """Show every saved version of the frame on screen; a chosen one becomes an edit."""
        services = self._services
        services.store.events.aboutToLeave.emit()
        services.saver.settle()  # what is written is a version too
        workspace, frame = services.state.workspace, services.state.frame
        database = services.review.database
        if workspace is None or frame is None or database is None:
            services.say(no_frame(services.state))
            return
        index = services.state.frame_index

        def read(version: str) -> FrameAnnotation:
            return workspace.parse(index, database.version_data(version))

        dialog = VersionsDialog(
            self._parent,
            database.versions(frame.name),
            read,
            services.navigator.picture,
            services.state.field,
            services.state.picture_size or (2, 2),
            services.state.annotation,
        )
        if dialog.exec() and dialog.chosen_id is not None:
            apply_version(services, dialog.chosen_id)
        dialog.deleteLater()


def apply_version(services: Services, version: str) -> None:
    """Make a saved version the annotation of the frame on screen; undo takes it back. Where the
    file cannot be read, it is replaced, and stays a version."""
    workspace, database = services.state.workspace, services.review.database
    if workspace is None or database is None:
        return
    seen, index = services.state.annotation, services.state.frame_index
    if services.state.damage:
        services.editing.look_at_frame()  # somebody may have mended it
    try:
        data = database.version_data(version)
        restored = workspace.parse(index, data)
        if services.state.damage:
            restore_version(workspace, index, data)
            services.editing.reload_frame()
            services.say(tr("the earlier version is back; what could not be read stays a version"))
            return
    except (InputError, SaveError) as error:
        services.say(str(error), "error")
        return

    def restore(annotation: FrameAnnotation) -> FrameAnnotation:
        if annotation is not seen:  # nobody decided to give up what somebody else just saved
            raise UsageError(tr("the frame was changed elsewhere: look at it, then restore again"))
        return editing.add_unconfirmed(restored, annotation.unconfirmed)

    if services.editing.edit(translatable("restore an earlier version"), restore, OriginKind.FILE):
        services.say(tr("the earlier version is back; undo takes it away again"))
