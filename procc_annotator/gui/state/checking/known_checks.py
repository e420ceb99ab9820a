"""Results of the label check by frame, without what blind mode hides and what was ignored."""

from __future__ import annotations

from collections.abc import Mapping

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


class KnownChecks:
    """Checks by frame, seen through blind mode and without the findings that are ignored.

    The dataset remembers ignored findings by keys that hold for the points a finding was found in:
    a key means nothing once they change, and the same again if that is undone. So none is ever
    forgotten but by `restore`.

    Attributes:
        frames: frame -> its check, whether it may be shown or not.
    """

    def __init__(self, store: Store, review: ReviewState) -> None:
        self._store, self._review = store, review
        self.frames: dict[str, FrameCheck] = {}
        # Frame -> the finding of the whole set, and the content it is valid for.
        self._set_findings: dict[str, tuple[str, StoredFinding]] = {}
        self._in_set: tuple[tuple[str, StoredFinding], ...] | None = None  # until anything changes
        self._ignored: dict[str, frozenset[str]] = {}  # frame -> keys
        self._read_from: WorkspaceDatabase | None = None

    # --- ignored findings ---------------------------------------------------------------------

    def ignore(self, frame: str, key: str) -> None:
        """Ignore a finding."""
        self._review.set_setting(f"{SETTING}{key} {frame}", "yes")

    def restore(self, frame: str) -> None:
        """Ignore no finding of a frame any more."""
        for key in self._ignored_in(frame):
            self._review.set_setting(f"{SETTING}{key} {frame}", None)

    def take_setting(self, setting: str) -> str | None:
        """Take over one setting; return the frame if it is about an ignored finding."""
        if not setting.startswith(SETTING):
            return None
        key, _, frame = setting.removeprefix(SETTING).partition(" ")
        here = self._ignored.get(frame, frozenset())
        is_ignored = self._review.setting(setting) is not None
        self._ignored[frame] = here | {key} if is_ignored else here - {key}
        return frame

    def _ignored_in(self, frame: str) -> frozenset[str]:
        database = self._review.database
        if database is not self._read_from:
            self._read_from, self._ignored = database, {}
            for setting in database.settings() if database is not None else ():
                self.take_setting(setting)
        return self._ignored.get(frame, frozenset())

    # --- asking -------------------------------------------------------------------------------

    def check_of(self, frame: str) -> FrameCheck | None:
        """The check of a frame if it may be shown: a fitted camera says something by what it finds,
        by what it does not find, and by the places of marks."""
        kept = self.frames.get(frame)
        return None if kept and kept.fitted and not self._store.state.reveals(frame) else kept

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
        ignored = self._ignored_in(frame)
        return tuple(found for found in kept.found if found.key not in ignored)

    def ignored_here(self) -> int:
        """Return how many findings of the frame on screen are ignored."""
        name = self._store.state.frame_name
        kept = self.check_of(name) if name is not None else None
        if name is None or kept is None:
            return 0
        ignored = self._ignored_in(name)
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
            names = sorted((n for n in self.frames if n in index), key=index.__getitem__)
            self._in_set = tuple((name, found) for name in names for found in self.of(name))
        return self._in_set

    @property
    def count(self) -> int:
        """Return how many frames were checked."""
        return sum(self.is_known(name) for name in self.frames)

    # --- taking down --------------------------------------------------------------------------

    def keep_set_findings(self, checks: Mapping[str, FrameCheck]) -> None:
        """Keep the findings of the set beside those found anew whenever a frame is shown."""
        self._set_findings = {
            name: (checked.content, found)
            for name, checked in checks.items()
            for found in checked.found
            if found.finding.rule is Rule.OTHER_SIDE
        }

    def look_at_set_again(self) -> None:
        """Something is known of a frame, or may be shown, that was not before."""
        self._in_set = None

    def forget(self) -> None:
        """Nothing of what was found counts any more."""
        self.frames.clear()
        self._set_findings.clear()
