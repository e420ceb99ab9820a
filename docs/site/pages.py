"""Pages of the site that lie elsewhere in the repository, or follow from what lies there.

The start page is the README, the decisions are listed by their titles, and the Python API is what
the package names.
"""

from __future__ import annotations

import re
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

import procc_annotator

ROOT = Path(__file__).resolve().parents[2]
PICTURE = re.compile(r"!\[([^\]]*)\]\((\S*pictures/)([\w-]+)\.(webp|svg)\)")
BEGINS = re.compile(r"- |1\. |\|")  # a list, a table
GOES_ON = re.compile(r"- |\d+\. |\||\s|#")  # what either stands behind without a line between

# Where the names of the package are told of, in the order of the page.
REFERENCE = {
    "Reading": ("load_", "Dataset", "LoadedCamera", "field_names"),
    "Annotations": ("FrameAnnotation", "Polyline", "Point"),
    "Cameras": (
        "camera_from_",
        "save_",
        "Camera",
        "Pinhole",
        "Fisheye",
        "Homography",
        "Matrix",
    ),
    "Fields": ("Field", "Element"),
    "Scores": ("evaluate", "jac_curve", "SetScore", "SetSummary", "Class", "FrameScore"),
    "Sets of methods": ("compare_", "write_report", "SetOptions"),
    "Pixels to metres": ("to_", "PlacedPoints", "homography_of", "NearestHomography"),
    "Differences": ("disagreement", "Disagreement", "Interval", "Paired", "corrected_for"),
    "Finding cameras": (
        "fit_",
        "Fit",
        "leave_one_out",
        "LeftOut",
        "propose_",
        "Proposal",
        "KnownPosition",
        "track",
        "Track",
    ),
    "Checking labels": ("check_", "Finding"),
    "Drawing": ("project_", "draw_", "ElementProjections"),
}
ERRORS = "Errors"
API_PAGES = {
    "api": ("data", ("Reading", "Annotations", "Cameras", "Fields", ERRORS)),
    "api-scores": ("scores", ("Scores", "Sets of methods", "Differences")),
    "api-estimation": (
        "estimation, metres, drawing",
        ("Pixels to metres", "Finding cameras", "Checking labels", "Drawing"),
    ),
}


def on_files(files: Files, config: MkDocsConfig) -> Files:
    """Add the pages that are made here."""
    made = {
        "index.md": _from_root("README.md"),
        "changelog.md": _from_root("CHANGELOG.md"),
        "contributing.md": _from_root("CONTRIBUTING.md"),
        "security.md": _from_root("SECURITY.md"),
        "CITATION.cff": (ROOT / "CITATION.cff").read_text(encoding="utf-8"),
        "decisions/index.md": _decisions(),
        **api_pages(),
    }
    for name, content in made.items():
        files.append(File.generated(config, name, content=content))
    return files


def on_page_markdown(markdown: str, page: Page, config: MkDocsConfig, files: Files) -> str:
    """A folder's link leads to its list; a picture that there is in both themes follows them."""
    markdown = markdown.replace("](decisions/)", "](decisions/index.md)")
    if re.match(r"decisions/\d", page.file.src_uri):
        page.meta["search"] = {"exclude": True}  # the pages of their subjects come first
    return PICTURE.sub(_in_both_themes, set_apart(markdown))


def set_apart(markdown: str) -> str:
    """Lists and tables with an empty line before them, without which they are text to the site."""
    lines: list[str] = []
    code = False
    for line in markdown.splitlines():
        code ^= line.lstrip().startswith("```")
        begins = BEGINS.match(line) if lines and not code else None
        if begins and lines[-1].strip() and not GOES_ON.match(lines[-1]):
            lines.append("")
        lines.append(line)
    return "\n".join(lines)


def _in_both_themes(found: re.Match[str]) -> str:
    title, folder, name, suffix = found.groups()
    if not (ROOT / "docs" / "pictures" / f"{name}-dark.{suffix}").exists():
        return found.group(0)
    light, dark = f"{folder}{name}.{suffix}#only-light", f"{folder}{name}-dark.{suffix}#only-dark"
    return f"![{title}]({light})![{title}]({dark})"


def _from_root(name: str) -> str:
    """Return a page of the repository's root, with links as from `docs`."""
    text = (ROOT / name).read_text(encoding="utf-8").replace("](docs/", "](")
    return re.sub(r"\]\(([A-Z]+\.md)\)", lambda link: f"]({link[1].lower()})", text)


def _decisions() -> str:
    lines = ["# Decisions", "", "What was decided, why, and what was rejected.", ""]
    for file in sorted((ROOT / "docs" / "decisions").glob("[0-9]*.md")):
        number, title = re.match(r"# (\d+)\. (.*)", file.read_text(encoding="utf-8")).groups()
        lines.append(f"{number}. [{title}]({file.name})")
    return "\n".join(lines) + "\n"


def api_pages() -> dict[str, str]:
    """Every public name under its heading, on three pages of like size.

    Raises:
        PluginError: a name has no heading yet; this stops the build.
    """
    left = [name for name in procc_annotator.__all__ if name != "__version__"]
    pages = {}
    for page, (about, headings) in API_PAGES.items():
        parts = [f"# Python API: {about}", "Introduction: [Python](python.md)."]
        for title in headings:
            beginnings = REFERENCE.get(title, ("",))
            here = [n for b in beginnings for n in left if n.startswith(b) and _is_error(n, title)]
            here = list(dict.fromkeys(here))
            left = [name for name in left if name not in here]
            parts += [f"## {title}", *(f"::: procc_annotator.{name}" for name in here)]
        pages[f"reference/{page}.md"] = "\n\n".join(parts) + "\n"
    if left:
        raise PluginError(f"docs/site/pages.py: REFERENCE has no heading for {', '.join(left)}")
    return pages


def _is_error(name: str, title: str) -> bool:
    return name.endswith("Error") == (title == ERRORS)
