#!/usr/bin/python3
"""Checks the parts that need no other program: python3 -m unittest in this folder."""
import dataclasses
import math
import pathlib
import unittest

import numpy as np

import tables
from beds import Bed, packing_fraction
from cases import CASES, TUNED, Physics
from programs import Failed, Job, Measured, lammps_variables, liggghts_variables, read_output

BED = Bed(pathlib.Path("b"), pathlib.Path("l"), 2, (1, 1, 1), (0.005, 0.05))
OUTPUT = """Loop time of 1.5 on 2 procs for 300 steps with 2 atoms
Neighbor list builds = 3
Loop time of 2.0 on 2 procs for 1000 steps with 2 atoms, finish time now
Neighbor list builds = 7
Loop time of 1e-06 on 2 procs for 0 steps with 2 atoms
STATE z 5.4 kinetic 0.25
"""


def job() -> Job:
    case = CASES["S3"]
    return Job(case, BED, Physics.of(case.scene), steps=1000, warm_up=300, cores=2, folder=pathlib.Path("."))


def measured(rate: float, z: float) -> Measured:
    return Measured(1.0, rate, 100, z, 1.0, 0.6, None)


class Parts(unittest.TestCase):
    def test_timed_loop_is_the_second(self):
        m = read_output(OUTPUT, job(), memory=5, fraction=0.6)
        self.assertEqual((m.seconds, m.rate, m.z, m.kinetic, m.list_builds), (2.0, 1000.0, 5.4, 0.25, 7))

    def test_lost_particles_fail(self):
        with self.assertRaises(Failed):
            read_output(OUTPUT.replace("1000 steps with 2 atoms", "1000 steps with 1 atoms"), job(), 5, 0.6)

    def test_gamma_gives_the_restitution(self):
        p = Physics.of("equal_bed.toml")
        m_eff = p.mass(0.005) / 2
        half, omega = p.gamma(m_eff) / 2, math.sqrt(p.normal_stiffness / m_eff)
        self.assertAlmostEqual(math.exp(-half * math.pi / math.sqrt(omega**2 - half**2)), p.restitution)

    def test_pairs_of_types(self):
        """LIGGGHTS: small, large and floor in rows; the floor's m_eff is the particle's mass."""
        p = Physics.of("two_sizes_bed.toml")
        small, large = p.mass(0.005), p.mass(0.05)
        gamma = [float(word) for word in liggghts_variables(p, job(), TUNED["S3", "liggghts"], 2)["gamma"].split()]
        self.assertEqual(len(gamma), 9)
        for place, m_eff in ((0, small / 2), (1, small * large / (small + large)), (2, small), (5, large)):
            self.assertAlmostEqual(gamma[place] / p.gamma(m_eff), 1)
        lammps = lammps_variables(p, job(), TUNED["S3", "lammps"], 2)
        self.assertAlmostEqual(float(lammps["gamma"]) / gamma[0], 1)
        self.assertAlmostEqual(float(lammps["floor_gamma_2"]) / gamma[5], 1)

    def test_scenes_of_a_case_have_one_physics(self):
        for case in CASES.values():
            timed, settled = Physics.of(case.scene), Physics.of(case.settle)
            self.assertEqual(timed, dataclasses.replace(settled, time_step=timed.time_step))

    def test_packing_fraction_of_a_lattice(self):
        """Touching spheres in a simple cubic lattice, many layers: pi / 6 but for the ends of the slab."""
        layers = 400
        height = np.arange(layers) * 0.01 + 0.005
        self.assertAlmostEqual(packing_fraction(height, np.full(layers, 0.005), 1e-4), math.pi / 6, places=3)

    def test_table_and_notes(self):
        same = tables.rows_of(job(), {"packstone": [measured(4, 5.0)] * 3, "lammps": [measured(2, 5.1)] * 3},
                              {"packstone": "", "lammps": "x"})  # fmt: skip
        self.assertEqual(same[1].packstone_ratio, 2)
        self.assertEqual(tables.disagreements(same), [])
        self.assertIn("| 2.00 x |", tables.markdown(same))
        away = tables.rows_of(job(), {"packstone": [measured(4, 3.5)], "lammps": [measured(2, 5.1)]},
                              {"packstone": "", "lammps": "x"})  # fmt: skip
        self.assertIn("NOT THE SAME BED in S3", tables.disagreements(away)[0])


if __name__ == "__main__":
    unittest.main()
