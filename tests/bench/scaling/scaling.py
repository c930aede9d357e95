#!/usr/bin/python3
"""Cost of a particle and step over the number of particles, the ratio of sizes and the threads. See ../README.md.

Equal spheres are jammed without gravity by growth in a small periodic box and tiled to any number. Mixtures are cut
out of that packing, large spheres in the place of the small ones in their way, and settle between walls under strong
gravity, so that all have about the same contacts a particle.
"""
from __future__ import annotations

import argparse
import json
import math
import os
import pathlib
import subprocess

import h5py
import numpy as np

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]
RADIUS = 0.005  # of the small spheres [m]
TILE = 8000  # spheres of the periodic packing
FRACTION = 0.639  # solid volume over the box's: about random close packing, and just what growth accepts
LARGE_SHARE = 1 / 8  # of the small spheres' volume, in a mixture
PARTICLE_STEPS = 1.5e9  # of a timed run: tens of seconds
LEAST_STEPS, MOST_STEPS = 400, 40000
TIME_STEP = 5e-6  # [s]
GRAVITY, SETTLING = 98.0, 0.1  # that bring a mixture to rest [m/s2], [s]

SCENE = """
title = "Jammed spheres"
[dynamics]
time_step = {time_step}
duration = {duration:.17g}
[domain]
min = [0, 0, 0]
max = [{side[0]:.17g}, {side[1]:.17g}, {side[2]:.17g}]
periodic = {periodic}
[contact]
normal = "linear"
[[material]]
name = "steel"
density = 7800
normal_stiffness = 1e7
restitution = 0.42
{gravity}
{particles}
{filling}
{walls}
[monitor]
overlap_limit = 1
energy_tolerance = 1e9
[output]
interval = {duration:.17g}
history_interval = {duration:.17g}
contacts = false
fields = ["velocity"]
"""


def sphere(radius: float) -> float:
    return 4 / 3 * math.pi * radius**3


def scene(**parts: object) -> str:
    return SCENE.format(**{"time_step": TIME_STEP, "gravity": "", **parts})


def walls(side: float) -> str:
    text = ""
    for axis in range(3):
        for end, sign in ((0.0, 1), (side, -1)):
            point, normal = [0.0] * 3, [0] * 3
            point[axis], normal[axis] = end, sign
            text += f'[[boundary]]\nname = "{"xyz"[axis]}{sign:+d}"\nkind = "plane"\npoint = {point}\nnormal = {normal}\n'
    return text


def group(count: int | None, radius: float) -> str:
    text = '[[particles]]\nmaterial = "steel"\n'
    return text if count is None else text + f"count = {count}\nradius = {radius:.17g}\n"


def packstone(text: str, folder: pathlib.Path, threads: int) -> tuple[dict, int]:
    """Runs a scene's text; returns run.json and the peak memory [byte]."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "scene_in.toml").write_text(text)
    command = [os.environ.get("PACKSTONE", REPOSITORY / "build" / "packstone"), "run", folder / "scene_in.toml", "-o",
               folder / "run", "--overwrite", "--quiet", "--threads", str(threads)]  # fmt: skip
    with subprocess.Popen(command, stderr=subprocess.DEVNULL) as process:
        _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise SystemExit(f"packstone failed: {' '.join(map(str, command))}")
    return json.loads((folder / "run" / "run.json").read_text()), 1024 * usage.ru_maxrss


def last_snapshot(folder: pathlib.Path) -> h5py.File:
    return h5py.File(sorted((folder / "run" / "snapshots").glob("snapshot_*.vtkhdf"))[-1])


def jammed_tile(folder: pathlib.Path) -> tuple[np.ndarray, float]:
    """Positions of the periodic packing and its side."""
    side = (TILE * sphere(RADIUS) / FRACTION) ** (1 / 3)
    if not (folder / "run" / "run.json").exists():
        filling = '[filling]\nkind = "growth"\nduration = 0.05'
        packstone(scene(duration=0.1, side=3 * [side], periodic='["x", "y", "z"]', walls="",
                        particles=group(TILE, RADIUS), filling=filling), folder, 2)  # fmt: skip
    return last_snapshot(folder)["VTKHDF/Points"][:], side


def repeated(positions: np.ndarray, side: float, tiles: tuple[int, int, int]) -> np.ndarray:
    shifts = np.stack(np.meshgrid(*map(np.arange, tiles)), -1).reshape(-1, 3) * side
    return (positions[None] + shifts[:, None]).reshape(-1, 3)


def written(points: np.ndarray, radii: np.ndarray, file: pathlib.Path) -> None:
    """A file of spheres, in the order of an unsorted input."""
    order = np.random.default_rng(1).permutation(len(points))
    np.savetxt(file, np.column_stack([points, radii])[order], fmt="%.10g", delimiter=",", header="x,y,z,radius",
               comments="")  # fmt: skip


def mixture(packing: np.ndarray, tile: float, ratio: float, small: int,
            file: pathlib.Path) -> tuple[float, int, int]:  # fmt: skip
    """A file of large spheres among about so many small ones; returns the box's side and how many there are of each."""
    large = 0 if ratio == 1 else max(1, round(small * LARGE_SHARE / ratio**3))
    side = ((small + large * ratio**3) * sphere(RADIUS) / FRACTION) ** (1 / 3)
    points = repeated(packing, tile, 3 * (math.ceil(side / tile),))
    points = points[np.all((points >= RADIUS) & (points <= side - RADIUS), axis=1)]
    radius, random, centres = ratio * RADIUS, np.random.default_rng(1), np.empty((0, 3))
    while len(centres) < large:
        centre = random.uniform(radius, side - radius, 3) if large > 1 else np.full(3, side / 2)
        if np.all(np.linalg.norm(centres - centre, axis=1) > 2 * radius):
            centres = np.vstack([centres, centre])
    for centre in centres:
        points = points[np.linalg.norm(points - centre, axis=1) > radius + RADIUS]
    written(np.vstack([points, centres]), np.repeat([RADIUS, radius], [len(points), large]), file)
    return side, len(points), large


def from_file(file: pathlib.Path) -> str:
    return f'[filling]\nkind = "file"\npath = "{file}"'


def timed(folder: pathlib.Path, particles: int, threads: int, **parts: object) -> dict:
    steps = int(min(MOST_STEPS, max(LEAST_STEPS, PARTICLE_STEPS / particles)))
    text = scene(duration=steps * TIME_STEP, particles=group(None, RADIUS), **parts)
    record, memory = packstone(text, folder, threads)
    history = np.genfromtxt(folder / "run" / "history.csv", delimiter=",", names=True)
    return {"particles": particles, "threads": threads, "ns": 1e9 * record["loop_seconds"] / particles / record["steps"],
            "lists": record["list_seconds"] / record["loop_seconds"], "builds": record["list_builds"],
            "steps": record["steps"], "z": float(np.atleast_1d(history)[-1]["coordination"]),
            "bytes": memory / particles}  # fmt: skip


def over_particles(folder: pathlib.Path, numbers: list[int], threads: list[int]) -> list[dict]:
    positions, side = jammed_tile(folder / "tile")
    rows = []
    for number in numbers:
        edge = max(1, round((number / TILE) ** (1 / 3)))
        tiles = (edge, edge, max(1, round(number / TILE / edge**2)))
        file = folder / f"tiles_{number}.csv"
        if not file.exists():
            points = repeated(positions, side, tiles)
            written(points, np.full(len(points), RADIUS), file)
        count = TILE * math.prod(tiles)
        for t in threads:
            row = timed(folder / f"n{number}", count, t, filling=from_file(file), side=[side * n for n in tiles],
                        periodic='["x", "y", "z"]', walls="")  # fmt: skip
            rows.append({"case": "equal spheres", "ratio": 1, **row})
            print(line(rows[-1]), flush=True)
    return rows


def over_ratios(folder: pathlib.Path, ratios: list[float], small: int, threads: list[int]) -> list[dict]:
    packing, tile = jammed_tile(folder / "tile")
    gravity = f"[gravity]\nacceleration = [0, 0, {-GRAVITY}]"
    rows = []
    for ratio in ratios:
        file, bed = folder / f"ratio{ratio:g}.csv", folder / f"ratio{ratio:g}"
        side, kept, large = mixture(packing, tile, ratio, small, file)
        box = {"side": 3 * [side], "periodic": "[]", "walls": walls(side), "gravity": gravity}
        packstone(scene(duration=SETTLING, particles=group(None, RADIUS), filling=from_file(file), **box), bed, 2)
        settled = sorted((bed / "run" / "snapshots").glob("snapshot_*.vtkhdf"))[-1]
        for t in threads:
            row = timed(folder / f"timed_ratio{ratio:g}", kept + large, t, filling=from_file(settled), **box)
            rows.append({"case": f"{large} large among small", "ratio": ratio, **row})
            print(line(rows[-1]), flush=True)
    return rows


HEADER = ("| particles | ratio of radii | threads | ns a particle and step | million particle-steps a second | z | "
          "lists' share of the time | steps a list | peak bytes a particle |\n|" + 9 * "---|")  # fmt: skip


def line(row: dict) -> str:
    lives = row["steps"] / max(1, row["builds"])
    return (f"| {row['particles']} | {row['ratio']:g} | {row['threads']} | {row['ns']:.1f} | {1e3 / row['ns']:.1f} | "
            f"{row['z']:.2f} | {100 * row['lists']:.0f} % | {lives:.0f} | {row['bytes']:.0f} |")  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument("--numbers", nargs="*", type=int, default=[8000, 32000, 100000, 300000, 1000000, 3000000])
    parser.add_argument("--ratios", nargs="*", type=float, default=[1, 2, 5, 10, 20, 50])
    parser.add_argument("--small", type=int, default=100000, help="small spheres of a mixture")
    parser.add_argument("--threads", nargs="+", type=int, default=[1, 2])
    parser.add_argument("--folder", type=pathlib.Path, default=REPOSITORY / "build" / "bench" / "scaling")
    options = parser.parse_args()
    print(HEADER, flush=True)
    rows = over_particles(options.folder, options.numbers, options.threads)
    rows += over_ratios(options.folder, options.ratios, options.small, options.threads)
    (options.folder / "scaling.json").write_text(json.dumps(rows, indent=1))
    (options.folder / "scaling.md").write_text("\n".join([HEADER, *map(line, rows)]) + "\n")


if __name__ == "__main__":
    main()
