# SPDX-License-Identifier: BSD-3-Clause
"""Programs of this folder that are compiled when they are asked for."""
import atexit
import pathlib
import shutil
import tempfile

from harness import run


def compiled(source, *flags):
    """The path of the program of a source of this folder."""
    folder = tempfile.mkdtemp(prefix="fca-program-")
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    program = pathlib.Path(folder) / pathlib.Path(source).stem
    done = run(["g++", "-std=c++17", pathlib.Path(__file__).parent / source, "-o", program, *flags])
    if done.returncode != 0:
        raise RuntimeError(done.stderr)
    return program
