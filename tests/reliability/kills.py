#!/usr/bin/python3
"""kills.py PACKSTONE [--rounds 200] [--seed 1]: kills runs with SIGKILL at random moments and goes on with them.

After each kill every snapshot that has its name is opened and read with h5py, must be the same bytes as that of a run
never stopped, and all that were there before the kill must still be there. A run is gone on with until it has been
killed up to four times, and must then end with the bytes of the run never stopped; nothing under a temporary name may
stay. For people: it takes some minutes."""

import argparse
import os
import random
import shutil
import sys
import tempfile

import runs

SCENE = """
title = "Killed"
seed = 3
[dynamics]
time_step = "20 us"
duration = "0.5 s"
[domain]
min = [0, 0, 0]
max = [0.2, 0.2, 0.5]
periodic = ["x", "y"]
open = ["z+"]
[gravity]
acceleration = [0, 0, -9.8]
[contact]
normal = "linear"
tangential = "cundall-strack"
[[material]]
name = "m"
density = 2500
normal_stiffness = 1e5
tangential_stiffness = 8e4
restitution = 0.5
friction = 0.4
[[particles]]
material = "m"
count = 600
radius = 0.01
[filling]
kind = "pour"
rate = 2000
region_min = [0, 0, 0.3]
region_max = [0.2, 0.2, 0.5]
velocity = [0, 0, -1]
[[boundary]]
name = "floor"
kind = "plane"
point = [0, 0, 0]
normal = [0, 0, 1]
[output]
interval = "10 ms"
history_interval = "1 ms"
fields = ["velocity", "force"]
checkpoint_interval = "0.2 s"
[monitor]
overlap_limit = 0.3
"""


def check_after_kill(folder, whole, before):
    """Every snapshot is whole; returns their names."""
    names = runs.files_of(os.path.join(folder, "snapshots"), ".vtkhdf")
    names = [name for name in names if not name.startswith(".")]
    assert set(before) <= set(names), f"{folder}: lost {set(before) - set(names)}"
    for name in names:
        path = os.path.join(folder, "snapshots", name)
        runs.check_opens(path)
        assert runs.content(path) == runs.content(os.path.join(whole, "snapshots", name)), f"{path} differs"
    return names


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("packstone")
    parser.add_argument("--rounds", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    program, chance = arguments.packstone, random.Random(arguments.seed)
    with tempfile.TemporaryDirectory() as place:
        scene, whole, folder = (os.path.join(place, name) for name in ("scene.toml", "whole", "killed"))
        with open(scene, "w", encoding="utf-8") as file:
            file.write(SCENE)
        seconds = runs.timed([program, "run", scene, "-o", whole, "--quiet", "--threads", "1"])
        print(f"a whole run takes {seconds:.2f} s", flush=True)
        kills = ended = seen = with_checkpoint = partial = 0
        while kills < arguments.rounds:
            shutil.rmtree(folder, ignore_errors=True)
            before = []
            for _ in range(4):
                threads = str(chance.choice((1, 2)))
                command = [program, "run", scene, "-o", folder, "--quiet", "--resume", "--threads", threads]
                code = runs.run_for(command, chance.uniform(0, 0.8 * seconds), runs.KILL)
                if code == 0:
                    break
                kills += 1
                before = check_after_kill(folder, whole, before) if os.path.isdir(folder) else []
                seen += len(before)
                partial += len(runs.leftovers(folder))
                with_checkpoint += os.path.isdir(os.path.join(folder, "checkpoint"))
                if before:
                    assert runs.info(program, folder)["status"] == "killed", f"{folder}: info does not tell"
            runs.run_for([program, "run", scene, "-o", folder, "--quiet", "--resume"], 1000, runs.KILL)
            runs.check_same(program, whole, folder)
            assert not runs.leftovers(folder), runs.leftovers(folder)
            ended += 1
            print(f"{kills} kills, {ended} runs ended the same", flush=True)
        print(f"{kills} kills ({with_checkpoint} with checkpoints there): {seen} snapshots looked at, none lost or "
              f"unreadable; {partial} files under temporary names left and removed; {ended} runs ended byte for byte "
              "as one never stopped")


if __name__ == "__main__":
    sys.exit(main())
