# SPDX-License-Identifier: BSD-3-Clause
"""The real parsers of programs that are not here: PyYAML (Kalibr, cuVSLAM's example, rosparam of FAST-LIVO2), yaml-cpp (SVO, maplab,
stella_vslam) and cv::FileStorage (OpenVINS, VINS-Fusion, ORB-SLAM3, Kimera-VIO, OKVIS2). Their numbers go into OpenCV's formulas."""
import json
from dataclasses import dataclass

import numpy as np
import yaml

import opencv_program
from compiled import compiled
from harness import Refused, run


def by_pyyaml(path):
    try:
        return yaml.safe_load(path.read_text(encoding="utf-8"))
    except yaml.YAMLError as error:
        raise Refused(str(error)) from error


def by_storage(path):
    storage = opencv_program.opened(path)  # its nodes are nothing without it
    return plain(storage.root())


def plain(node):
    if node.isMap():
        return {key: plain(node.getNode(key)) for key in node.keys()}
    if node.isSeq():
        return [plain(node.at(i)) for i in range(node.size())]
    if node.isInt() or node.isReal():
        return node.real()
    return node.string() if node.isString() else None


YAML_JSON = []  # compiled at its first use


def by_yaml_cpp(path):
    if not YAML_JSON:
        YAML_JSON.append(compiled("yaml_json.cc", "-lyaml-cpp"))
    done = run([YAML_JSON[0], path])
    if done.returncode != 0:
        raise Refused(done.stderr.strip())
    return json.loads(done.stdout)


# ---- lenses: for each camera of a file, a function from rays to pixels

def lens(model, focal, centre, bends):
    K = np.array([[focal[0], 0.0, centre[0]], [0.0, focal[1], centre[1]], [0.0, 0.0, 1.0]])
    D = np.array(bends, dtype=float)
    if model == "fisheye":
        return opencv_program.of_fisheye(K, D)
    return opencv_program.of_pinhole(K, D if len(bends) >= 4 else np.zeros(4))


def omni(xi, focal, centre, bends):
    K = np.array([[focal[0], 0.0, centre[0]], [0.0, focal[1], centre[1]], [0.0, 0.0, 1.0]])
    return opencv_program.of_omnidir(K, np.array(bends, dtype=float).reshape(1, 4), xi)


def bent(word):
    return "fisheye" if str(word).lower().startswith(("equi", "kannala", "fisheye")) else "pinhole"


def of_chain(data):
    """Kalibr's camchain, and OpenVINS' of the same keys."""
    cameras = []
    for name in sorted(key for key in data if key.startswith("cam") and key[3:].isdigit()):
        camera = data[name]
        numbers = camera["intrinsics"]
        if camera["camera_model"] == "omni":
            cameras.append(omni(numbers[0], numbers[1:3], numbers[3:5], camera["distortion_coeffs"]))
        else:
            cameras.append(lens(bent(camera["distortion_model"]), numbers[:2], numbers[2:4], camera["distortion_coeffs"]))
    return cameras


def of_sensor(data):
    """EuRoC's sensor.yaml, and Kimera's."""
    numbers = data["intrinsics"]
    bends = data.get("distortion_coefficients", [])
    return [lens(bent(data["distortion_model"]), numbers[:2], numbers[2:4], bends)]


def of_fast_livo(data):
    is_fisheye = data["cam_model"] == "EquidistantCamera"
    bends = [data[key] for key in (("k1", "k2", "k3", "k4") if is_fisheye else ("cam_d0", "cam_d1", "cam_d2", "cam_d3"))]
    return [lens("fisheye" if is_fisheye else "pinhole", (data["cam_fx"], data["cam_fy"]), (data["cam_cx"], data["cam_cy"]), bends)]


def of_ncamera(data):
    cameras = []
    for entry in data["cameras"]:
        camera = entry["camera"]
        numbers, bends = camera["intrinsics"]["data"], camera["distortion"]
        values = bends["parameters"]["data"] if bends["type"] != "none" else []
        cameras.append(lens(bent(bends["type"]), numbers[:2], numbers[2:4], values))
    return cameras


def of_stella(data):
    camera = data["Camera"]
    is_fisheye = camera["model"] == "fisheye"
    bends = [camera[key] for key in (("k1", "k2", "k3", "k4") if is_fisheye else ("k1", "k2", "p1", "p2", "k3"))]
    return [lens("fisheye" if is_fisheye else "pinhole", (camera["fx"], camera["fy"]), (camera["cx"], camera["cy"]), bends)]


def of_vins(data):
    kind = data["model_type"]
    numbers = data["projection_parameters"]
    if kind == "KANNALA_BRANDT":
        return [lens("fisheye", (numbers["mu"], numbers["mv"]), (numbers["u0"], numbers["v0"]), [numbers[f"k{i}"] for i in (2, 3, 4, 5)])]
    bends = [data["distortion_parameters"][key] for key in ("k1", "k2", "p1", "p2")]
    if kind == "MEI":
        return [omni(data["mirror_parameters"]["xi"], (numbers["gamma1"], numbers["gamma2"]), (numbers["u0"], numbers["v0"]), bends)]
    return [lens("pinhole", (numbers["fx"], numbers["fy"]), (numbers["cx"], numbers["cy"]), bends)]


def of_orbslam3(data):
    first = "Camera1" if "Camera1.fx" in data else "Camera"
    cameras = []
    for name in (first, "Camera2"):
        if f"{name}.fx" not in data:
            break
        bends = ("k1", "k2", "k3", "k4") if data["Camera.type"] == "KannalaBrandt8" else ("k1", "k2", "p1", "p2")
        cameras.append(lens("fisheye" if bends[2] == "k3" else "pinhole", [data[f"{name}.{key}"] for key in ("fx", "fy")],
                            [data[f"{name}.{key}"] for key in ("cx", "cy")], [data[f"{name}.{key}"] for key in bends]))
    return cameras


def of_okvis(data):
    return [lens(bent(camera["distortion_type"]), camera["focal_length"], camera["principal_point"], camera["distortion_coefficients"])
            for camera in data["cameras"]]


@dataclass
class Program:
    """A program that is not here, by its parser."""
    to: str  # as convert takes it
    parser: object
    cameras: object  # of the parsed file


PROGRAMS = {"kalibr": Program("kalibr", by_pyyaml, of_chain),
            "cuvslam": Program("euroc", by_pyyaml, of_sensor),
            "fast-livo": Program("fast-livo", by_pyyaml, of_fast_livo),
            "svo": Program("ncamera", by_yaml_cpp, of_ncamera),
            "maplab": Program("maplab", by_yaml_cpp, of_ncamera),
            "stella": Program("stella", by_yaml_cpp, of_stella),
            "openvins": Program("openvins", by_storage, of_chain),
            "vins": Program("vins", by_storage, of_vins),
            "orbslam3": Program("orbslam3", by_storage, of_orbslam3),
            "kimera": Program("kimera", by_storage, of_sensor),
            "okvis2": Program("okvis2", by_storage, of_okvis)}

def pixels(program, path, rays):
    """Of each camera of the file."""
    return [project(rays) for project in program.cameras(program.parser(path))]
