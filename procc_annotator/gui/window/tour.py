"""A tour of a minute, on a copy of the sample: one thing to do at a time, in a bar."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QDialog, QPushButton

from procc_annotator.dataset.records import Status
from procc_annotator.gui.commands.opening import sample_folder
from procc_annotator.gui.messages import Bar
from procc_annotator.gui.state.sequences import is_annotated
from procc_annotator.gui.state.services import Services
from procc_annotator.translation import tr, word

_LOOK_MS = 200
_LEFT_OUT = shutil.ignore_patterns(
    "basketball",
    "ice_hockey",
    "volleyball",
    "drawing",
    "shot",
    "views",
    "second_annotator",
    "other_names",
)


class Tour(Bar):
    """Shows the steps, each until the state says that it was done."""

    def __init__(self, services: Services, in_sight: Callable[[str], bool]) -> None:
        """Show nothing yet; ``in_sight``: whether a panel is, by name."""
        super().__init__("tourBar")
        self.services, self.in_sight, self._step = services, in_sight, 0
        skip, end = QPushButton(tr("Skip")), QPushButton(tr("End"))
        self.add_button(skip, tr("Go on to the next step"), lambda: self._show(self._step + 1))
        self.add_button(end, tr("Esc ends the tour, too"), self.hide)
        self._timer = QTimer(self)  # only while a step is shown
        self._timer.timeout.connect(self._look)

    def start(self) -> None:
        """Open a new copy of the sample, where nothing is annotated, and show the first step."""
        services, sample = self.services, sample_folder()
        if sample is None:
            services.say(tr("the sample comes with the source, not here"), "warning")
            return
        try:
            copied = Path(tempfile.mkdtemp(), "tour")
            shutil.copytree(sample, copied, ignore=_LEFT_OUT)
        except OSError as error:
            services.say(tr("the sample cannot be copied: {why}", why=error), "warning")
            return
        services.opening.open_path(copied)
        if (workspace := services.state.workspace) is not None:
            every = range(len(workspace.frames))
            bare = (index for index in every if not is_annotated(workspace, index))
            services.navigator.go_to(next(bare, 0))
            self._show(0)

    def key(self, name: str, _shift: bool) -> bool:
        """End with Escape, while nothing is chosen; False for all else."""
        ends = name == "Escape" and self.isVisible() and not self.services.state.selected_class
        if ends:
            self.hide()
        return ends

    def has_status(self, status: Status) -> bool:
        """Return whether the frame on screen has a status."""
        return self.services.review.status(self.services.state.frame_name or "") is status

    def _show(self, step: int) -> None:
        self._step = step
        number = tr("{n} of {total}", n=step + 1, total=len(_STEPS))
        self.tell(f"{number}:  {tr(_STEPS[step][0])}" if step < len(_STEPS) else "")
        self._timer.start(_LOOK_MS)

    def _look(self) -> None:
        if not self.isVisible():
            self._timer.stop()
        elif _STEPS[self._step][1](self):
            self._show(self._step + 1)


_STEPS: tuple[tuple[str, Callable[[Tour], bool]], ...] = (
    (word("The camera is found without a click; dashed: what it expects. Shift+Enter accepts that"),
     lambda tour: len(tour.services.state.annotation.annotated) > 3),
    (word("W switches to editing: drag a point off its line"),
     lambda tour: tour.services.state.selection.point is not None),
    (word("The tab Check lists possible mistakes: open it. F12 applies the first remedy"),
     lambda tour: tour.in_sight("findings")),
    (word("Ctrl+Enter: this frame is done"), lambda tour: tour.has_status(Status.DONE)),
    (word("Ctrl+Shift+D: a frame without annotation. W, and draw a line: click its ends, press"
          " Enter, choose its name"),
     lambda tour: tour.has_status(Status.IN_PROGRESS)),
    (word("Judge, at the top right (Shift+F2), then C: the fitted camera, judged by your"
          " annotation"),
     lambda tour: tour.in_sight("scores") and tour.services.state.active is not None),
    (word("File > Export as… writes the annotations for other programs: look at it"),
     lambda _: isinstance(QApplication.activeWindow(), QDialog)),
    (word("That was the tour. Shift+F1: back to annotating; F1: all keys"), lambda _: False),
)  # fmt: skip
