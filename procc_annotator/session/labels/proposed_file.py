"""A proposal as a file to be looked at, and which field the labels resemble."""

from __future__ import annotations

from collections.abc import Sequence

from procc_annotator.field.load import field_names, load_field
from procc_annotator.field.model import Field
from procc_annotator.field.similar_names import matching_classes
from procc_annotator.io.annotation_files.label_map_text import WrittenRule, label_map_text
from procc_annotator.session.dataset.field_match import loadable
from procc_annotator.session.labels.label_proposal import LabelProposal
from procc_annotator.words import count_words

_MUCH_MORE = 1.3  # of the likeness of all labels


def proposed_text(
    proposals: Sequence[LabelProposal], source: str, field: Field, *, given_cameras: bool
) -> str:
    """The ``labels.toml`` of a proposal.

    Args:
        proposals: of all labels.
        source: what the labels are of, for people.
        field: whose classes they are.
        given_cameras: whether cameras were given, which say what is left and what is right.
    """
    head = [
        f"What the labels of {source} may stand for on a field of {field.title}.",
        "Proposed by procc-annotator propose-map: sure by two ways, likely by one. What is open is"
        " a comment:",
        "write a class there, or leave the label out with false, and take the # away.",
    ]
    ordered = any(p.rule is not None and not isinstance(p.rule, str) for p in proposals)
    if field.symmetries and ordered and not given_cameras:
        head.append(
            "The field looks the same after a turn: the classes of the other end are as good, as"
            " long as all lines agree."
        )
    return label_map_text(head, [_written(one) for one in proposals])


def _written(one: LabelProposal) -> WrittenRule:
    shapes = count_words(one.count.shapes, "shape")
    like = f"; may be {', '.join(name.strip() for name in one.like)}" if one.like else ""
    comment = f"{one.surety}, {shapes}: {one.why}{like}"
    return WrittenRule(one.count.label, one.rule, comment, used=one.surety != "open")


def better_field(labels: Sequence[str], field: Field) -> str | None:
    """The field that the package ships whose classes are called much more like some labels.

    Args:
        labels: of a set.
        field: what they were taken for.

    Returns:
        What `load_field` takes; None where no field is.
    """
    own = _likeness(labels, field)
    others = [load_field(name) for name in field_names() if name != field.name]
    best = max(others, key=lambda other: _likeness(labels, other))
    much = _likeness(labels, best)
    return loadable(best) if much > own * _MUCH_MORE and much >= len(labels) / 2 else None


def _likeness(labels: Sequence[str], field: Field) -> float:
    found = (matching_classes(label, field) for label in labels)
    return sum(one.likeness for one in found if one.classes)
