"""Reads a .vtu or .pvtu with VTK's own reader and prints all that is in it, a line an item:

    points COUNT / cells COUNT
    cell I TYPE POINT POINT ...
    array WHERE NAME COMPONENTS VALUE ...      WHERE: position, point or cell; floats in hexadecimal
"""
import sys

from vtkmodules.vtkCommonCore import vtkCommand, vtkDoubleArray
from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader, vtkXMLUnstructuredGridReader


def text(value):
    return value.hex() if isinstance(value, float) else str(int(value))


def show(where, array):
    count = array.GetNumberOfTuples()
    parts = array.GetNumberOfComponents()
    whole = not isinstance(array, vtkDoubleArray)
    values = [array.GetComponent(i, c) for i in range(count) for c in range(parts)]
    print("array", where, array.GetName(), parts, *(text(int(v) if whole else v) for v in values))


def main():
    failures = []
    pieces = sys.argv[1].endswith(".pvtu")
    reader = vtkXMLPUnstructuredGridReader() if pieces else vtkXMLUnstructuredGridReader()
    if not reader.CanReadFile(sys.argv[1]):
        sys.exit("VTK says it cannot read this file")
    reader.AddObserver(vtkCommand.ErrorEvent, lambda *_: failures.append("error"))
    reader.AddObserver(vtkCommand.WarningEvent, lambda *_: failures.append("warning"))
    reader.SetFileName(sys.argv[1])
    reader.Update()
    if failures:
        sys.exit("VTK reports: " + ", ".join(failures))
    grid = reader.GetOutput()
    print("points", grid.GetNumberOfPoints())
    print("cells", grid.GetNumberOfCells())
    for i in range(grid.GetNumberOfCells()):
        ends = grid.GetCell(i).GetPointIds()
        print("cell", i, grid.GetCellType(i), *(ends.GetId(k) for k in range(ends.GetNumberOfIds())))
    show("position", grid.GetPoints().GetData())
    for where, data in (("point", grid.GetPointData()), ("cell", grid.GetCellData())):
        for i in range(data.GetNumberOfArrays()):
            show(where, data.GetArray(i))


main()
