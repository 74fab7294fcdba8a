# SPDX-License-Identifier: BSD-3-Clause
"""Reads, converts, checks and compares camera calibrations of any format, on NumPy arrays. No process is started.

    import fca_io
    rig = fca_io.read("camchain.yaml", parts=["imu.yaml"])
    rig.cameras[0].project([[0.1, 0.2, 1.0]])             # pixels (N, 2) of points (N, 3)
    rig.cameras[0].unproject([[250.0, 250.0]])            # unit rays (N, 3) of pixels (N, 2)
    rig.pose("cam1", "cam0")                              # T_cam1_cam0 (4, 4)
    conversion = fca_io.convert(rig, to="orbslam3")
    print(conversion.verdict, conversion.reasons)
    conversion.save("out/")

What there is:

    read            a file as a Rig: cameras, IMUs, poses
    convert         to another format and, if need be, another camera model: a Conversion with a verdict
    rectify         a stereo pair: rotations, the camera of rectified images, maps, settings
    undistort_maps  from any camera to any other, for cv2.remap
    fit             a model to a camera, a function or a table of rays
    models          all models as targets for a camera, the best first
    check           what is wrong with a file, and where
    compare         how two files differ, in pixels

Pixels are (u, v) with (0, 0) at the centre of the top-left pixel; rays are (x right, y down, z forward), of any length; lengths
are metres, times seconds, errors pixels, angles degrees unless said otherwise. A pose T_a_b takes points in b to points in a.
Arrays are float64; others are converted. What a model has no answer for is NaN. Functions that compute let other threads run.

A file that cannot be read or converted raises fca_io.Error, which has the code, file, line and column; a request that cannot be,
whatever the files are, raises ValueError or TypeError.
"""
__all__ = ["Camera", "CameraComparison", "Check", "Comparison", "Conversion", "ConvertedCamera", "Error", "Finding", "Fit", "Imu",
           "Loss", "ModelFit", "PairError", "PixelError", "PoseComparison", "Reason", "Rectification", "Rig", "RowDifference",
           "Uncertainty", "VerticalDisparity", "check", "compare", "convert", "fit", "models", "read", "rectify",
           "undistort_maps"]


class Error(Exception):
    """A file that cannot be read or converted.

    code: the name of what is wrong ("missing-key"). fix: what to do; may be empty. file, line, column: where; lines and
    columns are counted from 1, and None where there is no place.
    """

    code = ""
    fix = ""
    file = ""
    line = None
    column = None

    def __str__(self):
        place = ":".join(str(part) for part in (self.file, self.line, self.column) if part)
        return (place + ": " if place else "") + super().__str__() + (f" [{self.code}]" if self.code else "")


from ._native import (Camera, CameraComparison, Check, Comparison, Conversion, ConvertedCamera, Finding, Fit, Imu,  # noqa: E402
                      Loss, ModelFit, PairError, PixelError, PoseComparison, Reason, Rectification, Rig, RowDifference,
                      Uncertainty, VerticalDisparity, __version__, check, compare, convert, fit, models, read, rectify,
                      undistort_maps)
