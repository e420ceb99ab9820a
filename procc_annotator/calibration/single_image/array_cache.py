"""Arrays that take seconds to compute, kept in the user's cache folder."""

from __future__ import annotations

import hashlib
import os
import zipfile
from collections.abc import Callable, Sequence
from contextlib import suppress

import numpy as np

from procc_annotator.errors import SaveError
from procc_annotator.formats.atomic import make_folder, open_replacing
from procc_annotator.regular_file import open_regular
from procc_annotator.resources import cache_folder
from procc_annotator.version import __version__

_FOLDER = "procc-annotator"
_MAX_FILES = 16  # of 30 MB each
Arrays = tuple[np.ndarray, ...]


def cached_arrays(
    name: str,
    key: Sequence[object],
    compute: Callable[[], Arrays],
    is_valid: Callable[[Arrays], bool],
) -> Arrays:
    """Return what ``compute`` returns, from a file if an earlier call with the same key wrote one.

    A file that is damaged, of another program, or not valid is written again; without a folder that
    can be written to, the arrays are computed each time.

    Args:
        name: of the file, before its key.
        key: arrays and values with a stable repr; the program's version is added.
        is_valid: whether arrays from a file are those of this program.
    """
    folder = cache_folder()
    if folder is None:
        return compute()
    digest = hashlib.sha256(repr((__version__, np.__version__)).encode())
    for part in key:
        digest.update(part.tobytes() if isinstance(part, np.ndarray) else repr(part).encode())
    path = folder / _FOLDER / f"{name}-{digest.hexdigest()[:24]}.npz"
    # The archive has a checksum of each array; one of other arrays fails when they are used.
    with suppress(OSError, ValueError, LookupError, EOFError, zipfile.BadZipFile):
        with open_regular(path) as file, np.load(file, allow_pickle=False) as kept:
            found = tuple(kept[f"arr_{number}"] for number in range(len(kept.files)))
        if is_valid(found):
            return found
    found = compute()
    with suppress(SaveError, OSError):
        make_folder(path.parent)
        with open_replacing(path) as stream:
            np.savez(stream, *found)
        files = sorted(path.parent.glob(f"{name}-*.npz"), key=os.path.getmtime)
        for old in files[:-_MAX_FILES]:
            old.unlink(missing_ok=True)
    return found
