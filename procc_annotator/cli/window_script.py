"""``procc-annotator-window``: the window from a menu, where no terminal shows errors."""

from __future__ import annotations

import io
import sys

from procc_annotator.cli.main import run


def run_window() -> None:
    """Entry point of the graphical script; its arguments are those of ``procc-annotator open``.

    Where the system gives no standard error (a program of Windows without a console), what would
    have been written there is shown in a dialog.
    """
    sys.argv[1:1] = ["open"]
    if sys.stderr is not None:
        run()
        return
    told = io.StringIO()
    sys.stdout = sys.stderr = told
    try:
        run()
    except SystemExit as ended:
        if ended.code and told.getvalue():
            _show(told.getvalue())
        raise


def _show(text: str) -> None:
    from PySide6.QtWidgets import QMessageBox

    from procc_annotator.gui.app import application

    application()
    QMessageBox.critical(None, "ProCC Annotator", text)
