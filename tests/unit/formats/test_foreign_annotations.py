"""Files as other programs write them, and damaged ones: each is read, or refused in one line."""

import copy
import json
from pathlib import Path
from typing import Any

import pytest

from procc_annotator.annotation import Point, points_px
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.exchange import ExchangedFrame, ReadContext, WriteContext
from procc_annotator.formats.annotations.registry import find_annotations, format_named
from procc_annotator.formats.file_source import open_source

SOCCER = load_field("soccer")

# As labelme 5.5 saves it: the label without the space at its end, a polygon, and a rectangle.
LABELME: dict[str, Any] = {
    "version": "5.5.0",
    "flags": {},
    "shapes": [
        {
            "label": "Goal left post left",
            "points": [[100.5, 20.25], [101.0, 359.0]],
            "group_id": None,
            "description": "",
            "shape_type": "linestrip",
            "flags": {},
            "mask": None,
        },
        {
            "label": "Circle central",
            "points": [[10.0, 10.0], [20.0, 12.0], [30.0, 10.0]],
            "group_id": 3,
            "description": "",
            "shape_type": "polygon",
            "flags": {},
            "mask": None,
        },
        {
            "label": "Middle line",
            "points": [[320.0, 100.0]],
            "group_id": None,
            "shape_type": "point",
            "flags": {},
        },
        {
            "label": "player",
            "points": [[1.0, 2.0], [3.0, 4.0]],
            "group_id": None,
            "shape_type": "rectangle",
            "flags": {},
        },
    ],
    "imagePath": "..\\pictures\\a.jpg",
    "imageData": None,
    "imageHeight": 360,
    "imageWidth": 640,
}

# As a CVAT server exports a job: two decimals, attributes, and a picture nobody annotated.
CVAT = """<?xml version="1.0" encoding="utf-8"?>
<annotations>
  <version>1.1</version>
  <meta>
    <job>
      <id>12</id>
      <size>3</size>
      <mode>annotation</mode>
      <overlap>0</overlap>
      <bugtracker></bugtracker>
      <created>2024-05-02 10:00:00.000000+00:00</created>
      <updated>2024-05-02 11:00:00.000000+00:00</updated>
      <subset>default</subset>
      <start_frame>0</start_frame>
      <stop_frame>2</stop_frame>
      <frame_filter></frame_filter>
      <segments>
        <segment><id>12</id><start>0</start><stop>2</stop><url>http://localhost/api/jobs/12</url></segment>
      </segments>
      <owner><username>admin</username><email>admin@example.org</email></owner>
      <assignee></assignee>
      <labels>
        <label>
          <name>Goal left post left</name>
          <color>#c06060</color>
          <type>polyline</type>
          <attributes>
            <attribute><name>sure</name><mutable>False</mutable><input_type>checkbox</input_type>
              <default_value>false</default_value><values>false</values></attribute>
          </attributes>
        </label>
      </labels>
    </job>
    <dumped>2024-05-02 11:00:01.000000+00:00</dumped>
  </meta>
  <image id="0" name="day one/a.jpg" width="640" height="360">
    <polyline label="Goal left post left" source="manual" occluded="0"\
 points="100.50,20.25;101.00,359.00" z_order="0">
      <attribute name="sure">true</attribute>
    </polyline>
    <points label="Middle line" source="manual" occluded="0" points="320.00,100.00" z_order="0">
    </points>
    <box label="player" source="manual" occluded="0" xtl="1.00" ytl="2.00" xbr="3.00" ybr="4.00"\
 z_order="0">
    </box>
    <tag label="day" source="manual">
    </tag>
  </image>
  <image id="1" name="day one/b.jpg" width="640" height="360">
  </image>
</annotations>
"""

# As SoccerNet-v3 is published: an action and its replay, players, a line without a class.
V3: dict[str, Any] = {
    "GameMetadata": {
        "UrlLocal": "england_epl/2014-2015/2015-02-21 - 18-00 Chelsea 1 - 1 Burnley",
        "list_actions": ["0.png"],
        "list_replays": ["0_1.png"],
        "num_actions": 1,
    },
    "actions": {
        "0.png": {
            "imageMetadata": {"width": 1920, "height": 1080, "half": 1},
            "linked_replays": ["0_1.png"],
            "bboxes": [
                {"class": "Player team left", "ID": "7",
                 "points": {"x1": 1, "y1": 2, "x2": 3, "y2": 4}},
            ],
            "lines": [
                {"class": "Goal left post left", "points": [0, 10, 1919, 1079]},
                {"class": "Line unknown", "points": [1, 2, 3, 4]},
                {"class": "Line unknown", "points": [5.5, 6, 7, 8]},
                {"class": None, "points": [5, 6]},
            ],
        }
    },
    "replays": {
        "0_1.png": {
            "imageMetadata": {"width": 1280, "height": 720},
            "linked_action": "0.png",
            "bboxes": [],
            "lines": [],
        }
    },
}  # fmt: skip

# As SoccerNet-GSR is published: players, a pitch and a camera annotation.
GSR: dict[str, Any] = {
    "info": {"version": "1.3", "id": "200", "name": "SNGS-200", "im_dir": "img1",
             "frame_rate": 25, "seq_length": 2, "im_ext": ".jpg"},
    "images": [
        {"is_labeled": True, "image_id": "3200000001", "file_name": "000001.jpg", "height": 1080,
         "width": 1920, "has_labeled_person": True, "has_labeled_pitch": True,
         "has_labeled_camera": True, "ignore_regions_y": [], "ignore_regions_x": []},
        {"is_labeled": True, "image_id": "3200000002", "file_name": "000002.jpg", "height": 1080,
         "width": 1920, "has_labeled_person": True, "has_labeled_pitch": False,
         "has_labeled_camera": False, "ignore_regions_y": [], "ignore_regions_x": []},
    ],
    "annotations": [
        {"id": "3200000001", "image_id": "3200000001", "track_id": 1, "supercategory": "object",
         "category_id": 1, "attributes": {"role": "player", "jersey": "14", "team": "left"},
         "bbox_image": {"x": 1020, "y": 508, "x_center": 1043.0, "y_center": 557.5, "w": 46,
                        "h": 99},
         "bbox_pitch": {"x_bottom_middle": -28.786446826184775,
                        "y_bottom_middle": -14.119801608871501}},
        {"id": "3200000019", "image_id": "3200000001", "supercategory": "pitch", "category_id": 5,
         "lines": {"Side line top": [{"x": 0.21, "y": 0.34}, {"x": 1.0, "y": 0.43}],
                   "Goal left post left": [{"x": 0.1, "y": 0.2}]}},
        {"id": "3200000020", "image_id": "3200000001", "supercategory": "camera", "category_id": 6,
         "parameters": {"pan_degrees": 1.5}},
    ],
    "categories": [{"supercategory": "pitch", "id": 5, "name": "pitch", "lines": []}],
}  # fmt: skip

COCO: dict[str, Any] = {
    "info": {"year": 2024},
    "licenses": [],
    "images": [{"id": 5, "width": 640, "height": 360, "file_name": "train/a.jpg", "license": 1}],
    "annotations": [
        {"id": 1, "image_id": 5, "category_id": 2, "iscrowd": 0, "area": 1.0, "num_keypoints": 2,
         "bbox": [0, 0, 1, 1], "keypoints": [100.5, 20.25, 2, 101.0, 359.0, 1, 0, 0, 0]},
        {"id": 2, "image_id": 5, "category_id": 2, "iscrowd": 0, "area": 1.0,
         "bbox": [0, 0, 1, 1], "segmentation": []},
    ],
    "categories": [
        {"id": 2, "name": "Goal left post left", "keypoints": ["1", "2", "3"], "skeleton": []}
    ],
}  # fmt: skip

FILES: dict[str, tuple[str, Any]] = {
    "labelme": ("a.json", LABELME),
    "cvat": ("annotations.xml", CVAT),
    "soccernet-v3": ("Labels-v3.json", V3),
    "soccernet-gsr": ("Labels-GameState.json", GSR),
    "coco": ("person_keypoints_train.json", COCO),
}


def read(
    path: Path, fmt: str = "auto", size: tuple[int, int] | None = None
) -> tuple[dict[str, ExchangedFrame], ReadContext]:
    with open_source(path) as source:
        known, files = find_annotations(source, fmt)
        reading = ReadContext(SOCCER, lambda _: size)
        assert known.read is not None
        return {f.name: f for f in known.read(source, files, reading)}, reading


def put(folder: Path, name: str, content: object = None) -> Path:
    file, usual = FILES[name]
    content = usual if content is None else content
    path = folder / file
    path.write_text(content if isinstance(content, str) else json.dumps(content), "utf-8")
    return path


@pytest.mark.parametrize("name", ["labelme", "cvat", "coco"])
def test_pixels_become_what_soccernet_means(name, tmp_path):
    frames, reading = read(put(tmp_path, name))
    assert reading.problems == []
    frame = frames["a"]
    assert (frame.size, frame.picture) == ((640, 360), "a.jpg")
    post = frame.annotation.get("Goal left post left ")  # the official name ends in a space
    assert post.points == (Point(100.5 / 639, 20.25 / 359), Point(101.0 / 639, 1.0))


def test_labelme_shapes_of_other_types_are_told(tmp_path):
    frames, reading = read(put(tmp_path, "labelme"))
    assert frames["a"].annotation.annotated == (
        "Goal left post left ", "Circle central", "Middle line",
    )  # fmt: skip
    assert reading.remarks.lines() == [
        "polygons are taken for open lines through their points (1 frame: a)",
        "groups, descriptions and flags of shapes are left out (1 frame: a)",
        "shapes of the type rectangle are left out (1 frame: a)",
    ]


def test_labelme_without_a_size_takes_that_of_the_picture(tmp_path):
    content = {k: v for k, v in LABELME.items() if not k.startswith("imageH")}
    content["imageWidth"] = None
    path = put(tmp_path, "labelme", content)
    assert read(path, size=(640, 360))[0]["a"].size == (640, 360)
    frames, reading = read(path)
    assert frames == {}
    assert "give the size" in reading.problems[0]


def test_cvat_pictures_nobody_annotated_stay_so(tmp_path):
    frames, reading = read(put(tmp_path, "cvat"))
    assert list(frames) == ["a"]
    assert reading.remarks.lines() == [
        "attributes, groups and occlusion of shapes are left out (1 frame: a)",
        "shapes of the type box are left out (1 frame: a)",
        "shapes of the type tag are left out (1 frame: a)",
    ]


def test_cvat_two_decimals_move_points_by_no_more(tmp_path):
    text = CVAT.replace("100.50", "100.49")
    a = read(put(tmp_path, "cvat"))[0]["a"].annotation.polylines[0]
    b = read(put(tmp_path, "cvat", text))[0]["a"].annotation.polylines[0]
    assert abs(points_px(a, (640, 360)) - points_px(b, (640, 360))).max() == pytest.approx(0.01)


def test_v3_keeps_every_unknown_line(tmp_path):
    frames, reading = read(put(tmp_path, "soccernet-v3"))
    assert list(frames) == ["0", "0_1"]
    first = frames["0"].annotation
    assert [p.class_name for p in first.polylines] == [
        "Goal left post left ", "Line unknown", "Line unknown (2)",
    ]  # fmt: skip
    assert first.polylines[0].points == (Point(0, 10 / 1079), Point(1, 1))
    assert frames["0_1"].annotation.polylines == ()
    assert "lines without a class are left out (1 frame: 0)" in reading.remarks.lines()
    assert any(line.startswith("players, links") for line in reading.remarks.lines())


def test_gsr_gives_the_frames_with_a_pitch(tmp_path):
    frames, reading = read(put(tmp_path, "soccernet-gsr"))
    assert list(frames) == ["000001"]
    assert frames["000001"].annotation.polylines[0].points[1] == Point(1.0, 0.43)
    assert reading.remarks.lines() == ["players, ball, cameras and other annotations are left out"]


@pytest.mark.parametrize("name", ["soccernet-v3", "soccernet-gsr"])
def test_writing_into_a_file_keeps_its_other_content(name, tmp_path):
    path = put(tmp_path, name)
    frames, _ = read(path)
    known = format_named(name)
    assert known.decode_existing is not None
    written: dict[str, bytes] = {}

    def keep(file: str, data: bytes) -> bool:
        written[file] = data
        return True

    writing = WriteContext(SOCCER, keep, into=known.decode_existing(path.read_bytes(), str(path)))
    first, *rest = frames.values()
    moved = first.annotation.without("Side line top").without("Line unknown")
    new = ExchangedFrame("new", moved, (640, 360), "new.png")
    known.write([ExchangedFrame(first.name, moved, first.size), *rest, new], writing)
    (data,) = written.values()
    after = json.loads(data)
    before = copy.deepcopy(FILES[name][1])
    if name == "soccernet-gsr":
        assert after["info"] == before["info"]
        assert after["categories"] == before["categories"]
        assert after["images"][:2] == before["images"]
        assert after["annotations"][0] == before["annotations"][0]
        assert after["annotations"][2] == before["annotations"][2]
        assert list(after["annotations"][1]["lines"]) == ["Goal left post left "]
        assert after["images"][2]["file_name"] == "new.png"
        assert after["annotations"][3]["image_id"] == after["images"][2]["image_id"]
    else:
        entry = after["actions"]["0.png"]
        assert entry["bboxes"] == before["actions"]["0.png"]["bboxes"]
        assert entry["imageMetadata"] == before["actions"]["0.png"]["imageMetadata"]
        assert entry["lines"][0] == {"class": "Goal left post left ", "points": [0, 10, 1919, 1079]}
        assert after["replays"] == before["replays"]
        assert after["GameMetadata"]["list_actions"] == ["0.png", "new.png"]
    (tmp_path / "again").mkdir()
    (tmp_path / "again" / path.name).write_bytes(data)
    assert read(tmp_path / "again")[0]["new"].annotation.polylines[0] == moved.polylines[0]


# ------------------------------------------------------------------------------------- pieces


def shapes(*pieces: tuple[str, list[list[float]]]) -> dict[str, Any]:
    return LABELME | {
        "shapes": [
            {"label": label, "points": points, "shape_type": "linestrip"}
            for label, points in pieces
        ]
    }


def px(frame: ExchangedFrame, name: str) -> list[list[float]]:
    polyline = frame.annotation.get(name)
    assert polyline is not None
    assert frame.size is not None
    return [[round(x, 6), round(y, 6)] for x, y in points_px(polyline, frame.size)]


def test_pieces_of_a_straight_line_are_joined_along_it(tmp_path):
    content = shapes(
        ("Side line top", [[300, 130], [200, 120]]),
        ("Side line top", [[10, 101], [100, 110]]),
        ("Side line top", [[400, 140]]),
    )
    frames, reading = read(put(tmp_path, "labelme", content))
    assert px(frames["a"], "Side line top") == [
        [400, 140], [300, 130], [200, 120], [100, 110], [10, 101],
    ]  # fmt: skip
    assert reading.remarks.lines() == ["shapes of one class were joined end to end (1 frame: a)"]


def test_pieces_of_a_line_bent_by_the_lens_are_joined(tmp_path):
    """A twentieth of its length is more than broadcast lenses do."""
    course = [[x, 100 + 20 * (1 - ((x - 310) / 300) ** 2)] for x in range(10, 611, 50)]
    content = shapes(("Side line top", course[:5]), ("Side line top", course[6:]))
    frames, _ = read(put(tmp_path, "labelme", content))
    expected = [[x, round(y, 6)] for x, y in course[:5] + course[6:]]
    assert px(frames["a"], "Side line top") == expected


def test_arcs_are_joined_where_they_touch(tmp_path):
    content = shapes(
        ("Circle left", [[100, 100], [120, 130]]),
        ("Circle left", [[80, 60], [100.5, 100]]),
        ("Circle left", [[150, 160], [120, 130]]),
    )
    frames, _ = read(put(tmp_path, "labelme", content))
    assert px(frames["a"], "Circle left") == [
        [80, 60], [100.5, 100], [100, 100], [120, 130], [150, 160],
    ]  # fmt: skip


@pytest.mark.parametrize(
    "pieces",
    [
        (("Circle left", [[100, 100], [120, 130]]), ("Circle left", [[300, 100], [320, 130]])),
        (("Middle line", [[100, 100], [300, 130]]), ("Middle line", [[150, 100], [320, 130]])),
        (("Side line top", [[100, 100], [200, 100]]), ("Side line top", [[300, 300], [400, 310]])),
        (
            ("Goal left crossbar", [[100, 100], [200, 100]]),
            ("Goal left crossbar", [[300, 100], [305, 300]]),
        ),
        (("Side line top", [[10, 100], [250, 100]]), ("Side line top", [[300, 125], [600, 125]])),
    ],
)
def test_a_guess_is_refused_and_explained(pieces, tmp_path):
    frames, reading = read(put(tmp_path, "labelme", shapes(*pieces)))
    assert frames == {}
    (problem,) = reading.problems
    assert "2 shapes are called" in problem
    assert "one polyline a class" in problem


def test_single_points_of_a_class_keep_their_order(tmp_path):
    content = shapes(*((("Circle left"), [[x, 10]]) for x in (30, 10, 20)))
    frames, _ = read(put(tmp_path, "labelme", content))
    assert px(frames["a"], "Circle left") == [[30, 10], [10, 10], [20, 10]]


@pytest.mark.parametrize("to", ["cvat", "coco", "soccernet-v3", "soccernet-gsr"])
def test_frames_keep_their_names_whatever_their_pictures_are_called(to, tmp_path):
    folder = tmp_path / "labelme"
    folder.mkdir()
    for name, picture in (("g", "..\\imgs\\other.png"), ("a", "a.jpg"), ("a2", "a.png")):
        content = shapes(("Middle line", [[10, 10], [20, 30]]))
        (folder / f"{name}.json").write_text(json.dumps({**content, "imagePath": picture}))
    frames, _ = read(folder)
    out = tmp_path / "out"
    out.mkdir()

    def keep(name: str, data: bytes) -> bool:
        (out / name).parent.mkdir(exist_ok=True)
        (out / name).write_bytes(data)
        return True

    writing = WriteContext(SOCCER, keep)
    format_named(to).write(list(frames.values()), writing)
    again, reading = read(out)
    assert again.keys() == {"g", "a", "a2"}
    assert not reading.problems
    assert any("named after the frame (2 frames: a2, g)" in x for x in writing.remarks.lines())


# ------------------------------------------------------------------------------------- damage


def changed(content: Any, place: tuple[Any, ...], value: Any) -> Any:
    content = copy.deepcopy(content)
    inner = content
    for key in place[:-1]:
        inner = inner[key]
    inner[place[-1]] = value
    return content


LINE = ("actions", "0.png", "lines", 0)
PITCH = ("annotations", 1, "lines", "Side line top")
TRACK = (
    "<annotations><meta><task><original_size><width>64</width><height>36</height></original_size>"
    '</task></meta><track id="0" label="Middle line"><polyline {}/></track></annotations>'
)
DAMAGE: list[tuple[str, Any, str]] = [
    ("labelme", changed(LABELME, ("shapes", 0, "points", 1), [True, 2]), "shapes[0].points[1]"),
    ("labelme", changed(LABELME, ("shapes", 0, "points", 1), [1, "2"]), "shapes[0].points[1]"),
    ("labelme", changed(LABELME, ("shapes", 0, "points", 1), [1]), "shapes[0].points[1]"),
    ("labelme", changed(LABELME, ("shapes", 0), 7), "shapes[0]"),
    ("labelme", changed(LABELME, ("imageWidth",), 1), "imageWidth"),
    ("labelme", changed(LABELME, ("procc_extra",), {"Circle left": 1}), "procc_extra"),
    ("labelme", json.dumps(LABELME)[:200], "line 1 column"),
    ("soccernet-v3", changed(V3, (*LINE, "points"), [1, 2, 3]), "lines[0].points"),
    ("soccernet-v3", changed(V3, (*LINE, "points"), [1, None]), "lines[0].points[0]"),
    ("soccernet-v3", changed(V3, ("actions", "0.png"), []), "lines"),
    ("soccernet-v3", changed(V3, ("actions", "0.png", "imageMetadata"), {}), "imageMetadata"),
    ("soccernet-v3", changed(V3, ("replays",), [1]), "replays"),
    ("soccernet-v3", changed(V3, ("actions", "../.."), V3["replays"]["0_1.png"]), "'../..'"),
    ("soccernet-gsr", changed(GSR, PITCH, [{"x": 0.2}]), "annotations[1].lines[Side line top[0]]"),
    ("soccernet-gsr", changed(GSR, PITCH, 5), "annotations[1].lines[Side line top]"),
    ("soccernet-gsr", changed(GSR, PITCH[:3], [5]), "annotations[1].lines"),
    ("soccernet-gsr", changed(GSR, ("images", 0, "file_name"), None), "images[0].file_name"),
    ("soccernet-gsr", changed(GSR, ("images", 0, "width"), "wide"), "images[0].width"),
    ("soccernet-gsr", changed(GSR, ("annotations", 1, "image_id"), "9"), "annotations[1].image_id"),
    ("soccernet-gsr", changed(GSR, ("annotations",), None), "annotations"),
    ("coco", changed(COCO, ("annotations", 0, "keypoints"), [1, 2]), "annotations[0].keypoints"),
    ("coco", changed(COCO, ("annotations", 0, "keypoints", 2), 5), "annotations[0].keypoints[2]"),
    ("coco", changed(COCO, ("annotations", 0, "keypoints", 0), "x"), "annotations[0].keypoints[0]"),
    ("coco", changed(COCO, ("annotations", 0, "category_id"), [1]), "annotations[0].category_id"),
    ("coco", changed(COCO, ("annotations", 0, "image_id"), {}), "annotations[0].image_id"),
    ("coco", changed(COCO, ("images", 0, "height"), -4), "images[0].width"),
    ("coco", changed(COCO, ("categories", 0, "name"), 4), "categories[id 2].name"),
    ("coco", changed(COCO, ("categories",), [3]), "categories[0]"),
    ("cvat", CVAT.replace("100.50,20.25", "1e999,1"), "image 1 (a), shape 1, point 1"),
    ("cvat", CVAT.replace('label="Goal left post left"', ""), "shape 1.label"),
    ("cvat", CVAT.replace('width="640"', 'width="wide"'), "image 1 (a).width"),
    ("cvat", CVAT.replace('name="day one/a.jpg"', ""), "image 1.name"),
    ("cvat", CVAT[:-40], "line "),
    ("cvat", TRACK.format('frame="x" points="1,1"'), "track 1, shape 1.frame"),
    ("cvat", TRACK.format('frame="1" points="1"'), "track 1, shape 1, point 1"),
    ("cvat", TRACK.format('frame="1" points="1,1"').replace("64", "w"), "original_size"),
    ("cvat", CVAT.replace("utf-8", "utf-99"), "not readable XML"),
]  # fmt: skip


@pytest.mark.parametrize(("name", "content", "place"), DAMAGE)
def test_damage_is_one_line_with_its_place(name, content, place, tmp_path):
    path = put(tmp_path, name, content)
    _, reading = read(path, name)
    (problem,) = reading.problems
    assert problem.startswith(f"{path}: ")
    assert place in problem
    assert problem.endswith(")")  # what to do about it
    assert len(problem) < len(str(path)) + 300
    assert problem.isprintable()


@pytest.mark.parametrize("name", ["soccernet-v3", "soccernet-gsr", "coco", "cvat"])
def test_one_damaged_frame_leaves_the_others(name, tmp_path):
    content = copy.deepcopy(FILES[name][1])
    if name == "soccernet-v3":
        content["actions"]["0.png"]["lines"] = 3
    elif name == "soccernet-gsr":
        content["annotations"].append(
            {"id": "9", "image_id": "3200000002", "lines": {"Middle line": 4}}
        )
    elif name == "coco":
        content["images"].append({"id": 6, "width": 9, "height": 9, "file_name": "b.jpg"})
        content["annotations"].append(
            {"id": 7, "image_id": 6, "category_id": 2, "keypoints": [1, 2, 9]}
        )
    else:
        shape = '<polyline label="Middle line" points="4;5"></polyline>'
        content = content.replace("  </image>\n</ann", f"{shape}</image>\n</ann")
    frames, reading = read(put(tmp_path, name, content), name)
    assert len(frames) == 1
    assert len(reading.problems) == 1


BOMB = '<!DOCTYPE a [<!ENTITY l "lol">' + "".join(
    f'<!ENTITY l{i} "{f"&l{i - 1 if i > 1 else chr(0)};".replace(chr(0), "") * 10}">'
    for i in range(1, 9)
)  # fmt: skip


@pytest.mark.parametrize(
    "doctype",
    [
        f"{BOMB}]>",
        '<!DOCTYPE a [<!ENTITY f SYSTEM "file:///etc/passwd">]>',
        '<!DOCTYPE a SYSTEM "http://127.0.0.1:1/a.dtd">',
        '<!DOCTYPE a [<!ENTITY % p SYSTEM "file:///etc/passwd"> %p;]>',
    ],
)
def test_entities_are_refused(doctype, tmp_path):
    text = CVAT.replace("<annotations>", f"{doctype}<annotations>", 1).replace("day one", "&f;")
    _, reading = read(put(tmp_path, "cvat", text), "cvat")
    (problem,) = reading.problems
    assert "root:" not in problem
    assert "entities" in problem


def test_deep_nesting_is_refused_or_read_and_never_fatal(tmp_path):
    deep = "<a>" * 100_000 + "</a>" * 100_000
    text = CVAT.replace("<meta>", f"<meta>{deep}")
    frames, reading = read(put(tmp_path, "cvat", text), "cvat")
    assert len(frames) + len(reading.problems) == 1
    for name in ("labelme", "coco", "soccernet-gsr", "soccernet-v3"):
        _, reading = read(put(tmp_path, name, "[" * 100_000 + "]" * 100_000), name)
        assert len(reading.problems) == 1
