# SPDX-License-Identifier: BSD-3-Clause
"""The example of cli/python/README.md runs beside the files that it names."""
import os
import pathlib
import re
import shutil

import numpy as np

EXAMPLES = pathlib.Path(os.environ["FCA_EXAMPLES"])


def test_the_example_runs(tmp_path, monkeypatch):
    [code] = re.findall(r"```python\n(import fca_io.*?)```", (EXAMPLES.parent / "cli/python/README.md").read_text(), re.DOTALL)
    shutil.copytree(EXAMPLES / "tumvi", tmp_path / "tumvi")
    monkeypatch.chdir(tmp_path / "tumvi")
    names = {}
    exec(compile(code, "README.md", "exec"), names)  # pylint: disable=exec-used
    assert names["pixels"].shape == (500, 2) and np.isfinite(names["pixels"]).all()
    assert names["conversion"].verdict == "ready"
    assert [path.suffix for path in pathlib.Path("settings").iterdir()] == [".yaml"]
    assert names["D"].shape == (4,)
    assert names["left"][0].shape == names["right"][1].shape == names["pair"].image_size[::-1]
    assert names["map_u"].shape == (480, 640)
