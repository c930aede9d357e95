#!/usr/bin/python3
"""The floor's load beside the weight above it, and Janssen's law: janssen.py RUN [--check]

F = W (1 - exp(-w/W)): w the weight poured, W what the floor bears at most (Janssen, Z. VDI 39 (1895) 1045); and the form with
a layer of weight a that the walls do not carry, F = a + W (1 - exp(-(w - a)/W)) above it and F = w below (Vanel & Clement, Eur.
Phys. J. B 11 (1999) 525). Each portion counts at its last row of history.csv, at rest. With --check the exit code says whether the load
saturates as the second form has it.
"""
import csv
import glob
import sys

import h5py
import numpy

GRAVITY = 9.8
DENSITY = 2500
REST = 1e-3  # root-mean-square speed, as in the scene [m/s]

with open(sys.argv[1] + "/history.csv") as file:
    rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]
last = sorted(glob.glob(sys.argv[1] + "/snapshots/snapshot_*.vtkhdf"))[-1]
with h5py.File(last) as file:
    radius = file["VTKHDF/PointData/radius"][:]
    ids = file["VTKHDF/PointData/id"][:]
weight_of = numpy.empty(len(ids))
weight_of[ids] = DENSITY * 4 / 3 * numpy.pi * radius**3 * GRAVITY
poured = numpy.cumsum(weight_of)

weight, load = [], []
for row, after in zip(rows, rows[1:] + [None]):
    w = poured[int(row["particles"]) - 1]
    rests = row["time"] > 0 and 2 * row["kinetic_translational"] * GRAVITY / w < REST**2
    if rests and (after is None or after["particles"] > row["particles"]):
        weight.append(w)
        load.append(-row["floor.force_z"])
weight, load = numpy.array(weight), numpy.array(load)


def law(a, W):
    return numpy.where(weight < a, weight, a + W * (1 - numpy.exp(-(weight - a) / W)))


def misfit(a, W):
    return numpy.sqrt(((law(a, W) - load) ** 2).mean())


grid = numpy.linspace(0.01, 2, 400) * load.max()
janssen = min(grid, key=lambda W: misfit(0, W))
layer, more = min(((a, W) for a in numpy.linspace(0, 1, 101) * load.max() for W in grid), key=lambda p: misfit(*p))
print("weight [N]  floor [N]  Janssen [N]  with a layer [N]")
for row in zip(weight, load, law(0, janssen), law(layer, more)):
    print("{:10.3f}{:11.3f}{:13.3f}{:18.3f}".format(*row))
print(f"misfit {misfit(0, janssen):.3f} N, with a layer of {layer:.2f} N {misfit(layer, more):.3f} N; "
      f"the last portion of {weight[-1] - weight[-2]:.3f} N added {load[-1] - load[-2]:.3f} N")
added = (load[-1] - load[-2]) / (weight[-1] - weight[-2])
if sys.argv[2:] == ["--check"] and not (added < 0.05 and load[-1] < 0.5 * weight[-1]
                                        and misfit(layer, more) < 0.05 * load[-1]):
    sys.exit("the floor's load does not saturate: of the last portion it should bear less than 5 %, of all less than half, "
             "within 5 % of the law with a layer")
