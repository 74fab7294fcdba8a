# SPDX-License-Identifier: BSD-3-Clause
"""The recipe examples/python/README.md, word by word: each ">>>" is run in its folder, and prints what stands below it."""
import doctest
import os
import pathlib
import shutil

EXAMPLES = pathlib.Path(os.environ["FCA_EXAMPLES"])


def test_the_recipe_prints_what_it_shows(tmp_path, monkeypatch):
    shutil.copytree(EXAMPLES, tmp_path / "examples")
    recipe = tmp_path / "examples/python"
    monkeypatch.chdir(recipe)
    # A line of ``` ends what an example prints.
    text = (recipe / "README.md").read_text().replace("\n```\n", "\n\n")
    examples = doctest.DocTestParser().get_doctest(text, {}, "README.md", str(recipe / "README.md"), 0)
    assert len(examples.examples) >= 20
    told = []
    result = doctest.DocTestRunner().run(examples, out=told.append)
    assert result.failed == 0, "".join(told)
    assert [path.suffix for path in (recipe / "settings").iterdir()] == [".yaml"]
