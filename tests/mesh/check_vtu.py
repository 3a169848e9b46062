#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The VTU and PVD files of facies, read by somebody else: meshio (Debian: python3-meshio).

usage: check_vtu.py PATH/TO/write_vtu_sample
Exit status 77 where meshio or numpy is not installed: CTest then reports the test as skipped.
"""
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

try:
    import meshio
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing} (Debian: apt-get install python3-meshio)")
    sys.exit(77)

# Faces of cells as meshio hands them over, each counter-clockwise seen from outside. meshio turns VTK's wedge, whose
# triangle 0 1 2 looks out of the cell, into gmsh's, whose triangle looks into it: a wedge comes out with positive volume
# exactly if the file has it as VTK wants it.
FACES = {
    "hexahedron": [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)],
    "wedge": [(0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)],
    "triangle": [(0, 1, 2)],
    "quad": [(0, 1, 2, 3)],
}
# The sheet of write_vtu_sample.cpp [mm].
RADIUS, SIZE_Y, SIZE_Z = 80.0, 40.0, 40.0
N_Y, N_Z, N_DEPTH = 40, 30, 10


def check(condition, message):
    if not condition:
        sys.exit(f"FAILED: {message}")


def flux_volumes(points, cells, kind):
    """Volume that each cell's faces enclose (divergence theorem; both diagonals of a quadrilateral averaged)."""
    volume = np.zeros(len(cells))
    corner = points[cells]
    for face in FACES[kind]:
        if len(face) == 3:
            splits = [[face]]
        else:
            a, b, c, d = face
            splits = [[(a, b, c), (a, c, d)], [(b, c, d), (b, d, a)]]
        for split in splits:
            for i, j, k in split:
                triple = np.einsum("ni,ni->n", corner[:, i], np.cross(corner[:, j], corner[:, k]))
                volume += triple / 6.0 / len(splits)
    return volume


def expected_points():
    depths = np.concatenate([[0.0, 1.5], 1.5 + 5.0 * np.arange(1, 9) / 8.0, [11.5]])
    y = SIZE_Y * (np.arange(N_Y + 1) / N_Y - 0.5)
    z = SIZE_Z * (np.arange(N_Z + 1) / N_Z - 0.5)
    depth, y, z = np.meshgrid(depths, y, z, indexing="ij")
    ray = np.stack([-np.ones_like(y), np.tan(y / RADIUS), np.tan(z / RADIUS)], axis=-1)
    ray /= np.linalg.norm(ray, axis=-1, keepdims=True)
    return (np.array([RADIUS, 0.0, 0.0]) + (RADIUS - depth)[..., None] * ray).reshape(-1, 3)


def check_volume(path):
    mesh = meshio.read(path)
    points = expected_points()
    check(mesh.points.dtype == np.float64, "points are not Float64")
    check(mesh.points.shape == points.shape, f"{mesh.points.shape} points, expected {points.shape}")
    check(np.abs(mesh.points - points).max() < 1e-12, "points differ")
    check(np.array_equal(mesh.point_data["height"], mesh.points[:, 2]), "scalar node field differs")
    check(mesh.point_data["X_mm"].dtype == np.float32, "X_mm is not Float32")
    check(np.array_equal(mesh.point_data["X_mm"], mesh.points.astype(np.float32)), "vector node field differs")
    check(mesh.point_data["number"].dtype == np.int32, "number is not Int32")
    check(np.array_equal(mesh.point_data["number"], np.arange(len(points)) - 7), "integer node field differs")

    total, count = 0.0, {"hexahedron": 0, "wedge": 0}
    for block, tensor, n_nodes in zip(mesh.cells, mesh.cell_data["tensor"], mesh.cell_data["n_nodes"]):
        count[block.type] += len(block.data)
        volumes = flux_volumes(mesh.points, block.data, block.type)
        check(volumes.min() > 0.0, f"a {block.type} is inside out")
        total += volumes.sum()
        x, y, z = mesh.points[block.data].mean(axis=1).T
        expected = np.stack([x, 10 * y, 100 * z, x * y, y * z, x * z], axis=1)
        check(np.abs(tensor - expected).max() < 1e-9, "tensor cell field differs")
        check(n_nodes.dtype == np.uint8 and (n_nodes == block.data.shape[1]).all(), "UInt8 cell field differs")
    check(count == {"hexahedron": N_Y * N_Z * N_DEPTH // 2, "wedge": N_Y * N_Z * N_DEPTH},
          f"counts of cells: {count}")
    return mesh, total


def check_surface(path, volume_mesh, volume):
    mesh = meshio.read(path)
    total = 0.0
    for block, normal in zip(mesh.cells, mesh.cell_data["normal"]):
        total += flux_volumes(mesh.points, block.data, block.type).sum()
        corner = mesh.points[block.data]
        area = np.cross(corner[:, 2] - corner[:, 0], corner[:, -1] - corner[:, 1])
        area /= np.linalg.norm(area, axis=1, keepdims=True)
        check(np.abs(area - normal).max() < 1e-12, "face normals differ")
    check(abs(total - volume) < 1e-8 * volume, f"the surface encloses {total}, the cells {volume} mm^3")
    back = volume_mesh.points[mesh.point_data["number"] + 7]
    check(np.array_equal(back, mesh.points), "node fields of the surface belong to other nodes")
    used = np.unique(np.concatenate([block.data.ravel() for block in mesh.cells]))
    check(np.array_equal(used, np.arange(len(mesh.points))), "the surface has nodes of no face")


def check_series(path):
    datasets = ElementTree.parse(path).getroot().findall("Collection/DataSet")
    check([d.get("file") for d in datasets] == ["volume.vtu", "surface.vtu"], "files of the series")
    check([float(d.get("timestep")) for d in datasets] == [0.0, 1.0], "times of the series")


def main():
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.argv[1], folder], check=True)
        mesh, volume = check_volume(os.path.join(folder, "volume.vtu"))
        check_surface(os.path.join(folder, "surface.vtu"), mesh, volume)
        check_series(os.path.join(folder, "series.pvd"))
    print(f"meshio {meshio.__version__} read every point, cell and field as it was written")


if __name__ == "__main__":
    main()
