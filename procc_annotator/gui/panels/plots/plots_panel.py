"""Scores and errors as plots, of the frame on screen or of the set, of several sources at once."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from PySide6.QtCore import QRect, Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QGridLayout,
    QMenu,
    QSizePolicy,
    QStackedWidget,
    QToolButton,
)

from procc_annotator.field.landmarks import element_titles
from procc_annotator.gui.panels.plots.export import ExportablePlot
from procc_annotator.gui.panels.plots.page import PlotPage, PlotRequest, PlotSources
from procc_annotator.gui.panels.widgets import choice, empty_state, hbox, make_label, named, vbox
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.availability import as_sentence, no_frame, no_source
from procc_annotator.gui.state.background import JobControl, LatestOnlyTask
from procc_annotator.gui.state.selectors import judged
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr, word

_SCOPES = {"frame": word("This frame"), "set": word("Whole set")}
_ALL_CLASSES = -1
_WIDE = 34  # lines of text: then what is chosen stands in one row


_Kind = type[PlotPage[Any]]


def _kinds() -> tuple[_Kind, ...]:
    """Every kind of page; loaded when the panel is first seen."""
    from procc_annotator.gui.panels.plots.pages import (
        HistogramPage,
        TauPage,
        TimelinePage,
        VectorsPage,
    )

    return (TauPage, TimelinePage, HistogramPage, VectorsPage)


class PlotsPanel(ExportablePlot):
    """Chooses a plot and what it is of; what it shows is computed in the background for a set."""

    def __init__(self, services: Services) -> None:
        super().__init__(services)
        self._sources = PlotSources(services)
        self._kinds: tuple[_Kind, ...] = ()
        self._made: dict[_Kind, PlotPage[Any]] = {}
        self._elements: tuple[str, ...] = ()  # of the field, by row
        self._computing = LatestOnlyTask(self, self._fail)
        self._again = False
        self._drawn: tuple[object, ...] | None = None
        self._in_sight = False
        self._build()
        self._follow(
            lambda s: (judged(s), s.looks, s.compared, s.blind, s.committed),
            services.store.events.sourceAuditsChanged,
            services.review.statusChanged,
        )

    # --- building -------------------------------------------------------------------------

    def _offer_classes(self) -> None:
        """The elements of the field; the one that was chosen stays, if there is one of its name."""
        row = self.classes.currentData()
        before = self._elements[row] if row not in (None, _ALL_CLASSES) else None
        titles = element_titles(self._services.state.field)
        self._elements = tuple(titles)
        blocked = self.classes.blockSignals(True)
        self.classes.clear()
        self.classes.addItem(tr("All elements"), _ALL_CLASSES)
        for row, title in enumerate(titles.values()):
            self.classes.addItem(tr(title), row)
        row = self._elements.index(before) if before in self._elements else _ALL_CLASSES
        self.classes.setCurrentIndex(self.classes.findData(row))
        self.classes.blockSignals(blocked)

    def _build_more(self) -> QToolButton:
        tip = tr("Copy or save the plot and its numbers")
        more = named(QToolButton(), "plots_more", tip=tip, title=tr("Copy or save the plot"))
        more.setText(f"{tr('Save')} ▾")  # Qt's own sign lies over the letters
        more.setStyleSheet("QToolButton::menu-indicator { image: none; }")
        more.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(more)
        for name, text, slot in (
            ("copy_picture", tr("Copy picture"), self.copy_picture),
            ("copy_numbers", tr("Copy numbers"), self.copy_numbers),
            ("save_picture", tr("Save picture…"), self.ask_picture),
            ("save_numbers", tr("Save numbers…"), self.ask_numbers),
        ):
            menu.addAction(text, slot).setObjectName(f"plots_{name}")
        more.setMenu(menu)
        return more

    def _build(self) -> None:
        self.chooser = choice("plots_page", tr("Plot"))
        self.chooser.currentIndexChanged.connect(self._turn_page)
        self.scope = choice(
            "plots_scope",
            tr("Frames"),
            tip=tr("Plot the frame on screen, or all frames scored so far"),
            items=[(tr(words), scope) for scope, words in _SCOPES.items()],
        )
        self.scope.currentIndexChanged.connect(self._redraw)
        tip = tr("Plot the points of one element only")
        self.classes = choice("plots_class", tr("Element"), tip=tip)
        self._offer_classes()
        self._services.store.watch(select.field, self._offer_classes)
        self.classes.currentIndexChanged.connect(self._redraw)
        self.more = self._build_more()
        second = QGridLayout()
        for place, part in enumerate((self.scope, self.classes)):
            second.addWidget(part, 0, place)
            second.setColumnStretch(place, 1)
        self.empty = empty_state("", "plots_empty")
        self._stack = QStackedWidget()
        self._stack.addWidget(self.empty)
        self.notes = make_label(name="plots_notes", wrap=True)
        self.notes.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.notes.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.notes.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self._choices = QBoxLayout(QBoxLayout.Direction.TopToBottom)
        self._choices.setSpacing(4)
        self._choices.addLayout(hbox((self.chooser, 1), self.more), 1)
        self._choices.addLayout(second, 1)
        parts = (self._choices, self.legend, (self._stack, 1), self.notes)
        vbox(*parts, of=self, spacing=4, margins=6)
        self._read_out("")

    def _read_out(self, text: str) -> None:
        """Show what is under the cursor, or what there is to say of the plot.

        The room is what the latter needs and never changes while the cursor moves.
        """
        lines = 2 * self.fontMetrics().lineSpacing() + 2
        width = max(self.notes.width(), 120)
        said = self.fontMetrics().boundingRect(
            QRect(0, 0, width, 10_000), int(Qt.TextFlag.TextWordWrap), self._said or " "
        )
        if self.notes.height() != max(lines, said.height() + 2):
            self.notes.setFixedHeight(max(lines, said.height() + 2))
        self.notes.setText(text or self._said)

    def _offer_kinds(self) -> None:
        if not self._kinds:
            self._kinds = _kinds()
            self.chooser.addItems([tr(kind.title) for kind in self._kinds])

    @property
    def _kind(self) -> _Kind:
        self._offer_kinds()
        return self._kinds[self.chooser.currentIndex()]

    @property
    def page(self) -> PlotPage[Any]:
        """The chosen plot; made (and pyqtgraph imported) when it is first asked for."""
        page = self._made.get(self._kind)
        if page is None:
            page = self._made[self._kind] = self._kind(self._services)
            page.readout.connect(self._read_out)
            page.changed.connect(self._redraw)
            self._stack.addWidget(page)
        return page

    # --- showing --------------------------------------------------------------------------

    def choose(self, title: str) -> None:
        """Show a plot by its title, in English."""
        self._offer_kinds()
        self.chooser.setCurrentIndex([kind.title for kind in self._kinds].index(title))

    def set_in_sight(self, in_sight: bool) -> None:
        """Compute only while the panel is open and no other tab lies over it."""
        self._in_sight = in_sight
        if in_sight:
            self._offer_kinds()
            self._refresher.request()

    @property
    def busy(self) -> bool:
        """Return whether numbers are being computed."""
        return self._computing.running

    def _turn_page(self) -> None:
        self._request = self._data = None  # they are another page's
        self._redraw()

    def _redraw(self) -> None:
        self._drawn = None
        self._refresher.request()

    def _refresh(self) -> None:
        if not self._in_sight:
            return
        state = self._services.state
        if why := no_frame(state) or ("" if state.sources else no_source(state)):
            self._forget(as_sentence(why))
            return
        page = self.page
        self.scope.setVisible(len(page.scopes) > 1)
        self.classes.setVisible(page.by_class)
        request = self._make_request(page)
        key = self._key(page, request)
        if key == self._drawn:
            if self._request is not None:  # what is drawn, with another frame and tau
                self._request = replace(request, sources=self._request.sources)
            page.mark(request)
            return
        if request.scope == "frame":
            self._cancel()
            self._show(page, key, request, page.compute(request))
            return
        if self._computing.running:
            self._again = True
            return
        self._compute(page, key, request)

    def _forget(self, why: str) -> None:
        self._cancel()
        self._drawn = self._request = self._data = None
        self.empty.setText(why)
        self.legend.show_sources([])
        self._said = ""
        self._read_out("")
        self.more.setEnabled(False)
        self._stack.setCurrentWidget(self.empty)

    def _make_request(self, page: PlotPage[Any]) -> PlotRequest:
        scope = self.scope.currentData()
        if scope not in page.scopes:
            scope = page.scopes[0]
        row = self.classes.currentData() if page.by_class else _ALL_CLASSES
        return self._sources.request(scope, None if row == _ALL_CLASSES else row)

    def _key(self, page: PlotPage[Any], request: PlotRequest) -> tuple[object, ...]:
        """Return what the drawing depends on; marks are moved without it."""
        frame = request.current if request.scope == "frame" else None
        return (
            type(page),
            request.scope,
            request.class_row,
            request.tau if page.follows_tau else None,
            frame,
            self._sources.version(request.scope),
        )

    def _compute(self, page: PlotPage[Any], key: tuple[object, ...], request: PlotRequest) -> None:
        def work(control: JobControl) -> tuple[PlotRequest, Any]:
            allowed = request.revealed()
            return allowed, page.compute(allowed)

        def done(result: tuple[PlotRequest, Any]) -> None:
            self._show(page, key, *result)
            if self._again:
                self._again = False
                self._refresher.request()

        self._computing.start(work, done)
        if self._stack.currentWidget() is not page:  # nothing of it was drawn yet
            self.empty.setText(tr("Computing…"))
            self._stack.setCurrentWidget(self.empty)
            self.more.setEnabled(False)

    def _fail(self, text: str) -> None:
        self._again = False
        self._forget(tr("This plot could not be computed: {error}.", error=text))

    def _cancel(self) -> None:
        self._computing.cancel()
        self._again = False

    def _show(
        self, page: PlotPage[Any], key: tuple[object, ...], request: PlotRequest, data: Any
    ) -> None:
        if page is not self._made.get(self._kind):
            self._refresher.request()  # another page was chosen meanwhile
            return
        self._drawn, self._request, self._data = key, request, data
        self._stack.setCurrentWidget(page)
        said = page.draw(data, request)
        self._said = "" if page.is_empty else said
        counts = [(source, self._count(source, request)) for source in request.sources]
        self.legend.show_sources(counts)
        self._read_out("")
        self.more.setEnabled(not page.is_empty)

    def _count(self, source: Any, request: PlotRequest) -> str:
        """Return how much a source's part of the plot rests on."""
        if request.scope == "frame":
            name = request.frames[request.current] if request.current >= 0 else ""
            if request.blind:
                return tr("(hidden)")
            return "" if name in source.audits else tr("(no score)")
        if request.blind:
            return tr("({n:,} committed)", n=len(source.audits))
        return tr("({n:,} of {total:,})", n=len(source.audits), total=len(request.frames))

    # --- events ---------------------------------------------------------------------------

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        wide = self.width() > _WIDE * self.fontMetrics().height()
        way = QBoxLayout.Direction.LeftToRight if wide else QBoxLayout.Direction.TopToBottom
        self._choices.setDirection(way)
        self._read_out("")
