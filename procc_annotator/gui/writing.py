"""One way to write something of the open dataset: ask where to, write in the background, say."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QFileDialog, QWidget

from procc_annotator.dataset.frames import Frame
from procc_annotator.gui.state.availability import no_frame
from procc_annotator.gui.state.background import JobControl, run_in_background
from procc_annotator.gui.state.services import Services

T = TypeVar("T")


def opened_frame(services: Services) -> Frame | None:
    """The frame on screen; if there is none it is said what to do."""
    if why := no_frame(services.state):
        services.say(why, "warning")
    return services.state.frame


def ask_where(
    services: Services, parent: QWidget, title: str, name: str, kinds: str
) -> Path | None:
    """Ask for a file next to the folder of pictures; None if nowhere.

    Args:
        services: nothing is asked, and that is said, where no frame is open.
        parent: the dialog's.
        title: the dialog's.
        name: offered for the file.
        kinds: Qt's filters; a name without a suffix gets that of the kind that was chosen.
    """
    if (frame := opened_frame(services)) is None:
        return None
    start = frame.image_path.parent.parent / name
    chosen, kind = QFileDialog.getSaveFileName(parent, title, str(start), kinds)
    if not chosen:
        return None
    path = Path(chosen)
    suffix = (kinds if ";;" not in kinds else kind).partition("(*.")[2].rstrip(")")
    return path.with_suffix(f".{suffix}") if suffix and not path.suffix else path


def write(
    services: Services,
    work: Callable[[JobControl], T],
    said: Callable[[T], str],
    *,
    owner: QObject | None = None,
    progress: Callable[[int, int], None] | None = None,
    again: str = "",
) -> None:
    """Write in the background, and say what came of it.

    Args:
        services: says it.
        work: writes.
        said: in words, what came of it.
        owner: nothing is said once it is gone; the services unless given.
        progress: receives how many of how many are done.
        again: the action that asks for another place.
    """
    run_in_background(
        work,
        on_result=lambda result: services.say(said(result)),
        on_error=lambda text: services.say(text, "error", again),
        on_progress=progress,
        owner=services if owner is None else owner,
    )
