"""Compare two annotators' files frame by frame: the run of several, of one pair."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from procc_annotator.errors import UsageError
from procc_annotator.field.model import Field
from procc_annotator.io.source import FileSource
from procc_annotator.metric.agreement import AgreementSummary, AgreementAccumulator
from procc_annotator.session.runs.consensus_run import ConsensusRun, ConsensusResult


class AgreementRun(ConsensusRun):
    """One pass over the frames two annotators have in common; iterate, then ask for the `summary`.

    Args:
        a, b: folder or archive of annotation files of each annotator.
        field, size, thresholds: as of `ConsensusRun`.
        among: names of frames of b, where others are not to be compared.
        own: names of frames of a, where nothing is to be told of others.

    Attributes:
        only_a, only_b: names of the frames only one annotated: reported, not compared.

    Raises:
        UsageError: nothing to compare, a threshold that is none, or a size that is no picture.
        InputError: a folder or archive that cannot be listed.
    """

    def __init__(
        self,
        a: FileSource,
        b: FileSource,
        field: Field,
        size: tuple[int, int],
        thresholds: Sequence[float],
        among: Collection[str] | None = None,
        own: Collection[str] | None = None,
    ) -> None:
        super().__init__((a, b), field, size, thresholds, pairs_only=True)
        self.only_a, self.only_b = self.alone
        if among is not None:
            files = {file for name, file in self.files[1].items() if name in among}
            self.frames = [frame for frame in self.frames if frame.files[1] in files]
        if own is not None:
            self.frames = [frame for frame in self.frames if frame.name in own]
            self.only_a = tuple(name for name in self.only_a if name in own)
        if not self.frames:
            raise UsageError("nothing to do: none of the frames asked for has annotations of both")
        self._sums = AgreementAccumulator(self.thresholds, self.only_a, self.only_b)

    def _take(self, results: Sequence[ConsensusResult], sums: None) -> None:
        for result in results:
            if result.agreement is not None:
                self._sums.add(result.name, result.agreement)

    def summary(self) -> AgreementSummary:
        """Figures of the frames seen so far."""
        return self._sums.summary()
