"""The same work on a real Dask cluster: a scheduler and worker processes on loopback."""

import importlib.util
import json
import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from operator import attrgetter
from pathlib import Path
from typing import Any

import pytest

from procc_annotator.batch.evaluation import run_evaluation
from procc_annotator.batch.execution import dask_cluster
from procc_annotator.batch.execution.executor import Executor, InProcess, Work, make_executor
from procc_annotator.batch.scoring import FrameResult
from procc_annotator.errors import CameraError, ProccError, UsageError
from procc_annotator.field.load import load_field
from procc_annotator.formats.cameras.collection import CameraCollection
from procc_annotator.formats.file_source import open_source
from procc_annotator.metrics.setup import EvaluationSetup

pytestmark = pytest.mark.skipif(
    importlib.util.find_spec("distributed") is None, reason="Dask is not installed"
)

HERE = Path(__file__).parent
PATIENCE_S = 60.0


@dataclass
class Cluster:
    """Processes of the Dask command line."""

    folder: Path
    files: ExitStack
    address: str = ""
    scheduler: subprocess.Popen[bytes] | None = None
    workers: list[subprocess.Popen[bytes]] = field(default_factory=list)

    def start(self) -> None:
        self.remove_workers()
        self.address, told = "", self.folder / "scheduler.json"
        told.unlink(missing_ok=True)
        self.scheduler = self._run(
            "scheduler", "--port", "0", "--no-dashboard", "--scheduler-file", str(told)
        )
        until = time.monotonic() + PATIENCE_S
        while not self.address:
            assert time.monotonic() < until, (self.folder / "log").read_text()
            time.sleep(0.05)
            if told.exists() and told.stat().st_size:
                self.address = json.loads(told.read_text())["address"]

    def add_workers(self, count: int) -> None:
        """So that there are so many that live."""
        self.workers = [worker for worker in self.workers if worker.poll() is None]
        for _ in range(count - len(self.workers)):
            self.workers.append(
                self._run(
                    "worker", self.address, "--nthreads", "1", "--no-nanny", "--no-dashboard",
                    "--local-directory", str(self.folder),
                )
            )  # fmt: skip

    def remove_workers(self) -> None:
        for worker in self.workers:
            worker.kill()
            worker.wait()
        self.workers.clear()

    def _run(self, kind: str, *arguments: str) -> subprocess.Popen[bytes]:
        paths = os.pathsep.join([str(HERE), os.environ.get("PYTHONPATH", os.getcwd())])
        with open(self.folder / "log", "ab") as log:
            process = subprocess.Popen(
                [sys.executable, "-m", f"distributed.cli.dask_{kind}", "--host", "127.0.0.1",
                 *arguments],
                stdout=log, stderr=log, cwd=self.folder, env={**os.environ, "PYTHONPATH": paths},
            )  # fmt: skip
        self.files.callback(process.wait)
        self.files.callback(process.kill)
        return process


@pytest.fixture(scope="module")
def one_cluster(tmp_path_factory) -> Iterator[Cluster]:
    with ExitStack() as files:
        yield Cluster(tmp_path_factory.mktemp("cluster"), files)


@pytest.fixture
def cluster(one_cluster) -> Cluster:
    """Its scheduler lives, whatever the test before has done."""
    if one_cluster.scheduler is None or one_cluster.scheduler.poll() is not None:
        one_cluster.start()
    return one_cluster


@pytest.fixture
def two_workers(cluster) -> Iterator[Executor]:
    """Of which a test may kill one."""
    cluster.add_workers(2)
    with make_executor(dask=cluster.address) as executor:
        executor._client.wait_for_workers(2, timeout=PATIENCE_S)
        yield executor


@pytest.fixture
def workers(cluster) -> Iterator[Executor]:
    """Whoever lives; starting another one takes long."""
    cluster.add_workers(1)
    with make_executor(dask=cluster.address) as executor:
        yield executor


@pytest.fixture
def marks(tmp_path) -> Path:
    folder = tmp_path / "marks"
    folder.mkdir()
    return folder


@dataclass
class Wrapped:
    """An executor whose tasks are wrapped."""

    executor: Executor
    wrap: Callable[[Any], Any]

    def map(self, work: Work[Any, Any]) -> Iterator[Any]:
        return self.executor.map(replace(work, task=self.wrap(work.task)))


def evaluate(set_: Path, executor: Executor) -> tuple[list[FrameResult], Any]:
    run = run_evaluation(
        open_source(set_ / "annotations"),
        CameraCollection.open(set_ / "cameras"),
        EvaluationSetup(load_field("soccer")),
        (5.0, 2.0),
        attrgetter("result"),
        executor=executor,
    )
    run.chunk = 4
    return list(run), run.summary()


@pytest.fixture
def set_(sample_data, tmp_path, monkeypatch) -> Path:
    """Sixty frames, some without a good camera, by a path relative to here and not to workers."""
    annotations = sorted(sample_data.glob("*.json"))
    cameras = sample_data / "cameras/bad"
    for folder in ("annotations", "cameras"):
        (tmp_path / "set" / folder).mkdir(parents=True)
    for i in range(60):
        source = annotations[i % len(annotations)]
        (tmp_path / "set/annotations" / f"{i}.json").write_bytes(source.read_bytes())
        camera = cameras / f"camera_{source.stem}.json"
        target = tmp_path / "set/cameras" / f"camera_{i}.json"
        if i == 17:
            target.write_text("[")
        elif camera.exists():
            target.write_bytes(camera.read_bytes())
    monkeypatch.chdir(tmp_path)
    return Path("set")


def same(a: tuple[list[FrameResult], Any], b: tuple[list[FrameResult], Any]) -> None:
    assert a[1] == b[1]
    assert len(a[0]) == len(b[0]) == 60
    for mine, theirs in zip(a[0], b[0], strict=True):
        for part in ("name", "camera", "error", "notices", "counted", "model"):
            assert getattr(mine, part) == getattr(theirs, part)
        assert mine.scores.keys() == theirs.scores.keys()
        for tau, score in mine.scores.items():
            other = theirs.scores[tau]
            assert (score.jac, score.mean_error) == (other.jac, other.mean_error)
            distances = score.labelling.all_distances.tobytes()
            assert distances == other.labelling.all_distances.tobytes()


def test_a_cluster_without_workers_is_said_so(cluster, monkeypatch):
    if cluster.workers:
        with make_executor(dask=cluster.address) as executor:
            cluster.remove_workers()
            until = time.monotonic() + PATIENCE_S
            while executor._client.nthreads():
                assert time.monotonic() < until
                time.sleep(0.05)
    monkeypatch.setattr(dask_cluster, "WORKERS_S", 0.2)
    with pytest.raises(ProccError, match="has no workers"), make_executor(dask=cluster.address):
        pass


def test_figures_are_the_same_with_a_worker_killed_midway(tasks, two_workers, set_, marks):
    alone = evaluate(set_, InProcess())
    assert any(r.error for r in alone[0])
    assert evaluate(set_, two_workers)[1] == alone[1]
    seen: list[Any] = []
    evaluate(set_, Wrapped(InProcess(), lambda task: _noting(task, seen)))
    killing = Wrapped(two_workers, lambda task: tasks.Killer(task, seen[7], marks))
    same(evaluate(set_, killing), alone)
    assert len(list(marks.iterdir())) == 1


def _noting(task: Any, seen: list[Any]) -> Callable[[Any], Any]:
    def noted(chunk: Any) -> Any:
        seen.append(chunk)
        return task(chunk)

    return noted


def test_local_processes_give_the_same_with_one_killed(tasks, set_, marks):
    seen: list[Any] = []
    alone = evaluate(set_, Wrapped(InProcess(), lambda task: _noting(task, seen)))
    with make_executor(2) as pool:
        killing = Wrapped(pool, lambda task: tasks.Killer(task, seen[7], marks))
        same(evaluate(set_, killing), alone)
    assert len(list(marks.iterdir())) == 1


def test_a_worker_killed_from_outside_loses_nothing(tasks, cluster, two_workers, tmp_path):
    gate = tmp_path / "gate"
    results = two_workers.map(Work(tasks.Waiting(gate), range(12)))
    first, pid = next(results)
    (victim,) = [worker for worker in cluster.workers if worker.pid == pid]
    victim.kill()
    victim.wait()
    gate.touch()
    rest = list(results)
    assert [first, *(chunk for chunk, _ in rest)] == list(range(12))
    assert {pid for _, pid in rest} == {w.pid for w in cluster.workers if w is not victim}


def test_errors_travel_and_what_is_queued_is_given_up(tasks, workers):
    results = workers.map(Work(tasks.Failing(1), range(9)))
    assert next(results) == 0
    with pytest.raises(CameraError, match=r"a\.json: line 3: is damaged \(mend it\)"):
        next(results)
    results = workers.map(Work(tasks.with_pid, range(100)))
    next(results)
    results.close()
    assert [chunk for chunk, _ in workers.map(Work(tasks.with_pid, range(3)))] == [0, 1, 2]


def test_a_look_at_the_workers_never_loses_a_result(tasks, workers, monkeypatch):
    from distributed import Future

    fetch = Future.result

    def fetch_what_is_there(future: Any, timeout: float | None = None) -> Any:
        assert future.done(), "a fetch that is given up spoils the next one"
        return fetch(future, timeout=timeout)

    monkeypatch.setattr(Future, "result", fetch_what_is_there)
    monkeypatch.setattr(dask_cluster, "_LOOK_S", 0.001)
    results = list(workers.map(Work(tasks.with_pid, range(60))))
    assert [chunk for chunk, _ in results] == list(range(60))
    with pytest.raises(CameraError, match="is damaged"):
        list(workers.map(Work(tasks.Failing(1), range(3))))
    with pytest.raises(TimeoutError, match="too slow"):
        list(workers.map(Work(tasks.too_slow, range(3))))


def test_a_set_that_workers_do_not_find_is_said_so(workers, set_, tmp_path):
    run = run_evaluation(
        open_source(set_ / "annotations"),
        CameraCollection.open(set_ / "cameras"),
        EvaluationSetup(load_field("soccer")),
        (5.0,),
        attrgetter("result"),
        executor=workers,
    )
    (tmp_path / "set/annotations").rename(tmp_path / "set/elsewhere")
    with pytest.raises(ProccError, match=r"set/annotations: .*under the same path"):
        list(run)


def test_another_version_on_a_worker_is_refused(tasks, workers, monkeypatch):
    monkeypatch.setattr(dask_cluster, "__version__", "99")
    with pytest.raises(ProccError, match=r"a Dask worker has procc-annotator .* this is 99"):
        list(workers.map(Work(tasks.with_pid, range(2))))


def test_a_scheduler_that_does_not_answer_is_one_line(monkeypatch):
    monkeypatch.setattr(dask_cluster, "ANSWER_S", 0.5)
    with (
        pytest.raises(ProccError, match=r"no Dask scheduler answers at tcp://127\.0\.0\.1:1 "),
        make_executor(dask="tcp://127.0.0.1:1"),
    ):
        pass


@pytest.mark.parametrize("address", ["nonsense", "", "gopher://host:1", "tcp://host"])
def test_what_is_no_address_is_one_line(address):
    with pytest.raises(UsageError, match="HOST:PORT"), make_executor(dask=address):
        pass


def test_a_worker_is_no_scheduler(cluster, workers):
    (address, *_) = workers._client.nthreads()
    with pytest.raises(UsageError, match="not a Dask scheduler"), make_executor(dask=address):
        pass


def test_without_the_library_the_extra_is_advised(monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with (
        pytest.raises(ProccError, match=r"pip install 'procc-annotator\[dask\]'"),
        make_executor(dask="tcp://127.0.0.1:8786"),
    ):
        pass


def test_a_scheduler_that_is_lost_midway_is_one_line(tasks, cluster, workers, tmp_path, capfd):
    gate = tmp_path / "gate"
    results = workers.map(Work(tasks.Waiting(gate), range(12)))
    next(results)
    cluster.scheduler.kill()
    cluster.scheduler.wait()
    with pytest.raises(ProccError, match=r"the connection to the Dask scheduler .* was lost"):
        list(results)
    gate.touch()
    assert capfd.readouterr().err == ""
