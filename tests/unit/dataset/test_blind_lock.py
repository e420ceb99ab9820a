"""Who locked a dataset to blind mode and who took it back."""

from __future__ import annotations

import pytest

from procc_annotator.dataset.review import LockEvent, lock_of, read_events, write_events

LOCKED, UNLOCKED = LockEvent(True, "Ada", 1.5), LockEvent(False, "Béla", 2.0)


@pytest.mark.parametrize(
    ("events", "lock"),
    [
        ((), None),
        ((LOCKED,), LOCKED),
        ((LOCKED, UNLOCKED), None),
        ((LOCKED, UNLOCKED, LOCKED),) * 2,
    ],
)
def test_the_last_word_holds(events, lock) -> None:
    expected = events[-1] if isinstance(lock, tuple) else lock
    assert read_events(write_events(events)) == events
    assert lock_of(events) is expected


def test_what_cannot_be_read_locks() -> None:
    assert lock_of(read_events("[{")) is not None
    assert read_events(None) == ()
