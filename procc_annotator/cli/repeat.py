"""``procc-annotator repeat``: run the command of a manifest again, and compare the metrics."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from contextlib import chdir, redirect_stdout
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, Any

import typer

from procc_annotator.cli import options, outputs
from procc_annotator.cli.echo import echo
from procc_annotator.cli.main import LazyCommand
from procc_annotator.cli.manifest import DROPPED, Manifest, differences, read_manifest
from procc_annotator.errors import UsageError
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.messages import pluralize
from procc_annotator.report.tables.data_files import json_bytes

HELP = """\
MANIFEST was written by evaluate or report with --manifest. Its inputs are searched by their
relative paths in --data DIR, else next to the manifest, in the folder above, or in the current one.

The command runs again on these inputs. Listed are: another version, missing files, other contents,
files that the manifest does not list, another field, other metrics.

Exit code: 0 without differences; 1 with some; 2 if it cannot be repeated.
"""

EXAMPLE = """\
  procc-annotator evaluate sample_data sample_data/cameras/bad --manifest run.json
  procc-annotator repeat run.json --data sample_data
  procc-annotator repeat run.json --data sample_data --output differences.json
"""

_COMMANDS = ("evaluate", "report")
_LISTED = 50


def repeat(
    manifest: Annotated[
        Path, typer.Argument(metavar="MANIFEST", help="The manifest, a JSON file.")
    ],
    data: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Folder that holds all inputs.")
    ] = None,
    output: Annotated[
        Path | None, typer.Option(metavar="FILE.json", help="Write what differs.")
    ] = None,
    workers: options.Workers = None,
    dask: options.Dask = None,
) -> None:
    if output is not None:
        outputs.check_output_folder(output)
    known = read_manifest(manifest)
    if known.command not in _COMMANDS:
        raise UsageError(f"{manifest}: {known.command!r} is not repeated, only {_COMMANDS} are")
    for text in (*known.inputs, *_texts(known.options)):
        # Options hold paths as NAME=PATH, NAME:FORMAT=PATH and FILE:length=104.
        if any(Path(p).anchor or ".." in Path(p).parts for p in re.split("[=:,]", text)):
            raise UsageError(f"{manifest}: {text[:200]!r} leads out of the folder of the inputs")
    work = [f"--workers={workers}"] * (workers is not None) + [f"--dask={dask}"] * bool(dask)
    found = list(differences(known, _run(known, _root(known, manifest, data), work)))
    for line in found[:_LISTED]:
        echo(line)
    if (more := len(found) - _LISTED) > 0:
        echo(f"... and {pluralize(more, 'more difference')}")
    if not found:
        echo(f"the same: {pluralize(len(known.inputs), 'file')} and all metrics")
    if output is not None:
        write_atomic(output, json_bytes({"manifest": manifest.name, "differences": found}))
        echo(f"written: {output}")
    raise typer.Exit(1 if found else 0)


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, dict | list):
        for one in value.values() if isinstance(value, dict) else value:
            yield from _texts(one)
    else:
        yield str(value)


def _root(known: Manifest, manifest: Path, data: Path | None) -> Path:
    """Find the folder of the inputs: the one that holds most of them."""
    beside = manifest.absolute().parent
    places = [data.absolute()] if data is not None else [beside, beside.parent, Path.cwd()]
    held = {place: sum((place / name).is_file() for name in known.inputs) for place in places}
    best = max(places, key=held.__getitem__)
    if not held[best]:
        first = next(iter(known.inputs), "no input")
        raise UsageError(
            f"{first}: is not in {data}; --data names the folder that it lies in by that path"
            if data is not None
            else f"{first}: is not next to the manifest; name its folder with --data DIR"
        )
    return best


def _run(known: Manifest, root: Path, work: list[str]) -> Manifest:
    """Run the command in the folder of the inputs; its tables are not printed."""
    command = LazyCommand(known.command, "").load()
    with TemporaryDirectory(prefix="procc-repeat-") as folder:
        own = [f"--manifest={folder}/manifest.json", *work]
        if known.command == "report":
            own.append(f"--output={folder}/report.json")
        arguments = [*own, *_arguments(command, known.options)]
        with chdir(root), redirect_stdout(io.StringIO()):
            code = command.main(arguments, known.command, standalone_mode=False, obj=root)
        if code not in (0, 1):
            raise UsageError(f"{known.command} failed: nothing can be compared")
        return read_manifest(Path(folder) / "manifest.json")


def _arguments(command: Any, given: dict[str, Any]) -> Iterator[str]:
    """Spell options as they are typed; those that write files are left out."""
    if unknown := given.keys() - {one.name for one in command.params}:
        raise UsageError(f"{command.name} has no option {min(unknown)[:60]!r}")
    places: list[str] = []
    for parameter in command.params:
        values = given.get(parameter.name, []) if parameter.name not in DROPPED else []
        for value in values if isinstance(values, list) else [values]:
            if parameter.param_type_name == "argument":
                places.append(str(value))
            elif isinstance(value, bool):
                yield (parameter.opts if value else parameter.secondary_opts)[0]
            else:
                yield f"{max(parameter.opts, key=len)}={value}"
    yield from ("--", *places)
