#!/usr/bin/python3
"""Time to a bed at rest: goal = "rest" beside packstone's own Newtonian motion and LAMMPS, one after the other. See ../README.md."""
from __future__ import annotations

import argparse
import csv
import dataclasses
import datetime
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
import tomllib

PEERS = pathlib.Path(__file__).parents[1] / "peers"
sys.path.insert(0, str(PEERS))

import numpy as np  # noqa: E402
from beds import Bed, packing_fraction, write_bed  # noqa: E402
from bench import machine  # noqa: E402
from cases import TUNED, Physics  # noqa: E402
from programs import MPI_ENVIRONMENT, packstone_command  # noqa: E402

REPOSITORY = PEERS.parents[2]
SCENE = REPOSITORY / "samples" / "13_quick_rest" / "scene.toml"
LAMMPS_STEP = 10e-6  # [s]; the largest sound one (docs/rest.md)
MOST_TIME = 10.0  # [s] of motion, which nothing needs
LOOK = 1000  # steps of LAMMPS between two looks at its kinetic energy


@dataclasses.dataclass(frozen=True)
class Rest:
    """What counts as rest in this scene."""

    physics: Physics
    fall_time: float  # [s] before which a low kinetic energy is that of the beginning
    energy: float  # [J]


@dataclasses.dataclass(frozen=True)
class Ended:
    """One way's end."""

    way: str
    seconds: float  # wall time: packstone's whole, LAMMPS' loop
    at_rest: bool
    physical_time: float  # [s]
    kinetic_share: float  # of the sum of m g d
    fraction: float  # packing fraction of the bulk
    contacts: float  # between particles, a particle
    told: str  # what packstone says of the end


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--particles", nargs="+", type=int, default=[20000, 100000], help="sizes of the bed")
    parser.add_argument("--cores", type=int, default=2, help="threads of packstone, processes of LAMMPS")
    parser.add_argument("--energy", type=float, default=5e-5, help="kinetic energy at rest, of the sum of m g d")
    parser.add_argument("--own-limit", type=float, default=8, help="times the quick way, after which motion is stopped")
    parser.add_argument("--lammps-limit", type=float, default=22, help="the same of LAMMPS")
    parser.add_argument("--folder", type=pathlib.Path, default=REPOSITORY / "build" / "bench" / "rest")
    return parser.parse_args()


def rest_of(particles: int, share: float) -> tuple[Rest, float]:
    """Rest in the scene, and the sum of m g d [J]."""
    scene = tomllib.loads(SCENE.read_text())
    (material,) = scene["material"]
    radius = 1e-3 * float(scene["particles"][0]["radius"].removesuffix(" mm"))
    physics = Physics(LAMMPS_STEP, -scene["gravity"]["acceleration"][2], material["density"],
                      material["normal_stiffness"], material["normal_stiffness"], material["restitution"], 0.0)  # fmt: skip
    height = scene["domain"]["aspect"][2] * (4 / 3 * np.pi * radius**3 * particles * scene["domain"]["volume_factor"]
                                             / np.prod(scene["domain"]["aspect"])) ** (1 / 3)  # fmt: skip
    unit = particles * physics.mass(radius) * physics.gravity * 2 * radius
    return Rest(physics, float(np.sqrt(2 * height / physics.gravity)), share * unit), unit


def packstone(goal: str, particles: int, cores: int, folder: pathlib.Path, *more: str) -> list:
    return [packstone_command(), "run", SCENE, "-o", folder, "--overwrite", "--quiet", "--threads", str(cores),
            "--set", f"particles[0].count={particles}", "--set", f'dynamics.goal="{goal}"', *more]  # fmt: skip


def rows_of(run: pathlib.Path) -> list[dict[str, str]]:
    """Of history.csv, but for a last line still to be finished."""
    try:
        text = (run / "history.csv").read_text()
    except FileNotFoundError:
        return []
    return list(csv.DictReader(text[: text.rfind("\n") + 1].splitlines()))


def ended(way: str, run: pathlib.Path, seconds: float, at_rest: bool, unit: float) -> Ended:
    last = rows_of(run)[-1]
    return Ended(way, seconds, at_rest, float(last["time"]), float(last["kinetic_translational"]) / unit,
                 float(last["packing_fraction"]), float(last["coordination"]),
                 json.loads((run / "run.json").read_text()).get("ending", ""))  # fmt: skip


def quick(particles: int, cores: int, run: pathlib.Path, unit: float) -> Ended:
    begin = time.monotonic()
    subprocess.run(packstone("rest", particles, cores, run), check=True)
    return ended('packstone, `goal = "rest"`', run, time.monotonic() - begin, True, unit)


def motion(particles: int, cores: int, run: pathlib.Path, rest: Rest, unit: float, limit: float) -> Ended:
    """Stopped as soon as a row of its history is at rest, or time is up."""
    begin = time.monotonic()
    process = subprocess.Popen(packstone("motion", particles, cores, run, "--set", f"dynamics.duration={MOST_TIME}",
                                         "--set", "output.interval=1"), stderr=subprocess.DEVNULL)  # fmt: skip
    at_rest = False
    while process.poll() is None and not at_rest and time.monotonic() - begin < limit:
        time.sleep(0.5)
        for row in rows_of(run)[-1:]:
            at_rest = float(row["time"]) > rest.fall_time and float(row["kinetic_translational"]) < rest.energy
    seconds = time.monotonic() - begin
    process.send_signal(signal.SIGINT)
    process.wait()
    return ended("packstone, Newtonian motion", run, seconds, at_rest, unit)


def lammps(bed: Bed, cores: int, folder: pathlib.Path, rest: Rest, unit: float, limit: float) -> Ended:
    physics, tuning = rest.physics, TUNED["S1", "lammps"]
    mass = physics.mass(bed.radii[0])
    variables = {
        "bed": bed.data, "newton": tuning.newton, "skin": tuning.skin, "grid": tuning.grid, "look": LOOK,
        "dt": physics.time_step, "kn": physics.normal_stiffness, "kt": physics.tangential_stiffness,
        "gamma": physics.gamma(mass / 2), "floor_gamma": physics.gamma(mass), "gravity": physics.gravity,
        "rest_energy": rest.energy, "fall_steps": round(rest.fall_time / physics.time_step),
        "steps": round(MOST_TIME / physics.time_step), "timeout": datetime.timedelta(seconds=round(limit)),
        "end": folder / "end.dump",
    }  # fmt: skip
    command = ["mpirun", "-n", cores, "--bind-to", tuning.bind, "lmp", "-in", pathlib.Path(__file__).parent / "lammps.in",
               "-log", folder / "log.lammps", "-screen", "none"]  # fmt: skip
    for name, value in variables.items():
        command += ["-var", name, value]
    subprocess.run([str(word) for word in command], check=True, env={**os.environ, **MPI_ENVIRONMENT})
    log = (folder / "log.lammps").read_text()
    seconds = float(re.findall(r"^Loop time of (\S+)", log, re.MULTILINE)[0])
    step, contacts, kinetic = re.findall(r"^STATE step (\S+) z (\S+) kinetic (\S+)", log, re.MULTILINE)[0]
    radius, height = np.loadtxt(folder / "end.dump", skiprows=9, unpack=True, ndmin=2)
    return Ended("LAMMPS, Newtonian motion", seconds, float(kinetic) < rest.energy, float(step) * physics.time_step,
                 float(kinetic) / unit, packing_fraction(height, radius, bed.box[0] * bed.box[1]), float(contacts), "")  # fmt: skip


def table(particles: int, ways: list[Ended]) -> str:
    lines = [f"{particles} spheres", "",
             "| way | seconds | times the quick one | at rest | physical time | KE / sum of m g d | fraction | contacts a particle |",
             "|---|---|---|---|---|---|---|---|"]  # fmt: skip
    for way in ways:
        times = way.seconds / ways[0].seconds
        lines.append(f"| {way.way} | {way.seconds:.1f} | {'' if way.at_rest else 'more than '}{times:.1f} | "
                     f"{'yes' if way.at_rest else 'not yet'} | {way.physical_time:.3f} s | {way.kinetic_share:.2g} | "
                     f"{way.fraction:.4f} | {way.contacts:.3f} |")  # fmt: skip
    return "\n".join([*lines, "", ways[0].told, ""])


def main() -> None:
    args = arguments()
    args.folder.mkdir(parents=True, exist_ok=True)
    results = {"machine": machine()}
    for particles in args.particles:
        rest, unit = rest_of(particles, args.energy)
        folder = args.folder / str(particles)
        folder.mkdir(exist_ok=True)
        ways = [quick(particles, args.cores, folder / "quick", unit)]
        bed = write_bed(folder / "quick" / "snapshots" / "snapshot_000000.vtkhdf", folder / "start")
        ways.append(motion(particles, args.cores, folder / "motion", rest, unit, args.own_limit * ways[0].seconds))
        ways.append(lammps(bed, args.cores, folder, rest, unit, args.lammps_limit * ways[0].seconds))
        print(table(particles, ways), flush=True)
        results[str(particles)] = [dataclasses.asdict(way) for way in ways]
        (args.folder / "results.json").write_text(json.dumps(results, indent=2) + "\n")


if __name__ == "__main__":
    main()
