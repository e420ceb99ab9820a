"""What other programs make of files, as JSON: run by their own Python, see `make clients`.

client.py datumaro-read FORMAT PATH | datumaro-write FORMAT PATH NEW_FORMAT OUT
          labelme-read FOLDER | labelme-write FOLDER OUT | pandas FILE | duckdb FILE
"""

import json
import sys
import warnings
from pathlib import Path
from typing import Any

Read = dict[str, list[tuple[str, list[list[float]]]]]  # frame -> label and points of each shape


def datumaro_read(fmt: str, path: str) -> dict[str, Any]:
    from datumaro import Dataset

    found = Dataset.import_from(path, fmt)
    names = found.categories()[_label_kind()]
    frames: Read = {}
    for item in found:
        shapes = [shape for shape in item.annotations if shape.type.name in ("points", "polyline")]
        frames[item.id] = [
            (names[shape.label].name, _shown(shape))
            for shape in shapes
            if not shape.attributes.get("outside")
        ]
    return {"frames": frames, "pictures": sum(bool(item.media) for item in found)}


def datumaro_write(fmt: str, path: str, new: str, out: str) -> dict[str, Any]:
    from datumaro import Dataset

    Dataset.import_from(path, fmt).export(out, new, save_media=True)
    return {}


def labelme_read(folder: str) -> dict[str, Any]:
    frames: Read = {}
    pictures = 0
    for file in sorted(Path(folder).glob("*.json")):
        read = _label_file()(str(file))
        pictures += bool(read.image_data)
        frames[file.stem] = [(shape["label"], _lists(shape["points"])) for shape in read.shapes]
    return {"frames": frames, "pictures": pictures}


def labelme_write(folder: str, out: str) -> dict[str, Any]:
    """Open every file and save it elsewhere, as a person does."""
    for file in sorted(Path(folder).glob("*.json")):
        told = json.loads(file.read_text())
        read = _label_file()(str(file))
        shapes = [
            {**shape, "points": _lists(shape["points"]), "mask": None} for shape in read.shapes
        ]
        _label_file()().save(
            filename=str(Path(out) / file.name),
            shapes=shapes,
            image_path=read.image_path,
            image_height=told["imageHeight"],
            image_width=told["imageWidth"],
        )
    return {}


def pandas(file: str) -> dict[str, Any]:
    import pandas

    table = pandas.read_csv(file)
    return {"rows": len(table), "columns": list(table.columns)}


def duckdb(file: str) -> dict[str, Any]:
    import duckdb

    table = duckdb.sql(f"SELECT * FROM '{file}'")
    return {"rows": len(table.fetchall()), "columns": table.columns}


def _label_kind() -> Any:
    from datumaro.components.annotation import AnnotationType

    return AnnotationType.label


def _label_file() -> Any:
    from labelme._label_file import LabelFile

    return LabelFile


def _shown(shape: Any) -> list[list[float]]:
    """The points that exist: of keypoints those with a visibility."""
    pairs = [list(map(float, shape.points[i : i + 2])) for i in range(0, len(shape.points), 2)]
    seen = getattr(shape, "visibility", None)
    return pairs if seen is None else [p for p, v in zip(pairs, seen, strict=True) if v.value > 0]


def _lists(points: Any) -> list[list[float]]:
    return [[float(x), float(y)] for x, y in points]


if __name__ == "__main__":
    warnings.simplefilter("ignore")
    command, *arguments = sys.argv[1:]
    json.dump(globals()[command.replace("-", "_")](*arguments), sys.stdout)
