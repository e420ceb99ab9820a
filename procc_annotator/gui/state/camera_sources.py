"""A named source of cameras: how it is shown, and how it does in every frame of the set."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from procc_annotator.batch.audit import TAU_GRID, FrameAudit
from procc_annotator.dataset.camera_set import CameraSet, FrameCameras
from procc_annotator.dataset.computed_cameras import FIT_NAME, TRACK_NAME, FittedCameras
from procc_annotator.formats.cameras.fit_record import NOT_FITTED, FitCounts
from procc_annotator.interaction.palette import SOURCE_COLOURS
from procc_annotator.translation import tr


class CameraSource:
    """One of the camera sets a dataset is examined with; belongs to the interface thread.

    Attributes:
        camera_set: the cameras by frame; another object once one of them changed.
        colour: of its wireframe, its curves and its row, ``#rrggbb``.
        visible: whether it is drawn next to the active source.
        audits: frame name -> how it does there, of the frames audited so far that have both a
            camera and an annotation file; changed by `take` and `clear` only.
        problems: frame name -> why its camera cannot be used, of the frames audited so far.
    """

    def __init__(self, camera_set: FrameCameras, colour: str, *, visible: bool = True) -> None:
        self.camera_set: FrameCameras = camera_set
        self.colour = colour
        self.visible = visible
        self.audits: dict[str, FrameAudit] = {}
        self.problems: dict[str, str] = {}
        self._seen: set[str] = set()
        self._jac_sums = np.zeros(len(TAU_GRID))
        self._models: Counter[str] = Counter()
        self._fitted = NOT_FITTED  # of the audited frames

    @property
    def name(self) -> str:
        """Return what the user calls it."""
        return self.camera_set.name

    @property
    def files(self) -> CameraSet | None:
        """The cameras as files; None for those that are fitted here to the clicks.

        Only cameras from files have a name of the user's, a place that verdicts and other sessions
        know them by, and a score of their own: a fit is judged by the clicks it was made from.
        """
        return self.camera_set if isinstance(self.camera_set, CameraSet) else None

    @property
    def fitted(self) -> FitCounts:
        """Its cameras, of those seen, that were fitted to the clicks they are judged by."""
        return FitCounts(1) if isinstance(self.camera_set, FittedCameras) else self._fitted

    @property
    def look(self) -> SourceLook:
        """Return how it is shown now, as a value."""
        return SourceLook(self, self.camera_set, self.name, self.colour, self.visible)

    def forget(self, frames: Iterable[str]) -> None:
        """Forget what is known of some frames: their cameras are others now."""
        for frame in self._seen.intersection(frames):
            self.take(frame, None)
            self._seen.discard(frame)

    def clear(self) -> None:
        """Forget what is known of every frame: dataset or terms are others now."""
        self.audits.clear()
        self.problems.clear()
        self._seen.clear()
        self._models.clear()
        self._fitted = NOT_FITTED
        self._jac_sums[:] = 0.0

    def take(self, frame: str, audit: FrameAudit | None, problem: str = "") -> None:
        """Keep how the source does in a frame; None where there is nothing to judge."""
        self._seen.add(frame)
        before = self.audits.pop(frame, None)
        if before is not None:
            self._jac_sums -= before.jac
            self._models[before.model] -= 1
            self._fitted -= before.fitted
        if audit is not None:
            self.audits[frame] = audit
            self._jac_sums += audit.jac
            self._models[audit.model] += 1
            self._fitted += audit.fitted
        self.problems.pop(frame, None)
        if problem:
            self.problems[frame] = problem

    def to_look_at(self, frames: Iterable[str]) -> list[str]:
        """Those of some frames that were not examined. Fits come with a look at the frame itself,
        so that there is nothing to wait for if there is none."""
        there = self.camera_set.frames
        fitted = self.files is None
        return [f for f in frames if f not in self._seen and (f in there or not fitted)]

    def mean_jac(self, tau: float) -> float | None:
        """Mean JaC over the audited frames at the threshold of `TAU_GRID` nearest to ``tau``."""
        if not self.audits:
            return None
        column = int(np.argmin(np.abs(TAU_GRID - tau)))
        # Sums that edits were taken out of again may leave the interval by a rounding error.
        return float(np.clip(self._jac_sums[column] / len(self.audits), 0.0, 1.0))

    @property
    def models(self) -> tuple[str, ...]:
        """The camera models met in the audited frames, the most frequent one first."""
        return tuple(model for model, count in self._models.most_common() if count)

    def matched(self, frames: Iterable[str]) -> int:
        """Return how many of these frames have a camera that can be used, as far as it was
        tried."""
        there, problems = self.camera_set.frames, self.problems
        return sum(frame in there and frame not in problems for frame in frames)


@dataclass(frozen=True, slots=True)
class SourceLook:
    """How a source is shown; replaced when anything of it changes."""

    source: CameraSource
    cameras: FrameCameras
    name: str
    colour: str
    visible: bool


def free_colour(sources: Sequence[CameraSource]) -> str:
    """The first colour of the palette used least."""
    counts = Counter(source.colour for source in sources)
    return min(SOURCE_COLOURS, key=lambda colour: counts[colour])


def free_name(wanted: str, sources: Sequence[CameraSource]) -> str:
    """A name no one has: as wanted, or with a number behind it. The fit's and the track's are
    never free."""
    taken = {FIT_NAME, TRACK_NAME, *(source.name for source in sources)}
    name, number = wanted, 1
    while name in taken:
        number += 1
        name = f"{wanted} ({number})"
    return name


def same_files(some: CameraSet | None, other: CameraSet) -> bool:
    """Return whether two sets are the same files read the same way."""
    if some is None:
        return False
    places = (os.path.abspath(cameras.path) for cameras in (some, other))
    return some.format == other.format and len(set(places)) == 1


def where_else(path: Path) -> str:
    """Return what to do about a folder without cameras."""
    try:
        inner = sorted(p.name for p in path.iterdir() if p.is_dir() and not p.name.startswith("."))
    except OSError:  # a single file or an archive
        inner = []
    if inner:
        return tr("load one of its folders: {names}", names=", ".join(inner[:6]))
    return tr("expected files like camera_00037.json, 00037.npy or 00037.homographyMatrix")
