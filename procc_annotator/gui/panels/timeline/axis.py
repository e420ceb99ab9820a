"""Where the frames of a sequence lie along a strip: all of them, or those a person zoomed to."""

from __future__ import annotations

from dataclasses import dataclass, replace

_FEWEST = 20.0  # frames across the whole strip; nobody wants fewer


@dataclass(frozen=True, slots=True)
class Axis:
    """Frame numbers along a width.

    A frame takes the room from its number to the next one.

    Attributes:
        first, last: numbers there are.
        width: px.
        begin, end: numbers at both ends of the width, the end beyond its frame.
    """

    first: int
    last: int
    width: float
    begin: float
    end: float

    @classmethod
    def whole(cls, first: int, last: int, width: float) -> Axis:
        """All frames."""
        return cls(first, last, width, float(first), float(last + 1))

    @property
    def per_frame(self) -> float:
        """Px that a frame takes."""
        return self.width / (self.end - self.begin)

    @property
    def is_whole(self) -> bool:
        """Return whether all frames are in sight."""
        return self.end - self.begin >= self.last + 1 - self.first

    def x_of(self, number: float) -> float:
        """Return where a frame begins, px."""
        return (number - self.begin) * self.per_frame

    def middle_of(self, number: float) -> float:
        """The middle of a frame, px."""
        return self.x_of(number + 0.5)

    def number_at(self, x: float) -> int:
        """The frame at a place, px; the nearest one next to the strip."""
        number = int((x / self.per_frame) + self.begin)
        return min(max(number, self.first), self.last)

    def with_width(self, width: float) -> Axis:
        """The same frames along another width."""
        return replace(self, width=max(1.0, width))

    def zoomed(self, times: float, x: float) -> Axis:
        """So many times as near, while the frame at a place stays there."""
        span = min(max((self.end - self.begin) / times, _FEWEST), self.last + 1.0 - self.first)
        at = self.begin + x / self.per_frame
        return self._from(at - x / self.width * span, span)

    def scrolled(self, frames: float) -> Axis:
        """Moved along by some frames."""
        return self._from(self.begin + frames, self.end - self.begin)

    def showing(self, number: int) -> Axis:
        """Moved along, if need be, to have a frame in sight, with some room around it."""
        span = self.end - self.begin
        room = 0.1 * span
        if self.begin + room <= number <= self.end - room:
            return self
        return self._from(number + 0.5 - span / 2, span)

    def _from(self, begin: float, span: float) -> Axis:
        begin = min(max(begin, float(self.first)), self.last + 1.0 - span)
        begin = max(begin, float(self.first))
        return replace(self, begin=begin, end=begin + span)
