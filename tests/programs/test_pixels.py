# SPDX-License-Identifier: BSD-3-Clause
"""The real program and our reader of it have the same pixels of the same file, and none for the same rays."""
import pytest

import harness
from conversions import MODULES, ask, compared, program, rays_of
from inputs import INPUTS

EACH = [pytest.param(name, i, id=f"{name}: {INPUTS[i].name}") for name in MODULES for i in range(len(INPUTS))]


def is_newer(name, each):
    """Whether the file has a lens of a COLMAP after the one that runs here: our reader is of the newer one."""
    return name == "colmap" and program(name).is_newer(each.file.path)


CENTRES = {"colmap": 0.5}  # what a file adds to a centre


@pytest.mark.parametrize("name, i", EACH)
def test_the_program_sees_what_our_reader_sees(name, i):
    for each in compared(name, i):
        if is_newer(name, each):
            assert not each.real and each.ours, each.why
            continue
        assert len(each.real) == len(each.ours), each.why
        for difference, real, ours in zip(each.reader, each.real, each.ours):
            assert difference.same, str(difference)
            if real.rays is not None:
                assert abs(real.rays - ours.rays).max() <= 1e-9 * max(1.0, abs(real.rays).max())


@pytest.mark.parametrize("name, i", EACH)
def test_the_comparison_finds_each_fault(name, i, tmp_path):
    module = program(name)
    for each in compared(name, i):
        if not each.real:
            continue
        file = each.file
        rays = rays_of(file.path, len(file.cameras))
        near = [camera.pixels for camera in each.ours]
        found = harness.faults(file.path.read_text(encoding="utf-8"), file.parameters[0], CENTRES.get(name, 0.0))
        assert all(changed for _, changed in found), [what for what, changed in found if not changed]
        for what, changed in found:
            path = tmp_path / file.path.name
            path.write_text(changed, encoding="utf-8")
            try:
                real = ask(module, path, rays, near=near)
            except harness.Refused:
                continue
            assert not all(harness.compare(a, b, rays, b.slack).same for a, b in zip(real, each.ours)), what
