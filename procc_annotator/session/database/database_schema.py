"""The tables of the workspace database, and how those of older versions become them."""

from __future__ import annotations

APPLICATION_ID = 0x50724343  # "PrCC"

# `verdict.by_name` of a source's stored name, which stays a BLOB when it is one.
BY_NAME = "CASE typeof({0}) WHEN 'blob' THEN CAST('name:' || {0} AS BLOB) ELSE 'name:' || {0} END"

# One tuple of statements a schema version; a database of version n gets MIGRATIONS[n:].
MIGRATIONS: tuple[tuple[str, ...], ...] = (
    (
        # A setting that was taken back leaves NULL.
        "CREATE TABLE meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID",
        # NULL is what nobody has set.
        "CREATE TABLE frame(name TEXT PRIMARY KEY, status TEXT, committed INTEGER) WITHOUT ROWID",
        # Seconds are kept by session as totals, so that writing them twice changes nothing.
        "CREATE TABLE work(frame TEXT, session TEXT, seconds REAL NOT NULL,"
        " PRIMARY KEY(frame, session)) WITHOUT ROWID",
        # Ids are chosen by the writing process; seq gives the order, whatever the clocks said.
        "CREATE TABLE comment(seq INTEGER PRIMARY KEY AUTOINCREMENT, id TEXT NOT NULL UNIQUE,"
        " frame TEXT NOT NULL, author TEXT NOT NULL, time REAL NOT NULL, text TEXT NOT NULL,"
        " resolved INTEGER NOT NULL DEFAULT 0)",
        "CREATE TABLE origin(frame TEXT, u REAL, v REAL, kind TEXT NOT NULL,"
        " author TEXT NOT NULL, time REAL NOT NULL, PRIMARY KEY(frame, u, v)) WITHOUT ROWID",
        "CREATE TABLE version(seq INTEGER PRIMARY KEY AUTOINCREMENT, id TEXT NOT NULL UNIQUE,"
        " frame TEXT NOT NULL, author TEXT NOT NULL, time REAL NOT NULL, reason TEXT NOT NULL,"
        " digest BLOB NOT NULL, data BLOB NOT NULL)",
        "CREATE INDEX version_of_frame ON version(frame)",
        # A draft that is over leaves an empty one.
        "CREATE TABLE draft(frame TEXT PRIMARY KEY, data BLOB NOT NULL) WITHOUT ROWID",
    ),
    (
        # A verdict that was taken back leaves an empty fault.
        "CREATE TABLE verdict(frame TEXT, source TEXT, fault TEXT NOT NULL, author TEXT NOT NULL,"
        " time REAL NOT NULL, comment TEXT NOT NULL, PRIMARY KEY(frame, source)) WITHOUT ROWID",
    ),
    (
        # A source is known by its place: names change, and others may be called the same.
        "CREATE TABLE source_verdict(frame TEXT, place TEXT, source TEXT NOT NULL,"
        " fault TEXT NOT NULL, author TEXT NOT NULL, time REAL NOT NULL, comment TEXT NOT NULL,"
        " PRIMARY KEY(frame, place)) WITHOUT ROWID",
        "INSERT INTO source_verdict(frame, place, source, fault, author, time, comment)"
        f" SELECT frame, {BY_NAME.format('source')}, source, fault, author, time, comment"
        " FROM verdict",
        "DROP TABLE verdict",
    ),
    (
        # An element that can be seen after all leaves a hidden of 0.
        "CREATE TABLE not_visible(frame TEXT, element TEXT, hidden INTEGER NOT NULL,"
        " author TEXT NOT NULL, time REAL NOT NULL, PRIMARY KEY(frame, element)) WITHOUT ROWID",
    ),
)
