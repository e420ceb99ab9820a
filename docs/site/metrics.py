"""The page of metrics, generated from the table that score files and reports use."""

from __future__ import annotations

from collections.abc import Iterator

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

from procc_annotator.report.tables import metrics
from procc_annotator.report.tables.table import Metric

INTRODUCTION = """\
# Metrics

Columns of tables, score files and reports. *Key* is the name in CSV and JSON; an arrow says whether
higher or lower is better. Definitions: [JaC and the two protocols](../explanation/metric.md),
[confidence intervals and tests](../explanation/statistics.md), [metrics over
time](../explanation/temporal.md).

| metric | key | definition |
|---|---|---|
"""
ARROWS = {"higher": " ↑", "lower": " ↓", None: ""}


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the page of metrics."""
    rows = "\n".join(_row(figure) for figure in _listed())
    files.append(File.generated(config, "reference/metrics.md", content=INTRODUCTION + rows + "\n"))
    return files


def _listed() -> Iterator[Metric]:
    """Return each metric once, in the order of the module."""
    met: set[Metric] = set()
    for value in vars(metrics).values():
        for figure in value if isinstance(value, tuple) else (value,):
            if isinstance(figure, Metric) and figure not in met:
                met.add(figure)
                yield figure


def _row(figure: Metric) -> str:
    title = f"{figure.title}, {figure.unit}" if figure.unit else figure.title
    return f"| {title}{ARROWS[figure.better]} | `{figure.key}` | {figure.definition} |"
