"""Options of intervals, clusters, annotation noise, power and temporal metrics."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, cast

import typer

from procc_annotator.batch.frame_sums import ClickNoise
from procc_annotator.batch.grouping import (
    NONE,
    SHOT,
    Clusters,
    FrameOrder,
    Tags,
    check_by,
    clusters_of,
)
from procc_annotator.batch.strata import DERIVED
from procc_annotator.cli.outputs import output_files
from procc_annotator.dataset.layout import FRAMES_FILE, folder_of_dataset
from procc_annotator.errors import InputError, UsageError
from procc_annotator.formats.file_source import read_file
from procc_annotator.formats.point_tables import is_number
from procc_annotator.formats.strict_json import decode_as
from procc_annotator.metrics.statistics.intervals import (
    INTERVAL_METHODS,
    BootstrapSettings,
    IntervalMethodName,
    noise_from_median_distance,
)
from procc_annotator.report.scores.inference import InferenceSettings

if TYPE_CHECKING:
    from procc_annotator.cli.temporal import TemporalRequest

_ADVICE = "expected what `agree A B --output FILE.json` writes"


def noise_from(path: Path, seed: int) -> ClickNoise:
    """One annotator's standard deviation, from the median distance of every two; InputError for a
    file that is no agreement, or has no distance."""
    content = decode_as(read_file(path), object, "JSON", path=path)
    size, floor = _member(content, "size"), _member(content, "summary", "noise_floor")
    if not (isinstance(size, list) and len(size) == 2 and all(type(n) is int for n in size)):
        raise InputError(path, "has no size of pictures", place="size", advice=_ADVICE)
    if min(size) < 2 or not isinstance(floor, Mapping):
        raise InputError(path, "is no agreement", place="summary.noise_floor", advice=_ADVICE)
    median = floor.get("median")
    if not isinstance(median, int | float) or not math.isfinite(median) or median <= 0:
        raise InputError(
            path,
            f"has a median distance of {median}, expected one above 0 px",
            place="summary.noise_floor.median",
            advice="compare annotators who clicked the same elements each for themselves",
        )
    return ClickNoise(
        noise_from_median_distance(median), seed=seed, of_size=(size[0], size[1]), told_by=path.name
    )


def _member(content: Any, *keys: str) -> Any:
    for key in keys:
        content = content.get(key) if isinstance(content, Mapping) else None
    return content


# What holds if not stated otherwise: method, sets drawn, seed.
USUAL = USUAL_METHOD, USUAL_DRAWS, USUAL_SEED = "t", 10_000, 1
_LEAST_NOISE, _MOST_NOISE = 0.01, 100.0  # px


def _known_method(text: str) -> str:
    if text not in INTERVAL_METHODS:
        raise typer.BadParameter(f"{text!r} is not one of {', '.join(INTERVAL_METHODS)}")
    return text


TagsFile = Annotated[
    Path | None,
    typer.Option(
        metavar="FILE.csv",
        help="Tags of frames: a column 'frame' and one or more others (and 'set', if there are"
        " several).",
    ),
]
Cluster = Annotated[
    str | None,
    typer.Option(
        metavar="TAG|shot|none",
        help="Which frames are alike, for intervals: those of one value of a tag, of one shot (by"
        " frames.csv or names), or none.  [default: shots, where there are several]",
    ),
]
Seed = Annotated[int, typer.Option(min=0, metavar="N", help="Random seed of the resamples.")]

OverTime = Annotated[
    bool,
    typer.Option(
        "--over-time",
        help="Also how steady the cameras are over the shots of the set: jitter, jumps, outages,"
        " cameras that are some frames late.",
    ),
]
Shots = Annotated[
    Path | None,
    typer.Option(
        "--shots",
        metavar="FILE.csv",
        help="Which frames follow each other: columns 'frame', 'shot' and perhaps 'number'."
        "  [default: frames.csv of the dataset, the shots of tracked cameras, else by the names of"
        " the frames]",
    ),
]


def temporal_request(
    wanted: bool, shots: Path | None, pictures: Path | None = None, output: list[Path] | None = None
) -> TemporalRequest | None:
    """The request for temporal metrics, if they are wanted; UsageError for a file that cannot be
    written, or options without --over-time."""
    if not wanted:
        if shots or pictures or output:
            raise UsageError("--shots, --pictures and --over-time-output need --over-time")
        return None
    from procc_annotator.cli.temporal import TemporalRequest  # loads decoding and motion

    return TemporalRequest(shots, pictures, output_files(output))


@dataclass(frozen=True)
class ClusterOptions:
    """Which frames are alike, as commands without ``--by`` ask for it."""

    tags: TagsFile = None
    cluster: Cluster = None

    def of(self, datasets: Iterable[Path]) -> Callable[[Sequence[str]], Clusters]:
        """Return what finds the clusters of frames, see `clustering`."""
        return clustering(self.tags, self.cluster, datasets)


@dataclass(frozen=True)
class IntervalOptions:
    """Options of confidence intervals and tests."""

    cluster: Cluster = None
    interval_method: Annotated[
        str,
        typer.Option(
            "--interval-method",
            metavar="t|percentile|bca",
            callback=_known_method,
            help="How intervals are found: t: jackknife of clusters; percentile, bca: from sets"
            " drawn.",
        ),
    ] = USUAL_METHOD
    power: Annotated[
        bool,
        typer.Option(
            "--power",
            help="Also the number of frames needed to detect differences of 1, 2 and 5 points of"
            " JaC.",
        ),
    ] = False
    click_noise: Annotated[
        str | None,
        typer.Option(
            "--annotation-noise",
            metavar="PX|FILE.json",
            help="Also what clicks leave open: everything again and again with every point moved"
            " by so much (standard deviation, px of the evaluation size), or by the JSON of agree.",
        ),
    ] = None
    draws: Annotated[
        int,
        typer.Option(
            "--resamples",
            min=100,
            max=1_000_000,
            metavar="N",
            help="Number of bootstrap resamples.",
        ),
    ] = USUAL_DRAWS

    def terms(
        self,
        tags: Tags | None,
        annotations: Mapping[str, Path],
        by: Sequence[str],
        seed: int,
        shots: Path | None,
    ) -> InferenceSettings:
        """Return the settings of inference, with differences by ``by``, and shots by a table of
        frames or by those of the sets. Raises as `clustering`."""
        return InferenceSettings(
            cluster_of(self.cluster, tags),
            tags,
            orders_by_set(annotations, shots),
            BootstrapSettings(self.draws, seed),
            cast(IntervalMethodName, self.interval_method),
            self.power,
            None if self.click_noise is None else annotation_noise(self.click_noise, seed),
            tuple(by),
        )


def cluster_of(name: str | None, tags: Tags | None) -> str | None:
    """Return what to cluster by; UsageError if there is no such tag."""
    columns = () if tags is None else tags.columns
    if name not in (None, SHOT, NONE, *columns):
        there = ", ".join((SHOT, NONE, *columns))
        more = "" if tags else "; tags come from --tags FILE"
        raise UsageError(f"cannot cluster by {name!r}: there is {there}{more}")
    return name


def clustering(
    tags: Path | None, by: str | None, datasets: Iterable[Path]
) -> Callable[[Sequence[str]], Clusters]:
    """Return what finds the clusters of frames: by a tag, ``shot`` or ``none``; None for shots if
    there are any.

    The first dataset that has a table of frames gives the shots; else names do. Raises UsageError
    for no such tag, InputError for a file that cannot be used."""
    read = None if tags is None else Tags.read(tags)
    cluster = cluster_of(by, read)
    values = {} if read is None else read.values(cluster, "")
    orders = orders_by_set({str(place): place for place in datasets}, None)
    return lambda frames: clusters_of(frames, cluster, values, next(iter(orders.values()), None))


def groups_asked(
    by: Sequence[str] | None, tags: Tags | None, cluster: str | None
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return what ``--by`` asks for: tags and the model, and what annotations and cameras say.

    Without it every tag is meant but the one that frames are clustered by. UsageError if there is
    no such tag."""
    columns = () if tags is None else tags.columns
    if by is None:
        by = [name for name in columns if name != cluster]
    derived = tuple(n for n in dict.fromkeys(by) if n in DERIVED and n not in columns)
    return check_by([name for name in by if name not in derived], tags, DERIVED), derived


def orders_by_set(annotations: Mapping[str, Path], shots: Path | None) -> dict[str, FrameOrder]:
    """Set -> its table of frames: the one given, or that of its dataset, if it has one; InputError
    for a table that cannot be used."""
    found = {}
    for of_set, path in annotations.items():
        folder = folder_of_dataset(path)
        table = shots or (folder / FRAMES_FILE if folder is not None else None)
        if table is not None and (shots or table.is_file()):
            found[of_set] = FrameOrder.read(table)
    return found


def noise_file(text: str | None) -> Path | None:
    """The file that gives the noise of clicks, where the option names one."""
    if text is None or is_number(text):
        return None
    return Path(text)


def annotation_noise(text: str, seed: int) -> ClickNoise:
    """The noise that the option names; UsageError for a number out of range, InputError for a file
    that is no agreement."""
    file = noise_file(text)
    if file is not None:
        return noise_from(file, seed)
    if not _LEAST_NOISE <= float(text) <= _MOST_NOISE:
        raise UsageError(
            f"--annotation-noise {text}: expected {_LEAST_NOISE:g} to {_MOST_NOISE:g} px,"
            " or the JSON of agree"
        )
    return ClickNoise(float(text), seed=seed)
