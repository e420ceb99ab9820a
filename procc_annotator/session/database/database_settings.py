"""Reading what a dataset was given, without opening its database for work."""

from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path

from procc_annotator.errors import InputError
from procc_annotator.session.database.database_file import FAILURES, leads_out, reason_of
from procc_annotator.session.database.database_places import database_path, kept_elsewhere
from procc_annotator.session.database.database_rows import SETTING_KEY
from procc_annotator.session.database.database_values import as_text, as_text_or_none

_BUSY_S = 5.0


def read_settings(dataset: Path) -> dict[str, str]:
    """The settings of a dataset, by key; nothing is made, written or mended.

    Args:
        dataset: its folder (or a picture in it).

    Raises:
        InputError: there is a workspace, but it cannot be read.
    """
    path = database_path(dataset)
    if not path.exists() or leads_out(path):
        found = kept_elsewhere(dataset)
        if found is None:
            return {}
        path = found
    try:
        connection = sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", _BUSY_S, uri=True)
        with closing(connection):
            rows = connection.execute("SELECT key, value FROM meta").fetchall()
        meta = {as_text(key): as_text_or_none(value) for key, value in rows}
    except FAILURES as error:
        raise InputError(path, f"the dataset's workspace cannot be read: {reason_of(error)}") from (
            error
        )
    start = SETTING_KEY
    return {k.removeprefix(start): v for k, v in meta.items() if k.startswith(start) and v}
