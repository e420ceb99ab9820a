"""Keeps the status bar in step with the document and the cursor."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QObject

from procc_annotator.camera.backprojection import ground_from_px
from procc_annotator.gui.canvas.canvas import Canvas
from procc_annotator.gui.state.document import Document
from procc_annotator.gui.window.status import StatusLine
from procc_annotator.translation import tr


class StatusReport(QObject):
    """Hint, cursor position, work under way."""

    def __init__(
        self, document: Document, canvas: Canvas, status: StatusLine, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._document = document
        self._canvas = canvas
        self._status = status
        canvas.cursorMoved.connect(self.show_cursor)
        canvas.hintChanged.connect(status.set_hint)
        store = document.store
        store.watch(lambda s: s.field, self._show_titles)
        store.watch(
            lambda s: (s.setup, s.projection_visible, s.active, s.cameras_of(s.active)),
            self._look_again,
        )
        document.disagreement.changed.connect(self._look_again)
        document.uncertainty.changed.connect(self._look_again)
        document.set_scores.progressed.connect(self.show_scoring)
        status.set_hint(canvas.hint)
        self._show_titles()

    def _show_titles(self) -> None:
        """What elements are called, which hints and messages name."""
        self._status.hint.set_titles(tr(e.title) for e in self._document.state.field.elements)

    def show_scoring(self, done: int, total: int) -> None:
        """How far the scores of the set are; nothing once they are all there."""
        text = tr("scoring {done:,} / {total:,}", done=done, total=total) if done < total else ""
        self._status.set_work(text, tr("Camera > Stop scoring the set ends it"))

    def show_comparing(self, done: int, total: int) -> None:
        """How far the comparison of two sources is; nothing once it is over."""
        text = tr("comparing {done:,} / {total:,}", done=done, total=total) if total else ""
        self._status.set_work(text, tr("Camera > Stop scoring the set ends it"))

    def show_ghosts(self, done: int, total: int) -> None:
        """How far the look along all ghosts is; nothing once it is over."""
        text = tr("ghosts {done:,} / {total:,}", done=done, total=total) if total else ""
        self._status.set_work(text, tr("Esc ends it"))

    def _look_again(self, *_: object) -> None:
        self.show_cursor(self._canvas.cursor_px)

    def show_cursor(self, px: tuple[float, float] | None) -> None:
        """Picture pixels, and metres on the ground when a camera is shown."""
        at = None if px is None else self._evaluated(px)
        self._status.set_cursor(px, None if at is None else self._metres(at))
        found = self._document.disagreement.value
        apart = found.at(*at) if found is not None and at is not None else None
        self._status.set_disagreement(self._document.disagreement.wanted, apart)
        known = self._document.uncertainty.value
        sd = known.at(*px) if known is not None and px is not None else None
        self._status.set_uncertainty(self._document.uncertainty.wanted, sd)

    def _evaluated(self, px: tuple[float, float]) -> tuple[float, float] | None:
        """A place of the picture in px of the evaluation size."""
        size, target = self._document.state.picture_size, self._document.state.setup.size
        if size is None:
            return None
        # Both grids share the centres of their corners.
        return px[0] * (target[0] - 1) / (size[0] - 1), px[1] * (target[1] - 1) / (size[1] - 1)

    def _metres(self, at: tuple[float, float]) -> tuple[float, float] | None:
        camera = self._document.judge.camera
        if camera is None:
            return None
        ground = ground_from_px(camera, np.array([at]))
        if not np.isfinite(ground).all() or np.abs(ground).max() > 999:
            return None
        metres = ground[0]
        return float(metres[0]), float(metres[1])
