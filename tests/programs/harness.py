# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of real programs share: fca-io, our readers, a grid of rays, the comparison of pixels, and files with a fault."""
import json
import os
import pathlib
import re
import subprocess
from dataclasses import dataclass, field

import numpy as np

COMMAND = os.environ["FCA_IO"]
READERS = os.environ["FCA_CONSUMER_PIXELS"]
SOURCE = pathlib.Path(os.environ["FCA_SOURCE"])
TESTDATA = SOURCE / "testdata"
CORPUS = SOURCE.parent / "shared/corpus"


class Refused(Exception):
    """The program does not load the file."""


@dataclass
class SeenCamera:
    """A camera as a program, or our reader of it, holds it. Pixels and rays of nan: it has none."""
    pixels: np.ndarray  # N x 2, of the rays that were asked for
    size: tuple | None = None  # width, height; None: the program does not tell
    rays: np.ndarray | None = None  # M x 2, x / z and y / z of the pixels that were asked for; None: it was not asked
    left_out: np.ndarray | None = None  # of the rays, those for which its answer is chance
    slack: np.ndarray | None = None  # px of each ray that its last digits are worth
    approximation_px: float = 0.0  # by how much it says that it leaves its own formula


def run(words, text=None, seconds=120):
    """What a program prints; Refused where it does not end."""
    try:
        return subprocess.run([str(word) for word in words], input=text, capture_output=True, text=True, errors="replace", check=False,
                              timeout=seconds)
    except subprocess.TimeoutExpired as late:
        raise Refused(f"does not end within {seconds} s") from late


def fca_io(*words, text=None):
    """What the command says, as JSON."""
    done = run([COMMAND, *words, "--json"], text)
    return json.loads(done.stdout)


def grid():
    """Rays from the axis to 175 degrees off it, of different lengths: on it, beside it, at 90 degrees (z = 0) and behind."""
    rays = [[0.0, 0.0, 1.0], [0.0, 0.0, 2.5], [1e-9, 0.0, 1.0], [1e-5, -2e-5, 3.0]]
    for angle in [1, 5, 10, 20, 30, 40, 50, 60, 70, 80, 85, 89, 90, 91, 95, 100, 110, 120, 140, 160, 175]:
        for turn in range(0, 360, 30):
            sine, cosine = np.sin(np.radians(angle)), np.cos(np.radians(angle))
            length = 0.5 + turn / 100.0
            z = 0.0 if angle == 90 else length * cosine
            rays.append([length * sine * np.cos(np.radians(turn + 7)), length * sine * np.sin(np.radians(turn + 7)), z])
    return np.array(rays)


RAYS = grid()


def pixel_grid(width, height):
    """Over the image, its corners with it."""
    return np.array([[u, v] for v in np.linspace(0, height - 1, 9) for u in np.linspace(0, width - 1, 9)])


def by_our_reader(program, path, rays=RAYS, pixels=(), sensor="", opencv_model=None):
    """The cameras of our reader that imitates the program; Refused where it refuses."""
    text = "".join(f"r {x!r} {y!r} {z!r}\n" for x, y, z in np.asarray(rays).tolist())
    text += "".join(f"p {u!r} {v!r}\n" for u, v in np.asarray(pixels).tolist())
    words = [READERS, program, path, sensor] + ([opencv_model] if opencv_model else [])
    done = run(words, text)
    if done.returncode != 0:
        raise RuntimeError(f"{words}: {done.stderr}")
    view = json.loads(done.stdout)
    if not view["loads"]:
        raise Refused("; ".join(view["refusals"]))
    return [SeenCamera(pixels=points(camera["pixels"], 2), size=(camera["width"], camera["height"]),
                       rays=None if camera["rays"] is None else on_plane(points(camera["rays"], 3)),
                       approximation_px=camera["approximation_px"]) for camera in view["cameras"]], view


def points(rows, columns):
    return np.array([[np.nan] * columns if row is None else row for row in rows], dtype=float).reshape(-1, columns)


def on_plane(rays):
    """Where rays meet the plane z = 1."""
    return rays[:, :2] / rays[:, 2:]


def by_our_model(path, camera, rays=RAYS, options=()):
    """The pixels of the camera that we take the file for; nan where the model has none."""
    text = "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in np.asarray(rays).tolist())
    done = run([COMMAND, "project", path, "--camera", camera, *options], text)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return np.array([[float(word) for word in line.split()[:2]] for line in done.stdout.splitlines()])


def by_our_model_rays(path, camera, pixels):
    """The rays of pixels for which our model has one."""
    text = "".join(f"{u!r} {v!r}\n" for u, v in np.asarray(pixels).tolist())
    done = run([COMMAND, "unproject", path, "--camera", camera], text)
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    rays = np.array([[float(word) for word in line.split()[:3]] for line in done.stdout.splitlines()])
    return rays[np.isfinite(rays).all(axis=1)]


def finite(pixels):
    """Those that are no numbers are none."""
    return np.where(np.isfinite(pixels).all(axis=1, keepdims=True), pixels, np.nan)


# ---- the comparison

@dataclass
class Difference:
    worst_px: float = 0.0  # where both have a pixel that rounding does not move, scaled to pixels below 1000 px
    only_one: list = field(default_factory=list)  # rays for which only one has a pixel
    beyond: list = field(default_factory=list)  # rays whose pixels are further apart than rounding puts them
    other_size: bool = False

    @property
    def same(self):
        return not (self.only_one or self.beyond or self.other_size)

    def __str__(self):
        rows = [f"worst {self.worst_px:.3g} px"]
        if self.other_size:
            rows.append("another image size")
        rows += [f"only one has a pixel: {each}" for each in self.only_one[:5]]
        rows += [f"apart: {each}" for each in self.beyond[:5]]
        return "; ".join(rows)


ROUNDING_PX = 1e-9  # of formulas in double precision, for pixels below 1000 px: oracles/README.md
FARTHEST_PX = 1e7  # beyond it a double has no digits left that mean anything to a camera


def compare(real, ours, rays=RAYS, slack=None):
    """`real` and `ours`: SeenCamera. `slack`: px of each ray that rounding explains further."""
    result = Difference()
    if real.size is not None and tuple(real.size) != tuple(ours.size):
        result.other_size = True
    for i, ray in enumerate(rays.tolist()):
        if real.left_out is not None and real.left_out[i]:
            continue
        a, b = real.pixels[i], ours.pixels[i]
        there = [np.isfinite(p).all() for p in (a, b)]
        if there[0] and there[1]:
            largest = max(np.abs(a).max(), np.abs(b).max())
            if largest > FARTHEST_PX:
                continue
            apart = np.abs(a - b).max() / max(1.0, largest / 1000.0)
            rounding = 0.0 if slack is None else np.nan_to_num(slack[i], nan=0.0, posinf=0.0)
            allowed = ROUNDING_PX + ours.approximation_px + rounding
            if rounding <= 0.1 * ROUNDING_PX or apart > allowed:
                result.worst_px = max(result.worst_px, apart)
            if apart > allowed:
                result.beyond.append((ray, a.tolist(), b.tolist()))
        elif there[0] != there[1]:
            which = a if there[0] else b
            if np.abs(which).max() <= FARTHEST_PX:
                result.only_one.append((ray, a.tolist(), b.tolist()))
    return result


# ---- files with a fault, so that the comparison is known to find it

NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


def replaced(text, value, by, after=0):
    """Each number of the text from `after` on that is `value`, replaced. None: there is none."""
    body = text[after:]

    def other(match):
        before = body[match.start() - 1:match.start()] if match.start() > 0 else ""
        is_word = before.isalnum() or before in ("_", "#")
        return repr(by) if not is_word and float(match.group()) == value else match.group()

    changed = NUMBER.sub(other, body)
    return None if changed == body else text[:after] + changed


def body_start(text):
    """Behind the comments, in which numbers stand, too."""
    at = 0
    for line in text.splitlines(keepends=True):
        if line.strip() and not line.lstrip().startswith(("#", "//", "%YAML", "---", "{")):
            return at
        at += len(line)
    return 0


def faults(text, parameters, shift=0.0):
    """One sign, one order of coefficients and half a pixel: (what, text with that fault). `parameters`: of the camera, by name.
    `shift`: what the file adds to a centre."""
    start = body_start(text)
    names = list(parameters)
    bends = [name for name in names if name not in ("fx", "fy", "cx", "cy") and parameters[name] != 0.0]
    centre = parameters["cx"] + shift
    signed = (parameters[bends[0]], -parameters[bends[0]]) if bends else (parameters["fy"], -parameters["fy"])
    found = [("sign", replaced(text, *signed, start))]
    pairs = [(a, b) for a, b in zip(bends, bends[1:]) if parameters[a] != parameters[b]]
    first, second = (parameters[name] for name in (pairs[0] if pairs else ("cx", "cy")))
    if not pairs:
        first, second = first + shift, second + shift
    mark = 123456789.0625  # a number that no file has
    swapped = replaced(text, first, mark, start)
    swapped = swapped and replaced(swapped, second, first, start)
    found.append(("order", swapped and replaced(swapped, mark, second, start)))
    found.append(("half a pixel", replaced(text, centre, centre + 0.5, start)))
    return found
