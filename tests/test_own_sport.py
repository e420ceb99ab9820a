"""The guide "A sport of your own" works to the letter: its blocks are run as they stand."""

import re
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from typer.testing import CliRunner

from procc_annotator.cli.main import app
from procc_annotator.field import element_reader, file_reader
from procc_annotator.field.load import field_names, load_field

DOCS = Path(__file__).parents[1] / "docs"
WALK = (DOCS / "tutorials" / "a-sport-of-your-own.md").read_text(encoding="utf-8")
REFERENCE = (DOCS / "reference" / "field-files.md").read_text(encoding="utf-8")


@dataclass(frozen=True)
class Block:
    """A fenced block, and the last file that the text before it names."""

    kind: str
    text: str
    file: str


def blocks(text: str) -> Iterator[Block]:
    named = ""
    for between, kind, inside in re.findall(r"(.*?)^```(\w+)\n(.*?)^```$", text, re.DOTALL | re.M):
        files = re.findall(r"`([\w/.-]+\.(?:toml|json))`", between)
        named = files[-1] if files else named
        yield Block(kind, inside, named)


def run(line: str) -> str:
    """What a command of the guide prints."""
    program, _, rest = line.partition(" ")
    if program != "procc-annotator":
        return subprocess.run(line, shell=True, check=True, capture_output=True, text=True).stdout
    done = CliRunner().invoke(app, rest.split())
    if done.exception is not None and not isinstance(done.exception, SystemExit):
        raise done.exception
    assert done.exit_code == 0, f"{line}: {done.output}"
    return done.stdout


def test_padel_from_an_empty_file_to_a_score(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.delenv("COLUMNS", raising=False)
    printed, seen = "", []
    for block in blocks(WALK):
        seen.append(block.kind)
        if block.kind == "toml":
            with Path("padel.toml").open("a", encoding="utf-8") as file:
                file.write(block.text + "\n")
        elif block.kind == "json":
            Path(block.file).write_text(block.text, encoding="utf-8")
        elif block.kind == "sh":
            printed = "".join(map(run, block.text.splitlines()))
        else:
            for line in block.text.splitlines():
                assert line in printed, f"the guide promises {line!r}, printed was:\n{printed}"
    assert seen.count("toml") == 8
    assert seen.count("sh") == 5
    assert seen.count("json") == 1
    assert Path("padel.png").stat().st_size > 10_000
    assert Path("cameras/camera_1.json").is_file()
    assert load_field("padel.toml").described == "padel"
    assert "padel" not in field_names()


def test_the_mistake_of_the_guide_is_told_as_the_guide_says(tmp_path):
    path = tmp_path / "padel.toml"
    text = "\n".join(block.text for block in blocks(WALK) if block.kind == "toml")
    path.write_text(text.replace('end = ["-service_line"', 'end = ["-sevice_line"', 1))
    done = CliRunner().invoke(app, ["field", "check", str(path)])
    assert done.exit_code == 2
    told = re.search(r"`padel\.toml: (line \d+: element .*?: bad formula) …; (did.*?)`", WALK, re.S)
    for words in told.groups():
        assert words.replace("\n", " ") in done.stderr


def test_every_example_of_the_reference_can_be_read(tmp_path):
    found = "\n".join(block.text for block in blocks(WALK) if block.kind == "toml")
    found = found.replace("symmetries = [180]", "symmetries = []")
    examples = [block for block in blocks(REFERENCE) if block.kind == "toml"]
    path = tmp_path / "padel.toml"
    path.write_text("\n".join([found, *(e.text for e in examples)]), encoding="utf-8")
    field = load_field(path)
    assert len(examples) == 3
    arch, area, border = field.elements[-3:]
    assert arch.name == "Arch"
    assert not arch.on_ground
    assert area.is_curved
    assert border.inside == (0.0, 10.0, 0.0)


def test_the_reference_names_every_key():
    named = set(re.findall(r"`\[*([a-z_]+)\]*`", REFERENCE))
    kinds = element_reader.GEOMETRY_KEYS
    keys = {key for needed, more in kinds.values() for key in (*needed, *more)} | set(kinds)
    keys |= (
        file_reader._ALLOWED_KEYS
        | element_reader.MARKING_KEYS
        | set(file_reader._ELEMENT_TEXTS)
        | {"optional"}
    )
    keys |= set(file_reader._DIMENSION_NUMBERS) | {"distance", "height", "ceiling", "kind"}
    assert keys <= named, f"not documented: {sorted(keys - named)}"
