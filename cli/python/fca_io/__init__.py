# SPDX-License-Identifier: BSD-3-Clause
"""fca-io: read, convert, check and compare camera calibrations.

    import fca_io
    rig = fca_io.read("camchain.yaml", parts=["imu.yaml"])
    rig.cameras[0].project([[0.1, 0.2, 1.0]])            # pixels (N, 2)
    rig.pose("cam1", "cam0")                              # T_cam1_cam0, 4 x 4
    conversion = fca_io.convert(rig, to="orbslam3")
    print(conversion.verdict, conversion.reasons)
    conversion.save("out/")

Pixels are (u, v) with (0, 0) at the centre of the top-left pixel; rays are (x right, y down, z forward); lengths are metres,
angles degrees. A pose T_a_b takes points in b to points in a.
"""
__all__ = ["Camera", "CameraComparison", "Check", "Comparison", "Conversion", "ConvertedCamera", "Error", "Finding", "Fit", "Imu",
           "ModelFit", "PixelError", "PoseComparison", "Reason", "Rig", "check", "compare", "convert", "fit", "models", "read",
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
                      ModelFit, PixelError, PoseComparison, Reason, Rig, __version__, check, compare, convert, fit, models, read,
                      undistort_maps)
