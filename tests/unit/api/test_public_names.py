"""What the package offers other programs: listed once, documented, typed, and nothing private."""

from __future__ import annotations

import ast
import inspect
import re
import subprocess
import sys
import typing
from collections.abc import Iterator
from pathlib import Path

import pytest

import procc_annotator

PACKAGE = Path(procc_annotator.__file__).parent
PUBLIC = [name for name in procc_annotator.__all__ if name != "__version__"]
FUNCTIONS = [n for n in PUBLIC if inspect.isfunction(getattr(procc_annotator, n))]
CLASSES = [n for n in PUBLIC if inspect.isclass(getattr(procc_annotator, n))]


def test_every_name_is_there_and_none_else() -> None:
    assert sorted([*FUNCTIONS, *CLASSES]) == PUBLIC
    assert dir(procc_annotator) == sorted(procc_annotator.__all__)
    with pytest.raises(AttributeError, match="no attribute 'fit_cameras'"):
        procc_annotator.fit_cameras  # noqa: B018


def test_type_checkers_are_told_the_same_names_from_the_same_places() -> None:
    tree = ast.parse((PACKAGE / "__init__.py").read_text())
    block = next(node for node in tree.body if isinstance(node, ast.If))
    told = {
        alias.name: node.module
        for node in block.body
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    assert sorted(told) == PUBLIC
    for name, module in told.items():
        assert getattr(procc_annotator, name).__module__ == module, name


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_function_says_what_it_takes_gives_and_raises(name) -> None:
    function = getattr(procc_annotator, name)
    text = inspect.getdoc(function) or ""
    parts = re.split(r"^(Args|Returns|Raises):$", text, flags=re.M)
    sections = dict(zip(parts[1::2], parts[2::2], strict=True))
    parameters = inspect.signature(function).parameters
    for parameter in parameters:
        assert re.search(rf"(^|[ *,]){parameter}[:,]", sections["Args"], re.M), parameter
    if parameters:
        assert sections["Raises"].strip()
    assert "Returns" in sections or text.splitlines()[0].endswith("."), name


@pytest.mark.parametrize("name", CLASSES)
def test_a_class_says_what_it_holds(name) -> None:
    kind = getattr(procc_annotator, name)
    text = inspect.getdoc(kind) or ""
    assert text.strip(), name
    assert not text.startswith(f"{name}("), name  # what dataclasses write themselves
    for attribute, value in vars(kind).items():
        method = inspect.isfunction(value) or isinstance(value, property | classmethod)
        if not attribute.startswith("_") and method:
            told = inspect.getdoc(getattr(kind, attribute)) or inspect.getdoc(value)
            assert told, f"{name}.{attribute}"


def test_what_is_returned_is_public_itself() -> None:
    """Nobody has to import a private module to say what a function takes or gives."""
    for name in FUNCTIONS:
        for kind in _kinds(typing.get_type_hints(getattr(procc_annotator, name))):
            assert kind.__name__ in PUBLIC, f"{name}: {kind}"


def _kinds(hints: object) -> Iterator[type]:
    if isinstance(hints, dict):
        for hint in hints.values():
            yield from _kinds(hint)
    elif isinstance(hints, type) and hints.__module__.startswith("procc_annotator."):
        yield hints
    for inner in typing.get_args(hints):
        yield from _kinds(list(inner) if isinstance(inner, tuple) else inner)


def test_type_checkers_know_the_package() -> None:
    assert (PACKAGE / "py.typed").is_file()


def test_importing_the_package_is_next_to_nothing() -> None:
    """Two small modules of its own, and of the standard library what most programs load."""
    program = (
        "import sys; b = set(sys.modules); import procc_annotator; print(*set(sys.modules) - b)"
    )
    loaded = subprocess.run(
        [sys.executable, "-S", "-c", program],
        capture_output=True, text=True, check=True, cwd=PACKAGE.parent,
    ).stdout.split()  # fmt: skip
    own = {name for name in loaded if name.startswith("procc_annotator")}
    assert own == {"procc_annotator", "procc_annotator.version"}
    others = {name.partition(".")[0] for name in loaded} - {"procc_annotator"}
    assert others <= sys.stdlib_module_names
    assert not others & {"asyncio", "inspect", "email", "http", "json", "subprocess", "sqlite3"}
