"""The site's menu leads to every page; what it shows besides, `make docs` checks."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[1]


def test_every_page_is_in_the_menu_and_nothing_else():
    menu = re.findall(r"^ +- (\S+\.md)$", (ROOT / "mkdocs.yml").read_text(), re.M)
    made = {"index.md", "changelog.md", "contributing.md", "security.md", "decisions/index.md"}
    made |= {f"reference/{name}.md" for name in ("commands", "metrics", "keys", "settings")}
    made |= {f"reference/api{part}.md" for part in ("", "-scores", "-estimation")}
    docs = ROOT / "docs"
    pages = {path.relative_to(docs).as_posix() for path in docs.rglob("*.md")}
    written = {page for page in pages if not page.startswith(("decisions/", "examples/"))}
    assert sorted(menu) == sorted(made | written)


def test_pictures_of_the_pages_are_there_in_both_themes():
    shown = set()
    for page in (ROOT / "README.md", *(ROOT / "docs").rglob("*.md")):
        for name in re.findall(r"!\[[^\]]*\]\((\S+)\)", page.read_text()):
            shown.add((page.parent / name).resolve())
    assert len(shown) >= 25
    for picture in shown:
        if picture.name.startswith(("output-", "layout")):  # alike in both themes
            assert picture.is_file()
            continue
        light = picture.with_name(picture.name.replace("-dark", ""))
        assert light.is_file()
        assert light.with_stem(f"{light.stem}-dark").is_file()
