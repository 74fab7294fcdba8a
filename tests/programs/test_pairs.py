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


@pytest.mark.parametrize("i", PAIRS)
def test_ros_has_the_baseline_and_the_points_of_the_pair(i, tmp_path):
    present(i)
    ros = program("ros")
    left, right = (file.path for file in written("ros", i)[:2])
    baseline, rows = ros.pair(left, right, POINTS)
    T = of_input(i, tmp_path)
    assert abs(baseline - np.linalg.norm(T[:3, 3])) <= METRES
    assert np.abs(rows[:, 4:] - POINTS).max() <= 1e-5 * 20.0  # its disparity is a float
    # A point of the left camera is seen in both rectified images in one row, where the pose puts it.
    (R_left, P_left), (R_right, P_right) = rows_of(left), rows_of(right)
    for point, row in zip(POINTS, rows):
        there = R_right @ (T[:3, :3] @ (R_left.T @ point) + T[:3, 3])
        seen = P_right[:, :3] @ there
        assert np.abs(seen[:2] / seen[2] - row[2:4]).max() <= 1e-9 * 1000.0
        assert abs(row[1] - row[3]) <= 1e-9


@pytest.mark.parametrize("i", PAIRS + named("rig of four"))
def test_mrcal_has_the_pose_of_the_rig(i, tmp_path):
    present(i)
    mrcal = program("mrcal")
    first, second = (mrcal.pose(file.path) for file in written("mrcal", i)[:2])
    assert np.abs(second @ np.linalg.inv(first) - of_input(i, tmp_path)).max() <= METRES


@pytest.mark.parametrize("i", PAIRS)
def test_opencv_rectifies_the_pair_so_that_rows_agree(i, tmp_path):
    """cv2.stereoRectify of the written file: a point is in one row of both images, whose distance is the baseline."""
    present(i)
    opencv = program("opencv")
    path = written("opencv", i)[0].path
    R1, R2, P1, P2, Q = opencv.rectified(path)
    T = of_input(i, tmp_path)
    assert abs(np.linalg.norm(T[:3, 3]) - abs(1.0 / Q[3, 2])) <= METRES
    for point in POINTS:
        here, there = P1 @ np.append(R1 @ point, 1.0), P2 @ np.append(R1 @ point, 1.0)
        assert abs(here[1] / here[2] - there[1] / there[2]) <= 1e-9 * 1000.0
        assert np.abs(R2 @ (T[:3, :3] @ point + T[:3, 3]) - (R1 @ point + [P2[0, 3] / P2[0, 0], 0.0, 0.0])).max() <= 1e-8
