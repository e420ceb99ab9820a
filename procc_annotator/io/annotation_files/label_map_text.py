"""A map of labels as the text of a file, with a comment on every rule."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from procc_annotator.io.annotation_files.label_map import TemplateRule, Rule


@dataclass(frozen=True, slots=True)
class WrittenRule:
    """A line of the file.

    Attributes:
        label: as in the annotations.
        rule: what it stands for.
        comment: above it; may be empty.
        used: otherwise the line is one to fill in: it stands there as a comment.
    """

    label: str
    rule: Rule
    comment: str = ""
    used: bool = True


def label_map_text(head: Sequence[str], rules: Iterable[WrittenRule]) -> str:
    """The text of a ``labels.toml``.

    Args:
        head: lines of a comment at its top.
        rules: in the order they are written.
    """
    lines = [*(f"# {_plain(line)}".rstrip() for line in head), "", "[labels]"]
    for one in rules:
        if one.comment:
            lines.append(f"# {_plain(one.comment)}")
        lines.append(f"{'' if one.used else '# '}{_quoted(one.label)} = {_value(one.rule)}")
    return "\n".join(lines) + "\n"


def _value(rule: Rule) -> str:
    if rule is None:
        return "false"
    if isinstance(rule, str):
        return _quoted(rule.strip())
    if isinstance(rule, TemplateRule):
        return f"{{ template = {_quoted(rule.name)} }}"
    names = ", ".join(_quoted(name.strip()) for name in rule.classes)
    return f"{{ {rule.order} = [{names}] }}"


def _quoted(text: str) -> str:
    """A basic string of TOML, which are those of JSON but for the last control character."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _plain(text: str) -> str:
    """A comment of one line."""
    return "".join(c if c.isprintable() else " " for c in text)
