"""Log unexpected errors to a rotating file and report them in one line."""

from __future__ import annotations

import logging.handlers
import platform
import sys
import threading
import traceback
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from types import TracebackType

from procc_annotator.resources import data_folder
from procc_annotator.version import __version__

# Some hundred tracebacks a file; older ones go.
_BYTES, _FILES = 500_000, 3
_NAME = "procc_annotator"

# One line for people, and the details: versions, the path of the log, the traceback.


def log_path() -> Path | None:
    """The log file; None if the user has no home."""
    folder = data_folder()
    return None if folder is None else folder / "procc-annotator" / "log" / "errors.log"


def one_line(error: BaseException) -> str:
    """The type of an error and the first line of its message."""
    return traceback.format_exception_only(error)[-1].strip().split("\n", 1)[0]


def install_handlers(report: Callable[[str, str], None]) -> None:
    """Log every exception that nothing handles, in any thread, and hand it to ``report``.

    What is logged: versions, the platform, the traceback with its message; no values of variables.
    """
    logger = _logger()
    last = ""

    def log(error: BaseException) -> None:
        nonlocal last
        trace = "".join(traceback.format_exception(error))
        if trace == last:  # one that comes again with every paint
            return
        last = trace
        where = f"ProCC Annotator {__version__}, Python {platform.python_version()}"
        details = f"{where}, {platform.platform()}\n{trace}"
        logger.error(details)
        report(one_line(error), details)

    def hook(_: object, error: BaseException | None, trace: TracebackType | None) -> None:
        if isinstance(error, KeyboardInterrupt):
            sys.__excepthook__(type(error), error, trace)
        elif error is not None:
            log(error)

    sys.excepthook = hook
    threading.excepthook = lambda args: hook(args.exc_type, args.exc_value, args.exc_traceback)
    sys.unraisablehook = lambda args: hook(type(args.exc_value), args.exc_value, args.exc_traceback)


def log_line(text: str) -> None:
    """Log a line that no one needs to see now."""
    logging.getLogger(_NAME).warning(text)


def _logger() -> logging.Logger:
    logger, path = logging.getLogger(_NAME), log_path()
    logger.propagate = False
    logger.handlers = [logging.NullHandler()]
    if path is not None:
        with suppress(OSError):  # a home that cannot be written: the report is all there is
            path.parent.mkdir(parents=True, exist_ok=True)
            logger.handlers = [_Rotating(path, "a", _BYTES, _FILES, "utf-8", delay=True)]
            logger.handlers[0].setFormatter(logging.Formatter("%(asctime)s %(message)s"))
    return logger


class _Rotating(logging.handlers.RotatingFileHandler):
    def handleError(self, record: logging.LogRecord) -> None:
        """A full disk: the report is all there is."""
