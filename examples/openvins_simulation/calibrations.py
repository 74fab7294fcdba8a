# SPDX-License-Identifier: BSD-3-Clause
"""The calibrations that the estimator gets: OpenVINS' own chains, converted by fca-io there and back, and disturbed to a given error."""
import json
import pathlib
import re
import shutil
import subprocess

# name: where OpenVINS has it, the model that it has there, and the largest angle that the simulator's points have (z > 0).
RIGS = {"euroc": {"folder": "config/euroc_mav", "model": "radtan", "max_angle": None},
        "tumvi": {"folder": "config/tum_vi", "model": "kb4", "max_angle": 90}}
# What OpenVINS reads is radtan and kb4 (equidistant): other models are a step between. The last step writes OpenVINS' chain.
PATHS = {"euroc": ["radtan", "kb4", "kb4-radtan", "eucm-radtan", "ds-radtan", "ocamcalib-radtan", "dropped"],
         "tumvi": ["kb4", "ds-kb4", "eucm-kb4", "ocamcalib-kb4", "ucm-kb4", "radtan", "dropped"]}
# A lens beyond 60 deg is none for radtan.
OPTIONS = {("tumvi", "radtan"): ["--max-angle", "60"]}
# The levels of the plot, px rms. Each is the true calibration minus a multiple of what this path changes in its parameters: minus, as
# a radtan lens that is bent less folds within the image, and then has no pixel for a part of it.
LEVELS = [0.01, 0.03, 0.1, 0.25, 0.5, 1.0, 2.0, 5.0]
SHAPES = {"euroc": "ds-radtan", "tumvi": "ucm-kb4"}
SETTINGS = "config/rpng_sim/estimator_config.yaml"
NUMBERS = re.compile(r"(distortion_coeffs|intrinsics): *\[([^\]]*)\]")


class Calibrations:
    """Makes <work>/<rig>/<path>/, each with what OpenVINS reads, by the command `fca_io`."""

    def __init__(self, openvins, work, fca_io):
        self.openvins, self.work, self.fca_io = pathlib.Path(openvins), pathlib.Path(work), fca_io

    def chain(self, rig, path):
        return self.work / rig / path / "kalibr_imucam_chain.yaml"

    def true_path(self, rig):
        return PATHS[rig][0]

    def make(self):
        """-> the certificates: rows (rig, path, camera, verdict, rms, p99, max)."""
        rows = []
        for rig in RIGS:
            words = {path: self.converted(rig, path) for path in PATHS[rig]}
            words.update({f"level-{level:g}": "" for level in LEVELS})
            for level in LEVELS:
                self.disturbed(rig, level)
            for path, word in words.items():
                self.add_settings(rig, path)
                rows += [(rig, path, i, word, *error) for i, error in enumerate(self.errors(rig, self.chain(rig, path), OPTIONS.get((rig, path), [])))]
        return rows

    def add_settings(self, rig, path):
        folder = self.chain(rig, path).parent
        shutil.copy(self.openvins / RIGS[rig]["folder"] / "kalibr_imu_chain.yaml", folder)
        text = (self.openvins / SETTINGS).read_text()
        for cameras in (1, 2):
            (folder / f"settings_{cameras}.yaml").write_text(re.sub(r"max_cameras: \d+", f"max_cameras: {cameras}", text))

    def convert(self, words, output):
        """-> the verdict."""
        run = subprocess.run([self.fca_io, "convert", *map(str, words), "-o", output, "--force", "--json"], capture_output=True, text=True)
        if run.returncode != 0:
            raise RuntimeError(run.stdout + run.stderr)
        return json.loads(run.stdout)["verdict"]["word"]

    def converted(self, rig, path):
        """Writes the chain of a path, -> the worst verdict of its steps."""
        source = self.openvins / RIGS[rig]["folder"] / "kalibr_imucam_chain.yaml"
        chain = self.chain(rig, path)
        chain.parent.mkdir(parents=True, exist_ok=True)
        if path == RIGS[rig]["model"]:
            shutil.copy(source, chain)
            return ""
        if path == "dropped":
            chain.write_text(with_lenses(source.read_text(), [(f, [0.0] * 4) for f, _ in lenses_of(source)]))
            return ""
        *between, last = path.split("-")
        end = ["--to", "openvins", "--model", last, *OPTIONS.get((rig, path), [])]
        if not between:
            return self.convert([source, *end], chain)
        if between == ["ocamcalib"]:  # a file per camera, without poses: those come from the base
            files = [chain.parent / f"between.{camera}.txt" for camera in ("cam0", "cam1")]
            first = self.convert([source, "--to", "ocamcalib"], chain.parent / "between.{camera}.txt")
            return worse(first, self.convert([*files, "--join", "--into", source, *end], chain))
        middle = chain.parent / "between.yaml"
        first = self.convert([source, "--to", "kalibr", "--model", between[0]], middle)
        return worse(first, self.convert([middle, *end], chain))

    def errors(self, rig, chain, region=()):
        """Of each camera of the chain against the true one: px rms, 99 % and max. `region`: the options that limit the angle, in
        place of the rig's own."""
        options = region or (["--max-angle", str(RIGS[rig]["max_angle"])] if RIGS[rig]["max_angle"] else [])
        run = subprocess.run([self.fca_io, "compare", self.chain(rig, self.true_path(rig)), chain, "--json", *options],
                             capture_output=True, text=True)
        cameras = json.loads(run.stdout)["files"][0]["cameras"]
        return [tuple(camera["error_px"][key] for key in ("rms", "p99", "max")) for camera in cameras]

    def disturbed(self, rig, level):
        """Writes the chain whose cameras each differ by `level` px rms from the true ones."""
        true, shape = (lenses_of(self.chain(rig, path)) for path in (self.true_path(rig), SHAPES[rig]))
        chain = self.chain(rig, f"level-{level:g}")
        chain.parent.mkdir(parents=True, exist_ok=True)
        text = self.chain(rig, self.true_path(rig)).read_text()
        factors = [-level] * len(true)
        for _ in range(20):  # the error is nearly proportional to the factor
            chain.write_text(with_lenses(text, [between_lenses(a, b, s) for a, b, s in zip(true, shape, factors)]))
            errors = [rms for rms, _, _ in self.errors(rig, chain)]
            if all(rms is not None and abs(rms - level) <= 1e-3 * level for rms in errors):
                return
            factors = [s * (level / rms if rms else 0.5) for s, rms in zip(factors, errors)]
        raise RuntimeError(f"{rig}: no calibration is {level} px from the true one: {errors}")


def worse(a, b):
    return max(a, b, key=["ready", "use-with-care", "do-not-use"].index)


def lenses_of(chain):
    """-> [(intrinsics, distortion)] of the cameras of OpenVINS' chain."""
    found = {"distortion_coeffs": [], "intrinsics": []}
    for key, numbers in NUMBERS.findall(pathlib.Path(chain).read_text()):
        found[key].append([float(word) for word in numbers.split(",")])
    return list(zip(found["intrinsics"], found["distortion_coeffs"]))


def with_lenses(text, lenses):
    """The chain with these lenses in place of its own."""
    left = {"intrinsics": [f for f, _ in lenses], "distortion_coeffs": [d for _, d in lenses]}
    return NUMBERS.sub(lambda match: f"{match[1]}: {left[match[1]].pop(0)!r}", text)


def between_lenses(a, b, factor):
    return tuple([x + factor * (y - x) for x, y in zip(u, v)] for u, v in zip(a, b))
