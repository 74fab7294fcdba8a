# SPDX-License-Identifier: BSD-3-Clause
"""The tables of formats/README.md are what is computed here."""
import os

import pytest

import harness
import table
from conversions import MODULES, program


def test_the_tables_of_the_readme_are_what_is_computed():
    if not harness.CORPUS.exists():
        pytest.skip(f"no corpus in {harness.CORPUS}")
    for name in MODULES:
        program(name)
    if os.environ.get("FCA_WRITE_PROGRAMS") == "1":
        table.write()
    assert table.written_text()[1].splitlines() == table.text().splitlines(), "FCA_WRITE_PROGRAMS=1 writes them again"
