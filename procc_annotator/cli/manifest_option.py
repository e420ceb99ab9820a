"""``--manifest``: write what a run was made with, so that ``repeat`` can run it again."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated, Any

import typer

from procc_annotator.cli import outputs
from procc_annotator.cli.inference_options import noise_file
from procc_annotator.cli.options import named_field
from procc_annotator.dataset import layout as folders
from procc_annotator.field.load import field_fingerprint
from procc_annotator.formats.annotations.label_map import LABELS_FILE
from procc_annotator.formats.atomic import write_atomic
from procc_annotator.formats.file_listing import list_annotations
from procc_annotator.formats.file_source import read_file
from procc_annotator.formats.landmark_file import LANDMARKS_FILE
from procc_annotator.formats.strict_json import decode_as
from procc_annotator.report.manifest import Manifest, hashes, of_sets, relative
from procc_annotator.report.scores.scoring import EvaluationRequest
from procc_annotator.report.tables.data_files import json_bytes

# Options that write files or say who does the work: no part of what is repeated.
DROPPED = frozenset({"output", "over_time_output", "manifest", "workers", "dask"})
_OF_DATASET = (
    folders.FIELD_FILE, folders.FRAMES_FILE, folders.STADIUMS_FILE, folders.VIEWS_FILE,
    LABELS_FILE, LANDMARKS_FILE,
)  # fmt: skip

ManifestFile = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE.json",
        show_default=False,
        help="Write options, versions, the SHA-256 of every input file and the metrics, so that"
        " `procc-annotator repeat` can run it again and compare.",
    ),
]


@dataclass(frozen=True)
class ManifestOfRun:
    """The manifest of a run in progress; the command writes its metrics to a temporary file."""

    path: Path
    context: typer.Context
    metrics: Path

    @classmethod
    def of(cls, context: typer.Context, path: Path | None) -> ManifestOfRun | None:
        """Prepare the file that was asked for, if one was.

        Raises:
            UsageError, SaveError: the file cannot be written there.
        """
        if path is None:
            return None
        outputs.check_output_folder(path)
        folder = context.with_resource(TemporaryDirectory(prefix="procc-manifest-"))
        return cls(path, context, Path(folder) / "metrics.json")

    def write(
        self, runs: Sequence[EvaluationRequest], over_time: Mapping[str, Any] | None = None
    ) -> None:
        """Write the file; the inputs are still open.

        Args:
            over_time: metrics that the temporary file does not hold.

        Raises:
            InputError: the metrics were not written. SaveError: the manifest cannot be written.
        """
        metrics = decode_as(read_file(self.metrics), dict[str, Any], "metrics", path=self.path)
        if over_time:
            own = json_bytes(over_time)
            metrics["over_time"] = decode_as(own, dict[str, Any], "metrics", path=self.path)
        files = [*self._named_files(), *(path for one in runs for path in _files(one))]
        root = self.context.obj or Path(os.path.commonpath([file.parent for file in files]))
        manifest = Manifest(
            command=str(self.context.info_name),
            options=self._options(root),
            inputs=hashes(files, root),
            fields={one.set_name: field_fingerprint(one.setup.field) for one in runs},
            metrics=of_sets(metrics),
        )
        write_atomic(self.path, manifest.encoded())

    def _typed(self) -> Iterator[tuple[str, Any]]:
        for parameter in self.context.command.params:
            name = str(parameter.name)
            source = self.context.get_parameter_source(name)
            if source is not None and source.name == "COMMANDLINE" and name not in DROPPED:
                value = self.context.params[name]
                yield name, Path(value) if parameter.type.name == "path" else value

    def _named_files(self) -> Iterator[Path]:
        paths = (_path_in(name, value) for name, value in self._typed())
        yield from (path.absolute() for path in paths if path is not None and path.is_file())

    def _options(self, root: Path) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for name, value in self._typed():
            if name in ("sources", "cameras", "sets") and isinstance(value, list | tuple):
                parts = [re.fullmatch("([^=]*=)?(.*)", one, re.DOTALL) for one in value]
                found[name] = [f"{m[1] or ''}{relative(Path(m[2]), root)}" for m in parts if m]
            elif (path := _path_in(name, value)) is not None:
                found[name] = str(value).replace(str(path), relative(path, root), 1)
            else:
                found[name] = value
        return found


def _path_in(name: str, value: Any) -> Path | None:
    """Return the path that an option holds, if it does."""
    if isinstance(value, Path):
        return value
    if name == "field":
        file = Path(named_field(value)[0])
        return file if file.is_file() else None
    return noise_file(value) if name == "click_noise" else None


def _files(one: EvaluationRequest) -> Iterator[Path]:
    """Yield the files that an evaluation reads; an archive is one."""
    place, cameras = one.annotations.path.absolute(), one.cameras.path.absolute()
    if place.is_dir():
        names = one.annotations.decoded or list_annotations(one.annotations).values()
        yield from (place / name for name in names)
    else:
        yield place
    if cameras.is_dir():
        yield from (Path(file).absolute() for file in one.cameras.files())
        yield from (cameras / name for name in one.cameras.beside())
    else:
        yield cameras
    if (dataset := folders.folder_of_dataset(place)) is not None:
        yield from (path for name in _OF_DATASET if (path := dataset / name).is_file())
