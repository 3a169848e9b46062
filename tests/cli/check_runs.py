# SPDX-License-Identifier: Apache-2.0
"""Runs the program as a user would, on the patch, and looks at the folders it leaves: whole, repeatable, readable after
a stop, a kill or a full disk.

usage: check_runs.py FACIES
"""

import hashlib
import json
import os
import pathlib
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree
import zlib

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
SLOW_FACE = "patch:ny=48,nz=48"


def facies(*arguments, **options):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, timeout=300, **options)


def without_timings(path):
    if path.name != "summary.json":
        return path.read_bytes()
    summary = json.loads(path.read_text())
    del summary["timings"]
    return summary


def files_of(folder):
    return {path.relative_to(folder): without_timings(path) for path in sorted(folder.rglob("*")) if path.is_file()}


def frames_of(png):
    """The pixels of every frame of an animated PNG file and how long each is shown [ms]; independent of the writer."""
    assert png.startswith(b"\x89PNG\r\n\x1a\n")
    place, number, frames = 8, 0, []
    while place < len(png):
        (length,) = struct.unpack_from(">I", png, place)
        kind, data = png[place + 4:place + 8], png[place + 8:place + 8 + length]
        assert struct.unpack_from(">I", png, place + 8 + length) == (zlib.crc32(kind + data),)
        place += length + 12
        if kind == b"acTL":
            n_frames, _ = struct.unpack(">II", data)
        if kind in (b"fcTL", b"fdAT"):
            assert struct.unpack_from(">I", data) == (number,)
            number += 1
        if kind == b"fcTL":
            numerator, denominator = struct.unpack_from(">HH", data, 20)
            frames.append([b"", 1000 * numerator // denominator])
        if kind in (b"IDAT", b"fdAT"):
            frames[-1][0] += data[4:] if kind == b"fdAT" else data
    assert kind == b"IEND" and n_frames == len(frames)
    return [(zlib.decompress(data), shown) for data, shown in frames]


class Runs(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="facies-runs-"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def assert_readable(self, out):
        """Every file is whole: JSON and XML parse, the series names files that are there, nothing is half-written."""
        json.loads((out / "summary.json").read_text())
        for line in (out / "log.jsonl").read_text().splitlines():
            json.loads(line)
        series = out / "fields.pvd"
        if series.exists():
            for entry in xml.etree.ElementTree.parse(series).iter("DataSet"):
                self.assertTrue((out / entry.get("file")).is_file())

    def test_a_run_leaves_everything_that_the_documentation_names(self):
        out = self.folder / "out"
        done = facies("run", "patch-stretch", "--out", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        names = {str(path) for path in files_of(out)}
        expected = {"scenario.yaml", "summary.json", "landmarks.csv", "distances.csv", "fields.pvd", "log.jsonl",
                    "convergence.txt", "fields/01-tension.vtu", "fields/02-release.vtu", "fields/03-express.vtu",
                    "figures/rest.png", "figures/tensioned-rest.png", "figures/expression.png",
                    "figures/displacement.png", "figures/01-tension-section.png", "figures/03-express-section.png"}
        self.assertLessEqual(expected, names)
        summary = json.loads((out / "summary.json").read_text())
        self.assertEqual(summary["status"], "done")
        ((scenario, checksum),) = summary["inputs"].items()
        self.assertEqual(checksum, "sha256:" + hashlib.sha256(pathlib.Path(scenario).read_bytes()).hexdigest())
        self.assert_readable(out)

    def test_frames_become_an_animation_and_field_files(self):
        out = self.folder / "out"
        done = facies("run", "patch-stretch", "--out", out, "--set", "output.frames=3")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_readable(out)
        times = [float(entry.get("timestep")) for entry in
                 xml.etree.ElementTree.parse(out / "fields.pvd").iter("DataSet")]
        self.assertEqual([round(time, 9) for time in times], [1, 2, round(2 + 1 / 3, 9), round(2 + 2 / 3, 9), 3])
        self.assertTrue((out / "fields" / "03-express-002.vtu").is_file())
        frames = frames_of((out / "figures" / "03-express-animation.png").read_bytes())
        self.assertEqual([shown for _, shown in frames], [1000, 500, 500, 1000])
        self.assertEqual(len({pixels for pixels, _ in frames}), 4)
        self.assertEqual(len({len(pixels) for pixels, _ in frames}), 1)

    def test_frames_that_make_no_sense_are_refused(self):
        for frames, expected in (("-1", "0"), ("100000", "240"), ("1.5", "whole number")):
            done = facies("run", "patch-stretch", "--out", self.folder / "out", "--set", f"output.frames={frames}")
            self.assertNotEqual(done.returncode, 0)
            self.assertIn("output.frames", done.stderr)
            self.assertIn(expected, done.stderr)
            self.assertFalse((self.folder / "out").exists())

    def test_motions_give_the_same_bytes_for_any_number_of_threads(self):
        for name, threads in (("one", 1), ("three", 3)):
            done = facies("run", "patch-twitch", "--face", "patch:width=30,height=30,ny=4,nz=4", "--no-pictures",
                          "--out", self.folder / name, "--threads", threads)
            self.assertEqual(done.returncode, 0, done.stderr)
        one, three = (files_of(self.folder / name) for name in ("one", "three"))
        self.assertLessEqual({"motion.csv", "energy.csv", "motion.pvd"}, {str(path) for path in one})
        for path in (pathlib.Path("scenario.yaml"), pathlib.Path("summary.json")):  # they say how many threads
            del one[path], three[path]
        self.assertEqual(one, three)
        self.assert_readable(self.folder / "one")

    def test_two_runs_give_the_same_bytes_for_any_number_of_threads(self):
        for name, threads in (("one", 1), ("two", 2), ("three", 3)):
            done = facies("run", "patch-stretch", "--out", self.folder / name, "--threads", threads)
            self.assertEqual(done.returncode, 0, done.stderr)
        one, two, three = (files_of(self.folder / name) for name in ("one", "two", "three"))
        for path in (pathlib.Path("scenario.yaml"), pathlib.Path("summary.json")):  # they say how many threads
            for files in (one, two, three):
                files.pop(path)
        self.assertEqual(one, two)
        self.assertEqual(one, three)

    def test_repeating_a_run_gives_the_same_bytes(self):
        for name in ("a", "b"):
            self.assertEqual(facies("run", "patch-stretch", "--out", self.folder / name).returncode, 0)
        self.assertEqual(files_of(self.folder / "a"), files_of(self.folder / "b"))

    def start_slow_run(self, out):
        process = subprocess.Popen([PROGRAM, "run", "patch-stretch", "--face", SLOW_FACE, "--out", out],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 120
        log = out / "log.jsonl"
        while not (log.exists() and log.read_text().count("\n") >= 2):
            self.assertLess(time.monotonic(), deadline, "the run did not begin")
            self.assertIsNone(process.poll(), "the run ended before it could be stopped")
            time.sleep(0.02)
        return process

    def test_ctrl_c_ends_with_130_and_a_readable_folder(self):
        out = self.folder / "out"
        process = self.start_slow_run(out)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=120)
        self.assertEqual(process.returncode, 130)
        self.assertEqual(json.loads((out / "summary.json").read_text())["status"], "interrupted")
        self.assert_readable(out)

    def test_a_killed_run_leaves_a_readable_folder_that_can_be_replaced(self):
        out = self.folder / "out"
        process = self.start_slow_run(out)
        process.kill()
        process.communicate(timeout=60)
        self.assertEqual(json.loads((out / "summary.json").read_text())["status"], "running")
        self.assert_readable(out)
        again = facies("run", "patch-stretch", "--out", out, "--force", "--no-pictures")
        self.assertEqual(again.returncode, 0, again.stderr)

    def test_a_run_that_diverges_ends_with_5_and_says_where(self):
        out = self.folder / "out"
        done = facies("run", "patch-stretch", "--out", out, "--no-pictures", "--set", "solver.max_iterations=2",
                      "--set", "solver.smallest_increment=0.5")
        self.assertEqual(done.returncode, 5, done.stderr)
        for word in ("tension", "did not converge", "element", "increment"):
            self.assertIn(word, done.stderr)
        summary = json.loads((out / "summary.json").read_text())
        self.assertEqual(summary["status"], "not_converged")
        self.assert_readable(out)

    def test_an_existing_folder_is_not_overwritten(self):
        out = self.folder / "out"
        out.mkdir()
        (out / "mine.txt").write_text("precious")
        for options in ([], ["--force"]):
            done = facies("run", "patch-stretch", "--out", out, *options)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual((out / "mine.txt").read_text(), "precious")
            self.assertEqual(len(list(out.iterdir())), 1)

    def test_a_full_disk_is_told_and_nothing_is_half_written(self):
        disk = self.folder / "disk"
        disk.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=128k", "tmpfs", disk], capture_output=True)
        if mounted.returncode != 0:
            self.skipTest("needs the right to mount a small file system")
        try:
            done = facies("run", "patch-stretch", "--out", disk / "out")
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("No space left", done.stderr)
            self.assertFalse(list(disk.rglob("*.part")))
            self.assert_readable(disk / "out")
        finally:
            subprocess.run(["umount", disk], check=True)


if __name__ == "__main__":
    os.environ.pop("FACIES_DATA", None)
    unittest.main(argv=sys.argv[:1], verbosity=2)
