#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that includes follow the arrows between the rooms.

usage: tools/check_layers.py [REPOSITORY]

The arrows are the USES of src/facies/CMakeLists.txt (drawn in docs/architecture.md): a room may include itself, the rooms it
uses, and what those use. PETSc appears in the room solve only (and in bench/, which measures it bare), and no header
includes a heavy library, but solve's own wrappers petsc*.hpp, which count as PETSc themselves. Prints every offence as
file:line and exits with 1 if there is one.
"""

import pathlib
import re
import sys

ROOM = re.compile(r"^facies_room\((\w+)([^)]*)\)", re.MULTILINE)
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]')
PETSC = re.compile(r"^(petsc|mumps|[a-z]mumps_c\.h|facies/solve/petsc)")
HEAVY = re.compile(PETSC.pattern + r"|^(yaml-cpp/|nlohmann/|embree|cairo|CLI/)")
WRAPPER = re.compile(r"^src/facies/solve/petsc\w*\.hpp$")


def read_arrows(cmake: str) -> dict[str, set[str]]:
    """Every room with the rooms it may include (itself among them), from the text of src/facies/CMakeLists.txt."""
    arrows: dict[str, set[str]] = {}
    for name, arguments in ROOM.findall(cmake):
        words = re.search(r"\bUSES((?:\s+[a-z_]+)*)", arguments)
        used = words.group(1).split() if words else []
        unknown = [room for room in used if room not in arrows]
        if unknown:
            raise SystemExit(f"src/facies/CMakeLists.txt: {name} uses {', '.join(unknown)}, which stands later or nowhere")
        arrows[name] = {name}.union(*(arrows[room] for room in used))
    return arrows


def room_offence(room: str, include: str, arrows: dict[str, set[str]]) -> str | None:
    """What is wrong with a facies include in a room, if anything."""
    target = pathlib.PurePosixPath(include).parts[1]
    if room not in arrows:
        return f"room {room} is missing from src/facies/CMakeLists.txt"
    if target not in arrows[room]:
        return f"{room} may not include {include}: it uses {', '.join(sorted(arrows[room] - {room})) or 'no other room'}"
    return None


def offences_in(path: pathlib.Path, root: pathlib.Path, arrows: dict[str, set[str]]) -> list[str]:
    """Every offence of one source file."""
    parts = path.relative_to(root).parts
    room = parts[2] if parts[:2] == ("src", "facies") and len(parts) > 3 else None
    found = []
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        match = INCLUDE.match(line)
        if not match:
            continue
        include = match.group(1)
        reasons = []
        if include.startswith("facies/"):
            if not (root / "src" / include).is_file():
                reasons.append(f"{include} does not exist")
            elif room:
                reasons.append(room_offence(room, include, arrows))
        if include.startswith("apps/") and room:
            reasons.append(f"{include} is above every room")
        if PETSC.match(include) and room != "solve" and parts[0] != "bench":
            reasons.append(f"{include} belongs in src/facies/solve only")
        if HEAVY.match(include) and path.suffix == ".hpp" and not WRAPPER.match("/".join(parts)):
            reasons.append(f"{include} is heavy: include it in the .cpp file only")
        found += [f"{path.relative_to(root)}:{number}: {reason}" for reason in reasons if reason]
    return found


def main() -> int:
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    arrows = read_arrows((root / "src/facies/CMakeLists.txt").read_text(encoding="utf-8"))
    sources = [
        path
        for folder in ("src", "apps", "examples", "tests", "bench")
        for path in sorted((root / folder).rglob("*.[ch]pp"))
    ]
    found = [offence for path in sources for offence in offences_in(path, root, arrows)]
    print("\n".join([*found, f"{len(sources)} files, {len(arrows)} rooms, {len(found)} offences"]))
    return 1 if found or not sources or not arrows else 0


if __name__ == "__main__":
    sys.exit(main())
