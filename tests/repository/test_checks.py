#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The checks under tools/ find what they are there for: each is run on a small repository with one thing wrong."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
LICENCE = "// SPDX-License-Identifier: Apache-2.0\n"
ROOMS = """# SPDX-License-Identifier: Apache-2.0
facies_room(base      LIBRARIES fmt::fmt)
facies_room(mesh      USES base LIBRARIES ZLIB::ZLIB)
facies_room(mechanics USES mesh)
facies_room(solve     USES mechanics LIBRARIES PkgConfig::PETSC)
"""


class Repository(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)
        self.write("src/facies/CMakeLists.txt", ROOMS)
        for name in ("base/error", "mesh/mesh", "mechanics/term", "solve/petsc_matrix"):
            self.write(f"src/facies/{name}.hpp", LICENCE)

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def check(self, tool):
        """Exit status and output of a check of this repository."""
        done = subprocess.run([sys.executable, TOOLS / tool, self.root], capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr

    def assert_accepted(self, tool):
        status, output = self.check(tool)
        self.assertEqual(status, 0, output)

    def assert_refused(self, tool, *expected):
        status, output = self.check(tool)
        self.assertEqual(status, 1, output)
        for text in expected:
            self.assertIn(text, output)


class Layers(Repository):
    def include(self, source, header):
        self.write(source, LICENCE + f"#include {header}\n")

    def test_includes_along_the_arrows_pass(self):
        self.include("src/facies/solve/newton.cpp", '"facies/base/error.hpp"')
        self.include("src/facies/solve/newton.hpp", '"facies/mechanics/term.hpp"')
        self.include("src/facies/solve/matrix.cpp", "<petscmat.h>")
        self.include("src/facies/solve/petsc_vector.hpp", "<petscvec.h>")
        self.include("tests/mesh/test_mesh.cpp", '"facies/solve/newton.hpp"')
        self.assert_accepted("check_layers.py")

    def test_an_include_against_the_arrows_is_found_with_its_line(self):
        self.include("src/facies/mesh/mesh.cpp", '"facies/mechanics/term.hpp"')
        self.assert_refused("check_layers.py", "src/facies/mesh/mesh.cpp:2: mesh may not include facies/mechanics/term.hpp")

    def test_the_command_line_is_out_of_reach_of_the_rooms(self):
        self.include("apps/facies/terminal.hpp", "<string>")
        self.include("apps/facies/main.cpp", '"apps/facies/terminal.hpp"')
        self.assert_accepted("check_layers.py")
        self.include("src/facies/mesh/mesh.cpp", '"apps/facies/terminal.hpp"')
        self.assert_refused("check_layers.py", "src/facies/mesh/mesh.cpp:2: apps/facies/terminal.hpp is above every room")

    def test_petsc_outside_solve_is_found(self):
        self.include("apps/facies/main.cpp", "<petscsnes.h>")
        self.assert_refused("check_layers.py", "apps/facies/main.cpp:2: petscsnes.h belongs in src/facies/solve only")

    def test_petsc_by_way_of_a_wrapper_is_found(self):
        self.include("apps/facies/main.cpp", '"facies/solve/petsc_matrix.hpp"')
        self.include("src/facies/solve/newton.hpp", '"facies/solve/petsc_matrix.hpp"')
        self.assert_refused("check_layers.py", "apps/facies/main.cpp:2", "src/facies/solve/newton.hpp:2")

    def test_a_heavy_library_in_a_header_is_found(self):
        self.include("src/facies/mesh/read.hpp", "<nlohmann/json.hpp>")
        self.assert_refused("check_layers.py", "src/facies/mesh/read.hpp:2: nlohmann/json.hpp is heavy")

    def test_a_header_that_does_not_exist_is_found(self):
        self.include("src/facies/mesh/read.cpp", '"facies/base/errors.hpp"')
        self.assert_refused("check_layers.py", "facies/base/errors.hpp does not exist")

    def test_a_room_that_nobody_registered_is_found(self):
        self.include("src/facies/attic/box.cpp", '"facies/base/error.hpp"')
        self.assert_refused("check_layers.py", "room attic is missing from src/facies/CMakeLists.txt")

    def test_an_arrow_upwards_is_found(self):
        self.write("src/facies/CMakeLists.txt", ROOMS.replace("USES base", "USES solve"))
        self.assert_refused("check_layers.py", "mesh uses solve, which stands later or nowhere")


class Files(Repository):
    def test_a_tidy_repository_passes(self):
        self.write("README.md", "[tour](docs/tour.md#rooms) [web](https://example.org) `[not](a-link)`\n")
        self.write("docs/tour.md", "```\n[no](link)\n```\n[back](../README.md)\n")
        self.assert_accepted("check_files.py")

    def test_a_source_without_licence_is_found(self):
        self.write("src/facies/mesh/mesh.cpp", "int x;\n")
        self.assert_refused("check_files.py", "src/facies/mesh/mesh.cpp:1: no line 'SPDX")

    def test_a_script_without_licence_is_found(self):
        self.write("run", "#!/usr/bin/env bash\n")
        self.assert_refused("check_files.py", "run:1: no line 'SPDX")

    def test_a_file_of_501_lines_is_found(self):
        self.write("src/facies/mesh/mesh.cpp", LICENCE + "\n" * 499)
        self.assert_accepted("check_files.py")
        self.write("src/facies/mesh/mesh.cpp", LICENCE + "\n" * 500)
        self.assert_refused("check_files.py", "src/facies/mesh/mesh.cpp:501: 501 lines")

    def test_a_dead_link_is_found(self):
        self.write("docs/tour.md", "one\n[gone](gone.md)\n")
        self.assert_refused("check_files.py", "docs/tour.md:2: link to gone.md")

    def test_a_folder_of_a_machine_is_found(self):
        self.write("docs/tour.md", "see /" + "home/someone/face\n")
        self.assert_refused("check_files.py", "docs/tour.md:1: names a folder of a machine")

    def test_build_folders_are_left_alone(self):
        self.write("build/release/x.cpp", "int x;\n")
        self.assert_accepted("check_files.py")


class CountedTests(Repository):
    def count(self, *tests):
        self.write("tests.xml", "<testsuite>" + "".join(tests) + "</testsuite>")
        done = subprocess.run(
            [sys.executable, TOOLS / "count_tests.py", self.root / "tests.xml"], capture_output=True, text=True, check=False
        )
        return done.stdout.strip(), done.returncode

    @staticmethod
    def ran(status, output="", inner=""):
        return f'<testcase status="{status}">{inner}<system-out>{output}</system-out></testcase>'

    def test_cases_of_a_googletest_program_count_one_by_one(self):
        output = "[       OK ] A.B (0 ms)\n[  SKIPPED ] A.C (1 ms)\n[  PASSED  ] 1 test.\n[  SKIPPED ] A.C\n"
        self.assertEqual(self.count(self.ran("run", output), self.ran("run")), ("2 passed, 0 failed, 1 skipped", 0))

    def test_a_crash_counts_as_failed(self):
        crash = self.ran("fail", "[       OK ] A.B (0 ms)\n[ RUN      ] A.C\n")
        self.assertEqual(self.count(crash), ("1 passed, 1 failed, 0 skipped", 1))

    def test_a_program_that_cannot_be_started_counts_as_failed(self):
        absent = self.ran("notrun", inner='<skipped message="Unable to find executable"/>')
        self.assertEqual(self.count(self.ran("run"), absent), ("1 passed, 1 failed, 0 skipped", 1))

    def test_nothing_run_is_a_failure(self):
        skipped = self.ran("notrun", inner='<skipped message="SKIP_RETURN_CODE=77"/>')
        self.assertEqual(self.count(skipped), ("0 passed, 0 failed, 1 skipped", 1))


if __name__ == "__main__":
    unittest.main()
