# SPDX-License-Identifier: BSD-3-Clause
"""mrcal: mrcal.cameramodel reads the file, mrcal.project computes."""
import subprocess

import mrcal
import numpy as np

from harness import Refused, SeenCamera, finite

NAME = "mrcal"


def version():
    said = subprocess.run(["dpkg-query", "--show", "--showformat=${Version}", "python3-mrcal"], capture_output=True, text=True,
                          check=False).stdout
    return "mrcal " + said.partition("-")[0]


def cameras(path, rays, pixels=(), opencv_model=None):
    try:
        model = mrcal.cameramodel(str(path))
        with np.errstate(all="ignore"):
            pixels = finite(mrcal.project(rays, *model.intrinsics()))
    except Exception as error:  # noqa: BLE001 - its parser raises what it likes
        raise Refused(str(error)) from error
    return [SeenCamera(pixels=pixels, size=tuple(int(side) for side in model.imagersize()))]


def pose(path):
    """T_cam_ref, 4 x 4."""
    T = np.eye(4)
    Rt = mrcal.cameramodel(str(path)).extrinsics_Rt_fromref()
    T[:3, :3], T[:3, 3] = Rt[:3], Rt[3]
    return T
