"""Every two-way format gives back what it was given: real frames, and any other."""

import json
from pathlib import Path
from xml.etree import ElementTree

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from procc_annotator.annotation import FrameAnnotation, Point, Polyline
from procc_annotator.errors import UsageError
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.exchange import (
    ExchangedFrame,
    ReadContext,
    WriteContext,
    normalised,
    to_px,
)
from procc_annotator.formats.annotations.registry import (
    WRITTEN,
    find_annotations,
    format_named,
)
from procc_annotator.formats.annotations.soccernet import read_annotation, write_annotation
from procc_annotator.formats.file_source import open_source
from procc_annotator.formats.strict_json import WrittenNumber, json_text, number_text, parse_number

SOCCER = load_field("soccer")
SIZE = (1280, 720)
COCO_FILE = "annotations/person_keypoints_default.json"
TRACKS = "cvat-video"  # knows neither an order of a frame's classes nor what pictures are called
TWO_WAY = pytest.mark.parametrize(
    "name", [f.name for f in WRITTEN if f.read is not None and f.name != TRACKS]
)


def write(name: str, frames: list[ExchangedFrame], folder: Path) -> WriteContext:
    """Write frames to a new folder."""
    folder.mkdir()

    def put(file: str, data: bytes) -> bool:
        (folder / file).parent.mkdir(parents=True, exist_ok=True)
        (folder / file).write_bytes(data)
        return True

    writing = WriteContext(SOCCER, put)
    format_named(name).write(iter(frames), writing)
    return writing


def read(folder: Path, fmt: str = "auto") -> tuple[dict[str, ExchangedFrame], ReadContext]:
    """Read a folder."""
    with open_source(folder) as source:
        known, files = find_annotations(source, fmt)
        reading = ReadContext(SOCCER)
        assert known.read is not None
        return {f.name: f for f in known.read(source, files, reading)}, reading


@pytest.fixture(scope="module")
def real_frames(shared_data) -> dict[str, bytes]:
    files = (shared_data / "wc14" / "annotations").glob("*.json")
    return {path.stem: path.read_bytes() for path in files}


@pytest.mark.parametrize(
    ("count", "held"),
    [
        (25, None),
        pytest.param(186, (186, 1685, 7418), marks=pytest.mark.soak),
    ],
)
@TWO_WAY
def test_real_frames_come_back_to_the_last_digit(name, count, held, real_frames, tmp_path):
    real_frames = dict(sorted(real_frames.items())[:count])
    frames = [
        ExchangedFrame(n, read_annotation(d, path=n, field=SOCCER), SIZE, f"{n}.jpg")
        for n, d in real_frames.items()
    ]
    writing = write(name, frames, tmp_path / name)
    of_annotations = [frame.annotation for frame in frames]
    lines = [line for annotation in of_annotations for line in annotation.polylines]
    counted = count, len(lines), sum(len(line.points) for line in lines)
    assert (writing.frames, writing.elements, writing.points) == counted
    assert held in (None, counted)
    assert writing.remarks.lines() == []
    back, reading = read(tmp_path / name)
    assert reading.problems == []
    assert reading.remarks.lines() == []
    assert len(back) == count
    for frame, data in real_frames.items():
        text = write_annotation(back[frame].annotation)
        assert json.dumps(json.loads(text)) == json.dumps(json.loads(data))


# ------------------------------------------------------------------------------------- numbers


@given(st.floats(-1e6, 1e6), st.integers(1, 20_000))
def test_a_coordinate_survives_pixels_exactly(u, extent):
    text = number_text(to_px(u, extent))
    back = normalised(parse_number(text), extent)
    if abs(u) > 1e-20 or u == 0:
        assert back == u
    else:
        assert back == pytest.approx(u, abs=1e-30)


@given(st.floats(-10, 10), st.integers(1, 20_000))
def test_other_programs_read_the_same_pixel(u, extent):
    """What does not fit a float is rounded by them to the nearest one."""
    assert float(number_text(to_px(u, extent))) == pytest.approx(u * extent, rel=1e-15, abs=1e-300)


def test_whole_numbers_stay_whole():
    assert number_text(to_px(1, 1279)) == "1279"


@pytest.mark.parametrize("extent", [959, 719, 1919])
def test_pixels_of_few_digits_are_written_with_these_digits(extent):
    for px in (*map(float, range(extent)), 0.1, 333.3, 500.125, 611.2345678):
        assert number_text(to_px(normalised(px, extent), extent)) == repr(px)
    assert type(normalised(1279, 1279)) is int
    assert normalised(640, 1279) == 640 / 1279


@pytest.mark.parametrize(
    "text",
    ["1e999999999", "1.00000000000000000001e999999", "0." + "0" * 400 + "1", "1." + "1" * 100_000],
)
def test_numbers_made_to_hurt_take_no_time(text):
    assert type(parse_number(text)) is float


def test_longer_numbers_reach_the_file():
    number = parse_number("290.21008824709182600")
    assert isinstance(number, WrittenNumber)
    assert json_text({"a": [number]}, 0) == '{"a": [290.21008824709182600]}'


# ------------------------------------------------------------------------------------- anything

NAMES = [*(e.name for e in SOCCER.elements), *SOCCER.classes_without_geometry]
# Below 1e-30 px the last digit may change.
coordinates = st.floats(-3, 4).map(lambda u: u if abs(u) > 1e-20 else 0.0) | st.sampled_from([0, 1])
points = st.builds(Point, coordinates, coordinates, st.just(()))
point_lists = st.lists(points, min_size=1, max_size=6)
texts = st.text(
    st.characters(codec="utf-8", exclude_categories=["Cc", "Cs", "Cn"]), min_size=1, max_size=8
)


@st.composite
def annotations(draw: st.DrawFn) -> FrameAnnotation:
    known = draw(st.lists(st.sampled_from(NAMES), max_size=5, unique=True))
    unknown = draw(st.lists(texts.filter(lambda t: t == SOCCER.canonical_name(t)), max_size=2))
    names = list(dict.fromkeys([*known, *(n for n in unknown if n != "pan_degrees")]))
    return FrameAnnotation(tuple(Polyline(n, tuple(draw(point_lists))) for n in names))


@TWO_WAY
@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(annotations(), st.tuples(st.integers(2, 4000), st.integers(2, 4000)))
def test_any_annotation_comes_back(name, tmp_path_factory, annotation, size):
    folder = tmp_path_factory.mktemp("any") / "set"
    writing = write(name, [ExchangedFrame("7", annotation, size, "7.png")], folder)
    back, reading = read(folder, name)
    assert reading.problems == []
    if not annotation.polylines and writing.remarks.lines():
        assert back == {}  # and that was said
        return
    assert back["7"].annotation == annotation


# ------------------------------------------------------------------------------------- losses

RICH = FrameAnnotation(
    (
        Polyline("Side line top", (Point(0.1, 0.2, (("seen", True),)), Point(0.5, 0.25))),
        Polyline("Circle left", ()),
        Polyline("Middle line", (Point(0.5, 0.5),)),
    ),
    (("weather", "rain"), ("crew", ["a", "b"])),
)
PLAIN_POINTS = (Point(0.1, 0.2), Point(0.5, 0.25))


@pytest.mark.parametrize(
    ("name", "point_keys", "empty", "extra"),
    [
        ("soccernet", True, True, True),
        ("soccernet-gsr", True, True, True),
        ("soccernet-v3", False, True, True),
        ("coco", False, True, True),
        ("labelme", False, False, True),
        ("cvat", False, False, False),
    ],
)
def test_what_a_format_cannot_hold_is_told(name, point_keys, empty, extra, tmp_path):
    writing = write(name, [ExchangedFrame("1", RICH, SIZE, "1.jpg")], tmp_path / "set")
    back = read(tmp_path / "set")[0]["1"].annotation
    told = " ".join(writing.remarks.lines())
    assert (back.polylines[0] == RICH.polylines[0]) is point_keys
    assert tuple(p[:2] for p in back.polylines[0].points) == tuple(p[:2] for p in PLAIN_POINTS)
    assert ("keys of points" in told) is not point_keys
    assert ("Circle left" in [p.class_name for p in back.polylines]) is empty
    assert ("without a point" in told) is not empty
    assert (back.extra == RICH.extra) is extra
    assert ("entries of a frame" in told) is not extra
    assert back.get("Middle line") == RICH.polylines[2]


@pytest.mark.parametrize(
    "name", ["soccernet-v3", "labelme", "cvat", TRACKS, "coco", "yolo-pose", "masks"]
)
def test_a_frame_without_a_size_is_left_out_and_told(name, tmp_path):
    frames = [ExchangedFrame("1", RICH), ExchangedFrame("2", RICH, SIZE)]
    writing = write(name, frames, tmp_path / "set")
    assert writing.frames == 1
    (problem,) = writing.problems
    assert problem.startswith("1: not written: the size of its picture is not known")


def test_numbered_classes_are_one_class_again_where_several_may_be(tmp_path):
    names = ("Line unknown", "Line unknown (2)", "Line unknown (4)", "odd (2)")
    annotation = FrameAnnotation(tuple(Polyline(n, PLAIN_POINTS) for n in names))
    for name in ("soccernet-v3", "labelme", "cvat", "coco"):
        folder = tmp_path / name
        write(name, [ExchangedFrame("1", annotation, SIZE)], folder)
        assert read(folder)[0]["1"].annotation == annotation
    labels = [
        s["label"] for s in json.loads((tmp_path / "labelme" / "1.json").read_text())["shapes"]
    ]
    assert labels == ["Line unknown", "Line unknown", "Line unknown (4)", "odd (2)"]


# ------------------------------------------------------------------------------------- telling


@TWO_WAY
def test_formats_are_told_by_their_content(name, tmp_path):
    write(name, [ExchangedFrame("1", RICH, SIZE)], tmp_path / "set")
    with open_source(tmp_path / "set") as source:
        assert find_annotations(source)[0].name == name


def test_a_folder_of_two_formats_asks_which(tmp_path):
    write("labelme", [ExchangedFrame("1", RICH, SIZE)], tmp_path / "set")
    (tmp_path / "set" / "2.json").write_bytes(write_annotation(RICH))
    with open_source(tmp_path / "set") as source, pytest.raises(UsageError, match="several"):
        find_annotations(source)


def test_masks_are_not_read(tmp_path):
    write("masks", [ExchangedFrame("1", RICH, SIZE)], tmp_path / "set")
    with (
        open_source(tmp_path / "set") as source,
        pytest.raises(UsageError, match="only be written"),
    ):
        find_annotations(source, "masks")


def test_every_format_says_what_it_keeps():
    assert len({f.name for f in WRITTEN}) == len(WRITTEN) == 9
    assert all(f.title and f.holds and f.loses for f in WRITTEN)


# ------------------------------------------------------------------------------------- readers


def test_coco_is_what_its_readers_expect(tmp_path):
    """What pycocotools indexes, and the lengths that keypoint evaluation relies on."""
    more = FrameAnnotation((Polyline("Middle line", (Point(0.5, 0.5), Point(0.5, 1.5))),))
    frames = [ExchangedFrame("1", RICH, SIZE, "1.jpg"), ExchangedFrame("2", more, SIZE, "2.jpg")]
    write("coco", frames, tmp_path / "set")
    content = json.loads((tmp_path / "set" / COCO_FILE).read_text())
    categories = {c["id"]: c for c in content["categories"]}
    images = {i["id"]: i for i in content["images"]}
    assert len(categories) == len(content["categories"]) == len(SOCCER.elements)
    assert [i["file_name"] for i in images.values()] == ["1.jpg", "2.jpg"]
    assert len({a["id"] for a in content["annotations"]}) == len(content["annotations"]) == 4
    for entry in content["annotations"]:
        names = categories[entry["category_id"]]["keypoints"]
        visible = entry["keypoints"][2::3]
        assert entry["image_id"] in images
        assert len(entry["keypoints"]) == 3 * len(names)
        assert entry["num_keypoints"] == sum(v > 0 for v in visible)
        assert all(
            entry["keypoints"][3 * i : 3 * i + 2] == [0, 0] for i, v in enumerate(visible) if not v
        )
        assert "segmentation" not in entry
        assert entry["area"] == entry["bbox"][2] * entry["bbox"][3]
    number = SOCCER.index["Middle line"] + 1
    middle = [a for a in content["annotations"] if a["category_id"] == number]
    assert [a["keypoints"][2::3] for a in middle] == [[2, 0], [2, 1]]
    for category in categories.values():
        assert max((end for edge in category["skeleton"] for end in edge), default=1) <= len(
            category["keypoints"]
        )


def test_cvat_labels_have_names_a_server_keeps_and_colours(tmp_path):
    annotation = FrameAnnotation(
        (
            Polyline("Goal left post left ", PLAIN_POINTS),
            Polyline('a "b" <c> & d', PLAIN_POINTS),
            Polyline("Middle line", PLAIN_POINTS[:1]),
        )
    )
    write("cvat", [ExchangedFrame("1 & 2", annotation, SIZE, "1 & 2.jpg")], tmp_path / "set")
    root = ElementTree.parse(tmp_path / "set" / "annotations.xml").getroot()
    labels = {label.findtext("name"): label for label in root.iterfind("meta/task/labels/label")}
    used = [shape.get("label") for shape in root.iterfind("image/*")]
    assert used == ["Goal left post left", 'a "b" <c> & d', "Middle line"]
    assert set(used) <= set(labels)
    element = SOCCER.element("Goal left post left ")
    assert labels["Goal left post left"].findtext("color") == element.colour
    assert labels["Goal left post left"].findtext("type") == "polyline"
    assert labels["Middle line"].findtext("type") == "any"  # it has a single point, too
    image = root.find("image")
    assert image.attrib == {"id": "0", "name": "1 & 2.jpg", "width": "1280", "height": "720"}
    raw = json.loads((tmp_path / "set" / "labels.json").read_text())
    assert [(r["name"], r["color"]) for r in raw] == [
        (label.findtext("name"), label.findtext("color")) for label in labels.values()
    ]


def test_soccernets_loader_finds_its_keys(tmp_path):
    """``dataloader.py`` joins UrlLocal to its folder, and walks list_actions and their replays."""
    write("soccernet-v3", [ExchangedFrame("1", RICH, SIZE, "1.jpg")], tmp_path / "set")
    content = json.loads((tmp_path / "set" / "Labels-v3.json").read_text())
    assert content["GameMetadata"] == {"list_actions": ["1.jpg"], "UrlLocal": ""}
    assert content["actions"]["1.jpg"]["linked_replays"] == []


# ------------------------------------------------------------------------------------- tracks


def of_frame(*names: str) -> FrameAnnotation:
    return FrameAnnotation(tuple(Polyline(name, PLAIN_POINTS) for name in names))


def test_frames_of_a_video_come_back_from_tracks(tmp_path):
    """What is annotated in one frame is not seen in the next, unless it is annotated there."""
    point = FrameAnnotation((Polyline("Middle line", PLAIN_POINTS[:1]),))
    annotations = {
        "match_000007": of_frame("Goal left post left ", "Middle line"),
        "match_000008": of_frame("Middle line", "Side line top"),
        "match_000100": point,
    }
    frames = [ExchangedFrame(n, a, SIZE, f"{n}.png") for n, a in annotations.items()]
    writing = write(TRACKS, frames, tmp_path / "set")
    assert writing.remarks.lines() == []
    text = (tmp_path / "set" / "annotations.xml").read_text()
    assert "<source>match.mp4</source>" in text
    root = ElementTree.fromstring(text)
    assert [(t.get("label"), [s.get("frame") for s in t]) for t in root.iterfind("track")] == [
        ("Goal left post left", ["7", "8"]),
        ("Middle line", ["7", "8", "9"]),
        ("Side line top", ["8", "9"]),
        ("Middle line", ["100", "101"]),
    ]
    assert [s.get("outside") for s in root.findall("track")[1]] == ["0", "0", "1"]
    back, reading = read(tmp_path / "set")
    assert reading.problems == reading.remarks.lines() == []
    assert {name: frame.annotation for name, frame in back.items()} == annotations


def test_pictures_of_a_task_are_counted_in_the_order_of_their_names(tmp_path):
    annotations = {name: of_frame("Middle line", klass) for name, klass in (
        ("2", "Side line top"), ("10", "Side line left"), ("b", "Circle left"),
    )}  # fmt: skip
    frames = [ExchangedFrame(n, a, SIZE, f"{n}.jpg") for n, a in annotations.items()]
    writing = write(TRACKS, frames, tmp_path / "set")
    assert "numbered in the order of their names" in writing.remarks.lines()[0]
    with open_source(tmp_path / "set") as source:
        known, files = find_annotations(source)
        assert known.read is not None
        reading = ReadContext(SOCCER, pictures=["10.jpg", "2.jpg", "b.jpg"])
        back = {f.name: f.annotation for f in known.read(source, files, reading)}
        assert back == annotations
        nameless = [f.name for f in known.read(source, files, ReadContext(SOCCER))]
        assert nameless == ["frame_000000", "frame_000001", "frame_000002"]
        few = ReadContext(SOCCER, pictures=["10.jpg"])
        assert len(list(known.read(source, files, few))) == 1
        assert "there are 1 pictures" in few.problems[0]


def test_tracks_over_pictures_in_several_folders_keep_these(tmp_path):
    pictures = ["a/1.jpg", "a/2.jpg", "b/1.jpg"]
    annotations = {name.removesuffix(".jpg"): RICH for name in pictures}
    frames = [ExchangedFrame(n, a, SIZE, f"{n}.jpg") for n, a in annotations.items()]
    write(TRACKS, frames, tmp_path / "set")
    with open_source(tmp_path / "set") as source:
        known, files = find_annotations(source)
        assert known.read is not None
        reading = ReadContext(SOCCER, pictures=pictures)
        assert [f.name for f in known.read(source, files, reading)] == list(annotations)


def test_what_cvat_interpolated_counts_where_a_person_set_something(tmp_path):
    shapes = {
        "Middle line": [(0, 1), (1, 0), (2, 0), (3, 1)],
        "Side line top": [(0, 1), (1, 0), (2, 1), (3, 0)],
    }
    tracks = "".join(
        f'<track id="0" label="{name}">'
        + "".join(
            f'<polyline frame="{frame}" keyframe="{key}" outside="0" points="1,1;5,{frame}"/>'
            for frame, key in of_track
        )
        + "</track>"
        for name, of_track in shapes.items()
    )
    meta = (
        "<meta><task><original_size><width>64</width><height>36</height></original_size></task>"
        "<source>a.mov</source></meta>"
    )
    (tmp_path / "a.xml").write_text(f"<annotations>{meta}{tracks}</annotations>")
    back, reading = read(tmp_path)
    assert list(back) == ["a_000000", "a_000002", "a_000003"]
    assert all(len(frame.annotation.polylines) == 2 for frame in back.values())
    told = " ".join(reading.remarks.lines())
    assert "interpolated from end to end are left out" in told
    assert "taken as they are (2 frames: a_000002, a_000003)" in told


def test_a_video_has_pictures_of_one_size(tmp_path):
    frames = [ExchangedFrame("1", RICH, SIZE), ExchangedFrame("2", RICH, (64, 36))]
    writing = write(TRACKS, frames, tmp_path / "set")
    assert writing.frames == 1
    assert "pictures of one size" in writing.problems[0]


# ------------------------------------------------------------------------------------- YOLO


def test_yolo_pose_is_what_its_readers_ask_for(tmp_path):
    """As many columns in every line, and nothing outside 0..1."""
    outside = FrameAnnotation((
        Polyline("Middle line", (Point(-0.2, 0.5), Point(0.25, 0.5), Point(1, 1))),
        Polyline("Circle left", (Point(2, 2),)),
    ))  # fmt: skip
    frames = [ExchangedFrame("1", RICH, SIZE), ExchangedFrame("2", outside, SIZE)]
    writing = write("yolo-pose", frames, tmp_path / "set")
    lines = [
        line.split()
        for file in (tmp_path / "set" / "labels").rglob("*.txt")
        for line in file.read_text().splitlines()
    ]
    assert writing.elements == len(lines)
    assert writing.points == sum(line[5:].count("2") for line in lines)
    assert "YOLO has no points outside the picture (1 frame: 2)" in writing.remarks.lines()
    labels = tmp_path / "set" / "labels" / "train"
    assert sorted(p.name for p in labels.iterdir()) == ["1.txt", "2.txt"]
    lines = [line.split() for file in labels.iterdir() for line in file.read_text().splitlines()]
    assert {len(line) for line in lines} == {5 + 3 * 2}
    assert all(0 <= float(value) <= 1 for line in lines for value in line[1:5])
    (line,) = (labels / "2.txt").read_text().splitlines()
    number, x, y, width, height, *points = map(float, line.split())
    assert number == SOCCER.index["Middle line"]
    assert points[0] * 1280 == pytest.approx(0.25 * 1279, abs=1e-3)
    assert points[3] * 1280 == pytest.approx(1279, abs=1e-3)
    assert points[2::3] == [2, 2]
    assert (x - width / 2, y + height / 2) == pytest.approx((points[0], points[4]), abs=1e-6)
    data = (tmp_path / "set" / "data.yaml").read_text()
    assert "kpt_shape: [2, 3]" in data
    assert f'  {SOCCER.index["Middle line"]}: "Middle line"' in data
