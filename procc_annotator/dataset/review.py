"""Stored label-check results of a frame, ignored findings, and blind-mode commits."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from enum import StrEnum
from hashlib import blake2b

import msgspec
import numpy as np

from procc_annotator.annotation import FrameAnnotation, Polyline
from procc_annotator.calibration.fitting import fit_camera
from procc_annotator.calibration.label_check.check import (
    FittedPosition,
    OppositeSideFrame,
    add_line_evidence,
    check_labels,
    check_without_camera,
    fitted_position,
    opposite_side_finding,
)
from procc_annotator.calibration.label_check.evidence import LineEvidence
from procc_annotator.calibration.label_check.finding import Finding, Rule, Severity
from procc_annotator.calibration.result import FitResult
from procc_annotator.field.model import Field


@dataclass(frozen=True, slots=True)
class StoredFinding:
    """A finding of a frame, with what distinguishes it from others.

    Attributes:
        key: of what was found in which points: the same until one of those elements changes.
        places: (class, index of the point) its marks stand at, one for each annotated element.
    """

    finding: Finding
    key: str
    places: tuple[tuple[str, int], ...]

    def holds_for(self, annotation: FrameAnnotation) -> bool:
        """Return whether its elements have the points that it was found in."""
        return _key(self.finding, annotation) == self.key


@dataclass(frozen=True, slots=True)
class FrameCheck:
    """Findings of the label check in one annotation.

    Attributes:
        content: of the annotation, see `content_of`; empty for what is left of a check after an
            edit.
        found: the surest first.
        fitted: whether the rules that need a camera were examined too.
        size: (width, height) px of the picture that distances are reported in.
        failure: why there was no camera, although one was asked for; empty otherwise.
        elements: number of annotated classes.
        with_paint: whether the picture was examined.
        stand: where the fitted camera stands; None without one.
    """

    content: str
    found: tuple[StoredFinding, ...]
    fitted: bool
    size: tuple[int, int]
    failure: str = ""
    elements: int = 0
    with_paint: bool = False
    stand: FittedPosition | None = None


def content_of(annotation: FrameAnnotation, classes: Iterable[str] | None = None) -> str:
    """A short text that is the same as long as all points (of these classes) are."""
    wanted = None if classes is None else frozenset(classes)
    digest = blake2b(digest_size=12)
    for polyline in sorted(annotation.polylines, key=lambda p: p.class_name):
        if polyline.points and (wanted is None or polyline.class_name in wanted):
            digest.update(repr((polyline.class_name, len(polyline.points))).encode())
            digest.update(np.array([p[:2] for p in polyline.points], dtype=np.float64).tobytes())
    return digest.hexdigest()


def store_check(
    annotation: FrameAnnotation,
    findings: Sequence[Finding],
    fit: FitResult,
    *,
    fitted: bool = True,
    with_paint: bool = False,
) -> FrameCheck:
    """Return what to keep of a check of an annotation: what was found, the surest first, and the
    camera fitted to it, or why that failed.

    Args:
        fitted: False if the camera was not asked for.
        with_paint: whether the picture was examined.
    """
    found = tuple(_found(finding, annotation, fit) for finding in findings)
    failure = (fit.failure or "") if fitted else ""
    count = len(annotation.annotated)
    content = content_of(annotation)
    stand = fitted_position(fit) if fitted else None
    return FrameCheck(content, found, fitted, fit.size, failure, count, with_paint, stand)


def check_with_camera_side(
    checked: FrameCheck, annotation: FrameAnnotation, field: Field, other: OppositeSideFrame
) -> FrameCheck:
    """A check of an annotation with what a set's cameras say of the side that this frame's stands
    on."""
    finding = opposite_side_finding(annotation, field, other)
    return checked if finding is None else with_set_findings(checked, _found(finding, annotation))


def with_set_findings(checked: FrameCheck, found: StoredFinding) -> FrameCheck:
    """A check with what only the set could say; of a frame that is known to be the wrong way round
    it says nothing new."""
    if any(known.finding.rule is Rule.REFLECTED for known in checked.found):
        return checked
    at = sum(known.finding.severity.rank < found.finding.severity.rank for known in checked.found)
    return replace(checked, found=(*checked.found[:at], found, *checked.found[at:]))


def still_valid(checked: FrameCheck, annotation: FrameAnnotation) -> FrameCheck:
    """Return what still holds of a check once the annotation is another one: what was found in
    elements that did not change. It passes for the check of no annotation."""
    kept = tuple(f for f in checked.found if f.holds_for(annotation))
    return replace(checked, content="", found=kept)


def check_frame(
    annotation: FrameAnnotation,
    field: Field,
    *,
    size: tuple[int, int],
    model: str = "R",
    paint: Mapping[str, LineEvidence] | None = None,
    fit: FitResult | None = None,
) -> FrameCheck:
    """Fit a camera to a frame's annotation and check its labels; safe from any thread.

    Args:
        size: (width, height) px of the picture.
        model: see `fit_camera`.
        paint: class -> what the picture shows along it; None where no one looked.
        fit: its fit, where that was made together with others.
    """
    if fit is None:
        fit = fit_camera(annotation, field, model=model, size=size)
    found = check_labels(annotation, field, size=size, fit=fit)
    if paint is not None:
        found = add_line_evidence(found, annotation, field, size=size, fit=fit, paint=paint)
    return store_check(annotation, found, fit, with_paint=paint is not None)


def check_without_fit(
    annotation: FrameAnnotation,
    field: Field,
    *,
    size: tuple[int, int],
    paint: Mapping[str, LineEvidence] | None = None,
) -> FrameCheck:
    """Check a frame's labels by the rules that need no camera; no camera is fitted, so that what is
    found may be shown where a camera may not. Safe from any thread."""
    none = FitResult("", size, None, failure="not asked for")
    findings = check_without_camera(annotation, field, size=size)
    if paint is not None:
        findings = add_line_evidence(findings, annotation, field, size=size, fit=none, paint=paint)
    return store_check(annotation, findings, none, fitted=False, with_paint=paint is not None)


def worst_severity(found: Iterable[StoredFinding]) -> Severity | None:
    """The surest of some findings; None for none."""
    return min((f.finding.severity for f in found), key=lambda s: s.rank, default=None)


def _found(
    finding: Finding, annotation: FrameAnnotation, fit: FitResult | None = None
) -> StoredFinding:
    return StoredFinding(finding, _key(finding, annotation), _places(finding, annotation, fit))


def _key(finding: Finding, annotation: FrameAnnotation) -> str:
    said = repr((finding.rule.value, finding.elements, finding.point)).encode()
    points = content_of(annotation, finding.elements).encode()
    return blake2b(said + points, digest_size=8).hexdigest()


def _places(
    finding: Finding, annotation: FrameAnnotation, fit: FitResult | None
) -> tuple[tuple[str, int], ...]:
    places = []
    for name in dict.fromkeys(finding.elements):
        polyline = annotation.get(name)
        if polyline is None or not polyline.points:
            continue
        index = finding.point if name == finding.elements[0] else None
        if index is None or not 0 <= index < len(polyline.points):
            index = _worst_point(polyline, fit)
        places.append((name, index))
    return tuple(places)


def _worst_point(polyline: Polyline, fit: FitResult | None) -> int:
    """The point farthest from the fitted camera's element; without a camera the middle one. Points
    next to the picture, where no one looks, only if there are no others."""
    points = polyline.points
    elements = () if fit is None else fit.elements
    residual = next((e for e in elements if e.name == polyline.class_name), None)
    distances = {}
    if fit is not None and residual is not None:
        distances = residual.distances_of(polyline, fit.size)
    candidates = list(distances) or list(range(len(points)))
    inside = [i for i in candidates if 0 <= points[i].u <= 1 and 0 <= points[i].v <= 1]
    seen = inside or candidates
    return max(seen, key=distances.__getitem__) if distances else seen[len(seen) // 2]


def by_severity(found: Iterable[StoredFinding]) -> Mapping[Severity, int]:
    """Return how many of some findings there are of each severity."""
    counted = Counter(f.finding.severity for f in found)
    return {severity: counted[severity] for severity in Severity}


# One setting a finding, so that two windows that ignore at the same time lose nothing.
SETTING = "ignored finding "


def ignored_keys(settings: Iterable[str]) -> dict[str, frozenset[str]]:
    """Frame -> the keys of its findings that are ignored, by the names of a dataset's settings that
    are set."""
    found: dict[str, set[str]] = {}
    for setting in settings:
        if setting.startswith(SETTING):
            key, _, frame = setting.removeprefix(SETTING).partition(" ")
            found.setdefault(frame, set()).add(key)
    return {frame: frozenset(keys) for frame, keys in found.items()}


# What these are kept under with the dataset; a commit with the frame's name behind it.
_COMMIT_SETTING = "blind commit of "


class BlindStatus(StrEnum):
    """Results on a frame's clicks that may be shown."""

    UNKNOWN = ""  # not committed in blind mode: cameras may have been shown all along
    BLIND = "blind"
    EDITED = "edited after the cameras were shown"


@dataclass(frozen=True, slots=True)
class BlindCommit:
    """The first time that a frame was committed, which was in blind mode.

    Attributes:
        time: seconds since 1970, UTC.
        content: of what was committed, see `content_of`; empty if that is not known any more.
    """

    author: str
    time: float
    content: str

    def work(self, annotation: FrameAnnotation) -> BlindStatus:
        """Return whether a frame that holds this annotation now is still what was committed."""
        same = self.content == content_of(annotation)
        return BlindStatus.BLIND if same else BlindStatus.EDITED


def setting_of(frame: str) -> str:
    """Return what a frame's commit is kept under with the dataset."""
    return _COMMIT_SETTING + frame


def read_commit(text: str | None) -> BlindCommit | None:
    """The commit that `write_commit` wrote; None for none. Of a damaged text nothing is known but
    that there was one."""
    if text is None:
        return None
    try:
        return msgspec.json.decode(text, type=BlindCommit)
    except msgspec.DecodeError:
        return BlindCommit("", 0.0, "")


def write_commit(commit: BlindCommit) -> str:
    """The text that `read_commit` reads."""
    return json.dumps(asdict(commit), ensure_ascii=False)


def blind_status(text: str | None, annotation: FrameAnnotation) -> BlindStatus:
    """Return what may be said of a frame's clicks as they are now, by the text that is kept under
    `setting_of` the frame."""
    commit = read_commit(text)
    return commit.work(annotation) if commit is not None else BlindStatus.UNKNOWN


LOCK_SETTING = "blind lock"  # what it is kept under with the dataset


@dataclass(frozen=True, slots=True)
class LockEvent:
    """The dataset was locked to blind mode, or unlocked.

    Attributes:
        time: seconds since 1970, UTC.
    """

    locked: bool
    author: str
    time: float


def read_events(text: str | None) -> tuple[LockEvent, ...]:
    """Return what happened, oldest first. A text that cannot be read is a lock by no one known:
    anyone who may not see the fit must not come to see it through a damaged entry."""
    if text is None:
        return ()
    try:
        return tuple(msgspec.json.decode(text, type=list[LockEvent]))
    except msgspec.DecodeError:
        return (LockEvent(True, "", 0.0),)


def write_events(events: Sequence[LockEvent]) -> str:
    """The text that `read_events` reads."""
    return json.dumps([asdict(event) for event in events], ensure_ascii=False)


def lock_of(events: Sequence[LockEvent]) -> LockEvent | None:
    """The lock that holds now, if one does."""
    return events[-1] if events and events[-1].locked else None
