"""Runs one bed through one program and reads what came out."""
from __future__ import annotations

import csv
import dataclasses
import json
import os
import pathlib
import re
import subprocess
import sys

import numpy as np

from beds import Bed, packing_fraction
from cases import HERE, Case, Physics, Tuning

COMMANDS = {"lammps": "lmp", "liggghts": "liggghts"}
# Open MPI inside a container, as root, on one machine; without them it refuses to run or looks for a network.
MPI_ENVIRONMENT = {
    "OMPI_ALLOW_RUN_AS_ROOT": "1",
    "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
    "OMPI_MCA_btl": "self,vader",
    "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
    "OMPI_MCA_hwloc_base_use_hwthreads_as_cpus": "1",
}


class Failed(Exception):
    """A program did not do what it was asked to; says what it printed last."""


@dataclasses.dataclass(frozen=True)
class Job:
    """One bed, how long, on how many cores, and where its files go."""

    case: Case
    bed: Bed
    physics: Physics
    steps: int
    warm_up: int
    cores: int
    folder: pathlib.Path


@dataclasses.dataclass(frozen=True)
class Measured:
    """One run of one program."""

    seconds: float  # in the loop over the steps
    rate: float  # particle-steps a second
    memory: int  # peak resident, all processes together [byte]
    z: float  # contacts between particles, a particle
    kinetic: float  # of translation and rotation [J]
    packing_fraction: float
    list_builds: int | None  # where the program tells


def run(program: str, job: Job, tuning: Tuning | None) -> Measured:
    """Runs a job; raises Failed."""
    job.folder.mkdir(parents=True, exist_ok=True)
    for old in job.folder.glob("memory.*"):
        old.unlink()
    measured = packstone if program.startswith("packstone") else peer
    return measured(program, job, tuning)


def launched(program: str, command: list, job: Job, prefix: list, environment: dict[str, str]) -> int:
    """Runs a command under launch.py; its output goes to output.txt. Returns the peak memory of all processes."""
    launch = [sys.executable, HERE / "launch.py", job.folder / "memory"]
    with open(job.folder / "output.txt", "w") as output:
        done = subprocess.run([*map(str, prefix + launch + command)], stdout=output, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL, env={**os.environ, **environment})  # fmt: skip
    if done.returncode != 0:
        lines = (job.folder / "output.txt").read_text().splitlines()
        told = [line for line in lines if "error" in line.lower()] or lines[-10:]
        raise Failed("\n".join([f"exit code {done.returncode}", *told]))
    return 1024 * sum(int(file.read_text()) for file in job.folder.glob("memory.*"))


# ---- packstone


def packstone(program: str, job: Job, _: Tuning | None) -> Measured:
    """Times packstone: the steps of the warm-up are in its time, it has no way to leave them out."""
    steps = job.steps + job.warm_up
    duration = steps * job.physics.time_step
    box = ", ".join(f"{length:.17g}" for length in job.bed.box)
    overrides = {
        "dynamics.precision": "mixed" if program == "packstone-mixed" else "double",
        "dynamics.time_step": f"{job.physics.time_step:.17g}",
        "dynamics.duration": f"{duration:.17g}",
        "domain.max": f"[{box}]",
        "filling.path": f'"{job.bed.data}"',
        "output.interval": f"{duration:.17g}",
        "output.history_interval": f"{duration:.17g}",
    }
    folder = job.folder / "run"
    command = [packstone_command(), "run", HERE / "scenes" / job.case.scene, "-o", folder, "--overwrite", "--quiet",
               "--threads", job.cores]  # fmt: skip
    for key, value in overrides.items():
        command += ["--set", f"{key}={value}"]
    memory = launched(program, command, job, [], {})
    record = json.loads((folder / "run.json").read_text())
    with open(folder / "history.csv") as table:
        last = list(csv.DictReader(table))[-1]
    return Measured(
        seconds=record["loop_seconds"],
        rate=record["particles"] * record["steps"] / record["loop_seconds"],
        memory=memory,
        z=float(last["coordination"]),
        kinetic=float(last["kinetic_translational"]) + float(last["kinetic_rotational"]),
        packing_fraction=float(last["packing_fraction"]),
        list_builds=record.get("list_builds"),
    )


def packstone_command() -> pathlib.Path:
    return pathlib.Path(os.environ.get("PACKSTONE", HERE.parents[2] / "build" / "packstone"))


# ---- LAMMPS and LIGGGHTS


def peer(program: str, job: Job, tuning: Tuning | None) -> Measured:
    """Times LAMMPS or LIGGGHTS by the loop time in its own log."""
    assert tuning is not None
    end = job.folder / "end.dump"
    variables = variables_of(program, job, tuning) | {"end": end}
    command = [COMMANDS[program], "-in", HERE / "decks" / f"{program}.in", "-log", "none"]
    for name, value in variables.items():
        command += ["-var", name, value]
    mpirun = ["mpirun", "-n", job.cores, "--bind-to", tuning.bind]
    memory = launched(program, command, job, mpirun, MPI_ENVIRONMENT)
    radius, height = np.loadtxt(end, skiprows=9, unpack=True, ndmin=2)
    area = job.bed.box[0] * job.bed.box[1]
    return read_output((job.folder / "output.txt").read_text(), job, memory, packing_fraction(height, radius, area))


def variables_of(program: str, job: Job, tuning: Tuning) -> dict[str, str]:
    """What the decks call ${...}; a text with spaces is one variable."""
    p = job.physics
    sizes = len(job.bed.radii)
    common = {
        "skin": f"{tuning.skin:g}",
        "grid": tuning.grid,
        "dt": f"{p.time_step:g}",
        "gravity": f"{p.gravity:g}",
        "motion": "nve/sphere" if p.friction > 0 else "nve",
        "warm_up": str(job.warm_up),
        "steps": str(job.steps),
    }
    return common | (lammps_variables if program == "lammps" else liggghts_variables)(p, job, tuning, sizes)


def lammps_variables(p: Physics, job: Job, tuning: Tuning, sizes: int) -> dict[str, str]:
    """One gamma for all pairs of particles: that of two small ones. The floor has one for each type."""
    masses = [p.mass(radius) for radius in job.bed.radii]
    return {
        "bed": str(job.bed.data),
        "sizes": str(sizes),
        "types": " ".join(str(k + 1) for k in range(sizes)),
        "law": "hooke/history" if p.friction > 0 else "hooke",
        "newton": tuning.newton,
        "bins": tuning.bins,
        "kn": f"{p.normal_stiffness:g}",
        "kt": f"{p.tangential_stiffness:g}",
        "mu": f"{p.friction:g}",
        "gamma": f"{p.gamma(min(masses) / 2):.12g}",
        "floor_gamma_1": f"{p.gamma(masses[0]):.12g}",
        "floor_gamma_2": f"{p.gamma(masses[-1]):.12g}",
    }


def liggghts_variables(p: Physics, job: Job, tuning: Tuning, sizes: int) -> dict[str, str]:
    """Every pair of types has its own gamma; the floor is the last type and has no bounds to its mass."""
    inverse_masses = [1 / p.mass(radius) for radius in job.bed.radii] + [0.0]
    sums = [a + b for a in inverse_masses for b in inverse_masses]
    pairs = len(sums)
    return {
        "bed": str(job.bed.liggghts_data),
        "types": str(sizes + 1),
        "tangential": "tangential history" if p.friction > 0 else tuning.tangential,
        "kn": " ".join(pairs * [f"{p.normal_stiffness:g}"]),
        "kt": " ".join(pairs * [f"{p.tangential_stiffness:g}"]),
        "mu": " ".join(pairs * [f"{p.friction:g}"]),
        "gamma": " ".join(f"{p.gamma(1 / s):.12g}" if s > 0 else "0" for s in sums),
        "no_gamma": " ".join(pairs * ["0"]),
    }


LOOP = re.compile(r"^Loop time of (\S+) on \d+ procs for (\d+) steps with (\d+) atoms", re.MULTILINE)
BUILDS = re.compile(r"^Neighbor list builds = (\d+)", re.MULTILINE)
STATE = re.compile(r"^STATE z (\S+) kinetic (\S+)", re.MULTILINE)


def read_output(text: str, job: Job, memory: int, fraction: float) -> Measured:
    """The second of the three loops (warm-up, timed, state) and the state after it."""
    loops = LOOP.findall(text)
    builds = BUILDS.findall(text)
    state = STATE.search(text)
    if len(loops) != 3 or state is None:
        raise Failed(f"{job.folder / 'output.txt'} does not end as it should")
    seconds, steps, atoms = float(loops[1][0]), int(loops[1][1]), int(loops[1][2])
    if steps != job.steps or atoms != job.bed.particles:
        raise Failed(f"{atoms} particles after {steps} steps, not {job.bed.particles}")
    return Measured(
        seconds=seconds,
        rate=atoms * steps / seconds,
        memory=memory,
        z=float(state[1]),
        kinetic=float(state[2]),
        packing_fraction=fraction,
        list_builds=int(builds[1]) if len(builds) > 1 else None,
    )
