"""The site's menu leads to every page; what it shows besides, `make docs` checks."""

import re
from pathlib import Path

ROOT = Path(__file__).parents[1]


def test_every_page_is_in_the_menu_and_nothing_else():
    menu = re.findall(r"^ +- .*: (\S+\.md)$", (ROOT / "mkdocs.yml").read_text(), re.M)
    made = {"index.md", "commands.md", "reference.md", "every-figure.md", "changelog.md"}
    made.add("decisions/index.md")  # which leads to each of them
    docs = ROOT / "docs"
    pages = {path.relative_to(docs).as_posix() for path in docs.rglob("*.md")}
    written = {page for page in pages if not page.startswith("decisions/")}
    assert sorted(menu) == sorted(made | written)


def test_pictures_of_the_readme_are_there_in_both_themes():
    readme = (ROOT / "README.md").read_text()
    shown = [ROOT / name for name in re.findall(r"\]\((docs/pictures/\S+)\)", readme)]
    assert len(shown) > 5
    for picture in shown:
        light = picture.with_name(picture.name.replace("-dark", ""))
        assert light.is_file()
        assert light.with_stem(f"{light.stem}-dark").is_file()
