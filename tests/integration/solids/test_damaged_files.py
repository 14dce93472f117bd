#!/usr/bin/python3
"""Damaged files end in an error or in a mesh: never by a signal, without an end, or with something left behind. Cut short, with bits flipped,
with numbers exchanged, by a seed; MESHER_TEST_EFFORT multiplies how many.

    test_damaged_files.py PROGRAM MODULE-FOLDER MODELS-FOLDER DEMOS-FOLDER [unittest options]
"""
import os
import random
import re
import shutil
import subprocess

from solid_case import MODELS, PROGRAM, Case, run_tests

EFFORT = float(os.environ.get("MESHER_TEST_EFFORT", "1"))
SEED = int(os.environ.get("MESHER_TEST_SEED", "1"))
FILES_OF_A_FORMAT = round(8 * EFFORT)
TIMEOUT = 5  # seconds, of the mesher
END = 60  # seconds, after which a process is taken to have none
NUMBER = re.compile(rb"-?\d+(?:\.\d*)?(?:[eE][-+]?\d+)?")


def cut(content, dice):
    return content[:dice.randrange(1, len(content))]


def flip_bits(content, dice):
    damaged = bytearray(content)
    for _ in range(dice.choice((1, 3, 10, 30))):
        damaged[dice.randrange(len(damaged))] ^= 1 << dice.randrange(8)
    return bytes(damaged)


def exchange_numbers(content, dice):
    numbers = list(NUMBER.finditer(content))
    if len(numbers) < 2:
        return flip_bits(content, dice)
    for _ in range(dice.choice((1, 2, 8))):
        a, b = sorted(dice.sample(numbers, 2), key=lambda found: found.start())
        content = b"".join((content[:a.start()], b[0], content[a.end():b.start()], a[0], content[b.end():]))
        numbers = list(NUMBER.finditer(content))
    return content


def exchange_words(content, dice):
    """Of eight bytes each, as the numbers of binary files have."""
    damaged = bytearray(content)
    for _ in range(dice.choice((1, 4))):
        a, b = (dice.randrange(len(damaged) - 8) for _ in range(2))
        damaged[a:a + 8], damaged[b:b + 8] = damaged[b:b + 8], damaged[a:a + 8]
    return bytes(damaged)


class DamagedFiles(Case):
    def try_file(self, name, content, *arguments):
        (self.folder / name).write_bytes(content)
        before = set(os.listdir(self.folder))
        run = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, capture_output=True, timeout=END, check=False)
        said = run.stderr.decode(errors="replace")
        self.assertIn(run.returncode, (0, 1), said)
        if run.returncode == 1:
            self.assertRegex(said.strip().split("\n")[-1], r"^mesher: .+\.$")
        self.assertLessEqual(set(os.listdir(self.folder)) - before, {"out.msh", "out.json"} if run.returncode == 0 else {"out.json"})
        for output in ("out.msh", "out.json"):
            (self.folder / output).unlink(missing_ok=True)
        return run.returncode

    def try_format(self, sources, suffix, kinds, arguments):
        results = []
        for number in range(FILES_OF_A_FORMAT):
            source = sources[number % len(sources)]
            dice = random.Random(f"{SEED} {source.name} {number}")
            damaged = dice.choice(kinds)(source.read_bytes(), dice)
            with self.subTest(source=source.name, number=number, seed=SEED):
                try:
                    results.append(self.try_file(f"damaged{suffix}", damaged, *arguments))
                except AssertionError:
                    if "MESHER_TEST_KEEP" in os.environ:
                        shutil.copy(self.folder / f"damaged{suffix}", f"{os.environ['MESHER_TEST_KEEP']}/{SEED}_{number}{suffix}")
                    raise
        self.assertIn(1, results)

    def try_models(self, suffix, kinds):
        sources = [MODELS / f"{name}{suffix}" for name in ("box_with_hole", "cut_ball")]
        self.try_format(sources, suffix, kinds,
                        ("mesh", f"damaged{suffix}", "-o", "out.msh", "--report", "out.json", "--size", 1.5, "--max-elements", 50000,
                         "--timeout", TIMEOUT))

    def try_meshes(self, suffix):
        source = self.folder / f"whole{suffix}"
        subprocess.run([PROGRAM, "mesh", MODELS / "box_with_hole.brep", "-o", source, "--size", "1.5"], check=True, capture_output=True)
        self.try_format([source], suffix, (cut, flip_bits, exchange_numbers), ("check", f"damaged{suffix}", "--model", MODELS / "box_with_hole.brep"))
        self.try_format([source], suffix, (cut, flip_bits, exchange_numbers),
                        ("mesh", MODELS / "box_with_hole.brep", "-o", "out.msh", "--background", f"damaged{suffix}", "--timeout", TIMEOUT))

    def test_step(self):
        self.try_models(".step", (cut, flip_bits, exchange_numbers))

    def test_iges(self):
        self.try_models(".igs", (cut, flip_bits, exchange_numbers))

    def test_brep_text(self):
        self.try_models(".brep", (cut, flip_bits, exchange_numbers))

    def test_brep_binary(self):
        self.try_models(".bin.brep", (cut, flip_bits, exchange_words))

    def test_msh(self):
        self.try_meshes(".msh")

    def test_vtu(self):
        self.try_meshes(".vtu")


if __name__ == "__main__":
    run_tests()
