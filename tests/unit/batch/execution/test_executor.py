"""Work shared in this process and among local ones; lost workers, errors, interrupts."""

import contextlib
import itertools
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path

import pytest

from procc_annotator.batch.execution import executor as executors
from procc_annotator.batch.execution.executor import InProcess, Work, make_executor
from procc_annotator.batch.execution.process_pool import MAX_CACHED_TASKS, ProcessPool
from procc_annotator.errors import CameraError, ProccError, UsageError

HERE = Path(__file__).parent


@pytest.fixture(scope="module")
def pool() -> Iterator[ProcessPool]:
    with make_executor(2) as made:
        assert isinstance(made, ProcessPool)
        yield made


@pytest.fixture
def marks(tmp_path) -> Path:
    folder = tmp_path / "marks"
    folder.mkdir()
    return folder


def test_how_many_processes_suit_the_work(monkeypatch):
    monkeypatch.setattr(executors, "usable_cpus", lambda: 3)
    with make_executor(frames=1999) as few:
        assert isinstance(few, InProcess)
    with make_executor(frames=2000) as many:
        assert isinstance(many, ProcessPool)
        assert many.workers == 3
    with make_executor(frames=50, worth_from=20) as heavy:
        assert isinstance(heavy, ProcessPool)
    with make_executor(1, frames=10**6) as told:
        assert isinstance(told, InProcess)


def test_results_come_in_the_order_of_the_chunks(tasks, pool):
    results = list(pool.map(Work(tasks.with_pid, range(40))))
    assert [chunk for chunk, _ in results] == list(range(40))
    assert os.getpid() not in {pid for _, pid in results}
    here = InProcess().map(Work(tasks.with_pid, range(40)))
    assert [chunk for chunk, _ in here] == list(range(40))


@pytest.mark.parametrize("make", [InProcess, None], ids=["in process", "pool"])
def test_chunks_are_taken_as_results_are(tasks, pool, make):
    taken = []

    def endless() -> Iterator[int]:
        for i in itertools.count():
            taken.append(i)
            yield i

    results = (make() if make else pool).map(Work(tasks.with_pid, endless()))
    assert [next(results)[0] for _ in range(3)] == [0, 1, 2]
    assert len(taken) <= 3 + 4
    close = getattr(results, "close", None)
    if close:
        close()


def test_errors_travel_whole_and_the_pool_goes_on(tasks, pool):
    results = pool.map(Work(tasks.Failing(2), range(9)))
    assert [next(results), next(results)] == [0, 1]
    with pytest.raises(CameraError) as caught:
        next(results)
    assert str(caught.value) == "a.json: line 3: is damaged (mend it)"
    assert (caught.value.place, caught.value.advice) == ("line 3", "mend it")
    assert list(pool.map(Work(tasks.Failing(-1), range(3)))) == [0, 1, 2]


def test_a_worker_keeps_its_copy_of_the_task_and_closes_it(tasks, tmp_path):
    with ProcessPool(1) as one:
        ((pid, _), *_, (_, calls)) = one.map(Work(tasks.Counting(tmp_path), range(20)))
        assert calls == 20
        list(one.map(Work(tasks.with_pid, range(2))))
        assert list(tmp_path.iterdir()) == []
        for _ in range(MAX_CACHED_TASKS):
            list(one.map(Work(tasks.with_pid, range(2))))
    assert [path.name.partition("-")[0] for path in tmp_path.iterdir()] == [str(pid)]


def test_files_that_changed_between_two_calls_are_opened_anew(tasks, pool, tmp_path):
    task = tasks.Counting(tmp_path)
    first = [calls for _, calls in pool.map(Work(task, range(1)))]
    assert first == [calls for _, calls in pool.map(Work(task, range(1)))] == [1]


@pytest.mark.parametrize("at", [0, 5, 11])
def test_a_lost_workers_chunk_is_done_again(tasks, pool, marks, at):
    task = tasks.Killer(tasks.with_pid, at, marks)
    assert [chunk for chunk, _ in pool.map(Work(task, range(12)))] == list(range(12))
    assert len(list(marks.iterdir())) == 1


def test_a_worker_killed_from_outside_is_replaced(tasks, pool, tmp_path):
    gate = tmp_path / "gate"
    results = pool.map(Work(tasks.Waiting(gate), range(9)))
    first, pid = next(results)
    os.kill(pid, signal.SIGKILL)
    gate.touch()
    rest = list(results)
    assert [first, *(chunk for chunk, _ in rest)] == list(range(9))
    assert pid not in {pid for _, pid in rest}


def test_a_pool_that_breaks_while_it_starts_a_process_loses_nothing(tasks, pool, monkeypatch):
    submit = ProcessPoolExecutor.submit
    errors = [OSError("handle is closed"), BrokenProcessPool("a process was ended")]

    def breaking(self, *arguments):
        if errors:
            raise errors.pop(0)
        return submit(self, *arguments)

    monkeypatch.setattr(ProcessPoolExecutor, "submit", breaking)
    assert [chunk for chunk, _ in pool.map(Work(tasks.with_pid, range(9)))] == list(range(9))
    assert not errors


def test_three_losses_are_survived_and_blamed_on_nobody_else(tasks, pool, marks):
    task = tasks.Killer(tasks.with_pid, 4, marks, times=3)
    assert [chunk for chunk, _ in pool.map(Work(task, range(9)))] == list(range(9))


def test_a_chunk_that_kills_every_worker_is_named(tasks, pool, marks):
    task = tasks.Killer(tasks.with_pid, 4, marks, times=99)
    results = pool.map(Work(task, range(9), name="frames {}".format))
    done = []
    with pytest.raises(ProccError, match=r"^frames 4: the worker process was ended from outside"):
        done += [chunk for chunk, _ in iter(results.__next__, None)]
    assert len(list(marks.iterdir())) <= 4
    assert [chunk for chunk, _ in pool.map(Work(tasks.with_pid, range(3)))] == [0, 1, 2]


def test_without_order_a_long_chunk_holds_nothing_up(tasks, pool, tmp_path):
    gate = tmp_path / "gate"
    results = pool.map(Work(tasks.Waiting(gate), [1, 0, 0, 0, 0, 0], ordered=False))
    assert [next(results)[0] for _ in range(5)] == [0] * 5
    gate.touch()
    assert [chunk for chunk, _ in results] == [1]


def test_a_chunk_that_kills_every_worker_may_have_a_result(tasks, pool, marks):
    task = tasks.Killer(tasks.with_pid, 4, marks, times=99)
    results = dict(
        pool.map(Work(task, range(9), ordered=False, lost=lambda chunk, error: (chunk, error)))
    )
    assert sorted(results) == list(range(9))
    assert "ended from outside" in str(results[4])


@pytest.mark.parametrize("make", [InProcess, None], ids=["in process", "pool"])
def test_chunks_that_depend_on_results_come_later(tasks, pool, make):
    done: list[int] = []

    def chunks() -> Iterator[int | None]:
        yield from (0, 1)
        while len(done) < 2:
            yield None
        yield 2

    for chunk, _ in (make() if make else pool).map(Work(tasks.with_pid, chunks(), ordered=False)):
        done.append(chunk)
    assert sorted(done) == [0, 1, 2]


def test_workers_and_a_cluster_exclude_each_other():
    with pytest.raises(UsageError, match="--dask"), make_executor(2, "tcp://127.0.0.1:1"):
        pass


WHEN = ("starting", "working", "busy")
PROGRAM = """
import faulthandler, itertools, signal, sys
faulthandler.register(signal.SIGUSR1)  # asked where it is, it says so
signal.signal(signal.SIGINT, signal.default_int_handler)  # whoever runs the tests may ignore it
from procc_annotator.batch.execution.executor import Work, make_executor
from executor_tasks import with_pid, without_end
if __name__ == "__main__":
    try:
        with make_executor(2) as executor:
            if sys.argv[1] == "starting":
                print("now", flush=True)
            task = without_end if sys.argv[1] == "busy" else with_pid
            for chunk, pid in executor.map(Work(task, itertools.count())):
                if (sys.argv[1], chunk) in {("working", 50), ("busy", 0)}:
                    print("now", flush=True)
    except KeyboardInterrupt:
        sys.exit(130)
"""


IGNORING = ("sh", "-c", "trap '' INT; exec \"$@\"", "sh")  # as a script does that uses `&`


@pytest.mark.skipif(not hasattr(os, "killpg"), reason="needs process groups")
@pytest.mark.parametrize(
    ("when", "how", "parent"),
    [
        *(pytest.param(w, signal.SIGINT, (), id=f"ctrl-c-{w}") for w in WHEN),
        pytest.param("working", signal.SIGINT, IGNORING, id="ctrl-c-below a deaf one"),
        pytest.param("working", signal.SIGKILL, (), id="killed-working"),
        pytest.param("starting", signal.SIGKILL, (), id="killed-starting", marks=pytest.mark.soak),
        pytest.param("busy", signal.SIGKILL, (), id="killed-busy", marks=pytest.mark.soak),
    ],
)
def test_an_interrupt_ends_all_processes_without_a_word(tmp_path, when, how, parent):
    """Ctrl+C goes to all processes of a terminal; being killed, to the main one only."""
    program = tmp_path / "program.py"
    program.write_text(PROGRAM)
    paths = os.pathsep.join([str(HERE), os.environ.get("PYTHONPATH", "")])
    running = subprocess.Popen(
        [*parent, sys.executable, program, when],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, start_new_session=True,
        env={**os.environ, "PYTHONPATH": paths},
    )  # fmt: skip
    with running:
        assert running.stdout.readline() == "now\n"
        if how == signal.SIGINT:
            os.killpg(running.pid, how)
        else:
            running.kill()
        # Ends when the last process has closed it: nobody lives on.
        try:
            _, said = running.communicate(timeout=30)
        except subprocess.TimeoutExpired:
            pytest.fail(f"alive after 30 s:\n{_where_it_hangs(running)}")
    if how == signal.SIGINT:
        assert (running.returncode, said) == (130, "")
    assert "Traceback" not in said
    until = time.monotonic() + 60
    while _any_alive(running.pid):
        assert time.monotonic() < until, _processes()
        time.sleep(0.02)


def _where_it_hangs(running: subprocess.Popen[str]) -> str:
    """What a program that does not end is doing, and who is alive; it is ended."""
    alive = _processes()
    running.send_signal(signal.SIGUSR1)
    with contextlib.suppress(subprocess.TimeoutExpired):
        running.communicate(timeout=2)  # keeps what it says
    os.killpg(running.pid, signal.SIGKILL)
    return f"{running.communicate()[1]}\n{alive}"


def _processes() -> str:
    return subprocess.run(["ps", "-ef"], capture_output=True, text=True, check=False).stdout


def _any_alive(group: int) -> bool:
    try:
        os.killpg(group, 0)
    except ProcessLookupError:
        return False
    return True
