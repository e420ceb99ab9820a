"""The window, assembled: canvas, panels, bars, actions; what they do is in their own files."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QCloseEvent, QCursor, QDragEnterEvent, QDropEvent, QShowEvent
from PySide6.QtWidgets import QMainWindow, QStackedWidget, QWidget

from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.commands.assistant import Assistant
from procc_annotator.gui.commands.element_edits import ElementEdits, Naming
from procc_annotator.gui.commands.exporting import ExportAs, Exporter
from procc_annotator.gui.commands.field_choosing import FieldBar, FieldChoosing
from procc_annotator.gui.commands.field_dimensions import FieldDimensionsTask
from procc_annotator.gui.commands.frame_walks import ShotWalk, StatusWalk, WorstFirst
from procc_annotator.gui.commands.ghosts import GhostCommands
from procc_annotator.gui.commands.importing import AnnotationImporter
from procc_annotator.gui.commands.label_check import LabelCheckCommands
from procc_annotator.gui.commands.opening import OpeningTask, SourceMemory
from procc_annotator.gui.commands.overlay_saving import OverlaySaving
from procc_annotator.gui.commands.shot_accepting import StretchAccepting
from procc_annotator.gui.commands.shot_following import ShotFollowing
from procc_annotator.gui.commands.triage import Triage
from procc_annotator.gui.commands.versions import Versions
from procc_annotator.gui.commands.view_grouping import ViewGrouping
from procc_annotator.gui.messages import (
    Bar,
    BarStack,
    ConflictBar,
    MessageBar,
    ask_to_leave_unsaved,
)
from procc_annotator.gui.panels.agreement import AgreementPanel
from procc_annotator.gui.panels.cameras import CamerasPanel
from procc_annotator.gui.panels.elements import ElementsPanel
from procc_annotator.gui.panels.field_map.field_map_panel import FieldMapPanel
from procc_annotator.gui.panels.film_strip import FrameStrips
from procc_annotator.gui.panels.findings import FindingsPanel
from procc_annotator.gui.panels.fit import FitPanel
from procc_annotator.gui.panels.frames import FramesPanel
from procc_annotator.gui.panels.landmarks import LandmarksPanel
from procc_annotator.gui.panels.plots.plots_panel import PlotsPanel
from procc_annotator.gui.panels.review import ReviewPanel
from procc_annotator.gui.panels.scores import ScoresPanel
from procc_annotator.gui.panels.timeline.shot_strip import ShotStrip
from procc_annotator.gui.panels.widgets import hbox, vbox
from procc_annotator.gui.settings import RECENT, SECOND, Settings
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.store import When
from procc_annotator.gui.window.command_palette import CommandPalette, PaletteEntries
from procc_annotator.gui.window.commands import Commands
from procc_annotator.gui.window.keyboard_focus import (
    DigitRow,
    ElementShortcuts,
    FocusRegions,
    FocusReturn,
    FocusRing,
)
from procc_annotator.gui.window.menus import Actions, ActionStates, FindingTips, canvas_menu
from procc_annotator.gui.window.status import ErrorReports, IsolatedRow, MessageRouter, StatusLine
from procc_annotator.gui.window.tool_bar import SideToolBar
from procc_annotator.gui.window.top_bar import TopBar
from procc_annotator.gui.window.tour import Tour
from procc_annotator.gui.window.welcome import RecentMenu, Welcome
from procc_annotator.gui.window.window_settings import BoundSettings, WindowState, apply_appearance
from procc_annotator.gui.window.workspaces import TITLES, Workspaces, WorkspaceSwitch
from procc_annotator.translation import tr


class MainWindow(QMainWindow):
    """One window on one dataset."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("mainWindow")
        self.setAcceptDrops(True)
        self.settings = Settings()
        apply_appearance(self.settings)
        self.services = Services(parent=self)
        self.canvas = Canvas(self.services)
        self.error_reports = ErrorReports(self.services, self)
        self.options = BoundSettings(
            self.settings, self.services, self.canvas, lambda name: self.actions_[name]
        )
        self._make_tasks()
        self._make_panels()
        self._make_centre()
        self.actions_ = Actions(self, self.canvas)
        ActionStates(self.services, self.actions_, self)
        self.panels.turned.connect(lambda name: self.actions_.set_checked(f"desk_{name}", True))
        self.panels.allHidden.connect(lambda on: self.actions_.set_checked("hide_panels", on))
        self._make_bars()
        self._add_menus()
        entries = PaletteEntries(
            self.services,
            self.actions_,
            self.settings,
            self.panels.show,
            self.opening.open_path,
            self.commands.show_settings,
        )
        self.palette_ = CommandPalette(self, entries.found, self.settings)
        self.naming.searchWanted.connect(
            lambda name: self.palette_.ask(lambda text, _: entries.elements(text, name))
        )
        self._make_helpers()
        self._window_state = WindowState(self.settings, self, self.options, self.panels)
        self._connect()
        self._window_state.take_up()
        self._refresh_frame()

    # --- assembly -------------------------------------------------------------------------

    def _make_bars(self) -> None:
        self.workspace_switch = WorkspaceSwitch(self.actions_)
        self.cameras.comparing.add_actions(self.actions_["split"], self.actions_["disagreement"])
        self.fit.add_actions(self.actions_["live_fit"], self.actions_["save_fit"])
        self.landmarks.add_actions(self.actions_["group_views"])
        self.top_bar = TopBar(self.services, self.actions_, self.actions_.menus["File/Field"])
        row = QWidget()
        parts = (self.actions_.bar, (IsolatedRow(self.top_bar), 1), self.workspace_switch)
        row.setLayout(line := hbox(*parts, spacing=4, margins=(0, 1, 4, 1)))
        line.setAlignment(self.actions_.bar, Qt.AlignmentFlag.AlignVCenter)
        self.setMenuWidget(row)
        self._centre.insertWidget(0, self.top_bar.camera_bar)
        self.panels.turned.connect(self.top_bar.camera_bar.show_in)
        self.side_bar = SideToolBar(self.actions_)
        self.addToolBar(Qt.ToolBarArea.LeftToolBarArea, self.side_bar)
        self.strips.show_action(self.actions_["frames_list"])
        self.field_choosing.fill(
            self.actions_.menus["File/Field"],
            self.actions_["field_file"],
            self.actions_["switch_field"],
        )
        self.status = StatusLine(self.services, self.canvas)
        self.setStatusBar(self.status)

    def _make_helpers(self) -> None:
        self.focus_return = FocusReturn(self.canvas)
        self.finding_tips = FindingTips(self.services, self.canvas)
        self.focus_ring = FocusRing(self)
        self.element_shortcuts = ElementShortcuts(self, self.services)
        self.digit_row = DigitRow(self)
        MessageRouter(
            self.services,
            (self.message_bar, self.frame_bar, self.conflict_bar),
            self.status,
            self,
        )

    def _make_tasks(self) -> None:
        """Make the objects that the table of actions calls."""
        services = self.services
        self.element_edits = ElementEdits(services)
        self.naming = Naming(services, self.canvas, self.element_edits)
        self.assistant = Assistant(services, self)
        self.ghost_tasks = GhostCommands(services, self.canvas, self.settings, self)
        self.status_walk = StatusWalk(services)
        self.shot_following = ShotFollowing(services, self)
        self.stretch_accepting = StretchAccepting(
            services, lambda: self.ghost_tasks.accepting.least_support, self
        )
        self.stretch_accepting.following = lambda: self.shot_following.running
        self.shot_walk = ShotWalk(
            services, self.canvas, lambda: self.stretch_accepting.unsure, self
        )
        self.canvas.editor.ask_first(
            self.canvas.camera_drag.key,
            self.assistant.key,
            self.ghost_tasks.key,
            lambda name, shift: self.review.key(name, shift),
            self.stretch_accepting.key,
            lambda name, shift: self.tour.key(name, shift),
        )
        self.triage = Triage(services, self)
        self.worst_first = WorstFirst(services, self)
        self.field_dimensions = FieldDimensionsTask(services, self)
        self.label_check = LabelCheckCommands(services, self)
        self.label_check.followWanted.connect(self.assistant.regularise_named)
        self.source_memory = SourceMemory(services, self.settings, self)
        self.exporter = Exporter(services, self)
        self.export_as = ExportAs(services, self)
        self.importer = AnnotationImporter(services, self)
        self.overlay_saving = OverlaySaving(services, self)
        self.versions = Versions(services, self)
        self.view_grouping = ViewGrouping(services, self)
        self.opening = OpeningTask(services, self.settings, self)
        self.regions = FocusRegions(self)
        self.commands = Commands(services, self.canvas, self.options, self)

    def _make_centre(self) -> None:
        services, editing = self.services, self.services.editing
        self.message_bar = MessageBar(lambda name: self.actions_[name].trigger())
        self.frame_bar = Bar("frameBar")
        self.conflict_bar = ConflictBar(editing.reload_frame, editing.overwrite_frame)
        self.field_bar = FieldBar()
        self.field_choosing = FieldChoosing(self.services, self.settings, self.field_bar, self)
        self.tour = Tour(
            services,
            lambda dock: not self.docks[dock].visibleRegion().isEmpty(),
            lambda workspace: self.panels.turn_to(workspace),
        )
        self.welcome = Welcome(self.opening, self.tour.start, self.settings.get(RECENT))
        self.pages = QStackedWidget()
        self.pages.addWidget(self.welcome)
        self.pages.addWidget(self.canvas)
        self.strip = ShotStrip(self.services)
        self.strip.show_tasks(self.shot_following, self.stretch_accepting)
        self.strips = FrameStrips(self.services, self.frames, self.strip)
        centre = QWidget()
        self._centre = vbox(self.pages, self.strips, of=centre, spacing=0, margins=0)
        others = self.frame_bar, self.conflict_bar, self.field_bar
        self._bars = (self.tour, self.message_bar, *others)
        self.bars = BarStack(self._bars, self.pages)
        self.bars.heightChanged.connect(self.canvas.comparison.set_top)
        self.setCentralWidget(centre)

    def _make_panels(self) -> None:
        services = self.services
        self.frames = FramesPanel(services)
        self.field_map = FieldMapPanel(services)
        self.elements = ElementsPanel(services)
        self.cameras = CamerasPanel(services)
        self.scores = ScoresPanel(services)
        self.fit = FitPanel(services)
        self.plots = PlotsPanel(services)
        self.findings = FindingsPanel(services, self.label_check)
        self.landmarks = LandmarksPanel(services)
        self.review = ReviewPanel(services)
        self.agreement = AgreementPanel(services)
        self.panels = Workspaces(
            self,
            {name: getattr(self, name) for name in TITLES},
            self.canvas,
            {
                "frames": self.frames.focus_filter,
                "elements": self.elements.focus_search,
                "review": self.review.focus_comment,
            },
        )
        self.docks = self.panels.by_name

    def _add_menus(self) -> None:
        menu = self.actions_.menus["View"].addMenu(tr("Panels"))  # not shown
        for dock in self.docks.values():
            menu.addAction(dock.toggleViewAction())
        recent = RecentMenu(self.settings, self.opening.open_path, self)
        before = self.actions_["open_sample"]
        self.actions_.menus["File"].insertMenu(before, recent)  # not shown

    def _connect(self) -> None:
        services = self.services
        services.store.watch(select.frame, self._refresh_frame)
        self.opening.camerasTracked.connect(self.source_memory.add)
        self.opening.secondChosen.connect(services.second_annotator.open)
        self.services.second_annotator.opened.connect(self._show_second)
        for panel in (self.elements, self.frames, self.review, self.landmarks):
            panel.left.connect(self.canvas.setFocus)
        self.canvas.menuWanted.connect(self._show_menu)
        chosen = services.review.commentChosen
        chosen.connect(lambda _: self.panels.show_unless_hidden("review"))
        fields = self.actions_.menus["File/Field"]
        self.canvas.found_plate.clicked.connect(lambda: fields.popup(QCursor.pos()))
        self.canvas.panChanged.connect(lambda on: self.actions_.set_checked("pan", on))
        self.side_bar.looks.lookChanged.connect(self.canvas.shown.set_look)
        self.docks["plots"].visibilityChanged.connect(self.plots.set_in_sight)
        for changed in (self.docks["frames"].visibilityChanged, self.panels.allHidden):
            changed.connect(self._show_strip)
        self.ghost_tasks.accepting.progressed.connect(self.status.show_ghosts)
        self.worst_first.progressed.connect(self.status.show_comparing)
        accepting = self.stretch_accepting
        sequence = services.sequence  # its strip says how far it is
        accepting.changed.connect(
            lambda: self.status.set_work("" if sequence.value is not None else accepting.words())
        )
        self.triage.serve(self.scores.verdict)
        # Its reason should be in sight.
        self.label_check.walked.connect(lambda: self.panels.show_unless_hidden("findings"))
        note_activity = services.review.note_activity
        for moved in (self.canvas.cursorMoved, self.canvas.viewChanged):
            moved.connect(note_activity)
        services.store.watch(lambda s: (s.annotation, s.selection), note_activity, When.AFTER_PAINT)

    # --- showing the state ----------------------------------------------------------------

    def _refresh_frame(self) -> None:
        frame = self.services.state.frame
        opened = frame is not None and self.pages.currentWidget() is self.welcome
        self.pages.setCurrentWidget(self.welcome if frame is None else self.canvas)
        if opened or (frame is not None and not self.canvas.hasFocus() and self.frames.isHidden()):
            self.canvas.setFocus()

    def _show_menu(self, at: QPoint) -> None:
        """The menu of what is under the cursor."""
        menu = canvas_menu(
            self,
            self.services,
            self.actions_,
            self.element_edits,
            self.label_check,
            drawing=self.canvas.editor.drawing,
            on_ground=self.canvas.editor.on_ground,
            ghost_tasks=self.ghost_tasks,
            ghost=self.ghost_tasks.at_cursor(),
        )
        menu.exec(at)
        menu.deleteLater()

    # --- panels ---------------------------------------------------------------------------

    def comment_here(self) -> None:
        """Begin a comment on the place that is pointed at; on the whole frame where none is."""
        place = self.canvas.pointed_px
        self.panels.enter("review")
        self.services.review.begin_comment(place)

    def _show_strip(self) -> None:
        """The frames have one place: the strip, or the list; none where all panels are hidden."""
        hidden = self.actions_["hide_panels"].isChecked()
        self.strips.set_covered(hidden or not self.docks["frames"].isHidden())

    def find_anything(self) -> None:
        """Show the command palette; once more puts it away."""
        self.palette_.ask()

    def _show_second(self, folder: Path) -> None:
        self.settings.set(SECOND, str(folder))
        self.panels.show("agreement")

    # --- events ---------------------------------------------------------------------------

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.panels.settle()
        self.panels.show_whole_tabs()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.ActivationChange and self.isActiveWindow():
            self.services.outside_changes.look()  # other programs had their turn
        if event.type() == QEvent.Type.PaletteChange:
            for bar in self._bars:
                bar.follow_theme()

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if any(url.isLocalFile() for url in event.mimeData().urls()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        event.acceptProposedAction()
        paths = [Path(u.toLocalFile()) for u in event.mimeData().urls() if u.isLocalFile()]
        self.opening.drop(paths)

    def closeEvent(self, event: QCloseEvent) -> None:
        self.services.navigator.leave()
        if not self.services.editing.save_now():
            problems = [str(p) for p in self.services.saver.problems.values()]
            if not ask_to_leave_unsaved(self, problems):
                event.ignore()
                return
        self._window_state.write_down()
        self.importer.stop()
        self.shot_following.forget()
        self.stretch_accepting.forget()
        self.services.close()
        event.accept()
