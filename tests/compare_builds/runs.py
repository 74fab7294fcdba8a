# SPDX-License-Identifier: BSD-3-Clause
"""What one build is asked about one file, and what it answers."""
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

TIMEOUT_S = 120
ENVIRONMENT = {"LC_ALL": "C.UTF-8", "NO_COLOR": "1", "PATH": os.environ.get("PATH", ""), "HOME": "/nonexistent",
               # What the sanitizers print to a build that has them stays as it is.
               **{name: value for name, value in os.environ.items() if name.endswith("SAN_OPTIONS")}}


def commands_without_file():
    """Runs that no input has a say in."""
    return [["--help"], ["formats"], ["formats", "--json"], ["models"], ["models", "--json"], ["programs"],
            ["programs", "--json"], ["check", "--list-codes"]] + [
                [command, "--help"] for command in ("show", "check", "compare", "convert", "report", "remap", "rectify", "project",
                                                    "unproject", "evaluate", "formats", "models", "programs")]


def commands_of(name, neighbour, formats):
    """The runs about the file `name`; `neighbour` is the next file of its folder, or None."""
    commands = []
    for json in ([], ["--json"]):
        commands.append(["show", name] + json)
        commands.append(["check", name] + json)
        commands.append(["compare", name, name] + json)
        if neighbour is not None:
            commands.append(["compare", name, neighbour] + json)
        # A folder, for targets that have one camera a file.
        commands += [["convert", name, "--to", target, "-o", "out/"] + json for target in formats]
    return commands


def kind_of(command):
    """What a command is counted as: its subcommand, and whether it prints JSON."""
    return command[0] + (" --json" if "--json" in command else "")


def masked(text):
    """Without what two runs of one build may differ in: how long a fit took."""
    text = re.sub(r'("time_us": ?)[-+.0-9e]+', r"\1TIME", text)
    return re.sub(r" *[0-9][.0-9]* us\b", " TIME us", text)


def decoded(data):
    return data.decode("utf-8", "surrogateescape")


def files_below(folder):
    return {str(path.relative_to(folder)): decoded(path.read_bytes())
            for path in sorted(folder.rglob("*")) if path.is_file()}


def run(program, command, folder):
    """The answer of one run inside `folder`, whose out/ is empty before and after."""
    out = folder / "out"
    out.mkdir()
    try:
        # The program's own name is not a difference; a relative run path still finds the libraries beside it.
        done = subprocess.run(["fca-io", *command], executable=program, cwd=folder, env=ENVIRONMENT, timeout=TIMEOUT_S,
                              stdin=subprocess.DEVNULL, capture_output=True, check=False)
        code, stdout, stderr = done.returncode, decoded(done.stdout), decoded(done.stderr)
    except subprocess.TimeoutExpired:
        code, stdout, stderr = f"none after {TIMEOUT_S} s", "", ""
    own_paths = ((str(program), "PROGRAM"), (str(folder), "FOLDER"))
    for path, word in own_paths:
        stdout, stderr = stdout.replace(path, word), stderr.replace(path, word)
    answer = {"command": command, "code": code, "stdout": stdout, "stderr": stderr, "files": files_below(out)}
    shutil.rmtree(out)
    return answer


def answers(program, commands, corpus):
    """Runs `commands` one after the other in a folder of their own, where corpus/ is the folder of inputs."""
    with tempfile.TemporaryDirectory(prefix="compare-builds-") as work:
        folder = Path(work)
        (folder / "corpus").symlink_to(corpus)
        return [run(program, command, folder) for command in commands]
