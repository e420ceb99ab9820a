"""Tasks that worker processes can import."""

import importlib
from pathlib import Path
from types import ModuleType

import pytest

HERE = Path(__file__).parent


@pytest.fixture
def tasks(monkeypatch) -> ModuleType:
    """The module `executor_tasks`, under a name that workers find too."""
    monkeypatch.syspath_prepend(HERE)
    return importlib.import_module("executor_tasks")
