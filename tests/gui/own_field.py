"""A field file of the user's own, and annotations of given classes."""

import json
from pathlib import Path

YARD = """
name = "yard"
title = "Yard"
[dimensions]
length = { title = "Length", nominal = 20, minimum = 18, maximum = 22 }
width = { title = "Width", nominal = 10, minimum = 10, maximum = 10 }
[[elements]]
name = "fence"
title = "Fence"
group = "Lines"
colour = "#ff0000"
shortcut = "1"
kind = "line"
start = ["-length / 2", "5", "0"]
end = ["length / 2", "5", "0"]
[[elements]]
name = "gate"
title = "Gate"
group = "Lines"
colour = "#00ff00"
shortcut = "D"
kind = "line"
start = ["0", "-5", "0"]
end = ["0", "5", "0"]
"""


def annotate(folder: Path, name: str, classes: list[str]) -> None:
    points = [{"x": 0.2, "y": 0.4}, {"x": 0.6, "y": 0.5}]
    (folder / f"{name}.json").write_text(json.dumps(dict.fromkeys(classes, points)))
