# SPDX-License-Identifier: BSD-3-Clause
"""The inputs: calibrations that fca-io writes for each program. Ten are invented; the others are real files of the corpus."""
import math
from dataclasses import dataclass, field

from harness import CORPUS, TESTDATA


@dataclass
class Input:
    name: str
    what: str
    files: list  # below the corpus, or of the folder that is made for it
    options: list = field(default_factory=list)  # for convert
    text: dict = field(default_factory=dict)  # of an invented one: its files

    @property
    def is_real(self):
        return not self.text

    def place(self, folder):
        """Its files, made if they are invented."""
        if self.is_real:
            return [CORPUS / name for name in self.files]
        for name, text in self.text.items():
            (folder / name).write_text(text, encoding="utf-8")
        return [folder / name for name in self.files]


COSINE, SINE = math.cos(0.02), math.sin(0.02)
TURNED = [[COSINE, -SINE, 0.0, -0.1], [SINE, COSINE, 0.0, 0.002], [0.0, 0.0, 1.0, 0.0015], [0.0, 0.0, 0.0, 1.0]]
# By 4e-6 rad, of which cv::Rodrigues takes no notice.
HARDLY_TURNED = [[1.0, 0.0, 4e-6, -0.1], [0.0, 1.0, 0.0, 0.0], [-4e-6, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]]


def chain(*cameras, pose=TURNED):
    """A camchain of Kalibr's: (model, distortion, intrinsics, coefficients, size), each camera 0.1 m beside the one before and
    turned a little."""
    text = ""
    for i, (model, distortion, intrinsics, coefficients, size) in enumerate(cameras):
        text += f"cam{i}:\n  camera_model: {model}\n  intrinsics: {list(intrinsics)}\n  distortion_model: {distortion}\n"
        text += f"  distortion_coeffs: {list(coefficients)}\n  resolution: {list(size)}\n  rostopic: /cam{i}\n"
        if i > 0:
            text += f"  T_cn_cnm1: {pose}\n"
    return text


def camera_info(name, K, model, D, size):
    fx, fy, cx, cy = K
    return f"""image_width: {size[0]}
image_height: {size[1]}
camera_name: {name}
camera_matrix: {{rows: 3, cols: 3, data: [{fx}, 0, {cx}, 0, {fy}, {cy}, 0, 0, 1]}}
distortion_model: {model}
distortion_coefficients: {{rows: 1, cols: {len(D)}, data: {list(D)}}}
rectification_matrix: {{rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}}
projection_matrix: {{rows: 3, cols: 4, data: [{fx}, 0, {cx}, 0, 0, {fy}, {cy}, 0, 0, 0, 1, 0]}}
"""


def invented(name, what, text, options=(), file="camchain.yaml"):
    return Input(name, what, [file], list(options), {file: text})


FISHEYE = ("pinhole", "equidistant", (310.25, 311.5, 320.75, 239.125), (0.0131, -0.0052, 0.0017, -0.00041), (640, 480))
RADTAN = ("pinhole", "radtan", (458.6, 457.3, 367.2, 248.4), (-0.2834, 0.0739, 0.00019, 0.0000176), (752, 480))

INPUTS = [
    invented("pinhole", "no distortion", chain(("pinhole", "none", (612.5, 611.25, 322.125, 238.5), (), (640, 480)))),
    invented("fisheye", "kb4, 190 deg", chain(FISHEYE), ["--max-angle", "95"]),
    invented("over 180 deg", "ds, 220 deg", chain(("ds", "none", (-0.21, 0.59, 366.5, 367.25, 511.75, 509.5), (), (1024, 1020))),
             ["--max-angle", "110"]),
    invented("omni", "Mei with xi = 1.9", chain(("omni", "radtan", (1.9, 836.0, 837.5, 376.25, 241.5),
                                                 (-0.31, 0.12, 0.0004, -0.0011), (752, 480)))),
    invented("eucm", "alpha 0.61, beta 1.17", chain(("eucm", "none", (0.61, 1.17, 301.5, 302.25, 318.5, 241.75), (), (640, 480)))),
    invented("rig of four", "kb4 with poses", chain(*[(*FISHEYE[:2], (300.0 + i, 301.5 + i, 320.25 + i, 240.5 - i), FISHEYE[3], FISHEYE[4])
                                                     for i in range(4)])),
    Input("no poses", "two camera_info", ["a.yaml", "b.yaml"], ["--join"],
          {"a.yaml": camera_info("a", (500.25, 501.5, 318.5, 242.25), "plumb_bob", (-0.31, 0.11, 0.0004, -0.0007, -0.02), (640, 480)),
           "b.yaml": camera_info("b", (502.75, 503.5, 321.5, 238.25), "rational_polynomial",
                                 (0.41, -0.22, 0.0003, -0.0005, 0.013, 0.72, -0.08, 0.003), (640, 480))}),
    Input("blanks and Unicode", "names and paths", ["links \u00e4 \u5de6.yaml", "rechts \u5267.yaml"], ["--join"],
          {"links \u00e4 \u5de6.yaml": camera_info("\"links \u00e4 \u5de6\"", (500.25, 501.5, 318.5, 242.25), "plumb_bob",
                                                   (-0.31, 0.11, 0.0004, -0.0007, -0.02), (640, 480)),
           "rechts \u5267.yaml": camera_info("\"rechts, it's: {b} #2\"", (310.25, 311.5, 320.75, 239.125), "equidistant",
                                             (0.0131, -0.0052, 0.0017, -0.00041), (640, 480))}),
    invented("long lens", "f of 123456 px", chain(("pinhole", "radtan", (123456.789, 123450.125, 2047.25, 1535.75),
                                                   (0.31, -2.5, 0.0011, -0.0007), (4096, 3072)))),
    invented("tiny lens", "f of 2.5 px", chain(("pinhole", "radtan", (2.5, 2.4375, 3.25, 2.125), (-0.11, 0.013, 0.0011, -0.0007),
                                                (8, 6)))),
    Input("tilted sensor", "14 coefficients", ["a.yaml"], [],
          {"a.yaml": camera_info("a", (700.25, 701.5, 318.5, 242.25), "rational_polynomial",
                                 (0.41, -0.22, 0.0003, -0.0005, 0.013, 0.72, -0.08, 0.003, 0.0011, -0.0002, 0.0007, 0.0001, 0.011,
                                  -0.017), (640, 480))}),
    invented("pair", "radtan", chain(RADTAN, ("pinhole", "radtan", (457.1, 456.2, 379.9, 255.2), (-0.2837, 0.0745, -0.0001, -0.000035),
                                              (752, 480)))),
    invented("parallel pair", "4e-6 rad", chain(RADTAN, ("pinhole", "radtan", (457.1, 456.2, 379.9, 255.2),
                                                         (-0.2837, 0.0745, -0.0001, -0.000035), (752, 480)), pose=HARDLY_TURNED)),
    Input("TUM-VI", "kb4 pair", ["tumvi/lukasvst__dm-vio__configs__tumvi_calib__camchain.yaml"]),
    Input("EuRoC", "radtan pair", ["kalibr/rpng__open_vins__config__euroc_mav__kalibr_imucam_chain.yaml"]),
    Input("Kalibr's omni", "Mei", ["kalibr/mrastgoo__camera_imu_calibration_kalibr_viper__camchain_yaml__camchain_I0_RPY_4A3_Mei.yaml"]),
    Input("Basalt's EuRoC", "ds pair", ["extra/basalt/VladyslavUsenko__basalt-mirror__data__euroc_ds_calib.json"]),
    Input("mobius", "OCamCalib, over 180 deg", ["ocamcalib/ctu-mrs__uav_detect__config__mobius_calib.txt"]),
    Input("WoodScape", "polynomial, 190 deg", ["woodscape/valeoai__WoodScape__scripts__calibration__front.json"]),
    Input("ORB-SLAM3's T265", "kb4", ["orbslam3/thien94__orb_slam3_ros__config__Monocular-Inertial__RealSense_T265.yaml"]),
    Input("OpenCV's omnidir", "Mei", ["opencv/ScanVan__Calibration-CPP__out_camera_omni.xml"]),
    Input("stereo_calib", "rational pair", ["opencv/messo__msc_onlab2__intrinsics.yml", "opencv/messo__msc_onlab2__extrinsics.yml"],
          ["--size", "640x480"]),
    Input("mrcal's cam0", "rational", ["extra/mrcal/dkogan__mrcal__test__data__cam0.opencv8.cameramodel"]),
    Input("VINS' A3", "Mei", ["extra/camodocal/HKUST-Aerial-Robotics__VINS-Fusion__config__A3_ptgrey__left.yaml"]),
    Input("ROS' domi", "camera_info", ["extra/ros_camera_info/ethz-asl__rovio__cfg__domi_cam0.yaml"]),
]
