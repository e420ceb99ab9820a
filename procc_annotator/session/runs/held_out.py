"""How well cameras predict elements that were left out of their fits, of a whole set."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from procc_annotator.field.fingerprint import field_fingerprint
from procc_annotator.io.camera_files.held_out_table import LeftOutResult, LeftOutElement, LeftOutSettings
from procc_annotator.metric.setup import EvaluationSetup


@dataclass
class LeftOutTally:
    """The elements left out of a source's fits, of all its frames, by what they were judged with.

    Attributes:
        found: terms -> the elements of each frame.
    """

    found: dict[LeftOutSettings, list[tuple[LeftOutElement, ...]]] = field(default_factory=dict)

    def add(self, of_frame: LeftOutResult | None) -> None:
        """What is known of a frame's camera."""
        if of_frame is not None:
            self.found.setdefault(of_frame.terms, []).append(of_frame.elements)

    def merge(self, other: LeftOutTally) -> None:
        """Add the frames that follow."""
        for terms, frames in other.found.items():
            self.found.setdefault(terms, []).extend(frames)

    def at(self, setup: EvaluationSetup) -> LeftOutMetrics:
        """What counts where cameras are judged so."""
        if not self.found:
            return LeftOutMetrics()
        own = left_out_settings(setup)
        frames = self.found.get(own, [])
        others = tuple(sorted({(t.protocol, t.size) for t in self.found if t != own}))
        return LeftOutMetrics(len(frames), tuple(e for frame in frames for e in frame), others)


@dataclass(frozen=True)
class LeftOutMetrics:
    """The elements left out of a source's fits.

    Attributes:
        frames: that these are of.
        elements: left out, of all frames.
        others: protocol and size of figures that were made with other terms, and do not count.
    """

    frames: int = 0
    elements: tuple[LeftOutElement, ...] = ()
    others: tuple[tuple[str, tuple[int, int]], ...] = ()

    def shares(self, tau: float) -> tuple[float, float] | None:
        """The shares of elements that are correct at a threshold under the cameras of the others,
        and under those of all; None without elements."""
        if not self.elements:
            return None
        predicted = passed((e.predicted_px for e in self.elements), tau)
        explained = passed((e.explained_px for e in self.elements), tau)
        return predicted / len(self.elements), explained / len(self.elements)


def left_out_settings(setup: EvaluationSetup) -> LeftOutSettings:
    """What elements are judged with."""
    return LeftOutSettings(setup.protocol, setup.size, field_fingerprint(setup.field))


def passed(distances_px: Iterable[float | None], tau: float) -> int:
    """How many elements with such farthest points are correct at a threshold."""
    return sum(d is not None and d < tau for d in distances_px)
