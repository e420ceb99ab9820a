"""What somebody may choose for a label: rules in words."""

from __future__ import annotations

from procc_annotator.field.model import Field
from procc_annotator.io.annotation_files.label_map import (
    LEFT_TO_RIGHT,
    ORDERS,
    TOP_DOWN,
    OrderedClasses,
    Rule,
)
from procc_annotator.session.labels.label_proposal import LabelProposal

_DIRECTIONS = {LEFT_TO_RIGHT: "left to right", TOP_DOWN: "top down"}


def order_choices(proposal: LabelProposal) -> list[OrderedClasses]:
    """The orders that a label which two lines share may have, the proposed one first."""
    own = proposal.rule if isinstance(proposal.rule, OrderedClasses) else None
    pair = own.classes if own is not None else proposal.like
    found = [own] if own is not None else []
    if len(pair) == proposal.count.copies == 2:
        found += [OrderedClasses(way, names) for way in ORDERS for names in (pair, pair[::-1])]
    return list(dict.fromkeys(found))


def rule_words(rule: Rule, field: Field) -> str:
    """A rule in a few words, with the titles of the classes."""
    if isinstance(rule, OrderedClasses):
        titles = ", ".join(field.title_of(name) for name in rule.classes)
        return f"{titles} ({_DIRECTIONS[rule.order]})"
    return field.title_of(rule) if isinstance(rule, str) else "Leave out"
