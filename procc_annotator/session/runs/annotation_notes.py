"""What annotations of a set have that lowers the score of every camera."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

from procc_annotator.annotation import FrameAnnotation, pixel_like
from procc_annotator.field.model import Field
from procc_annotator.io.json_text import printable
from procc_annotator.words import first_of, listed


@dataclass
class AnnotationNotes:
    """Frames with such annotations, and the classes that are of no element of the field."""

    in_pixels: list[str] = field(default_factory=list)
    empty: list[str] = field(default_factory=list)
    without_place: list[str] = field(default_factory=list)
    classes: Counter[str] = field(default_factory=Counter)

    def add(self, frame: str, annotation: FrameAnnotation, known: Field) -> None:
        """Add a frame.

        Args:
            known: the field its classes are of.
        """
        strange = [n for n in annotation.annotated if known.canonical_name(n) not in known.index]
        if pixel_like(annotation) is not None:
            self.in_pixels.append(frame)
        if not annotation.annotated:
            self.empty.append(frame)
        if strange:
            self.without_place.append(frame)
            self.classes.update(strange)

    def merge(self, other: AnnotationNotes) -> None:
        """Add those of the frames that follow."""
        self.in_pixels += other.in_pixels
        self.empty += other.empty
        self.without_place += other.without_place
        self.classes.update(other.classes)

    def lines(self) -> tuple[str, ...]:
        """One line for people for each kind that there is."""
        found = []
        if self.in_pixels:
            frames = listed(self.in_pixels, "frame")
            found.append(f"coordinates look like pixels, expected 0 to 1, in {frames}")
        if self.empty:
            frames = listed(self.empty, "frame")
            found.append(f"no element is annotated in {frames}: whatever a camera shows is wrong")
        if self.without_place:
            names = first_of([*map(printable, self.classes)])
            frames = listed(self.without_place, "frame")
            found.append(
                f"classes of no element of the field always count as missed: {names}, in {frames}"
            )
        return tuple(found)
