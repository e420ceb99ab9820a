"""What is said where a part of the installation is missing is the line that adds it right here."""

from __future__ import annotations

import importlib.util
import shlex
import sys
import tomllib
from pathlib import Path

import pytest

from procc_annotator import messages
from procc_annotator.batch.execution.dask_cluster import DaskCluster
from procc_annotator.errors import ProccError

ROOT = Path(__file__).resolve().parent.parent.parent


@pytest.mark.parametrize("has_pip", [True, False])
def test_the_line_is_for_this_very_python(monkeypatch, has_pip) -> None:
    monkeypatch.setattr(sys, "executable", "/a b/python")
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: object() if has_pip else None)
    said = messages.install_hint("dask").partition(": ")[2]
    begin = ["/a b/python", "-m", "pip", "install"]
    if not has_pip:
        begin = ["uv", "pip", "install", "--python", "/a b/python"]
    assert shlex.split(said) == [*begin, "procc-annotator[dask]"]


def test_the_standalone_folder_says_that_it_cannot(monkeypatch) -> None:
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    assert "the standalone folder goes without a Dask cluster" in messages.install_hint("dask")


def test_the_extras_are_those_of_the_project() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    optional = project["optional-dependencies"]
    assert optional.keys() == messages.EXTRAS.keys()
    base = " ".join(project["dependencies"])
    for name, (_, library) in messages.EXTRAS.items():
        assert any(one.startswith(library) for one in optional[name])
        assert library not in base


def test_messages_name_it(monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    with (
        pytest.raises(ProccError, match=r"procc-annotator\[dask\]"),
        DaskCluster("tcp://127.0.0.1:1"),
    ):
        pass
