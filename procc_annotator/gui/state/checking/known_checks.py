"""Results of the label check by frame, without what blind mode hides and what was ignored."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QObject, Signal

from procc_annotator.calibration.label_check.finding import Rule, Severity
from procc_annotator.dataset.database.database import WorkspaceDatabase
from procc_annotator.dataset.review import (
    SETTING,
    FrameCheck,
    StoredFinding,
    with_set_findings,
    worst_severity,
)
from procc_annotator.gui.state.review_state import ReviewState
from procc_annotator.gui.state.store import Store


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


class KnownChecks:
    """Checks by frame, seen through blind mode and without the findings that are ignored."""

    def __init__(self, store: Store, ignored: IgnoredFindings) -> None:
        self._store, self._ignored = store, ignored
        self._frames: dict[str, FrameCheck] = {}
        # Frame -> the finding of the whole set, and the content it is valid for.
        self._set_findings: dict[str, tuple[str, StoredFinding]] = {}
        self._in_set: tuple[tuple[str, StoredFinding], ...] | None = None  # until anything changes

    # --- asking -------------------------------------------------------------------------------

    def check_of(self, frame: str) -> FrameCheck | None:
        """The check of a frame if it may be shown: a fitted camera says something by what it finds,
        by what it does not find, and by the places of marks."""
        kept = self._frames.get(frame)
        return (
            None if kept is None or (kept.fitted and not self._store.state.reveals(frame)) else kept
        )

    def of(self, frame: str) -> tuple[StoredFinding, ...]:
        """Findings of a frame, as far as it was checked and blind mode lets them be seen."""
        kept = self.check_of(frame)
        if kept is None:
            return ()
        content, by_set = self._set_findings.get(frame, (None, None))
        if by_set is not None and content == kept.content and kept.fitted:
            kept = with_set_findings(kept, by_set)
        if not kept.found:
            return ()
        ignored = self._ignored.of(frame)
        return tuple(found for found in kept.found if found.key not in ignored)

    def ignored_here(self) -> int:
        """Return how many findings of the frame on screen are ignored."""
        name = self._store.state.frame_name
        kept = self.check_of(name) if name is not None else None
        if name is None or kept is None:
            return 0
        ignored = self._ignored.of(name)
        return sum(found.key in ignored for found in kept.found)

    def is_known(self, frame: str) -> bool:
        """Return whether a frame was checked as it is, by every rule that may be shown."""
        kept = self.check_of(frame)
        if kept is None or not kept.content:
            return False
        return kept.fitted or not self._store.state.reveals(frame)

    def severities_of(self, frame: str) -> frozenset[Severity] | None:
        """Return how sure the findings of a frame are; None if it was not checked."""
        if not self.is_known(frame):
            return None
        return frozenset(found.finding.severity for found in self.of(frame))

    def worst(self, frame: str) -> Severity | None:
        """Return how sure the surest finding of a frame is; None for none."""
        return worst_severity(self.of(frame))

    def in_set(self) -> tuple[tuple[str, StoredFinding], ...]:
        """Every finding with its frame, in the order of the frames."""
        if self._in_set is None:
            workspace = self._store.state.workspace
            index = workspace.index if workspace is not None else {}
            names = sorted((n for n in self._frames if n in index), key=index.__getitem__)
            self._in_set = tuple((name, found) for name in names for found in self.of(name))
        return self._in_set

    @property
    def count(self) -> int:
        """Return how many frames were checked."""
        return sum(self.is_known(name) for name in self._frames)

    # --- taking down --------------------------------------------------------------------------

    def get(self, frame: str) -> FrameCheck | None:
        """The check of a frame, whether it may be shown or not."""
        return self._frames.get(frame)

    def keep(self, frame: str, checked: FrameCheck) -> None:
        """Keep the check of a frame."""
        self._frames[frame] = checked

    def drop(self, frame: str) -> bool:
        """A frame is another one now; whether it was checked."""
        return self._frames.pop(frame, None) is not None

    def keep_set_findings(self, checks: Mapping[str, FrameCheck]) -> None:
        """Keep the findings of the set beside those found anew whenever a frame is shown."""
        self._set_findings = {
            name: (checked.content, found)
            for name, checked in checks.items()
            for found in checked.found
            if found.finding.rule is Rule.OTHER_SIDE
        }

    def look_at_set_again(self, _: str = "") -> None:
        """Something is known of a frame, or may be shown, that was not before."""
        self._in_set = None

    def forget(self) -> None:
        """Nothing of what was found counts any more."""
        self._frames.clear()
        self._set_findings.clear()
