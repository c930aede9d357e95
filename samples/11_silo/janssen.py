#!/usr/bin/python3
"""The floor's load beside the weight above it, and Janssen's law: janssen.py RUN

F = W (1 - exp(-w/W)): w the weight poured, W what the floor bears at most (Janssen, Z. VDI 39 (1895) 1045). Each portion counts
at its last row of history.csv, at rest.
"""
import csv
import glob
import sys

import h5py
import numpy

GRAVITY = 9.8
DENSITY = 2500

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
    if after is None or after["particles"] > row["particles"]:
        weight.append(poured[int(row["particles"]) - 1])
        load.append(-row["floor.force_z"])
weight, load = numpy.array(weight), numpy.array(load)
most = min(numpy.linspace(0.5, 2, 1501) * load.max(),
           key=lambda W: ((W * (1 - numpy.exp(-weight / W)) - load) ** 2).sum())
print("weight [N]  load [N]  Janssen [N]")
for w, f in zip(weight, load):
    print(f"{w:10.3f}{f:10.3f}{most * (1 - numpy.exp(-w / most)):13.3f}")
print(f"the floor bears at most {most:.3f} N; the last portion of {weight[-1] - weight[-2]:.3f} N added "
      f"{load[-1] - load[-2]:.3f} N")
