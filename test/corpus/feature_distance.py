#!/usr/bin/env python3
"""Measures how far the feature curves of a triangle mesh are from the edges of a quad mesh.

    feature_distance.py SURFACE.off QUADS.obj ANGLE

Prints the greatest distance of a point on a border edge, or on an edge sharper than ANGLE degrees, from the nearest
edge of a quad, as a fraction of the diagonal of the bounding box; 0 if there are no such edges.
"""
import collections
import sys

import numpy
from scipy.spatial import cKDTree

NEIGHBOURS = 64


def read_off(file):
    """Return points and triangles of a mesh in OFF."""
    with open(file, encoding="utf-8", errors="replace") as stream:
        lines = [words for words in (line.split("#")[0].split() for line in stream) if words]
    counts = lines.pop(0)[1:] or lines.pop(0)           # "OFF", "COFF", ... may share a line with the counts
    vertices, faces = int(counts[0]), int(counts[1])
    points = numpy.array([words[:3] for words in lines[:vertices]], dtype=float)
    triangles = numpy.array([words[1:4] for words in lines[vertices:vertices + faces]], dtype=int)
    return points, triangles


def read_quads(file):
    """Return points and quads of a mesh in OBJ."""
    points, quads = [], []
    with open(file, encoding="utf-8") as stream:
        for words in (line.split() for line in stream):
            if words and words[0] == "v":
                points.append([float(x) for x in words[1:4]])
            elif words and words[0] == "f":
                quads.append([int(x.split("/")[0]) - 1 for x in words[1:]])
    return numpy.array(points), numpy.array(quads)


def feature_edges(points, triangles, angle):
    """Return the pairs of vertices of border edges and sharp edges."""
    corners = points[triangles]
    normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= numpy.linalg.norm(normals, axis=1)[:, None]
    faces = collections.defaultdict(list)
    for f, triangle in enumerate(triangles):
        for k in range(3):
            faces[tuple(sorted((triangle[k], triangle[(k + 1) % 3])))].append(f)
    limit = numpy.cos(numpy.radians(angle + 1e-6))
    return [edge for edge, (f, *others) in faces.items() if not others or normals[f] @ normals[others[0]] < limit]


def distances_to_segments(samples, begins, ends):
    """Return the distance of each sample from the nearest of its segments; these have a second axis."""
    along = ends - begins
    squared = numpy.maximum((along ** 2).sum(-1), 1e-300)
    fraction = numpy.clip(((samples[:, None] - begins) * along).sum(-1) / squared, 0, 1)
    return numpy.linalg.norm(begins + fraction[..., None] * along - samples[:, None], axis=-1).min(1)


def greatest_distance(surface, quad_mesh, angle):
    """Return the figure that the program prints."""
    points, triangles = read_off(surface)
    diagonal = numpy.linalg.norm(numpy.ptp(points[numpy.unique(triangles)], axis=0))
    edges = feature_edges(points, triangles, angle)
    if not edges:
        return 0.
    samples = numpy.concatenate([points[u] + numpy.linspace(0, 1, 9)[:, None] * (points[v] - points[u])
                                 for u, v in edges])
    vertices, quads = read_quads(quad_mesh)
    sides = numpy.unique(numpy.sort(numpy.stack([quads, numpy.roll(quads, -1, axis=1)], -1).reshape(-1, 2), axis=1),
                         axis=0)
    begins, ends = vertices[sides[:, 0]], vertices[sides[:, 1]]
    nearest = cKDTree((begins + ends) / 2).query(samples, min(NEIGHBOURS, len(sides)))[1].reshape(len(samples), -1)
    result = distances_to_segments(samples, begins[nearest], ends[nearest])
    for i in numpy.flatnonzero(result > 5e-4 * diagonal):      # a long side may be near while its middle is far
        result[i] = distances_to_segments(samples[i:i + 1], begins[None], ends[None])[0]
    return float(result.max() / diagonal)


if __name__ == "__main__":
    print("%.3g" % greatest_distance(sys.argv[1], sys.argv[2], float(sys.argv[3])))
