"""How wide LaTeX sets text: Computer Modern at 10 pt, rather too wide than too narrow."""

from __future__ import annotations

_GROUPS = {
    2.8: "ijl.,:;'`![]|",
    3.7: " f-I",
    4.0: "rst()",
    4.8: "cez?",
    5.3: "agovxyqk0123456789*/–$_",
    5.7: 'bdhnpuSJ"',
    7.3: "FELPBTw",
    7.9: "ACDGHKNOQRUVXYZ+<>=@&~",
    8.4: "%m#",
    10.3: "WM",
}
_WIDTHS = {character: width for width, group in _GROUPS.items() for character in group}
_UNKNOWN = 10.3
_BOLD = 1.16  # of the upright type's width


def text_width(text: str, *, bold: bool = False) -> float:
    """Width of a line of text, pt."""
    width = sum(_WIDTHS.get(character, _UNKNOWN) for character in text)
    return _BOLD * width if bold else width
