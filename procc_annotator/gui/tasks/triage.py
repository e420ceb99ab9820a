"""Going through a set worst first, and saying of each frame whose fault it is."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Literal

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QFileDialog, QInputDialog, QWidget

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.worker import Job, JobControl, run_in_background
from procc_annotator.io.atomic import write_atomic
from procc_annotator.report.verdicts import verdicts_csv
from procc_annotator.session.camera_set import CameraSet
from procc_annotator.session.triage import (
    Comparison,
    JudgedVerdict,
    compare_sources,
    judge_verdict,
    largest_error,
    next_worst,
    worst_first,
)
from procc_annotator.session.verdict import FAULT_WORDS, Fault

Order = Literal["jac", "error", "disagreement"]


class Triage(QObject):
    """Slots of the actions that walk and mark; the walk keeps its order while one walks."""

    progressed = Signal(int, int)  # frames compared, of how many; (0, 0) when it is over

    def __init__(self, document: Document, parent: QWidget) -> None:
        super().__init__(parent)
        self._document = document
        self._window = parent
        self._order: list[int] = []
        self._place = -1  # in the order, visited last
        self._order_of: tuple[object, ...] = ()
        self._kept: dict[tuple[object, ...], Comparison] = {}
        self._job: Job | None = None
        self._export: Job | None = None
        document.datasetChanged.connect(self._forget)
        document.camerasChanged.connect(self._forget_removed)

    # --- walking --------------------------------------------------------------------------

    def go_worst(self) -> None:
        """The frame with the lowest JaC, then the next better one."""
        scores = self._document.frame_scores
        self._walk("jac", lambda: dict(scores.items()), low=True)

    def go_largest_error(self) -> None:
        """The frame with the largest error of a point, then the next smaller one."""
        source = self._document.active_source
        if source is None:
            self._say_no_scores()
            return
        audits = source.audits

        def values() -> dict[str, float]:
            found = ((name, largest_error(audit)) for name, audit in audits.items())
            return {name: error for name, error in found if error is not None}

        self._walk("error", values, low=False)

    def go_disagreement(self) -> None:
        """The frame where the active source and the compared one differ most, then the next."""
        document = self._document
        pair = self._pair()
        if pair is None or document.workspace is None:
            document.message.emit(
                "two sources are needed to see where they disagree: load more cameras (Ctrl+L)",
                "info",
            )
            return
        found = self._kept.get(self._pair_key(*pair))
        if found is None:
            self._compare(*pair)
            return
        if not found.metres:
            document.message.emit(
                f"{pair[0].name} and {pair[1].name} cannot be compared on the ground in any frame",
                "info",
            )
            return
        self._walk("disagreement", lambda: found.metres, low=False, more=self._pair_key(*pair))

    def stop(self) -> None:
        """Stop comparing sources."""
        if self._job is not None:
            self._job.cancel()
            self._job = None
            self.progressed.emit(0, 0)
            self._document.message.emit("stopped comparing the sources", "info")

    def _walk(
        self,
        order: Order,
        values: Callable[[], dict[str, float]],
        *,
        low: bool,
        more: tuple[object, ...] = (),
    ) -> None:
        document = self._document
        workspace = document.workspace
        if workspace is None:
            self._say_no_scores()
            return
        found = values()
        allowed = document.frame_scores.allowed
        if allowed is not None:
            found = {name: value for name, value in found.items() if allowed(name)}
        if not found:
            self._say_no_scores()
            return
        # An edit changes a frame's value; while one walks its place stays, so that none is
        # visited twice and none is missed.
        key = (order, document.active_camera, document.tau, document.setup, frozenset(found), more)
        if key != self._order_of:
            self._order, self._order_of = worst_first(found, workspace.index, low=low), key
            self._place = -1
        place = next_worst(self._order, self._place, document.frame_index)
        if place is None:
            document.message.emit("no other frame has a score", "info")
            return
        again, self._place = place < self._place, place
        index = self._order[place]
        document.go_to(index)
        said = _said(order, found[workspace.frames[index].name])
        begun = "from the worst again: " if again else ""
        document.message.emit(
            f"{begun}{place + 1} of {len(self._order)}, worst first: {said}", "info"
        )

    def _say_no_scores(self) -> None:
        self._document.message.emit("no JaC yet: load cameras first", "info")

    def _pair(self) -> tuple[CameraSource, CameraSource] | None:
        """The active source and the one it is held against."""
        active, other = self._document.active_source, self._document.compared
        return None if active is None or other is None else (active, other)

    def _pair_key(self, a: CameraSource, b: CameraSource) -> tuple[object, ...]:
        """The same whichever of the two is active: metres do not depend on it."""
        setup = self._document.setup
        return frozenset((a.camera_set, b.camera_set)), setup.size, setup.field.name

    def _compare(self, a: CameraSource, b: CameraSource) -> None:
        document = self._document
        workspace, frame, setup = document.workspace, document.frame, document.setup
        if workspace is None or self._job is not None:
            return
        key = self._pair_key(a, b)
        names = [f.name for f in workspace.frames]
        first, second = a.camera_set, b.camera_set
        document.message.emit(f"comparing {a.name} with {b.name} over the set", "info")

        def work(control: JobControl) -> Comparison:
            return compare_sources(
                names, first, second, setup, control.progress, lambda: control.cancelled
            )

        def done(found: Comparison) -> None:
            self._job = None
            self.progressed.emit(0, 0)
            self._kept[key] = found
            if document.frame is frame:  # nobody has moved on meanwhile
                self.go_disagreement()
            else:
                document.message.emit(f"{a.name} and {b.name} are compared", "info")

        def failed(text: str) -> None:
            self._job = None
            self.progressed.emit(0, 0)
            document.message.emit(text, "error")

        self._job = run_in_background(
            work, on_result=done, on_error=failed, on_progress=self.progressed.emit, owner=self
        )

    def _forget(self) -> None:
        if self._job is not None:
            self._job.cancel()
            self._job = None
            self.progressed.emit(0, 0)
        self._kept.clear()
        self._order_of = ()

    def _forget_removed(self) -> None:
        """Comparisons of sources that are gone are not kept."""
        there = {source.camera_set for source in self._document.sources}
        self._kept = {
            key: found
            for key, found in self._kept.items()
            if isinstance(key[0], frozenset) and key[0] <= there
        }

    # --- marking --------------------------------------------------------------------------

    def mark(self, fault: str) -> None:
        """Give the frame on screen a verdict under the active source; the same again takes it
        back."""
        document = self._document
        source, frame = document.active_source, document.frame
        if frame is None or source is None:
            document.message.emit(
                "a verdict is on a frame and a camera: load cameras first", "info"
            )
            return
        if not document.projection_visible:
            document.message.emit(
                "blind: the camera is hidden until this frame is committed (Ctrl+Enter)", "info"
            )
            return
        chosen = Fault(fault)
        before = document.review.verdict(frame.name, source.name)
        if before is not None and before.fault is chosen:
            document.review.set_verdict(frame.name, source.name, None)
            document.message.emit(f"{frame.name}: no verdict on {source.name} any more", "info")
            return
        comment = before.comment if before is not None else ""
        document.review.set_verdict(frame.name, source.name, chosen, comment)
        document.message.emit(f"{frame.name}: {FAULT_WORDS[chosen]}, {source.name}", "info")

    def ask_note(self) -> None:
        """Ask for a few words on the verdict."""
        document = self._document
        source, frame = document.active_source, document.frame
        verdict = None
        if frame is not None and source is not None and document.projection_visible:
            verdict = document.review.verdict(frame.name, source.name)
        if frame is None or source is None or verdict is None:
            document.message.emit("mark the frame first: camera fault, annotation fault or fine",
                                  "info")  # fmt: skip
            return
        text, given = QInputDialog.getText(
            self._window, "Note on the verdict", "What is wrong here:", text=verdict.comment
        )
        if given:
            document.review.set_verdict(frame.name, source.name, verdict.fault, text.strip())

    # --- exporting ------------------------------------------------------------------------

    def ask_export(self) -> None:
        """Ask for a file and write all verdicts there."""
        document = self._document
        frame = document.frame
        if frame is None:
            document.message.emit("open a folder of pictures first", "warning")
            return
        start = frame.image_path.parent.parent / "verdicts.csv"
        chosen, _ = QFileDialog.getSaveFileName(
            self._window, "Export verdicts", str(start), "Table (*.csv)"
        )
        if chosen:
            path = Path(chosen)
            self.export(path if path.suffix else path.with_suffix(".csv"))

    def export(self, path: Path) -> None:
        """Write all verdicts with their figures at tau as CSV."""
        document = self._document
        workspace = document.workspace
        if workspace is None:
            document.message.emit("open a folder of pictures first", "warning")
            return
        verdicts = [v for of_frame in document.review.all_verdicts().values()
                    for v in of_frame.values()]  # fmt: skip
        verdicts.sort(key=lambda v: (workspace.index.get(v.frame, len(workspace.frames)),
                                     v.frame, v.source))  # fmt: skip
        if not verdicts:
            document.message.emit("no frame has a verdict yet: mark one first", "info")
            return
        if not document.save_now():
            document.message.emit(
                "not everything could be saved: the figures are of the last saved state", "warning"
            )
        sets: dict[str, CameraSet] = {s.name: s.camera_set for s in document.sources}
        setup, tau, reopen = document.setup, document.tau, document.reopen

        def work(control: JobControl) -> int:
            fresh = reopen()

            def read(name: str) -> FrameAnnotation | None:
                index = fresh.index.get(name)
                return None if index is None else fresh.read(index)

            rows: list[JudgedVerdict] = []
            for done, verdict in enumerate(verdicts, start=1):
                if control.cancelled:
                    return 0
                rows.append(judge_verdict(verdict, sets.get(verdict.source), read, setup, tau))
                control.progress(done, len(verdicts))
            write_atomic(path, verdicts_csv(rows, setup.field, setup, tau).encode())
            return len(rows)

        self._export = run_in_background(
            work,
            on_result=lambda n: document.message.emit(f"exported {n} verdicts to {path}", "info"),
            on_error=lambda text: document.message.emit(text, "error"),
            owner=self,
        )


def _said(order: Order, value: float) -> str:
    if order == "jac":
        return f"JaC {value:.3f}"
    if order == "error":
        return f"largest error {value:.1f} px"
    return f"median disagreement {value:.2f} m"
