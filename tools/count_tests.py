#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Counts the test cases of a ctest run: "N passed, N failed, N skipped".

usage: tools/count_tests.py build/release/tests.xml     (written by ctest --output-junit)

A GoogleTest program is one test for ctest and many cases for a reader; its cases are counted one by one, so that a case
that was skipped is never taken for one that passed. Any other test counts as one. Exit status 1 where something failed or
nothing ran.
"""

import collections
import re
import sys
import xml.etree.ElementTree as ElementTree

CASE = re.compile(r"^\[ *(OK|FAILED|SKIPPED) *\] .* \(\d+ ms\)$", re.MULTILINE)
OUTCOME = {"OK": "passed", "FAILED": "failed", "SKIPPED": "skipped"}


def outcome(test: ElementTree.Element) -> str:
    """What ctest says of a test as a whole."""
    if test.get("status") == "run":
        return "passed"
    skipped = test.find("skipped")
    asked_for = test.get("status") == "disabled" or (skipped is not None and skipped.get("message", "").startswith("SKIP_"))
    return "skipped" if asked_for else "failed"  # failed: also a crash, a time-out, a program that could not be started


def count(test: ElementTree.Element) -> collections.Counter:
    """Outcomes of the cases of one ctest test."""
    cases = collections.Counter(OUTCOME[word] for word in CASE.findall(test.findtext("system-out") or ""))
    whole = outcome(test)
    if not cases or (whole == "failed" and not cases["failed"]):
        cases[whole] += 1
    return cases


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__.split("\n\n")[1], file=sys.stderr)
        return 2
    try:
        tests = ElementTree.parse(sys.argv[1]).getroot().iter("testcase")
    except (OSError, ElementTree.ParseError) as failure:
        print(f"No test has run: {failure}", file=sys.stderr)
        return 1
    total = sum((count(test) for test in tests), collections.Counter())
    print(f"{total['passed']} passed, {total['failed']} failed, {total['skipped']} skipped")
    return 0 if total["passed"] and not total["failed"] else 1


if __name__ == "__main__":
    sys.exit(main())
