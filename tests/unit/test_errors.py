"""The texts of errors: one line, names as they are, nothing that commands a terminal."""

from __future__ import annotations

import pickle

from procc_annotator.errors import AnnotationError, InputError, SaveError


def test_names_stay_as_they_are() -> None:
    error = AnnotationError("/data/two  spaces/é.json", "no such class", place='"A  B"')
    assert str(error) == '/data/two  spaces/é.json: "A  B": no such class'


def test_control_characters_of_a_name_are_shown_and_not_obeyed() -> None:
    for error in (InputError("a\x1b[2Jb\nc.json", "unreadable"), SaveError("a\x1b[2Jb\nc.json")):
        assert str(error).startswith(r"a\x1b[2Jb\nc.json")


def test_explanations_of_several_lines_become_one() -> None:
    assert str(InputError("f.toml", "wrong value\n  at line 3")) == "f.toml: wrong value at line 3"


def test_errors_come_back_whole_from_a_worker_process() -> None:
    error = InputError("a\nb", "wrong", place="line 1", advice="mend it")
    again = pickle.loads(pickle.dumps(error))  # noqa: S301 - its own bytes
    assert (str(again), again.place) == (str(error), "line 1")
