"""Tracked cameras as files, CSV and tables; positions found by a track."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, field
from itertools import groupby
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import numpy as np

from procc_annotator.batch.calibration import camera_file
from procc_annotator.batch.tracking import TrackedShot, TrackRun
from procc_annotator.calibration.single_image.proposal import KnownPosition
from procc_annotator.calibration.tracking.track import TrackedFrame
from procc_annotator.camera.models import PinholeCamera
from procc_annotator.dataset.frames import Frame
from procc_annotator.errors import InputError, SaveError
from procc_annotator.formats.atomic import make_folder, remove, write_atomic
from procc_annotator.formats.cameras.registry import read_camera_file
from procc_annotator.formats.csv_tables import csv_cells
from procc_annotator.formats.file_listing import camera_name
from procc_annotator.formats.file_source import read_file
from procc_annotator.messages import pluralize
from procc_annotator.report.calibration import DEVIATION_COLUMNS, deviation_values
from procc_annotator.report.outputs import Interrupted
from procc_annotator.report.tables.data_files import csv_bytes, value_of
from procc_annotator.report.tables.metrics import COVERAGE, RESIDUAL
from procc_annotator.report.tables.table import (
    Column,
    MetricTable,
    count_column,
    metric_column,
    shortened,
)

TABLE_FILE = "track.csv"
COLUMNS = (
    Column("frame"),
    Column("shot"),
    Column("state"),
    Column("reason"),
    metric_column(COVERAGE),
    metric_column(RESIDUAL),
    *DEVIATION_COLUMNS,
    count_column("anchor_distance"),
    count_column("width"),
    count_column("height"),
    Column("camera"),
)
_KEYS = tuple(column.key for column in COLUMNS)
STATES = ("anchor", "followed", "bridged", "lost")
_SHOWN = 20
_ADVICE = "move it away, or --overwrite to replace it"
_WRITERS = 4  # most of writing is waiting for the disk
_WAITING = 200  # files

Line = Mapping[str, Any]  # values of a row, by the keys of the columns
Progress = Callable[[int, int], None]


@dataclass
class TrackTable:
    """Table of the frames of a source: a row each, as in the file.

    Attributes:
        names: of all frames, in order.
        rows: of those that are done, by name.
        errors: why pictures cannot be used, one line each.
    """

    names: tuple[str, ...]
    rows: dict[str, Line] = field(default_factory=dict)
    errors: list[str] = field(default_factory=list)

    def has_all(self, frames: Iterable[Frame]) -> bool:
        """Return whether all of these are done."""
        return all(frame.name in self.rows for frame in frames)

    def lost(self, frames: Iterable[Frame]) -> set[str]:
        """The names of those that have no camera."""
        done = {frame.name: self.rows.get(frame.name) for frame in frames}
        return {name for name, row in done.items() if row is not None and row["state"] == "lost"}

    def forget(self, frames: Iterable[Frame]) -> None:
        """These are not done: they are to be followed again."""
        for frame in frames:
            self.rows.pop(frame.name, None)

    def in_order(self) -> list[Line]:
        """The rows in the order of the frames."""
        return [self.rows[name] for name in self.names if name in self.rows]

    def encoded(self) -> bytes:
        """As a CSV file."""
        rows = tuple(tuple(line[key] for key in _KEYS) for line in self.in_order())
        return csv_bytes(MetricTable("track", "", COLUMNS, rows))


def read_table(out: Path, names: tuple[str, ...]) -> TrackTable:
    """The table that an earlier run left in a folder.

    Raises:
        InputError: it is none of ours, or of other frames.
    """
    table = TrackTable(names)
    path = out / TABLE_FILE
    if not path.exists():
        return table
    lines = csv_cells(path)
    if not lines or tuple(lines[0][1]) != _KEYS:
        why = "is no table of a track"
        raise InputError(path, why, advice=_ADVICE)
    ours = set(names)
    for number, cells in lines[1:]:
        if len(cells) != len(COLUMNS):
            continue
        try:
            row = dict(zip(_KEYS, map(value_of, COLUMNS, cells), strict=True))
        except ValueError as error:
            raise InputError(path, str(error), place=f"line {number}", advice=_ADVICE) from error
        name = str(row["frame"])
        if name not in ours:
            why = f"is of other frames, such as {name}"
            raise InputError(path, why, advice="choose another place, or --overwrite to replace it")
        table.rows[name] = row
    return table


def write_tracks(run: TrackRun, out: Path, table: TrackTable, progress: Progress) -> None:
    """Follow all shots of a run and write what comes of it.

    The table is there before the first camera: without one, cameras are not those of a track.
    Cameras are written as frames are followed; those of a shot once more when it is done, refined
    over all of it, and only then its rows. So a table that was left by a run that was stopped says
    which shots need not be followed again; of those that are it says nothing any more before their
    first camera is replaced. Every file appears in one step, whole.

    Args:
        run: over the shots.
        out: folder; made if needed.
        table: filled; may hold shots that were done before.
        progress: called with frames done and their count.

    Raises:
        SaveError: writing failed.
        Interrupted: in place of a KeyboardInterrupt: so many frames of shots that are done.
    """
    make_folder(out)
    write_atomic(out / TABLE_FILE, table.encoded())
    names = table.names
    seen = 0

    def followed(one: TrackedFrame) -> None:
        nonlocal seen
        seen += 1
        progress(min(seen, run.frame_count), run.frame_count)
        writing.write(names[one.number], one)

    told = run.tell(followed)
    done = 0
    try:
        with _Writing(out) as writing:
            for shot in run:
                for one in shot.tracked:
                    writing.write(names[one.number], one)
                writing.finish()
                _add_rows(shot, table)
                write_atomic(out / TABLE_FILE, table.encoded())
                done += len(shot.frames)
                seen = max(seen, done) if told else done
                progress(seen, run.frame_count)
    except KeyboardInterrupt:
        raise Interrupted(done, run.frame_count) from None


class _Writing:
    """Writes cameras behind anyone who follows them; one of a frame after the other."""

    def __init__(self, out: Path) -> None:
        self._out = out
        self._pool = ThreadPoolExecutor(_WRITERS, thread_name_prefix="writing cameras")
        self._last: dict[str, Future[None]] = {}

    def write(self, name: str, one: TrackedFrame) -> None:
        """Write a frame's camera; without one remove that of an earlier run.

        Raises:
            SaveError: an earlier one could not be written.
        """
        before = self._last.pop(name, None)
        if len(self._last) >= _WAITING:
            self.finish()
        if before is not None:
            before.result()
        self._last[name] = self._pool.submit(self._write, name, one)

    def finish(self) -> None:
        """Wait until all is written.

        Raises:
            SaveError: something could not be.
        """
        waiting, self._last = self._last, {}
        for future in waiting.values():
            future.result()

    def _write(self, name: str, one: TrackedFrame) -> None:
        if one.fit is None or one.fit.camera is None:
            path = self._out / camera_name(name)
            try:
                if path.exists():
                    remove(path)
            except OSError as error:
                raise SaveError(f"{path}: could not be removed: {error.strerror}") from error
            return
        file_name, data = camera_file(name, one.fit, one.clicks or None)
        make_folder((self._out / file_name).parent)
        write_atomic(self._out / file_name, data)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._pool.shutdown(cancel_futures=kind is not None)


def _add_rows(shot: TrackedShot, table: TrackTable) -> None:
    begin = shot.frames[0].name
    for frame, one in zip(shot.frames, shot.tracked, strict=True):
        if one.number in shot.begins:
            begin = frame.name
        table.rows[frame.name] = _row(frame.name, begin, one)
    damaged = (shot.damaged or {}).values()
    table.errors += [error for error in damaged if error not in table.errors]


def _row(name: str, begin: str, one: TrackedFrame) -> Line:
    fit = one.fit
    has_camera = fit is not None and fit.camera is not None
    cells = (
        name, begin, one.state, one.reason, round(one.coverage, 4),
        None if one.residual_px is None else round(one.residual_px, 3),
        *deviation_values(fit.deviations if fit is not None else None), one.anchor_distance,
        *(fit.size if fit is not None else (None, None)),
        camera_name(name) if has_camera else None,
    )  # fmt: skip
    return dict(zip(_KEYS, cells, strict=True))


# --- what is said of it -------------------------------------------------------------------------


def shots_table(table: TrackTable) -> MetricTable:
    """A row a shot: its frames by state, and how well the paint agrees, median."""
    lines = table.in_order()
    shots = [list(own) for _, own in groupby(lines, key=lambda line: line["shot"])]
    columns = (
        Column("from", "from"),
        Column("to", "to"),
        count_column("frames"),
        *map(count_column, STATES),
        metric_column(COVERAGE),
        metric_column(RESIDUAL),
    )
    rows = []
    for own in shots:
        states = Counter(line["state"] for line in own)
        coverage = [line["coverage"] for line in own if line["state"] != "lost"]
        residuals = [line["residual_px"] for line in own if line["residual_px"] is not None]
        counts = (len(own), *(states[state] for state in STATES))
        medians = (float(np.median(v)) if v else None for v in (coverage, residuals))
        rows.append((own[0]["frame"], own[-1]["frame"], *counts, *medians))
    title = f"{pluralize(len(lines), 'frame')} in {pluralize(len(shots), 'shot')}"
    return shortened(MetricTable("shots", title, columns, tuple(rows)), _SHOWN)


def gaps_table(table: TrackTable) -> MetricTable:
    """Stretches of frames that have no camera, or one propagated from others."""
    columns = (
        Column("from", "from"), Column("to", "to"), count_column("frames"), Column("state"),
        Column("why", "why"),
    )  # fmt: skip
    found = []
    for (state, _), own in groupby(table.in_order(), key=lambda row: (row["state"], row["shot"])):
        if state in ("bridged", "lost"):
            rows: Sequence[Line] = list(own)
            ends = rows[0]["frame"], rows[-1]["frame"]
            found.append((*ends, len(rows), state, rows[0]["reason"] or ""))
    gaps = MetricTable("gaps", pluralize(len(found), "gap"), columns, tuple(found))
    return shortened(gaps, _SHOWN, f"in {TABLE_FILE}")


def tracked_words(table: TrackTable) -> str:
    """``430 of 436 frames have a camera (2 anchors, 420 followed, 8 bridged), 6 are lost``."""
    states = Counter(row["state"] for row in table.rows.values())
    anchors = pluralize(states["anchor"], "anchor")
    have = sum(states[state] for state in STATES[:3])
    return (
        f"{have} of {pluralize(len(table.rows), 'frame')} have a camera ({anchors},"
        f" {states['followed']} followed, {states['bridged']} bridged), {states['lost']} lost"
    )


# A shot whose camera's place counts: that many frames, their lines on paint, known so well.
_LEAST_FRAMES, _LEAST_COVERAGE, _MOST_SD_M = 10, 0.65, 1.0
_SAME_M, _WANDERS_M = 3.0, 0.5  # nearer ones are one place; farther apart in a shot it is none
_APART_M = 0.7  # shots of one match tell of a tripod to about a metre
_MOST = 4
_DEVIATIONS = ("sd_x_m", "sd_y_m", "sd_z_m")


def find_positions(out: Path, table: TrackTable) -> tuple[KnownPosition, ...]:
    """The places from which the shots of a track were filmed, that of most frames first.

    Args:
        out: its folder, with the cameras.
        table: what became of its frames.
    """
    shots = [list(own) for _, own in groupby(table.in_order(), key=lambda line: line["shot"])]
    found: list[KnownPosition] = []
    for shot in sorted(shots, key=len, reverse=True):
        place = _place_of(out, [line for line in shot if line["camera"]])
        if place is None:
            continue
        if all(np.linalg.norm(place.position_m - one.position_m) > _SAME_M for one in found):
            found.append(place)
    return tuple(found[:_MOST])


def _place_of(out: Path, lines: Sequence[Line]) -> KnownPosition | None:
    """Return where a shot was filmed from, if that is known and stays the same."""
    followed = [line for line in lines if line["state"] == "followed"]
    if len(followed) < _LEAST_FRAMES:
        return None
    middle = followed[len(followed) // 2]
    deviations = np.array([middle[key] for key in _DEVIATIONS], dtype=np.float64)
    coverage = float(np.median([line["coverage"] for line in followed]))
    if coverage < _LEAST_COVERAGE or not deviations.max() <= _MOST_SD_M:
        return None
    positions = [_position(out / line["camera"]) for line in (followed[0], middle, followed[-1])]
    seen = np.array([position for position in positions if position is not None])
    if len(seen) < len(positions) or np.ptp(seen, axis=0).max() > _WANDERS_M:
        return None
    return KnownPosition(seen[1], np.diag(deviations**2 + _APART_M**2))


def _position(path: Path) -> tuple[float, float, float] | None:
    """Return where the camera of a file stands, metres; None if another person has been there."""
    try:
        camera = read_camera_file(read_file(path), path=str(path)).camera
    except InputError:
        return None
    return camera.position_world if isinstance(camera, PinholeCamera) else None
