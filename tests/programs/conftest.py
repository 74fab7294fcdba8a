# SPDX-License-Identifier: BSD-3-Clause
"""FCA_PROGRAMS: "elsewhere" runs nothing here (.ci/run gives these tests a section of their own); "required" makes a failure of each
skip for a program that is not installed."""
import os

collect_ignore_glob = ["test_*.py"] if os.environ.get("FCA_PROGRAMS") == "elsewhere" else []
