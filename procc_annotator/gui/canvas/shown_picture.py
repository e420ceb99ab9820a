"""The picture as it is shown: in the chosen look, lines enhanced in the background."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from procc_annotator.gui.state.background import ComputedValue, Inputs
from procc_annotator.image.pixels import DisplayAdjustment, PixelArray, adjust_image


class ShownPicture(QObject):
    """Pixels of the frame on screen in the chosen look; the frame's own pixels are never touched.

    A lookup table is applied at once. Line enhancement takes too long for that: until it is done
    the picture is shown without.
    """

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.look = self._without = DisplayAdjustment()  # and without enhancement
        self._picture: PixelArray | None = None
        self._whole = True
        self._plain = ComputedValue(self._given, adjust_image, self, background=False)
        self._enhanced = ComputedValue(self._to_enhance, adjust_image, self)
        self._enhanced.changed.connect(self._arrived)

    @property
    def pixels(self) -> PixelArray | None:
        """Return what to show; None without a picture."""
        enhanced = self._enhanced.value
        return self._plain.value if enhanced is None else enhanced

    def set_picture(self, picture: PixelArray | None, *, whole: bool = True) -> None:
        """Another frame, or a first look at it; announced by no one, the caller shows `pixels`."""
        self._picture, self._whole = picture, whole
        self._enhanced.invalidate()

    def set_look(self, look: DisplayAdjustment) -> None:
        """Another look, kept across frames."""
        if look != self.look:
            self.look, self._without = look, replace(look, enhance=False)
            self._enhanced.clear()
            self._enhanced.invalidate()
            self.changed.emit()

    def _given(self) -> Inputs | None:
        return None if self._picture is None else (self._picture, self._without)

    def _to_enhance(self) -> Inputs | None:
        if self._picture is None or not (self._whole and self.look.enhance):
            return None
        return self._picture, self.look

    def _arrived(self) -> None:
        if self._enhanced.value is not None:
            self.changed.emit()
