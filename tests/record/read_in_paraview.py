# SPDX-License-Identifier: Apache-2.0
"""Opens the small mill's frames (mill.c) in ParaView, as a person would: file, times, numbers."""
import os
import sys

from paraview.simple import OpenDataFile

folder = os.path.abspath(sys.argv[1])


def check(name, cells, arrays):
    reader = OpenDataFile(os.path.join(folder, "frames", name))
    times = list(reader.TimestepValues)
    assert len(times) == 11 and all(abs(t - 0.004 * i) < 1e-12 for i, t in enumerate(times)), times
    boxes = []
    for time in times:
        reader.UpdatePipeline(time)
        about = reader.GetDataInformation()
        assert cells(about), (time, about.GetNumberOfPoints(), about.GetNumberOfCells())
        boxes.append(about.GetBounds())
    assert boxes[0] != boxes[-1]
    data = reader.PointData if reader.PointData.GetNumberOfArrays() else reader.CellData
    names = {data.GetArray(i).GetName() for i in range(data.GetNumberOfArrays())}
    assert names == arrays, names


check("frames.hdf.series", lambda a: a.GetNumberOfPoints() == 80 and a.GetNumberOfCells() == 1,
      {"id", "body", "class", "radius", "velocity", "speed", "spin"})
check("liner.hdf.series", lambda a: a.GetNumberOfCells() > 100,
      {"lifter", "part", "normal_work", "shear_work", "finnie_work"})
