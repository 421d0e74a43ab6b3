"""Prints as JSON what each of VTK's two XDMF readers finds in a file: pvpython THIS FILE."""

import json
import math
import sys

from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOXdmf2 import vtkXdmfReader
from vtkmodules.vtkIOXdmf3 import vtkXdmf3Reader


def numbers(values):
    return [None if math.isnan(value) else value for value in values]


def arrays(attributes):
    """Values of the first and the last item of each array."""
    result = {}
    for index in range(attributes.GetNumberOfArrays()):
        array = attributes.GetArray(index)
        last = array.GetNumberOfTuples() - 1
        result[array.GetName()] = [numbers(array.GetTuple(item)) for item in (0, last)]
    return result


def block(data):
    return {
        "type": data.GetClassName(),
        "points": data.GetNumberOfPoints(),
        "cells": data.GetNumberOfCells(),
        "bounds": list(data.GetBounds()),
        "point_arrays": arrays(data.GetPointData()),
        "cell_arrays": arrays(data.GetCellData()),
    }


def read(reader, path):
    reader.SetFileName(path)
    reader.UpdateInformation()
    information = reader.GetOutputInformation(0)
    key = vtkStreamingDemandDrivenPipeline.TIME_STEPS()
    times = [information.Get(key, step) for step in range(information.Length(key))]
    frames = []
    for time in times:
        reader.UpdateTimeStep(time)
        blocks = {}
        iterator = reader.GetOutputDataObject(0).NewIterator()
        iterator.InitTraversal()
        while not iterator.IsDoneWithTraversal():
            name = iterator.GetCurrentMetaData().Get(vtkCompositeDataSet.NAME())
            name = name.split("[")[0]  # the older reader numbers names that it has seen before
            blocks[name] = block(iterator.GetCurrentDataObject())
            iterator.GoToNextItem()
        frames.append(blocks)
    return {"times": times, "frames": frames}


print(json.dumps([read(kind(), sys.argv[1]) for kind in (vtkXdmfReader, vtkXdmf3Reader)]))
