"""Walking through what the label check found, and mending it with one key."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from procc_annotator.annotation import FrameAnnotation, points_px
from procc_annotator.assist.frame_analysis import apply_remedy
from procc_annotator.calibration.label_check.finding import Finding, Remedy, RemedyKind, Severity
from procc_annotator.dataset.review import StoredFinding, by_severity
from procc_annotator.errors import ProccError, UsageError
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.gui.messages import ask_where, opened_frame
from procc_annotator.gui.panels.finding_rows import Entry
from procc_annotator.gui.panels.findings import so_many
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.services import Services
from procc_annotator.report.label_check import CheckReport, ReportedFinding, findings_csv
from procc_annotator.translation import (
    TranslatableText,
    tr,
    tr_count,
    translatable,
    translatable_count,
    word,
)

_MOST_NAMED = 2  # elements that fit the status bar by name

_SEVERITIES = {
    Severity.ERROR: word("error", "a finding"),
    Severity.WARNING: word("warning", "a finding"),
    Severity.HINT: word("hint", "a finding"),
}


class LabelCheckCommands(QObject):
    """Slots of the actions, the list and the menu that go to findings and do their remedies."""

    walked = Signal()  # a finding was gone to: its reason should be in sight
    followWanted = Signal(str)  # this element is to be put along its paint

    def __init__(self, services: Services, parent: QWidget) -> None:
        super().__init__(parent)
        self._services = services
        self._check = services.label_check
        self._window = parent
        self._passed: set[str] = set()  # keys of this frame's findings that were walked through
        self._passed_in = ""
        self._check.finished.connect(self._tell_finished)
        services.store.watch(select.dataset, self._forget_passed)

    # --- walking --------------------------------------------------------------------------

    def step(self, step: int) -> None:
        """Go to the next finding (1) or the one before (-1), from frame to frame."""
        services = self._services
        if services.state.workspace is None:
            return
        # What is in progress may become an element with findings.
        services.store.events.aboutToLeave.emit()
        entries = self._walked()
        if not entries:
            services.say(self._why_nothing())
            return
        at = self._next(entries, step)
        self.go(*entries[at])
        self._tell_place(at, entries)

    def go(self, frame: str, found: StoredFinding) -> None:
        """Show a finding: its frame, its element, its place."""
        services, workspace = self._services, self._services.state.workspace
        if workspace is None:
            return
        if frame != self._passed_in:
            self._passed_in = frame
            self._passed.clear()
        self._passed.add(found.key)
        services.navigator.go_to(workspace.index[frame])
        self._check.set_current(frame, found)
        self._show(found)
        self.walked.emit()

    def _forget_passed(self) -> None:
        """Frames of another dataset may have the same names."""
        self._passed_in = ""
        self._passed.clear()

    def _walked(self) -> list[Entry]:
        chosen = self._check.severities
        return [(n, f) for n, f in self._check.known.in_set() if f.finding.severity in chosen]

    def _next(self, entries: list[Entry], step: int) -> int:
        """Which finding comes next; the one walked to last may have been fixed meanwhile."""
        services, workspace = self._services, self._services.state.workspace
        here, current = services.state.frame, self._check.current
        assert workspace is not None  # the caller looked
        name = here.name if here is not None else ""
        if current is not None:
            for at, (frame, found) in enumerate(entries):
                if frame == name and found.key == current.key:
                    return (at + step) % len(entries)
        passed = self._passed if name == self._passed_in else set()
        order = range(len(entries)) if step > 0 else range(len(entries) - 1, -1, -1)
        for at in order:
            frame, found = entries[at]
            ahead = (workspace.index[frame] - services.state.frame_index) * step
            if ahead > 0 or (ahead == 0 and found.key not in passed):
                return at
        return order[0]

    def _tell_place(self, at: int, entries: list[Entry]) -> None:
        """In one line that fits; the panel, which opens, has the reason whole."""
        finding = entries[at][1].finding
        said = tr(
            "finding {place} of {total}, {severity}: {elements}",
            place=at + 1,
            total=len(entries),
            severity=tr(_SEVERITIES[finding.severity], "a finding"),
            elements=self._named(finding.elements),
        )
        remedy = f"F12: {tr(finding.remedies[0].text)}" if finding.remedies else ""
        self._services.say("; ".join(filter(None, (said, remedy))))

    def _named(self, elements: tuple[str, ...]) -> str:
        if len(elements) > _MOST_NAMED:
            return tr_count(len(elements), "{n} element", "{n} elements")
        titles = [self._services.state.title_of(name) for name in elements]
        if len(titles) == _MOST_NAMED:
            return tr("{element} and {other}", element=titles[0], other=titles[1])
        return "".join(titles)

    def _why_nothing(self) -> str:
        check = self._check
        if check.working:
            return tr("the label check is still looking at this frame")
        if not check.known.in_set():
            if check.known.count > 1:
                return tr("the label check has found nothing")
            return tr(
                "the label check has found nothing; check the whole set to look at all frames"
            )
        return tr("no finding is as sure as the Check panel is set to show")

    # --- showing --------------------------------------------------------------------------

    def look(self, found: StoredFinding) -> None:
        """Bring a finding of the frame on screen into sight."""
        self._check.set_current(self._services.state.frame_name or "", found)
        self._show(found)

    def _show(self, found: StoredFinding) -> None:
        services, size = self._services, self._services.state.picture_size
        annotated = set(services.state.annotation.annotated)
        if size is None or not found.places or not annotated.issuperset(p[0] for p in found.places):
            return
        name, index = found.places[0]
        annotation = services.state.annotation
        if found.finding.point is not None:
            services.selection.select_point(name, index)
            polyline = annotation.get(name)
            if polyline is not None and index < len(polyline.points):
                x, y = points_px(polyline, size)[index].tolist()
                services.store.events.flyTo.emit(x, y)
            return
        services.selection.select_point(None)
        services.selection.select_class(name)
        shown = [annotation.get(each) for each, _ in found.places]
        points = np.concatenate([points_px(p, size) for p in shown if p is not None])
        services.store.events.flyToArea.emit(
            *points.min(axis=0).tolist(), *points.max(axis=0).tolist()
        )

    # --- mending --------------------------------------------------------------------------

    def apply_first(self) -> None:
        """Do the first remedy of the current finding, or of the frame's surest one."""
        services = self._services
        services.store.events.aboutToLeave.emit()
        chosen = self._check.severities
        listed = [f for f in self._check.shown if f.finding.severity in chosen]
        found = self._check.current or next(iter(listed), None)
        if found is None and self._check.working:
            services.say(tr("the label check is still looking at this frame"))
        elif found is None:
            services.say(tr("the label check has found nothing in this frame"))
        elif not found.finding.remedies:
            services.say(tr("no remedy is known: {reason}", reason=found.finding.reason))
        else:
            self.apply(found, found.finding.remedies[0])

    def apply(self, found: StoredFinding, remedy: Remedy) -> None:
        """Do a remedy of a finding of the frame on screen, as one step of undo."""
        services, finding = self._services, found.finding
        if remedy.kind is RemedyKind.LOOK:
            self.look(found)
            services.say(tr(finding.reason))
            return
        services.store.events.aboutToLeave.emit()
        if found.key not in {known.key for known in self._check.shown}:
            services.say(tr("the elements have changed since: checked again"))
            return
        if remedy.kind is RemedyKind.FOLLOW:
            self.followWanted.emit(finding.elements[0])
            return
        done = self._done(finding, remedy)

        def mend(annotation: FrameAnnotation) -> FrameAnnotation:
            if not found.holds_for(annotation):  # another window changed them
                raise UsageError(tr("the elements have changed since: checked again"))
            return apply_remedy(annotation, finding, remedy, services.state.field)

        if not services.editing.edit(done, mend):
            return
        self._passed_in = self._services.state.frame_name or ""
        self._passed.add(found.key)
        shown = dict(remedy.renamed).get(finding.elements[0], finding.elements[0])
        services.selection.select_point(None)
        services.selection.select_class(shown)
        services.say(tr("{done}; Ctrl+Z takes it back", done=done))

    def _done(self, finding: Finding, remedy: Remedy) -> TranslatableText:

        def title(name: str) -> TranslatableText:
            return translatable(self._services.state.field.title_of(name))

        renamed = remedy.renamed
        if remedy.kind is RemedyKind.REMOVE_POINT:
            element = title(finding.elements[0])
            if finding.point is None:
                return translatable("removed point of {element}", element=element)
            return translatable(
                "removed point {n} of {element}", n=finding.point + 1, element=element
            )
        if remedy.kind is RemedyKind.SWAP and len(renamed) == 2:
            first, second = title(renamed[0][0]), title(renamed[1][0])
            return translatable("swapped {element} and {other}", element=first, other=second)
        if len(renamed) == 1:
            before, after = map(title, renamed[0])
            return translatable("relabelled {element} to {other}", element=before, other=after)
        return translatable_count(len(renamed), "relabelled {n} element", "relabelled {n} elements")

    # --- ignoring -------------------------------------------------------------------------

    def ignore_current(self) -> None:
        """Show the current finding no more."""
        found = self._check.current
        if found is None:
            self._services.say(tr("go to a finding first (F10)"))
            return
        self.ignore(self._services.state.frame_name or "", found)

    def ignore(self, frame: str, found: StoredFinding) -> None:
        """Show a finding no more, as long as the points of its elements stay as they are."""
        self._passed.add(found.key)
        self._check.known.ignore(frame, found.key)
        titles = ", ".join(map(self._services.state.title_of, found.finding.elements))
        self._services.say(
            tr("ignored until {elements} changes; the Check panel brings it back", elements=titles)
        )

    def restore(self) -> None:
        """Show the ignored findings of the frame on screen again."""
        if name := self._services.state.frame_name:
            self._check.known.restore(name)

    # --- the set --------------------------------------------------------------------------

    def check_set(self) -> None:
        """Check the whole set in the background."""
        if opened_frame(self._services) is None:
            return
        self._services.store.events.aboutToLeave.emit()
        if not self._check.running:
            self._check.check_set()

    def stop(self) -> None:
        """Stop checking the set."""
        if self._check.running:
            self._check.stop()
            self._services.say(tr("stopped checking the set; what was found stays"))

    def _tell_finished(self, checked: int) -> None:
        check = self._check
        found = [f for _, f in check.known.in_set()]
        counts = [so_many(severity, n) for severity, n in by_severity(found).items() if n]
        words = tr_count(
            checked,
            "checked {n:,} frame, camera model {model}: {found}",
            "checked {n:,} frames, camera model {model}: {found}",
            model=self._services.live_fit.model,
            found=", ".join(counts) if counts else tr("nothing found"),
        )
        if problems := len(check.problems):
            not_checked = tr_count(
                problems, "{n:,} frame cannot be checked", "{n:,} frames cannot be checked"
            )
            words = f"{words}; {not_checked}"
        self._services.say(words)

    def ask_export(self) -> None:
        """Ask for a file and write the findings of all checked frames there."""
        asked = self._services, self._window, tr("Export findings")
        if (path := ask_where(*asked, "findings.csv", tr("Table (*.csv)"))) is not None:
            self.export(path)

    def export(self, path: Path) -> None:
        """Write the findings of all checked frames as CSV, without those that are ignored."""
        services, known = self._services, self._check.known.count
        found = [
            ReportedFinding(frame, one.finding, checked.size)
            for frame, one in self._check.known.in_set()
            if (checked := self._check.known.check_of(frame)) is not None
        ]
        unreadable = list(self._check.problems.items())
        try:
            write_atomic(path, findings_csv(CheckReport(found=found, unreadable=unreadable)))
        except ProccError as error:
            services.say(str(error), "error", "export_findings")
            return
        frames = tr_count(known, "{n:,} checked frame", "{n:,} checked frames")
        services.say(
            tr_count(
                len(found),
                "exported {n:,} finding in {frames} to {path}",
                "exported {n:,} findings in {frames} to {path}",
                frames=frames,
                path=path,
            )
        )
