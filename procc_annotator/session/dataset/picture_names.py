"""How a frame that a file of another program tells is called by its picture."""

from __future__ import annotations

from collections.abc import Mapping

from procc_annotator.io.frame_names import PICTURE_FOLDERS


class PicturesByName:
    """Names of the frames that have a picture, to find those that files tell otherwise: they leave
    out the folder that only keeps pictures (``game/img1/000001`` is game/000001 to game state), or
    all folders."""

    def __init__(self, pictures: Mapping[str, object]) -> None:
        """Look at nothing yet.

        Args:
            pictures: by frame.
        """
        self._pictures = pictures
        self._of_stem: dict[str, str | None] | None = None

    def called(self, frame: str) -> str:
        """The name that a frame has by its picture; its own where no picture can be meant."""
        if frame in self._pictures:
            return frame
        above, slash, name = frame.rpartition("/")
        for inner in PICTURE_FOLDERS:
            for path in (f"{above}{slash}{inner}/{name}", f"{inner}/{frame}"):
                if path in self._pictures:
                    return path
        return (None if above else self._by_stem().get(name)) or frame

    def _by_stem(self) -> dict[str, str | None]:
        """Frames of a tree by the last part of their name; None where several have it."""
        if self._of_stem is None:
            self._of_stem = {}
            for frame in self._pictures:
                stem = frame.rpartition("/")[2]
                self._of_stem[stem] = None if stem in self._of_stem else frame
        return self._of_stem
