#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks `facies schema` against an independent reader: python3-jsonschema.

The schema is a valid draft-07 schema, accepts every scenario that ships and what `facies check --resolved` writes, and
refuses what facies refuses. Usage: check_schema.py PROGRAM SCENARIOS_FOLDER. Exit status 77: a module is missing.
"""
import json
import pathlib
import subprocess
import sys

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

GOOD = [
    "steps: [tension, release]",
    "steps: [{tension: {tsf: 2}}]\nskin: {c: 1e1 kPa, mu1: .5MPa}",
    "steps: [{express: {ZYG_L: 1}}]\ngravity: {magnitude: 9.8 m/s^2, direction: [0, 0, -1]}",
]
BAD = [
    "name: a",
    "steps: []",
    "steps: [{tension: {tsf: 0}}]",
    "steps: [{tension: {tfs: 1.1}}]",
    "steps: [{express: {ZYG: 1.5}}]",
    "steps: [{express: {}}]",
    "steps: [{smile: {}}]",
    "steps: [tension]\nskin: {c: 21.3}",
    "steps: [tension]\nskin: {c: 6 mm}",
    "steps: [tension]\nskin: {preset: nosuch}",
    "steps: [tension]\nskinn: {}",
    "steps: [tension]\nsolver: {threads: -1}",
    "steps: [tension]\noutput: {fields: some}",
]


def main() -> int:
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])

    def facies(*arguments: str) -> str:
        return subprocess.run([program, *arguments], check=True, capture_output=True, text=True).stdout

    schema = json.loads(facies("schema"))
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    texts = GOOD + [path.read_text() for path in sorted(folder.glob("*.yaml"))]
    texts.append(facies("check", "patch-stretch", "--resolved"))
    failures = 0
    for text in texts:
        for error in validator.iter_errors(yaml.safe_load(text)):
            print(f"refused: {text!r}: {error.message}")
            failures += 1
    for text in BAD:
        if validator.is_valid(yaml.safe_load(text)):
            print(f"accepted: {text!r}")
            failures += 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
