"""Whatever breaks, the window says so, goes on working, and the files stay whole."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import textwrap
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from procc_annotator.dataset.records import Status
from procc_annotator.gui.main_window import MainWindow
from tests.gui.conftest import until_kept

if TYPE_CHECKING:
    from tests.gui.conftest import Hand, MakeWindow

pytestmark = pytest.mark.qt_log_ignore("This plugin does not support", extend=True)

HandOn = Callable[[MainWindow], "Hand"]
MIDDLE, TOP = "Middle line", "Side line top"
ROOT = Path(__file__).resolve().parents[2]


def classes(path: Path) -> list[str]:
    return list(json.loads(path.read_text())) if path.exists() else []


class TestDiskTroubles:
    def test_a_folder_that_vanishes_in_the_middle(
        self, window: MainWindow, hand: Hand, dataset: Path
    ) -> None:
        hand.draw(MIDDLE, (100, 100), (200, 200))
        away = dataset.with_name("unplugged")
        dataset.rename(away)
        hand.draw(TOP, (100, 50), (200, 50))
        assert "NOT SAVED" in window.top_bar.saved.text()
        window.document.walk.next_frame()
        window.document.presence.beat()
        window.document.presence.look()
        window.document.review.poll()
        assert not dataset.exists()  # nothing was made in its place
        away.rename(dataset)
        window.document.saver.retry()
        until_kept()
        assert classes(dataset / "frame_0.json") == [MIDDLE, TOP]

    def test_a_read_only_dataset_is_annotated_with_its_memory_elsewhere(
        self,
        dataset: Path,
        make_window: MakeWindow,
        monkeypatch: pytest.MonkeyPatch,
        tmp_path: Path,
    ) -> None:
        (dataset / ".procc").write_text("a file where the folder belongs")
        monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
        window = make_window(dataset)
        assert str(tmp_path / "data") in window.message_bar.label.text()
        window.document.editing.commit_frame()
        assert window.document.review.status("frame_0") is Status.DONE

    def test_a_link_that_leads_out_of_the_dataset_is_not_followed(
        self, window: MainWindow, hand: Hand, dataset: Path, tmp_path: Path
    ) -> None:
        outside = tmp_path / "precious.json"
        outside.write_text("{}")
        (dataset / "frame_1.json").symlink_to(outside)
        window.document.walk.next_frame()
        hand.draw(MIDDLE, (100, 100), (200, 200))
        assert outside.read_text() == "{}"
        assert "link" in window.message_bar.label.text()


class TestPictures:
    def test_a_picture_deleted_or_cut_off_while_open(
        self, window: MainWindow, hand: Hand, dataset: Path
    ) -> None:
        (dataset / "frame_0.png").unlink()
        hand.draw(MIDDLE, (100, 100), (200, 200))  # it is on screen: clicks go on
        assert classes(dataset / "frame_0.json") == [MIDDLE]
        data = (dataset / "frame_2.png").read_bytes()
        window.document.cache.close()
        (dataset / "frame_2.png").write_bytes(data[: len(data) // 3])
        window.document.walk.go_to(2)
        assert "frame_2.png" in window.frame_bar.label.text()
        hand.draw(MIDDLE, (100, 100), (200, 200))
        assert not (dataset / "frame_2.json").exists()
        (dataset / "frame_2.png").write_bytes(data)
        window.document.walk.go_to(1)
        window.document.walk.go_to(2)
        assert window.document.state.editable


class TestClock:
    def test_a_clock_that_goes_backwards_disturbs_nothing(
        self, window: MainWindow, hand: Hand, dataset: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        hand.draw(MIDDLE, (100, 100), (200, 200))
        now = time.time()
        monkeypatch.setattr(time, "time", lambda: now - 86_400 * 400)
        hand.draw(TOP, (100, 50), (200, 50))
        database = window.document.review.database
        assert database is not None
        reasons = [v.reason for v in database.versions("frame_0")]
        assert reasons == ["draw Far touchline", "draw Halfway line"]
        window.document.presence.beat()
        assert window.document.state.editable
        assert classes(dataset / "frame_0.json") == [MIDDLE, TOP]


ANNOTATES = """
    import os, sys
    from pathlib import Path
    from PySide6.QtCore import QSettings
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, sys.argv[2])
    from procc_annotator.annotation import Point
    from procc_annotator.gui.app import application, build_window
    from procc_annotator.dataset import editing
    application()
    window = build_window(Path(sys.argv[1]))
    window.show()
    document = window.document
    for step in range(100_000):
        document.walk.go_to(step % 3)
        point = Point((step % 97) / 97, (step % 89) / 89)
        edited = editing.append_points(document.state.annotation, "Middle line", [point])
        document.editing.commit_edit("click", edited)
        while not window.top_bar.saved.text().startswith("saved "):
            application().processEvents()
        print(step, document.state.frame_index, len(edited.get("Middle line").points), flush=True)
"""


class TestKill:
    @pytest.mark.parametrize(
        "seed", [0, *(pytest.param(n, marks=pytest.mark.soak) for n in range(1, 8))]
    )
    def test_a_program_killed_at_any_moment_loses_nothing_it_had_saved(
        self,
        dataset: Path,
        tmp_path: Path,
        make_window: MakeWindow,
        hand_on: HandOn,
        seed: int,
    ) -> None:
        script = [sys.executable, "-c", textwrap.dedent(ANNOTATES), str(dataset), str(tmp_path)]
        running = subprocess.Popen(
            script, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, cwd=ROOT
        )
        assert running.stdout is not None
        told: dict[int, int] = {}
        for _ in range(7 + 13 * seed):
            _, frame, points = map(int, running.stdout.readline().split())
            told[frame] = points
        running.send_signal(signal.SIGKILL)
        running.wait()
        for line in running.stdout.read().splitlines():
            if len(line.split()) == 3:
                told[int(line.split()[1])] = int(line.split()[2])
        running.stdout.close()
        window = make_window(dataset)
        assert "damaged" not in window.message_bar.label.text()
        for frame, points in told.items():
            polyline = json.loads((dataset / f"frame_{frame}.json").read_text())[MIDDLE]
            assert len(polyline) in (points, points + 1)
        hand_on(window).draw(TOP, (100, 50), (200, 50))  # the dead one's lock blocks nobody
        assert window.document.state.annotation.get(TOP) is not None
        leftovers = [p for p in dataset.iterdir() if p.suffix == ".tmp"]
        assert len(leftovers) <= 1

    def test_a_polyline_under_way_is_all_that_a_kill_can_take(
        self, window: MainWindow, hand: Hand, dataset: Path, tmp_path: Path
    ) -> None:
        hand.draw(MIDDLE, (100, 100), (200, 200))
        window.document.selecting.select_class(TOP)
        hand.click(100, 50)
        shutil.copytree(dataset, tmp_path / "as_left")  # what a kill at this moment leaves
        assert classes(tmp_path / "as_left" / "frame_0.json") == [MIDDLE]


def test_a_file_mended_outside_opens_when_the_frame_is_opened_again(
    make_window: MakeWindow, dataset: Path, hand_on: Callable[[MainWindow], Hand]
) -> None:
    (dataset / "frame_1.json").write_text("{")
    window = make_window(dataset)
    window.document.walk.go_to(1)
    assert not window.document.state.editable
    (dataset / "frame_1.json").write_text("{}")
    window.document.walk.go_to(0)
    window.document.walk.go_to(1)
    hand_on(window).draw(MIDDLE, (100, 100), (200, 200))
    assert classes(dataset / "frame_1.json") == [MIDDLE]


def test_an_unreadable_annotation_blocks_its_frame_only(
    dataset: Path, make_window: MakeWindow, hand_on: HandOn, qtbot: QtBot
) -> None:
    (dataset / "frame_0.json").write_bytes(b'{"Middle line": [{"x": 0.5}]}')
    window = make_window(dataset)
    assert "Middle line[0]" in window.frame_bar.label.text()
    hand = hand_on(window)
    hand.key(Qt.Key.Key_R, Qt.KeyboardModifier.ShiftModifier)
    hand.key(Qt.Key.Key_V)
    hand.draw(MIDDLE, (100, 100), (200, 200))
    assert (dataset / "frame_0.json").read_bytes() == b'{"Middle line": [{"x": 0.5}]}'
    window.document.walk.next_frame()
    hand.draw(MIDDLE, (100, 100), (200, 200))
    assert classes(dataset / "frame_1.json") == [MIDDLE]


FAILS = """
    import sys, threading
    from pathlib import Path
    from PySide6.QtCore import QSettings, QTimer
    from PySide6.QtGui import QGuiApplication
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, sys.argv[2])
    from procc_annotator.annotation import Point
    from procc_annotator.gui import app as program
    from procc_annotator.gui.state.background import run_in_background
    from procc_annotator.dataset import editing

    def fail_in_slot(): 1 / 0
    def fail_in_thread(): [][1]
    def fail_in_job(control): {}["a job"]

    def look_and_close(window):
        if "a job" not in window.message_bar.label.text():
            QTimer.singleShot(20, lambda: look_and_close(window))
            return
        print(window.message_bar.label.text(), window.message_bar.remedy.text(), sep="|")
        window.message_bar.remedy.click()
        print(QGuiApplication.clipboard().text())
        document = window.document
        points = [Point(0.2, 0.2), Point(0.4, 0.4)]
        edited = editing.append_points(document.state.annotation, "Middle line", points)
        document.editing.commit_edit("click", edited)
        window.close()

    def show(app, window):
        window.show()
        program.go_to_work(app)
        QTimer.singleShot(0, fail_in_slot)
        QTimer.singleShot(0, threading.Thread(target=fail_in_thread).start)
        QTimer.singleShot(
            100, lambda: run_in_background(fail_in_job, on_result=print, on_error=None)
        )
        QTimer.singleShot(0, lambda: look_and_close(window))
        return app.exec()

    program.show_until_closed = show
    program.main(Path(sys.argv[1]))
"""


def test_an_unexpected_error_is_logged_and_shown_and_saving_goes_on(
    dataset: Path, tmp_path: Path
) -> None:
    script = [sys.executable, "-c", textwrap.dedent(FAILS), str(dataset), str(tmp_path)]
    home = {**os.environ, "XDG_DATA_HOME": str(tmp_path / "data")}
    done = subprocess.run(script, env=home, cwd=ROOT, capture_output=True, text=True, check=False)

    log = tmp_path / "data" / "procc-annotator" / "log" / "errors.log"
    assert done.returncode == 0, done.stderr
    shown, _, copied = done.stdout.partition("\n")
    assert shown == (
        f"unexpected error (KeyError: 'a job'); saving goes on, the details are in {log}"
        "|Copy details"
    )
    assert "in fail_in_job" in copied
    logged = log.read_text()
    for function in ("fail_in_slot", "fail_in_thread", "fail_in_job"):
        assert f"in {function}" in logged
    assert "Traceback" not in done.stderr
    assert classes(dataset / "frame_0.json") == [MIDDLE]
