"""Proposed cameras as files, CSV and terminal tables."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from procc_annotator.batch.calibration import camera_file
from procc_annotator.batch.camera_proposals import ProposalRun, Proposed, second_pass
from procc_annotator.batch.execution.executor import Progress
from procc_annotator.batch.tracking import pack
from procc_annotator.calibration.single_image.proposal import (
    NONE,
    PROPOSAL_STATES,
    SURE,
    UNSURE,
    KnownPosition,
)
from procc_annotator.calibration.tracking.track import TrackedFrame
from procc_annotator.formats.atomic import make_folder, remove, write_atomic
from procc_annotator.formats.cameras.packed import PACKED_SUFFIX
from procc_annotator.formats.file_listing import UNSURE_FOLDER, camera_name
from procc_annotator.messages import pluralize
from procc_annotator.report.calibration import DEVIATION_COLUMNS, deviation_values
from procc_annotator.report.outputs import Interrupted
from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.data_files import csv_bytes
from procc_annotator.report.tables.table import (
    Column,
    MetricTable,
    Row,
    count_column,
    metric_column,
    metric_values,
    shortened,
)

TABLE_FILE = "proposals.csv"
_COLUMNS = (
    Column("frame"),
    Column("state"),
    Column("reason"),
    metric_column(metrics.PROBABILITY),
    metric_column(metrics.COVERAGE),
    metric_column(metrics.EXPLAINED),
    metric_column(metrics.RESIDUAL),
    metric_column(metrics.MARGIN),
    *DEVIATION_COLUMNS,
    metric_column(metrics.SECONDS),
    count_column("width"),
    count_column("height"),
    Column("camera"),
    Column("known_position", kind="yes_no"),
)
_SHOWN = 20


@dataclass
class ProposedSet:
    """Result for a set of pictures: its frames in order, and positions on which frames agreed."""

    frames: list[Proposed] = field(default_factory=list)
    positions: tuple[KnownPosition, ...] = ()

    @property
    def errors(self) -> list[str]:
        """Why pictures cannot be used, one line each."""
        return [one.error for one in self.frames if one.error]

    @property
    def states(self) -> Counter[str]:
        """Return how many frames are in each state."""
        return Counter(one.proposal.state for one in self.frames if one.proposal is not None)


def propose_for_set(
    run: ProposalRun, out: Path, progress: Progress[Proposed], *, packed: Path | None = None
) -> ProposedSet:
    """Look at all pictures of a set, once more at those without a sure camera where the others
    agree where it stands, and write cameras and table.

    Every file appears in one step, whole; the sure ones of the first look as they come, and the
    table at last.

    Args:
        out: folder; made if needed.
        packed: folder above, in which the cameras go to ``OUT.npz`` and ``unsure/OUT.npz``, at the
            end; None for a file a frame.

    Raises:
        SaveError: writing failed.
        Interrupted: in place of a KeyboardInterrupt; the sure cameras so far stay.
    """
    found: dict[str, Proposed] = {}
    positions: tuple[KnownPosition, ...] = ()
    written: set[str] = set()
    make_folder(out)

    def keep(one: Proposed) -> None:
        found[one.name] = one
        if one.is_sure and packed is None:
            written.add(_write_camera(one, out))

    try:
        for one in progress(run, run.total, "proposing"):
            keep(one)
        again = second_pass(run, list(found.values()))
        if again is not None:
            positions = again.positions
            for one in progress(again.run, again.run.total, "proposing, positions known"):
                keep(again.better(one))
    except KeyboardInterrupt:
        raise Interrupted(len(written), run.total) from None
    frames = [found[name] for name in run.names]
    if packed is not None:
        _write_packed(frames, out, sure=True)
        _write_packed(frames, packed / UNSURE_FOLDER / out.relative_to(packed), sure=False)
    for one in frames if packed is None else ():
        if not one.is_sure and one.proposal is not None and one.proposal.fit.camera is not None:
            written.add(_write_camera(one, out))
    _remove_older(out, run.names, written)
    rows = (_row(one, "" if packed is not None else _file_of(one)) for one in frames)
    table = MetricTable("proposals", "", _COLUMNS, tuple(rows))
    write_atomic(out / TABLE_FILE, csv_bytes(table))
    return ProposedSet(frames, positions)


def _file_of(one: Proposed) -> str:
    """Return where the camera of a frame goes, within OUT; empty without one."""
    if one.proposal is None or one.proposal.fit.camera is None:
        return ""
    name = camera_name(one.name)
    return name if one.is_sure else f"{UNSURE_FOLDER}/{name}"


def _write_camera(one: Proposed, out: Path) -> str:
    assert one.proposal is not None
    _, data = camera_file(one.name, one.proposal.fit)
    path = out / _file_of(one)
    make_folder(path.parent)
    write_atomic(path, data)
    return _file_of(one)


def _write_packed(frames: Sequence[Proposed], out: Path, *, sure: bool) -> None:
    """Write the cameras that are sure, or those that are not; a shot is not known."""
    own = ((one.name, one.proposal) for one in frames if one.is_sure == sure)
    found = [(name, p) for name, p in own if p is not None and p.fit.camera is not None]
    tracked = [
        TrackedFrame(n, "lost", "", p.fit, p.coverage, p.residual_px, None, "", None, p.probability)
        for n, (_, p) in enumerate(found)
    ]
    names = tuple(name for name, _ in found)
    cameras = pack(tracked, names, names, np.full(len(names), np.nan))
    states, reasons = (tuple(getattr(p, n) for _, p in found) for n in ("state", "reason"))
    cameras = replace(cameras, state=states, reason=reasons)
    make_folder(out.parent)
    write_atomic(out.with_name(out.name + PACKED_SUFFIX), cameras.encoded())


def _remove_older(out: Path, names: Iterable[str], written: set[str]) -> None:
    """Remove cameras of these frames from before: one that was sure then may be unsure now."""
    for name in names:
        own = camera_name(name)
        for file in (own, f"{UNSURE_FOLDER}/{own}"):
            if file not in written and (out / file).exists():
                remove(out / file)


def _row(one: Proposed, file: str) -> Row:
    said = one.proposal
    if said is None:
        return (one.name, "unreadable", one.error, *[None] * (len(_COLUMNS) - 3))
    residual = None if said.residual_px is None else round(said.residual_px, 3)
    shares = (said.probability, said.coverage, said.explained)
    agreement = (*(round(share, 4) for share in shares), residual)
    return (
        one.name, said.state, said.reason, *agreement, round(said.margin, 4),
        *deviation_values(said.fit.deviations), round(one.seconds, 3), *said.fit.size,
        file, one.from_agreement,
    )  # fmt: skip


def states_table(found: ProposedSet) -> MetricTable:
    """Return how many frames are in each state, and how they are, median."""
    looked_at = len(found.frames) - len(found.errors)
    shown = (
        metrics.PROBABILITY,
        metrics.COVERAGE,
        metrics.EXPLAINED,
        metrics.RESIDUAL,
        metrics.MARGIN,
    )
    rows = []
    for state in PROPOSAL_STATES:
        own = [one for one in found.frames if one.proposal and one.proposal.state == state]
        said = [metric_values(shown, one.proposal) for one in own]
        medians = (_median([values[i] for values in said]) for i in range(len(shown)))
        rows.append((state, len(own), *medians, _median([one.seconds for one in own])))
    columns = (
        Column("state"),
        count_column("frames"),
        *map(metric_column, shown),
        metric_column(metrics.SECONDS),
    )
    title = f"Proposals for {pluralize(looked_at, 'frame')}"
    return MetricTable("proposals", title, columns, tuple(rows))


def _median(values: Sequence[float | None]) -> float | None:
    known = [value for value in values if value is not None]
    return float(np.median(known)) if known else None


def doubtful_table(found: ProposedSet) -> MetricTable:
    """The frames without a sure camera and why, the first ones of many."""
    doubtful = [(one.name, p.state, p.reason) for one in found.frames
                if (p := one.proposal) is not None and not one.is_sure]  # fmt: skip
    columns = (Column("frame", "frame"), Column("state", "state"), Column("reason", "why"))
    title = f"{pluralize(len(doubtful), 'frame')} not sure"
    table = MetricTable("doubtful", title, columns, tuple(doubtful))
    return shortened(table, _SHOWN, f"in {TABLE_FILE}")


def proposed_words(found: ProposedSet) -> str:
    """``112 sure, 9 unsure, 5 none``."""
    states = found.states
    return ", ".join(f"{states[state]} {state}" for state in (SURE, UNSURE, NONE))


def positions_words(found: ProposedSet) -> str:
    """Return where frames agree that cameras stand, and what came of it; empty where they do
    not."""
    if not found.positions:
        return ""
    places = "; ".join(
        ", ".join(f"{value:.1f}" for value in known.position_m) + " m" for known in found.positions
    )
    gained = sum(one.from_agreement for one in found.frames)
    positions = pluralize(len(found.positions), "position")
    became = pluralize(gained, "more frame is", "more frames are")
    return f"frames agree on {positions} ({places}); with that {became} sure"
