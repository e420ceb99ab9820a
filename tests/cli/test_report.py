"""``procc-annotator report``: one page, figures and tables, the same numbers as `evaluate`."""

import json
import re
import shutil
from dataclasses import dataclass
from functools import cached_property
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest
from typer.testing import Result

from procc_annotator.formats.cameras.registry import CAMERA_FORMATS
from procc_annotator.resources import resources_dir
from tests.cli.conftest import rows_in

pytestmark = pytest.mark.usefixtures("qapp")

SHOWN = ("Middle line", "Circle central", "Side line top", "Big rect. left main")
VOID = {"meta", "link", "img", "br", "hr", "input"}
CHEAP = ("--worst", 1, "--random", 1, "--date", "2024-06-01")


class Page(HTMLParser):
    """Parses a page strictly: every element is closed by its own end tag."""

    def __init__(self, text: str) -> None:
        super().__init__(convert_charrefs=True)
        self.open: list[str] = []
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.texts: list[tuple[str, str]] = []
        self.feed(text)
        self.close()
        assert self.open == [], f"not closed: {self.open}"

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self.open, f"</{tag}> closes nothing"
        assert self.open.pop() == tag, f"</{tag}> at {self.getpos()}"

    def handle_data(self, data: str) -> None:
        self.texts.append((self.open[-1] if self.open else "", data))

    def all(self, tag: str) -> list[dict[str, str | None]]:
        return [attributes for name, attributes in self.elements if name == tag]

    @property
    def text(self) -> str:
        return " ".join(data for owner, data in self.texts if owner not in ("style", "script"))


def keep_few(dataset):
    """Of every frame a few elements, where figures do not matter: each class is a panel to draw."""
    for path in dataset.annotations.iterdir():
        entries = json.loads(path.read_text())
        path.write_text(json.dumps({n: p for n, p in entries.items() if n in SHOWN}))
    return dataset


@pytest.fixture
def few(dataset):
    return keep_few(dataset)


def poor_cameras(dataset) -> Path:
    """One camera is turned, one is missing, one damaged."""
    poor = dataset.root / "poor"
    shutil.copytree(dataset.cameras, poor)
    turned = json.loads((poor / "camera_3.json").read_text())
    (poor / "camera_3.json").write_text(json.dumps(turned | {"pan_degrees": 1.0}))
    (poor / "camera_10.json").unlink()
    (poor / "camera_11.json").write_text("{")
    return poor


@pytest.fixture
def two_sources(dataset):
    """``good`` is exact, ``poor`` is not."""
    return dataset, poor_cameras(dataset)


def run(cli, dataset, out: Path, sources: dict[str, Path], *more: object, code: int | None = 0):
    given = [text for name, path in sources.items() for text in ("--cameras", f"{name}={path}")]
    return cli("report", dataset.root, *given, "-o", out, *CHEAP, *more, code=code)


@dataclass(frozen=True)
class Written:
    """A run, what it was about, and the page it wrote; other files lie beside the page."""

    done: Result
    dataset: Any
    out: Path

    @cached_property
    def page(self) -> Page:
        return Page(self.out.read_text(encoding="utf-8"))


def report_two(cli, dataset, out: Path):
    return run(
        cli, dataset, out, {"good": dataset.cameras, "poor": dataset.root / "poor"},
        "--disagreement", "good,poor", "--reference", "good", "-o", out.with_suffix(".tex"),
        "-o", out.with_suffix(".json"), code=1,
    )  # fmt: skip


@pytest.fixture(scope="module")
def compared(cli, qapp, new_dataset, tmp_path_factory) -> Written:
    """A page of an exact source and a poor one."""
    dataset = new_dataset()
    poor_cameras(dataset)
    out = tmp_path_factory.mktemp("compared") / "r.html"
    return Written(report_two(cli, dataset, out), dataset, out)


HOSTILE_TITLE = "<script>alert(1)</script>"
HOSTILE_NAME = "__<b>$x$ 100% a_b #{}~^&"


@pytest.fixture(scope="module")
def oddly_named(cli, qapp, new_dataset, tmp_path_factory) -> Written:
    """Frames, elements, sources and the page have names that mean something in HTML or LaTeX."""
    few = keep_few(new_dataset())
    shutil.copy(few.annotations / "1.json", few.annotations / "x<b>&'.json")
    shutil.copy(few.cameras / "camera_1.json", few.cameras / "camera_x<b>&'.json")
    labels = json.loads((few.annotations / "2.json").read_text())
    labels["<img src=x onerror=1>"] = [{"x": 0.5, "y": 0.5}]
    (few.annotations / "2.json").write_text(json.dumps(labels))
    out = tmp_path_factory.mktemp("oddly_named") / "r.html"
    named = [f"{name}={few.cameras}" for name in (HOSTILE_NAME, "相机", "Камеры ñ")]
    done = cli(
        "report", few.annotations, *(text for given in named for text in ("--cameras", given)),
        "-o", out, "-o", out.with_suffix(".tex"), *CHEAP, "--random", 9,
        "--title", HOSTILE_TITLE, "--threshold", 5,
    )  # fmt: skip
    return Written(done, few, out)


@pytest.fixture(scope="module")
def damaged(cli, qapp, new_dataset, tmp_path_factory) -> Written:
    """Frame 1 has no picture, that of 2 is damaged; 10 has no label, those of 11 are damaged."""
    few = keep_few(new_dataset())
    (few.root / "1.jpg").unlink()
    (few.root / "2.jpg").write_bytes(b"no picture")
    (few.annotations / "10.json").write_text("{}")
    (few.annotations / "11.json").write_text("[")
    out = tmp_path_factory.mktemp("damaged") / "r.html"
    sources = {"good": few.cameras, "same": few.cameras}
    return Written(run(cli, few, out, sources, "--random", 5, code=1), few, out)


def test_landmarks_are_told_apart_where_one_moves(cli, dataset, tmp_path):
    moving = {"name": "ball", "title": "The ball", "moving": True}
    ball = {"name": "ball", "position": [1, 2, -0.1], "instant": "t1"}
    flag = {"name": "flag", "title": "The flag", "position": [0, 0, -1.5]}
    (dataset.root / "landmarks.json").write_text(json.dumps({"landmarks": [moving, ball, flag]}))
    (dataset.root / "views.csv").write_text("frame,instant,view\n3,t1,main\n")
    clicks = {"flag": [{"x": 0.5, "y": 0.5}], "ball": [{"x": 0.5, "y": 0.52}]}
    for path in dataset.annotations.iterdir():
        path.unlink()
    (dataset.annotations / "3.json").write_text(json.dumps(clicks))
    out = tmp_path / "r.html"
    run(cli, dataset, out, {"good": dataset.cameras}, "--protocol", "procc")
    charted = Page(out.read_text()).text.split("Reprojection errors by class")[1]
    assert "ball" in charted  # named as in the files of figures
    assert "flag" in charted


@pytest.mark.usefixtures("no_charts")
def test_of_many_sources_those_that_lead_are_drawn(cli, two_sources, tmp_path):
    dataset, poor = two_sources
    sources = {"poor": poor, **{f"good{n}": dataset.cameras for n in range(12)}}
    out = tmp_path / "r.html"
    run(cli, dataset, out, sources, code=1)
    page = Page(out.read_text()).text
    assert "the 12 sources of 13 with the highest JaC" in page
    alternatives = out.read_text()
    assert "projection of good11" in alternatives
    assert "projection of poor" not in alternatives
    assert "poor" in page  # in the tables


@pytest.mark.usefixtures("no_charts")
def test_what_lowers_every_score_is_told(cli, few, tmp_path):
    for path in few.annotations.iterdir():
        entries = json.loads(path.read_text())
        if path.stem in ("3", "10"):
            entries = {
                key: [{"x": 959 * p["x"], "y": 539 * p["y"]} for p in points]
                for key, points in entries.items()
            }
        entries |= {"Line unknown": [{"x": 0.5, "y": 0.5}]} if path.stem == "1" else {}
        path.write_text(json.dumps({} if path.stem == "2" else entries))
    told = (
        "coordinates look like pixels, expected 0 to 1, in 2 frames (3, 10)",
        "no element is annotated in 1 frame (2): whatever a camera shows is wrong",
        "classes of no element of the field always count as missed: Line unknown, in 1 frame (1)",
    )
    out = tmp_path / "r.html"
    both = cli("evaluate", *few.set_arguments).stderr, run(cli, few, out, {"a": few.cameras}).stderr
    for line in told:
        assert [stderr.count(line) for stderr in both] == [1, 1]
        assert f"{line[0].upper()}{line[1:]}." in Page(out.read_text()).text


def test_figures_are_those_of_evaluate(cli, two_sources, tmp_path):
    dataset, poor = two_sources
    sources = {"good": dataset.cameras, "poor": poor}
    run(cli, dataset, tmp_path / "r.json", sources, "-o", tmp_path / "r.csv", code=1)
    said = json.loads((tmp_path / "r.json").read_text())
    rows = rows_in(tmp_path / "r.csv")
    for found in said["sources"]:
        scores = tmp_path / f"{found['name']}.json"
        cli(
            "evaluate", dataset.annotations, sources[found["name"]],
            "-t", 5, "-t", 2, "-t", 10, "-o", scores, code=None,
        )  # fmt: skip
        wanted = json.loads(scores.read_text())
        assert found["summary"] == wanted["summary"]
        for image, expected in zip(found["images"], wanted["images"], strict=True):
            assert image["name"] == expected["name"]
            for tau, figures in expected["results"].items():
                figures.pop("elements")
                assert image["results"][tau] == figures
        for row in rows:
            if row["source"] != found["name"]:
                continue
            summary = wanted["summary"][row["threshold"]]
            if row["class"]:
                assert float(row["mean_jac"]) == summary["per_class"][row["class"]]["jac"]
            else:
                assert float(row["mean_jac"]) == summary["mean_jac"]
                assert float(row["final_score"]) == summary["final_score"]
                error = summary["mean_reprojection_error"]
                assert float(row["mean_reprojection_error"]) == error
    assert said["sources"][1]["summary"]["5"]["completeness"] == 0.6
    assert said["sources"][0]["summary"]["5"]["mean_jac"] == 1.0
    assert said["sources"][1]["summary"]["5"]["mean_jac"] < 1.0


def test_the_page_shows_them_and_loads_nothing(compared):
    done, page, out = compared.done, compared.page, compared.out
    assert done.exit_code == 1, done.output
    assert "camera_11.json" in done.stderr
    summary = json.loads(out.with_suffix(".json").read_text())["sources"][1]["summary"]
    for tau in ("2", "5", "10"):
        assert f"{100 * summary[tau]['mean_jac']:.2f}" in page.text
    assert "60.00" in page.text  # completeness of the poor source
    assert f"{summary['5']['mean_error']:.2f}" in page.text
    assert "soccernet, 960x540" in page.text
    assert "camera_11.json" in page.text
    for folder in (compared.dataset.root.parent, out.parent):
        assert str(folder) not in out.read_text(encoding="utf-8")
    assert "is too far: point" in page.text
    check_self_contained(page)
    assert all(image["alt"] for image in page.all("img"))
    assert all(cell.get("scope") for cell in page.all("th"))
    pictures = [image["src"] or "" for image in page.all("img")]
    # A worst one and one by lot for either source, and the three frames that can be compared.
    assert [src.partition(";")[0] for src in pictures] == ["data:image/jpeg"] * 7
    tex = out.with_suffix(".tex").read_text()
    assert tex.count(r"\begin{tabular}") == tex.count(r"\end{tabular}")
    assert tex.count(r"\begin{table") == tex.count(r"\end{table") == tex.count(r"\caption")
    captions = re.findall(r"\\caption\{(.*?) \((?:soccer|part)", tex)
    assert len({*captions}) == 6, captions  # wide ones are split
    for title in ("Comparison of methods", "Intervals", "Is the difference real", "Ranks"):
        assert rf"\caption{{{title}" in tex
    best = re.search(r"^good .*$", tex, re.MULTILINE)
    assert "100.00" in best[0]
    assert r"\textbf" not in best[0]  # five frames tell nothing beyond chance


RESOURCES = resources_dir() / "report"


def check_self_contained(page: Page) -> None:
    names = {attributes.get("id") for _, attributes in page.elements}
    for tag, attributes in page.elements:
        assert tag not in ("link", "iframe", "object", "base")
        assert not any(name.startswith("on") for name in attributes), (tag, attributes)
        for key in ("src", "href", "xlink:href", "data", "srcset"):
            target = attributes.get(key)
            if target is None:
                continue
            assert target.startswith(("data:image/", "#")), (tag, key, target[:80])
            if target.startswith("#"):
                assert target[1:] in names, target
    scripts = [data for owner, data in page.texts if owner == "script"]
    assert "".join(scripts) in ("", (RESOURCES / "sort.js").read_text())  # none but ours
    style = " ".join(data for owner, data in page.texts if owner == "style")
    assert "url(" not in style
    assert "@import" not in style
    ids = [a["id"] for _, a in page.elements if a.get("id")]
    assert len(ids) == len(set(ids))


def test_the_same_input_gives_the_same_bytes(cli, compared, tmp_path):
    again = tmp_path / "again.html"
    report_two(cli, compared.dataset, again)
    assert again.read_bytes() == compared.out.read_bytes()
    other = tmp_path / "other.html"
    run(cli, compared.dataset, other, {"good": compared.dataset.cameras}, "--seed", 3)
    assert other.read_bytes() != again.read_bytes()


@pytest.mark.usefixtures("no_charts")
def test_annotations_alone_are_drawn_on_plain_ground(cli, few, tmp_path):
    out = tmp_path / "r.html"
    archive = shutil.make_archive(str(tmp_path / "labels"), "zip", few.annotations)
    for given in (few.annotations, archive):
        cli("report", given, "--cameras", few.cameras, "-o", out, *CHEAP)
        page = Page(out.read_text(encoding="utf-8"))
        assert "drawn on plain ground" in page.text
        assert all((i["src"] or "").startswith("data:image/jpeg") for i in page.all("img"))
    assert "Cameras of labels" in page.text


def test_pictures_missing_for_some(damaged):
    assert "2.jpg" in damaged.done.stderr
    page = damaged.page
    assert "The picture cannot be read: drawn on plain ground." in page.text
    assert "No picture of this frame: drawn on plain ground." in page.text
    assert "2.jpg" in page.text
    for folder in (damaged.dataset.root.parent, damaged.out.parent):
        assert str(folder) not in page.text


def test_hostile_names_are_only_text(oddly_named):
    page = oddly_named.page
    check_self_contained(page)
    assert "x<b>&'" in page.text
    assert "<img src=x onerror=1>" in page.text
    assert HOSTILE_TITLE in page.text
    assert HOSTILE_NAME in page.text
    tex = oddly_named.out.with_suffix(".tex").read_text()
    row = next(line for line in tex.splitlines() if "100\\%" in line)
    wanted = r"\_\_\textless{}b\textgreater{}\$x\$ 100\% a\_b \#\{\}\textasciitilde{}"
    name, *_ = row.replace(r"\allowbreak{}", "").split(" & ")
    assert wanted + r"\textasciicircum{}\&" in name
    assert r"\label{tab:comparison}" in tex
    assert " & pinhole P" in tex


def test_a_source_that_shares_projections_only(cli, few, tmp_path):
    """It is judged like any other; what needs the ground is told to be impossible."""
    if "polylines" not in CAMERA_FORMATS:
        pytest.skip("projected polylines cannot be read yet")
    out = tmp_path / "r.html"
    done = cli(
        "report", few.root, "--cameras", f"good={few.cameras}", "-o", out, *CHEAP,
        "--cameras", f"lines:polylines={few.annotations}", "--disagreement", "good,lines", code=1
    )  # fmt: skip
    assert "good, lines" in done.stderr
    page = Page(out.read_text(encoding="utf-8"))
    check_self_contained(page)
    assert "Without a pose: lines." in page.text
    assert "good, lines" in page.text


def test_names_in_any_script(oddly_named):
    in_charts = [data.strip() for owner, data in oddly_named.page.texts if owner == "text"]
    assert "相机" in in_charts
    assert "Камеры ñ" in in_charts


def test_one_frame_only(cli, dataset, tmp_path):
    for file in [*dataset.annotations.iterdir(), *dataset.cameras.iterdir()]:
        if file.stem.removeprefix("camera_") != "3":
            file.unlink()
    out = tmp_path / "r.html"
    run(cli, dataset, out, {"only": dataset.cameras}, "-o", tmp_path / "r.tex")
    page = Page(out.read_text(encoding="utf-8"))
    assert "1 annotated frame " in page.text.replace("·", " ")
    assert "textbf" not in (tmp_path / "r.tex").read_text()  # no best of one


def test_a_source_without_any_camera_is_listed(cli, few, tmp_path):
    empty = tmp_path / "empty"
    empty.mkdir()
    out = tmp_path / "r.html"
    done = run(
        cli, few, out, {"good": few.cameras, "none": empty}, "--disagreement", "good,none", code=1
    )
    assert "no camera" in done.stderr
    page = Page(out.read_text(encoding="utf-8"))
    assert "no camera" in page.text
    check_self_contained(page)
    done = run(cli, few, out, {"none": empty}, code=2)
    assert "no camera" in done.stderr


@pytest.mark.usefixtures("no_charts")
def test_a_damaged_camera_is_told_once(cli, few, tmp_path):
    file = next(iter(sorted(few.cameras.glob("camera_*.json"))))
    file.write_text("{")
    done = run(cli, few, tmp_path / "r.html", {"damaged": few.cameras}, code=1)
    assert done.stderr.count(file.name) == 1, done.stderr


@pytest.mark.parametrize("focal", [1e308, pytest.param(1e200, marks=pytest.mark.soak)])
def test_an_absurd_camera_does_not_stop_the_report(cli, few, tmp_path, focal):
    file = next(iter(sorted(few.cameras.glob("camera_*.json"))))
    file.write_text(json.dumps(json.loads(file.read_text()) | {"x_focal_length": focal}))
    out = tmp_path / "r.html"
    run(cli, few, out, {"damaged": few.cameras})
    assert "values over a million are left out" in Page(out.read_text(encoding="utf-8")).text


def test_an_empty_frame_and_a_damaged_annotation(damaged):
    assert damaged.done.stderr.count("11.json") == 1  # said once, not for every source
    assert "4 annotated frames" in damaged.page.text


def test_an_interruption_leaves_no_half_file(cli, dataset, tmp_path, monkeypatch):
    out = tmp_path / "out"
    out.mkdir()
    (out / "r.html").write_text("what was there")

    def interrupted(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("procc_annotator.report.page.report.draw_charts", interrupted)
    run(cli, dataset, out / "r.html", {"good": dataset.cameras}, "-o", out / "r.csv", code=130)
    assert [p.name for p in out.iterdir()] == ["r.html"]
    assert (out / "r.html").read_text() == "what was there"


@pytest.mark.usefixtures("no_charts")
def test_the_usual_page_replaces_reports_alone(cli, few, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    asked = ("report", few.annotations, "--cameras", few.cameras, "--worst", 0, "--random", 0)
    page = tmp_path / "report.html"
    for _ in range(2):
        done = cli(*asked)
        assert "written: report.html" in done.stdout
    page.write_text(notes := "<p>my own notes</p>")
    done = cli(*asked, code=2)
    assert "report.html: is there already, and no report wrote it" in done.stderr
    assert page.read_text() == notes
    cli(*asked, "-o", page)
