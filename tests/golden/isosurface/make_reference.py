#!/usr/bin/env python3
"""Writes reference.txt: the surface that scikit-image takes from the volume of test_isosurface_reference.cpp.

Debian package python3-skimage (made with 0.19.3); not needed to build or test. Run it in this folder.
"""
from collections import Counter

import numpy as np
import skimage
from skimage import measure

NX, NY, NZ = 22, 20, 14
LEVEL = 0.45


def volume(finer=1):
    """A ring, a ball inside it and one beside it that has grown together with it."""
    shape = [(n - 1) * finer + 1 for n in (NZ, NY, NX)]
    z, y, x = np.indices(shape).astype(np.float64) / finer
    ring = np.hypot(x - 9.3, y - 9.6) - 6.1
    value = np.exp(-(ring**2 + (z - 6.4) ** 2) / 5.0)
    value += 0.9 * np.exp(-((x - 9.1) ** 2 + (y - 9.4) ** 2 + (z - 6.7) ** 2) / 4.0)
    value += 0.9 * np.exp(-((x - 17.2) ** 2 + (y - 9.9) ** 2 + (z - 7.1) ** 2) / 5.0)
    return value.astype(np.float32)


def euler_number(faces, vertices):
    edges = {tuple(sorted((f[a], f[b]))) for f in faces for a, b in ((0, 1), (1, 2), (2, 0))}
    return len(vertices) - len(edges) + len(faces)


def surface(finer=1):
    """Vertices without twins, faces, area and volume enclosed."""
    vertices, faces, _, _ = measure.marching_cubes(volume(finer), LEVEL, spacing=(1 / finer,) * 3, method="lewiner")
    vertices, inverse = np.unique(vertices, axis=0, return_inverse=True)
    faces = np.array([f for f in inverse[faces] if len(set(f)) == 3])
    corners = vertices[faces].astype(np.float64)
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return vertices, faces, np.linalg.norm(across, axis=1).sum() / 2, abs((corners[:, 0] * across).sum() / 6)


def main():
    vertices, faces, area, enclosed = surface()
    uses = Counter(tuple(sorted((f[a], f[b]))) for f in faces for a, b in ((0, 1), (1, 2), (2, 0)))
    assert set(uses.values()) == {2}
    _, _, fine_area, fine_enclosed = surface(finer=8)
    with open("reference.txt", "w", encoding="ascii") as out:
        out.write(f"# scikit-image {skimage.__version__}, measure.marching_cubes, method lewiner; by make_reference.py\n")
        out.write("# Euler number, area, volume enclosed, the two on a grid eight times as fine, vertices; then x y z of each\n")
        out.write(f"{euler_number(faces, vertices)} {area:.4f} {enclosed:.4f} {fine_area:.4f} {fine_enclosed:.4f} {len(vertices)}\n")
        for z, y, x in vertices:
            out.write(f"{x:.5f} {y:.5f} {z:.5f}\n")


main()
