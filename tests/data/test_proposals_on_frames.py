"""On a real frame the camera is found without a click."""

from procc_annotator.calibration.single_image.propose import propose_camera
from procc_annotator.field.load import load_field
from procc_annotator.formats.annotations.soccernet import read_annotation
from procc_annotator.image.decoding import decode_bgra
from tests.bench.no_clicks.clips import is_right


def test_the_camera_of_a_real_frame(shared_data):
    field = load_field("soccer")
    picture = decode_bgra(shared_data / "frames" / "bra_mex.jpg")
    file = shared_data / "frames" / "bra_mex.json"
    clicked = read_annotation(file.read_bytes(), path=str(file), field=field)
    found = propose_camera(picture, field)
    size = picture.shape[1], picture.shape[0]
    assert is_right(clicked, found.fit.camera, size, field)
