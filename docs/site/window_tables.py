"""Pages of the window's actions and settings, generated from their tables."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from itertools import groupby
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files

from procc_annotator.gui.actions import ACTIONS
from procc_annotator.gui.keymap import GESTURES
from procc_annotator.gui.settings import OFFERED

sys.path.insert(0, str(Path(__file__).parent))

from commands import escaped


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the page of actions and keys, and that of the settings."""
    for name, lines in (("keys", _actions()), ("settings", _settings())):
        content = "\n".join(lines) + "\n"
        files.append(File.generated(config, f"reference/{name}.md", content=content))
    return files


def _actions() -> Iterator[str]:
    yield "# Actions and keys"
    yield "\nKeys can be changed in *Help > Keys*. On macOS, Ctrl is Cmd."
    yield "\n## Mouse and held keys\n"
    yield "| gesture | effect |\n|---|---|"
    yield from (f"| {escaped(gesture)} | {escaped(effect)} |" for gesture, effect in GESTURES)
    for menu, actions in groupby(sorted(ACTIONS, key=_menu_order), lambda a: a.menu):
        yield f"\n## {menu.replace('/', ' > ')}\n\n| action | keys | effect |\n|---|---|---|"
        for action in actions:
            keys = ", ".join(f"`{key}`" for key in action.keys)
            yield f"| {escaped(action.text.lstrip('-'))} | {keys} | {escaped(action.tip)} |"


def _menu_order(action: object) -> int:
    menus = list(dict.fromkeys(one.menu for one in ACTIONS))
    return menus.index(action.menu)


def _settings() -> Iterator[str]:
    yield "# Settings\n\n*Edit > Settings* (`Ctrl+,`). They are kept per user, not per dataset."
    shown = [setting for setting in OFFERED if setting.shown]
    for group in dict.fromkeys(setting.shown.group for setting in shown):
        yield f"\n## {group}\n\n| setting | default | meaning |\n|---|---|---|"
        for setting in shown:
            if setting.shown.group == group:
                words = dict(setting.shown.choices)
                default = words.get(setting.default, setting.default)
                if isinstance(default, bool):
                    default = "on" if default else "off"
                elif isinstance(default, float):
                    default = f"{default * setting.shown.times:g}{setting.shown.unit}"
                title, text = escaped(setting.shown.title), escaped(setting.text)
                yield f"| {title} | {default or '–'} | {text} |"
