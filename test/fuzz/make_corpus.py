#!/usr/bin/env python3
"""Makes a corpus for fuzz_quad_layout: small meshes, good and bad ones, in all formats.

    make_corpus.py FOLDER
"""
import math
import os
import struct
import sys

TETRAHEDRON = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
CUBE = ([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)],
        [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4),
         (1, 5, 7), (1, 7, 3)])
SQUARES = ([(x, y, 0) for y in range(3) for x in range(3)], [(0, 1, 4, 3), (1, 2, 5, 4), (3, 4, 7, 6), (4, 5, 8, 7)])
FLIPPED = (TETRAHEDRON[0], [(0, 1, 2), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
WINGS = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)], [(0, 1, 2), (1, 0, 3), (0, 1, 4)])
BOW_TIE = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0)], [(0, 1, 2), (0, 3, 4)])
NEEDLE = ([(0, 0, 0), (1, 0, 0), (0.5, 1e-12, 0), (0.5, 1, 0)], [(0, 2, 3), (2, 1, 3), (0, 1, 2)])


def torus(n, m):
    """Return a torus of n rings of m vertices."""
    def point(i, j):
        u, v = 2 * math.pi * i / n, 2 * math.pi * j / m
        return (2 + math.cos(v)) * math.cos(u), (2 + math.cos(v)) * math.sin(u), math.sin(v)

    def vertex(i, j):
        return i % n * m + j % m
    faces = []
    for i in range(n):
        for j in range(m):
            faces.append((vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)))
            faces.append((vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)))
    return [point(i, j) for i in range(n) for j in range(m)], faces


def off(points, faces):
    """Write OFF."""
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += ["%g %g %g" % p for p in points] + [" ".join(map(str, (len(f), *f))) for f in faces]
    return ("\n".join(lines) + "\n").encode()


def obj(points, faces):
    """Write OBJ."""
    lines = ["v %g %g %g" % p for p in points] + ["f " + " ".join(str(v + 1) for v in f) for f in faces]
    return ("\n".join(lines) + "\n").encode()


def ply(points, faces):
    """Write PLY."""
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}", "property float x", "property float y",
             "property float z", f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    lines += ["%g %g %g" % p for p in points] + [" ".join(map(str, (len(f), *f))) for f in faces]
    return ("\n".join(lines) + "\n").encode()


def stl(points, faces):
    """Write binary STL."""
    triangles = [(f[0], f[k], f[k + 1]) for f in faces for k in range(1, len(f) - 1)]
    records = [struct.pack("<12fH", 0, 0, 0, *(x for v in t for x in points[v]), 0) for t in triangles]
    return b" " * 80 + struct.pack("<I", len(triangles)) + b"".join(records)


def main():
    """Write every mesh in every format; the first byte also asks for repair, and for features."""
    folder = sys.argv[1]
    os.makedirs(folder, exist_ok=True)
    meshes = {"tetrahedron": TETRAHEDRON, "cube": CUBE, "squares": SQUARES, "flipped": FLIPPED, "wings": WINGS,
              "bow_tie": BOW_TIE, "needle": NEEDLE, "torus": torus(5, 4), "empty": ([], [])}
    for name, mesh in meshes.items():
        for number, write in enumerate((off, obj, ply, stl)):
            for treatment in (0, 4, 8, 48):
                file = os.path.join(folder, f"{name}_{treatment}.{write.__name__}")
                with open(file, "wb") as out:
                    out.write(bytes([number + treatment]) + write(*mesh))


if __name__ == "__main__":
    main()
