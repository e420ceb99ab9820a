"""Field files of the user's own: read anew for a dataset, found for it, compared with classes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from procc_annotator.dataset.dataset_field import stored_field_source
from procc_annotator.dataset.diagnostics import Mismatch, mismatch_of
from procc_annotator.errors import FieldError
from procc_annotator.field.load import is_builtin_field, load_field, with_dimensions, with_lines
from procc_annotator.field.model import Field


def mismatch_among(
    classes: frozenset[str], field: Field, own_files: Sequence[Path]
) -> Mismatch | None:
    """Return what is to say of classes on a field, where it does not know all of them; reads the
    files."""
    if not any(not field.knows(name) for name in classes):
        return None
    more = []
    for path in own_files:
        try:
            more.append(load_field(path))
        except FieldError:
            continue  # it may be gone, or half written: then it fits nothing
    return mismatch_of(classes, field, more)


def read_for_dataset(
    path: Path,
    dimensions_of: Callable[[Field], Mapping[str, float]],
    lines_of: Callable[[Field], str],
) -> tuple[Field | None, str]:
    """The field of a file with the dataset's dimensions as far as it still has them, its lines
    where the dataset has them; or why not."""
    try:
        nominal = load_field(path)
        dimensions = dimensions_of(nominal)
        fits = {
            d.name: dimensions[d.name]
            for d in nominal.dimensions
            if d.name in dimensions and d.minimum <= dimensions[d.name] <= d.maximum
        }
        sized = with_dimensions(nominal, fits) if fits else nominal
        return with_lines(sized, lines_of(nominal)), ""
    except FieldError as error:
        return None, str(error)


def own_source(field: Field) -> Path | None:
    """The file of the user's own that a field was read from; None for a shipped one."""
    return field.source if field.source is not None and not is_builtin_field(field.source) else None


def field_file_of(folder: Path, settings: Mapping[str, str]) -> Path | None:
    """The file of the user's own that a dataset names."""
    try:
        source = stored_field_source(folder, settings)
    except FieldError:
        return None
    return source if isinstance(source, Path) else None
