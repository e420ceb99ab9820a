"""What is done once, after what there is to paint was painted."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, QTimer, SignalInstance


def soon(owner: QObject, then: Callable[[], object] | SignalInstance) -> QTimer:
    """A timer that, started, calls something after the next paint; once, however often it is
    started until then.

    Qt paints when it works through the events that are posted, which it does before it looks at
    its timers.

    Args:
        owner: with it the timer is gone.
        then: what to call, or a signal to send.
    """
    timer = QTimer(owner, singleShot=True, interval=0)
    timer.timeout.connect(then)
    return timer
