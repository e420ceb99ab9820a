"""Detectors of others: packages that propose cameras, or labelled points, for a picture."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.errors import ProccError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.fit.fitting import fit_camera
from procc_annotator.fit.from_picture.proposal import KnownPosition, Proposal
from procc_annotator.fit.from_picture.proposing import propose_camera
from procc_annotator.image.pixels import PixelArray
from procc_annotator.io.camera_files.camera_plugins import discover

GROUP = "procc_annotator.proposers"
# How surely a detector knows where a camera stands, and how many places are tried.
_SD_M, _MOST_POSITIONS = 2.0, 5

# What a detector says of a picture: cameras in its px, or points by class, normalised.
Hint = PinholeCamera | FrameAnnotation


@dataclass(frozen=True)
class PictureProposer:
    """A detector.

    Attributes:
        name: typed after ``--with``.
        title: for people.
        propose: picture, (H, W, 4) BGRA uint8, and field -> cameras in px of the picture, or
            annotations of normalised points, the likeliest first; nothing where it sees nothing.
    """

    name: str
    title: str
    propose: Callable[[PixelArray, Field], Iterable[Hint]]


@cache
def proposers() -> tuple[dict[str, PictureProposer], tuple[str, ...]]:
    """The detectors that are installed, by name, and what is wrong with others, one line each."""
    found, problems = discover(PictureProposer, GROUP, "proposer plug-in")
    by_name: dict[str, PictureProposer] = {}
    for point, given in found:
        if given.name in by_name:
            problems.append(f"the proposer plug-in {point!r} gives {given.name!r}, which there is")
        else:
            by_name[given.name] = given
    return by_name, tuple(problems)


@dataclass(frozen=True)
class WithPlugin:
    """`propose_camera`, also where a detector says that the camera stands: what it says is made
    right on the paint, and judged by the same rules.

    It survives the trip to a worker, where the detector is loaded anew.

    Attributes:
        name: of the detector.
    """

    name: str

    def __call__(
        self, picture: PixelArray, field: Field, *, known: Sequence[KnownPosition]
    ) -> Proposal:
        hinted = _positions(self.hints(picture, field))
        return propose_camera(picture, field, known=(*known, *hinted))

    def hints(self, picture: PixelArray, field: Field) -> list[PinholeCamera]:
        """The cameras that the detector's answers come to.

        Raises:
            ProccError: it went wrong, or gives something else.
        """
        try:
            hints = list(chosen_proposer(self.name).propose(picture, field))
        except ProccError:
            raise
        # Whatever somebody else's code raises is told as its fault.
        except Exception as error:
            said = " ".join(str(error).split())[:300] or "no reason given"
            raise self._error(f"{type(error).__name__}: {said}") from error
        size = (picture.shape[1], picture.shape[0])
        found = [self._camera(hint, field, size) for hint in hints]
        return [camera for camera in found if camera is not None]

    def _camera(self, hint: object, field: Field, size: tuple[int, int]) -> PinholeCamera | None:
        if isinstance(hint, FrameAnnotation):
            camera = fit_camera(hint, field, model="P", size=size).camera
            return camera if isinstance(camera, PinholeCamera) else None
        if not isinstance(hint, PinholeCamera):
            raise self._error(f"gives {type(hint).__name__}, not PinholeCamera or FrameAnnotation")
        if not all(map(math.isfinite, hint.position_world)):
            raise self._error("gives a camera whose position is not finite")
        return hint

    def _error(self, why: str) -> ProccError:
        return ProccError(f"the proposer {self.name!r} cannot be used: {why}")


def _positions(cameras: Sequence[PinholeCamera]) -> list[KnownPosition]:
    """Where cameras stand, the first few of different ones."""
    found: list[np.ndarray] = []
    for camera in cameras:
        place = np.array(camera.position_world)
        if all(np.linalg.norm(place - other) > _SD_M for other in found):
            found.append(place)
    return [KnownPosition(place, np.eye(3) * _SD_M**2) for place in found[:_MOST_POSITIONS]]


def chosen_proposer(name: str) -> PictureProposer:
    """An installed detector.

    Raises:
        UsageError: there is none of this name.
    """
    by_name, problems = proposers()
    if name not in by_name:
        there = ", ".join(by_name) or "none is installed"
        raise UsageError("; ".join((f"--with {name}: no such proposer ({there})", *problems)))
    return by_name[name]
