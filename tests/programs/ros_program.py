# SPDX-License-Identifier: BSD-3-Clause
"""ROS: camera_calibration_parsers reads the file, image_geometry computes: ros_pixels.cc, compiled here. (The image_geometry of
Python has no unrectifyPoint.)"""
import pathlib
import subprocess

import numpy as np

from compiled import compiled
from harness import Refused, SeenCamera, finite, run

NAME = "ros"
HEADERS = [pathlib.Path("/usr/include/camera_calibration_parsers/parse.h"), pathlib.Path("/usr/include/image_geometry/pinhole_camera_model.h")]
LIBRARIES = ["-lcamera_calibration_parsers", "-limage_geometry", "-lroscpp_serialization", "-lrostime", "-lopencv_core"]

if not all(header.exists() for header in HEADERS):
    raise ImportError("no headers of camera_calibration_parsers and image_geometry")


PROGRAM = compiled("ros_pixels.cc", *run(["pkg-config", "--cflags", "opencv4"]).stdout.split(), *LIBRARIES)


def version():
    said = subprocess.run(["dpkg-query", "--show", "--showformat=${Version} ", "libcamera-calibration-parsers-dev", "libimage-geometry-dev"],
                          capture_output=True, text=True, check=False).stdout.split()
    parsers, geometry = (word.partition("-")[0].partition("+")[0] for word in said)
    return f"camera_calibration_parsers {parsers}, image_geometry {geometry}"


def cameras(path, rays, pixels=(), opencv_model=None):
    done = run([PROGRAM, path], "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in rays.tolist()))
    if done.returncode != 0:
        raise Refused(done.stderr.strip())
    size, R, *rows = done.stdout.splitlines()
    is_turned = [float(word) for word in R.split()] != [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
    return [SeenCamera(pixels=finite(np.array([[float(word) for word in row.split()] for row in rows])),
                       size=tuple(int(word) for word in size.split()),
                       # Whether a ray at 90 degrees is in front, the last digit of R's product decides.
                       left_out=(rays[:, 2] == 0.0) & is_turned)]


def pair(left, right, points):
    """StereoCameraModel's baseline, and a row u v u' v' x y z of each point."""
    done = run([PROGRAM, left, right], "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in points.tolist()))
    if done.returncode != 0:
        raise Refused(done.stderr.strip())
    baseline, *rows = done.stdout.splitlines()
    return float(baseline), np.array([[float(word) for word in row.split()] for row in rows])
