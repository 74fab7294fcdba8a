# SPDX-License-Identifier: BSD-3-Clause
"""Cameras as numpy and OpenCV see them."""
import math

import numpy as np
import pytest

import fca_io

KB4 = {"fx": 190.9, "fy": 190.8, "cx": 254.9, "cy": 256.9, "k1": 0.0034, "k2": 0.0007, "k3": -0.002, "k4": 0.0002}
RADTAN = {"fx": 458.6, "fy": 457.2, "cx": 367.2, "cy": 248.4, "k1": -0.2834, "k2": 0.0739, "p1": 2e-4, "p2": 2e-5, "k3": 0.001}


def points(count, seed=1):
    """In front of a camera, up to 45 degrees from its axis."""
    random = np.random.default_rng(seed)
    return np.column_stack([random.uniform(-1.0, 1.0, (count, 2)), np.full(count, 1.5)])


def test_unproject_is_the_inverse_of_project():
    camera = fca_io.Camera("kb4", KB4, (512, 512))
    rays = points(500)
    pixels = camera.project(rays)
    assert pixels.shape == (500, 2) and pixels.dtype == np.float64
    unit = rays / np.linalg.norm(rays, axis=1, keepdims=True)
    np.testing.assert_allclose(camera.unproject(pixels), unit, atol=1e-12)


def test_one_point_gives_one_pixel():
    camera = fca_io.Camera("kb4", KB4)
    np.testing.assert_array_equal(camera.project([0.0, 0.0, 2.0]), [KB4["cx"], KB4["cy"]])
    assert camera.unproject([10.0, 20.0]).shape == (3,)


def test_what_the_model_has_no_pixel_for_is_not_a_number():
    camera = fca_io.Camera("radtan", RADTAN)
    pixels = camera.project([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [math.nan, 0.0, 1.0]])
    assert np.isfinite(pixels[0]).all() and np.isnan(pixels[1:]).all()


@pytest.mark.parametrize("shape", [(4,), (2, 2), (2, 3, 3), ()])
def test_other_shapes_are_refused(shape):
    with pytest.raises(ValueError):
        fca_io.Camera("kb4", KB4).project(np.zeros(shape))


def test_lists_views_and_other_types_are_taken():
    camera = fca_io.Camera("kb4", KB4)
    rays = points(10)
    expected = camera.project(rays)
    np.testing.assert_array_equal(camera.project(rays.tolist()), expected)
    np.testing.assert_array_equal(camera.project(np.asfortranarray(rays)), expected)
    np.testing.assert_array_equal(camera.project(np.repeat(rays, 2, axis=0)[::2]), expected)
    assert camera.project(rays[:0]).shape == (0, 2)


def test_opencv_projects_to_the_same_pixels():
    cv2 = pytest.importorskip("cv2", reason="no python3-opencv")
    rays = points(200)
    nothing = np.zeros(3)
    K, D = fca_io.Camera("radtan", RADTAN).to_opencv()
    expected, _ = cv2.projectPoints(rays, nothing, nothing, K, D)
    np.testing.assert_allclose(fca_io.Camera("radtan", RADTAN).project(rays), expected[:, 0], atol=1e-9)
    K, D = fca_io.Camera("kb4", KB4).to_opencv()
    expected, _ = cv2.fisheye.projectPoints(rays[:, None], nothing, nothing, K, D)
    np.testing.assert_allclose(fca_io.Camera("kb4", KB4).project(rays), expected[:, 0], atol=1e-9)


@pytest.mark.parametrize("coefficients, model", [([], "pinhole"), ([0.1, 0.01, 1e-3, 1e-4], "radtan"),
                                                 ([0.1, 0.01, 1e-3, 1e-4, 1e-3], "radtan"),
                                                 ([0.1, 0.01, 1e-3, 1e-4, 1e-3, 0.2, 0.01, 1e-3], "rational"),
                                                 ([0.1, 0.01, 1e-3, 1e-4, 1e-3, 0.2, 0.01, 1e-3, 2e-3, 0, -1e-3, 0], "opencv14"),
                                                 ([0.1, 0.01, 1e-3, 1e-4, 1e-3, 0.2, 0.01, 1e-3, 0, 0, 0, 0, 0.01, -0.02], "opencv14")])
def test_from_opencv_and_back(coefficients, model):
    K = np.array([[400.0, 0.0, 320.0], [0.0, 401.0, 240.0], [0.0, 0.0, 1.0]])
    camera = fca_io.Camera.from_opencv(K, coefficients, (640, 480))
    assert camera.model == model and camera.image_size == (640, 480)
    back, D = camera.to_opencv()
    np.testing.assert_array_equal(back, K)
    np.testing.assert_array_equal(D[:len(coefficients)], coefficients)
    assert not D[len(coefficients):].any()


def test_a_skewed_matrix_is_kept():
    K = np.array([[400.0, 1.0, 320.0], [0.0, 401.0, 240.0], [0.0, 0.0, 1.0]])
    camera = fca_io.Camera.from_opencv(K, [0.1, 0.0, 0.0, 0.0, 0.0])
    np.testing.assert_allclose(camera.project([0.0, 1.0, 10.0])[0], 320.0 + 0.1 * 1.001, rtol=0, atol=1e-9)
    np.testing.assert_array_equal(camera.to_opencv()[0], K)
    tilted = fca_io.Camera.from_opencv(K, [0.01] * 14)
    assert tilted.model == "opencv14-skew"
    np.testing.assert_array_equal(tilted.to_opencv()[0], K)


@pytest.mark.parametrize("model, parameters", [("kb5", KB4), ("kb4", {"fz": 1.0}), ("kb4", {"fx": -1.0}), ("kb4", {**KB4, "k1": math.inf}),
                                               ("kb4", {})])
def test_no_camera_is_made_of_such(model, parameters):
    with pytest.raises(ValueError):
        fca_io.Camera(model, parameters)


def test_parameters_keep_the_models_order():
    assert list(fca_io.Camera("kb4", dict(reversed(KB4.items()))).parameters) == list(KB4)
