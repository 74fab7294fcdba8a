# SPDX-License-Identifier: BSD-3-Clause
"""OpenCV: cv2.FileStorage reads the file as OpenCV's samples do, and projectPoints of calib3d, fisheye or omnidir computes."""
import cv2
import numpy as np

from harness import Refused, SeenCamera, finite

NAME = "opencv"

# The keys of OpenCV's own samples: calibration.cpp, stereo_calib.cpp, omni_calibration.cpp, omni_stereo_calibration.cpp.
KEYS = [[("camera_matrix", ("distortion_coefficients",), "xi")],
        [("Camera_Matrix", ("Distortion_Coefficients",), None)],
        [("M1", ("D1",), None), ("M2", ("D2",), None)],
        [("K1", ("D1",), None), ("K2", ("D2",), None)],
        [("camera_matrix_left", ("dist_coeffs_left", "distortion_coefficients_left"), None),
         ("camera_matrix_right", ("dist_coeffs_right", "distortion_coefficients_right"), None)],
        [("camera_matrix_1", ("distortion_coefficients_1",), "xi_1"), ("camera_matrix_2", ("distortion_coefficients_2",), "xi_2")]]
SIZES = [("image_width", "image_height"), ("image_Width", "image_Height")]


def version():
    return f"OpenCV {cv2.__version__}"


def opened(path):
    try:
        storage = cv2.FileStorage(str(path), cv2.FILE_STORAGE_READ)
    except (cv2.error, SystemError) as error:
        raise Refused(str(error)) from error
    if not storage.isOpened():
        raise Refused("FileStorage does not open it")
    return storage


def matrix(parent, name):
    """Of a storage or a node of it."""
    node = parent.getNode(name)
    if node.empty():
        return None
    try:
        value = node.mat()
    except (cv2.error, SystemError) as error:
        raise Refused(f"{name}: {error}") from error
    if value is None:
        raise Refused(f"{name} is no matrix")
    return value


def projections(storage, opencv_model=None):
    """For each camera a function from rays to pixels, and one from pixels to points at z = 1, or None."""
    if not storage.getNode("camera_0").empty():
        return of_mc_calib(storage)
    for family in KEYS:
        if not storage.getNode(family[0][0]).empty():
            break
    else:
        raise Refused("no camera matrix")
    fisheye = storage.getNode("fisheye_model")
    is_fisheye = opencv_model == "fisheye" or (opencv_model is None and not fisheye.empty() and fisheye.real() == 1)
    found = []
    for key, bends, xi_key in family:
        K = matrix(storage, key)
        if K is None:
            break
        D = next((d for d in (matrix(storage, name) for name in bends) if d is not None), None)
        if D is None:
            D = np.zeros((1, 5))
        xi = storage.getNode(xi_key) if xi_key else None
        if xi is not None and not xi.empty():
            value = xi.real() if xi.isReal() or xi.isInt() else float(matrix(storage, xi_key).ravel()[0])
            found.append((of_omnidir(K, D, value), None))
        elif is_fisheye:
            found.append((of_fisheye(K, D), rays_of_fisheye(K, D)))
        else:
            found.append((of_pinhole(K, D), None))
    if family[0][0] == "M1" and len(found) == 2 and not is_fisheye:
        rectify(storage, family, image_size(storage) or (640, 480))
    return found


def rectify(storage, family, size):
    """cv::stereoRectify of the pair, as stereo_match does it; None where the file has no pose."""
    R, T = matrix(storage, "R"), matrix(storage, "T")
    if R is None and (T is None or not storage.getNode("om").empty()):  # om: of omni_stereo_calibration
        return None
    if R is None or T is None:
        raise Refused("R or T is missing")
    bends = [next(d for d in (matrix(storage, name) for name in names) if d is not None) for _, names, _ in family]
    try:
        return cv2.stereoRectify(matrix(storage, family[0][0]), bends[0], matrix(storage, family[1][0]), bends[1], size, R, T,
                                 flags=cv2.CALIB_ZERO_DISPARITY, alpha=-1)
    except cv2.error as error:
        raise Refused(str(error)) from error


def rectified(path):
    """R1, R2, P1, P2 and Q by stereoRectify, of the lens that a file of stereo_calib's keys has."""
    storage = opened(path)
    if storage.getNode("fisheye_model").real() == 1:
        K1, D1, K2, D2, R, T = (matrix(storage, name) for name in ("M1", "D1", "M2", "D2", "R", "T"))
        return cv2.fisheye.stereoRectify(K1, D1, K2, D2, image_size(storage), R, T, flags=cv2.CALIB_ZERO_DISPARITY)[:5]
    return rectify(storage, KEYS[2], image_size(storage))[:5]


def of_mc_calib(storage):
    """MC-Calib's file: nb_camera, and a map for each camera. Its distortion_type 1 is cv::fisheye."""
    found = []
    for i in range(int(storage.getNode("nb_camera").real())):
        camera = storage.getNode(f"camera_{i}")
        K, D = (matrix(camera, name) for name in ("camera_matrix", "distortion_vector"))
        if camera.getNode("distortion_type").real() == 1:
            found.append((of_fisheye(K, D), rays_of_fisheye(K, D)))
        else:
            found.append((of_pinhole(K, D), None))
    return found


ZERO = np.zeros(3)


def of_pinhole(K, D):
    return lambda rays: cv2.projectPoints(rays.reshape(-1, 1, 3), ZERO, ZERO, K, D)[0].reshape(-1, 2)


def of_fisheye(K, D):
    return lambda rays: cv2.fisheye.projectPoints(rays.reshape(-1, 1, 3), ZERO, ZERO, K, D)[0].reshape(-1, 2)


def of_omnidir(K, D, xi):
    return lambda rays: cv2.omnidir.projectPoints(rays.reshape(-1, 1, 3), ZERO, ZERO, K, xi, D)[0].reshape(-1, 2)


def rays_of_fisheye(K, D):
    return lambda pixels: cv2.fisheye.undistortPoints(pixels.reshape(-1, 1, 2), K, D).reshape(-1, 2)


def image_size(storage):
    return next(((int(storage.getNode(w).real()), int(storage.getNode(h).real())) for w, h in SIZES
                 if not storage.getNode(w).empty()), None)


def cameras(path, rays, pixels=(), opencv_model=None):
    storage = opened(path)
    size = image_size(storage)
    seen = []
    for project, unproject in projections(storage, opencv_model):
        try:
            with np.errstate(all="ignore"):
                seen.append(SeenCamera(pixels=finite(project(rays)), size=size,
                                       rays=unproject(np.asarray(pixels)) if unproject and len(pixels) else None))
        except cv2.error as error:
            raise Refused(str(error)) from error
    return seen
