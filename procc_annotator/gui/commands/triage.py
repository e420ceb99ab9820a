"""Verdicts of frames and their export; locking a dataset to blind mode."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QInputDialog, QWidget

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.batch.triage import JudgedVerdict, judge_verdict
from procc_annotator.dataset.camera_set import CameraSet
from procc_annotator.dataset.records import FAULT_WORDS, FaultParty, Verdict, place_by_name
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.gui.messages import ask_to_unlock, ask_where, opened_frame, write
from procc_annotator.gui.panels.scores import VerdictRow
from procc_annotator.gui.state.availability import hidden, no_frame, no_source
from procc_annotator.gui.state.background import JobControl
from procc_annotator.gui.state.services import Services
from procc_annotator.report.window_tables import verdicts_csv
from procc_annotator.translation import tr, tr_count, word

_UNLOCKS_SHARED = word(
    "Unlocking shows cameras, ghosts and the fit to everybody who annotates it. It is recorded with"
    " the dataset that {author} unlocked it, and when."
)
_UNLOCKS_OWN = word(
    "Unlocking shows cameras, ghosts and the fit to you; for others it was not locked. It is"
    " recorded with the dataset that {author} unlocked it, and when."
)


class Triage(QObject):
    """Slots of the actions that mark a frame, export the verdicts and lock the dataset."""

    def __init__(self, services: Services, parent: QWidget) -> None:
        super().__init__(parent)
        self._services = services
        self._window = parent

    def serve(self, row: VerdictRow) -> None:
        """Do what the buttons below the scores ask for."""
        for fault, button in row.buttons.items():
            button.clicked.connect(lambda _=False, fault=str(fault): self.mark(fault))
            button.clicked.connect(row.refresh)  # also where nothing was marked

    # --- marking --------------------------------------------------------------------------

    def mark(self, fault: str) -> None:
        """Give the frame on screen a verdict under the active source; the same again takes it
        back."""
        services = self._services
        source, frame = services.state.active, services.state.frame
        if frame is None or source is None:
            services.say(no_frame(services.state) or no_source(services.state))
            return
        if source.files is None:
            follows = source is services.fit_source.source
            name = source.name
            services.say(
                tr(
                    "{source} follows the clicks: a verdict is on a camera that was loaded",
                    source=name,
                )
                if follows
                else tr(
                    "{source} is worked out here: a verdict is on a camera that was loaded",
                    source=name,
                )
            )
            return
        if why := hidden(services.state):
            services.say(why)
            return
        chosen = FaultParty(fault)
        before = services.review.verdict(frame.name, source)
        if before is not None and before.fault is chosen:
            services.review.set_verdict(frame.name, source, None)
            is_undone = tr(
                "{frame}: no verdict on {source} any more", frame=frame.name, source=source.name
            )
            services.say(is_undone)
            return
        comment = before.comment if before is not None else ""
        services.review.set_verdict(frame.name, source, chosen, comment)
        services.say(f"{frame.name}: {tr(FAULT_WORDS[chosen], 'a verdict')}, {source.name}")

    def ask_note(self) -> None:
        """Ask for a few words on the verdict."""
        services = self._services
        source, name = services.state.active, services.state.frame_name
        verdict = services.review.shown_verdict(name) if name is not None else None
        if name is None or source is None or verdict is None:
            services.say(tr("mark the frame first: camera wrong, labels wrong or fine"))
            return
        text, given = QInputDialog.getText(
            self._window, tr("Note on the verdict"), tr("What is wrong here:"), text=verdict.comment
        )
        if given:
            services.review.set_verdict(name, source, verdict.fault, text.strip())

    # --- exporting ------------------------------------------------------------------------

    def ask_export(self) -> None:
        """Ask for a file and write all verdicts there."""
        asked = self._services, self._window, tr("Export verdicts")
        if (path := ask_where(*asked, "verdicts.csv", tr("Table (*.csv)"))) is not None:
            self.export(path)

    def export(self, path: Path) -> None:
        """Write all verdicts with their figures at tau as CSV."""
        services = self._services
        if opened_frame(services) is None:
            return
        every = [
            v for of_frame in services.review.all_verdicts().values() for v in of_frame.values()
        ]
        revealed = services.state.revealed_frames
        verdicts = [v for v in every if revealed is None or v.frame in revealed]
        if not verdicts:
            hidden = tr("blind: no frame that is committed has a verdict")
            none = tr("no frame has a verdict yet: mark one first")
            services.say(hidden if every else none)
            return
        if not services.editing.save_now():
            services.say(
                tr("not everything could be saved: the figures are of the last saved state"),
                "warning",
            )
        left = len(every) - len(verdicts)
        more = tr("blind mode leaves out {n} on frames that are not committed", n=left)

        def said(count: int) -> str:
            done = tr_count(
                count,
                "exported {n:,} verdict to {path}",
                "exported {n:,} verdicts to {path}",
                path=path,
            )
            return f"{done}; {more}" if left else done

        write(
            services,
            self._writing(path, self._in_order(verdicts)),
            said,
            owner=self,
            again="export_verdicts",
        )

    # --- blind mode -----------------------------------------------------------------------

    def set_locked(self, locked: bool) -> None:
        """Lock the dataset for everybody; unlock it once a person said so knowingly."""
        lock = self._services.blind_lock
        if locked or self._services.state.blind_lock is None or self._confirmed(lock.reason):
            lock.set_locked(locked)
        lock.refused.emit()  # the action shows the present state

    def _confirmed(self, reason: str) -> bool:
        words = _UNLOCKS_OWN if self._services.review.reach else _UNLOCKS_SHARED
        lost = tr(words, author=self._services.state.author)
        return ask_to_unlock(self._window, reason, lost)

    # --- inside ---------------------------------------------------------------------------

    def _in_order(self, verdicts: list[Verdict]) -> list[Verdict]:
        """As the frames lie in the set; those of frames that are gone behind."""
        workspace = self._services.state.workspace
        places = workspace.index if workspace is not None else {}
        return sorted(verdicts, key=lambda v: (places.get(v.frame, len(places)), v.frame, v.source))

    def _writing(self, path: Path, verdicts: list[Verdict]) -> Callable[[JobControl], int]:
        """Return what writes the verdicts, in a thread of its own, and returns how many."""
        services = self._services
        sets: dict[str, CameraSet] = {}
        for source in services.state.sources:
            if (files := source.files) is not None:
                sets[services.review.place(source)] = sets[place_by_name(source.name)] = files
        setup, tau, reopen = services.state.setup, services.state.tau, services.opening.reopener()

        def work(control: JobControl) -> int:
            fresh = reopen()

            def read(name: str) -> FrameAnnotation | None:
                index = fresh.index.get(name)
                return None if index is None else fresh.annotation_to_score(index)

            rows: list[JudgedVerdict] = []
            for done, verdict in enumerate(verdicts, start=1):
                control.progress_or_stop(done, len(verdicts))
                rows.append(judge_verdict(verdict, sets.get(verdict.place), read, setup, tau))
            write_atomic(path, verdicts_csv(rows, setup.field, setup, tau))
            return len(rows)

        return work
