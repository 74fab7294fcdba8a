# SPDX-License-Identifier: BSD-3-Clause
"""How two builds' answers to the same run differ."""
import json
from collections import namedtuple

from runs import kind_of, masked

# `what` is the exit code, stdout, stderr, JSON or a written file; `where` a line or a key path in it.
Difference = namedtuple("Difference", "command what where old new")

NOTHING = "(nothing)"


def first_line(old, new):
    """(line number, old line, new line) of the first line that differs."""
    old_lines, new_lines = old.split("\n"), new.split("\n")
    for at in range(max(len(old_lines), len(new_lines))):
        old_line = old_lines[at] if at < len(old_lines) else NOTHING
        new_line = new_lines[at] if at < len(new_lines) else NOTHING
        if old_line != new_line:
            return at + 1, old_line, new_line
    raise ValueError("no line differs")


def first_value(old, new, path=""):
    """(key path, old value, new value) of the first value of two JSON documents that differs; None if none does."""
    if isinstance(old, dict) and isinstance(new, dict):
        for key in list(old) + [key for key in new if key not in old]:
            found = first_value(old.get(key, NOTHING), new.get(key, NOTHING), f"{path}.{key}")
            if found:
                return found
        return None if list(old) == list(new) else (path + " (order of keys)", list(old), list(new))
    if isinstance(old, list) and isinstance(new, list):
        for at in range(max(len(old), len(new))):
            found = first_value(old[at] if at < len(old) else NOTHING, new[at] if at < len(new) else NOTHING, f"{path}[{at}]")
            if found:
                return found
        return None
    return None if type(old) is type(new) and old == new else (path, old, new)


def parsed(text):
    try:
        return json.loads(text.replace('"time_us": TIME', '"time_us": 0').replace('"time_us":TIME', '"time_us":0'))
    except ValueError:
        return None


def differing_text(command, what, old, new):
    """The difference of two texts, as JSON where both are; None if they are the same."""
    old, new = masked(old), masked(new)
    if old == new:
        return None
    if "--json" in command and what == "stdout":
        old_json, new_json = parsed(old), parsed(new)
        value = first_value(old_json, new_json) if old_json is not None and new_json is not None else None
        if value:
            return Difference(command, "JSON", value[0], json.dumps(value[1]), json.dumps(value[2]))
    line, old_line, new_line = first_line(old, new)
    return Difference(command, what, f"line {line}", old_line, new_line)


def differences(old, new):
    """Of two answers to one run: at most one of each kind, and one for each written file."""
    command = old["command"]
    found = []
    if old["code"] != new["code"]:
        found.append(Difference(command, "exit code", "", str(old["code"]), str(new["code"])))
    for what in ("stdout", "stderr"):
        found.append(differing_text(command, what, old[what], new[what]))
    for name in sorted(old["files"].keys() | new["files"].keys()):
        if (name in old["files"]) != (name in new["files"]):
            said = ["written" if name in side["files"] else "not written" for side in (old, new)]
            found.append(Difference(command, "written files", name, *said))
            continue
        difference = differing_text(command, "written files", old["files"][name], new["files"][name])
        if difference:
            found.append(difference._replace(where=f"{name} {difference.where}"))
    return [each for each in found if each]


def kind(difference):
    return f"{kind_of(difference.command)}: {difference.what}"
