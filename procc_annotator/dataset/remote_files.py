"""Files of object stores and web servers, by fsspec: local copies while they are used, uploads.

A URL is a path like any other, with one slash where the URL has two (``s3:/bucket/match.mp4``).
fsspec's own caches take a transfer that was killed for a whole file (``simplecache``) or let two
processes write one file (``filecache``), and have no bound: only its transfers are used.
"""

from __future__ import annotations

import os
import re
import shutil
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from hashlib import sha256
from pathlib import Path, PurePath
from typing import Any

from procc_annotator.errors import InputError, ProccError, UsageError
from procc_annotator.formats.atomic import make_folder
from procc_annotator.messages import install_hint
from procc_annotator.resources import cache_folder

CACHE_VARIABLE = "PROCC_ANNOTATOR_CACHE"  # names the folder, for workers too
_MOST_BYTES = 20 << 30  # of copies: the oldest are removed, unless
_IN_USE_S = 6 * 3600.0  # a unit of work began with them that recently
_URL = re.compile(r"([a-z][a-z0-9+.-]+):/+(.*)")  # one letter is a drive
# What stores say of a file that changes with its content, the best first.
_MARKS = ("etag", "md5hash", "lastmodified", "last_modified", "updated", "mtime", "created")


def url_of(path: Path) -> str:
    """The URL that a path was made from; empty for any other path."""
    found = _URL.fullmatch(path.as_posix())
    slash = "/" if found and found[1] == "file" else ""
    return f"{found[1]}://{slash}{found[2]}" if found else ""


def file_name(path: Path) -> PurePath:
    """The name of a file, of a URL without a signature (``?...``)."""
    return PurePath(PurePath(url_of(path).partition("?")[0] or path).name)


def local_path(path: Path) -> Path:
    """A path itself; for a URL that of a copy on this machine, made unless there is one of what the
    file holds now, for which its time stands.

    Raises:
        UsageError: fsspec, or what it needs for such a URL, is not installed.
        InputError: the file cannot be read, or not be kept here.
    """
    if not url_of(path):
        return path
    with _store_of(path) as (store, name):
        about = {key.lower(): value for key, value in store.info(name).items()}
        mark = _digest(about["size"], next((about[key] for key in _MARKS if key in about), ""))
        copy = _cache() / "copies" / f"{_digest(url_of(path))}-{mark}" / file_name(path)
        make_folder(copy.parent)
        if not copy.exists():
            _remove_idle(copy.parent.parent)
            partial = copy.with_name(f"{os.getpid()}.partial")
            store.get_file(name, str(partial))
            os.utime(partial, (int(mark[:7], 16),) * 2)
            os.replace(partial, copy)
        os.utime(copy.parent)
    return copy


def remove_copies(path: Path) -> None:
    """Remove the copies of a URL; of any other path there are none."""
    for folder in (_cache() / "copies").glob(f"{_digest(url_of(path))}-*"):
        shutil.rmtree(folder, ignore_errors=True)


def working_folder(out: Path) -> Path:
    """A folder itself; for a URL one on this machine, which begins with what is there; raises as
    `local_path`."""
    if not url_of(out):
        return out
    folder = _cache() / "out" / f"{out.name}-{_digest(url_of(out))}"
    if not folder.exists():
        with _store_of(out) as (store, name):
            make_folder(partial := folder.with_suffix(".partial"))
            if store.exists(name):
                store.get(f"{name}/", f"{partial}/", recursive=True)
            os.replace(partial, folder)
    return folder


def upload(out: Path, file: str) -> None:
    """Write a file of the `working_folder` of a URL there; raises as `local_path`."""
    if url_of(out) and (local := working_folder(out) / file).exists():
        with _store_of(out) as (store, name):
            store.makedirs(f"{name}/{file}".rpartition("/")[0], exist_ok=True)
            store.put_file(str(local), f"{name}/{file}")


def _cache() -> Path:
    usual = cache_folder() or Path(tempfile.gettempdir())
    return Path(os.environ.get(CACHE_VARIABLE) or usual / "procc-annotator").absolute()


def _digest(*parts: object) -> str:
    return sha256(repr(parts).encode()).hexdigest()[:16]


def _remove_idle(copies: Path) -> None:
    kept = 0
    with suppress(FileNotFoundError):  # another process removes some, too
        for folder in sorted(copies.iterdir(), key=os.path.getmtime, reverse=True):
            kept += sum(file.stat().st_size for file in folder.iterdir())
            if kept > _MOST_BYTES and time.time() - folder.stat().st_mtime > _IN_USE_S:
                shutil.rmtree(folder, ignore_errors=True)


@contextmanager
def _store_of(path: Path) -> Iterator[tuple[Any, str]]:
    """The file system of a URL, and its path there; each store has errors of its own."""
    try:
        from fsspec.core import url_to_fs
    except ImportError as error:
        why = f"is read through fsspec, which is not installed ({install_hint('cloud')})"
        raise UsageError(f"{url_of(path)}: {why}") from error
    try:
        yield url_to_fs(url_of(path), use_listings_cache=False)
    except ProccError:
        raise
    except Exception as error:  # the libraries of stores share no class of errors
        why = "no such file" if isinstance(error, FileNotFoundError) else f"{error or repr(error)}"
        raise InputError(url_of(path), f"cannot be transferred: {why}") from error
