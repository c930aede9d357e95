#!/usr/bin/python3
"""Discharge over five openings, and the power it follows: beverloo.py [PACKSTONE [FOLDER [--check]]]

Beverloo, Leniger & van de Velde, Chem. Eng. Sci. 15 (1961) 260: the flow through an opening D wide of beads d wide goes
as (D - k d)^(5/2). Runs sample 05 with each opening, counts the beads below the outlet in the snapshots, takes the flow between
a third and nine tenths of the discharge, and fits flow^(2/5) = a (D - k d); then the power with that k. With --check the exit
code says whether the power and Beverloo's own constants come out.
"""
import glob
import os
import subprocess
import sys

import h5py
import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
BIN, OUTLET, BEAD = 0.05, 0.1, 0.004            # [m]
BULK_DENSITY = 0.58 * 2500                      # [kg/m3]
GRAVITY = 9.8                                   # [m/s2]
RADII = [0.010, 0.012, 0.014, 0.016, 0.018]     # of the openings [m]
MASS = 2500 * numpy.pi / 6 * BEAD**3            # [kg]
SETTLED = 0.5                                   # [s]


def flow(folder):
    """Mass a second [kg/s], while the bin is neither just opened nor nearly empty."""
    time, out = [], []
    for name in sorted(glob.glob(folder + "/snapshots/snapshot_*.vtkhdf")):
        with h5py.File(name) as file:
            time.append(file["VTKHDF/FieldData/time"][0])
            out.append((file["VTKHDF/Points"][:, 2] < OUTLET).sum())
            count = len(file["VTKHDF/Points"])
    time, out = numpy.array(time), numpy.array(out)
    steady = (time > SETTLED + 0.15) & (out < 0.6 * count)
    return MASS * numpy.polyfit(time[steady], out[steady], 1)[0]


def main():
    packstone = sys.argv[1] if len(sys.argv) > 1 else "packstone"
    folder = sys.argv[2] if len(sys.argv) > 2 else "runs/05_beverloo"
    flows = []
    for r in RADII:
        run = f"{folder}/{1000 * r:.0f}mm"
        subprocess.run([packstone, "run", HERE + "/scene.toml", "-o", run, "--overwrite", "--quiet", "--set",
                        f"boundary[0].outlet_radius={r}", "--set", f"boundary[0].cone_length={BIN - r}"], check=True)
        flows.append(flow(run))
    openings, flows = 2 * numpy.array(RADII), numpy.array(flows)
    a, b = numpy.polyfit(openings, flows**0.4, 1)
    k = -b / a / BEAD
    power = numpy.polyfit(numpy.log(openings - k * BEAD), numpy.log(flows), 1)[0]
    with_usual_k = numpy.polyfit(numpy.log(openings - 1.4 * BEAD), numpy.log(flows), 1)[0]
    print("opening [mm]  flow [g/s]  fit [g/s]")
    for D, W in zip(openings, flows):
        print(f"{1e3 * D:12.0f}{1e3 * W:12.2f}{1e3 * (a * D + b)**2.5:11.2f}")
    constant = a**2.5 / (BULK_DENSITY * numpy.sqrt(GRAVITY))
    print(f"k = {k:.2f}, C = {constant:.2f}; power {power:.2f} with it, {with_usual_k:.2f} with k = 1.4")
    if sys.argv[3:] == ["--check"] and not (abs(power - 2.5) < 0.05 and abs(with_usual_k - 2.5) < 0.1
                                            and 1 < k < 1.8 and 0.5 < constant < 0.65):
        sys.exit("not Beverloo's law: power 2.5, k from 1 to 1.8, C from 0.5 to 0.65")


main()
