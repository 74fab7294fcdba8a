# SPDX-License-Identifier: BSD-3-Clause
"""The table of README.md and error.svg, from results.csv and certificates.csv."""
import math
import pathlib
import re
import statistics
import sys

from calibrations import LEVELS, PATHS

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "lib/convert/figures"))
import drawing  # noqa: E402

BEGIN, END = "<!-- summary.py writes from here -->", "<!-- to here -->"
NAMES = {"tum_corridor1_512_16_okvis": "corridor", "udel_gore": "gore", "euroc_V1_01_easy": "V1_01"}
TITLES = {"euroc": "EuRoC, radtan", "tumvi": "TUM-VI, kb4"}
SEEDS = 10  # that the table is to have
LOST = 0.1  # of the length: an estimate that is further off follows the trajectory no more
LIMITS = pathlib.Path(__file__).resolve().parents[2] / "formats/include/fca/formats/verdict_limits.h"
READY, CARE = map(float, re.search(r"kVerdictRmsPx = {([\d.]+), ([\d.]+)}", LIMITS.read_text()).groups())
THRESHOLDS = [(READY, "ready up to here", 0.067), (CARE, "do not use beyond", 0.49)]  # px rms, and where the words begin
LOWEST, HIGHEST = 0.5, 50  # the ends of the figure


def is_lost(row):
    return not float(row["position_m"]) <= LOST * float(row["length_m"])  # nan, too


def write(results, certificates, folder):
    readme = folder / "README.md"
    text = readme.read_text()
    head, rest = text.split(BEGIN)
    tail = rest.split(END)[1]
    readme.write_text(head + BEGIN + "\n" + "\n".join(table(results, certificates)) + "\n" + END + tail)
    figure(results, folder / "error.svg")


def table(results, certificates):
    columns = [(cameras, trajectory) for cameras in ("2", "1") for trajectory in NAMES]
    seeds = [int(row["seed"]) for row in results]
    processor = sum(float(row["cpu_s"]) for row in results if row["cpu_s"] != "nan") / 60
    yield f"{len(results)} estimates with {len(set(seeds))} seeds, in {processor:.0f} minutes of processor time."
    flown = [sum((r["rig"], r["path"], r["cameras"], r["trajectory"]) == (rig, path, *column) for r in results)
             for rig, paths in PATHS.items() for path in paths for column in columns]
    if min(flown) < SEEDS:
        yield f"**Not whole yet**: each cell is of {min(flown)} to {max(flown)} flights, not of {SEEDS}; of less than three it has no deviation."
    yield ""
    head = ["calibration", "px rms", "p99", "max", "verdict"] + [f"{'stereo' if c == '2' else 'mono'} {NAMES[t]}" for c, t in columns]
    yield "| " + " | ".join(head) + " |"
    yield "|---" * len(head) + "|"
    for rig, paths in PATHS.items():
        yield f"| **{TITLES[rig]}** |" + " |" * (len(head) - 1)
        for path in paths:
            cells = [cell([r for r in results if (r["rig"], r["path"], r["cameras"], r["trajectory"]) == (rig, path, *column)]) for column in columns]
            yield "| " + " | ".join([in_words(path, paths[0]), *certificate(certificates, rig, path), *cells]) + " |"


def in_words(path, true):
    if path == true:
        return f"{path}, the true one"
    return "distortion dropped" if path == "dropped" else " -> ".join([true, *path.split("-")])


def certificate(certificates, rig, path):
    """Of the worse camera."""
    rows = [row for row in certificates if (row["rig"], row["path"]) == (rig, path)]
    worst = [max((float(row[key]) for row in rows if row[key]), default=None) for key in ("rms_px", "p99_px", "max_px")]
    return [*("-" if x is None else f"{x:.3g}" for x in worst), rows[0]["verdict"].replace("-", " ") or "-"]


def cell(rows):
    """Position error in cm: mean and standard deviation over the seeds."""
    lost = sum(map(is_lost, rows))
    if lost:
        return "lost" if lost == len(rows) else f"{lost} of {len(rows)} lost"
    errors = [100 * float(row["position_m"]) for row in rows]
    if len(errors) < 3:  # two tell no deviation
        return f"{statistics.mean(errors):.1f}" if errors else "-"
    return f"{statistics.mean(errors):.1f} ± {statistics.stdev(errors):.1f}"


def ratios(results, rig, cameras, path):
    """The position errors with a calibration, by those with the true one in the same flights; infinite where it is lost."""
    true = {(row["trajectory"], row["seed"]): float(row["position_m"]) for row in results
            if (row["rig"], row["cameras"], row["path"]) == (rig, cameras, PATHS[rig][0])}
    return [math.inf if is_lost(row) else float(row["position_m"]) / true[row["trajectory"], row["seed"]] for row in results
            if (row["rig"], row["cameras"], row["path"]) == (rig, cameras, path)]


def figure(results, path):
    """The errors of both rigs at each level, by those with the true calibration: the median, and the middle two thirds of the flights."""
    body = []
    for i, rig in enumerate(PATHS):
        axes = drawing.Axes((0.008, 6), (LOWEST, HIGHEST), log=True, log_x=True, top=36 + 300 * i)
        axes.grid(LEVELS, (LOWEST, 1, 2, 5, 10, 20, HIGHEST), "px", "x")
        axes.heading(TITLES[rig] + ": position error, as a multiple of that with the true calibration")
        axes.words(0.0095, 21, "line: stereo")
        axes.words(0.0095, 15, "dashed: mono")
        axes.words(0.0095, 10.7, f"{HIGHEST} x: that, more, or lost")
        for threshold, words, begin in THRESHOLDS:
            axes.curve([(threshold, LOWEST), (threshold, HIGHEST)], dashes="2 4", words=words, at=(begin, 31))
        for cameras, red, shift in (("2", False, 0.97), ("1", True, 1.03)):
            points = []
            for level in LEVELS:
                found = [min(ratio, HIGHEST) for ratio in ratios(results, rig, cameras, f"level-{level:g}")]
                if len(found) > 1:
                    low, _, middle, _, high = statistics.quantiles(found, n=6, method="inclusive")
                    points.append((level * shift, middle))
                    axes.bar(level * shift, low, high, red=red)
            axes.curve(points, red=red, dashes="6 3" if red else "")
        body += axes.body
    drawing.write(path, 660, 600, body)
