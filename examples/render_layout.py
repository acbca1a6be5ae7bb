"""Draws a quad mesh with its layout: patches in colours, layout edges dark, irregular vertices as
balls. Called by render_layout.sh, which says how."""

import argparse
import collections
import os

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints, vtkUnsignedCharArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkGlyph3D, vtkPolyDataNormals, vtkTubeFilter
from vtkmodules.vtkFiltersExtraction import vtkExtractEdges
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkImagingCore import vtkImageShrink3D
from vtkmodules.vtkIOGeometry import vtkOBJReader
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer,
                                         vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter)
import vtkmodules.vtkRenderingFreeType  # noqa: F401 (registers the fonts)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 (registers the renderer)

WIDTH, HEIGHT, SUPERSAMPLING = 1200, 900, 2
PALETTE = [(141, 193, 226), (249, 203, 139), (168, 216, 160), (240, 163, 158), (196, 177, 222),
           (246, 232, 150), (159, 219, 209), (231, 178, 208), (205, 190, 170), (187, 200, 220)]
LAYOUT_EDGE, MESH_EDGE = (0.13, 0.14, 0.17), (0.25, 0.27, 0.32)
VALENCE_COLOURS = {3: (0.10, 0.35, 0.85), 5: (0.86, 0.12, 0.12)}
OTHER_VALENCE = (0.95, 0.65, 0.05)


def arguments():
    """The command line; a direction is three numbers."""
    def direction(text):
        x, y, z = (float(t) for t in text.split(","))
        return x, y, z

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder")
    parser.add_argument("picture")
    parser.add_argument("--view", type=direction, help="from the object to the camera")
    parser.add_argument("--up", type=direction, default=(0, 1, 0))
    return parser.parse_args()


def read(reader, path):
    """The mesh in a file."""
    if not os.path.exists(path):
        raise SystemExit(f"render_layout: there is no {path}")
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()


def patch_colours(mesh):
    """A colour for each patch, unlike those of its neighbours, all used about equally often."""
    patch = vtk_to_numpy(mesh.GetCellData().GetArray("patch"))
    corners = vtk_to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 4)
    seen, neighbours = {}, collections.defaultdict(set)
    for p, quad in zip(patch, corners):
        for k in range(4):
            edge = tuple(sorted((quad[k], quad[k - 1])))
            q = seen.setdefault(edge, p)
            if p != q:
                neighbours[p].add(q)
                neighbours[q].add(p)
    colour, used = {}, collections.Counter()
    for p in sorted(set(patch), key=lambda p: (-len(neighbours[p]), p)):
        taken = {colour[q] for q in neighbours[p] if q in colour}
        free = [c for c in range(len(PALETTE)) if c not in taken] or range(len(PALETTE))
        colour[p] = min(free, key=lambda c: (used[c], c))
        used[colour[p]] += 1
    values = vtkUnsignedCharArray()
    values.SetName("colour")
    values.SetNumberOfComponents(3)
    for p in patch:
        values.InsertNextTuple3(*PALETTE[colour[p]])
    return values


def actor(port, colour=None, shine=0.0):
    """What draws the output of a filter."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(port)
    result = vtkActor()
    result.SetMapper(mapper)
    if colour:
        mapper.ScalarVisibilityOff()
        result.GetProperty().SetColor(*colour)
    result.GetProperty().SetAmbient(0.25)
    result.GetProperty().SetDiffuse(0.8)
    result.GetProperty().SetSpecular(shine)
    result.GetProperty().SetSpecularPower(30)
    return result


def surface(mesh):
    """The patches in their colours."""
    mesh.GetCellData().SetScalars(patch_colours(mesh))
    normals = vtkPolyDataNormals()
    normals.SetInputData(mesh)
    normals.SetFeatureAngle(40)
    normals.ConsistencyOff()
    result = actor(normals.GetOutputPort(), shine=0.08)
    result.GetMapper().SetScalarModeToUseCellData()
    return result


def mesh_edges(mesh):
    """The edges of all quads as faint lines."""
    edges = vtkExtractEdges()
    edges.SetInputData(mesh)
    result = actor(edges.GetOutputPort(), MESH_EDGE)
    result.GetProperty().SetOpacity(0.28)
    result.GetProperty().SetLineWidth(1.2)
    result.GetProperty().LightingOff()
    result.GetMapper().SetResolveCoincidentTopologyToPolygonOffset()
    result.GetMapper().SetRelativeCoincidentTopologyLineOffsetParameters(-2, -2)
    return result


def layout_edges(curves, radius):
    """The layout edges as tubes."""
    tubes = vtkTubeFilter()
    tubes.SetInputData(curves)
    tubes.SetRadius(radius)
    tubes.SetNumberOfSides(12)
    return actor(tubes.GetOutputPort(), LAYOUT_EDGE)


def balls(mesh, valence, radius):
    """Balls at the irregular vertices of one valence."""
    irregular = vtk_to_numpy(mesh.GetPointData().GetArray("irregular"))
    valences = vtk_to_numpy(mesh.GetPointData().GetArray("valence"))
    points = vtkPoints()
    for i in ((irregular == 1) & (valences == valence)).nonzero()[0]:
        points.InsertNextPoint(mesh.GetPoint(i))
    places = vtkPolyData()
    places.SetPoints(points)
    ball = vtkSphereSource()
    ball.SetRadius(radius)
    ball.SetThetaResolution(32)
    ball.SetPhiResolution(32)
    glyphs = vtkGlyph3D()
    glyphs.SetInputData(places)
    glyphs.SetSourceConnection(ball.GetOutputPort())
    return actor(glyphs.GetOutputPort(), VALENCE_COLOURS.get(valence, OTHER_VALENCE), 0.4)


def caption(renderer, text, x, y, colour):
    """A line of text; returns its width."""
    line = vtkTextActor()
    line.SetInput(text)
    line.SetPosition(x, y)
    line.GetTextProperty().SetFontSize(20 * SUPERSAMPLING)
    line.GetTextProperty().SetColor(*colour)
    renderer.AddActor2D(line)
    size = [0, 0]
    line.GetSize(renderer, size)
    return size[0]


def captions(renderer, mesh):
    """The numbers of patches and of irregular vertices, in the colours of the balls."""
    number = len(set(vtk_to_numpy(mesh.GetCellData().GetArray("patch"))))
    valences = vtk_to_numpy(mesh.GetPointData().GetArray("valence"))
    irregular = vtk_to_numpy(mesh.GetPointData().GetArray("irregular"))
    x, y = 24 * SUPERSAMPLING, 20 * SUPERSAMPLING
    x += caption(renderer, f"{number} patches", x, y, LAYOUT_EDGE) + 26 * SUPERSAMPLING
    for valence, count in sorted(collections.Counter(valences[irregular == 1]).items()):
        colour = VALENCE_COLOURS.get(valence, OTHER_VALENCE)
        x += caption(renderer, f"{count} of valence {valence}", x, y, colour) + 26 * SUPERSAMPLING


def place_camera(renderer, mesh, view, up):
    """Looks at the object from its broad side, a little from the right and from above, as near as
    possible."""
    low_x, high_x, _, _, low_z, high_z = mesh.GetBounds()
    if view is None:
        view = (0.6, 0.35, 1) if high_x - low_x >= high_z - low_z else (1, 0.35, 0.6)
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    back = numpy.array(view) / numpy.linalg.norm(view)
    right = numpy.cross(up, back)
    right /= numpy.linalg.norm(right)
    axes = numpy.array((right, numpy.cross(back, right), back))
    seen = points @ axes.T
    low, high = seen.min(0), seen.max(0)
    centre = (low + high) / 2 @ axes
    half_width, half_height = (high - low)[:2] / 2
    camera = renderer.GetActiveCamera()
    camera.SetParallelProjection(True)
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(centre + mesh.GetLength() * back))
    camera.SetViewUp(*up)
    camera.SetParallelScale(1.12 * max(half_height, half_width * HEIGHT / WIDTH))
    renderer.ResetCameraClippingRange()


def add_lights(renderer):
    """A key light from the upper left, a weak one from the right."""
    for position, intensity in (((-0.6, 0.9, 1), 0.8), ((1, 0.1, 0.6), 0.35)):
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(*position)
        light.SetIntensity(intensity)
        renderer.AddLight(light)


def save(window, path):
    """Writes the window's picture, several of its pixels averaged into one."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    shrink = vtkImageShrink3D()
    shrink.SetInputConnection(grab.GetOutputPort())
    shrink.SetShrinkFactors(SUPERSAMPLING, SUPERSAMPLING, 1)
    shrink.AveragingOn()
    writer = vtkPNGWriter()
    writer.SetInputConnection(shrink.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()


def main():
    """Draws the files of the folder."""
    options = arguments()
    mesh = read(vtkXMLPolyDataReader(), os.path.join(options.folder, "quad_mesh.vtp"))
    curves = read(vtkOBJReader(), os.path.join(options.folder, "layout_curves.obj"))
    size = mesh.GetLength()

    renderer = vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(4)
    window.SetSize(WIDTH * SUPERSAMPLING, HEIGHT * SUPERSAMPLING)
    window.AddRenderer(renderer)

    renderer.AddActor(surface(mesh))
    renderer.AddActor(mesh_edges(mesh))
    renderer.AddActor(layout_edges(curves, 0.0013 * size))
    for valence in sorted(set(vtk_to_numpy(mesh.GetPointData().GetArray("valence")))):
        renderer.AddActor(balls(mesh, valence, 0.0065 * size))
    captions(renderer, mesh)
    add_lights(renderer)
    place_camera(renderer, mesh, options.view, options.up)
    window.Render()
    save(window, options.picture)


main()
