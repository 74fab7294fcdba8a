# SPDX-License-Identifier: BSD-3-Clause
"""COLMAP, without a window. point_filtering, asked to filter nothing, writes the reprojection error of each point. The errors to
three places beside each other are the pixel."""
import pathlib
import shutil
import struct
import tempfile

import numpy as np

from harness import Refused, SeenCamera, run

NAME = "colmap"
CENTRE = 0.5  # of the first pixel
APART = 1000.0  # px, of the three places
SECONDS = 10  # a count of 2^64 cameras takes longer

if shutil.which("colmap") is None:
    raise ImportError("no colmap on the PATH")


def colmap(*words):
    return run(["env", "QT_QPA_PLATFORM=offscreen", "colmap", *words], seconds=SECONDS)


def version():
    return " ".join(colmap("help").stdout.split(" -- ")[0].split())


# Of the models of COLMAP 3.8, by their numbers in cameras.bin: SIMPLE_PINHOLE, ..., THIN_PRISM_FISHEYE.
MODELS = {"SIMPLE_PINHOLE": 3, "PINHOLE": 4, "SIMPLE_RADIAL": 4, "RADIAL": 5, "OPENCV": 8, "OPENCV_FISHEYE": 8, "FULL_OPENCV": 12,
          "FOV": 5, "SIMPLE_RADIAL_FISHEYE": 4, "RADIAL_FISHEYE": 5, "THIN_PRISM_FISHEYE": 12}


def is_newer(path):
    """Whether a cameras.txt has a model that COLMAP 3.8 has not."""
    words = [line.split() for line in pathlib.Path(path).read_text(encoding="utf-8").splitlines()]
    return any(len(row) > 1 and not row[0].startswith("#") and row[1] not in MODELS for row in words)


def numbers_of(path):
    """The ids of the cameras, in the order of the file."""
    path = pathlib.Path(path)
    if path.suffix == ".txt":
        rows = [line.split() for line in path.read_text(encoding="utf-8").splitlines()]
        return [int(row[0]) % 2**32 for row in rows if row and not row[0].startswith("#")]
    data, at, found = path.read_bytes(), 8, []
    while at + 24 <= len(data):
        number, model = struct.unpack_from("<Ii", data, at)
        found.append(number)
        at += 24 + 8 * list(MODELS.values())[model]
    return found


def listed(path):
    """(id, size) of each camera of a cameras.txt that COLMAP wrote."""
    rows = [line.split() for line in pathlib.Path(path).read_text(encoding="utf-8", errors="replace").splitlines()]
    return [(row[0], (int(row[2]), int(row[3]))) for row in rows if row and not row[0].startswith("#")]


def cameras(path, rays, pixels=(), opencv_model=None, near=None):
    """`near`: a guess of the pixels of each camera; the three places are there."""
    with tempfile.TemporaryDirectory(prefix="fca-colmap-") as name:
        folder = pathlib.Path(name)
        (folder / "in").mkdir(), (folder / "out").mkdir()
        text = pathlib.Path(path).read_bytes()
        (folder / "in" / ("cameras" + pathlib.Path(path).suffix)).write_bytes(text)
        found = as_listed(folder)
        order = numbers_of(path)  # COLMAP writes them in another one
        found.sort(key=lambda camera: order.index(int(camera[0])) if int(camera[0]) in order else len(order))
        (folder / "in").joinpath("cameras.bin").unlink(missing_ok=True)
        shutil.copy(folder / "out/cameras.txt", folder / "in/cameras.txt")
        places = write_images(folder / "in", found, rays, near)
        errors = filtered(folder)
    return [SeenCamera(pixels=solved(places[i], errors, i * 3 * len(rays), len(rays)), size=found[i][1]) for i in range(len(found))]


def as_listed(folder):
    """The cameras as COLMAP itself writes them again; Refused where it does not read the file."""
    suffix = ".bin" if (folder / "in/cameras.bin").exists() else ".txt"
    for name in ("images", "points3D"):
        (folder / "in" / (name + suffix)).write_bytes(bytes(8) if suffix == ".bin" else b"")
    done = colmap("model_converter", "--input_path", folder / "in", "--output_path", folder / "out", "--output_type", "TXT")
    written = folder / "out/cameras.txt"
    for name in ("images", "points3D"):
        (folder / "in" / (name + suffix)).unlink()
    if done.returncode != 0 or not written.exists():
        raise Refused((done.stdout + done.stderr).strip()[-300:] or f"ends with {done.returncode}")
    return listed(written)


def write_images(folder, found, rays, near):
    """Each camera has two images from one place. Both see three points at each ray, each in another place of the image."""
    images, points, places = [], [], []
    point = 1
    for i, (number, _) in enumerate(found):
        at = np.zeros((len(rays), 2)) if near is None or i >= len(near) else np.where(np.isfinite(near[i]), near[i], 0.0)
        at = np.where(np.abs(at) < 1e12, at, 0.0)
        places.append(at)
        seen = []
        for ray, (u, v) in zip(rays.tolist(), at.tolist()):
            for x, y in ((u, v), (u + APART, v), (u, v + APART)):
                index = len(seen)
                seen.append(f"{x + CENTRE!r} {y + CENTRE!r} {point}")
                points.append(f"{point} {ray[0]!r} {ray[1]!r} {ray[2]!r} 0 0 0 0 {2 * i + 1} {index} {2 * i + 2} {index}")
                point += 1
        for k in (1, 2):
            images.append(f"{2 * i + k} 1 0 0 0 0 0 0 {number} {2 * i + k}.png\n{' '.join(seen)}")
    (folder / "images.txt").write_text("\n".join(images) + "\n")
    (folder / "points3D.txt").write_text("\n".join(points) + "\n")
    return places


def filtered(folder):
    """The error of each point that COLMAP keeps, by its number. It drops those behind a camera."""
    done = colmap("point_filtering", "--input_path", folder / "in", "--output_path", folder / "out", "--min_track_len", 2,
                  "--max_reproj_error", "1e150", "--min_tri_angle", 0)
    if done.returncode != 0:
        raise Refused((done.stdout + done.stderr).strip()[-300:])
    written = folder / "out/points3D"
    colmap("model_converter", "--input_path", folder / "out", "--output_path", folder / "out", "--output_type", "TXT")
    rows = [line.split() for line in written.with_suffix(".txt").read_text().splitlines() if not line.startswith("#")]
    return {int(row[0]): float(row[7]) for row in rows}


def solved(places, errors, before, count):
    pixels = np.full((count, 2), np.nan)
    for i in range(count):
        d = [errors.get(before + 3 * i + k + 1) for k in range(3)]
        if None in d:
            continue
        step = [(d[0] ** 2 - d[k] ** 2 + APART ** 2) / (2.0 * APART) for k in (1, 2)]
        pixels[i] = places[i] + step
    return pixels
