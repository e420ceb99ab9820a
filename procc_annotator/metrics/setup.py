"""Evaluation setup: field, image size, protocol and the options that change a number."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from dataclasses import field as dataclass_field
from functools import cached_property

import numpy as np

from procc_annotator.arrays import BoolArray, FloatArray, IntArray
from procc_annotator.errors import UsageError
from procc_annotator.field.load import default_field_name, field_fingerprint, field_for_frame
from procc_annotator.field.model import Field
from procc_annotator.field.sampling import sample_official
from procc_annotator.messages import pluralize
from procc_annotator.metrics.curve_projection import ElementCurves

PROTOCOLS = ("soccernet", "procc")
OFF_PLANE = ("missed", "left_out")


@dataclass(frozen=True)
class EvaluationSetup:
    """Everything a score depends on besides annotation, camera and threshold.

    Args:
        size: (width, height) in px at which annotation and camera are compared.
        protocol: ``soccernet`` (the official evaluation, quirks included; optional elements take no
            part, neither annotated nor projected) or ``procc`` (the paper's definition: closed
            circles, fine curves, clean clipping; optional elements count where they are annotated).
        allow_mirrored: whether labels of the turned field may count; for ``procc`` only,
            ``soccernet`` always considers them. A field may have several turns, or none.
        off_plane: how elements off the ground count for a camera that knows only the ground:
            ``missed`` (as false negatives when annotated) or ``left_out`` (not at all).
        planar_only: whether elements off the ground take no part for any camera, neither annotated
            nor projected; ``off_plane`` then has nothing to say.
        unsized: (width, height) in px that cameras belong to where nothing says it; None for
            ``size``.

    Raises:
        UsageError: an unknown protocol or choice, or a size that is no picture.
    """

    field: Field
    size: tuple[int, int] = (960, 540)
    protocol: str = "soccernet"
    allow_mirrored: bool = False
    off_plane: str = "missed"
    planar_only: bool = False
    unsized: tuple[int, int] | None = None
    _of_field: _FieldCache | None = dataclass_field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        if self._of_field is None or self._of_field.field is not self.field:
            object.__setattr__(self, "_of_field", _FieldCache(self.field))
        _require_choice("protocol", self.protocol, PROTOCOLS)
        _require_choice("choice for off-plane elements", self.off_plane, OFF_PLANE)
        if min(self.size) < 2:
            raise UsageError(f"the evaluation size {self.size[0]}x{self.size[1]} is too small")

    @property
    def considers_mirrored(self) -> bool:
        """Return whether the labels of the turned field are scored as well."""
        return bool(self.field.symmetries) and (self.is_official or self.allow_mirrored)

    @property
    def is_official(self) -> bool:
        """Return whether the official evaluation is followed in every count."""
        return self.protocol == "soccernet"

    def at(self, size: tuple[int, int]) -> EvaluationSetup:
        """The same at another picture size."""
        return self if size == self.size else replace(self, size=size)

    def of_frame(self, name: str) -> EvaluationSetup:
        """The same with the field as it is in a frame: the dimensions of its stadium, the landmarks
        where they are then; itself where the frame has nothing of its own."""
        field = field_for_frame(self.field, name)
        if field is self.field:
            return self
        assert self._of_field is not None  # see above
        return replace(self, field=field, _of_field=self._of_field.of(field))

    def describe(self, ground_only: bool = False, sizes: str = "") -> str:
        """The setup in words, to stand next to every number, e.g. ``soccernet, 960x540``.

        A field other than the default one is reported, as are dimensions that are not the nominal
        ones: the official evaluation knows neither. ``sizes``: picture sizes in words, where frames
        were scored at their own.
        """
        words = [self.protocol, sizes or f"{self.size[0]}x{self.size[1]}"]
        if self.field.described != default_field_name():
            words.append(self.field.described)
        placed = len({m.name for m in self.field.landmarks if m.position is not None})
        if placed and not self.is_official:
            words.append(pluralize(placed, "landmark"))
        return ", ".join([*words, *self.options(ground_only)])

    def options(self, ground_only: bool = False) -> tuple[str, ...]:
        """Return what was chosen besides protocol, size and field, in words; see `describe`."""
        words = []
        if self.protocol == "procc" and self.considers_mirrored:
            words.append("mirrored labels allowed")
        if self.planar_only:
            words.append("planar elements only")
        elif ground_only:
            how = "left out" if self.off_plane == "left_out" else "counted as missed"
            words.append(f"off-plane elements {how}")
        return tuple(words)

    @property
    def tables(self) -> FieldTables:
        """Return what every frame needs of the field, computed once."""
        assert self._of_field is not None  # see above
        return self._of_field.tables

    @property
    def field_sha256(self) -> str:
        """Return the fingerprint of the field, computed once."""
        assert self._of_field is not None
        return self._of_field.fingerprint

    @property
    def curves(self) -> ElementCurves:
        """The elements as parametric curves, for the ``procc`` protocol."""
        assert self._of_field is not None
        return self._of_field.curves


@dataclass(frozen=True, eq=False)
class _FieldCache:
    """Data computed once for a field; it does not depend on the picture's size."""

    field: Field
    _of_stadiums: dict[int, _FieldCache] = dataclass_field(default_factory=dict)

    def of(self, field: Field) -> _FieldCache:
        """The same of the field as it is in a frame; kept for each stadium."""
        if not any(field is own for own in self.field.of_stadiums.values()):
            return _FieldCache(field)
        return self._of_stadiums.setdefault(id(field), _FieldCache(field))

    @cached_property
    def tables(self) -> FieldTables:
        return FieldTables.of(self.field)

    @cached_property
    def fingerprint(self) -> str:
        return field_fingerprint(self.field)

    @cached_property
    def curves(self) -> ElementCurves:
        return ElementCurves.of(self.field)


@dataclass(frozen=True, eq=False)
class FieldTables:
    """The field as flat arrays; E elements, N official samples.

    Attributes:
        names: (E,) element names.
        index: element name -> row.
        turns: (E,) row of the element each one becomes, for every turn that takes the field to
            itself.
        on_ground: (E,) whether the element lies on z = 0.
        is_official: (E,) whether it belongs to the official classes, i.e. is not optional.
        points_world: (N, 3) metres, world frame: the official samples of those.
        element_of_sample: (N,) row of the element of each sample.
        off_plane_names: the elements that leave the ground. optional_names: the optional ones.
        unplaced_names: landmarks whose place is not known.
    """

    names: tuple[str, ...]
    index: dict[str, int]
    turns: tuple[IntArray, ...]
    on_ground: BoolArray
    is_official: BoolArray
    points_world: FloatArray
    element_of_sample: IntArray
    off_plane_names: frozenset[str]
    optional_names: frozenset[str]
    unplaced_names: frozenset[str]

    @classmethod
    def of(cls, field: Field) -> FieldTables:
        samples = sample_official(field)
        rows = np.arange(len(field.elements), dtype=np.intp)
        element_of_sample = np.repeat(rows, np.diff(samples.offsets))
        is_official = np.array([not e.optional for e in field.elements], dtype=bool)
        kept = is_official[element_of_sample]
        return cls(
            names=tuple(e.name for e in field.elements),
            index=dict(field.index),
            turns=tuple(
                np.array(
                    [field.index[turn.name_of(e.name)] for e in field.elements],
                    dtype=np.intp,
                )
                for turn in field.symmetries
            ),
            on_ground=field.on_ground,
            is_official=is_official,
            points_world=samples.points_world[kept],
            element_of_sample=element_of_sample[kept],
            off_plane_names=frozenset(e.name for e in field.elements if not e.on_ground),
            optional_names=frozenset(e.name for e in field.elements if e.optional),
            unplaced_names=field.unplaced_landmarks,
        )


def check_thresholds(thresholds: float | Sequence[float]) -> tuple[float, ...]:
    """The thresholds, one or several, without repetitions, in the order given; `UsageError` if
    there is none, or one that is not a positive number of pixels."""
    thresholds = tuple(thresholds) if isinstance(thresholds, Iterable) else (thresholds,)
    for threshold in thresholds:
        number = isinstance(threshold, int | float | np.number) and type(threshold) is not bool
        if not (number and math.isfinite(threshold) and threshold > 0):
            shown = f"{threshold:g}" if number else repr(threshold)
            raise UsageError(f"a threshold must be a positive number of pixels, not {shown}")
    if not thresholds:
        raise UsageError("at least one threshold is needed")
    return tuple(dict.fromkeys(float(t) for t in thresholds))


def _require_choice(what: str, value: str, choices: tuple[str, ...]) -> None:
    if value in choices:
        return
    close = difflib.get_close_matches(value, choices, n=1)
    hint = f"; did you mean {close[0]!r}?" if close else f"; choose one of {', '.join(choices)}"
    raise UsageError(f"unknown {what} {value!r}{hint}")
