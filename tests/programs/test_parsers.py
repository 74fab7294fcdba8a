# SPDX-License-Identifier: BSD-3-Clause
"""Programs that are not here, by their real parsers: PyYAML, yaml-cpp and cv::FileStorage find in our files the numbers that our
readers of these programs find, and stop where these do."""
import numpy as np
import pytest

import harness
from conversions import required, size_of, written
from inputs import INPUTS

NAMES = ["kalibr", "cuvslam", "fast-livo", "svo", "maplab", "stella", "openvins", "vins", "orbslam3", "kimera", "okvis2"]
ONE_CAMERA = ["fisheye", "long lens", "tiny lens", "ORB-SLAM3's T265"]
PAIRS = ["pair", "TUM-VI", "EuRoC"]
# A pair for stella_vslam is a rectified one, and OKVIS2 wants two cameras or more.
CHOSEN = {"stella": ONE_CAMERA, "okvis2": PAIRS, "kimera": PAIRS}
EACH = [pytest.param(name, next(i for i, each in enumerate(INPUTS) if each.name == which), id=f"{name}: {which}")
        for name in NAMES for which in CHOSEN.get(name, ONE_CAMERA + PAIRS)]
FLOATS = 5.0  # of the tolerance of a reader that computes in floats: the parameters, too, are rounded
FARTHEST_DEG = 75.0  # off the axis; what the programs do beyond is not a parser's


def front(path, count):
    """Rays of the images of its cameras."""
    rays = np.vstack([harness.by_our_model_rays(path, str(i), harness.pixel_grid(*size_of(path, i))) for i in range(count)])
    return rays[rays[:, 2] > np.cos(np.radians(FARTHEST_DEG)) * np.linalg.norm(rays, axis=1)]


def both(name, file):
    """(our reader's cameras, rays) of a file. None stands for one that the program is known to misread: ORB-SLAM3's second."""
    rays = front(file.path, len(file.cameras))
    sensor = "stereo" if len(file.cameras) == 2 and name == "orbslam3" else ""
    ours, view = harness.by_our_reader(name, file.path, rays, sensor=sensor)
    for camera in ours:
        camera.slack = np.full(len(rays), FLOATS * view["tolerance_px"] if view["tolerance_px"] > harness.ROUNDING_PX else 0.0)
    return [None if told["misread"] else camera for camera, told in zip(ours, view["cameras"])], rays


def difference(program, path, rays, ours):
    real = parsers().pixels(program, path, rays)
    return [harness.compare(harness.SeenCamera(pixels=a), b, rays, b.slack) for a, b in zip(real, ours) if b is not None]


def parsers():
    return required("parsers", "python3-yaml, libyaml-cpp-dev and python3-opencv")


def of(name):
    return parsers().PROGRAMS[name]


@pytest.mark.parametrize("name, i", EACH)
def test_the_parser_finds_what_our_reader_finds(name, i, tmp_path):
    program = of(name)
    for file in written(program.to, i):
        ours, rays = both(name, file)
        same = difference(program, file.path, rays, ours)
        assert same and all(each.same for each in same), [str(each) for each in same]
        for what, changed in harness.faults(file.path.read_text(encoding="utf-8"), file.parameters[0]):
            assert changed, what
            path = tmp_path / file.path.name
            path.write_text(changed, encoding="utf-8")
            assert not all(each.same for each in difference(program, path, rays, ours)), what


@pytest.mark.parametrize("name", NAMES)
def test_the_parser_stops_where_our_reader_stops(name, tmp_path):
    """At a file that is cut off inside a list or a quoted word."""
    program = of(name)
    which = CHOSEN.get(name, ONE_CAMERA)[0]
    file = written(program.to, next(i for i, each in enumerate(INPUTS) if each.name == which))[0]
    text = file.path.read_text(encoding="utf-8")
    for mark in ("[", "\""):
        start = text.find(mark, harness.body_start(text))
        if start < 0:
            continue
        path = tmp_path / file.path.name
        path.write_text(text[:start + 2], encoding="utf-8")
        with pytest.raises(harness.Refused):
            program.parser(path)
        with pytest.raises(harness.Refused):
            harness.by_our_reader(name, path)
        return
    path = tmp_path / file.path.name
    path.write_text(text + "a: [1,\n", encoding="utf-8")
    with pytest.raises(harness.Refused):
        program.parser(path)
    with pytest.raises(harness.Refused):
        harness.by_our_reader(name, path)
