"""The frames of a study, written apart for each annotator, and the plan for whoever runs it."""

from __future__ import annotations

import os
import shutil
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path

from procc_annotator.errors import UsageError
from procc_annotator.io.atomic import make_folder, replacing, write_atomic
from procc_annotator.io.source import read_if_there
from procc_annotator.regular_file import open_regular
from procc_annotator.report.sheet.as_csv import csv_bytes
from procc_annotator.report.sheet.sheet import Column, Row, Sheet, whole
from procc_annotator.session.runs.assignments import Assigned, StudyTerms

PLAN_FILE = "plan.csv"

Progress = Callable[[Iterable[Assigned], int, str], Iterator[Assigned]]


def write_assignments(
    assigned: Sequence[Assigned],
    pictures: Mapping[str, Path],
    own_files: Mapping[str, Path],
    out: Path,
    *,
    progress: Progress = lambda items, _total, _what: iter(items),
) -> None:
    """Write a dataset for each annotator, in a folder of that name, and the plan beside them.

    A picture is linked where the file system can, else copied: a link costs no space. The plan is
    written first: what a run that was stopped has given out is kept, and the rest is added, if the
    same is asked for again.

    Args:
        pictures: frame -> its picture.
        own_files: what else an annotator's dataset needs, such as its field: name -> file.
        out: a folder.

    Raises:
        UsageError: a folder of an annotator is there already, without this very plan; an annotator
            who would get one of the folders of a tree alone, so that frames would lose its name.
        SaveError: something cannot be written.
    """
    who = dict.fromkeys(one.annotator for one in assigned)
    plan = csv_bytes(plan_sheet(assigned))
    begun = read_if_there(out / PLAN_FILE) == plan
    for name in who:
        if (out / name).exists() and not begun:
            raise UsageError(f"{out / name}: exists already, choose another folder")
        _check_folders(name, [one.frame for one in assigned if one.annotator == name])
    make_folder(out)
    write_atomic(out / PLAN_FILE, plan)
    for name in who:
        make_folder(out / name)
        for called, file in own_files.items():
            _give(file, out / name / called, link=False)
    for one in progress(assigned, len(assigned), "giving out"):
        picture = pictures[one.frame]
        target = out / one.annotator / f"{one.frame}{picture.suffix}"
        make_folder(target.parent)
        _give(picture, target, link=True)


def plan_sheet(assigned: Sequence[Assigned]) -> Sheet:
    """Who gets which frame, and why: for whoever runs the study alone."""
    columns = Column("annotator"), Column("frame"), Column("why")
    rows = tuple((one.annotator, one.frame, one.why) for one in assigned)
    return Sheet("plan", "Plan", columns, rows)


def counts_sheet(
    assigned: Sequence[Assigned], parts: Mapping[str, str], terms: StudyTerms
) -> Sheet:
    """How many frames everybody gets, and of how many parts."""
    why = Counter((one.annotator, one.why) for one in assigned)
    columns = [
        Column("annotator", "annotator"), whole("frames"), whole("alone"), whole("overlap"),
        whole("gold"),
    ]  # fmt: skip
    if parts:
        columns += [
            whole("parts"), whole("fewest", "fewest of a part"), whole("most", "most of a part"),
        ]  # fmt: skip
    rows: list[Row] = []
    every = {parts.get(one.frame, "") for one in assigned if one.why != "gold"}
    for name in terms.annotators:
        own = Counter(
            parts.get(one.frame, "")
            for one in assigned
            if one.annotator == name and one.why != "gold"
        )
        counts = [own[part] for part in every] or [0]
        kinds = [why[name, kind] for kind in ("alone", "overlap", "gold")]
        spread = (len(own), min(counts), max(counts)) if parts else ()
        rows.append((name, sum(kinds), *kinds, *spread))
    return Sheet("assignments", "Assignments", tuple(columns), tuple(rows))


def _check_folders(annotator: str, frames: Sequence[str]) -> None:
    """Pictures of a single folder are called as if it were not there."""
    folders = {frame.rpartition("/")[0] for frame in frames}
    if len(folders) == 1 and folders != {""}:
        raise UsageError(
            f"{annotator} would get frames of {folders.pop()} alone, which would then be called"
            " otherwise than in the dataset: let more frames overlap, or assign that folder for"
            " itself"
        )


def _give(source: Path, target: Path, *, link: bool) -> None:
    if target.exists():
        return
    if link:
        with suppress(OSError):  # another disk, or a file system without links
            os.link(os.path.realpath(source), target)  # never a link, which leads elsewhere there
            return
    with replacing(target) as stream, open_regular(source) as content:
        shutil.copyfileobj(content, stream)
