"""Collect the clicks on each landmark for triangulation."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from dataclasses import field as dataclass_field

from natsort import natsorted

from procc_annotator.annotation import FrameAnnotation, Point
from procc_annotator.calibration.triangulation import Triangulation
from procc_annotator.dataset.landmarks.view_groups import ViewGroups
from procc_annotator.field.landmarks import is_moving, landmarks_by_name, without_landmarks
from procc_annotator.field.model import Field, Landmark
from procc_annotator.formats.landmark_file import LandmarkFile
from procc_annotator.translation import TranslatableText, translatable


@dataclass(frozen=True, slots=True)
class Click:
    """A landmark clicked in a frame; the point is normalised."""

    frame: str
    point: Point


@dataclass(frozen=True)
class ClickedLandmark:
    """One landmark, at one instant if it moves.

    Attributes:
        instant: of a moving object; None for what stays.
        clicks: one a frame, in natural order of the frames.
        problem: why there is nothing to triangulate; empty if there is.
    """

    name: str
    instant: str | None = None
    clicks: tuple[Click, ...] = ()
    problem: str = ""


@dataclass(frozen=True)
class LocatedLandmark:
    """Result for a landmark's clicks.

    Attributes:
        found: the position, or why it is unknown.
        without_view: frames that could not take part, with the reason.
        kept: whether its position was given by a person, and is not touched.
        astray: frames with a click that does not agree with the position that is kept.
    """

    clicked: ClickedLandmark
    found: Triangulation
    without_view: tuple[tuple[str, str], ...] = ()
    kept: bool = False
    astray: tuple[str, ...] = ()


@dataclass
class ClickGathering:
    """Gathers the clicks of a dataset frame by frame.

    Attributes:
        field: with or without landmarks.
        known: those the dataset has.
        groups: when its frames were taken.
        moving: names of objects that move, next to those the dataset says so of.
    """

    field: Field
    known: tuple[Landmark, ...] = ()
    groups: ViewGroups = dataclass_field(default_factory=ViewGroups)
    moving: Collection[str] = ()
    _clicks: dict[str, list[Click]] = dataclass_field(default_factory=dict)
    _longest: dict[str, int] = dataclass_field(default_factory=dict)

    def __post_init__(self) -> None:
        self._plain = without_landmarks(self.field)
        self._moves = {name.strip() for name in self.moving}
        self._moves |= {mark.name.strip() for mark in self.known if is_moving(mark)}
        self._names = {mark.name.strip(): mark.name for mark in self.known}

    def add(self, frame: str, annotation: FrameAnnotation) -> bool:
        """Take the clicks of one frame, on classes that the field does not place itself; return
        whether there are any."""
        any_click = False
        for polyline in annotation.polylines:
            name = self._names.get(polyline.class_name.strip(), polyline.class_name)
            if not polyline.points or self._plain.knows(self._plain.canonical_name(name)):
                continue
            self._longest[name] = max(self._longest.get(name, 0), len(polyline.points))
            if len(polyline.points) == 1:
                self._clicks.setdefault(name, []).append(Click(frame, polyline.points[0]))
                any_click = True
        return any_click

    def clicked(self) -> tuple[ClickedLandmark, ...]:
        """The landmarks in natural order; a moving one once an instant."""
        found: list[ClickedLandmark] = []
        for name in natsorted(self._longest):
            clicks = self._in_order(self._clicks.get(name, []))
            if not clicks:
                problem = f"a landmark is one click, this has up to {self._longest[name]} points"
                found.append(ClickedLandmark(name, problem=problem))
            elif name.strip() in self._moves:
                found += self._by_instant(name, clicks)
            else:
                found.append(ClickedLandmark(name, None, tuple(clicks)))
        return tuple(found)

    def _in_order(self, clicks: Iterable[Click]) -> list[Click]:
        return natsorted(clicks, key=lambda click: click.frame)

    def _by_instant(self, name: str, clicks: list[Click]) -> list[ClickedLandmark]:
        at: dict[str, list[Click]] = {}
        alone: list[Click] = []
        for click in clicks:
            instant = self.groups.instant_of(click.frame)
            if instant is None:
                alone.append(click)
            else:
                at.setdefault(instant, []).append(click)
        found = [ClickedLandmark(name, instant, tuple(at[instant])) for instant in natsorted(at)]
        if alone:
            found.append(ClickedLandmark(name, None, tuple(alone), self._why_alone(alone)))
        return found

    def _why_alone(self, clicks: Sequence[Click]) -> str:
        if not self.groups.told_by:
            return "no views.csv states when its frames were taken, as a moving object needs"
        more = f" and {len(clicks) - 1} more" if len(clicks) > 1 else ""
        return (
            f"{self.groups.told_by} does not state when {clicks[0].frame}{more} was taken, as a"
            " moving object needs"
        )


def with_positions(file: LandmarkFile, located: Iterable[LocatedLandmark]) -> LandmarkFile:
    """A dataset's landmarks with the positions that were found.

    What a person surveyed stays as it is, though it be the file alone that says so; what was
    triangulated before and cannot be now keeps its position too.
    """
    for one in located:
        name, instant = one.clicked.name, one.clicked.instant
        if one.kept or one.found.position is None or why_kept(file, name, instant):
            continue
        entries = landmarks_by_name(file.landmarks).get(name, [])
        own = next((mark for mark in entries if mark.instant == instant), None)
        if instant is not None and not any(mark.moving for mark in entries):
            # What it is called and how it looks is said once, of the object.
            looks = next((m for m in entries if m.instant is None), Landmark(name))
            looks = replace(looks, moving=True, surveyed=True, frames=())
            file = file.with_landmark(replace(looks, position=None, covariance=None))
        used = [c.frame for c in one.clicked.clicks if c.frame not in dict(one.without_view)]
        placed = replace(
            own or Landmark(name, instant=instant),
            position=one.found.position,
            covariance=one.found.covariance,
            surveyed=False,
            frames=tuple(frame for frame in used if frame not in one.found.left_out),
        )
        file = file.with_landmark(placed)
    return file


def why_kept(file: LandmarkFile, name: str, instant: str | None = None) -> str:
    """Why no triangulated position may be written for a landmark, of an instant if it moves; empty
    where one may. The file is as it is now: it may say more than when the triangulation began."""
    if surveyed_entry(file.landmarks, name, instant) is not None:
        return translatable(
            "{title} was surveyed: its position stays as it is", title=title_in(file, name)
        )
    if instant is None and any(map(is_moving, landmarks_by_name(file.landmarks).get(name, []))):
        return translatable(
            "{title} moves: its positions hold for an instant each", title=title_in(file, name)
        )
    return ""


def title_in(file: LandmarkFile, name: str) -> TranslatableText:
    """Return what people call a landmark; its name where the file does not know it."""
    entries = landmarks_by_name(file.landmarks).get(name)
    return translatable(entries[0].shown_title if entries else name.strip())


def surveyed_entry(known: Iterable[Landmark], name: str, instant: str | None) -> Landmark | None:
    """The entry with a landmark's place at an instant, or the one it has at all times, as far as
    a person gave it."""
    return next(
        (
            mark
            for mark in known
            if mark.name.strip() == name.strip()
            and mark.instant in (instant, None)
            and mark.surveyed
            and mark.position is not None
        ),
        None,
    )
