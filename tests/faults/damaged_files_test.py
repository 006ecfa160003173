#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Hardball authors
# SPDX-License-Identifier: MIT
"""Files that are missing, cut off or changed: one clear line and exit code 2, or a run that is as it should be."""

import random
import resource
import shutil
import unittest

import faults
from faults import DONE, FAILED, FaultTest, limited, run

# What a mutated input may claim before it is refused.
MEMORY = 1 << 30


def mutations(original, count, seed):
    """As many changed copies of the bytes, the same in every run."""
    source = random.Random(seed)
    words = original.split()
    digits = [at for at, byte in enumerate(original) if chr(byte).isdigit()]
    for case in range(count):
        changed = bytearray(original)
        if case % 2:
            changed[source.choice(digits)] = source.choice(b"0123456789.-e")
            yield bytes(changed)
            continue
        at = source.randrange(len(original))
        kind = source.randrange(7)
        if kind == 0:
            changed[at] ^= 1 << source.randrange(8)
        elif kind == 1:
            del changed[at:]
        elif kind == 2:
            del changed[at:at + source.randrange(1, 20)]
        elif kind == 3:
            changed[at:at] = original[at:at + source.randrange(1, 20)]
        elif kind == 4:
            changed[at:at + 1] = bytes([source.randrange(256)])
        elif kind == 5:
            changed[at:at] = source.choice(words)
        else:
            changed[at:at] = source.choice([b"-1", b"1e308", b"nan", b"inf", b"0", b"\0", b"\n", b"[", b"=", b'"'])
        if bytes(changed) != original:
            yield bytes(changed)


class DamagedCheckpoint(FaultTest):
    scenario = faults.SCENARIO.replace("checkpoint_every = 0.02", "checkpoint_every = 1000\ncheckpoint_at = [10]")

    def setUp(self):
        self.out = self.folder / "out"
        shutil.rmtree(self.out, ignore_errors=True)
        shutil.copytree(self.folder / "whole", self.out)
        self.files = {path: path.read_bytes() for path in self.out.rglob("*") if path.is_file()}

    def assert_refused_and_untouched(self, *arguments):
        end = run(["resume", self.out, "--until", 25, "--quiet", *arguments], self.folder)
        self.assert_refused(end)
        for path, content in self.files.items():
            self.assertEqual(path.read_bytes(), content, path)

    def test_of_which_a_part_is_missing(self):
        checkpoint = self.out / "checkpoint.hbc"
        whole = checkpoint.read_bytes()
        for length in [*range(0, 200, 7), *range(200, len(whole), len(whole) // 40), len(whole) - 1]:
            with self.subTest(length):
                self.files[checkpoint] = whole[:length]
                checkpoint.write_bytes(whole[:length])
                self.assert_refused_and_untouched()

    def test_of_which_bits_have_flipped(self):
        checkpoint = self.out / "checkpoint.hbc"
        whole = checkpoint.read_bytes()
        source = random.Random(1)
        for case in range(300):
            # Half of them in the table of sections.
            at = source.randrange(200 if case % 2 else len(whole))
            with self.subTest(at=at):
                changed = bytearray(whole)
                changed[at] ^= 1 << source.randrange(8)
                self.files[checkpoint] = bytes(changed)
                checkpoint.write_bytes(changed)
                self.assert_refused_and_untouched()

    def test_that_is_no_checkpoint(self):
        for content in (b"", b"HBCHECK1", b"\0" * 5000, (self.out / "events.npy").read_bytes()):
            self.files[self.out / "checkpoint.hbc"] = content
            (self.out / "checkpoint.hbc").write_bytes(content)
            self.assert_refused_and_untouched()

    def test_beside_files_that_have_vanished_or_shrunk(self):
        for name in ("trajectory.xyz", "events.npy", "recording.hbr"):
            for keep in (None, 0, 0.3):
                with self.subTest(name, keep=keep):
                    self.setUp()
                    damaged = self.out / name
                    if keep is None:
                        damaged.unlink()
                        del self.files[damaged]
                    else:
                        self.files[damaged] = damaged.read_bytes()[:int(keep * damaged.stat().st_size)]
                        damaged.write_bytes(self.files[damaged])
                    end = run(["resume", self.out, "--from", "checkpoints/10.hbc", "--quiet"], self.folder)
                    self.assert_refused(end, name)
                    for path, content in self.files.items():
                        self.assertEqual(path.read_bytes(), content, path)

    def test_beside_files_that_nobody_needs_to_go_on(self):
        for name in ("summary.json", "report.html", "measures/quantities.csv"):
            (self.out / name).unlink()
        end = run(["resume", self.out, "--from", "checkpoints/10.hbc", "--quiet"], self.folder)
        self.assertEqual(end.code, DONE, end)
        self.assert_undisturbed(self.out)


class MutatedText(FaultTest):
    """Such a change may be a legitimate input."""

    scenario = faults.SCENARIO.replace("until = 20.0", "until = 0.5").replace(
        "[output]", '[output]\ndirectory = "whole"\nreport = false')

    def assert_clear(self, end, mutation):
        with self.subTest(mutation):
            self.assertIn(end.code, (DONE, FAILED, faults.BAD_INPUT), end)
            if end.code != DONE:
                self.assert_one_line(end)
                self.assertNotIn("invariant", end.messages)

    def check_all(self, path, original, count, seed):
        codes = []
        for changed in mutations(original, count, seed):
            path.write_bytes(changed)
            end = run(["run", "scenario.toml", "--until", 0.5, "--quiet", "--out", "out", "--overwrite"], self.folder,
                      prepare=limited(resource.RLIMIT_AS, MEMORY))
            self.assert_clear(end, changed)
            codes.append(end.code)
        self.assertGreater(codes.count(DONE), count // 20)
        self.assertGreater(codes.count(faults.BAD_INPUT), count // 20)

    def setUp(self):
        (self.folder / "scenario.toml").write_text(self.scenario)

    def test_scenario(self):
        self.check_all(self.folder / "scenario.toml", self.scenario.encode(), 250, 3)

    def test_start_file(self):
        frame = self.last_frame((self.folder / "whole" / "trajectory.xyz").read_bytes())
        (self.folder / "start.xyz").write_bytes(frame)
        scenario = self.scenario[:self.scenario.index("[[spheres]]")] + '[start]\nfile = "start.xyz"\n' + \
            self.scenario[self.scenario.index("[response]"):]
        (self.folder / "scenario.toml").write_text(scenario)
        self.check_all(self.folder / "start.xyz", frame, 250, 4)

    @staticmethod
    def last_frame(trajectory):
        lines = trajectory.splitlines(keepends=True)
        return b"".join(lines[-(int(lines[0]) + 2):])

    def test_radii(self):
        text = b"".join(b"%.3f\n" % (0.3 + 0.01 * k) for k in range(30))
        scenario = self.scenario.replace("radius = 0.5", 'radius = {distribution = "file", file = "radii.txt"}')
        (self.folder / "scenario.toml").write_text(scenario)
        self.check_all(self.folder / "radii.txt", text, 60, 5)


if __name__ == "__main__":
    unittest.main()
