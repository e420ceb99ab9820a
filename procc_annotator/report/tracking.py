"""Tables of tracked cameras and of the units of a run."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Sequence
from itertools import groupby

import numpy as np

from procc_annotator.batch.unit_store import DONE, FAILED, UnitStore
from procc_annotator.formats.cameras.packed import PackedCameras
from procc_annotator.messages import pluralize
from procc_annotator.report.tables.metrics import COVERAGE, RESIDUAL
from procc_annotator.report.tables.table import (
    Column,
    MetricTable,
    count_column,
    metric_column,
    shortened,
)

STATES = ("anchor", "followed", "bridged", "lost")
_SHOWN = 20


def shots_table(cameras: PackedCameras) -> MetricTable:
    """A row a shot: its frames by state, and how well the paint agrees, median."""
    columns = (
        Column("from", "from"),
        Column("to", "to"),
        count_column("frames"),
        *map(count_column, STATES),
        metric_column(COVERAGE),
        metric_column(RESIDUAL),
    )
    rows = []
    for _, own in groupby(range(len(cameras)), key=cameras.shot.__getitem__):
        frames = list(own)
        states = Counter(cameras.state[i] for i in frames)
        known = [i for i in frames if cameras.has_camera[i]]
        medians = (_median(values[known]) for values in (cameras.coverage, cameras.residual_px))
        counts = (len(frames), *(states[state] for state in STATES))
        rows.append((cameras.frame[frames[0]], cameras.frame[frames[-1]], *counts, *medians))
    title = f"{pluralize(len(cameras), 'frame')} in {pluralize(len(rows), 'shot')}"
    return shortened(MetricTable("shots", title, columns, tuple(rows)), _SHOWN)


def _median(values: np.ndarray) -> float | None:
    known = values[np.isfinite(values)]
    return float(np.median(known)) if len(known) else None


def gaps_table(cameras: PackedCameras) -> MetricTable:
    """Stretches of frames that have no camera, or one propagated from others."""
    columns = (
        Column("from", "from"), Column("to", "to"), count_column("frames"), Column("state"),
        Column("why", "why"),
    )  # fmt: skip
    found = []
    for (state, _), own in groupby(
        range(len(cameras)), key=lambda i: (cameras.state[i], cameras.shot[i])
    ):
        frames: Sequence[int] = list(own)
        if state not in ("anchor", "followed"):
            first, last = frames[0], frames[-1]
            ends = cameras.frame[first], cameras.frame[last]
            found.append((*ends, len(frames), state, cameras.reason[first]))
    return shortened(
        MetricTable("gaps", pluralize(len(found), "gap"), columns, tuple(found)), _SHOWN
    )


def tracked_words(cameras: PackedCameras) -> str:
    """``430 of 436 frames have a camera (2 anchors, 420 followed, 8 bridged), 6 are lost``."""
    states = Counter(cameras.state)
    have = sum(states[state] for state in STATES[:3])
    return (
        f"{have} of {pluralize(len(cameras), 'frame')} have a camera"
        f" ({pluralize(states['anchor'], 'anchor')}, {states['followed']} followed,"
        f" {states['bridged']} bridged), {states.total() - have} lost"
    )


def season_table(store: UnitStore) -> MetricTable:
    """A row a match: units by state, frames followed, speed, evidence, and when it changed last."""
    columns = (
        Column("match", "match"),
        *map(count_column, ("done", "waiting", "failed", "frames")),
        Column("frames_per_cpu_s", "frames/s", "number", written=".1f"),
        metric_column(COVERAGE),
        Column("changed", "changed"),
    )
    rows = []
    for match, own in groupby(store.matches(), key=lambda row: row.match):
        states = {row.state: row for row in own}
        counts = (states[s].units if s in states else 0 for s in (DONE, "waiting", FAILED))
        done = states.get(DONE)
        frames, seconds = (done.frames, done.seconds) if done else (0, 0.0)
        changed = max(row.changed for row in states.values())
        rows.append((
            match, *counts, frames, frames / seconds if seconds else None,
            done.evidence if done else None,
            time.strftime("%Y-%m-%d %H:%M", time.localtime(changed)),
        ))  # fmt: skip
    title = f"{pluralize(len(rows), 'match', 'matches')}"
    return MetricTable("season", title, columns, tuple(rows))
