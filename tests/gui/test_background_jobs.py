"""Work in the background: its outcome arrives on the interface thread, nothing vanishes."""

import os
import sys
import threading
from collections.abc import Iterator
from types import TracebackType

import pytest
import shiboken6
from PySide6.QtCore import QObject

from procc_annotator.errors import UsageError
from procc_annotator.gui.state.background import (
    JobControl,
    LatestOnlyTask,
    Priority,
    hold,
    release,
    run_in_background,
)


class Heard:
    """What the callbacks were told, and in which thread."""

    def __init__(self) -> None:
        self.results: list[int] = []
        self.errors: list[str] = []
        self.progress: list[tuple[int, int]] = []
        self.threads: set[int] = set()

    def on_result(self, value: int) -> None:
        self.results.append(value)
        self.threads.add(threading.get_ident())

    def on_error(self, text: str) -> None:
        self.errors.append(text)
        self.threads.add(threading.get_ident())

    def on_progress(self, done: int, total: int) -> None:
        self.progress.append((done, total))
        self.threads.add(threading.get_ident())


def test_the_result_arrives_on_the_interface_thread(qtbot):
    heard = Heard()
    worked_in: list[int] = []

    def work(control: JobControl) -> int:
        worked_in.append(threading.get_ident())
        for i in range(1000):
            control.progress(i + 1, 1000)
        return 42

    job = run_in_background(
        work, on_result=heard.on_result, on_error=heard.on_error, on_progress=heard.on_progress
    )
    qtbot.waitUntil(lambda: heard.results == [42])
    assert heard.threads == {threading.get_ident()}
    assert worked_in != [threading.get_ident()]
    assert heard.progress[-1] == (1000, 1000)
    assert len(heard.progress) <= 1000
    assert not job.running


def test_an_expected_error_arrives_as_its_text(qtbot):
    heard = Heard()

    def work(control: JobControl) -> int:
        raise UsageError("no such folder")

    run_in_background(work, on_result=heard.on_result, on_error=heard.on_error)
    qtbot.waitUntil(lambda: bool(heard.errors))
    assert heard.errors == ["no such folder"]
    assert not heard.results


def test_a_bug_reaches_the_exception_hook_and_whoever_waits(qtbot, monkeypatch):
    heard = Heard()
    raised: list[BaseException] = []

    def hook(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        raised.append(error)

    def work(control: JobControl) -> int:
        raise ZeroDivisionError("a bug")

    monkeypatch.setattr(sys, "excepthook", hook)
    run_in_background(work, on_result=heard.on_result, on_error=heard.on_error)
    qtbot.waitUntil(lambda: bool(raised))
    assert isinstance(raised[0], ZeroDivisionError)
    assert heard.errors == ["unexpected error (ZeroDivisionError: a bug)"]
    assert not heard.results


def test_a_cancelled_job_is_asked_to_stop_and_says_nothing(qtbot):
    heard = Heard()
    stopped = threading.Event()
    started = threading.Event()

    def work(control: JobControl) -> int:
        started.set()
        while not control.cancelled:
            control.progress(0, 1)
        stopped.set()
        return 1

    job = run_in_background(work, on_result=heard.on_result, on_error=heard.on_error)
    assert started.wait(5)
    job.cancel()
    assert stopped.wait(5)
    run_in_background(lambda control: 2, on_result=heard.on_result, on_error=heard.on_error)
    qtbot.waitUntil(lambda: bool(heard.results))
    assert heard.results == [2]


def test_parts_come_before_the_outcome_in_their_order(qtbot):
    heard, owner, told = Heard(), QObject(), list[object]()
    latest = LatestOnlyTask(owner, heard.on_error)

    def work(control: JobControl) -> str:
        for part in range(100):
            control.emit_partial(part)
            control.progress(part, 100)
        return "outcome"

    latest.start(work, told.append, partial=told.extend)
    qtbot.waitUntil(lambda: not latest.running)
    assert told == [*range(100), "outcome"]
    assert latest.finish()


@pytest.mark.parametrize("kept", [True, False])
def test_what_was_handed_over_is_taken_by_cutting_short_not_by_cancelling(qtbot, kept):
    heard, owner, told = Heard(), QObject(), list[int]()
    latest = LatestOnlyTask(owner, heard.on_error)
    handed, ended = threading.Event(), threading.Event()

    def until_left(control: JobControl) -> int:
        control.emit_partial(1)
        handed.set()
        ended.wait(60)
        control.emit_partial(2)  # too late
        return 3

    latest.start(until_left, heard.on_result, partial=told.extend)
    assert handed.wait(60)
    assert latest.stop_keep_partial() if kept else latest.cancel()
    ended.set()
    latest.start(lambda control: 4, heard.on_result)
    qtbot.waitUntil(lambda: bool(heard.results))
    assert told == ([1] if kept else [])
    assert heard.results == [4]


def test_of_work_begun_one_after_another_only_the_latest_is_heard_of(qtbot):
    heard, owner = Heard(), QObject()
    latest = LatestOnlyTask(owner, heard.on_error)
    begun, left = threading.Event(), threading.Event()

    def until_left(control: JobControl) -> int:
        begun.set()
        while not control.cancelled:
            control.progress(0, 1)
        left.set()
        return 1

    latest.start(until_left, heard.on_result)
    assert latest.running
    assert begun.wait(5)
    latest.start(lambda control: 2, heard.on_result)
    qtbot.waitUntil(lambda: bool(heard.results))
    assert left.wait(5)
    assert heard.results == [2]
    assert not latest.running
    assert not latest.cancel()  # nothing is under way

    def fail(control: JobControl) -> int:
        raise UsageError("no")

    latest.start(fail, heard.on_result)
    qtbot.waitUntil(lambda: bool(heard.errors))
    assert heard.errors == ["no"]
    latest.start(fail, heard.on_result, failed=lambda text: heard.errors.append(f"{text}!"))
    qtbot.waitUntil(lambda: len(heard.errors) > 1)
    assert heard.errors == ["no", "no!"]


def test_nothing_is_delivered_to_an_owner_that_is_gone(qtbot):
    heard = Heard()
    owner = QObject()
    go_on = threading.Event()

    def work(control: JobControl) -> int:
        assert go_on.wait(5)
        return 1

    job = run_in_background(work, on_result=heard.on_result, on_error=heard.on_error, owner=owner)
    del owner
    go_on.set()
    qtbot.waitUntil(lambda: not job.running)
    assert heard.results == []


@pytest.fixture
def busy(qtbot) -> Iterator[threading.Event]:
    """Work on whole datasets holds every thread it may have, until this is set."""
    go_on = threading.Event()
    heard = Heard()
    started = [threading.Event() for _ in range(8)]

    def hold(begun: threading.Event) -> int:
        begun.set()
        assert go_on.wait(20)
        return 0

    jobs = [
        run_in_background(
            lambda _, begun=begun: hold(begun),
            on_result=heard.on_result,
            on_error=heard.on_error,
        )
        for begun in started
    ]
    qtbot.waitUntil(lambda: sum(begun.is_set() for begun in started) >= 2)
    yield go_on
    go_on.set()
    qtbot.waitUntil(lambda: not any(job.running for job in jobs))


def test_what_a_hand_waits_for_passes_work_on_the_whole_set(qtbot, busy):
    heard = Heard()
    run_in_background(
        lambda _: 1, on_result=heard.on_result, on_error=heard.on_error, priority=Priority.URGENT
    )
    qtbot.waitUntil(lambda: heard.results == [1])
    assert not busy.is_set()


@pytest.mark.parametrize("how", ["forgotten", "deleted with its parent"])
def test_work_whose_owner_is_gone_never_begins(qtbot, busy, how):
    heard = Heard()
    began: list[str] = []
    parent = QObject()
    owner = QObject() if how == "forgotten" else QObject(parent)

    def work(_: JobControl) -> int:
        began.append("owned")
        return 1

    job = run_in_background(work, on_result=heard.on_result, on_error=heard.on_error, owner=owner)
    if how == "forgotten":
        del owner
    else:
        shiboken6.delete(parent)
    run_in_background(lambda _: 2, on_result=heard.on_result, on_error=heard.on_error)
    busy.set()
    qtbot.waitUntil(lambda: heard.results == [2])
    assert began == []
    assert not job.running


@pytest.mark.skipif(sys.platform != "linux", reason="no other system lets one thread yield")
def test_work_on_whole_datasets_yields_to_the_interface(qtbot):
    found: dict[bool, int] = {}

    def note(urgent: bool) -> None:
        run_in_background(
            lambda _: os.getpriority(os.PRIO_PROCESS, 0),
            on_result=lambda niceness: found.update({urgent: niceness}),
            on_error=None,
            priority=Priority.URGENT if urgent else Priority.LOW,
        )

    note(True)
    note(False)
    qtbot.waitUntil(lambda: len(found) == 2)
    here = os.getpriority(os.PRIO_PROCESS, 0)
    assert found[True] == here
    assert found[False] > here or here == 19


def test_work_may_begin_later_and_is_never_begun_if_it_is_cancelled_before(qtbot):
    heard, begun = Heard(), []

    def work(control: JobControl) -> int:
        begun.append(control)
        return 1

    given = {"on_result": heard.on_result, "on_error": heard.on_error}
    dropped = run_in_background(work, **given, delay_ms=0)
    job = run_in_background(work, **given, delay_ms=0)
    asked_for = run_in_background(work, **given, delay_ms=60_000)
    assert not job.begun
    dropped.cancel()
    assert asked_for.finish()  # whoever waits for it does not wait for its time
    assert heard.results == [1]
    qtbot.waitUntil(lambda: len(heard.results) == 2)
    assert job.begun
    assert len(begun) == 2


def test_while_the_window_is_made_only_short_work_begins(qtbot):
    heard, begun = Heard(), []
    given = {"on_result": heard.on_result, "on_error": heard.on_error}

    def work(name: str) -> str:
        begun.append(name)
        return name

    hold()
    try:
        jobs = [
            run_in_background(lambda _: work("fit"), **given, priority=Priority.URGENT, delay_ms=0),
            run_in_background(lambda _: work("audit"), **given),
        ]
        dropped = run_in_background(lambda _: work("dropped"), **given)
        dropped.cancel()
        run_in_background(lambda _: work("picture"), **given, priority=Priority.IMMEDIATE)
        qtbot.waitUntil(lambda: heard.results == ["picture"])
        assert begun == ["picture"]
        assert not any(job.begun for job in jobs)
    finally:
        release()
    qtbot.waitUntil(lambda: len(heard.results) == 3)
    assert sorted(begun) == ["audit", "fit", "picture"]
    assert not dropped.running


def test_whoever_tells_nothing_hides_no_error(qtbot, monkeypatch):
    raised: list[BaseException] = []
    monkeypatch.setattr(sys, "excepthook", lambda kind, error, trace: raised.append(error))

    def work(control: JobControl) -> int:
        raise UsageError("nobody expected this")

    job = run_in_background(work, on_result=Heard().on_result, on_error=None)
    qtbot.waitUntil(lambda: bool(raised))
    assert isinstance(raised[0], UsageError)
    assert not job.running
