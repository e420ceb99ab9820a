"""The languages of the window: which there are, and how one is taken up at the start."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator

from procc_annotator import translation
from procc_annotator.resources import resources_dir

CONTEXT = "procc"  # of all texts in the files of translations
SYSTEM, ENGLISH = "system", "en"

# Each by its own name: anyone who looks for theirs cannot read the others.
LANGUAGES = {
    ENGLISH: "English",  # not shown
    "de": "Deutsch",  # not shown
    "es": "Español",
    "fr": "Français",
    "ja": "日本語",
    "zh_CN": "简体中文",
}

_taken_up: list[QTranslator] = []


def folder() -> Path:
    """Return where the translations are."""
    return resources_dir() / "languages"


def of_system() -> str:
    """The first language the system asks for that there is, or English."""
    for asked in QLocale.system().uiLanguages():
        name = asked.replace("-", "_")
        for known in LANGUAGES:
            if name == known or name.split("_")[0] == known.split("_")[0]:
                return known
    return ENGLISH


def take_up(app: QCoreApplication, chosen: str) -> None:
    """Have all that is made from now on speak a language; what was made keeps its words.

    Args:
        chosen: a key of ``LANGUAGES``, or ``SYSTEM``.
    """
    while _taken_up:
        app.removeTranslator(_taken_up.pop())
    translation.set_translator(None)
    name = of_system() if chosen == SYSTEM else chosen
    if name == ENGLISH:
        return
    of_qt = Path(QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath))
    for file in (of_qt / f"qtbase_{name}.qm", folder() / f"{name}.qm"):
        translator = QTranslator(app)
        if translator.load(str(file)):
            app.installTranslator(translator)
            _taken_up.append(translator)
    translation.set_translator(_look_up)


def _look_up(text: str, about: str, count: int) -> str:
    return QCoreApplication.translate(CONTEXT, text, about or None, count)
