"""The picture as it is shown: in the chosen look, lines enhanced in the background."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from procc_annotator.gui.worker import Job, run_in_background
from procc_annotator.image.adjust import Look, adjust
from procc_annotator.image.decode import PixelArray


class ShownPicture(QObject):
    """Pixels of the frame on screen in the chosen look; the frame's own pixels are never touched.

    A lookup table is applied at once. Line enhancement takes too long for that: until it is done
    the picture is shown without.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.look = Look()
        self.pixels: PixelArray | None = None
        self._picture: PixelArray | None = None
        self._job: Job | None = None

    def set_picture(self, picture: PixelArray | None) -> None:
        """Another frame; announced by nobody, the caller shows `pixels`."""
        self._picture = picture
        self._apply()

    def set_look(self, look: Look) -> None:
        """Another look, kept across frames."""
        if look != self.look:
            self.look = look
            self._apply()
            self.changed.emit()

    def _apply(self) -> None:
        if self._job is not None:
            self._job.cancel()
            self._job = None
        picture, look = self._picture, self.look
        if picture is None:
            self.pixels = None
            return
        self.pixels = adjust(picture, replace(look, enhance=False))
        if not look.enhance:
            return
        self._job = run_in_background(
            lambda control: adjust(picture, look),
            on_result=self._arrived,
            on_error=None,
            owner=self,
            urgent=True,
        )

    def _arrived(self, pixels: PixelArray) -> None:
        self._job = None
        self.pixels = pixels
        self.changed.emit()
