"""The page of figures, made from the list that every table and page of the program is made from."""

from __future__ import annotations

from collections.abc import Iterator

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.table import Metric

INTRODUCTION = """\
# Every figure

What the columns of tables, files and reports mean. *Key* is the name in CSV and JSON; an
arrow says which way is better. How the figures are worked out: [metrics](metrics.md),
[is the difference real](chance.md), [steady over time](over-time.md).

| figure | key | means |
|---|---|---|
"""
ARROWS = {"higher": " ↑", "lower": " ↓", None: ""}


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the page of figures."""
    rows = "\n".join(_row(figure) for figure in _listed())
    files.append(File.generated(config, "every-figure.md", content=INTRODUCTION + rows + "\n"))
    return files


def _listed() -> Iterator[Metric]:
    """Every figure and count once, in the order of their modules."""
    met: set[Metric] = set()
    for value in (*vars(metrics).values(), *vars(metrics).values()):
        for figure in value if isinstance(value, tuple) else (value,):
            if isinstance(figure, Metric) and figure not in met:
                met.add(figure)
                yield figure


def _row(figure: Metric) -> str:
    title = f"{figure.title}, {figure.unit}" if figure.unit else figure.title
    return f"| {title}{ARROWS[figure.better]} | `{figure.key}` | {figure.definition} |"
