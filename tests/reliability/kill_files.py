#!/usr/bin/env python3
"""Kills packstone's verbs at random moments and looks at what is left.

    tests/reliability/kill_files.py build/packstone [--rounds 200] [--seed 1] [--verbs run,analyze,convert,render]

Each round starts a verb that replaces the files of an earlier call, kills it with SIGKILL after a random part of the
time it takes, and checks that every file under its own name is whole: that of the earlier call or the new one, byte
for byte; of a run, that every snapshot opens and history has whole rows. A last call to each verb, which nobody
kills, must then leave no temporary file.
"""
import argparse
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

import h5py

SCENE = """
title = "Killed"
seed = 3
[dynamics]
time_step = "5 us"
duration = "20 ms"
[domain]
min = [0, 0, 0]
max = [0.2, 0.2, 0.4]
periodic = ["x", "y", "z"]
[contact]
normal = "hysteretic"
[[material]]
name = "glass"
density = 2500
normal_stiffness = 1e6
normal_damping = 0.7
[[particles]]
material = "glass"
count = 2000
radius = "5 mm"
[filling]
kind = "growth"
duration = "10 ms"
[output]
interval = "1 ms"
history_interval = "0.2 ms"
fields = ["velocity"]
"""


def contents(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def is_temporary(name):
    return ".partial" in pathlib.PurePath(name).name


class Verb:
    """A verb, the folder it writes into, and what it leaves there when nobody kills it."""

    def __init__(self, name, call, folder):
        self.name, self.call, self.folder = name, call, folder
        folder.mkdir()
        began = time.monotonic()
        self.finish()
        self.seconds = time.monotonic() - began
        self.whole = contents(folder)
        self.killed = 0

    def finish(self):
        done = subprocess.run(self.call, capture_output=True, text=True)
        assert done.returncode == 0, f"{self.call}: {done.stdout}{done.stderr}"

    def kill_after(self, seconds):
        process = subprocess.Popen(self.call, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            process.wait(seconds)
        except subprocess.TimeoutExpired:
            process.send_signal(signal.SIGKILL)
            process.wait()
            self.killed += 1

    def check(self):
        for name, data in contents(self.folder).items():
            if not is_temporary(name):
                assert data == self.whole[name], f"{self.name} left {name} neither as it was nor whole"

    def check_end(self):
        self.finish()
        left = set(contents(self.folder))
        assert left == set(self.whole), f"{self.name} leaves {left ^ set(self.whole)}"


class Run(Verb):
    """A run replaces the earlier one at its beginning; what it has written then is checked for itself."""

    def check(self):
        for path in self.folder.rglob("snapshot_*.vtkhdf"):
            with h5py.File(path) as file:
                assert len(file["VTKHDF/Points"]) == 2000, path
            assert path.read_bytes() == self.whole[str(path.relative_to(self.folder))], path
        for path in self.folder.rglob("history.csv"):
            rows = path.read_text().split("\n")
            assert all(row.count(",") == rows[0].count(",") for row in rows[:-1]), path

    def check_end(self):
        self.finish()
        left, whole = contents(self.folder), self.whole
        assert set(left) == set(whole), f"run leaves {set(left) ^ set(whole)}"
        for name in whole:
            assert left[name] == whole[name] or name.endswith("run.json"), f"{name} is another one"


def verbs_of(program, scene, run, folder, wanted):
    packing = run / "snapshots" / "snapshot_000010.vtkhdf"
    small = ["--size", "640x480", "--supersampling", "1", "--quiet"]
    calls = {
        "run": lambda out: ["run", scene, "--quiet", "--threads", "1", "--overwrite", "-o", out / "run"],
        "analyze": lambda out: ["analyze", run, "--quiet", "--only", "packing,structure", "--json", out / "a.json",
                                "--csv", out / "tables", "--particles", out / "a.vtu"],
        "convert": lambda out: ["convert", run, "--quiet", "--overwrite", out / "a.dump"],
        "convert-snapshot": lambda out: ["convert", packing, "--quiet", "--overwrite", out / "a.vtkhdf"],
        "render": lambda out: ["render", run, *small, "--workers", "2", "-o", out / "frames"],
        "render-film": lambda out: ["render", run, *small, "-o", out / "a.mp4"],
    }
    for name, call in calls.items():
        if name.split("-")[0] in wanted:
            out = folder / name
            words = [str(word) for word in [program, *call(out)]]
            yield (Run if name == "run" else Verb)(name, words, out)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--verbs", default="run,analyze,convert,render")
    arguments = parser.parse_args()
    chance, program = random.Random(arguments.seed), arguments.program.resolve()
    with tempfile.TemporaryDirectory(prefix="packstone-kills-") as name:
        folder = pathlib.Path(name)
        scene, run = folder / "scene.toml", folder / "earlier"
        scene.write_text(SCENE)
        subprocess.run([program, "run", scene, "--quiet", "--threads", "1", "-o", run], check=True)
        verbs = list(verbs_of(program, scene, run, folder, arguments.verbs.split(",")))
        for number in range(arguments.rounds):
            verb = verbs[number % len(verbs)]
            verb.kill_after(chance.random() * verb.seconds)
            verb.check()
        for verb in verbs:
            verb.check_end()
            print(f"{verb.name}: killed {verb.killed} times in {verb.seconds:.2f} s each, every file whole")


if __name__ == "__main__":
    sys.exit(main())
