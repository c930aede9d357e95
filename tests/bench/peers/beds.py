"""The beds: packstone settles them, LAMMPS data files carry them to every program."""
from __future__ import annotations

import dataclasses
import hashlib
import pathlib
import subprocess
import tomllib

import h5py
import numpy as np

from cases import HERE, Case

STAMP = "stamp.txt"
ABOVE = 0.1  # share of the bed's height that the box leaves free above it


@dataclasses.dataclass(frozen=True)
class Bed:
    """A bed on disk: one file for packstone and LAMMPS, one for LIGGGHTS, whose floor is a type of its own."""

    data: pathlib.Path
    liggghts_data: pathlib.Path
    particles: int
    box: tuple[float, float, float]  # upper corner; the lower one is the origin [m]
    radii: tuple[float, ...]  # of each type, type 1 first [m]


def bed_of(case: Case, packstone: pathlib.Path, folder: pathlib.Path, threads: int, scale: float) -> Bed:
    """The bed of a case from the folder, made if it is not there or its scene has changed since."""
    scene = HERE / "scenes" / case.settle
    run = folder / f"{scene.stem}_{scale:g}"
    stamp = run / STAMP  # written last: the run is whole
    key = hashlib.sha256(scene.read_bytes()).hexdigest()
    if not stamp.exists() or stamp.read_text() != key:
        settle(scene, packstone, run, threads, scale)
        stamp.write_text(key)
    return write_bed(snapshot_at(run, case.bed_time), run / case.name)


def forget(folder: pathlib.Path) -> None:
    """Makes every bed of the folder count as not there."""
    for stamp in folder.glob(f"*/{STAMP}"):
        stamp.unlink()


def settle(scene: pathlib.Path, packstone: pathlib.Path, run: pathlib.Path, threads: int, scale: float) -> None:
    """Runs the scene that makes a bed, with its particle counts scaled."""
    print(f"settling {scene.stem}, {scale:g} of its size: minutes for a whole one", flush=True)
    command = [packstone, "run", scene, "-o", run, "--overwrite", "--quiet", "--threads", str(threads)]
    for k, group in enumerate(tomllib.loads(scene.read_text())["particles"]):
        command += ["--set", f"particles[{k}].count={max(1, round(scale * group['count']))}"]
    subprocess.run(command, check=True)


def snapshot_at(run: pathlib.Path, time: float | None) -> pathlib.Path:
    """The snapshot at this time [s], or the last one."""
    snapshots = sorted((run / "snapshots").glob("snapshot_*.vtkhdf"))
    if time is None:
        return snapshots[-1]
    for file in snapshots:
        with h5py.File(file) as f:
            if abs(f["VTKHDF/FieldData/time"][0] - time) < 1e-3:
                return file
    raise SystemExit(f"bench: {run} has no snapshot at {time} s")


def write_bed(snapshot: pathlib.Path, stem: pathlib.Path) -> Bed:
    """Writes a snapshot as LAMMPS data files."""
    with h5py.File(snapshot) as f:
        point_data = f["VTKHDF/PointData"]
        points = f["VTKHDF/Points"][:]
        radius = point_data["radius"][:]
        ids = point_data["id"][:]
        types = point_data["type"][:]
        velocity = point_data["velocity"][:]
        # A scene without friction turns no sphere.
        spin = point_data["angular_velocity"][:] if "angular_velocity" in point_data else np.zeros_like(velocity)
        density = f["scene/group_density"][:][types]
        upper = f["packstone/domain"][1]
    height = (1 + ABOVE) * np.max(points[:, 2] + radius)
    box = (float(upper[0]), float(upper[1]), float(height))
    groups = int(types.max()) + 1
    radii = tuple(float(radius[types == k].max()) for k in range(groups))

    atoms = np.column_stack([ids + 1, types + 1, 2 * radius, density, points])
    velocities = np.column_stack([ids + 1, velocity, spin])
    files = {stem.with_suffix(".data"): groups, stem.with_suffix(".liggghts.data"): groups + 1}
    for file, type_count in files.items():
        with open(file, "w") as out:
            out.write(f"{snapshot.name} by packstone\n\n{len(ids)} atoms\n{type_count} atom types\n\n")
            for length, axis in zip(box, "xyz"):
                out.write(f"0 {length:.17g} {axis}lo {axis}hi\n")
            out.write("\nAtoms # sphere\n\n")
            np.savetxt(out, atoms, fmt=["%d", "%d"] + 5 * ["%.17g"])
            out.write("\nVelocities\n\n")
            np.savetxt(out, velocities, fmt=["%d"] + 6 * ["%.17g"])
    return Bed(*files, len(ids), box, radii)


def packing_fraction(height: np.ndarray, radius: np.ndarray, area: float) -> float:
    """Of the bulk, V(0.1 h, 0.8 h) / (0.7 h A) with exact sphere slabs and h = V / (f A), as in docs/format.md."""
    volume = float(np.sum(4 / 3 * np.pi * radius**3))

    def solid_below(z: float) -> float:
        u = np.clip(z - height, -radius, radius)
        return float(np.sum(np.pi * (radius**2 * u - u**3 / 3 + 2 / 3 * radius**3)))

    low, high = 0.0, float(np.max(height + radius)) / 0.8
    for _ in range(50):  # halvings
        h = (low + high) / 2
        if solid_below(0.8 * h) - solid_below(0.1 * h) < 0.7 * volume:
            low = h
        else:
            high = h
    return volume / (h * area)
