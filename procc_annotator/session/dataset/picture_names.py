"""How a frame that a file of another program tells is called by its picture."""

from __future__ import annotations

from typing import Generic, TypeVar

from procc_annotator.io.frame_names import PICTURE_FOLDERS, ByFrame, FrameTable

T = TypeVar("T")


class PicturesByName(Generic[T]):
    """Names of the frames that have a picture, to find those that files tell otherwise: they leave
    out the folder that only keeps pictures (``game/img1/000001`` is game/000001 to game state), or
    all folders."""

    def __init__(self, pictures: FrameTable[T]) -> None:
        """Look at nothing yet.

        Args:
            pictures: by frame.
        """
        self._pictures = pictures
        self._of_stem: ByFrame[str | None] | None = None

    def called(self, frame: str) -> str:
        """The name that a frame has by its picture; its own where no picture can be meant."""
        for path in (frame, *(f"{inner}/{frame}" for inner in PICTURE_FOLDERS)):
            if (there := self._pictures.name_there(path)) is not None:
                return there
        return (None if "/" in frame else self._by_stem().get(frame)) or frame

    def _by_stem(self) -> dict[str, str | None]:
        """Frames of a tree by the last part of their name; None where several have it."""
        if self._of_stem is None:
            self._of_stem = ByFrame()
            for frame in self._pictures:
                stem = frame.rpartition("/")[2]
                self._of_stem[stem] = None if dict.__contains__(self._of_stem, stem) else frame
        return self._of_stem
