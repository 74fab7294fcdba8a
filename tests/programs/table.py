# SPDX-License-Identifier: BSD-3-Clause
"""The tables of formats/README.md on what real programs make of our files, between two marks. FCA_WRITE_PROGRAMS=1 writes them."""
import numpy as np

import harness
from conversions import MODULES, compared, program
from inputs import INPUTS

README = harness.SOURCE / "formats/README.md"
BEGIN, END = "<!-- tests/programs: begin -->\n", "<!-- tests/programs: end -->\n"

# When the versions that run here were released.
RELEASED = {"OpenCV 4.6.0": "2022-06", "camera_calibration_parsers 1.12.0": "2020-04-03", "image_geometry 1.16.2": "2022-10-03",
            "COLMAP 3.8": "2023-01-31", "mrcal 2.2": "2022-02"}
# Differences are told by the least of these that is larger: the last digits are another machine's.
STEPS_PX = [1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 0.1, 1.0]


def below(px):
    """"1e-9" for all that is less, and the number itself where no step is larger."""
    if np.isnan(px):
        return "-"
    return next((f"{step:g}".replace("e-0", "e-") for step in STEPS_PX if px <= step), f"{px:.1g}")


def cell(name, i):
    results = compared(name, i)
    if not any(each.real for each in results):
        return "stops, both" if not any(each.ours for each in results) else "needs 4.1"
    reader = max(difference.worst_px for each in results for difference in each.reader)
    model = np.nanmax([px for each in results for px in each.model_px])
    return f"{below(reader)}, {below(model)}"


def versions():
    """("OpenCV 4.6.0", "2022-06") of each program that runs here."""
    words = [word for name in MODULES for word in program(name).version().split(", ")]
    return [(word, RELEASED[word]) for word in words]


def of_programs():
    titles = {"opencv": "OpenCV", "ros": "ROS", "colmap": "COLMAP", "mrcal": "mrcal"}
    rows = ["| input | of | " + " | ".join(titles[name] for name in MODULES) + " |", "|---" * (2 + len(MODULES)) + "|"]
    for i, each in enumerate(INPUTS):
        name = f"{each.name} (real)" if each.is_real else each.name
        rows.append(f"| {name} | {each.what} | " + " | ".join(cell(program_name, i) for program_name in MODULES) + " |")
    return "\n".join(rows) + "\n"


def of_others():
    """Those that do not run here, by the source that their readers were written from."""
    programs = harness.fca_io("programs")["programs"]
    words = {"built-once": "its pixels", "from-source": "its source"}
    rows = ["| reader of | written from | checked with |", "|---|---|---|"]
    sources = {}
    for each in programs:
        if each["checked"] != "real-program":
            sources.setdefault((each["source"], each["checked"]), []).append(f"`{each['id']}`")
    for (source, checked), ids in sources.items():
        rows.append(f"| {', '.join(ids)} | {source} | {words[checked]} |")
    return "\n".join(rows) + "\n"


def text():
    told = ", ".join(f"{name} ({date})" for name, date in versions())
    return f"""Debian 12's {told}.

{of_programs()}
These are read by readers of ours alone. *Its pixels*: the program was built once, and tests compare with what it printed.

{of_others()}"""


def written_text():
    before, _, rest = README.read_text(encoding="utf-8").partition(BEGIN)
    table, _, after = rest.partition(END)
    return before, table, after


def write():
    before, _, after = written_text()
    README.write_text(before + BEGIN + text() + END + after, encoding="utf-8")
