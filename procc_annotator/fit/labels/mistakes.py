"""What the fitted camera says about the labels, as findings."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from procc_annotator.annotation import FrameAnnotation
from procc_annotator.field.landmarks import known_covariances
from procc_annotator.fit.labels.clicked import ClickedFrame, in_picture, limit_of, off_px
from procc_annotator.fit.labels.explanation import ENOUGH_RIGHT, DoubtedFrame, Explanation, explain
from procc_annotator.fit.labels.finding import (
    LOOK,
    Finding,
    Remedy,
    RemedyKind,
    Rule,
    Severity,
)
from procc_annotator.fit.labels.orientation import ACROSS, ALONG, EXCHANGE, reflected_names, renamed
from procc_annotator.fit.labels.relabelling import distances_to_classes, others_with_and_without
from procc_annotator.fit.result import FitResult, PosedCamera
from procc_annotator.fit.solving.final_fit import MINIMUM_ELEMENTS, OUTLIER_PX
from procc_annotator.fit.solving.models import STRONG
from procc_annotator.fit.solving.observations import PictureFrame, observe
from procc_annotator.fit.solving.plausible import missing
from procc_annotator.language import Said, said, said_all, said_joined

# A whole frame is called reflected if its reflection fits at least so many times as well.
_TIMES_AS_WELL = 2.0
_REFLECTION_FITS_PX = 6.0
# An element counts at most this in the comparison of two labellings.
_MOST_PX = 30.0
# Only a fit this bad makes it worth while to look.
_BAD_MEDIAN_PX = 4.0
_BAD_ELEMENTS = 2
_NOTICEABLE_PX = 0.1
_FIT_EXCHANGED = {
    ACROSS: said("all labels fit with far and near exchanged"),
    ALONG: said("all labels fit with left and right exchanged"),
}
# Carelessly clicked frames have points so many times as far off as elements usually are.
_TIMES_USUAL = 3.0


def suspects_of(fit: FitResult, frame: PictureFrame) -> tuple[str, ...]:
    """The elements that are farther off than the limit, in the order of the fit."""
    limit = limit_of(fit, frame)
    return tuple(e.name for e in fit.elements if off_px(e, frame) > limit)


def camera_findings(looked_at: ClickedFrame, known: Sequence[Finding]) -> tuple[Finding, ...]:
    """What does not fit the camera of the other elements, explained; costs several fits. Nothing
    where all of it fits."""
    fit, frame = looked_at.fit, looked_at.frame
    if len(looked_at.clicked) < MINIMUM_ELEMENTS:
        return ()
    if fit.camera is not None and not suspects_of(fit, frame):
        return ()
    # A model without distortion leaves lines off that are right; so does one of the ground alone.
    model = fit.model if fit.model in ("R+", *STRONG) else "R"
    polylines = looked_at.annotation.polylines
    doubted = DoubtedFrame(
        FrameAnnotation(polylines), looked_at.field, frame, model, go_on=looked_at.go_on
    )
    if len(doubted.names) < MINIMUM_ELEMENTS or (fit.camera is None and _too_little(doubted)):
        return ()
    if fit.model != model:
        fit = doubted.fit(doubted.annotation, fit.camera)
    suspects = suspects_of(fit, frame)
    if fit.camera is not None and not suspects:
        return ()
    reversed_frame = _reflected(doubted, fit)
    if reversed_frame is not None:
        return (reversed_frame,)
    found = explain(replace(doubted, limit_px=limit_of(fit, frame)), fit, suspects)
    if found is None:
        return _unexplained(doubted, fit, suspects)
    return tuple(_findings(doubted, found))


def _too_little(doubted: DoubtedFrame) -> bool:
    """Whether there is no camera because there are too few clicks: nothing is wrong with those."""
    seen = observe(doubted.annotation, doubted.field, doubted.frame)
    return missing(seen, needed=MINIMUM_ELEMENTS, planar=False) is not None


def _badness(fit: FitResult, count: int, frame: PictureFrame) -> float:
    """Mean of the elements' largest distances, solver px, none counting more than a mistake."""
    if fit.camera is None or not fit.elements:
        return _MOST_PX
    worst = [min(off_px(e, frame), _MOST_PX) for e in fit.elements]
    return float(sum(worst) + _MOST_PX * max(count - len(worst), 0)) / max(count, len(worst))


def _reflected(doubted: DoubtedFrame, fit: FitResult) -> Finding | None:
    field, frame = doubted.field, doubted.frame
    if fit.camera is not None:
        worst = [off_px(e, frame) for e in fit.elements]
        if np.median(worst) < _BAD_MEDIAN_PX and len(suspects_of(fit, frame)) < _BAD_ELEMENTS:
            return None
    ways = [(names, signs) for signs in (ACROSS, ALONG)
            if (names := reflected_names(field, signs, doubted.names)) is not None]  # fmt: skip
    if not ways:
        return None
    before = _badness(fit, len(doubted.names), frame)
    better = doubted.fit(renamed(doubted.annotation, ways[0][0]))
    after = _badness(better, len(doubted.names), frame)
    if after * _TIMES_AS_WELL > before or after > _REFLECTION_FITS_PX:
        return None
    # Both reflections fit alike; the main camera stands on the near side.
    near = isinstance(better.camera, PosedCamera) and better.camera.position_world[1] > 0
    remedies = [
        Remedy(RemedyKind.RELABEL, EXCHANGE[signs], _pairs(doubted.names, names))
        for names, signs in ways
    ]
    if not near:
        remedies.reverse()
        ways.reverse()
    after_px, before_px = in_picture(after, frame), in_picture(before, frame)
    off = (
        said(
            "elements are {after:.1f} px off on average, no camera fits the labels as they are",
            after=after_px,
        )
        if fit.camera is None
        else said(
            "elements are {after:.1f} px off on average, {before:.1f} px as they are",
            after=after_px,
            before=before_px,
        )
    )
    return Finding(
        Rule.REFLECTED,
        Severity.ERROR,
        doubted.names,
        said_joined(": ", (_FIT_EXCHANGED[ways[0][1]], off)),
        tuple(remedies),
        model=doubted.model,
    )


def _pairs(names: Collection[str], becomes: Mapping[str, str]) -> tuple[tuple[str, str], ...]:
    return tuple((name, becomes[name]) for name in names if becomes[name] != name)


def _findings(doubted: DoubtedFrame, found: Explanation) -> Iterator[Finding]:
    severity = Severity.ERROR if found.right >= ENOUGH_RIGHT else Severity.WARNING
    done: set[str] = set()
    for name in sorted(found.off_px, key=lambda name: -found.off_px[name]):
        if name in done:
            continue
        group = _cycle(name, found.names)
        done.update(group)
        if len(group) > 1:
            yield _exchanged(doubted, found, group, severity)
        elif name in found.points:
            yield _point(doubted, found, name, severity)
        else:
            yield _misplaced(doubted, found, name, severity)


def _cycle(name: str, names: Mapping[str, str]) -> tuple[str, ...]:
    """The classes that exchange their labels, beginning with this one; it alone if none do."""
    group = [name]
    while (following := names.get(group[-1])) is not None and following != name:
        if following in group or following not in names:
            return (name,)
        group.append(following)
    return tuple(group) if following == name else (name,)


def _exchanged(
    doubted: DoubtedFrame, found: Explanation, group: Sequence[str], severity: Severity
) -> Finding:
    title = {name: said(doubted.field.title_of(name)) for name in group}
    renames = tuple((name, found.names[name]) for name in group)
    off = max(_shown_px(doubted, found, name) for name in group)
    if len(group) == 2:
        a, b = title.values()
        fact = said("{a} and {b} fit with each other's label", a=a, b=b)
        remedy = Remedy(RemedyKind.SWAP, said("swap {a} and {b}", a=a, b=b), renames)
    else:
        fact = said("{titles} fit with each other's labels", titles=said_all([*title.values()]))
        steps = [said("{a} to {b}", "labels", a=title[a], b=title[b]) for a, b in renames]
        text = said("relabel {steps}", steps=said_joined(", ", steps))
        remedy = Remedy(RemedyKind.RELABEL, text, renames)
    return Finding(
        Rule.SWAPPED,
        severity,
        tuple(group),
        said_joined("; ", (fact, *_others(doubted, found))),
        (remedy, LOOK),
        error_px=off,
        model=doubted.model,
    )


def _point(doubted: DoubtedFrame, found: Explanation, name: str, severity: Severity) -> Finding:
    bad = found.points[name]
    if bad.off_px <= max(_usual(found), _TIMES_USUAL * bad.rest_px):
        severity = Severity.WARNING
    title, number = said(doubted.field.title_of(name)), bad.index + 1
    polyline = doubted.annotation.get(name)
    count = 0 if polyline is None else len(polyline.points)
    look = said("look at point {number}", number=number)
    remedies: tuple[Remedy, ...] = (Remedy(RemedyKind.LOOK, look),)
    if count > 2:
        remove = said("remove point {number}", number=number)
        remedies = (Remedy(RemedyKind.REMOVE_POINT, remove), *remedies)
    off = in_picture(bad.off_px, doubted.frame)
    rest = in_picture(bad.rest_px, doubted.frame)
    reason = said(
        "point {number} of {title} is {off:.0f} px off, its other points at most {rest:.1f} px",
        number=number,
        title=title,
        off=off,
        rest=rest,
    )
    if count == 2:
        reason = said(
            "point {number} of {title} is {off:.0f} px off, its other point at most {rest:.1f} px",
            number=number,
            title=title,
            off=off,
            rest=rest,
        )
    return Finding(
        Rule.POINT,
        severity,
        (name,),
        reason,
        remedies,
        point=bad.index,
        error_px=off,
        model=doubted.model,
    )


def _misplaced(doubted: DoubtedFrame, found: Explanation, name: str, severity: Severity) -> Finding:
    field, title = doubted.field, said(doubted.field.title_of(name))
    off = _shown_px(doubted, found, name)
    if name not in found.names and found.off_px[name] <= max(OUTLIER_PX, _usual(found)):
        severity = Severity.WARNING  # the label may be right and the clicks bad
    fact = (
        said(
            "{title} is up to {px:.0f} px from where the camera of the others shows it",
            title=title,
            px=off,
        )
        if off < doubted.frame.size[0]
        else said("{title} is nowhere near where the camera of the others shows it", title=title)
    )
    if name in known_covariances(field):
        fact = said_joined(", ", (fact, said("more than its own place is uncertain")))
    facts = [fact]
    becomes = found.names.get(name)
    remedies: list[Remedy] = []
    if becomes is not None:
        meant = said(field.title_of(becomes))
        facts.append(said("it lies where {title} should be", title=meant))
        free = [becomes, *(p.class_name for p in found.places.get(name, ()))]
        taken = {*doubted.names, *found.names.values()} - {becomes}
        for other in dict.fromkeys(free):
            if other not in taken or other == becomes:
                renames = ((name, other),)
                text = said("relabel to {title}", title=said(field.title_of(other)))
                remedies.append(Remedy(RemedyKind.RELABEL, text, renames))
    else:
        twin = next((p.class_name for p in found.places.get(name, ())), None)
        if twin is not None and twin != name:
            lies_on = said(field.title_of(twin))
            facts.append(said("it lies on {title}, which is annotated as well", title=lies_on))
    return Finding(
        Rule.RESIDUAL,
        severity,
        (name,),
        said_joined("; ", (*facts, *_others(doubted, found))),
        (*remedies, LOOK),
        error_px=off,
        model=doubted.model,
    )


def _shown_px(doubted: DoubtedFrame, found: Explanation, name: str) -> float:
    """How far off an element is in the picture, px of it, however much of that counts."""
    polyline = doubted.annotation.get(name)
    assert polyline is not None  # it was found to be off
    distances = distances_to_classes(polyline, [name], doubted.field, doubted.frame, found.vector)
    return in_picture(float(distances[name].max()), doubted.frame)


def _others(doubted: DoubtedFrame, found: Explanation) -> tuple[Said, ...]:
    """The leave-one-out sentence, for all mistakes of the frame together."""
    wrong = tuple(found.off_px)
    means = others_with_and_without(
        doubted.annotation, wrong, doubted.field, doubted.frame, found.vector, doubted.model
    )
    if means is None:
        return ()
    titles = [said(doubted.field.title_of(name)) for name in wrong]
    before, after = (in_picture(mean, doubted.frame) for mean in means)
    if before - after < _NOTICEABLE_PX:
        return (said("the others are {px:.1f} px off with and without it", px=after),)
    return (
        said(
            "without {titles} the others drop from {before:.1f} to {after:.1f} px",
            titles=said_all(titles),
            before=before,
            after=after,
        ),
    )


def _usual(found: Explanation) -> float:
    """How far off a point may be where the right elements lie as far off as they do, solver px."""
    return _TIMES_USUAL * found.right_px


def _unexplained(
    doubted: DoubtedFrame, fit: FitResult, suspects: Collection[str]
) -> tuple[Finding, ...]:
    """The labels contradict each other, and too few are right to say which are wrong."""
    if fit.camera is None:
        return (
            Finding(
                Rule.RESIDUAL,
                Severity.WARNING,
                doubted.names,
                fit.failure or said("no camera fits these labels together"),
                (LOOK,),
                model=doubted.model,
            ),
        )
    return tuple(
        Finding(
            Rule.RESIDUAL,
            Severity.WARNING,
            (element.name,),
            said(
                "{title} is up to {px:.0f} px from where the camera shows it; too few elements fit"
                " to say which are wrong",
                title=said(doubted.field.title_of(element.name)),
                px=element.max_px,
            ),
            (LOOK,),
            error_px=element.max_px,
            model=doubted.model,
        )
        for element in fit.elements
        if element.name in suspects
    )
