# SPDX-License-Identifier: BSD-3-Clause
"""Files of testdata, good and bad: the program loads what our reader of it loads, with the same pixels, and refuses the others."""
import pytest

import harness
from conversions import MODULES, asked, program
from exceptions import EXCEPTIONS

SUFFIXES = {"opencv": (".yml", ".yaml", ".xml", ".json"), "ros": (".yaml", ".ini"), "colmap": (".txt", ".bin"), "mrcal": (".cameramodel",)}


def files_of(name):
    """Those of cameras: COLMAP's rigs are read by other commands of it, from 3.12 on."""
    found = [path for kind in ("good", "bad") for path in sorted((harness.TESTDATA / "formats" / name / kind).iterdir())
             if path.suffix in SUFFIXES[name]]
    return [path for path in found if not (name == "colmap" and "rig" in path.name)]


EACH = [pytest.param(name, path, id=f"{name}: {path.parent.name}/{path.name}") for name in MODULES for path in files_of(name)]


@pytest.mark.parametrize("name, path", EACH)
def test_the_program_refuses_what_our_reader_refuses(name, path):
    module = program(name)
    real, ours, why = asked(module, path, harness.RAYS)
    expected, reason = EXCEPTIONS.get((name, path.name), ("the same", ""))
    if name == "colmap" and path.suffix == ".txt" and path.parent.name == "good" and module.is_newer(path):
        expected, reason = "stops", "its lens is of a newer COLMAP"
    assert outcome(real, ours) == expected, (reason, why, [str(each) for each in differences(real, ours)])


def differences(real, ours):
    return [harness.compare(a, b, harness.RAYS, b.slack) for a, b in zip(real, ours)]


def outcome(real, ours):
    """What the program does, where our reader does something else: it stops, loads the file, or sees other pixels."""
    if real and not ours:
        return "loads"
    if ours and not real:
        return "stops"
    same = len(real) == len(ours) and all(each.same for each in differences(real, ours))
    return "the same" if same else "other pixels"


def test_each_program_refuses_a_file():
    """Else the test above would be of files that load alone."""
    for name in MODULES:
        module = program(name)
        refused = [path for path in files_of(name) if path.parent.name == "bad" and (name, path.name) not in EXCEPTIONS
                   and not path.suffix == ".bin" and asked(module, path, harness.RAYS[:5])[:2] == ([], [])]
        assert refused, name
