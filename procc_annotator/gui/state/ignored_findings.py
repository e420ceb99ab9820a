"""Findings of the label check that a person examined and let be, in this window or another one."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.review import SETTING
from procc_annotator.gui.state.review_state import ReviewState


class IgnoredFindings(QObject):
    """Keys of ignored findings by frame, as the dataset remembers them.

    A key holds for the points a finding was found in: it means nothing once they change, and the
    same again if that is undone. So none is ever forgotten but by `restore`.
    """

    changed = Signal(str)  # a frame of which another finding is ignored, or one fewer

    def __init__(self, review: ReviewState, parent: QObject) -> None:
        super().__init__(parent)
        self._review = review
        self._keys: dict[str, frozenset[str]] = {}
        self._read_from: WorkspaceDatabase | None = None
        review.settingChanged.connect(self._take)

    def of(self, frame: str) -> frozenset[str]:
        """Keys of the findings of a frame that are ignored."""
        return self._known().get(frame, frozenset())

    def add(self, frame: str, key: str) -> None:
        """Ignore a finding."""
        self._review.set_setting(f"{SETTING}{key} {frame}", "yes")

    def restore(self, frame: str) -> None:
        """Ignore no finding of a frame any more."""
        for key in self.of(frame):
            self._review.set_setting(f"{SETTING}{key} {frame}", None)

    def _known(self) -> dict[str, frozenset[str]]:
        database = self._review.database
        if database is not self._read_from:
            self._read_from, self._keys = database, {}
            for setting in database.settings() if database is not None else ():
                self._read(setting)
        return self._keys

    def _read(self, setting: str) -> str | None:
        """Take over one setting; the frame it is about, if it is about an ignored finding."""
        if not setting.startswith(SETTING):
            return None
        key, _, frame = setting.removeprefix(SETTING).partition(" ")
        here = self._keys.get(frame, frozenset())
        is_ignored = self._review.setting(setting) is not None
        self._keys[frame] = here | {key} if is_ignored else here - {key}
        return frame

    def _take(self, setting: str) -> None:
        self._known()
        frame = self._read(setting)
        if frame is not None:
            self.changed.emit(frame)
