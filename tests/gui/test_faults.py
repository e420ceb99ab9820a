"""Whatever breaks, the window says so, goes on working, and the files stay whole."""

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

import pytest
from PySide6.QtCore import Qt

from procc_annotator.dataset.records import Status
from procc_annotator.gui.main_window import MainWindow
from tests.gui.conftest import Hand, until_kept

HandOn = Callable[[MainWindow], "Hand"]
MIDDLE, TOP = "Middle line", "Side line top"
ROOT = Path(__file__).resolve().parents[2]


def classes(path: Path) -> list[str]:
    return list(json.loads(path.read_text())) if path.exists() else []


class TestDiskTroubles:
    def test_a_folder_that_vanishes_in_the_middle(self, window, hand, dataset):
        hand.draw(MIDDLE, (100, 100), (200, 200))
        away = dataset.with_name("unplugged")
        dataset.rename(away)
        hand.draw(TOP, (100, 50), (200, 50))
        assert "NOT SAVED" in window.top_bar.saved.text()
        window.services.navigator.next_frame()
        window.services.frame_lock.beat()
        window.services.frame_lock.look()
        window.services.review.poll()
        assert not dataset.exists()  # nothing was made in its place
        away.rename(dataset)
        window.services.saver.retry()
        until_kept()
        assert classes(dataset / "frame_0.json") == [MIDDLE, TOP]

    def test_a_read_only_dataset_is_annotated_with_its_memory_elsewhere(
        self, dataset, make_window, monkeypatch, tmp_path
    ):
        (dataset / ".procc").write_text("a file where the folder belongs")
        monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
        window = make_window(dataset)
        assert str(tmp_path / "data") in window.message_bar.label.text()
        window.services.editing.commit_frame()
        assert window.services.review.status("frame_0") is Status.DONE

    def test_a_link_that_leads_out_of_the_dataset_is_not_followed(
        self, window, hand, dataset, tmp_path
    ):
        outside = tmp_path / "precious.json"
        outside.write_text("{}")
        (dataset / "frame_1.json").symlink_to(outside)
        window.services.navigator.next_frame()
        hand.draw(MIDDLE, (100, 100), (200, 200))
        assert outside.read_text() == "{}"
        assert "link" in window.message_bar.label.text()


class TestPictures:
    def test_a_picture_deleted_or_cut_off_while_open(self, window, hand, dataset):
        (dataset / "frame_0.png").unlink()
        hand.draw(MIDDLE, (100, 100), (200, 200))  # it is on screen: clicks go on
        assert classes(dataset / "frame_0.json") == [MIDDLE]
        data = (dataset / "frame_2.png").read_bytes()
        window.services.cache.close()
        (dataset / "frame_2.png").write_bytes(data[: len(data) // 3])
        window.services.navigator.go_to(2)
        assert "frame_2.png" in window.frame_bar.label.text()
        hand.draw(MIDDLE, (100, 100), (200, 200))
        assert not (dataset / "frame_2.json").exists()
        (dataset / "frame_2.png").write_bytes(data)
        window.services.navigator.go_to(1)
        window.services.navigator.go_to(2)
        assert window.services.state.editable


class TestClock:
    def test_a_clock_that_goes_backwards_disturbs_nothing(self, window, hand, dataset, monkeypatch):
        hand.draw(MIDDLE, (100, 100), (200, 200))
        now = time.time()
        monkeypatch.setattr(time, "time", lambda: now - 86_400 * 400)
        hand.draw(TOP, (100, 50), (200, 50))
        database = window.services.review.database
        reasons = [v.reason for v in database.versions("frame_0")]
        assert reasons == ["draw Far touchline", "draw Halfway line"]
        window.services.frame_lock.beat()
        assert window.services.state.editable
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
    services = window.services
    for step in range(100_000):
        services.navigator.go_to(step % 3)
        point = Point((step % 97) / 97, (step % 89) / 89)
        edited = editing.append_points(services.state.annotation, "Middle line", [point])
        services.editing.commit_edit("click", edited)
        while window.top_bar.saved.text() != "saved":
            application().processEvents()
        print(step, services.state.frame_index, len(edited.get("Middle line").points), flush=True)
"""


class TestKill:
    @pytest.mark.parametrize(
        "seed", [0, *(pytest.param(n, marks=pytest.mark.soak) for n in range(1, 8))]
    )
    def test_a_program_killed_at_any_moment_loses_nothing_it_had_saved(
        self, dataset, tmp_path, make_window, hand_on, seed
    ):
        script = [sys.executable, "-c", textwrap.dedent(ANNOTATES), str(dataset), str(tmp_path)]
        running = subprocess.Popen(
            script, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, cwd=ROOT
        )
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
        assert window.services.state.annotation.get(TOP) is not None
        leftovers = [p for p in dataset.iterdir() if p.suffix == ".tmp"]
        assert len(leftovers) <= 1

    def test_a_polyline_under_way_is_all_that_a_kill_can_take(
        self, window, hand, dataset, tmp_path
    ):
        hand.draw(MIDDLE, (100, 100), (200, 200))
        window.services.selection.select_class(TOP)
        hand.click(100, 50)
        shutil.copytree(dataset, tmp_path / "as_left")  # what a kill at this moment leaves
        assert classes(tmp_path / "as_left" / "frame_0.json") == [MIDDLE]


def test_a_file_mended_outside_opens_when_the_frame_is_opened_again(make_window, dataset, hand_on):
    (dataset / "frame_1.json").write_text("{")
    window = make_window(dataset)
    window.services.navigator.go_to(1)
    assert not window.services.state.editable
    (dataset / "frame_1.json").write_text("{}")
    window.services.navigator.go_to(0)
    window.services.navigator.go_to(1)
    hand_on(window).draw(MIDDLE, (100, 100), (200, 200))
    assert classes(dataset / "frame_1.json") == [MIDDLE]


def test_an_unreadable_annotation_blocks_its_frame_only(dataset, make_window, hand_on, qtbot):
    (dataset / "frame_0.json").write_bytes(b'{"Middle line": [{"x": 0.5}]}')
    window = make_window(dataset)
    assert "Middle line[0]" in window.frame_bar.label.text()
    hand = hand_on(window)
    hand.key(Qt.Key.Key_R, Qt.KeyboardModifier.ShiftModifier)
    hand.key(Qt.Key.Key_V)
    hand.draw(MIDDLE, (100, 100), (200, 200))
    assert (dataset / "frame_0.json").read_bytes() == b'{"Middle line": [{"x": 0.5}]}'
    window.services.navigator.next_frame()
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
        services = window.services
        points = [Point(0.2, 0.2), Point(0.4, 0.4)]
        edited = editing.append_points(services.state.annotation, "Middle line", points)
        services.editing.commit_edit("click", edited)
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


def test_an_unexpected_error_is_logged_and_shown_and_saving_goes_on(dataset, tmp_path):
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
