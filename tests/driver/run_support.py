# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of vti-run share: readers of its files that are written from the formats' descriptions and know
nothing of the writer. Each reader returns frames: dictionaries of t, step and arrays by their names in HDF5."""
import functools
import os
import xml.etree.ElementTree as ElementTree

import h5py
import numpy

FILES = (".h5", ".csv", ".xdmf", ".dump")


def contents(stem):
    """The bytes of the four files, None for one that is not there, and of the contacts, if they are."""
    def content(path):
        if not os.path.exists(path):
            return None
        with open(path, "rb") as file:
            return file.read()
    contacts = ("-contacts.h5",) if os.path.exists(stem + "-contacts.h5") else ()
    return {ending: content(stem + ending) for ending in (*FILES, *contacts)}


def read_csv(path):
    """Column names in order, and rows; every line must be whole."""
    with open(path, encoding="ascii", newline="") as file:
        text = file.read()
    assert text.endswith("\n") and "\r" not in text
    lines = text[:-1].split("\n")
    names = lines[0].split(",")
    rows = [[float(cell) for cell in line.split(",")] for line in lines[1:]]
    assert all(len(row) == len(names) for row in rows)
    return names, numpy.array(rows)


def read_dump(path):
    """A LAMMPS text dump, strictly."""
    with open(path, encoding="ascii") as file:
        lines = file.read().split("\n")
    assert lines.pop() == ""
    frames, at = [], 0

    def item(name):
        nonlocal at
        assert lines[at].startswith("ITEM: " + name), lines[at]
        at += 1
        return lines[at - 1][len("ITEM: " + name):].split()

    def numbers(kind, count):
        nonlocal at
        cells = lines[at].split(" ")
        assert len(cells) == count and "" not in cells, lines[at]
        at += 1
        return [kind(cell) for cell in cells]

    while at < len(lines):
        item("TIME")
        t, = numbers(float, 1)
        item("TIMESTEP")
        step, = numbers(int, 1)
        item("NUMBER OF ATOMS")
        n, = numbers(int, 1)
        assert item("BOX BOUNDS") == ["ff"] * 3
        box = numpy.array([numbers(float, 2) for _ in range(3)])
        columns = item("ATOMS")
        table = numpy.array([numbers(float, len(columns)) for _ in range(n)])
        column = {name: table[:, k] for k, name in enumerate(columns)}
        assert numpy.array_equal(column["id"], numpy.arange(1, n + 1)) and (column["type"] == 1).all()
        frame = {"t": t, "step": step, "box": box, "columns": columns}
        for name, parts in (("Points", ["x", "y", "z"]), ("velocity", ["vx", "vy", "vz"]),
                            ("omega", ["omegax", "omegay", "omegaz"]),
                            ("attitude_xyzw", ["quati", "quatj", "quatk", "quatw"])):
            if all(part in column for part in parts):
                frame[name] = numpy.stack([column[part] for part in parts], axis=1)
        if "radius" in column:
            frame["diameter"] = 2 * column["radius"]
        frames.append(frame)
    return frames


@functools.lru_cache(maxsize=64)
def dataset(path, name, _written):
    """Read once, though each grid has its slab of it."""
    with h5py.File(path) as file:
        return file[name][...]


def xdmf_array(item, folder):
    """The numbers of a DataItem: XML, HDF, or a slab of another."""
    dimensions = [int(word) for word in item.get("Dimensions").split()]
    if item.get("ItemType") == "HyperSlab":
        selection, source = list(item)
        start, stride, count = xdmf_array(selection, folder).astype(int)
        data = xdmf_array(source, folder)
        slab = data[tuple(slice(s, s + d * c, d) for s, d, c in zip(start, stride, count))]
        return slab.reshape(dimensions)
    if item.get("Format") == "HDF":
        name, path = item.text.strip().split(":")
        file = os.path.join(folder, name)
        data = dataset(file, path, os.stat(file).st_mtime_ns)
        assert list(data.shape) == dimensions and data.dtype.itemsize == int(item.get("Precision"))
        assert data.dtype.kind == {"Float": "f", "Int": "i"}[item.get("NumberType")]
        return data
    return numpy.array(item.text.split(), dtype=float).reshape(dimensions)


def read_xdmf(path):
    """Frames of each grid over time, by the name of the grid; one frame without a time of a grid that does not move."""
    folder, grids = os.path.dirname(path), {}
    for series in ElementTree.parse(path).getroot().find("Domain"):
        moves = series.get("GridType") == "Collection"
        assert not moves or series.get("CollectionType") == "Temporal"
        frames = []
        for grid in series if moves else [series]:
            topology = grid.find("Topology")
            nodes = 4 if topology.get("TopologyType") == "Quadrilateral" else int(topology.get("NodesPerElement"))
            cells = xdmf_array(topology.find("DataItem"), folder).reshape(-1, nodes)
            assert len(cells) == int(topology.get("NumberOfElements"))
            frame = {"t": float(grid.find("Time").get("Value")) if moves else None, "cells": cells, "type": topology.get("TopologyType")}
            frame["Points"] = xdmf_array(grid.find("Geometry").find("DataItem"), folder)
            for attribute in grid.findall("Attribute"):
                assert attribute.get("Center") in ("Node", "Cell")
                data = xdmf_array(attribute.find("DataItem"), folder)
                assert data.shape[1:] == {"Scalar": (), "Vector": (3,), "Matrix": (1, 4), "Tensor": (1, 9)}[attribute.get("AttributeType")]
                frame[attribute.get("Name")] = data.reshape(len(data), -1) if data.ndim > 1 else data
            frames.append(frame)
        grids[series.get("Name")] = frames
    return grids


def loaded(group):
    """All arrays below a group, as groups and datasets are read: by names."""
    return {name: loaded(item) if isinstance(item, h5py.Group) else item[...] for name, item in group.items()}


def read_vtkhdf(path):
    """By the specification of PolyData over time, version 2.0."""
    frames = []
    with h5py.File(path) as file:
        root = file["VTKHDF"]
        assert root.attrs["Type"] == b"PolyData" and list(root.attrs["Version"]) == [2, 0]
        count = root["Steps"].attrs["NSteps"]
        root = loaded(root)
        steps = root["Steps"]
        assert all(len(steps[name]) == count for name in
                   ("Values", "PartOffsets", "NumberOfParts", "PointOffsets", "CellOffsets", "ConnectivityIdOffsets"))
        for k in range(count):
            part, first = steps["PartOffsets"][k], steps["PointOffsets"][k]
            assert steps["NumberOfParts"][k] == 1
            n = root["NumberOfPoints"][part]
            frame = {"t": steps["Values"][k], "Points": root["Points"][first:first + n]}
            for name in root.get("PointData", {}):
                offset = steps["PointDataOffsets"][name][k]
                frame[name] = root["PointData"][name][offset:offset + n]
            for column, kind in enumerate(("Vertices", "Lines", "Polygons", "Strips")):
                group = root[kind]
                cell, id_ = steps["CellOffsets"][k][column], steps["ConnectivityIdOffsets"][k][column]
                cells, ids = group["NumberOfCells"][part], group["NumberOfConnectivityIds"][part]
                offsets = group["Offsets"][cell + part:cell + part + cells + 1]
                points = group["Connectivity"][id_:id_ + ids]
                assert len(offsets) == cells + 1 and offsets[-1] == len(points) == ids
                frame[kind] = [list(points[offsets[c]:offsets[c + 1]]) for c in range(cells)]
            # cells in the order of the kinds
            cells = sum(len(frame[kind]) for kind in ("Vertices", "Lines", "Polygons", "Strips"))
            for name in root.get("CellData", {}):
                offset = steps["CellDataOffsets"][name][k]
                frame[name] = root["CellData"][name][offset:offset + cells]
                assert len(frame[name]) == cells
            assert all(len(frame[name]) == n for name in [*root.get("PointData", {}), "Points"])
            frames.append(frame)
    return frames


def same(frames, others, names):
    """Both trajectories hold these arrays, to the bit."""
    return len(frames) == len(others) and all(
        frame["t"] == other["t"] and all(numpy.array_equal(frame[name], other[name]) for name in names)
        for frame, other in zip(frames, others))
