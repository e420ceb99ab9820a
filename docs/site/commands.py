"""The page of the commands, generated from the commands."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

from procc_annotator.cli.main import COMMANDS

PROGRAM = "procc-annotator"
INTRODUCTION = """\
# Commands

The text of `procc-annotator COMMAND --help`. Commands read folders and archives, list each file
that they cannot read in one line, and exit with 0, 1 (some files were unreadable), 2 (nothing to
do) or 3 (a bug).
"""


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the page of the commands."""
    files.append(File.generated(config, "reference/commands.md", content=commands_page()))
    return files


def commands_page() -> str:
    """Every command that its list shows: summary, usage, help text, arguments and options."""
    shown = [command for command in COMMANDS if not command.hidden]
    table = ["| command | does |", "|---|---|"]
    table += [f"| [`{c.name}`](#{c.name}) | {escaped(str(c.help))} |" for c in shown]
    parts = [INTRODUCTION, "\n".join(table)]
    for command in shown:
        parts += _sections(command.load(), str(command.name), level=2)
    return "\n\n".join(parts) + "\n"


def _sections(command: Any, name: str, level: int) -> Iterator[str]:
    """The section of a command; of a command of several, theirs below it."""
    context = command.context_class(command, info_name=f"{PROGRAM} {name}")
    yield f"{'#' * level} {name}"
    yield f"```text\n{' '.join([PROGRAM, name, *command.collect_usage_pieces(context)])}\n```"
    yield from _paragraphs(command.help or "")
    yield from _paragraphs(command.epilog or "")
    rows = [_row(p, context) for p in command.params]
    listed = [row for row in rows if row is not None]
    if listed:
        yield "\n".join(["| argument or option | means |", "|---|---|", *listed])
    for child in getattr(command, "commands", {}).values():
        yield from _sections(child, f"{name} {child.name}", level + 1)


def _row(parameter: Any, context: Any) -> str | None:
    record = parameter.get_help_record(context)
    if record is None or "--help" in record[0]:
        return None
    names, text = record
    return f"| `{names.replace('|', chr(92) + '|')}` | {escaped(text)} |"


def _paragraphs(text: str) -> Iterator[str]:
    r"""Paragraphs of a help text; what follows ``\b`` keeps its lines, so it is code."""
    for paragraph in re.split(r"\n\s*\n", text.strip()):
        if paragraph.startswith("\b"):
            lines = paragraph.lstrip("\b").strip("\n").splitlines()
            indent = min(len(line) - len(line.lstrip()) for line in lines)
            yield "```text\n" + "\n".join(line[indent:] for line in lines) + "\n```"
        elif paragraph:
            yield escaped(paragraph)


def escaped(text: str) -> str:
    """Plain text as Markdown that shows it as it is, also in a table."""
    return re.sub(r"([\\`*_<>|\[\]])", r"\\\1", " ".join(text.split()))
