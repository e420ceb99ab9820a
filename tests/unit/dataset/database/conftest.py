"""A database of a folder of its own, away from the user's data."""

from __future__ import annotations

import sqlite3
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from procc_annotator.dataset.database import connection as database_file
from procc_annotator.dataset.database.database import WorkspaceDatabase


@pytest.fixture(autouse=True)
def own_data(tmp_path_factory, monkeypatch) -> Path:
    """The user's data folder, out of the way."""
    folder = tmp_path_factory.mktemp("own")
    for name in ("XDG_DATA_HOME", "LOCALAPPDATA", "HOME"):
        monkeypatch.setenv(name, str(folder))
    return folder


@pytest.fixture(autouse=True)
def quick_disk(monkeypatch) -> None:
    """Do not wait for the disk; the processes that are killed do."""
    connect = database_file.connect

    def quick(path: Path | None) -> sqlite3.Connection:
        connection = connect(path)
        connection.execute("PRAGMA synchronous = OFF")
        return connection

    monkeypatch.setattr(database_file, "connect", quick)


@pytest.fixture
def opened(tmp_path) -> Iterator[Callable[..., WorkspaceDatabase]]:
    """Opens databases and closes them in the end."""
    all_: list[WorkspaceDatabase] = []

    def open_(dataset: Path = tmp_path, author: str = "Anna") -> WorkspaceDatabase:
        all_.append(WorkspaceDatabase.open(dataset, author))
        return all_[-1]

    yield open_
    for one in all_:
        one.close()
