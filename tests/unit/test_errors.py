"""The texts of errors: one line, names as they are, nothing that commands a terminal."""

import importlib.util
import pickle
import shlex
import sys
import tomllib
from pathlib import Path

import pytest

from procc_annotator import messages
from procc_annotator.batch.execution.dask_cluster import DaskCluster
from procc_annotator.errors import AnnotationError, InputError, ProccError, SaveError
from procc_annotator.messages import condensed


def test_names_stay_as_they_are():
    error = AnnotationError("/data/two  spaces/é.json", "no such class", place='"A  B"')
    assert str(error) == '/data/two  spaces/é.json: "A  B": no such class'


def test_control_characters_of_a_name_are_shown_and_not_obeyed():
    for error in (InputError("a\x1b[2Jb\nc.json", "unreadable"), SaveError("a\x1b[2Jb\nc.json")):
        assert str(error).startswith(r"a\x1b[2Jb\nc.json")


def test_explanations_of_several_lines_become_one():
    assert str(InputError("f.toml", "wrong value\n  at line 3")) == "f.toml: wrong value at line 3"


def test_errors_come_back_whole_from_a_worker_process():
    error = InputError("a\nb", "wrong", place="line 1", advice="mend it")
    again = pickle.loads(pickle.dumps(error))  # noqa: S301 - its own bytes
    assert (str(again), again.place) == (str(error), "line 1")


# Remarks that say the same of many.


def test_of_many_remarks_that_differ_in_numbers_the_most_frequent_are_told():
    sizes = {f"scaled from 960x{700 + i} to 960x540": 1 for i in range(40)}
    sizes["scaled from 960x400 to 960x540"] = 7
    told = condensed({"no size is told": 2} | sizes)
    assert list(told)[:2] == ["no size is told", "scaled from 960x400 to 960x540"]
    assert len(told) == 5
    assert told["and 38 more like 'scaled from 960x701 to 960x540'"] == 38
    assert sum(told.values()) == 49


def test_a_few_remarks_are_told_as_they_are():
    remarks = {f"scaled from 960x{700 + i} to 960x540": i for i in range(5)} | {"another": 3}
    assert condensed(remarks) == remarks


# What is said where a part of the installation is missing is the line that adds it right here.

ROOT = Path(__file__).resolve().parent.parent.parent


@pytest.mark.parametrize("has_pip", [True, False])
def test_the_line_is_for_this_very_python(monkeypatch, has_pip):
    monkeypatch.setattr(sys, "executable", "/a b/python")
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: object() if has_pip else None)
    said = messages.install_hint("dask").partition(": ")[2]
    begin = ["/a b/python", "-m", "pip", "install"]
    if not has_pip:
        begin = ["uv", "pip", "install", "--python", "/a b/python"]
    assert shlex.split(said) == [*begin, "procc-annotator[dask]"]


def test_the_standalone_folder_says_that_it_cannot(monkeypatch):
    monkeypatch.setattr(sys, "frozen", True, raising=False)
    assert "the standalone folder goes without a Dask cluster" in messages.install_hint("dask")


def test_the_extras_are_those_of_the_project():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    optional = project["optional-dependencies"]
    assert optional.keys() == messages.EXTRAS.keys()
    base = " ".join(project["dependencies"])
    for name, (_, library) in messages.EXTRAS.items():
        assert any(one.startswith(library) for one in optional[name])
        assert library not in base


def test_messages_name_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with (
        pytest.raises(ProccError, match=r"procc-annotator\[dask\]"),
        DaskCluster("tcp://127.0.0.1:1"),
    ):
        pass
