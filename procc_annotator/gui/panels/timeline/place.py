"""When a strip is there, and which: that of the shot for frames that follow one another, small
pictures for others; neither comes while the user works.

It takes room from the picture, which must not move under a click: found out late, it waits for the
next frame unless nothing was begun in this one.
"""

from __future__ import annotations

from PySide6.QtCore import QObject

from procc_annotator.gui.canvas.editor import Editor
from procc_annotator.gui.panels.timeline.filmstrip import Filmstrip
from procc_annotator.gui.panels.timeline.shot_strip import ShotStrip
from procc_annotator.gui.state import selectors as select
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.state.store import When


class StripPlace(QObject):
    """Shows and hides both strips."""

    def __init__(
        self, document: Document, editor: Editor, strip: ShotStrip, filmstrip: Filmstrip
    ) -> None:
        super().__init__(strip)
        self._document, self._editor, self._strip = document, editor, strip
        self._filmstrip = filmstrip
        self._wanted, self._begun = True, False
        strip.setVisible(False)
        filmstrip.setVisible(False)
        document.sequence.changed.connect(self._look)
        editor.changed.connect(self._note)
        document.store.watch(lambda s: (s.shown_annotation, s.selection), self._note, When.GESTURE)
        document.store.watch(select.frame, self._begin)

    @property
    def wanted(self) -> bool:
        """Return whether a person wants it where there is one."""
        return self._wanted

    def set_wanted(self, wanted: bool) -> None:
        """Show it where there is one, or do not."""
        self._wanted = wanted
        self._show()

    def _begin(self) -> None:
        """A frame came whole."""
        self._begun = False
        self._show()

    def _note(self) -> None:
        self._begun = True

    def _look(self) -> None:
        if not self._begun and not self._editor.drawing:
            self._show()

    def _show(self) -> None:
        sequence, workspace = self._document.sequence, self._document.state.workspace
        follow = sequence.value is not None
        several = workspace is not None and len(workspace.frames) > 1
        self._strip.setVisible(self._wanted and follow)
        known = follow or not sequence.working
        self._filmstrip.setVisible(self._wanted and several and known and not follow)
