#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks what every file of the repository has to keep to.

usage: tools/check_files.py [REPOSITORY]

A source has at most 500 lines and names its licence (SPDX) in its first three; a link of a page points to a file that exists;
no file names a folder of somebody's machine. Prints every offence as file:line and exits with 1 if there is one.
"""

import os
import pathlib
import re
import sys

NOT_OURS = re.compile(r"^(\.git|\.cache|build.*|out|results|node_modules|__pycache__)$")
SOURCE_SUFFIXES = {".cpp", ".hpp", ".py", ".sh", ".cmake", ".ts"}
MAX_LINES = 500
SPDX = "SPDX-License-Identifier: Apache-2.0"
LINK = re.compile(r"\]\(([^)\s]+)\)")
FENCE = re.compile(r"^\s*```")
# A path that starts at the root, not the middle of an address or of a relative path.
MACHINE_PATH = re.compile(r"(?<![\w.\-/:])/(?:work|home|root|Users)/\w")


def files_of(root: pathlib.Path) -> list[pathlib.Path]:
    """Everything in the repository but build folders and results."""
    found = []
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(name for name in folders if not NOT_OURS.match(name))
        found += [pathlib.Path(folder) / name for name in sorted(names)]
    return found


def is_source(path: pathlib.Path, text: str) -> bool:
    return path.suffix in SOURCE_SUFFIXES or path.name == "CMakeLists.txt" or text.startswith("#!")


def source_offences(text: str) -> list[tuple[int, str]]:
    """Licence and length of a source."""
    lines = text.splitlines()
    found = []
    if lines and not any(SPDX in line for line in lines[:3]):
        found.append((1, f"no line '{SPDX}' among the first three"))
    if len(lines) > MAX_LINES:
        found.append((len(lines), f"{len(lines)} lines; at most {MAX_LINES}: which two things is it?"))
    return found


def link_offences(path: pathlib.Path, text: str) -> list[tuple[int, str]]:
    """Links to files that do not exist, outside code blocks."""
    found = []
    in_code = False
    for number, line in enumerate(text.splitlines(), start=1):
        if FENCE.match(line):
            in_code = not in_code
        targets = [] if in_code else LINK.findall(re.sub(r"`[^`]*`", "", line))
        for target in targets:
            local = target.split("#")[0]
            if local and "://" not in target and not target.startswith("mailto:") and not (path.parent / local).exists():
                found.append((number, f"link to {target}, which does not exist"))
    return found


def path_offences(text: str) -> list[tuple[int, str]]:
    """Folders of somebody's machine."""
    return [
        (number, f"names a folder of a machine: {line.strip()[:80]}")
        for number, line in enumerate(text.splitlines(), start=1)
        if MACHINE_PATH.search(line)
    ]


def offences_in(path: pathlib.Path) -> list[tuple[int, str]]:
    """Every offence of one file with its line number; a file that is not text has none."""
    try:
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return []
    found = path_offences(text)
    if is_source(path, text):
        found += source_offences(text)
    if path.suffix == ".md":
        found += link_offences(path, text)
    return found


def main() -> int:
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    files = files_of(root)
    found = [f"{path.relative_to(root)}:{line}: {what}" for path in files for line, what in offences_in(path)]
    print("\n".join([*found, f"{len(files)} files, {len(found)} offences"]))
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())
