"""Annotate and audit sports-camera calibrations; from Python: `api`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from procc_annotator.api import evaluate, fit_camera, load_annotation, propose_camera, track

__all__ = [
    "__version__",
    "evaluate",
    "fit_camera",
    "load_annotation",
    "propose_camera",
    "track",
]
__version__ = "0.1.0"


def __getattr__(name: str) -> Any:
    # Every start of the program imports this package; only callers of the API pay for it.
    if name in __all__:
        from procc_annotator import api

        return getattr(api, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
