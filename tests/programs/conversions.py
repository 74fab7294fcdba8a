# SPDX-License-Identifier: BSD-3-Clause
"""Files that fca-io writes of the inputs, and what a program and we make of them. Each is made once, when it is asked for."""
import atexit
import functools
import importlib
import os
import pathlib
import shutil
import tempfile
from dataclasses import dataclass, field

import numpy as np
import pytest

import harness
from inputs import INPUTS

# By the id of our reader: the module that asks the program, and the packages that it needs.
MODULES = {"opencv": ("opencv_program", "python3-opencv"),
           "ros": ("ros_program", "libcamera-calibration-parsers-dev and libimage-geometry-dev"),
           "colmap": ("colmap_program", "colmap"),
           "mrcal": ("mrcal_program", "python3-mrcal")}
MUST_BE_THERE = os.environ.get("FCA_PROGRAMS") == "required"

WORK = pathlib.Path(tempfile.mkdtemp(prefix="fca-programs-"))
atexit.register(shutil.rmtree, WORK, ignore_errors=True)


@functools.cache
def program(name):
    """The adapter of the program; a skip, or with FCA_PROGRAMS=required a failure, where it is not installed."""
    return required(*MODULES[name])


def required(module, package):
    try:
        return importlib.import_module(module)
    except ImportError as error:
        missing(package, error)


def missing(package, why=""):
    said = f"install {package} (.ci/install-packages --programs): {why}"
    if MUST_BE_THERE:
        pytest.fail(said)
    pytest.skip(said)


@dataclass
class Written:
    path: pathlib.Path
    cameras: list  # names in the order of the file
    parameters: list  # of each camera, as written
    sizes: list = field(default_factory=list)


@functools.cache
def written(name, i):
    """The files with cameras that fca-io writes of input i for a program. What its verdict would refuse is accepted: how well the
    model fits is not asked here."""
    given = INPUTS[i]
    if given.is_real and not harness.CORPUS.exists():
        pytest.skip(f"no corpus in {harness.CORPUS}")
    folder = WORK / f"{name}-{i}"
    (folder / "in").mkdir(parents=True)
    words = ["convert", *given.place(folder / "in"), "--to", name, *given.options, "-o", f"{folder}/out/"]
    done = harness.fca_io(*words)
    if done["exit_code"] == 1:
        codes = sorted({reason["code"] for reason in done["verdict"]["reasons"]})
        done = harness.fca_io(*words, *(word for code in codes for word in ("--accept", code)))
    assert done["exit_code"] == 0, done
    parameters = {camera["name"]: camera["parameters"] for camera in done["cameras"]}
    return [Written(pathlib.Path(each["path"]), each["cameras"], [parameters[camera] for camera in each["cameras"]])
            for each in done["outputs"] if each["cameras"]]


@functools.cache
def rays_of(path, count):
    """The grid of rays, and for each camera of the file those that our model has over its image."""
    rays = [harness.RAYS]
    for camera in range(count):
        pixels = harness.pixel_grid(*size_of(path, camera))
        rays.append(harness.by_our_model_rays(path, str(camera), pixels))
    return np.vstack(rays)


@functools.cache
def size_of(path, camera):
    shown = harness.fca_io("show", path)["files"][0]["cameras"][camera]
    return shown["width_px"], shown["height_px"]


@dataclass
class Compared:
    """What a program and our reader make of one file. Empty lists: it refuses the file."""
    file: Written
    why: str  # of a refusal
    real: list
    ours: list
    reader: list  # of each camera, harness.Difference of the program and our reader
    model_px: list  # of each camera, the program and our model, over the image; nan: no ray is in both


def ask(module, path, rays, pixels=(), near=None):
    more = {"near": near} if module.NAME == "colmap" else {}
    return module.cameras(path, rays, pixels, **more)


def asked(module, path, rays, pixels=()):
    """The cameras of the program and of our reader, and why one of them refuses."""
    ours, real, why = [], [], []
    try:
        ours = by_reader(module.NAME, path, rays, pixels)
    except harness.Refused as refused:
        why.append(f"our reader: {refused}")
    try:
        real = ask(module, path, rays, pixels, [camera.pixels for camera in ours])
    except harness.Refused as refused:
        why.append(f"the program: {refused}")
    return usable(real), usable(ours), "; ".join(why)


def usable(cameras):
    """Cameras without a pixel for any ray are of no more use than a file that is refused."""
    return cameras if any((np.abs(camera.pixels) < harness.FARTHEST_PX).all(axis=1).any() for camera in cameras) else []


@functools.cache
def compared(name, i):
    """Of each file that fca-io writes of input i for the program."""
    module = program(name)
    results = []
    for file in written(name, i):
        rays = rays_of(file.path, len(file.cameras))
        real, ours, why = asked(module, file.path, rays, harness.pixel_grid(*size_of(file.path, 0)))
        result = Compared(file, why, real, ours, [], [])
        for k, (a, b) in enumerate(zip(real, ours)):
            result.reader.append(harness.compare(a, b, rays, b.slack))
            result.model_px.append(worst_in_image(a, harness.by_our_model(file.path, str(k), rays), rays, file, k))
        results.append(result)
    return results


def by_reader(name, path, rays, pixels=()):
    """Our reader's cameras, each with the px that the last digits of each ray are worth."""
    last = np.finfo(float).eps * np.linalg.norm(rays, axis=1, keepdims=True)
    near = rays + last * np.array([1.0, -1.0, 1.0]) * (rays != 0.0)
    cameras, _ = harness.by_our_reader(name, path, np.vstack([rays, near]), pixels)
    for camera in cameras:
        here, there = camera.pixels[:len(rays)], camera.pixels[len(rays):]
        with np.errstate(all="ignore"):
            camera.pixels, camera.slack = here, 10.0 * np.hypot(*(here - there).T)
    return cameras


def worst_in_image(real, model, rays, file, camera):
    """Over the rays of the model's image. Those from behind count where the program has a formula for them (omnidir)."""
    width, height = size_of(file.path, camera)
    inside = np.isfinite(model).all(axis=1) & (model >= -0.5).all(axis=1) & (model[:, 0] <= width) & (model[:, 1] <= height)
    inside &= np.isfinite(real.pixels).all(axis=1)
    if "xi" not in file.parameters[camera]:
        inside &= rays[:, 2] > 0.0
    return float(np.abs(real.pixels - model)[inside].max()) if inside.any() else float("nan")
