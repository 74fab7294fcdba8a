# SPDX-License-Identifier: BSD-3-Clause
"""Fits to what is no camera of a file, and maps for cv2.remap."""
import numpy as np
import pytest

import fca_io

KB4 = {"fx": 190.9, "fy": 190.8, "cx": 254.9, "cy": 256.9, "k1": 0.0034, "k2": 0.0007, "k3": -0.002, "k4": 0.0002}
SIZE = (512, 512)


def stereographic(pixels, focal=220.0, centre=(511.5, 383.5)):
    """r = 2 f tan(angle / 2): UCM can be that, with alpha = 1/2."""
    x, y = ((pixels - centre) / (2.0 * focal)).T
    r2 = x * x + y * y
    return np.column_stack([2.0 * x, 2.0 * y, 1.0 - r2]) / (1.0 + r2)[:, None]


def test_a_function_is_fitted():
    fit = fca_io.fit(stereographic, "ucm", image_size=(1024, 768))
    assert fit.error.max < 1e-6 and fit.camera.image_size == (1024, 768)
    assert fit.camera.parameters["alpha"] == pytest.approx(0.5, abs=1e-6)
    assert fit.error.bound == np.inf, "nothing is known between the pixels"
    with pytest.raises(ValueError, match="max_angle"):
        fca_io.fit(stereographic, "radtan", image_size=(1024, 768))
    cone = fca_io.fit(stereographic, "radtan", max_angle=60.0, image_size=(1024, 768))
    assert cone.error.rms < 2.0 and cone.max_angle <= 60.0
    worse = fca_io.fit(stereographic, "kb4", image_size=(1024, 768))
    assert 1e-6 < worse.error.rms < 0.5 and worse.scored == pytest.approx(1.0)


def test_a_function_that_is_a_camera_gives_the_cameras_fit():
    camera = fca_io.Camera("kb4", KB4, SIZE)
    by_camera = fca_io.fit(camera, "eucm", max_angle=90.0)
    by_function = fca_io.fit(camera.unproject, "eucm", max_angle=90.0, image_size=SIZE)
    assert by_function.error.rms == pytest.approx(by_camera.error.rms, rel=0.02)
    for name, value in by_camera.camera.parameters.items():
        assert by_function.camera.parameters[name] == pytest.approx(value, rel=2e-3), name


def test_a_table_is_fitted_and_rows_without_numbers_are_left_out():
    camera = fca_io.Camera("kb4", KB4, SIZE)
    pixels = np.random.default_rng(2).uniform(0.0, 511.0, (800, 2))
    rays = 3.0 * camera.unproject(pixels)
    rays[::50] = np.nan
    fit = fca_io.fit((rays, pixels), "kb4")
    assert fit.error.max < 1e-6 and fit.camera.image_size is None
    for name, value in KB4.items():
        assert fit.camera.parameters[name] == pytest.approx(value, abs=1e-6), name


@pytest.mark.parametrize("source, options", [
    (stereographic, {}), (stereographic, {"image_size": (1024, 768), "objective": "max"}),
    ((np.ones((3, 3)), np.ones((3, 2))), {}), ((np.ones((9, 3)), np.ones((8, 2))), {}), ("a.yaml", {}),
    (lambda pixels: np.ones((len(pixels), 2)), {"image_size": (64, 48)}),
    (lambda pixels: np.full((len(pixels), 3), np.nan), {"image_size": (64, 48)})])
def test_what_is_no_lens_is_refused(source, options):
    with pytest.raises(ValueError):
        fca_io.fit(source, "kb4", **options)


def test_what_a_function_raises_comes_through():
    def broken(pixels):
        raise KeyError("of the lens")
    with pytest.raises(KeyError):
        fca_io.fit(broken, "kb4", image_size=(64, 48))


def test_maps_are_opencvs():
    cv2 = pytest.importorskip("cv2", reason="no python3-opencv")
    camera = fca_io.Camera("kb4", KB4, SIZE)
    pinhole = fca_io.Camera("pinhole", {"fx": 150.0, "fy": 151.0, "cx": 200.0, "cy": 150.0}, (400, 300))
    R = cv2.Rodrigues(np.array([0.02, -0.05, 0.1]))[0]
    K, D = camera.to_opencv()
    P, _ = pinhole.to_opencv()
    u, v = fca_io.undistort_maps(camera, pinhole, R.T)
    assert u.shape == (300, 400) and u.dtype == np.float32
    expected_u, expected_v = cv2.fisheye.initUndistortRectifyMap(K, D, R, P, (400, 300), cv2.CV_32FC1)
    np.testing.assert_allclose(u, expected_u, atol=1e-3)
    np.testing.assert_allclose(v, expected_v, atol=1e-3)
    image = np.random.default_rng(3).integers(0, 255, (512, 512), dtype=np.uint8)
    assert cv2.remap(image, u, v, cv2.INTER_LINEAR).shape == (300, 400)


def test_pixels_without_a_source_are_far_outside():
    radtan = fca_io.Camera("radtan", {"fx": 400.0, "fy": 400.0, "cx": 320.0, "cy": 240.0, "k1": -0.3}, (640, 480))
    wide = fca_io.Camera("kb4", KB4, SIZE)
    u, v = fca_io.undistort_maps(radtan, wide)
    assert u[256, 2] < -1000.0 and abs(u[257, 255] - 320.0) < 2.0 and abs(v[257, 255] - 240.0) < 2.0


def test_a_target_needs_a_size_and_R_is_a_rotation():
    camera = fca_io.Camera("kb4", KB4)
    with pytest.raises(ValueError):
        fca_io.undistort_maps(camera, camera)
    sized = fca_io.Camera("kb4", KB4, SIZE)
    for matrix in (np.full((3, 3), np.nan), 2.0 * np.eye(3), np.diag([1.0, 1.0, -1.0]), np.eye(4)):
        with pytest.raises(ValueError):
            fca_io.undistort_maps(sized, sized, matrix)
