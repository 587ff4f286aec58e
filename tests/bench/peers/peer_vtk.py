"""VTK draws the common raster as one mesh in one colour, without light: option `whole`, or `decimated-E` by
vtkGreedyTerrainDecimation with an absolute error of E metres. The conversation is that of peer_loop.hpp. Runs with a display."""
import math
import pathlib
import sys
import time
import zlib

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

SIDE, SPACING_M = 2049, 30.0
FIELD_DEG, NEAR_M, FAR_M = 45.0, 30.0, 100000.0
# The depth as peer_frame.hpp encodes it.
DEPTH_CODE = """
float level = floor(clamp(log2(1.0 / gl_FragCoord.w) / 17.0, 0.0, 1.0) * 16777215.0 + 0.5);
gl_FragData[0] = vec4(vec3(floor(level / 65536.0), mod(floor(level / 256.0), 256.0), mod(level, 256.0)) / 255.0, 1.0);
"""


def whole_mesh(posts):
    """Two triangles a cell, divided from south-west to north-east."""
    rows, columns = numpy.mgrid[0:SIDE, 0:SIDE]
    points = numpy.stack([columns * SPACING_M, (SIDE - 1 - rows) * SPACING_M, posts], axis=-1).astype(numpy.float32)
    first = (rows * SIDE + columns)[:-1, :-1].ravel()
    corners = numpy.stack([first, first + SIDE, first + 1, first + SIDE + 1, first + 1, first + SIDE], axis=-1).reshape(-1, 3)
    cells = vtk.vtkCellArray()
    cells.SetData(3, numpy_to_vtkIdTypeArray(corners.ravel().astype(numpy.int64), deep=True))
    places = vtk.vtkPoints()
    places.SetData(numpy_to_vtk(points.reshape(-1, 3), deep=True))
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(places)
    mesh.SetPolys(cells)
    return mesh


def decimated_mesh(posts, error_m):
    image = vtk.vtkImageData()
    image.SetDimensions(SIDE, SIDE, 1)
    image.SetSpacing(SPACING_M, SPACING_M, 1)
    heights = numpy_to_vtk(numpy.ascontiguousarray(posts[::-1]).astype(numpy.float32).ravel(), deep=True)
    image.GetPointData().SetScalars(heights)
    decimate = vtk.vtkGreedyTerrainDecimation()
    decimate.SetInputData(image)
    decimate.SetErrorMeasureToAbsoluteError()
    decimate.SetAbsoluteError(error_m)
    decimate.BoundaryVertexDeletionOff()
    decimate.Update()
    mesh = decimate.GetOutput()
    mesh.GetPointData().SetScalars(None)
    return mesh


def axes_of(heading_deg, pitch_deg, roll_deg):
    """Forward and down, east, north, up."""
    h, p, r = (math.radians(angle) for angle in (heading_deg, pitch_deg, roll_deg))
    forward = numpy.array([math.sin(h) * math.cos(p), math.cos(h) * math.cos(p), math.sin(p)])
    level = numpy.array([math.cos(h), -math.sin(h), 0])
    return forward, numpy.cross(forward, level) * math.cos(r) - level * math.sin(r)


def kept_mesh(folder, option, posts):
    """The mesh of the option and how long it took to make. Decimation takes a minute and more: its mesh is kept in the folder,
    under a name that tells the heights apart."""
    if option == "whole":
        start = time.perf_counter()
        return whole_mesh(posts), 1000 * (time.perf_counter() - start)
    file = folder / f"{option}-{zlib.crc32(posts.tobytes()):08x}.vtp"
    if not file.exists():
        start = time.perf_counter()
        mesh = decimated_mesh(posts, float(option.split("-")[1]))
        file.with_suffix(".ms").write_text(f"{1000 * (time.perf_counter() - start):.1f}", encoding="ascii")
        writer = vtk.vtkXMLPolyDataWriter()
        writer.SetInputData(mesh)
        writer.SetFileName(str(file))
        writer.Write()
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(file))
    reader.Update()
    return reader.GetOutput(), float(file.with_suffix(".ms").read_text(encoding="ascii"))


class Scene:
    def __init__(self, mesh, width, height):
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(width, height)
        self.renderer = vtk.vtkRenderer()
        self.window.AddRenderer(self.renderer)
        self.actors = [self._actor(mesh, shows_depth) for shows_depth in (False, True)]
        self.triangles = mesh.GetNumberOfPolys()

    def _actor(self, mesh, shows_depth):
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputData(mesh)
        mapper.ScalarVisibilityOff()
        mapper.StaticOn()
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().LightingOff()
        actor.GetProperty().SetColor(0.4, 0.5, 0.3)
        if shows_depth:
            actor.GetShaderProperty().AddFragmentShaderReplacement("//VTK::TCoord::Impl", True, DEPTH_CODE, False)
        return actor

    def look(self, pose):
        forward, down = axes_of(*pose[3:])
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(*pose[:3])
        camera.SetFocalPoint(*(numpy.array(pose[:3]) + 1000 * forward))
        camera.SetViewUp(*-down)
        camera.SetViewAngle(FIELD_DEG)
        camera.SetClippingRange(NEAR_M, FAR_M)

    def draw_ms(self):
        start = time.perf_counter()
        self.window.Render()
        self.window.WaitForCompletion()
        return 1000 * (time.perf_counter() - start)

    def show(self, shows_depth):
        self.renderer.RemoveAllViewProps()
        self.renderer.AddActor(self.actors[shows_depth])

    def depths(self):
        """Metres, rows from the top; infinite where nothing was drawn."""
        self.show(True)
        self.draw_ms()
        picture = vtk.vtkWindowToImageFilter()
        picture.SetInput(self.window)
        picture.ReadFrontBufferOff()
        picture.ShouldRerenderOff()
        picture.Update()
        width, height = self.window.GetSize()
        colors = vtk_to_numpy(picture.GetOutput().GetPointData().GetScalars())
        rgb = colors.reshape(height, width, 3)[::-1].astype(numpy.float64)
        level = rgb[..., 0] * 65536 + rgb[..., 1] * 256 + rgb[..., 2]
        return numpy.where(level > 0, numpy.exp2(17 * level / 16777215), numpy.inf).astype(numpy.float32)


def main():
    folder, (width, height), option = pathlib.Path(sys.argv[1]), map(int, sys.argv[2:4]), sys.argv[4]
    posts = numpy.fromfile(folder / "ground.i16", dtype="<i2").reshape(SIDE, SIDE)
    mesh, build_ms = kept_mesh(folder, option, posts)
    scene = Scene(mesh, width, height)
    print(f'ready {{"version": "VTK {vtk.vtkVersion.GetVTKVersion()}", "build_ms": {build_ms:.1f}}}', flush=True)
    for line in sys.stdin:
        scene.look([float(word) for word in line.split()])
        scene.show(False)
        scene.draw_ms()
        ms = scene.draw_ms()
        scene.depths().tofile(folder / f"vtk-{option}.depth")
        print(f'done {{"ms": [{ms:.4f}], "triangles": {scene.triangles}}}', flush=True)


if __name__ == "__main__":
    main()
