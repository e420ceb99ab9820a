"""The judged camera in the top bar: threshold, source, JaC and the terms it is computed with."""

from __future__ import annotations

from html import escape

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QSizePolicy, QWidget

from procc_annotator.camera.base import projects_only_ground
from procc_annotator.gui.panels.refresher import judged
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.theme import fixed_width
from procc_annotator.gui.window.status import ElidedLabel, SteadyLabel
from procc_annotator.gui.window.tau_control import TauControl
from procc_annotator.translation import tr, word

_NO_CAMERA = word("no camera")
_WIDEST_CAMERA = 14  # average letters
_JAC_TIP = word("Jaccard index of this frame at tau")


class CameraBar(QWidget):
    """Is there only where a camera is loaded or judged."""

    def __init__(self, document: Document) -> None:
        super().__init__()
        self.setObjectName("cameraBar")
        self._document = document
        self._listed: list[str] = []
        self.tau = TauControl(document)
        self.cameras = QComboBox()
        self.cameras.setObjectName("cameraCombo")
        self.cameras.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToContents)
        self.cameras.setToolTip(tr("The camera set that is judged (C switches)"))
        self.cameras.activated.connect(lambda i: document.camera_sources.set_active_camera(i - 1))
        self.jac = SteadyLabel()
        self.jac.setTextFormat(Qt.TextFormat.RichText)
        self.jac.setObjectName("judgedJac")
        self.jac.setFont(fixed_width(self.jac.font()))
        self.jac.setToolTip(tr(_JAC_TIP))
        self.jac.setContentsMargins(6, 0, 2, 0)
        self.terms = ElidedLabel()
        self.terms.setObjectName("judgedTerms")
        # The rest of the bar; a narrow window shows the beginning, and all of it in the tip.
        self.terms.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(4)
        for widget in (self.tau, self.cameras, self.jac):
            row.addWidget(widget)
        row.addWidget(self.terms, 1)
        store = document.store
        store.watch(lambda s: (s.looks, s.active), self._show_cameras)
        store.watch(judged, self._show_score)
        self._show_cameras()

    def _show_cameras(self) -> None:
        """The loaded sets and the active one."""
        document = self._document
        names = [tr(_NO_CAMERA), *(s.name for s in [look.cameras for look in document.state.looks])]
        with QSignalBlocker(self.cameras):
            if names != self._listed:
                self._fill_cameras(names)
            active = document.state.active_cameras
            chosen = (
                -1
                if active is None
                else [look.cameras for look in document.state.looks].index(active)
            )
            self.cameras.setCurrentIndex(chosen + 1)
        self.cameras.setEnabled(bool([look.cameras for look in document.state.looks]))
        loaded = any(s is not document.fit_source.source for s in document.state.sources)
        self.setVisible(loaded or document.state.active is not None)
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
        """JaC, or why there is none."""
        document = self._document
        score = document.judge.score
        if score is not None and (why := document.state.why_not_judged):
            self.jac.setText(tr("<b>JaC –</b> {why}", why=escape(why)))
        elif score is not None:
            own = document.state.active is document.fit_source.source
            said = tr("<b>JaC {jac:.3f}</b> of the fit") if own else "<b>JaC {jac:.3f}</b>"
            self.jac.setText(said.format(jac=score.jac))
        elif document.state.active_cameras is None:
            self.jac.setText("")
        elif not document.state.projection_visible:
            self.jac.setText(tr("<b>blind</b>: commit to see JaC"))
        else:
            words = tr("camera unreadable") if document.judge.shown.error else tr("no camera here")
            self.jac.setText(f"<b>{words}</b>")
        hidden = not document.state.projection_visible
        error = "" if hidden else document.judge.shown.error
        self.jac.setToolTip(error or tr(_JAC_TIP))
        camera = document.judge.camera
        ground_only = camera is not None and projects_only_ground(camera)
        terms = document.state.setup.describe(ground_only=ground_only)
        self.terms.set_text(terms)
        self.terms.setToolTip(tr("What the score is computed with: {terms}", terms=terms))
