# SPDX-License-Identifier: BSD-3-Clause
"""A rectified pair: OpenCV's for its models, the command's for all."""
import json
import os
import pathlib
import subprocess

import numpy as np
import pytest

import fca_io

COMMAND = os.environ["FCA_IO"]
EXAMPLES = pathlib.Path(os.environ["FCA_EXAMPLES"])
CHAIN = EXAMPLES / "tumvi" / "camchain.yaml"
EUROC = EXAMPLES / "euroc" / "mav0"


def told(*words):
    run = subprocess.run([COMMAND, "rectify", *map(str, words), "--json"], capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


def bare(data):
    """But for the comment that says who made it."""
    return [line for line in data.splitlines() if not line.lstrip().startswith((b"#", b"//", b"<!--"))]


@pytest.mark.parametrize("file, options, words", [
    (CHAIN, {}, []), (EUROC, {}, []), (EUROC, {"alpha": 1.0}, ["--alpha", "1"]), (CHAIN, {"pinhole": 90.0}, ["--pinhole", "90"]),
    (CHAIN, {"out_size": (400, 300)}, ["--out-size", "400x300"]), (CHAIN, {"camera": ["cam1", "cam0"]}, ["--camera", "cam1,cam0"])])
def test_it_is_what_the_command_says(file, options, words):
    result = fca_io.rectify(file, **options)
    pair = told(file, *words)["pair"]
    assert result.image_size == (pair["width"], pair["height"])
    assert (result.stated, result.vertical, result.exchanged) == (pair["stated"], pair["vertical"], pair["exchanged"])
    assert result.baseline == pytest.approx(pair["baseline_m"], rel=1e-12) and result.bf == pytest.approx(pair["bf"], rel=1e-12)
    assert result.full_fov == pytest.approx(pair["full_fov_deg"], rel=1e-12)
    for view, camera, rectified, R, P, valid in zip(pair["views"], result.cameras, result.rectified_cameras,
                                                    (result.R1, result.R2), (result.P1, result.P2), result.valid):
        assert camera.name == view["camera"]
        assert rectified.model == "pinhole" and rectified.image_size == result.image_size
        np.testing.assert_allclose(R, np.reshape(view["T_rectified_camera"], (4, 4))[:3, :3], atol=1e-12)
        np.testing.assert_allclose(P[:, :3], [[pair["fx"], 0, view["cx"]], [0, pair["fy"], view["cy"]], [0, 0, 1]], atol=1e-9)
        assert rectified.parameters == pytest.approx({"fx": P[0, 0], "fy": P[1, 1], "cx": P[0, 2], "cy": P[1, 2]})
        assert valid == [view["valid"][key] for key in ("x", "y", "width", "height")]
    np.testing.assert_allclose(result.P2[:, 3], [-result.bf, 0.0, 0.0], atol=1e-9)


def test_rotations_and_camera_are_opencvs():
    cv2 = pytest.importorskip("cv2", reason="no python3-opencv")
    rig = fca_io.read(EUROC)
    left, right = rig.cameras
    T = rig.pose(right.name, left.name)
    (K1, D1), (K2, D2) = left.to_opencv(), right.to_opencv()
    R1, R2, P1, P2, *_ = cv2.stereoRectify(K1, D1, K2, D2, left.image_size, T[:3, :3], T[:3, 3],
                                           flags=cv2.CALIB_ZERO_DISPARITY, alpha=0)
    result = fca_io.rectify(rig, alpha=0.0)
    np.testing.assert_allclose(result.R1, R1, atol=1e-6)
    np.testing.assert_allclose(result.R2, R2, atol=1e-6)
    # OpenCV undistorts corners by five steps of a fixed-point iteration; ours are exact.
    np.testing.assert_allclose(result.P1, P1, rtol=0.02)
    np.testing.assert_allclose(result.P2[0, 3] / result.P2[0, 0], P2[0, 3] / P2[0, 0], rtol=1e-6)
    assert fca_io.rectify(rig).maps is None
    maps = fca_io.rectify(rig, alpha=0.0, maps=True).maps
    for (u, v), K, D, R, P in zip(maps, (K1, K2), (D1, D2), (result.R1, result.R2), (result.P1, result.P2)):
        expected_u, expected_v = cv2.initUndistortRectifyMap(K, D, R, P[:, :3], result.image_size, cv2.CV_32FC1)
        assert u.dtype == np.float32 and u.shape == result.image_size[::-1]
        np.testing.assert_allclose(u, expected_u, atol=1e-3)
        np.testing.assert_allclose(v, expected_v, atol=1e-3)


def test_matches_lie_in_one_row():
    result = fca_io.rectify(CHAIN)
    left, right = result.cameras
    T_right_left = fca_io.read(CHAIN).pose(right.name, left.name)
    points = np.random.default_rng(3).uniform([-1.0, -1.0, 2.0], [1.0, 1.0, 8.0], (300, 3))
    first = points @ result.R1.T
    second = (points @ T_right_left[:3, :3].T + T_right_left[:3, 3]) @ result.R2.T
    np.testing.assert_allclose(second - first, np.broadcast_to([-result.baseline, 0.0, 0.0], (300, 3)), atol=1e-9)
    for P, camera, seen in ((result.P1, result.rectified_cameras[0], first), (result.P2, result.rectified_cameras[1], second)):
        pixels = np.column_stack([first, np.ones(300)]) @ P.T
        np.testing.assert_allclose(pixels[:, :2] / pixels[:, 2:], camera.project(seen), atol=1e-6)
    assert result.disparity.at_infinity.max < 1e-6 and result.disparity.at_ten_baselines.rms < 1e-6
    assert 0.0 < result.disparity.at_infinity.share <= 1.0


def test_maps_are_the_commands(tmp_path):
    told(CHAIN, "--pinhole", "110", "--max-angle", "50", "--maps", "-o", f"{tmp_path}/")
    result = fca_io.rectify(CHAIN, pinhole=110.0, max_angle=50.0, maps=True)
    for side, (u, v) in zip(("left", "right"), result.maps):
        expected = np.load(tmp_path / f"{side}_map.npy")
        is_there = np.isfinite(expected).all(axis=2)
        assert is_there.any() and not is_there.all()
        np.testing.assert_array_equal(np.stack([u, v], axis=2)[is_there], expected[is_there])
        assert (u[~is_there] < -1000.0).all() and (v[~is_there] < -1000.0).all()


@pytest.mark.parametrize("to", ["orbslam3", "opencv", "ros"])
def test_settings_are_the_commands(tmp_path, to):
    result = fca_io.rectify(CHAIN, parts=[EXAMPLES / "tumvi" / "imu.yaml"], to=to)
    told(CHAIN, "--with", EXAMPLES / "tumvi" / "imu.yaml", "--to", to, "-o", f"{tmp_path}/command/")
    assert result.accepted and result.files
    result.save(tmp_path / "module")
    written = {path.name: path.read_bytes() for path in (tmp_path / "module").iterdir()}
    assert written == result.files
    commands = {path.name: bare(path.read_bytes()) for path in (tmp_path / "command").iterdir()}
    assert commands == {name: bare(data) for name, data in written.items()}
    with pytest.raises(fca_io.Error):
        result.save(tmp_path / "module")
    result.save(tmp_path / "module", force=True)


def test_what_a_file_states_is_taken(tmp_path):
    fca_io.rectify(CHAIN, to="opencv", pinhole=80.0).save(tmp_path)
    [path] = tmp_path.iterdir()
    stated = fca_io.rectify(path)
    assert stated.stated and stated.full_fov == pytest.approx(80.0, abs=0.5)
    assert not fca_io.rectify(path, pinhole=80.0).stated


def test_requests_that_cannot_be(tmp_path):
    for words in ({"alpha": 2.0}, {"pinhole": 200.0}, {"alpha": 0.0, "pinhole": 80.0}, {"out_size": (0, 10)}, {"max_angle": 0.0},
                  {"to": "no-such-program"}):
        with pytest.raises(ValueError):
            fca_io.rectify(CHAIN, **words)
    for words in ({"beta": 1.0}, {"alpha": "wide"}, {"parts": 3}):
        with pytest.raises(TypeError):
            fca_io.rectify(CHAIN, **words)
    with pytest.raises(ValueError):
        fca_io.rectify(CHAIN).save(tmp_path / "none")
    with pytest.raises(fca_io.Error) as caught:
        fca_io.rectify(CHAIN, camera="cam0")
    assert caught.value.code
