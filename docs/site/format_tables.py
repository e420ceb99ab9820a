"""Tables of file formats, generated from the tables by which files are read."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import Files
from mkdocs.structure.pages import Page

from procc_annotator.formats.annotations.labelling_tools import TOOLS
from procc_annotator.formats.cameras.table import ROWS
from procc_annotator.formats.unread_formats import UNREAD_FORMATS, UnreadFormat


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Replace the mark of each table by the table."""
    for name, rows in TABLES.items():
        mark = f"<!-- table: {name} -->"
        if mark in markdown:
            markdown = markdown.replace(mark, "\n".join(_lines(*rows())))
    return markdown


def _lines(head: Sequence[str], *rows: Sequence[str]) -> Iterator[str]:
    for cells in (head, ["---"] * len(head), *rows):
        yield f"| {' | '.join(cells)} |"


def _cameras() -> Iterator[Sequence[str]]:
    yield "name", "format", "file", "recognised by", "world in the file"
    for row in ROWS:
        keys = f"`{row.keys}`" if row.keys else "its name"
        yield f"`{row.name}`", row.title, row.example, keys, row.world


def _annotation_tools() -> Iterator[Sequence[str]]:
    yield "`--from`", "tool", "file", "recognised by"
    for tool in TOOLS:
        signs = " or ".join(f"`{' and '.join(marks)}`" for marks in tool.marks) or "keys `(x, y)`"
        yield f"`{tool.name}`", tool.title, f"`{tool.example}`", signs


def _unread() -> Iterator[Sequence[str]]:
    yield "format", "recognised by", "what to do"
    for known in UNREAD_FORMATS:
        yield known.title, _signs(known), known.advice


def _signs(known: UnreadFormat) -> str:
    marks = (mark.decode("latin-1").strip("\x89 \n").split("\n")[0] for mark in known.marks)
    return ", ".join(f"`{one}`" for one in (*known.suffixes, *marks)) or "its numbers"


TABLES: dict[str, Callable[[], Iterator[Sequence[str]]]] = {
    "camera formats": _cameras,
    "annotation tools": _annotation_tools,
    "unread formats": _unread,
}
