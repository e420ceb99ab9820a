"""Garbage goes on the interface's thread, between gestures."""

import gc
import threading
import weakref

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt, QTimer
from PySide6.QtWidgets import QApplication

from procc_annotator.gui.app import collect_between_gestures, collect_now_and_then

MANY = 30_000


class Cycle(QObject):
    """Something of Qt that only the collector ends."""

    def __init__(self) -> None:
        super().__init__()
        self.itself = self


def litter() -> list[list[object]]:
    return [[] for _ in range(MANY)]


def test_garbage_goes_once_there_may_be_much(qapp):
    gc.collect()
    gone = weakref.ref(Cycle())
    collect_now_and_then()
    assert gone() is not None, "little is left alone"
    kept = litter()
    collect_now_and_then()
    assert gone() is None
    assert len(kept) == MANY


def test_nothing_is_collected_during_a_gesture(qapp, monkeypatch):
    gc.collect()
    gone, kept = weakref.ref(Cycle()), litter()
    with monkeypatch.context() as held:
        held.setattr(QApplication, "mouseButtons", lambda: Qt.MouseButton.LeftButton)
        collect_now_and_then()
        assert gone() is not None
    collect_now_and_then()
    assert gone() is None
    assert len(kept) == MANY


def test_no_other_thread_ends_what_qt_owns(qapp, qtbot):
    gc.collect()
    ended: list[int] = []
    timers = set(qapp.findChildren(QTimer))
    collect_between_gestures(qapp)
    gone = weakref.ref(Cycle(), lambda _: ended.append(threading.get_ident()))
    try:
        busy = threading.Thread(target=lambda: [litter() for _ in range(5)])
        busy.start()
        busy.join()
        assert not ended, "an object of Qt was ended by a thread beside the interface"
        kept = litter()
        qtbot.waitUntil(lambda: gone() is None)
        assert ended == [threading.get_ident()]
        assert len(kept) == MANY
    finally:
        for timer in set(qapp.findChildren(QTimer)) - timers:
            timer.stop()
            timer.deleteLater()
        gc.unfreeze()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete.value)
