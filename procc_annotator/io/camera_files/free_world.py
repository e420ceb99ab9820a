"""What can be said of where a camera stands, whatever format its file has."""

from __future__ import annotations

from procc_annotator.camera.fisheye import FisheyeCamera
from procc_annotator.camera.pinhole import PinholeCamera
from procc_annotator.io.camera_files.loaded_camera import LoadedCamera, with_notices

_FAR_M = 1000.0


def with_plausibility_remark(loaded: LoadedCamera) -> LoadedCamera:
    """The same with a remark where no camera stands: below the ground, or a kilometre away.

    Structure from motion finds a world up to its place, turn and size; only who laid it upon the
    field can know whether that was done.
    """
    camera = loaded.camera
    if not isinstance(camera, PinholeCamera | FisheyeCamera):
        return loaded
    x, y, z = camera.position_world
    doubt = ""
    if z > 0:
        doubt = f"stands {z:.3g} m below the ground: expected metres with z down"
    elif max(abs(x), abs(y), abs(z)) > _FAR_M:
        doubt = "stands more than a kilometre from the field's centre: expected metres"
    if not doubt:
        return loaded
    told = f"{doubt} (is the world of the file the field's?)"
    return with_notices(loaded, (told,))
