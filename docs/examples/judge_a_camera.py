# %% [markdown]
# Judge a camera of your own: a script in cells, for a notebook, an editor, or
#
#     python judge_a_camera.py [DATASET [OUT]]
#
# DATASET is a folder of annotations and pictures, the sample data if not given; OUT is the folder
# of the overlay picture, without it none is written.

# %% What is annotated
import sys
from pathlib import Path

import cv2
import numpy as np

import procc_annotator as procc

PACKAGE = Path(procc.__file__).parent  # the sample data lie inside, in a clone beside it
SAMPLE_DATA = next(filter(Path.is_dir, (PACKAGE / "_sample_data", PACKAGE.parent / "sample_data")))
DATASET = Path(sys.argv[1]) if len(sys.argv) > 1 else SAMPLE_DATA  # in a notebook: a path
OUT = Path(sys.argv[2]) if len(sys.argv) > 2 else None
dataset = procc.load_dataset(DATASET)
print(f"{len(dataset.annotations)} annotated frames of {dataset.field.title}")


# %% A camera is a function: places in the world (metres, z down) to pixels
def through_opencv(k, r, t):
    def project(points_world):
        px = cv2.projectPoints(points_world, cv2.Rodrigues(r)[0], t, k, None)[0].reshape(-1, 2)
        px[points_world @ r[2] + t[2] <= 0] = np.nan  # behind the camera: no projection
        return px

    return procc.camera_from_function(project)


# %% The cameras of a method, as K, R and t: here fits, moved a little
rng = np.random.default_rng(1)
cameras = {}
for name, annotation in dataset.annotations.items():
    fit = procc.fit_camera(annotation, dataset.field, model="P", size=(960, 540))
    if fit.camera is None:
        print(f"{name}: no camera ({fit.failure})")
        continue
    pinhole = fit.camera
    focal = pinhole.focal_px[0] * rng.normal(1, 0.005)
    k = np.array([[focal, 0, 479.5], [0, focal, 269.5], [0, 0, 1]])
    r = pinhole.rotation_cam_from_world
    cameras[name] = through_opencv(k, r, -r @ np.array(pinhole.position_world))

# %% Scores of the set
score = procc.evaluate_set(dataset, cameras, thresholds=(2.0, 5.0))
for tau, summary in score.summaries.items():
    print(
        f"JaC@{tau:g} {summary.mean_jac:.3f}, completeness {summary.completeness:.2f}"
        f"  ({score.described})"
    )

# %% How surely: frames of one shot are alike, so whole shots are drawn (here: every three frames)
shot = {name: str(at // 3) for at, name in enumerate(dataset.annotations)}
interval = score.intervals(shot)[5.0]["mean_jac"]
print(f"between {interval.low:.3f} and {interval.high:.3f} in 95 of 100 such sets")

# %% JaC as a function of the threshold: of the set, and of its worst frame
taus, mean = score.mean_curve()
worst = min(cameras, key=lambda name: score.frames[name][5.0].jac)
curve = procc.jac_curve(dataset.annotations[worst], cameras[worst], taus, field=dataset.field)
for tau in (1.0, 2.0, 5.0, 10.0):
    at = taus == tau
    print(f"tau {tau:4.1f} px: mean {mean[at][0]:.3f}, frame {worst} {curve[at][0]:.3f}")

# %% What is wrong in that frame, element by element
for element in procc.evaluate(
    dataset.annotations[worst], cameras[worst], field=dataset.field, threshold=2.0
).elements:
    if element.status != "tp":
        far = "" if element.max_distance is None else f" {element.max_distance:.1f} px"
        print(f"{worst}: {element.name}: {element.status}{far}")

# %% The same as a picture
picture = procc.draw_overlay(
    dataset.pictures.get(worst, np.zeros((540, 960, 3), np.uint8)),
    dataset.annotations[worst], cameras[worst],
    field=dataset.field, size=(960, 540), threshold=2.0,
)  # fmt: skip
print("overlay", picture.shape)
if OUT is not None:
    out = OUT / f"{worst}.png"
    cv2.imwrite(str(out), picture)
    print(f"written: {out}")

# %% The scores as a table
rows = score.rows()
print(f"{len(rows)} rows of {', '.join(rows[0])}")
try:
    print(score.to_dataframe().groupby("threshold")["jac"].describe())
except procc.UsageError as error:
    print(error)
