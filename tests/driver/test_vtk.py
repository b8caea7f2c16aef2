#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The trajectory of vti-run as ParaView sees it: VTK's own readers of VTKHDF and XDMF find what run_support's reader
finds. `./dev test` fetches VTK into VENV; where there is none that knows PolyData over time (VTK 9.3 does), exit status
77
(skipped).      test_vtk.py VTI_RUN SCENES VENV"""
import os
import sys
import tempfile

PYTHON = os.path.join(sys.argv[3], "bin", "python3")
if os.path.exists(PYTHON) and os.path.realpath(sys.prefix) != os.path.realpath(sys.argv[3]):
    os.execv(PYTHON, [PYTHON, *sys.argv])

import numpy  # noqa: E402

from programs import run  # noqa: E402
from run_support import read_vtkhdf, same  # noqa: E402
from tally import check, conclude  # noqa: E402

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkMath
    from vtkmodules.vtkCommonCore import vtkVersion
    from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
    from vtkmodules.vtkFiltersCore import vtkGlyph3D
    from vtkmodules.vtkFiltersSources import vtkArrowSource, vtkSphereSource
    from vtkmodules.vtkIOHDF import vtkHDFReader
    from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
except ImportError as missing:
    print(f"skipped: {missing}; ./dev test fetches VTK")
    sys.exit(77)
if (vtkVersion.GetVTKMajorVersion(), vtkVersion.GetVTKMinorVersion()) < (9, 3):
    print(f"skipped: VTK {vtkVersion.GetVTKVersion()} cannot read PolyData over time; ./dev test fetches one that can")
    sys.exit(77)

RUN, SCENES = map(os.path.abspath, sys.argv[1:3])
READERS = {".h5": vtkHDFReader, ".xdmf": vtkXdmfReader}


def read(path, ending, grid=0):
    """Frames as run_support's readers return them, with the points of that grid; which of them the cells of the XDMF
    index join is left to those."""
    reader, frames = READERS[ending](), []
    reader.SetFileName(path)
    reader.UpdateInformation()
    key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    information = reader.GetOutputInformation(0)
    # VTKHDF with a single frame is one without time to VTK
    for t in [information.Get(key, k) for k in range(information.Length(key))] or [0.0]:
        reader.UpdateTimeStep(t)
        data = reader.GetOutputDataObject(0)
        blocks = [data.GetBlock(k) for k in range(data.GetNumberOfBlocks())] if data.IsA("vtkMultiBlockDataSet") else [data]
        data = blocks[grid]
        frame = {"t": t}
        if data.GetNumberOfPoints() > 0:
            frame["Points"] = vtk_to_numpy(data.GetPoints().GetData()).copy()
        for k in range(data.GetPointData().GetNumberOfArrays()):
            array = data.GetPointData().GetArray(k)
            frame[array.GetName()] = vtk_to_numpy(array).copy()
        for block in blocks:
            cells = block.GetCellData()
            for k in range(cells.GetNumberOfArrays()):
                frame[cells.GetArrayName(k)] = vtk_to_numpy(cells.GetArray(k)).copy()
                if block.GetNumberOfCells() > 0:
                    frame["in " + cells.GetArrayName(k)] = block.GetCell(0).GetClassName()
        if ending == ".h5":
            ids = vtk_to_numpy(data.GetLines().GetConnectivityArray()) if data.GetNumberOfLines() else numpy.zeros(0, int)
            frame["Lines"] = ids.reshape(-1, 2).tolist()
        frames.append(frame)
    return frames


# What moves only, what turns only, with and without bonds and diameters, few frames and many.
CASES = [("pendulum", "--stepper", "vti3-leapfrog", "--frames", "100"), ("spin", "--h", "0.3"), ("torus", "--t-end", "0.5"),
         ("chain", "--t-end", "1/512"), ("pile", "--t-end", "1/16", "--frames", "30")]
BONDS = ("bond", "bond_energy", "bond_stretch")
print(f"VTK {vtkVersion.GetVTKVersion()}")
for scene, *options in CASES:
    with tempfile.TemporaryDirectory() as folder:
        done = run(RUN, f"{SCENES}/{scene}.yaml", *options, "-o", f"{folder}/out.h5")
        check(done.returncode == 0, f"{scene} runs {done.stderr}")
        frames = read_vtkhdf(f"{folder}/out.h5")
        data = sorted(set(frames[0]) - {"t", "Vertices", "Lines", "Polygons", "Strips", *BONDS})
        check(all(name in frames[0] for name in BONDS) == (len(frames[0]["Lines"]) > 0), f"{scene}: bonds have cell data")
        bonds = [{"t": frame["t"], **{name: frame[name][len(frame["Points"]):] for name in BONDS[1:]}} for frame in frames
                 if "bond" in frame]
        check(not bonds or same(bonds, read(f"{folder}/out.xdmf", ".xdmf"), BONDS[1:]), f"{scene}.xdmf: cell data of the bonds")
        planes = {"torus": 1, "pile": 5}.get(scene, 0)
        check(all((frame.get("in wall") == "vtkQuad" and frame["wall"].tolist() == list(range(planes))) if planes else
                  "wall" not in frame for frame in read(f"{folder}/out.xdmf", ".xdmf")),
              f"{scene}.xdmf: {planes} quads as walls at all times")
        for ending, more in ((".h5", ["Lines", *(name for name in BONDS if name in frames[0])]), (".xdmf", [])):
            check(same(frames, read(f"{folder}/out{ending}", ending), data + more),
                  f"{scene}{ending}: VTK finds the same {len(frames)} frames of {' '.join(data + more)}")

def one_glyph():
    """An arrow along x that a body turned by a quarter about z holds points along y, by VTK's quaternions (w first) as
    by its vectors."""
    scene = "bodies: {alpha: [0, 0, 2], omega: [0, 0, 1e-9], inertia: 1}\nstepper: vti2\nh: 1\nt_end: 2\n"
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/quarter.yaml", "w", encoding="ascii") as file:
            file.write(scene)
        done = run(RUN, f"{folder}/quarter.yaml", "-o", f"{folder}/out.h5")
        check(done.returncode == 0, f"a quarter turn runs {done.stderr}")
        reader = vtkHDFReader()
        reader.SetFileName(f"{folder}/out.h5")
        reader.Update()
        data = reader.GetOutputDataObject(0)
        turned = [[0.0] * 3 for _ in range(3)]
        vtkMath.QuaternionToMatrix3x3(data.GetPointData().GetArray("attitude_wxyz").GetTuple(0), turned)
        check(max(abs(turned[k][0] - (k == 1)) for k in range(3)) < 1e-8, f"attitude_wxyz turns x to y: {turned}")
        data.GetPointData().SetActiveVectors("director")
        glyph, arrow = vtkGlyph3D(), vtkArrowSource()
        glyph.SetInputData(data)
        glyph.SetSourceConnection(arrow.GetOutputPort())
        glyph.SetVectorModeToUseVector()
        glyph.Update()
        bounds = glyph.GetOutput().GetBounds()
        check(abs(bounds[3] - 1) < 1e-6 and abs(bounds[2]) < 1e-6 and max(map(abs, bounds[:2])) < 0.2,
              f"the arrow along director points along y: {bounds}")


def spheres():
    """Spheres of clumps, by the reader and as glyphs of their diameters."""
    with tempfile.TemporaryDirectory() as folder:
        done = run(RUN, f"{SCENES}/clump-pile.yaml", "--t-end", "1/256", "--frames", "50", "-o", f"{folder}/out.h5")
        check(done.returncode == 0, f"clumps run {done.stderr}")
        frames = read_vtkhdf(f"{folder}/out-spheres.h5")
        check(len(frames) > 2 and same(frames, read(f"{folder}/out-spheres.h5", ".h5"), ["Points", "velocity", "diameter", "body"]),
              f"VTK finds the same {len(frames)} frames of {len(frames[0]['Points'])} spheres")
        check(same(frames, read(f"{folder}/out.xdmf", ".xdmf", grid=1), ["Points", "velocity", "diameter", "body"]),
              "... and as the second block of the XDMF index")
        reader, glyph, sphere = vtkHDFReader(), vtkGlyph3D(), vtkSphereSource()
        reader.SetFileName(f"{folder}/out-spheres.h5")
        reader.Update()
        data = reader.GetOutputDataObject(0)
        data.GetPointData().SetActiveScalars("diameter")
        glyph.SetInputData(data)
        glyph.SetSourceConnection(sphere.GetOutputPort())
        glyph.SetScaleModeToScaleByScalar()
        glyph.Update()
        high = (frames[0]["Points"] + frames[0]["diameter"][:, None] / 2).max(0)
        check(abs(glyph.GetOutput().GetBounds()[5] - high[2]) < 1e-6 * high[2], "glyphs reach as high as the spheres")


def contacts():
    """What touches, as lines whose number changes from frame to frame, of which some have none."""
    with tempfile.TemporaryDirectory() as folder:
        for scene, end, frames in (("heap", "1/8", "8"), ("torus", "1/4", "16"), ("clump-pile", "1/32", "8")):
            done = run(RUN, f"{SCENES}/{scene}.yaml", "--t-end", end, "--frames", frames, "--contacts", "-o", f"{folder}/{scene}.h5")
            check(done.returncode == 0, f"{scene} --contacts runs {done.stderr}")
            wanted = read_vtkhdf(f"{folder}/{scene}-contacts.h5")
            names = sorted(set(wanted[0]) - {"t", "Vertices", "Polygons", "Strips"})
            found = read(f"{folder}/{scene}-contacts.h5", ".h5")
            counts = [len(frame["Lines"]) for frame in wanted]
            nothing = {name: wanted[0][name][:0] for name in names}
            found = [{**nothing, "Lines": [], **frame} for frame in found]
            check(same(wanted, found, names) and {"i", "j", "force", "normal_force", "overlap"} < set(names),
                  f"{scene}: VTK finds the same {min(counts)} to {max(counts)} contacts in {len(counts)} frames: {' '.join(names)}")
            check(min(counts) < max(counts) and (scene != "torus" or min(counts) == 0), "... whose number changes")


one_glyph()
spheres()
contacts()
conclude()
