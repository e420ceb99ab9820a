"""The list of camera sources: one row each, and one for no camera at all."""

from __future__ import annotations

from functools import partial
from itertools import islice, takewhile

from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QIcon,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QPen,
    QPixmap,
    QResizeEvent,
)
from PySide6.QtWidgets import (
    QButtonGroup,
    QCheckBox,
    QColorDialog,
    QFrame,
    QGridLayout,
    QLineEdit,
    QMenu,
    QRadioButton,
    QSizePolicy,
    QStackedWidget,
    QToolButton,
    QWidget,
)

from procc_annotator.camera.base import projects_only_ground
from procc_annotator.dataset.computed_cameras import TRACK_NAME
from procc_annotator.gui.panels.widgets import (
    ElidedLabel,
    make_label,
    named,
    note_label,
    show_note,
    vbox,
)
from procc_annotator.gui.state.camera_sources import CameraSource
from procc_annotator.gui.state.prediction.live_fit import MODELS
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.theme import blend, fixed_width
from procc_annotator.interaction.palette import SOURCE_COLOURS
from procc_annotator.translation import tr, tr_count, word

_COLOUR_NAMES = (
    word("Yellow"),
    word("Violet"),
    word("Blue"),
    word("Mint"),
    word("Navy"),
    word("Cyan"),
)
_PATCH = 14


class SourceRow(QFrame):
    """One source: choose, rename, colour, draw and remove it."""

    def __init__(self, services: Services, index: int, source: CameraSource) -> None:
        super().__init__()
        self.setObjectName(f"cameras_row_{index}")
        self._services, self._source = services, source
        self._active = False
        self._counted_of: object = None  # what was counted, and how many were known as damaged
        self._count = 0
        self._fixed = source.files is None  # the fit keeps its name and colour
        self._colour = ""
        commands = services.camera_sources
        self.radio = named(ElidedRadio(source.name), f"cameras_set_{index}")
        self.radio.installEventFilter(self)
        self.radio.clicked.connect(self._activate)
        title = tr("Name of the source")
        self.edit = named(QLineEdit(), f"cameras_name_{index}", title=title)
        self.edit.installEventFilter(self)
        self.edit.editingFinished.connect(self._finish_name)
        self.colour = named(QToolButton(autoRaise=True), f"cameras_colour_{index}")
        self.colour.setIconSize(QSize(_PATCH, _PATCH))
        self.colour.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.colour.setStyleSheet("QToolButton::menu-indicator { image: none; }")
        if not self._fixed:
            self.colour.setMenu(self._colour_menu())
        tip = tr("Draw as a wireframe while another source is judged")
        self.drawn = named(QCheckBox(), f"cameras_drawn_{index}", tip=tip)
        self.drawn.clicked.connect(lambda shown: commands.set_source_visible(source, shown))
        self.jac = make_label(name=f"cameras_jac_{index}", font=fixed_width(self.font()))
        self.model = named(ElidedLabel(), f"cameras_model_{index}")
        self.model.setForegroundRole(QPalette.ColorRole.PlaceholderText)
        self.matched = make_label(name=f"cameras_matched_{index}")
        self.remove = QToolButton(autoRaise=True)
        self.remove.setText("✕")
        named(self.remove, f"cameras_remove_{index}", tip=_what_remove_does(source))
        self.remove.clicked.connect(self._remove)
        self.problem = note_label(f"cameras_problem_{index}")
        self._arrange()
        self.refresh()

    def _arrange(self) -> None:
        self._names = QStackedWidget()
        self._names.addWidget(self.radio)
        self._names.addWidget(self.edit)
        layout = QGridLayout(self)
        layout.setContentsMargins(2, 3, 2, 3)
        layout.setHorizontalSpacing(4)
        layout.setVerticalSpacing(1)
        middle = Qt.AlignmentFlag.AlignCenter
        layout.addWidget(self.colour, 0, 0, middle)
        layout.addWidget(self._names, 0, 1)
        layout.addWidget(self.jac, 0, 2, Qt.AlignmentFlag.AlignRight)
        layout.addWidget(self.remove, 0, 3)
        layout.addWidget(self.drawn, 1, 0, middle)
        layout.addWidget(self.model, 1, 1)
        layout.addWidget(self.matched, 1, 2, 1, 2, Qt.AlignmentFlag.AlignRight)
        layout.addWidget(self.problem, 2, 1, 1, 3)
        layout.setColumnStretch(1, 1)

    # --- showing -------------------------------------------------------------------------------

    def refresh(self) -> None:
        """Show the source as it is now."""
        source, active = self._source, self._services.state.active is self._source
        self.radio.set_full_text(source.name)
        lines = [tr("Judge against {name}", name=source.name), tr(source.camera_set.origin)]
        if not self._fixed:
            lines.append(tr("Double-click or F2 gives it another name"))
        self.radio.setToolTip("\n".join(lines))
        self.radio.setChecked(active)
        self.remove.setAccessibleName(tr("Remove {name}", name=source.name))
        self.drawn.setChecked(source.visible)
        self.drawn.setAccessibleName(tr("Draw {name}", name=source.name))
        if source.colour != self._colour:
            self._colour = source.colour
            self.colour.setIcon(colour_icon(source.colour, self.devicePixelRatioF()))
            words = tr("Colour of {name}", name=source.name)
            self.colour.setToolTip(words)
            self.colour.setAccessibleName(words)
        if active != self._active:
            self._active = active
            self.update()
        for label, (text, tip) in ((self.jac, self._jac()), (self.matched, self._matched())):
            label.setText(text)
            label.setToolTip(tip)
        self.model.set_text(self._model())
        known = (MODELS.get(model.removeprefix("pinhole ")) for model in source.models)
        self.model.setToolTip("\n".join([self.model.text(), *map(tr, filter(None, known))]))
        problem = self._problem()
        show_note(self.problem, f"⚠ {problem}" if problem else "")

    def _jac(self) -> tuple[str, str]:
        """Mean JaC of the set, and what it is the mean of."""
        services, source = self._services, self._source
        if services.state.blind:
            return "JaC –", tr("Blind mode hides how the sources do")
        mean = source.mean_jac(services.state.tau)
        if mean is None:
            return "JaC –", tr("No frame has both annotated elements and a camera of this source")
        frames = tr_count(len(source.audits), "{n:,} frame", "{n:,} frames")
        if services.scoring.running:
            frames = tr("{frames} so far", frames=frames)
        tip = tr("Mean JaC at {tau:.1f} px over {frames}", tau=services.state.tau, frames=frames)
        if bad := len(source.problems):
            tip = tr_count(
                bad,
                "{mean}; {n:,} camera cannot be read and takes no part",
                "{mean}; {n:,} cameras cannot be read and take no part",
                mean=tip,
            )
        return f"JaC {mean:.3f}", f"{tip}\n{services.state.setup.describe()}"

    def _model(self) -> str:
        """The camera model: of the set when it has one, else of the frame on screen."""
        source, words = self._source, self._model_words()
        return f"{words}, {tr(source.fitted.mark)}" if words and source.fitted else words

    def _model_words(self) -> str:
        models = self._source.models
        known = self._services.source_frames.of(self._source)
        camera = known.camera if known is not None else None
        if len(models) == 1:
            words = models[0]
        elif known is None or camera is None:
            return tr("several models") if models else ""
        else:
            words = known.model
        if camera is not None and projects_only_ground(camera):
            words = tr("{model} (ground)", model=words)
        return tr("{model} here", model=words) if len(models) > 1 else words

    def _matched(self) -> tuple[str, str]:
        """Return how many frames have a camera, and which of these cannot be used."""
        source = self._source
        workspace, cameras = self._services.state.workspace, source.camera_set
        if source is self._services.shot_track.source:
            count = len(cameras.frames)
            words = tr_count(count, "{n:,} frame followed", "{n:,} frames followed")
            return words, tr(_FOLLOWED_TIP)
        if source.files is None:
            count = len(cameras.frames)
            words = tr_count(count, "{n:,} opened frame", "{n:,} opened frames")
            return words, tr(_FITTED_TIP)
        if workspace is None or not workspace.frames:
            return tr_count(len(cameras.frames), "{n:,} camera", "{n:,} cameras"), ""
        of = workspace, cameras, len(source.problems)
        if self._counted_of != of:  # counting a large set takes a while
            self._counted_of = of
            self._count = source.matched(frame.name for frame in workspace.frames)
        matched, total = self._count, len(workspace.frames)
        share = f"{100 * matched / total:.0f} %"
        if not source.problems:
            words = tr("{n} of {total} ({share})", n=matched, total=total, share=share)
            return words, tr(_COMPLETENESS)
        bad, names = len(source.problems), ", ".join(islice(source.problems, _NAMED))
        if bad > _NAMED:
            names = tr_count(
                bad - _NAMED, "{names} and {n:,} more", "{names} and {n:,} more", names=names
            )
        unreadable = tr("Unreadable (filter camera:unreadable): {names}", names=names)
        words = tr_count(
            bad,
            "{matched} of {total}, {n} unreadable",
            "{matched} of {total}, {n} unreadable",
            matched=matched,
            total=total,
        )
        return words, f"{tr(_COMPLETENESS)}: {share}\n{unreadable}"

    def _problem(self) -> str:
        """Why a source that is not judged has nothing to show of this frame; the panel's notes say
        it of the active one."""
        services, source = self._services, self._source
        known = services.source_frames.of(source)
        if known is None or source is services.state.active:
            return ""
        if source.files is None:
            return known.notice if services.state.projection_visible and not known.camera else ""
        if known.error:
            return tr("cannot be used here: {error}", error=known.error)
        return tr("no camera for this frame") if known.camera is None else ""

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._active:
            colours = self.palette()
            ground = colours.color(QPalette.ColorRole.Window)
            tone = blend(ground, colours.color(QPalette.ColorRole.Highlight), 0.16)
            painter = QPainter(self)
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(tone)
            painter.drawRoundedRect(QRectF(self.rect()), 4, 4)
            painter.end()
        super().paintEvent(event)

    # --- editing -------------------------------------------------------------------------------

    def begin_rename(self) -> None:
        """Let the name be typed, where it is the user's to give."""
        if self._fixed:
            return
        self.edit.setText(self.radio.full_text)
        self._names.setCurrentWidget(self.edit)
        self.edit.selectAll()
        self.edit.setFocus()

    def _finish_name(self) -> None:
        if self._names.currentWidget() is self.edit:
            self._names.setCurrentWidget(self.radio)
            self._services.camera_sources.rename_source(self._source, self.edit.text())

    def _activate(self) -> None:
        state = self._services.state
        if state.active is not self._source:
            self._services.camera_sources.set_active_camera(state.sources.index(self._source))

    def _remove(self) -> None:
        services = self._services
        if self._source is services.shot_track.source:
            services.shot_track.forget()
        elif self._source.files is None:
            services.live_fit.set_wanted(False)
        else:
            index = services.state.sources.index(self._source)
            services.camera_sources.remove_camera_set(index)

    def _set_colour(self, colour: str) -> None:
        self._services.camera_sources.set_source_colour(self._source, colour)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            event.accept()
            self._activate()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            event.accept()
            self.begin_rename()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self.radio:
            twice = event.type() == QEvent.Type.MouseButtonDblClick
            key = event.key() if isinstance(event, QKeyEvent) else None
            pressed = event.type() == QEvent.Type.KeyPress and key == Qt.Key.Key_F2
            if twice or pressed:
                self.begin_rename()
                return True
        elif isinstance(event, QKeyEvent) and event.key() == Qt.Key.Key_Escape:
            if event.type() == QEvent.Type.ShortcutOverride:
                event.accept()  # not the window's Esc
                return True
            if event.type() == QEvent.Type.KeyPress:
                self._names.setCurrentWidget(self.radio)
                self.radio.setFocus()
                return True
        return False

    def _colour_menu(self) -> QMenu:
        menu = QMenu(self)
        for name, colour in zip(_COLOUR_NAMES, SOURCE_COLOURS, strict=True):
            icon = colour_icon(colour, self.devicePixelRatioF())
            menu.addAction(icon, tr(name), partial(self._set_colour, colour))
        menu.addAction(tr("Other…"), self._ask_colour)
        return menu

    def _ask_colour(self) -> None:
        chosen = QColorDialog.getColor(QColor(self._colour), self, tr("Colour of the source"))
        if chosen.isValid():
            self._set_colour(chosen.name())


class ElidedRadio(QRadioButton):
    """A radio button that shortens its text in a narrow panel."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.full_text = ""
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self.set_full_text(text)

    def set_full_text(self, text: str) -> None:
        """Show another text, as much of it as there is room for."""
        if text != self.full_text:
            self.full_text = text
            self.setAccessibleName(text)
            self._elide(self.width())

    def _elide(self, width: int) -> None:
        room = width - self.iconSize().width() - 12
        elided = self.fontMetrics().elidedText(self.full_text, Qt.TextElideMode.ElideMiddle, room)
        self.setText(elided.replace("&", "&&"))

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._elide(event.size().width())
        super().resizeEvent(event)


def colour_icon(colour: str, ratio: float) -> QIcon:
    """A patch of a colour with a rim that shows on light and on dark ground."""
    pixmap = QPixmap(round(_PATCH * ratio), round(_PATCH * ratio))
    pixmap.setDevicePixelRatio(ratio)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(QPen(QColor("#707070"), 1))
    painter.setBrush(QColor(colour))
    corner = QPointF(1.5, 1.5)
    painter.drawRoundedRect(QRectF(corner.x(), corner.y(), _PATCH - 3, _PATCH - 3), 2.5, 2.5)
    painter.end()
    return QIcon(pixmap)


def _what_remove_does(source: CameraSource) -> str:
    if source.files is not None:
        return tr("Remove from the list; the files stay")
    if source.name == TRACK_NAME:
        return tr("Forget what was followed (T follows the shot again)")
    return tr("Switch the live fit off (Ctrl+T switches it on again)")


NO_CAMERA = -1

_COMPLETENESS = word("Frames of this dataset that have a camera (completeness)")
_FITTED_TIP = word(
    "Frames visited in this window whose clicks gave a camera; their JaC is of the clicks that the"
    " fit was made from.\nprocc-annotator calibrate fits and scores the whole set"
)
_FOLLOWED_TIP = word(
    "Frames of this dataset that were followed through their shot and have a camera.\n"
    "procc-annotator track follows a whole video and writes its cameras"
)
_NAMED = 12  # unreadable cameras in a tip


class SourceList(QWidget):
    """The rows of the state's sources, and one for no camera."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._services = services
        self._listed: tuple[CameraSource, ...] = ()
        self.rows: list[SourceRow] = []
        tip = tr("Judge nothing, draw no camera")
        self.none = named(QRadioButton(tr("none judged")), "cameras_none", tip=tip)
        self.none.clicked.connect(lambda: services.camera_sources.set_active_camera(NO_CAMERA))
        self._group = QButtonGroup(self)
        self._group.addButton(self.none)
        self._layout = vbox(self.none, of=self, spacing=2, margins=0)

    def refresh(self) -> None:
        """Show the sources as they are now."""
        sources = tuple(self._services.state.sources)
        if sources != self._listed:
            self._build(sources)
        self.none.setVisible(bool(sources))
        self.none.setChecked(self._services.state.active is None)
        for row in self.rows:
            row.refresh()

    def _build(self, sources: tuple[CameraSource, ...]) -> None:
        """Rows in front that stay the same are kept: a name may be typed into one just now."""
        pairs = zip(self._listed, sources, strict=False)
        kept = len(tuple(takewhile(lambda pair: pair[0] is pair[1], pairs)))
        self._listed = sources
        for row in self.rows[kept:]:
            self._group.removeButton(row.radio)
            self._layout.removeWidget(row)
            row.deleteLater()
        del self.rows[kept:]
        for index, source in enumerate(sources[kept:], start=kept):
            row = SourceRow(self._services, index, source)
            self._group.addButton(row.radio)
            self._layout.insertWidget(index, row)
            self.rows.append(row)
