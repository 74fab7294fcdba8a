# SPDX-License-Identifier: BSD-3-Clause
"""How two cameras sit to each other, by ROS' StereoCameraModel, cv::stereoRectify and mrcal."""
import numpy as np
import pytest

import harness
from conversions import program, required, written
from inputs import INPUTS


def named(*names):
    return [pytest.param(i, id=each.name) for i, each in enumerate(INPUTS) if each.name in names]


PAIRS = named("pair", "TUM-VI", "EuRoC")
POINTS = np.array([[x, y, z] for z in (0.5, 2.0, 20.0) for x in (-0.4, 0.0, 0.3) for y in (-0.2, 0.0, 0.25)])
METRES = 1e-9


def of_input(i, folder):
    """T_second_first of the input's first two cameras, also where it states the poses of both to an IMU."""
    shown = harness.fca_io("show", *INPUTS[i].place(folder))["files"][0]
    first, second = (camera["name"] for camera in shown["cameras"][:2])
    steps = {}
    for pose in shown["poses"]:
        T = np.array(pose["T_a_b"]).reshape(4, 4)
        steps[pose["a"], pose["b"]], steps[pose["b"], pose["a"]] = T, np.linalg.inv(T)
    if (second, first) in steps:
        return steps[second, first]
    return next(steps[second, frame] @ steps[frame, first] for a, frame in steps if a == second and (frame, first) in steps)


def present(i):
    if INPUTS[i].is_real and not harness.CORPUS.exists():
        pytest.skip(f"no corpus in {harness.CORPUS}")


def rows_of(path):
    """R and P of a camera_info."""
    data = required("yaml", "python3-yaml").safe_load(path.read_text(encoding="utf-8"))
    return (np.array(data["rectification_matrix"]["data"]).reshape(3, 3), np.array(data["projection_matrix"]["data"]).reshape(3, 4))


def ros_agrees(i, T):
    """The baseline, and points of the left camera in both rectified images: in one row, where the pose puts them."""
    ros = program("ros")
    left, right = (file.path for file in written("ros", i)[:2])
    baseline, rows = ros.pair(left, right, POINTS)
    assert abs(baseline - np.linalg.norm(T[:3, 3])) <= METRES
    assert np.abs(rows[:, 4:] - POINTS).max() <= 1e-5 * 20.0  # its disparity is a float
    (R_left, P_left), (R_right, P_right) = rows_of(left), rows_of(right)
    for point, row in zip(POINTS, rows):
        there = R_right @ (T[:3, :3] @ (R_left.T @ point) + T[:3, 3])
        seen = P_right[:, :3] @ there
        assert np.abs(seen[:2] / seen[2] - row[2:4]).max() <= 1e-9 * 1000.0
        assert abs(row[1] - row[3]) <= 1e-9


def mrcal_agrees(i, T):
    mrcal = program("mrcal")
    first, second = (mrcal.pose(file.path) for file in written("mrcal", i)[:2])
    assert np.abs(second @ np.linalg.inv(first) - T).max() <= METRES


def opencv_agrees(i, T):
    """cv2.stereoRectify of the written file: a point is in one row of both images, whose distance is the baseline."""
    opencv = program("opencv")
    R1, R2, P1, P2, Q = opencv.rectified(written("opencv", i)[0].path)
    assert abs(np.linalg.norm(T[:3, 3]) - abs(1.0 / Q[3, 2])) <= METRES
    for point in POINTS:
        here, there = P1 @ np.append(R1 @ point, 1.0), P2 @ np.append(R1 @ point, 1.0)
        assert abs(here[1] / here[2] - there[1] / there[2]) <= 1e-9 * 1000.0
        assert np.abs(R2 @ (T[:3, :3] @ point + T[:3, 3]) - (R1 @ point + [P2[0, 3] / P2[0, 0], 0.0, 0.0])).max() <= 1e-8


AGREES = {"ros": ros_agrees, "mrcal": mrcal_agrees, "opencv": opencv_agrees}


@pytest.mark.parametrize("name", AGREES)
@pytest.mark.parametrize("i", PAIRS)
def test_the_program_has_the_pose_of_the_pair(name, i, tmp_path):
    present(i)
    AGREES[name](i, of_input(i, tmp_path))


@pytest.mark.parametrize("i", named("rig of four"))
def test_mrcal_has_the_pose_of_the_rig(i, tmp_path):
    present(i)
    mrcal_agrees(i, of_input(i, tmp_path))


def with_(T, rotation=None, translation=None):
    changed = T.copy()
    if rotation is not None:
        changed[:3, :3] = rotation
    if translation is not None:
        changed[:3, 3] = translation
    return changed


FAULTS = {"rotation transposed": lambda T: with_(T, rotation=T[:3, :3].T),
          "one sign": lambda T: with_(T, translation=T[:3, 3] * [-1.0, 1.0, 1.0]),
          "two numbers exchanged": lambda T: with_(T, translation=T[[1, 0, 2], 3]),
          "the other way": np.linalg.inv}


@pytest.mark.parametrize("name", AGREES)
@pytest.mark.parametrize("fault", FAULTS)
def test_the_comparison_finds_each_fault(name, fault, tmp_path):
    """A pose with that fault is none that the program has."""
    i = next(i for i, each in enumerate(INPUTS) if each.name == "pair")
    with pytest.raises(AssertionError):
        AGREES[name](i, FAULTS[fault](of_input(i, tmp_path)))
