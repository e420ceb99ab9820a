"""Propose a camera for every picture of a set: here, in processes, or on a cluster."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Protocol

from procc_annotator.errors import InputError
from procc_annotator.field.model import Field
from procc_annotator.field.stadiums import field_for_frame
from procc_annotator.fit.from_picture.agreed_positions import cluster_fit_positions
from procc_annotator.fit.from_picture.proposal import SURE, UNSURE, KnownPosition, Proposal
from procc_annotator.image.decode import decode_for_camera
from procc_annotator.image.pixels import PixelArray
from procc_annotator.image.video import video_frame_of_path, open_shared_video
from procc_annotator.session.dataset.frames import Frame
from procc_annotator.session.runs.kept_values import serialize
from procc_annotator.session.runs.set_run import SetRun
from procc_annotator.session.runs.unfinished import hex_digest, stamp_of_file


class Proposer(Protocol):
    """Proposes a camera for a picture, as `propose_camera` does; survives the trip to a worker."""

    def __call__(
        self, picture: PixelArray, field: Field, *, known: Sequence[KnownPosition]
    ) -> Proposal: ...


@dataclass(frozen=True, slots=True)
class Proposed:
    """What was proposed for one frame.

    Attributes:
        name: of the frame.
        proposal: the camera, or why there is none; None if the picture cannot be used.
        seconds: that it took.
        error: why the picture cannot be used.
        from_agreement: whether it was looked for where sure frames agree that cameras stand.
    """

    name: str
    proposal: Proposal | None = None
    seconds: float = 0.0
    error: str = ""
    from_agreement: bool = False

    @property
    def is_sure(self) -> bool:
        """Whether there is a camera that may be relied on."""
        return self.proposal is not None and self.proposal.state == SURE


@dataclass(frozen=True)
class ProposeCameras:
    """Proposes cameras for chunks of frames.

    Attributes:
        field: the elements, metres.
        known: where their cameras may be known to stand.
        propose: finds the camera of a picture.
    """

    field: Field
    known: tuple[KnownPosition, ...]
    propose: Proposer

    def __call__(self, chunk: Sequence[Frame]) -> tuple[list[Proposed], None]:
        return [self._propose(frame) for frame in chunk], None

    def _propose(self, frame: Frame) -> Proposed:
        began = time.perf_counter()
        try:
            picture = decode_for_camera(frame.image_path)
        except InputError as error:
            return Proposed(frame.name, error=str(error))
        field = field_for_frame(self.field, frame.name)
        proposal = mark_non_square_pixels(self.propose(picture, field, known=self.known), frame.image_path)
        return Proposed(frame.name, proposal, time.perf_counter() - began)


def mark_non_square_pixels(proposal: Proposal, picture: Path) -> Proposal:
    """A camera is not sure if the picture is of a video whose pixels are not square."""
    found = video_frame_of_path(picture)
    squeezed = "" if found is None else open_shared_video(found[0]).squeezed
    if proposal.state != SURE or not squeezed:
        return proposal
    return replace(proposal, state=UNSURE, reason=squeezed)


class ProposalRun(SetRun[Frame, Proposed, None]):
    """One pass over pictures; iterate it once, then ask whether `again` is worth it."""

    chunk = 1  # a second's work, and what is found is written as it comes
    task: ProposeCameras

    def __init__(
        self,
        frames: Sequence[Frame],
        field: Field,
        propose: Proposer,
        known: tuple[KnownPosition, ...] = (),
    ) -> None:
        super().__init__(frames, ProposeCameras(field, known, propose))

    def _digest(self, chunk: Sequence[Frame]) -> str:
        parts: list[object] = [serialize(self.task.known)]
        for frame in chunk:
            # A frame of a video lies in the video's file.
            file = frame.image_folder if frame.image_folder.is_file() else frame.image_path
            parts += [frame.name, stamp_of_file(file)]
        return hex_digest(*parts)

    def _sums_of(self, results: Sequence[Proposed]) -> None:
        return None


@dataclass(frozen=True)
class SecondPass:
    """Frames that are looked at once more where the sure ones say that cameras stand.

    Attributes:
        positions: on which frames agree.
        run: over the frames without a sure camera; it takes their results one by one.
        before: what was proposed for those.
    """

    positions: tuple[KnownPosition, ...]
    run: ProposalRun
    before: dict[str, Proposed]

    def better(self, found: Proposed) -> Proposed:
        """A frame's second proposal if it is sure, else its first one."""
        first = self.before[found.name]
        seconds = first.seconds + found.seconds
        if found.is_sure:
            return replace(found, seconds=seconds, from_agreement=True)
        return replace(first, seconds=seconds)


def second_pass(run: ProposalRun, found: Sequence[Proposed]) -> SecondPass | None:
    """What a second look at a set is to be, if its sure frames agree on a position and others may
    gain by it.

    Args:
        run: that is done; its executor does this one too.
        found: its results.
    """
    before = {one.name: one for one in found if one.proposal is not None and not one.is_sure}
    sure = [one.proposal.fit for one in found if one.is_sure and one.proposal is not None]
    others = [one.proposal.fit for one in before.values() if one.proposal is not None]
    positions = cluster_fit_positions(sure, run.task.field, others) if before else ()
    if not positions:
        return None
    frames = [frame for frame in run.frames if frame.name in before]
    known = (*run.task.known, *positions)
    again = ProposalRun(frames, run.task.field, run.task.propose, known)
    again.executor, again.kept = run.executor, run.kept
    return SecondPass(positions, again, before)
