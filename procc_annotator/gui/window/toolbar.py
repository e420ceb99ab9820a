"""The bar above the picture: frame, tool, threshold, camera and its score."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import (
    QComboBox,
    QHBoxLayout,
    QLabel,
    QMenu,
    QSizePolicy,
    QSlider,
    QToolBar,
    QToolButton,
    QWidget,
    QWidgetAction,
)

from procc_annotator.camera.base import projects_only_ground
from procc_annotator.gui.decimal_box import DecimalBox
from procc_annotator.gui.panels.refresher import judged
from procc_annotator.gui.picture.looks import LookControls
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.state import MAX_TAU, MIN_TAU
from procc_annotator.gui.theme import fixed_width
from procc_annotator.gui.window.menus import Actions
from procc_annotator.gui.window.status import ElidedLabel, SteadyLabel
from procc_annotator.session.facts.origins import Status

_NO_CAMERA = "no camera"
_WIDEST_CAMERA = 200
_JAC_TIP = "Jaccard index of this frame at tau"
_SHORT = {"snapping": "Snap", "two_clicks": "2 clicks", "loupe": "Loupe"}


class TauControl(QWidget):
    """The threshold as a slider and a number; both change it live."""

    def __init__(self, document: Document) -> None:
        super().__init__()
        self._document = document
        tip = "Threshold tau: an element passes when all its points are nearer (+ and -)"
        label = QLabel("τ")
        self.slider = QSlider(Qt.Orientation.Horizontal)
        self.slider.setObjectName("tauSlider")
        self.slider.setRange(round(MIN_TAU * 10), round(MAX_TAU * 10))
        self.slider.setSingleStep(5)
        self.slider.setPageStep(20)
        self.slider.setFixedWidth(100)
        self.spin = DecimalBox()
        self.spin.setObjectName("tauSpin")
        self.spin.setRange(MIN_TAU, MAX_TAU)
        self.spin.setDecimals(1)
        self.spin.setSingleStep(0.5)
        self.spin.setSuffix(" px")
        self.spin.setKeyboardTracking(False)
        self.spin.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        layout = QHBoxLayout(self)
        layout.setContentsMargins(4, 0, 4, 0)
        for widget in (label, self.slider, self.spin):
            widget.setToolTip(tip)
            layout.addWidget(widget)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Preferred)
        self.slider.valueChanged.connect(lambda tenths: document.set_tau(tenths / 10))
        self.spin.valueChanged.connect(document.set_tau)
        document.store.watch(lambda s: s.tau, self._show)
        self._show(document.tau)

    def _show(self, tau: float) -> None:
        with QSignalBlocker(self.slider), QSignalBlocker(self.spin):
            self.slider.setValue(round(tau * 10))
            self.spin.setValue(tau)


class MainToolBar(QToolBar):
    """Assembled from the table of actions and the document."""

    lookChanged = Signal(object)  # how pictures are to be shown

    def __init__(self, document: Document, actions: Actions) -> None:
        super().__init__("Toolbar")
        self.setObjectName("toolbar")
        self.setMovable(False)
        self.setFloatable(False)
        self.toggleViewAction().setEnabled(False)
        self._document = document
        self._listed: list[str] = []
        self._make_labels()
        self._make_cameras()
        for name in ("previous_frame", "next_frame"):
            self.addAction(actions[name])
        self.widgetForAction(actions["previous_frame"]).setText("‹")  # type: ignore[attr-defined]
        self.widgetForAction(actions["next_frame"]).setText("›")  # type: ignore[attr-defined]
        self.insertWidget(actions["next_frame"], self.position)
        self.addWidget(self.status)
        self.addSeparator()
        for name in ("draw_mode", "edit_mode"):
            self.addAction(actions[name])
        self.addSeparator()
        for name in _SHORT:
            self.addAction(actions[name])
            button = self.widgetForAction(actions[name])
            assert isinstance(button, QToolButton)
            button.setText(_SHORT[name])
        self._add_looks()
        self.addSeparator()
        for name in ("blind", "commit"):
            self.addAction(actions[name])
        self.addSeparator()
        self.tau = TauControl(document)
        self.addWidget(self.tau)
        self.addSeparator()
        for widget in (self.cameras, self.jac, self.terms):
            widget.setContentsMargins(6, 0, 2, 0)
            self.addWidget(widget)
        store = document.store
        store.watch(lambda s: (s.workspace, s.frame_index), self._show_frame)
        store.watch(lambda s: (s.looks, s.active), self._show_cameras)
        store.watch(judged, self._show_score)
        document.review.statusChanged.connect(self._show_status)
        self._show_frame()
        self._show_cameras()
        self._show_score()

    def _make_labels(self) -> None:
        self.position = SteadyLabel()
        self.position.setObjectName("framePosition")
        self.position.setFont(fixed_width(self.position.font()))
        # A toolbar does not make room when a text grows.
        words, advance = (s.value for s in Status), self.fontMetrics().horizontalAdvance
        self.status = SteadyLabel(max(words, key=advance))
        self.status.setObjectName("frameStatus")
        self.status.setContentsMargins(4, 0, 4, 0)
        self.status.setToolTip("Status of this frame (panel Review)")
        self.jac = SteadyLabel()
        self.jac.setObjectName("toolbarJac")
        self.jac.setFont(fixed_width(self.jac.font()))
        self.jac.setToolTip(_JAC_TIP)
        self.terms = ElidedLabel()
        self.terms.setObjectName("toolbarTerms")
        # The rest of the bar; a narrow window shows the beginning, and all of it in the tip.
        self.terms.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)

    def _make_cameras(self) -> None:
        self.cameras = QComboBox()
        self.cameras.setObjectName("cameraCombo")
        self.cameras.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self.cameras.setMaximumWidth(_WIDEST_CAMERA)
        self.cameras.setToolTip("The camera set that is judged (C switches)")
        self.cameras.activated.connect(lambda i: self._document.set_active_camera(i - 1))

    def _add_looks(self) -> None:
        """A button that opens brightness and the like."""
        self.looks = LookControls()
        self.looks.lookChanged.connect(self.lookChanged)
        menu = QMenu(self)
        action = QWidgetAction(menu)
        action.setDefaultWidget(self.looks)
        menu.addAction(action)
        button = QToolButton()
        button.setObjectName("lookButton")
        button.setText("Picture")
        button.setToolTip("Brightness, contrast, gamma, line enhance: only what you see changes")
        button.setMenu(menu)
        button.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.addWidget(button)

    def _show_status(self, _frame: str = "") -> None:
        shown = self._document.frame
        self.status.setText(self._document.review.status(shown.name).value if shown else "")

    def _show_frame(self, _: object = None) -> None:
        workspace = self._document.workspace
        count = len(workspace.frames) if workspace is not None else 0
        self.position.setText(f" {self._document.frame_index + 1} / {count} " if count else " – ")
        frame = self._document.frame
        self.position.setToolTip(str(frame.image_path) if frame is not None else "")
        self._show_status()

    def _show_cameras(self, _: object = None) -> None:
        """The loaded sets and the active one."""
        document = self._document
        names = [_NO_CAMERA, *(s.name for s in document.camera_sets)]
        with QSignalBlocker(self.cameras):
            if names != self._listed:
                self._fill_cameras(names)
            active = document.active_camera
            chosen = -1 if active is None else document.camera_sets.index(active)
            self.cameras.setCurrentIndex(chosen + 1)
        self.cameras.setEnabled(bool(document.camera_sets))
        self._show_score()

    def _fill_cameras(self, names: list[str]) -> None:
        self._listed = names
        self.cameras.clear()
        self.cameras.addItems(names)
        # Where room is short, the terms give way, not the camera's name.
        self.cameras.setMinimumWidth(min(_WIDEST_CAMERA, self.cameras.sizeHint().width()))

    def _show_score(self, _: object = None) -> None:
        """JaC, or why there is none."""
        document = self._document
        score = document.score
        if score is not None and (why := document.why_not_judged):
            self.jac.setText(f"<b>JaC –</b> {why}")
        elif score is not None:
            own = document.active_source is document.fit_source.source
            self.jac.setText(f"<b>JaC {score.jac:.3f}</b>{' of the fit' if own else ''}")
        elif document.active_camera is None:
            self.jac.setText("")
        elif not document.projection_visible:
            self.jac.setText("<b>blind</b>: commit to see JaC")
        else:
            words = "camera unreadable" if document.camera_error else "no camera here"
            self.jac.setText(f"<b>{words}</b>")
        hidden = not document.projection_visible
        self.jac.setToolTip(_JAC_TIP if hidden else document.camera_error or _JAC_TIP)
        camera = document.camera
        ground_only = camera is not None and projects_only_ground(camera)
        terms = document.setup.describe(ground_only=ground_only)
        self.terms.set_text(terms)
        self.terms.setToolTip(f"What the score is computed with: {terms}")
