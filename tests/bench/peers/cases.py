"""What is measured: the four cases, and what each program was tuned to for them."""
from __future__ import annotations

import dataclasses
import math
import pathlib
import tomllib

HERE = pathlib.Path(__file__).parent
PROGRAMS = ("packstone", "packstone-mixed", "lammps", "liggghts")


@dataclasses.dataclass(frozen=True)
class Case:
    """A bed and how long it is timed."""

    name: str
    what: str
    settle: str  # scene that makes the bed
    scene: str  # scene that packstone is timed on; the other programs take their numbers from it
    bed_time: float | None  # instant of the settling run that is the bed [s]; None: its end
    steps: int
    same: str = "z"  # what must agree at the end: z, or kinetic while the bed falls and contacts come and go


CASES = {
    case.name: case
    for case in (
        Case("S1", "100,000 equal, frictionless", "equal_settle.toml", "equal_bed.toml", None, 3000),
        Case("S2", "100,000 equal, friction 0.5", "friction_settle.toml", "friction_bed.toml", None, 3000),
        Case("S3", "60,000 of 5 mm + 200 of 50 mm, frictionless", "two_sizes_settle.toml", "two_sizes_bed.toml", None,
             3000),
        Case("S4", "100,000 equal, frictionless, falling", "equal_settle.toml", "equal_bed.toml", 0.3, 3000,
             same="kinetic"),
    )
}  # fmt: skip


@dataclasses.dataclass(frozen=True)
class Tuning:
    """How a program is set up beside the physics. What a program does not know, it ignores."""

    skin: float  # margin of the neighbour list [m]
    grid: str = "* * 1"  # processes along x, y, z
    newton: str = "on"  # LAMMPS: each pair across processes computed once (and communicated) or twice
    bins: str = "bin"  # LAMMPS: bin or multi
    tangential: str = "tangential no_history"  # LIGGGHTS without friction: this, or "" for no tangential model
    bind: str = "none"  # mpirun --bind-to


# Starting values; bench.py --tune tries the CANDIDATES below, one kind after another, and prints lines for this table.
# LIGGGHTS' multi finds no neighbours at all (and exits with 0), so it has no choice there.
TUNED = {
    ("S1", "lammps"): Tuning(skin=0.0002),
    ("S1", "liggghts"): Tuning(skin=0.0001),
    ("S2", "lammps"): Tuning(skin=0.0002),
    ("S2", "liggghts"): Tuning(skin=0.0001),
    ("S3", "lammps"): Tuning(skin=0.001, bins="multi"),
    ("S3", "liggghts"): Tuning(skin=0.002),
    ("S4", "lammps"): Tuning(skin=0.0005),
    ("S4", "liggghts"): Tuning(skin=0.0005),
}

# Tried by --tune.
SKINS = (0.00005, 0.0001, 0.0002, 0.0005, 0.001, 0.002)
GRIDS = ("* * 1", "1 * *", "* 1 *", "* * *")
CANDIDATES = {
    "lammps": {"skin": SKINS, "bins": ("bin", "multi"), "newton": ("on", "off"), "grid": GRIDS,
               "bind": ("none", "core")},
    "liggghts": {"skin": SKINS, "tangential": ("tangential no_history", ""), "grid": GRIDS, "bind": ("none", "core")},
}  # fmt: skip


@dataclasses.dataclass(frozen=True)
class Physics:
    """The numbers of a scene that the other programs need, in SI."""

    time_step: float
    gravity: float
    density: float
    normal_stiffness: float
    tangential_stiffness: float
    restitution: float
    friction: float

    @staticmethod
    def of(scene_name: str) -> Physics:
        scene = tomllib.loads((HERE / "scenes" / scene_name).read_text())
        (material,) = scene["material"]  # one material only: pairs need no mixing
        return Physics(
            time_step=scene["dynamics"]["time_step"],
            gravity=-scene["gravity"]["acceleration"][2],
            density=material["density"],
            normal_stiffness=material["normal_stiffness"],
            tangential_stiffness=material.get("tangential_stiffness", material["normal_stiffness"]),
            restitution=material["restitution"],
            friction=material.get("friction", 0.0),
        )

    def mass(self, radius: float) -> float:
        return self.density * 4 / 3 * math.pi * radius**3

    def gamma(self, effective_mass: float) -> float:
        """Damping [1/s] of the force gamma m_eff v that gives the restitution at this effective mass [kg].

        The contact is a damped oscillator, e = exp(-pi zeta / sqrt(1 - zeta^2)) with gamma = 2 zeta sqrt(k / m_eff).
        """
        log_e = math.log(self.restitution)
        zeta = -log_e / math.hypot(math.pi, log_e)
        return 2 * zeta * math.sqrt(self.normal_stiffness / effective_mass)
