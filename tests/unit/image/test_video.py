"""Frame n of a video is the n-th that decoding gives, whatever was asked for before."""

import os
import threading
from contextlib import suppress
from fractions import Fraction
from pathlib import Path

import av
import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from procc_annotator.dataset.dataset_field import video_pixel_aspect
from procc_annotator.dataset.sequence import find_cuts, open_pictures
from procc_annotator.errors import ImageError
from procc_annotator.field.model import PixelAspect
from procc_annotator.image.decoding import decode_bgra, decode_thumbnail, read_size
from procc_annotator.image.video import (
    Video,
    frames_at_interval,
    open_shared_video,
    scene_cuts,
    video_frame_of_path,
)

WIDTH, HEIGHT = 320, 192
Pixels = NDArray[np.uint8]


def _frame(number: int) -> Pixels:
    """A picture with its number as ten black or white blocks along the top."""
    grey = np.random.default_rng(number).integers(90, 160, (12, 20, 3), dtype=np.uint8)
    picture = np.asarray(cv2.resize(grey, (WIDTH, HEIGHT)), dtype=np.uint8)
    for bit in range(10):
        picture[:32, 32 * bit : 32 * (bit + 1)] = 255 if number >> bit & 1 else 0
    return picture


def _number(picture: Pixels) -> int:
    blocks = (picture[8:24, 32 * bit + 8 : 32 * bit + 24, :3].mean() for bit in range(10))
    return sum(1 << bit for bit, mean in enumerate(blocks) if mean > 128)


def _write(path: Path, code: str, frames: list[Pixels], fps: float = 25.0) -> Path:
    size = frames[0].shape[1], frames[0].shape[0]
    writer = cv2.VideoWriter(str(path), cv2.CAP_FFMPEG, cv2.VideoWriter.fourcc(*code), fps, size)
    if not writer.isOpened():
        pytest.skip(f"this OpenCV has no encoder for {code}")
    for frame in frames:
        writer.write(frame)
    writer.release()
    return path


# mpg2 is stored with B-frames, out of order; in AVI it has no usable timestamps at all.
KINDS = [
    ("mp4v", ".mp4"),
    ("MJPG", ".avi"),
    ("XVID", ".avi"),
    ("mpg2", ".mp4"),
    ("mpg2", ".avi"),
    ("VP80", ".mkv"),
]


@pytest.mark.parametrize(("code", "suffix"), KINDS)
def test_any_order_of_asking_gives_exactly_the_frame(tmp_path, code, suffix):
    count = 130
    path = _write(tmp_path / f"match{suffix}", code, [_frame(n) for n in range(count)])
    jumps = np.random.default_rng(3).integers(0, count, 25).tolist()
    with Video.open(path) as video:
        assert video.size == (WIDTH, HEIGHT)
        assert video.fps == pytest.approx(25)
        assert video.frame_count == count
        for n in [count - 1, 0, 0, *jumps, *range(60, 70), *range(20, 12, -1), count - 1]:
            assert _number(video.frame(n)) == n


def test_frames_are_opaque_bgra_that_nobody_can_change(tmp_path):
    path = _write(tmp_path / "a.mp4", "mp4v", [_frame(n) for n in range(3)])
    with Video.open(path) as video:
        picture = video.frame(1)
    assert picture.shape == (HEIGHT, WIDTH, 4)
    assert picture.dtype == np.uint8
    assert picture.flags.c_contiguous
    assert not picture.flags.writeable
    assert (picture[..., 3] == 255).all()
    # Compression changes pixels by a few levels, not the colours' order.
    assert np.abs(picture[..., :3].astype(int) - _frame(1)).mean() < 4


def test_threads_share_a_video(tmp_path):
    path = _write(tmp_path / "a.mp4", "mp4v", [_frame(n) for n in range(60)])
    video = Video.open(path)
    wrong: list[tuple[int, int]] = []

    def ask(seed: int) -> None:
        for n in np.random.default_rng(seed).integers(0, 60, 12).tolist():
            got = _number(video.frame(n))
            if got != n:
                wrong.append((n, got))

    threads = [threading.Thread(target=ask, args=(seed,)) for seed in range(3)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    video.close()
    assert wrong == []


def test_asking_beyond_the_end_or_after_closing_names_video_and_frame(tmp_path):
    path = _write(tmp_path / "a.mp4", "mp4v", [_frame(n) for n in range(5)])
    video = Video.open(path)
    for n in (-1, 5, 10_000):
        with pytest.raises(ImageError, match=rf"a\.mp4: frame {n}: .*the video has 5"):
            video.frame(n)
    video.close()
    with pytest.raises(ImageError, match="frame 0: the video was closed"):
        video.frame(0)
    video.close()


@pytest.mark.parametrize(
    ("code", "suffix"), [("XVID", ".avi"), ("mpg2", ".avi"), ("VP80", ".mkv"), ("h264", ".mp4")]
)
def test_a_video_that_was_cut_off_has_the_frames_that_are_left_and_says_so(tmp_path, code, suffix):
    frames = [_frame(n) for n in range(80)]
    path = tmp_path / f"a{suffix}"
    path = _write_h264(path, frames) if code == "h264" else _write(path, code, frames)
    with Video.open(path) as video:
        assert not video.cut_off
    data = path.read_bytes()
    path.write_bytes(data[: len(data) // 2])
    with Video.open(path) as video:
        assert _number(video.frame(20)) == 20
        with pytest.raises(ImageError, match=r"frame 79: .*the video has \d\d\b"):
            video.frame(79)
        count = video.frame_count
        assert 25 < count < 60
        assert video.cut_off.startswith(f"the file is cut off or damaged: it ends after {count}")
        assert _number(video.frame(24)) == 24


_GROUPS = {"g": "15", "bf": "2", "sc_threshold": "0"}


def _write_h264(
    path: Path, frames: list[Pixels], pixel_aspect: Fraction = Fraction(1), code: str = "libx264"
) -> Path:
    """As most videos are: frames predicted from later ones, a key frame every 15."""
    options = {"movflags": "faststart"} if path.suffix == ".mp4" else {}
    with av.open(str(path), "w", options=options) as container:
        stream = container.add_stream(code, rate=25, options=_GROUPS if code == "libx264" else {})
        stream.width, stream.height, stream.pix_fmt = WIDTH, HEIGHT, "yuv420p"
        stream.codec_context.sample_aspect_ratio = pixel_aspect
        for picture in frames:
            container.mux(stream.encode(av.VideoFrame.from_ndarray(picture, format="bgr24")))
        container.mux(stream.encode())
    return path


@pytest.mark.parametrize("aspect", [Fraction(1), Fraction(4, 3)])
def test_pixels_that_are_not_square_are_those_of_the_metadata(tmp_path, aspect):
    path = _write_h264(tmp_path / "a.mp4", [_frame(n) for n in range(3)], aspect)
    found = video_pixel_aspect(path / "00000001")
    assert found == (None if aspect == 1 else PixelAspect(pytest.approx(4 / 3), 1.0))
    notices = open_pictures(path).notices
    assert [("its pixels are 1.333 times as wide as high" in one) for one in notices] == (
        [True] if aspect > 1 else []
    )


@pytest.mark.parametrize(
    ("suffix", "code"),
    [(".ts", "libx264"), (".flv", "libx264"), (".mpg", "mpeg2video"), (".mxf", "mpeg2video"),
     (".wmv", "wmv2")],
)  # fmt: skip
def test_frames_behind_a_hole_keep_their_numbers(tmp_path, suffix, code):
    path = _write_h264(tmp_path / f"a{suffix}", [_frame(n) for n in range(60)], code=code)
    data = path.read_bytes()
    begin, end = 4 * len(data) // 10, 6 * len(data) // 10
    path.write_bytes(data[:begin] + bytes(end - begin) + data[end:])
    shown = {}
    with Video.open(path) as video:
        assert video.frame_count == 60
        for n in range(60):
            with suppress(ImageError):
                shown[n] = _number(video.frame(n))
    assert len(shown) > 20
    assert all(number == n for n, number in shown.items())
    assert 59 in shown
    path.write_bytes(data[:begin])
    with Video.open(path) as video:
        assert bool(video.cut_off) == (suffix in (".flv", ".wmv"))


@pytest.mark.parametrize(
    ("suffix", "spoilt"),
    [(".mp4", "zeros"), (".mp4", "random"), (".mkv", "zeros"), (".ts", "zeros")],
)
def test_damaged_frames_are_refused_and_the_others_keep_number_and_pixels(tmp_path, suffix, spoilt):
    """Packets of three groups of frames are spoilt, in the second one 8 in a row."""
    path = _write_h264(tmp_path / f"a{suffix}", [_frame(n) for n in range(75)])
    with Video.open(path) as video:
        intact = [video.frame(n) for n in range(75)]
    with av.open(str(path)) as container:
        places = [(p.pos, p.size) for p in container.demux(video=0) if p.size]
    data = bytearray(path.read_bytes())
    for packet in (8, *range(20, 28), 47):
        begin, size = places[packet]
        random = np.random.default_rng(packet).bytes(size)
        data[begin : begin + size] = bytes(size) if spoilt == "zeros" else random
    path.write_bytes(data)
    refused = set()
    with Video.open(path) as video:
        assert video.frame_count == 75
        for n in [70, 12, *range(75)]:  # whatever was asked for before
            try:
                np.testing.assert_array_equal(video.frame(n), intact[n])
            except ImageError as error:
                assert f"frame {n}: damaged" in str(error)  # noqa: PT017
                refused.add(n)
    # Up to the next key frame, and those before one that refer to what is before them.
    assert {22, 29, 59} <= refused <= {*range(30), *range(42, 60)}


@pytest.mark.parametrize("damage", ["packet 9", "packet 40", "half of the last packet"])
def test_a_matroska_file_that_ends_early_says_so_and_keeps_its_numbers(tmp_path, damage):
    """Its reader gives up at a damaged packet; the last frames are shown in another order."""
    path = _write_h264(tmp_path / "a.mkv", [_frame(n) for n in range(60)])
    with av.open(str(path)) as container:
        places = [(p.pos, p.size) for p in container.demux(video=0) if p.size]
    data = bytearray(path.read_bytes())
    if damage.startswith("packet"):
        begin, size = places[int(damage.split()[1])]
        data[begin - 8 : begin + size] = bytes(8 + size)
    else:
        del data[places[-1][0] + places[-1][1] // 2 :]
    path.write_bytes(data)
    with Video.open(path) as video:
        assert video.frame_count == 60 or "cut off or damaged" in video.cut_off
        shown = {}
        for n in range(video.frame_count):
            with suppress(ImageError):
                shown[n] = _number(video.frame(n))
    assert len(shown) >= 5
    assert all(number == n for n, number in shown.items())


@pytest.mark.parametrize("suffix", [".mp4", ".mkv", ".avi"])
@pytest.mark.parametrize(
    ("data", "problem"),
    [
        (b"", "the file is empty"),
        (b"#EXTM3U\nhttp://example.org/video.ts\n", "none of 3gp, avi"),
        (b"\x00\x00\x00\x18ftypisom" + bytes(200), "cannot be opened as a video"),
        (b"RIFF\x00\x10\x00\x00AVI LIST" + bytes(200), "cannot be opened as a video"),
        (b"\x1a\x45\xdf\xa3" + bytes(200), "cannot be opened as a video"),
    ],
)
def test_what_is_no_video_is_one_line_that_names_it(tmp_path, suffix, data, problem):
    path = tmp_path / f"broken{suffix}"
    path.write_bytes(data)
    with pytest.raises(ImageError, match=problem) as caught:
        Video.open(path)
    assert str(path) in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_missing_file_and_a_folder_are_errors(tmp_path):
    with pytest.raises(ImageError, match="No such file"):
        Video.open(tmp_path / "gone.mp4")
    with pytest.raises(ImageError, match="No such file"):
        open_shared_video(tmp_path / "gone.mp4")
    (tmp_path / "folder.mp4").mkdir()
    with pytest.raises(ImageError, match="is a folder, expected a file"):
        Video.open(tmp_path / "folder.mp4")


def test_frames_at_an_interval(tmp_path):
    path = _write(tmp_path / "a.mp4", "mp4v", [_frame(n) for n in range(101)])
    with Video.open(path) as video:
        assert frames_at_interval(video, 1.0) == [0, 25, 50, 75, 100]
        assert frames_at_interval(video, 1.5) == [0, 38, 75]
        assert frames_at_interval(video, 0.001) == list(range(101))
        assert frames_at_interval(video, 60) == [0]
        for wrong in (0.0, -1.0, float("nan")):
            with pytest.raises(ValueError, match="above zero"):
                frames_at_interval(video, wrong)


def _pan(picture: Pixels, count: int, start: int) -> list[Pixels]:
    """Frames of a camera that turns by 1 % of the width a frame."""
    moved = [np.roll(picture, -(start + 4 * i), axis=1)[:, 20:340] for i in range(count)]
    noise = np.random.default_rng(start).normal(0, 2, (count, *moved[0].shape))
    return [np.clip(m + n, 0, 255).astype(np.uint8) for m, n in zip(moved, noise, strict=True)]


@pytest.fixture(scope="module")
def cut_video(tmp_path_factory) -> Path:
    """Scenes of 30, 20, 25 and 15 frames from different sample frames, a flash in the third."""
    folder = Path(__file__).resolve().parents[3] / "sample_data"
    scenes: list[Pixels] = []
    for name, count in (("00001", 30), ("00011", 20), ("00012", 25), ("00004", 15)):
        picture = np.asarray(cv2.imread(str(folder / f"{name}.jpg")), dtype=np.uint8)
        scenes += _pan(np.asarray(cv2.resize(picture, (360, 202))), count, start=0)
    scenes = [scene[:HEIGHT] for scene in scenes]
    scenes[62] = np.clip(scenes[62].astype(int) + 90, 0, 255).astype(np.uint8)
    return _write(tmp_path_factory.mktemp("cuts") / "cuts.mp4", "mp4v", scenes)


def test_cuts_are_found_and_pans_and_flashes_are_none(cut_video):
    told: list[tuple[int, int]] = []
    with Video.open(cut_video) as video:
        cuts = scene_cuts(video, progress=lambda *t: told.append(t), cancelled=lambda: False)
    assert cuts == [0, 30, 50, 75]
    assert told[0] == (0, 90)
    assert told[-1] == (90, 90)
    assert told == sorted(told)


@pytest.mark.parametrize("part", [range(30), range(25, 60), range(31, 50), range(62, 90)])
def test_cuts_of_a_part_are_those_of_the_whole(cut_video, part):
    source = open_pictures(cut_video)
    assert find_cuts(source, part) == [n for n in find_cuts(source, range(90)) if n in part]


def test_a_search_for_cuts_can_be_stopped(cut_video):
    asked: list[bool] = []

    def cancelled() -> bool:
        asked.append(True)
        return len(asked) > 2

    with Video.open(cut_video) as video:
        assert scene_cuts(video, progress=None, cancelled=cancelled) == [0, 30]


def test_a_path_below_a_video_is_a_frame_of_it(tmp_path):
    video = _write(tmp_path / "match.MP4", "mp4v", [_frame(n) for n in range(40)])
    assert video_frame_of_path(video / "00000012") == (video, 12)
    assert video_frame_of_path(video) is None
    assert video_frame_of_path(tmp_path / "gone.mp4" / "00000012") is None
    picture = decode_bgra(video / "00000012")
    assert _number(picture) == 12
    assert read_size(video / "00000012") == (WIDTH, HEIGHT)
    thumbnail = decode_thumbnail(video / "00000013", max_side=80)
    assert thumbnail.shape == (48, 80, 4)
    assert not thumbnail.flags.writeable
    for decode in (decode_bgra, decode_thumbnail):
        with pytest.raises(ImageError, match=r"match\.MP4: frame 40: .*has 40"):
            decode(video / "00000040")
        with pytest.raises(ImageError, match="expected a frame number"):
            decode(video / "first.jpg")


def test_a_folder_with_the_name_of_a_video_is_a_folder(tmp_path):
    folder = tmp_path / "stills.mp4"
    folder.mkdir()
    path = folder / "0001.png"
    cv2.imwrite(str(path), _frame(5))
    assert _number(decode_bgra(path)) == 5


def test_a_video_that_was_replaced_is_read_anew(tmp_path):
    path = _write(tmp_path / "a.mp4", "mp4v", [_frame(n) for n in range(4)])
    assert _number(decode_bgra(path / "1")) == 1
    assert open_shared_video(path) is open_shared_video(path)
    path.unlink()
    _write(path, "mp4v", [_frame(n) for n in range(10, 15)])
    os.utime(path, ns=(1, 1))
    assert _number(decode_bgra(path / "1")) == 11
