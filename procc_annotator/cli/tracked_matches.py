"""The matches that ``track`` follows: what is known of them beforehand, and what is written."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable, Container, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from procc_annotator.assist.track_anchors import TrackAnchors
from procc_annotator.batch.match_tracking import (
    MatchToTrack,
    TrackedMatch,
    find_positions,
    track_match,
)
from procc_annotator.batch.season_run import Attempt, Plan
from procc_annotator.batch.tracking import TRACK, UNREADABLE, TrackUnit
from procc_annotator.batch.unit_store import (
    DONE,
    FAILED,
    SOURCE,
    Unit,
    UnitStore,
    field_settings,
    hex_digest,
)
from procc_annotator.calibration.single_image.proposal import KnownPosition
from procc_annotator.calibration.tracking.track import TrackedFrame
from procc_annotator.cli import options, remarks
from procc_annotator.cli.console import stdout_console
from procc_annotator.cli.echo import echo
from procc_annotator.cli.matches import annotations_of_match, place_of_match
from procc_annotator.dataset import remote_files
from procc_annotator.dataset.dataset_field import with_dataset_pixels
from procc_annotator.dataset.season import Match
from procc_annotator.dataset.sequence import PictureSource, open_pictures
from procc_annotator.errors import InputError, UsageError
from procc_annotator.field.model import Field
from procc_annotator.formats.atomic import make_folder, write_atomic
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.packed import PACKED_SUFFIX, PackedCameras, read_packed
from procc_annotator.formats.file_source import read_file
from procc_annotator.messages import pluralize
from procc_annotator.report.tracking import gaps_table, shots_table, tracked_words

Progress = Callable[[int, int], None]
_NUMBERS = re.compile(r"/0*([0-9]+)-0*([0-9]+)(?:/|$)")
_LOGGED = ("match", "kind", "state", "tries", "frames", "evidence", "error")


@dataclass(frozen=True)
class Anchors:
    """Where cameras that are known beforehand are found; those of a season in folders called like
    its matches."""

    annotations: Path | None
    cameras: Path | None
    camera_format: str
    camera_size: tuple[int, int] | None
    by_match: bool

    def annotations_of(self, match: Match) -> Path | None:
        """Return where those of a match are, if there are any."""
        return annotations_of_match(self.annotations, match) if self.by_match else self.annotations

    def of(
        self, match: Match, pictures: PictureSource, shown: Field, given: options.FieldOptions
    ) -> TrackAnchors:
        """The anchors of a match; remarks on them are printed."""
        found = TrackAnchors()
        annotations = self.annotations_of(match)
        cameras = place_of_match(self.cameras, match) if self.by_match else self.cameras
        if annotations is not None:
            clicked = pictures.annotated(annotations, shown, given.names(shown))
            remarks.report_remarks(clicked.notices)
            found.add_annotated(pictures.frames, clicked, shown)
        if cameras is not None:
            with CameraCollection.open(cameras, self.camera_format, field=shown) as collection:
                remarks.report_remarks(collection.notices)
                found.add_cameras(pictures.frames, collection, self.camera_size)
        remarks.report_remarks(found.remarks)
        given_places = (self.annotations, annotations), (self.cameras, cameras)
        for root in (root for root, own in given_places if root is not None and own is None):
            echo(f"note: nothing for the match {match.name} in {root}", err=True)
        places = [str(one) for one in (annotations, cameras) if one is not None]
        if places and not found.cameras:
            echo(f"note: no frame here has a camera in {' and '.join(places)}", err=True)
        return found


class TrackedMatches:
    """What is known of the matches of a run, and what was written.

    Attributes:
        fields: the elements, by the names of matches.
        problems: what was unreadable, one line each.
    """

    def __init__(
        self,
        matches: tuple[Match, ...],
        out: Path,
        given: options.PictureFieldOptions,
        anchors: Anchors,
        start: str | None,
    ) -> None:
        self.matches = {match.name: match for match in matches}
        self._out, self._given, self._anchors, self._start = out, given, anchors, start
        self.fields = {
            match.name: options.chosen_field(
                match.field or given.field,
                match.pictures,
                lines=given.lines,
                pixel_aspect=given.pixel_aspect,
            )
            for match in matches
        }
        self.problems: list[str] = []
        self._names: dict[str, tuple[str, ...]] = {}  # of the frames of matches under way
        self._known: dict[str, tuple[KnownPosition, ...]] = {}  # by stadium
        self._read: tuple[str, PackedCameras | None] | None = None
        self._frames = 0  # that were followed

    def path(self, name: str) -> Path:
        """The file of a match."""
        return self._out / f"{name}{PACKED_SUFFIX}"

    def begin(self, store: UnitStore, name: str) -> Plan[TrackedMatch]:
        """The plan of a match, of which the store notes how many frames it has."""
        match, shown = self.matches[name], self.fields[name]
        pictures = open_pictures(match.pictures, self._anchors.annotations_of(match))
        remarks.report_remarks(pictures.notices)
        self.problems += pictures.problems
        anchors = self._anchors.of(match, pictures, shown, self._given)
        self.problems += anchors.errors
        self._names[name] = names = tuple(frame.name for frame in pictures.frames)
        url = remote_files.url_of(match.pictures)
        place = match.pictures if url else pictures.path.absolute()
        pixels = shown.pixels or with_dataset_pixels(shown, pictures.path).pixels
        stamp = self._stamp(name, pictures)
        plan = track_match(
            MatchToTrack(
                name, place, stamp, replace(shown, pixels=pixels), name, names,
                anchors.cameras, anchors.clicks,
                self._known.get(match.stadium, ()) if match.stadium else (), pixels,
                only=None if self._start is None else _number_of(self._start, names),
            )
        )  # fmt: skip
        store.announce(name, frames=len(names))
        if store.has_other(name, stamp):
            echo(f"note: {name}: the pictures or the field changed: tracked anew", err=True)
            store.drop_other(name, stamp)
        return plan

    def _stamp(self, name: str, pictures: PictureSource) -> str:
        return hex_digest(pictures.stamp(), field_settings(self.fields[name]))[:16]

    def require_same(self, store: UnitStore) -> None:
        """Raise UsageError if the units of a match of this name are of other pictures."""
        for name, match in self.matches.items():
            with suppress(InputError):  # of pictures that cannot be opened: said when tracked
                there = match.pictures.exists() and open_pictures(match.pictures)
                if there and store.has_other(name, self._stamp(name, there)):
                    raise UsageError(
                        f"{self._out}: holds {name} of other pictures or another field, from"
                        f" {store.terms.get(SOURCE, 'another run')}; choose another place, or"
                        " --overwrite"
                    )

    def is_kept(self, match: Match) -> bool:
        """Return whether a match that is done is left alone: its pictures would have to be fetched
        from a URL, or were moved away."""
        away = remote_files.url_of(match.pictures) or not match.pictures.exists()
        there = self._written(match.name) if away else None
        self._know(match, there)
        return there is not None

    def _know(self, match: Match, cameras: PackedCameras | None) -> None:
        if match.stadium and cameras is not None:
            places = find_positions([cameras])
            self._known[match.stadium] = places or self._known.get(match.stadium, ())

    def recover(self, unit: Any) -> PackedCameras | None:
        """A piece that was followed before, from the file of its match."""
        if not isinstance(unit, TrackUnit) or (there := self._written(unit.match)) is None:
            return None
        names = self._names[unit.match][unit.numbers.start : unit.numbers.stop]
        if names[0] not in there.frame:
            return None
        first = there.frame.index(names[0])
        rows = there.rows(range(first, min(first + len(names), len(there))))
        return rows if rows.frame == names else None

    def _written(self, name: str) -> PackedCameras | None:
        """What the file of a match holds; of the match asked for last it is kept."""
        if self._read is None or self._read[0] != name:
            path, there = self.path(name), None
            try:
                there = read_packed(read_file(path), str(path)) if path.exists() else None
            except InputError as error:
                remarks.report_remarks([f"{error}; it is written anew"])
            self._read = name, there
        return self._read[1]

    def write(self, store: UnitStore, name: str, found: TrackedMatch) -> None:
        """Write what a match came to, with the shots that were followed before; the store keeps
        that."""
        cameras, before = found.cameras, self._written(name)
        if before is not None and len(cameras) < len(self._names[name]):
            cameras = cameras.merged(before, self._names[name])
        make_folder(self.path(name).parent)
        write_atomic(self.path(name), cameras.encoded())
        self._read = None
        self._know(self.matches[name], cameras)
        self.problems += [
            reason
            for state, reason in zip(cameras.state, cameras.reason, strict=True)
            if state == UNREADABLE
        ]
        _report(name, cameras, found.jumps, self.path(name), alone=len(self.matches) == 1)
        evidence, have = evidence_of(cameras)
        count = len(self._names.pop(name))
        store.announce(name, DONE, frames=count, cameras=have, evidence=evidence)
        store.forget(name, TRACK)

    def on_frame(self, progress: Progress) -> Callable[[TrackedFrame], None]:
        """Show the progress of frames as they are followed, in this process."""
        return lambda _: self._count(1, progress)

    def _count(self, frames: int, progress: Progress) -> None:
        self._frames, total = self._frames + frames, sum(map(len, self._names.values()))
        progress(min(self._frames, total), total)

    def attempted(
        self, progress: Progress, in_process: bool, log: str, attempt: Attempt, kept: Unit
    ) -> None:
        """Print what came of a unit that was tried."""
        unit = attempt.unit
        if not in_process and unit.kind == TRACK:
            self._count(unit.frames, progress)
        if log == "json":
            about = {name: getattr(kept, name) for name in _LOGGED}
            about |= {"time": kept.changed, "unit": kept.key, "seconds": attempt.seconds}
            echo(json.dumps(about), err=True)
        elif attempt.error or not sys.stderr.isatty():
            what = attempt.error or f"{unit.frames} frames in {attempt.seconds:.1f} s"
            echo(f"{unit_words(kept)}: {what}", err=True)


def unit_words(unit: Unit) -> str:
    """How a unit is called: its match, kind of work, and numbers of frames."""
    numbers = _NUMBERS.search(unit.key)
    frames = f" of frames {numbers[1]} to {int(numbers[2]) - 1}" if numbers else ""
    return f"{unit.match}: {unit.kind}{frames}"


def set_aside(store: UnitStore, matches: Container[str]) -> list[str]:
    """The units of some matches that were set aside, one line each."""
    failed = (unit for unit in store.units(FAILED) if unit.match in matches)
    return [f"{unit_words(unit)}: {unit.error}" for unit in failed]


def evidence_of(result: Any) -> tuple[float | None, int]:
    """Mean coverage of tracked frames, those without a camera as 0, and how many have one; None
    and 0 for any other result."""
    if not isinstance(result, PackedCameras):
        return None, 0
    return float(np.nan_to_num(result.coverage).mean()), int(result.has_camera.sum())


def _number_of(text: str, names: Sequence[str]) -> int:
    if text in names:
        return names.index(text)
    last = len(names) - 1
    if text.isascii() and text.isdigit() and int(text) <= last:
        return int(text)
    raise UsageError(
        f"--from {text}: there is no such frame (they are called {names[0]} to {names[-1]},"
        f" numbers 0 to {last})"
    )


_NAMED = 3


def _report(
    name: str, cameras: PackedCameras, jumps: Mapping[int, float], path: Path, *, alone: bool
) -> None:
    if alone:
        console = stdout_console()
        console.print(shots_table(cameras))
        if (gaps := gaps_table(cameras)).rows:
            console.print(gaps)
    unseen = [
        frame
        for frame, state, coverage in zip(
            cameras.frame, cameras.state, cameras.coverage.tolist(), strict=True
        )
        if state == "anchor" and not coverage
    ]
    if unseen:
        some = ", ".join(unseen[:_NAMED])
        what = pluralize(len(unseen), "anchor")
        echo(f"{name}: {what} without any line on paint: cameras of other pictures? {some}")
    if (aspect := float(cameras.pixel_aspect.max(initial=1.0))) != 1:
        echo(f"{name}: pixels are {aspect:.3f} times as wide as high")
    for number, px in jumps.items():
        echo(f"{name}: at frame {number} two pieces of a shot are {px:.1f} px apart", err=True)
    echo(f"{name}: {tracked_words(cameras)}; written to {path}")
