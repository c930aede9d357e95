#!/usr/bin/python3
"""The same beds through packstone, LAMMPS and LIGGGHTS, side by side. See ../README.md."""
from __future__ import annotations

import argparse
import dataclasses
import pathlib
import platform
import subprocess
import sys

import tables
from beds import bed_of, forget
from cases import CASES, HERE, PROGRAMS, TUNED, Physics, Tuning
from programs import Failed, Job, Measured, packstone_command, run
from tuning import source, tuned

REPOSITORY = HERE.parents[2]
TUNING_SHARE = 3  # a tuning run takes this part of the steps


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--cases", nargs="+", choices=CASES, default=list(CASES), help="which beds")
    parser.add_argument("--programs", nargs="+", choices=PROGRAMS, default=list(PROGRAMS), help="which programs")
    parser.add_argument("--cores", nargs="+", type=int, default=[2], help="processes, or threads of packstone")
    parser.add_argument("--rounds", type=int, default=5, help="rounds; in each, every program runs once")
    parser.add_argument("--steps", type=int, help="timed steps instead of each case's own")
    parser.add_argument("--time-step", type=float, help="[s] instead of each case's own")
    parser.add_argument("--warm-up", type=int, default=300, help="steps before those that are timed")
    parser.add_argument("--scale", type=float, default=1.0, help="size of the beds, 1 for a whole one")
    parser.add_argument("--tune", action="store_true", help="look for each program's best settings first")
    parser.add_argument("--remake-beds", action="store_true", help="settle the beds anew")
    parser.add_argument("--folder", type=pathlib.Path, default=REPOSITORY / "build" / "bench", help="for all files")
    return parser.parse_args()


def machine() -> dict[str, str]:
    """What the numbers belong to."""
    cpu = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), "")
    versions = subprocess.run(["dpkg-query", "-W", "lammps", "liggghts"], capture_output=True, text=True).stdout
    revision = subprocess.run(["git", "-C", REPOSITORY, "describe", "--always", "--dirty"], capture_output=True,
                              text=True).stdout.strip()  # fmt: skip
    return {"processor": cpu, "system": platform.platform(), "packstone": revision,
            **dict(line.split("\t") for line in versions.splitlines())}  # fmt: skip


def in_rounds(job: Job, tunings: dict[str, Tuning | None], rounds: int) -> tuple[dict[str, list[Measured]], list[str]]:
    """Every program once a round, each round beginning with the next one, so that a slow minute meets all of them.

    A program that fails is left out from then on. Returns the runs of those that did not, and a note for each failure.
    """
    runs: dict[str, list[Measured]] = {program: [] for program in tunings}
    notes = []
    for number in range(rounds):
        programs = list(runs)
        shift = number % max(1, len(programs))
        for program in programs[shift:] + programs[:shift]:
            begin = f"  {job.case.name}, {job.cores} cores, round {number + 1}: {program:9}"
            try:
                runs[program].append(run(program, job, tunings[program]))
                print(f"{begin} {1e-6 * runs[program][-1].rate:8.2f} million particle-steps a second", flush=True)
            except Failed as failure:
                del runs[program]
                print(f"{begin} failed, {failure}", flush=True)
                notes.append(f"**{program} FAILED in {job.case.name} on {job.cores} cores**: {failure}")
    return runs, notes


def main() -> int:
    args = arguments()
    folder = args.folder.resolve()
    if args.remake_beds:
        forget(folder / "beds")
    rows: list[tables.Row] = []
    failures: list[str] = []
    for name in args.cases:
        case = CASES[name]
        bed = bed_of(case, packstone_command(), folder / "beds", max(args.cores), args.scale)
        physics = Physics.of(case.scene)
        if args.time_step is not None:
            physics = dataclasses.replace(physics, time_step=args.time_step)
        steps = args.steps or case.steps
        for cores in args.cores:
            job = Job(case, bed, physics, steps, args.warm_up, cores, folder / "work")
            tunings: dict[str, Tuning | None] = {p: TUNED.get((name, p)) for p in args.programs}
            for program, start in tunings.items():
                if args.tune and start is not None:
                    print(f"tuning {program} for {name} on {cores} cores", flush=True)
                    short = dataclasses.replace(job, steps=max(1, steps // TUNING_SHARE))
                    tunings[program] = tuned(program, short, start)
            runs, failed = in_rounds(job, tunings, args.rounds)
            failures += failed
            settings = {p: source(t) if t else "" for p, t in tunings.items()}
            rows += tables.rows_of(job, runs, settings)
    notes = failures + tables.disagreements(rows)
    tables.write(rows, notes, machine(), folder)
    print(f"\n{tables.markdown(rows)}\n")
    for note in notes:
        print(f"{note}\n")
    print(f"also in {folder}/results.md, .csv and .json")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
