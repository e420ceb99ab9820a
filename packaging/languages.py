"""The translations of the window: collect its texts, tell what is missing, compile.

    python packaging/languages.py collect [de ...]  bring resources/languages/*.ts up to date
    python packaging/languages.py compile           make the .qm that the window reads
    python packaging/languages.py missing [de ...]  texts without translation, as JSON lines
    python packaging/languages.py take de FILE      take translations from JSON lines, the same
                                                    with "to": a text, or the forms by number
    python packaging/languages.py unsaid [ROOM ...] words in the code that no translation reaches

A text is what stands in ``tr``, ``tr_count``, ``said`` and ``word``, and what tables hold: the
actions, the settings, the fields. A line that ends in ``# not shown`` holds words that nobody sees,
or that are of no language: names of keys and of programs.
"""

from __future__ import annotations

import ast
import json
import re
import subprocess
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from itertools import chain
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).parents[1]
PACKAGE = ROOT / "procc_annotator"
FOLDER = ROOT / "resources" / "languages"
LANGUAGES = ("de", "es", "fr", "ja", "zh_CN")
# As Qt's own rules have it: one form for all numbers, or one and many.
FORMS = {"de": 2, "es": 2, "fr": 2, "ja": 1, "zh_CN": 1}
CONTEXT = "procc"
SHOWN_ROOMS = ("gui", "interaction")
# Speak to a terminal, or paint pictures that are files: the window shows none of their words.
_NOT_OF_WINDOW = tuple(
    PACKAGE / name
    for name in (
        "gui/selftest.py",
        "gui/canvas/comparison_picture.py",
        "gui/canvas/comparison_picture.py",
        "gui/canvas/overlay_picture.py",
        "interaction/legend.py",
    )
)

_SAYING = {
    "tr": 1,
    "word": 1,
    "tr_count": 3,
    "translatable": 1,
    "translatable_count": 3,
}  # function -> how many of its arguments are texts
# Calls whose words are names for programs.
_SILENT = {"setObjectName", "setStyleSheet", "setProperty", "getattr", "setattr", "findChild",
           "TypeVar", "QRegularExpression", "compile", "NewType"}  # fmt: skip
_TABLES = {"_spec", "ActionSpec", "Setting", "Shown"}  # collected as values, not as code
_NOT_SHOWN = "# not shown"
# Two words, or one that begins a sentence; between the values of an f-string one will do.
_WORDS = re.compile(r"[^\W\d_]{2,}[,.:;]? +\(?[^\W\d_]{2,}|^[A-Z][a-z]{2,}[….:]?$")
_A_WORD = re.compile(r"(?<![\w.#])[^\W\d_]{2,}(?![\w(=])")
_UNITS = {"px", "mm", "km", "MB", "GB", "fps", "JaC"}


@dataclass(frozen=True)
class Text:
    """A text of the window.

    Attributes:
        source: the English words, the key of the translation.
        about: tells meanings apart.
        one: the English form for one thing; "" for a text that is about no number.
        places: where it is said.
    """

    source: str
    about: str = ""
    one: str = ""
    places: tuple[str, ...] = field(default=(), compare=False)


def collected() -> list[Text]:
    """All texts of the window, each once, by where they stand."""
    found: dict[tuple[str, str], Text] = {}
    for text in chain(_from_code(), _from_tables()):
        key = (text.source, text.about)
        known = found.get(key)
        if known is not None and bool(known.one) != bool(text.one):
            raise SystemExit(f"{text.places}: {text.source!r} is said with and without a number")
        found[key] = text if known is None else Text(
            text.source, text.about, text.one, (*known.places, *text.places)
        )  # fmt: skip
    return list(found.values())


def _modules(rooms: Iterable[str] = ("",)) -> Iterator[tuple[Path, ast.Module]]:
    for room in rooms:
        for file in sorted((PACKAGE / room).rglob("*.py")):
            yield file, ast.parse(file.read_text("utf-8"))


def _from_code() -> Iterator[Text]:
    for file, module in _modules():
        if file == PACKAGE / "translation.py":
            continue
        for node in ast.walk(module):
            if isinstance(node, ast.Call) and _name(node) in _SAYING:
                place = f"{file.relative_to(ROOT).as_posix()}:{node.lineno}"
                if text := _text_of(node, place):
                    yield text


def _text_of(call: ast.Call, place: str) -> Text | None:
    name, args = _name(call), call.args
    if any(isinstance(arg, ast.JoinedStr) for arg in args[: _SAYING[name]]):
        raise SystemExit(f"{place}: an f-string has no translation; name its values instead")
    if name in ("tr_count", "translatable_count"):
        one, several = _constant(args[1]), _constant(args[2])
        return Text(several, "", one, (place,)) if one and several else None
    source = _constant(args[0])
    about = _constant(args[1]) if len(args) > 1 else None
    for keyword in call.keywords:
        if keyword.arg == "about":
            about = _constant(keyword.value)
    return Text(source, about or "", "", (place,)) if source else None


def _constant(node: ast.expr) -> str | None:
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else None


def _name(call: ast.Call) -> str:
    function = call.func
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def _from_tables() -> Iterator[Text]:
    from procc_annotator.gui.actions import ACTIONS, MENUS
    from procc_annotator.gui.settings import LANGUAGE, OFFERED

    def named(place: str, *texts: str) -> Iterator[Text]:
        return (Text(text, places=(place,)) for text in texts if text)

    yield from named("the menus", *MENUS)
    for spec in ACTIONS:
        yield from named("the menus", *spec.menu.split("/"))
        yield from named(f"the action {spec.name}", spec.text.lstrip("-"), spec.tip)
    for setting in OFFERED:
        if (shown := setting.shown) is not None:
            place = f"the setting {setting.key}"
            yield from named(place, shown.group, shown.title, setting.text)
            if setting is not LANGUAGE:  # those are called by their own names
                yield from named(place, *(words for _, words in shown.choices))
    yield from _from_fields()


def _from_fields() -> Iterator[Text]:
    from procc_annotator.field.load import field_names, load_field

    for name in field_names():
        field, place = load_field(name), (f"the field {name}",)
        titled = (*field.elements, *field.dimensions)
        groups = (element.group for element in field.elements)
        for text in (field.title, *(one.title for one in titled), *groups):
            yield Text(text, places=place)
        for landmark in field.landmarks:
            yield Text(landmark.shown_title, places=place)
        for class_name in field.classes_without_geometry:
            yield Text(field.title_of(class_name), places=place)


# --- what is said past the translations -----------------------------------------------------------


def unsaid() -> list[str]:
    """Words in the rooms that show something and no translation reaches: ``file:line: words``."""
    told = []
    for file, module in _modules(SHOWN_ROOMS):
        if file in _NOT_OF_WINDOW:
            continue
        lines = file.read_text("utf-8").splitlines()
        for line, words in sorted(_Unsaid(module).found):
            if _NOT_SHOWN not in lines[line - 1]:
                told.append(f"{file.relative_to(ROOT).as_posix()}:{line}: {words!r}")
    return told


class _Unsaid(ast.NodeVisitor):
    """Goes through a module past what is said, what documents it, and what is a name."""

    def __init__(self, module: ast.Module) -> None:
        self.found: set[tuple[int, str]] = set()
        self.visit(module)

    def visit_Expr(self, node: ast.Expr) -> None:
        if not isinstance(node.value, ast.Constant):  # a docstring
            self.generic_visit(node)

    def visit_Assert(self, node: ast.Assert) -> None:
        self.visit(node.test)

    def visit_AnnAssign(self, node: ast.AnnAssign) -> None:
        if node.value is not None:
            self.visit(node.value)

    def visit_arguments(self, node: ast.arguments) -> None:
        for default in (*node.defaults, *node.kw_defaults):
            if default is not None:
                self.visit(default)

    def visit_FunctionDef(self, node: ast.FunctionDef) -> None:
        self.visit(node.args)
        for one in (*node.decorator_list, *node.body):
            self.visit(one)

    def visit_Call(self, node: ast.Call) -> None:
        name = _name(node)
        if name in _SILENT or name in _TABLES:
            return
        skipped = _SAYING.get(name, 0)
        if skipped == 1:
            skipped = 2  # what it is about tells meanings apart, and is shown to translators
        for one in (node.func, *node.args[skipped:], *(k.value for k in node.keywords)):
            self.visit(one)

    def visit_Compare(self, node: ast.Compare) -> None:
        for one in (node.left, *node.comparators):  # a text that is compared is a name
            if not isinstance(one, ast.Constant | ast.Tuple):
                self.visit(one)

    def visit_JoinedStr(self, node: ast.JoinedStr) -> None:
        words = "".join(_constant(part) or "{}" for part in node.values)
        if any(word not in _UNITS for word in _A_WORD.findall(words.replace("{}", " {} "))):
            self.found.add((node.lineno, words))
        for part in node.values:
            if isinstance(part, ast.FormattedValue):
                self.visit(part.value)

    def visit_Constant(self, node: ast.Constant) -> None:
        if isinstance(node.value, str) and _WORDS.search(node.value):
            self.found.add((node.lineno, node.value))


# --- the files ------------------------------------------------------------------------------------


def _path(language: str) -> Path:
    return FOLDER / f"{language}.ts"


def translations(language: str) -> dict[tuple[str, str], tuple[str, ...]]:
    """(source, about) -> the forms of its translation, those that are finished."""
    if not _path(language).exists():
        return {}
    known = {}
    for message in ElementTree.parse(_path(language)).iter("message"):
        translation = message.find("translation")
        if translation is None or translation.get("type") == "unfinished":
            continue
        forms = [form.text or "" for form in translation.iter("numerusform")]
        known[message.findtext("source", ""), message.findtext("comment", "")] = (
            tuple(forms) if forms else (translation.text or "",)
        )
    return known


def write(language: str, texts: list[Text], known: dict[tuple[str, str], tuple[str, ...]]) -> None:
    """Write a language's file: all texts, with the translations that are known."""
    root = ElementTree.Element("TS", version="2.1", language=language, sourcelanguage="en")
    context = ElementTree.SubElement(root, "context")
    ElementTree.SubElement(context, "name").text = CONTEXT
    for text in texts:
        message = ElementTree.SubElement(context, "message")
        if text.one:
            message.set("numerus", "yes")
        ElementTree.SubElement(message, "source").text = text.source
        if text.about:
            ElementTree.SubElement(message, "comment").text = text.about
        rooms = sorted({place.split(":")[0] for place in text.places})
        said = f"{text.one} / {text.source} " if text.one else ""
        ElementTree.SubElement(message, "extracomment").text = f"{said}[{', '.join(rooms[:3])}]"
        translation = ElementTree.SubElement(message, "translation")
        forms = known.get((text.source, text.about), ())
        if not forms:
            translation.set("type", "unfinished")
        if not text.one:
            translation.text = forms[0] if forms else ""
            continue
        for index in range(FORMS[language]):
            form = ElementTree.SubElement(translation, "numerusform")
            form.text = forms[index] if index < len(forms) else ""
    ElementTree.indent(root, " ")
    _path(language).parent.mkdir(exist_ok=True)
    body = ElementTree.tostring(root, encoding="unicode")
    _path(language).write_text(
        f'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n{body}\n', "utf-8"
    )


def missing(language: str) -> list[Text]:
    """The texts that a language does not have."""
    known = translations(language)
    return [text for text in collected() if (text.source, text.about) not in known]


def take(language: str, file: Path) -> None:
    """Put translations into a language's file: lines as ``missing`` gives them, with ``to``."""
    known, texts = translations(language), collected()
    by_key = {(text.source, text.about): text for text in texts}
    for line in file.read_text("utf-8").splitlines():
        if not line.strip():
            continue
        given = json.loads(line)
        key = (given["text"], given.get("about", ""))
        forms = (given["to"],) if isinstance(given["to"], str) else tuple(given["to"])
        if key not in by_key:
            raise SystemExit(f"{file}: the window does not say {key}")
        if faults := faults_of(by_key[key], language, forms):
            raise SystemExit(f"{file}: {key[0]!r}: {faults}")
        known[key] = forms
    write(language, texts, known)


def faults_of(text: Text, language: str, forms: tuple[str, ...]) -> str:
    """What is wrong with a translation; "" for nothing that can be told without reading it."""
    wanted = FORMS[language] if text.one else 1
    if len(forms) != wanted:
        return f"{len(forms)} forms instead of {wanted}"
    for form in forms:
        if not form.strip():
            return "nothing is said"
        lost = _places_of(text.source) ^ _places_of(form)
        if lost - ({"{n}"} if text.one else set()):  # "one frame" may say its number in words
            return f"places for values that only one of the two has: {sorted(lost)}"
        if (text.source[:1] == " ") != (form[:1] == " ") or text.source.endswith(
            " "
        ) != form.endswith(" "):
            return "spaces at the ends differ"
    return ""


def _places_of(text: str) -> set[str]:
    """Where values stand, and the patterns of files that a dialog filters by."""
    return set(re.findall(r"{\w*(?:[.!:][^{}]*)?}|\(\*[^()]*\)", text))


def compile_all() -> None:
    """Make the files the window reads."""
    for language in LANGUAGES:
        target = _path(language).with_suffix(".qm")
        command = ["pyside6-lrelease", "-silent", str(_path(language)), "-qm", str(target)]
        subprocess.run([Path(sys.executable).parent / command[0], *command[1:]], check=True)


def main() -> None:
    """Do what the command line says."""
    match sys.argv[1:]:
        case ["collect", *languages]:
            texts = collected()
            for language in languages or LANGUAGES:
                write(language, texts, translations(language))
        case ["compile"]:
            compile_all()
        case ["missing", *languages]:
            for language in languages or LANGUAGES:
                for text in missing(language):
                    print(json.dumps(_row(language, text), ensure_ascii=False))
        case ["take", language, file]:
            take(language, Path(file))
        case ["unsaid", *rooms]:
            for line in unsaid():
                if not rooms or any(room in line for room in rooms):
                    print(line)
        case _:
            raise SystemExit(__doc__)


def _row(language: str, text: Text) -> dict[str, object]:
    row: dict[str, object] = {"language": language, "text": text.source}
    if text.about:
        row["about"] = text.about
    if text.one:
        row |= {"one": text.one, "forms": FORMS[language]}
    return row | {"at": ", ".join(text.places[:2])}


if __name__ == "__main__":
    main()
