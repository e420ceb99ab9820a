"""What a season costs beyond its frames: ``pytest tests/bench/test_bench_season.py --benchmark-only
-s``."""

import multiprocessing
import resource
import time
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

from procc_annotator.batch.execution.executor import make_executor
from procc_annotator.batch.match_tracking import MatchToTrack, TrackedMatch, track_match
from procc_annotator.batch.season_run import Attempt, Plan, SeasonRun
from procc_annotator.batch.tracking import TRACK, CutUnit, TrackingUnit
from procc_annotator.batch.unit_store import DONE, UnitStore
from procc_annotator.dataset.season import list_matches
from procc_annotator.field.load import load_field
from procc_annotator.field.model import PixelAspect
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.cameras.packed import PARAMETERS, PackedCameras

UNITS_A_MATCH = 260  # of 100 minutes
MATCHES = 38  # a tenth of a season
MATCH_FRAMES = 150_000
SHOT_FRAMES = 500  # 20 s
WORK_S = 0.2  # of a unit of the overhead: a hundredth of a real one


@dataclass(frozen=True)
class MadeUnit:
    match: str
    number: int
    kind: str = "track"
    frames: int = 1500

    @property
    def key(self) -> str:
        return f"{self.match}/{self.number:04d}"


def nothing(unit: MadeUnit) -> list[int]:
    return [unit.number]


def work(unit: MadeUnit) -> float:
    """Computes for a while, and says how long by the clock of its processor."""
    began, values = time.process_time(), np.arange(1e4)
    while time.process_time() - began < WORK_S:
        np.sort(values)
    return time.process_time() - began


def plan(match: str, count: int) -> Plan[int]:
    results = yield [MadeUnit(match, i) for i in range(count)]
    return len(results)


@pytest.mark.parametrize("workers", [1, 2])
def test_a_hundred_thousand_units(benchmark, tmp_path, workers):
    matches = {f"m{i:03d}": "" for i in range(100_000 // UNITS_A_MATCH)}
    steps: list[float] = []

    def run() -> float:
        began, last = time.process_time(), time.perf_counter()

        def attempted(_: Attempt) -> None:
            nonlocal last
            now = time.perf_counter()
            steps.append(now - last)
            last = now

        with (
            UnitStore(tmp_path / "track.sqlite", {}, resume=False) as store,
            make_executor(workers) as executor,
        ):
            season = SeasonRun[int](nothing, store, executor, on_attempt=attempted)
            done = season.run(matches, lambda name: plan(name, UNITS_A_MATCH))
            assert len(list(done)) == len(matches)
            began_listing = time.perf_counter()
            assert len(store.matches()) == len(matches)
            print(f"\nstatus lists {len(matches)} matches in {_since(began_listing):.2f} s")
        return time.process_time() - began

    seconds = benchmark.pedantic(run, rounds=1)
    megabytes = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(
        f"{workers} workers: {1000 * seconds / len(steps):.2f} ms of CPU a unit, longest step"
        f" {max(steps):.2f} s, {megabytes:.0f} MB"
    )


def _since(began: float) -> float:
    return time.perf_counter() - began


def test_overhead_of_two_processes(benchmark, tmp_path):
    """Processor time of the process that hands work out and keeps it, beside that of the work."""

    def run() -> float:
        with UnitStore(tmp_path / "s.sqlite", {}, resume=False) as store, make_executor(2) as pool:
            season = SeasonRun[int](work, store, pool)
            began = time.process_time()
            list(season.run({"a": "", "b": ""}, lambda name: plan(name, 50)))
            own = time.process_time() - began
            done = sum(store.result(MadeUnit(name, i).key) for name in "ab" for i in range(50))
        assert not multiprocessing.active_children()
        return own / done

    print(f"\noverhead {benchmark.pedantic(run, rounds=1):.2%} of units of {WORK_S} s")


@dataclass(frozen=True, eq=False)
class Repeated:
    """Takes the cameras of one minute for those of every piece of every match."""

    minute: PackedCameras

    def __call__(self, unit: TrackingUnit) -> list[int] | PackedCameras:
        if isinstance(unit, CutUnit):
            return [number for number in unit.numbers if number and number % SHOT_FRAMES == 0]
        names = tuple(f"m_{i:06d}" for i in unit.numbers)
        rows = self.minute.rows(range(len(names)))
        return replace(rows, frame=names, shot=(names[0],) * len(names))


@pytest.mark.parametrize("workers", [1, 2])
def test_a_season_of_repeated_results(benchmark, tmp_path, workers):
    """A tenth of a season, 38 matches of 100 minutes: all that is done but following cameras."""
    field, names = load_field("soccer"), tuple(f"m_{i:06d}" for i in range(MATCH_FRAMES))
    task = Repeated(made_cameras(1500))
    megabytes: list[float] = []

    def begin(match: str) -> Plan[TrackedMatch]:
        pixels = PixelAspect(1.0, 1.0)
        known = MatchToTrack(match, tmp_path, "", replace(field, pixels=pixels), "", names)
        return track_match(known)

    def run() -> float:
        began = time.process_time()
        with (
            UnitStore(tmp_path / "track.sqlite", {}, resume=False) as store,
            make_executor(workers) as executor,
        ):
            season = SeasonRun[TrackedMatch](task, store, executor)
            for name, found in season.run({f"m{i:02d}": "" for i in range(MATCHES)}, begin):
                (tmp_path / "match.npz").write_bytes(found.cameras.encoded())
                store.announce(name, DONE)
                store.forget(name, TRACK)
                assert len(found.cameras) == MATCH_FRAMES
                megabytes.append(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024)
        return time.process_time() - began

    seconds = benchmark.pedantic(run, rounds=1)
    print(
        f"\n{workers} workers: {seconds / MATCHES:.1f} s of CPU a match, {megabytes[3]:.0f} MB"
        f" after 4 matches, {megabytes[-1]:.0f} MB after all"
    )


@pytest.fixture(scope="module")
def season(tmp_path_factory) -> Path:
    """380 files of matches, of which one is 100 minutes long."""
    root = tmp_path_factory.mktemp("season")
    for i in range(380):
        (root / f"{i:03d}.mp4").write_bytes(b"")
    (root / "match.npz").write_bytes(made_cameras(MATCH_FRAMES).encoded())
    return root


def made_cameras(count: int) -> PackedCameras:
    """Cameras that pan slowly, with noise in all they keep."""
    names = tuple(f"m_{i:06d}" for i in range(count))
    rng = np.random.default_rng(0)
    bare = PackedCameras.without_cameras(names, names[0], "followed")
    cameras = np.zeros((count, len(PARAMETERS)))
    cameras[:, :8] = np.cumsum(rng.normal(0, 1e-3, (count, 8)), axis=0)
    columns = {**vars(bare), "camera": cameras, "covariance": rng.normal(0, 1e-4, (count, 36))}
    return PackedCameras(**columns)


def test_listing_and_opening(benchmark, season):
    def run() -> tuple[float, float]:
        began = time.perf_counter()
        assert len(list_matches(season) or ()) == 380
        listed = _since(began)
        with CameraCollection.open(season / "match.npz") as cameras:
            assert len(cameras.frames) == 150_000
        return listed, _since(began) - listed

    listed, opened = benchmark.pedantic(run, rounds=1)
    size = (season / "match.npz").stat().st_size / 1e6
    print(f"\n380 matches listed in {listed:.2f} s, 100 minutes ({size:.0f} MB) in {opened:.2f} s")
