"""Parse XML of other programs, entities and document types refused."""

from __future__ import annotations

from typing import TYPE_CHECKING

from procc_annotator.errors import InputError
from procc_annotator.formats.strict_json import printable

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element


def parse_xml(data: bytes, path: str, error: type[InputError], advice: str) -> Element:
    """The root of a file.

    Raises:
        error: damaged, or with entities or a document type.
    """
    from xml.etree.ElementTree import ParseError

    from defusedxml import ElementTree  # type: ignore[import-untyped]
    from defusedxml.common import DefusedXmlException  # type: ignore[import-untyped]

    try:
        root: Element = ElementTree.fromstring(data, forbid_dtd=True)
    except DefusedXmlException as problem:
        why = "declares entities or a document type, which are not read"
        raise error(path, why, advice=advice) from problem
    except ParseError as problem:
        (line, column), why = problem.position, str(problem).partition(":")[0]
        place = f"line {line} column {column + 1}"
        advice = f"the file may be cut off: {advice}"
        raise error(path, f"is not valid XML: {why}", place=place, advice=advice) from problem
    except (ValueError, LookupError) as problem:  # an encoding nobody knows
        why = printable(str(problem), 120)
        raise error(path, f"is not readable XML: {why}", advice="save it as UTF-8") from problem
    return root
