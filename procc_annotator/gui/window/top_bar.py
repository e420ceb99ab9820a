"""The row on top: frame, dataset and sport, JaC, what is saved, search; the judged camera."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSignalBlocker, QSize, Qt
from PySide6.QtGui import (
    QAction,
    QColor,
    QPainter,
    QPaintEvent,
    QPalette,
    QResizeEvent,
)
from PySide6.QtWidgets import (
    QComboBox,
    QLabel,
    QMenu,
    QSizePolicy,
    QSlider,
    QStyle,
    QStyleOptionToolButton,
    QStylePainter,
    QToolButton,
    QWidget,
)

from procc_annotator.camera.base import projects_only_ground
from procc_annotator.dataset.records import Status
from procc_annotator.gui.panels.widgets import ElidedLabel, hbox, named, range_box
from procc_annotator.gui.state.selectors import judged
from procc_annotator.gui.state.services import Services
from procc_annotator.gui.state.state import MAX_TAU, MIN_TAU
from procc_annotator.gui.state.store import When
from procc_annotator.gui.theme import alarm_colours, bold, fixed_width, paint_icon
from procc_annotator.gui.window.menus import Actions
from procc_annotator.gui.window.status import SteadyLabel
from procc_annotator.gui.window.tool_bar import IconButton
from procc_annotator.translation import tr, tr_count, word


class TauControl(QWidget):
    """The threshold as a slider and a number; both change it live."""

    def __init__(self, services: Services) -> None:
        super().__init__()
        self._services = services
        tip = tr("Threshold tau: an element passes when all its points are nearer (+ and -)")
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(round(MIN_TAU * 10), round(MAX_TAU * 10))
        self.slider.setSingleStep(5)
        self.slider.setPageStep(20)
        self.slider.setFixedWidth(100)
        self.spin = range_box(MIN_TAU, MAX_TAU, 0.5, " px")
        self.spin.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        parts = {"tauLabel": QLabel("τ"), "tauSlider": self.slider, "tauSpin": self.spin}
        for name, part in parts.items():
            named(part, name, tip=tip, title=tr("Threshold tau"))
        self.setLayout(hbox(*parts.values(), margins=(4, 0, 4, 0)))
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
        self.slider.valueChanged.connect(lambda tenths: services.evaluation.set_tau(tenths / 10))
        self.spin.valueChanged.connect(services.evaluation.set_tau)
        services.store.watch(lambda s: s.tau, self._show)
        self._show()

    def _show(self) -> None:
        tau = self._services.state.tau
        with QSignalBlocker(self.slider), QSignalBlocker(self.spin):
            self.slider.setValue(round(tau * 10))
            self.spin.setValue(tau)


_NO_CAMERA = word("none")
_WIDEST_CAMERA, _LEAST_JAC, _LEAST_NAME = 14, 14, 10  # average letters
_JAC_TIP = word("Jaccard index of this frame at tau")


class CameraBar(QWidget):
    """The row above the picture while one judges: it comes and goes with the workspace alone.

    Attributes:
        jac: the JaC, or why there is none; it stands in the row on top, in every workspace.
    """

    def __init__(self, services: Services) -> None:
        super().__init__()
        self.setObjectName("cameraBar")
        self._services = services
        self._listed: list[str] = []
        self.tau = TauControl(services)
        tip = tr("The camera set that is judged (C switches)")
        self.cameras = named(QComboBox(), "cameraCombo", tip=tip)
        self.cameras.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self.cameras.activated.connect(lambda i: services.camera_sources.set_active_camera(i - 1))
        self.jac = named(ElidedLabel(), "judgedJac", tip=tr(_JAC_TIP))
        self.jac.setFont(bold(self.jac.font()))
        self.terms = named(ElidedLabel(), "judgedTerms")
        # The rest of the bar; a narrow window shows the beginning, and all of it in the tip.
        self.terms.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        parts = (self.tau, self.cameras, (self.terms, 1))
        self.setLayout(hbox(*parts, spacing=4, margins=(2, 1, 4, 1)))
        store = services.store
        store.watch(lambda s: (s.looks, s.active), self._show_cameras)
        store.watch(judged, self._show_score, When.AFTER_PAINT)
        store.watch(lambda s: s.projection_visible, self._show_score)  # hidden at once
        self._show_cameras()
        self.hide()

    def show_in(self, workspace: str) -> None:
        """Show the row in the workspace that judges only."""
        self.setVisible(workspace == "judge")

    def _show_cameras(self) -> None:
        services, looks = self._services, self._services.state.looks
        names = [tr(_NO_CAMERA), *(look.cameras.name for look in looks)]
        if names != self._listed:
            self._fill_cameras(names)
        active = services.state.active_cameras
        cameras = [None, *(look.cameras for look in looks)]
        self.cameras.setCurrentIndex(cameras.index(active))
        self.cameras.setEnabled(bool(looks))
        loaded = any(s is not services.fit_source.source for s in services.state.sources)
        there = loaded or services.state.active is not None
        self.jac.setVisible(there)
        self._show_score()

    def _fill_cameras(self, names: list[str]) -> None:
        self._listed = names
        self.cameras.clear()
        self.cameras.addItems(names)
        # Where room is short, the terms give way, not the camera's name.
        widest = _WIDEST_CAMERA * self.fontMetrics().averageCharWidth() + 40
        self.cameras.setMaximumWidth(widest)
        self.cameras.setMinimumWidth(min(widest, self.cameras.sizeHint().width()))

    def _show_score(self) -> None:
        """Show the JaC, or why there is no JaC."""
        services = self._services
        score = services.scorer.score
        if score is not None and (why := services.state.why_not_judged):
            said = why
        elif score is not None:
            own = services.state.active is services.fit_source.source
            said = tr("JaC {jac:.3f} of the fit") if own else "JaC {jac:.3f}"
            said = said.format(jac=score.jac)
        elif services.state.active_cameras is None:
            said = ""
        elif not services.state.projection_visible:
            said = tr("blind: commit to see JaC")
        else:
            said = tr("camera unreadable") if services.scorer.shown.error else tr("no camera here")
        self.jac.set_text(said)
        metrics = self.jac.fontMetrics()
        whole = metrics.horizontalAdvance(f"{said}  ")
        self.jac.setMinimumWidth(min(whole, _LEAST_JAC * metrics.averageCharWidth()))
        self.jac.setMaximumWidth(whole)
        hidden = not services.state.projection_visible
        error = "" if hidden else services.scorer.shown.error
        self.jac.setToolTip("\n".join(filter(None, (error or said, tr(_JAC_TIP)))))
        camera = services.scorer.camera
        ground_only = camera is not None and projects_only_ground(camera)
        terms = services.state.setup.describe(ground_only=ground_only)
        self.terms.set_text(terms)
        self.terms.setToolTip(tr("What the score is computed with: {terms}", terms=terms))


_SAVED_PAD = 4


class SaveState(SteadyLabel):
    """Says so in a word or two; what is not saved stands out."""

    def __init__(self, services: Services) -> None:
        super().__init__(tr("saved"))
        self.setObjectName("savedState")
        self.setFont(fixed_width(self.font()))
        self.setContentsMargins(*[_SAVED_PAD] * 4)
        self.setBackgroundRole(QPalette.ColorRole.Window)  # not that of a tool bar
        self._services = services
        store = services.store
        store.watch(lambda s: (s.workspace, s.frame_index, s.unsaved), self._show)
        for signal in (services.saver.begun, services.saver.settled):
            signal.connect(self._show)
        self._show()

    def set_saved(self, text: str, *, alarm: bool = False) -> None:
        """Show some words; an alarm stands out."""
        self.setText(text)
        if alarm != self.autoFillBackground():
            colours, font = QPalette(), self.font()
            if alarm:
                roles = (QPalette.ColorRole.Window, QPalette.ColorRole.WindowText)
                for role, tone in zip(roles, alarm_colours(self.palette()), strict=True):
                    colours.setColor(role, QColor(tone))
            font.setBold(alarm)
            self.setPalette(colours)
            self.setFont(font)
            self.setAutoFillBackground(alarm)

    def _show(self) -> None:
        saver = self._services.saver
        problems = saver.problems
        at = saver.saved_at
        saved = "" if at is None else tr("saved {time}", time=f"{at:%H:%M:%S}")
        self.setToolTip("\n".join(str(p) for p in problems.values()) or saved)
        if problems:
            count = len(problems)
            said = tr_count(count, "NOT SAVED: {n} frame", "NOT SAVED: {n} frames")
        elif saver.under_way:
            said = tr("saving...")
        else:
            said = "" if at is None else tr("saved")
        self.set_saved(said, alarm=bool(problems))


_PAD = 5
_ROOMY, _TIGHT = 60, 75  # lines of text: of the row, of the window
_WIDEST_CHIP = 30  # average letters


class WordsButton(QToolButton):
    """An icon and words, which are shortened where there is no room, in a frame of its own."""

    def __init__(self, icon: str, elide: Qt.TextElideMode, least: int) -> None:
        """Show nothing yet but an icon left of the words, which are shortened at ``elide``; there
        is always room for ``least`` letters."""
        super().__init__()
        self._icon, self._elide, self._least = icon, elide, least
        self._words = ""
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)

    def words(self) -> str:
        """All of them."""
        return self._words

    def set_words(self, words: str) -> None:
        """Show other words."""
        if words != self._words:
            self._words = words
            self.setAccessibleName(words)
            self.updateGeometry()
            self.update()

    def sizeHint(self) -> QSize:
        metrics = self.fontMetrics()
        words = metrics.horizontalAdvance(self._words)
        most = _WIDEST_CHIP * metrics.averageCharWidth()
        width = self._beside() + min(words, most)
        return QSize(width + 2, metrics.height() + 2 * _PAD)

    def minimumSizeHint(self) -> QSize:
        metrics = self.fontMetrics()
        least = min(
            metrics.averageCharWidth() * self._least, metrics.horizontalAdvance(self._words)
        )
        return QSize(self._beside() + least, self.sizeHint().height())

    def paintEvent(self, event: QPaintEvent) -> None:
        option = QStyleOptionToolButton()
        self.initStyleOption(option)
        option.text = ""
        option.features &= ~QStyleOptionToolButton.ToolButtonFeature.HasMenu
        painter = QStylePainter(self)
        painter.drawComplexControl(QStyle.ComplexControl.CC_ToolButton, option)
        self._paint_words(painter)

    def _paint_words(self, painter: QPainter) -> None:
        metrics, colours = self.fontMetrics(), self.palette()
        side = metrics.height()
        ink = colours.color(colours.ColorRole.ButtonText)
        box = QRectF(_PAD, (self.height() - side) / 2, side, side)
        paint_icon(painter, self._icon, box, ink)
        room = self.rect().adjusted(2 * _PAD + side, 0, -_PAD - self._arrow(), 0)
        middle = Qt.AlignmentFlag.AlignVCenter
        painter.setPen(ink)
        shown = metrics.elidedText(self._words, self._elide, max(0, room.width()))
        painter.drawText(room, middle | Qt.AlignmentFlag.AlignLeft, shown)
        if self._arrow():
            place = self.rect().adjusted(self.width() - _PAD - self._arrow(), 0, -_PAD, 0)
            painter.drawText(place, middle | Qt.AlignmentFlag.AlignRight, "▾")

    def _arrow(self) -> int:
        return self.fontMetrics().horizontalAdvance("▾ ") if self.menu() is not None else 0

    def _beside(self) -> int:
        """Return what is next to the words, px."""
        return self.fontMetrics().height() + 3 * _PAD + self._arrow()


class TopBar(QWidget):
    """Assembled from the table of actions and the state; between the menus and the workspaces."""

    def __init__(self, services: Services, actions: Actions, fields: QMenu) -> None:
        """Show nothing yet; ``fields`` is the menu in which a dataset's field is chosen."""
        super().__init__()
        self.setObjectName("topBar")
        self._services = services
        self._make_labels()
        self.chip = named(WordsButton("field", Qt.TextElideMode.ElideRight, 10), "fieldChip")
        self.chip.setMenu(fields)
        self.chip.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.camera_bar = CameraBar(services)
        self.saved = SaveState(services)
        self.search = self._make_search(actions["palette"])
        parts = (
            _button("previous", actions["previous_frame"]),
            self.position,
            _button("next", actions["next_frame"]),
            self.status,
            _button("done", actions["commit"]),
            self.chip,
            (self.frame, 1),
            (self.camera_bar.jac, 9),
            self.saved,
            self.search,
        )
        self.setLayout(hbox(*parts, spacing=3, margins=0))
        store = services.store
        store.watch(lambda s: (s.workspace, s.frame_index), self._show_frame)
        store.watch(lambda s: (s.workspace, s.field), self._show_dataset)
        services.review.statusChanged.connect(self._show_status)
        self._show_frame()
        self._show_dataset()

    def _make_labels(self) -> None:
        self.position = named(SteadyLabel(), "framePosition")
        self.position.setFont(fixed_width(self.position.font()))
        self.frame = named(ElidedLabel(Qt.TextElideMode.ElideLeft), "frameName")
        self.frame.setContentsMargins(4, 0, 0, 0)
        self.frame.setMinimumWidth(_LEAST_NAME * self.fontMetrics().averageCharWidth())
        # Nothing next to it moves when it changes.
        words, advance = (tr(s.value) for s in Status), self.fontMetrics().horizontalAdvance
        tip = tr("Status of this frame (panel Review)")
        self.status = named(SteadyLabel(max(words, key=advance)), "frameStatus", tip=tip)
        self.status.setContentsMargins(4, 0, 4, 0)

    def _make_search(self, action: QAction) -> WordsButton:
        search = WordsButton("find", Qt.TextElideMode.ElideRight, 0)
        named(search, "searchButton", tip=action.toolTip())
        search.clicked.connect(action.trigger)
        search.set_words(tr("Find anything"))
        return search

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Show the words of the search where names have room, too; leave out the status, which the
        panel Review has, where they have little."""
        super().resizeEvent(event)
        line = self.fontMetrics().height()
        self.status.setVisible(self.window().width() > _TIGHT * line)
        roomy = self.width() > _ROOMY * line
        hint = self.search.sizeHint() if roomy else self.search.minimumSizeHint()
        self.search.setFixedWidth(hint.width())

    def _show_status(self, _frame: str = "") -> None:
        shown = self._services.state.frame
        self.status.setText(tr(self._services.review.status(shown.name).value) if shown else "")

    def _show_frame(self) -> None:
        workspace = self._services.state.workspace
        count = len(workspace.frames) if workspace is not None else 0
        self.position.setText(
            f" {self._services.state.frame_index + 1} / {count} " if count else " – "
        )
        frame = self._services.state.frame
        self.frame.set_text(frame.name if frame is not None else "")
        for label in (self.position, self.frame):
            label.setToolTip(str(frame.image_path) if frame is not None else "")
        self._show_status()

    def _show_dataset(self) -> None:
        workspace, field = self._services.state.workspace, self._services.state.field
        name = workspace.root.name if workspace is not None else ""
        self.chip.set_words(" · ".join(filter(None, (name, tr(field.title)))))
        lines = [str(workspace.root)] if workspace is not None else []
        lines += [tr("Field: {field}", field=field.described), tr("Click to choose another one")]
        self.chip.setToolTip("\n".join(lines))


def _button(icon: str, action: QAction) -> IconButton:
    button = named(IconButton(icon), f"top_{icon}")
    button.show_action(action)
    return button
