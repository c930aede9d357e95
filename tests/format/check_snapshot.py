"""Reads every dataset of a snapshot with h5py alone and checks it against docs/format.md. Prints "ok N particles"."""

import sys

import h5py
import numpy as np

REQUIRED = {
    "/VTKHDF/NumberOfPoints": ("i8", 1), "/VTKHDF/NumberOfCells": ("i8", 1),
    "/VTKHDF/NumberOfConnectivityIds": ("i8", 1), "/VTKHDF/Points": ("f8", 2), "/VTKHDF/Connectivity": ("i8", 1),
    "/VTKHDF/Offsets": ("i8", 1), "/VTKHDF/Types": ("u1", 1), "/VTKHDF/PointData/radius": ("f8", 1),
    "/VTKHDF/PointData/id": ("i8", 1), "/VTKHDF/PointData/type": ("i4", 1), "/VTKHDF/PointData/material": ("i4", 1),
    "/VTKHDF/FieldData/time": ("f8", 1), "/VTKHDF/FieldData/step": ("i8", 1), "/contacts/pair": ("i8", 2),
    "/contacts/force": ("f8", 2), "/contacts/normal": ("f8", 2), "/contacts/overlap": ("f8", 1),
    "/contacts/point": ("f8", 2), "/contacts/slid": ("u1", 1), "/boundaries/point": ("f8", 2),
    "/boundaries/normal": ("f8", 2), "/boundaries/axis": ("f8", 2), "/boundaries/cross_section": ("f8", 1),
    "/boundaries/one_sided": ("u1", 1), "/boundaries/surface_points": ("f8", 2),
    "/boundaries/surface_triangles": ("i4", 2), "/boundaries/surface_first_point": ("i8", 1),
    "/boundaries/surface_first_triangle": ("i8", 1), "/scene/group_density": ("f8", 1), "/packstone/format_version": ("i8", 1),
    "/packstone/domain": ("f8", 2), "/packstone/periodic": ("u1", 1), "/packstone/gravity": ("f8", 1),
    "/packstone/chunk_first_row": ("i8", 1), "/packstone/chunk_bounds": ("f8", 2),
}
TEXTS = ["/boundaries/name", "/boundaries/kind", "/scene/text", "/scene/hash", "/scene/material_name",
         "/scene/group_name", "/scene/group_material", "/packstone/program"]

with h5py.File(sys.argv[1], "r") as file:
    assert file["VTKHDF"].attrs["Type"] == b"UnstructuredGrid"
    assert list(file["VTKHDF"].attrs["Version"]) == [1, 0]
    for name, (kind, rank) in REQUIRED.items():
        data = file[name][()]
        assert data.dtype == np.dtype(kind) and data.ndim == rank, (name, data.dtype, data.shape)
    for name in TEXTS:
        assert all(isinstance(text, str) for text in file[name].asstr()[()]), name

    count = int(file["/VTKHDF/NumberOfPoints"][0])
    points = file["/VTKHDF/Points"][()]
    radius = file["/VTKHDF/PointData/radius"][()]
    ids = file["/VTKHDF/PointData/id"][()]
    assert points.shape == (count, 3) and sorted(ids) == list(range(count))
    assert np.isfinite(points).all() and (radius >= 0).all()
    assert list(file["/VTKHDF/Offsets"][()]) == list(range(count + 1))
    assert (file["/VTKHDF/Types"][()] == 1).all()
    for name, data in file["/VTKHDF/PointData"].items():
        assert len(data) == count and "unit" in data.attrs, name

    bounds = file["/packstone/chunk_bounds"][()]
    first = list(file["/packstone/chunk_first_row"][()]) + [count]
    for chunk, box in enumerate(bounds):
        rows = slice(first[chunk], first[chunk + 1])
        assert (points[rows] - radius[rows, None] >= box[:3] - 1e-12).all()
        assert (points[rows] + radius[rows, None] <= box[3:] + 1e-12).all()

    # Overlap and normal of every contact follow from the positions.
    row = np.argsort(ids)
    low, high = file["/packstone/domain"][()]
    periodic = file["/packstone/periodic"][()].astype(bool)
    for (i, j), normal, overlap in zip(file["/contacts/pair"], file["/contacts/normal"], file["/contacts/overlap"]):
        if j < 0:
            assert -1 - j < len(file["/boundaries/name"])
            continue
        d = points[row[i]] - points[row[j]]
        d -= np.where(periodic, np.round(d / (high - low)) * (high - low), 0)
        distance = np.linalg.norm(d)
        assert abs(radius[row[i]] + radius[row[j]] - distance - overlap) < 1e-12
        assert np.allclose(d / distance, normal)
    print("ok", count, "particles")
