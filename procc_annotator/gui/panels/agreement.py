"""Agreement with a second annotator, class by class, and the noise of both."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from PySide6.QtCore import QTimer
from PySide6.QtGui import QFont
from PySide6.QtWidgets import (
    QHeaderView,
)

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.errors import InputError
from procc_annotator.gui.panels.element_states import class_title
from procc_annotator.gui.panels.widgets import (
    ElementRowsModel,
    ElementTable,
    Panel,
    empty_state,
    make_button,
    make_label,
    vbox,
)
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import bold
from procc_annotator.metrics.agreement import (
    AgreementAccumulator,
    AgreementSummary,
    ClassAgreement,
    FrameAgreement,
    compare_annotations,
)
from procc_annotator.translation import tr, tr_count, word

_NONE = word("Open a second annotator's folder (menu File) to compare the clicks of both.")
_APART = word(
    "Apart: the two share (almost) no stretch of this element, which is no agreement."
    " Was its class swapped with a neighbour's?"
)
_ERRORS_SHOWN = 10
_RESTED_MS = 1_000  # all files of a set are gone through: not with every click


@dataclass(frozen=True, slots=True)
class _MeasuredSet:
    """The set's figures, and one line for each frame that could not be read."""

    summary: AgreementSummary
    size: tuple[int, int]  # of the evaluation
    errors: tuple[str, ...]


class _Row(NamedTuple):
    """One element: its name, two distances, and how many of its clicks were compared."""

    class_name: str
    texts: tuple[str, ...]
    tip: str
    apart: bool = False


class _AgreementModel(ElementRowsModel[_Row]):
    """Agreement of both by class, least first."""

    def __init__(self) -> None:
        super().__init__((word("Element"), word("Median"), "95 %", word("Points")), first_figure=1)

    def texts(self, row: _Row) -> Sequence[str]:
        return row.texts

    def tip(self, row: _Row) -> str:
        return f"{row.texts[0]}\n{row.tip}"  # a narrow panel cuts the name

    def font(self, row: _Row) -> QFont | None:
        return bold(QFont()) if row.apart else None


class AgreementPanel(Panel):
    """Distances between two annotators in this frame, and over the set: the human noise floor."""

    def __init__(self, services: Services) -> None:
        super().__init__(services, "agreement_panel")
        self._measuring = LatestOnlyTask(self, self._say_of_set)
        self._build()
        self._follow(
            lambda s: (
                s.workspace,
                s.frame_index,
                s.annotation,
                s.setup,
                s.tau,
                s.projection_visible,
            ),
            services.second_annotator.changed,
        )
        services.second_annotator.changed.connect(self._forget_noise)
        services.second_annotator.opened.connect(self._compare)
        self._rested = QTimer(self, singleShot=True, interval=_RESTED_MS)
        self._rested.timeout.connect(self._measure_again)
        services.store.watch(select.score, self._rested.start)
        services.store.events.framesEdited.connect(self._rested.start)
        self._refresh()

    def _compare(self) -> None:
        services = self._services
        services.second_annotator.show(
            services.state.frame.name if services.state.frame is not None else None
        )
        services.evaluation.set_noise_floor(None)  # that of another annotator
        self._say_of_set(tr("Measuring the set…"))
        self._measure_set()

    def _build(self) -> None:
        self.empty = empty_state(tr(_NONE), "agreement_empty")
        self.noise = make_label(name="agreementNoise", wrap=True)
        self.frame = make_label(name="agreementFrame", wrap=True)
        self.rows = _AgreementModel()
        self.table = ElementTable("agreementTable", self.rows, {})
        self.table.setAccessibleName(tr("Distances by element"))
        header = self.table.horizontalHeader()
        for figures in (1, 2, 3):
            header.setSectionResizeMode(figures, QHeaderView.ResizeMode.ResizeToContents)
        self.table.chosen.connect(
            lambda row: self._services.selection.select_class(self.rows.rows[row].class_name)
        )
        close = self._services.second_annotator.close
        self.close_button = make_button(tr("Close the second annotator"), close)
        parts = (self.empty, self.noise, self.frame, self.table, self.close_button)
        vbox(*parts, of=self, margins=6)

    # --- showing --------------------------------------------------------------------------

    def _refresh(self) -> None:
        services = self._services
        second = services.second_annotator
        for part in (self.noise, self.frame, self.table, self.close_button):
            part.setVisible(second.is_open)
        self.empty.setVisible(not second.is_open)
        if not second.is_open:
            return
        rows: list[_Row] = []
        if second.error:
            text = tr(
                "The second annotator's file for this frame is unreadable: {error}",
                error=second.error,
            )
        elif not services.state.projection_visible:
            text = tr("Hidden: blind mode shows the score once this frame is committed.")
        elif (
            found := second.agreement(services.state.shown_annotation, services.state.setup.size)
        ) is None:
            text = tr("The second annotator has nothing for this frame.")
        else:
            text = "\n".join(self._frame_lines(found))
            # What agrees least comes first.
            ranked = sorted(found.by_class.values(), key=lambda c: (not c.apart, -(c.p95 or 0.0)))
            field = services.state.field
            rows = [_row(entry, class_title(field, entry.class_name)) for entry in ranked]
        self.frame.setText(text)
        self.rows.replace(rows)

    def _frame_lines(self, found: FrameAgreement) -> list[str]:
        services = self._services
        jac = found.jac(services.state.tau)
        lines = [tr("Agreement JaC at {tau:g} px: {jac:.3f}", tau=services.state.tau, jac=jac)]
        if found.mirrored_hint:
            lines.append(tr("One of the two seems to label the field turned by 180 degrees."))
        for names, what in (
            (
                tuple(c.class_name for c in found.by_class.values() if c.apart),
                word("Apart: {elements}"),
            ),
            (found.only_a, word("Only here: {elements}")),
            (found.only_b, word("Only there: {elements}")),
        ):
            if names:
                titles = ", ".join(class_title(services.state.field, n) for n in names)
                lines.append(tr(what, elements=titles))
        beyond = sum(c.left_out for c in found.by_class.values() if not c.apart)
        if beyond:
            lines.append(
                tr_count(
                    beyond,
                    "{n:,} click beyond the other's ends, left out",
                    "{n:,} clicks beyond the other's ends, left out",
                )
            )
        return lines

    def _forget_noise(self) -> None:
        if not self._services.second_annotator.is_open:
            self._measuring.cancel()
            self._services.evaluation.set_noise_floor(None)

    # --- the set --------------------------------------------------------------------------

    def _measure_set(self) -> None:
        """The noise floor over all frames that both annotated, in the background."""
        services = self._services
        workspace, second = services.state.workspace, services.second_annotator
        self._measuring.cancel()
        if workspace is None:
            return
        field, size, tau = services.state.field, services.state.setup.size, services.state.tau
        names = [frame.name for frame in workspace.frames]
        read_other = second.reader()

        def work(control: JobControl) -> _MeasuredSet:
            sums = AgreementAccumulator((tau,))
            errors: list[str] = []
            for index, name in enumerate(names):
                if control.cancelled:
                    break
                try:
                    other: FrameAnnotation | None = read_other(name)
                    mine = workspace.read(index) if other is not None else None
                except InputError as error:
                    errors.append(str(error))
                    continue
                if mine is not None and other is not None and mine.annotated:
                    sums.add(name, compare_annotations(mine, other, field, size))
            return _MeasuredSet(sums.summary(), size, tuple(errors))

        self._measuring.start(work, self._take_set)

    def _measure_again(self) -> None:
        """Clicks or terms may be others than those that were measured."""
        if self._services.second_annotator.is_open:
            self._measure_set()

    def _take_set(self, measured: _MeasuredSet) -> None:
        summary, size = measured.summary, measured.size
        median, p95 = summary.overall.median, summary.overall.p95
        floor = None if median is None or p95 is None else (median, p95)
        if not summary.overall.common:
            text = tr("No element is annotated by both in any frame.")
        elif floor is None:
            text = tr("Nothing to measure noise by: all elements annotated by both are apart.")
        else:
            text = tr_count(
                summary.frames,
                "Human noise over {n:,} frame: median {median:.2f} px, 95 % within {p95:.2f} px (at"
                " {width}x{height})",
                "Human noise over {n:,} frames: median {median:.2f} px, 95 % within {p95:.2f} px"
                " (at {width}x{height})",
                median=floor[0],
                p95=floor[1],
                width=size[0],
                height=size[1],
            )
        self._say_of_set(text, measured.errors)
        self._services.evaluation.set_noise_floor(floor)

    def _say_of_set(self, text: str, errors: tuple[str, ...] = ()) -> None:
        """Put a line on the set; frames that could not be read follow it, their errors in a tip."""
        if errors:
            unread = tr_count(
                len(errors),
                "{n:,} frame unreadable, not compared",
                "{n:,} frames unreadable, not compared",
            )
            text = f"{text}\n{unread}"
        shown = list(errors[:_ERRORS_SHOWN])
        if len(errors) > len(shown):
            shown.append(tr_count(len(errors) - len(shown), "and {n} more", "and {n} more"))
        self.noise.setText(text)
        self.noise.setToolTip("\n".join(shown))


def _row(entry: ClassAgreement, title: str) -> _Row:
    compared = len(entry.distances)
    points = str(compared)
    if entry.left_out:
        points = tr("{part} of {total}", part=compared, total=compared + entry.left_out)
    if entry.apart:
        apart = tr("apart")
        return _Row(entry.class_name, (title, apart, apart, points), tr(_APART), apart=True)
    tip = tr_count(compared, "{n:,} click compared", "{n:,} clicks compared")
    if entry.left_out:
        tip = tr_count(
            entry.left_out,
            "{compared}, {n} left out: beyond the ends of what the other clicked",
            "{compared}, {n} left out: beyond the ends of what the other clicked",
            compared=tip,
        )
    return _Row(entry.class_name, (title, _px(entry.median), _px(entry.p95), points), tip)


def _px(value: float | None) -> str:
    return "–" if value is None else f"{value:.2f} px"
