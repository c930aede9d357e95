#!/usr/bin/python3
"""The slope of a heap on a plate: slope.py RUN

The highest point of any sphere in rings about the axis, a straight line through those between a quarter and three
quarters of the plate's radius.
"""
import glob
import math
import sys

import h5py
import numpy

PLATE = 0.06   # radius [m]
TOP = 0.03     # of the plate [m]
RINGS = 10

last = sorted(glob.glob(sys.argv[1] + "/snapshots/snapshot_*.vtkhdf"))[-1]
with h5py.File(last) as file:
    position = file["VTKHDF/Points"][:]
    radius = file["VTKHDF/PointData/radius"][:]
on_plate = position[:, 2] > TOP
r = numpy.hypot(position[:, 0], position[:, 1])
z = position[:, 2] + radius
edges = numpy.linspace(0.25 * PLATE, 0.75 * PLATE, RINGS + 1)
middle, height = [], []
for low, high in zip(edges[:-1], edges[1:]):
    # Eight sectors of each ring: the mean of their highest points follows the surface, not its highest bead.
    ring = on_plate & (r >= low) & (r < high)
    sector = ((numpy.arctan2(position[:, 1], position[:, 0]) / (2 * math.pi) * 8).astype(int)) % 8
    tops = [z[ring & (sector == k)].max() for k in range(8) if (ring & (sector == k)).any()]
    middle.append(0.5 * (low + high))
    height.append(numpy.mean(tops))
slope, offset = numpy.polyfit(middle, height, 1)
residual = numpy.std(numpy.array(height) - numpy.polyval([slope, offset], middle))
print(f"angle of repose {math.degrees(math.atan(-slope)):.1f} degrees, residual {residual * 1e3:.2f} mm, "
      f"{on_plate.sum()} of {len(r)} beads on the plate")
