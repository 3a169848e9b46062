#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""quickstart and test say what they would do, and what is missing on a system that they do not know."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(*command, **environment):
    done = subprocess.run(
        command, cwd=ROOT, env={**os.environ, **environment}, capture_output=True, text=True, check=False
    )
    return done.returncode, done.stdout + done.stderr


class Setup(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def other_system(self, with_tools=()):
        """Environment of a system that is not Debian 12 and has these programs only, beside the shell's own."""
        release = self.folder / "os-release"
        release.write_text('PRETTY_NAME="Other Linux 7"\nVERSION_CODENAME=seven\n', encoding="utf-8")
        tools = self.folder / "bin"
        tools.mkdir()
        for name in ("awk", "bash", "cat", "dirname", "env", "nproc", *with_tools):
            (tools / name).symlink_to(f"/usr/bin/{name}")
        return {"FACIES_OS_RELEASE": str(release), "PATH": str(tools)}

    def test_print_names_every_step_and_does_nothing(self):
        status, output = run("./quickstart", "--print", FACIES_REFERENCE_FACE=self.face())
        self.assertEqual(status, 0, output)
        self.assertRegex(output, r"\+ cmake --build build/release .*--target facies")
        self.assertRegex(output, rf"\+ \S*facies run smile-open --face artisynth:{self.folder} --out out/quickstart --force")

    def face(self):
        (self.folder / "face").mkdir()
        return str(self.folder)

    def test_a_reference_face_that_is_not_one_is_refused(self):
        status, output = run("./quickstart", "--print", FACIES_REFERENCE_FACE=str(self.folder))
        self.assertEqual(status, 1, output)
        self.assertIn("there is no folder face in it", output)

    def test_another_system_is_told_everything_that_is_missing(self):
        status, output = run("./quickstart", **self.other_system())
        self.assertEqual(status, 1, output)
        self.assertIn("This is Other Linux 7", output)
        for name in ("g++", "cmake", "libpetsc-real-dev", "libcairo2-dev"):
            self.assertRegex(output, rf"(?m)^  {re.escape(name)} ")
        self.assertNotIn("libgtest-dev", output)

    def test_another_system_that_has_a_tool_is_not_told_to_install_it(self):
        status, output = run("./quickstart", **self.other_system(with_tools=("cmake", "g++")))
        self.assertEqual(status, 1, output)
        self.assertNotRegex(output, r"(?m)^  (cmake|g\+\+) ")
        self.assertRegex(output, r"(?m)^  ninja-build ")

    def test_test_passes_its_options_to_ctest(self):
        status, output = run("./test", "fast", "--print", "-R", "mesh")
        self.assertEqual(status, 0, output)
        self.assertRegex(output, r"\+ ctest .*--label-regex \^fast\$ -R mesh")

    def test_an_unknown_mode_is_refused(self):
        for command in (("./test", "quick"), ("./quickstart", "--fast")):
            status, output = run(*command)
            self.assertEqual(status, 2, output)
            self.assertIn("usage:", output)

    def test_every_package_says_what_it_is_for(self):
        sections = []
        for line in (ROOT / "tools/packages.txt").read_text(encoding="utf-8").splitlines():
            if line.startswith("["):
                sections.append(line)
            elif line and not line.startswith("#"):
                self.assertRegex(line, r"^\S+ +(-|(command|pkg|header|python):\S+) +# \S")
        self.assertEqual(sections, ["[build]", "[test]", "[developer]"])


if __name__ == "__main__":
    unittest.main()
