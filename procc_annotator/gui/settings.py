"""What the window remembers between runs."""

from __future__ import annotations

import json
from pathlib import Path

from PySide6.QtCore import QByteArray, QSettings

ORGANISATION = "ProCC"
APPLICATION = "Annotator"
_RECENT = 8
_OWN_FIELDS = 6
_DATASETS = 40  # whose camera sources are remembered


class Settings:
    """Typed access to the stored settings; a value of the wrong kind counts as absent."""

    def __init__(self) -> None:
        self._store = QSettings(
            QSettings.Format.IniFormat, QSettings.Scope.UserScope, ORGANISATION, APPLICATION
        )

    def number(self, key: str, default: float) -> float:
        """A number, or the default."""
        value = self._store.value(key)
        try:
            return float(str(value)) if value is not None else default
        except ValueError:
            return default

    def flag(self, key: str, default: bool) -> bool:
        """A yes or no, or the default."""
        value = self._store.value(key)
        return default if value is None else str(value).lower() in ("true", "1")

    def text(self, key: str, default: str, allowed: tuple[str, ...] = ()) -> str:
        """A text, or the default when it is none of the allowed ones."""
        value = self._store.value(key)
        if value is None or (allowed and str(value) not in allowed):
            return default
        return str(value)

    def blob(self, key: str) -> QByteArray:
        """A window state; empty when there is none."""
        value = self._store.value(key)
        return value if isinstance(value, QByteArray) else QByteArray()

    def set(self, key: str, value: str | float | bool | QByteArray) -> None:
        """Remember a value."""
        self._store.setValue(key, value)

    @property
    def recent(self) -> list[Path]:
        """Folders and pictures opened last, newest first."""
        value = self._store.value("recent")
        if isinstance(value, str):
            value = [value]
        return [Path(str(v)) for v in value] if isinstance(value, list) else []

    def add_recent(self, path: Path) -> None:
        """Put a path in front of the recent ones."""
        paths = [path, *(p for p in self.recent if p != path)][:_RECENT]
        self._store.setValue("recent", [str(p) for p in paths])

    def forget_recent(self, path: Path) -> None:
        """Take a path out of the recent ones: it is gone."""
        self._store.setValue("recent", [str(p) for p in self.recent if p != path])

    @property
    def own_fields(self) -> list[Path]:
        """Descriptions of fields of the user's own that were used last, newest first."""
        value = self._store.value("own_fields")
        if isinstance(value, str):
            value = [value]
        return [Path(str(v)) for v in value] if isinstance(value, list) else []

    def add_own_field(self, path: Path) -> None:
        """Put a description in front of those used last."""
        paths = [path, *(p for p in self.own_fields if p != path)][:_OWN_FIELDS]
        self._store.setValue("own_fields", [str(p) for p in paths])

    def sources(self, dataset: str) -> list[object]:
        """What was written down of the camera sources of a dataset."""
        entries = self._all_sources().get(dataset)
        return entries if isinstance(entries, list) else []

    def set_sources(self, dataset: str, entries: list[dict[str, object]]) -> None:
        """Write down the camera sources of a dataset; those used longest ago are forgotten."""
        known = self._all_sources()
        known.pop(dataset, None)
        if entries:
            known[dataset] = entries
        kept = dict(list(known.items())[-_DATASETS:])
        self._store.setValue("sources", json.dumps(kept))

    def _all_sources(self) -> dict[str, object]:
        try:
            known = json.loads(str(self._store.value("sources") or "{}"))
        except ValueError:
            return {}
        return known if isinstance(known, dict) else {}

    def sync(self) -> None:
        """Write to disk now."""
        self._store.sync()
