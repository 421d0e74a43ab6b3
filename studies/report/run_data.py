"""Readers of a run directory for the report."""

import csv
import json
import pathlib
import tomllib

import h5py
import numpy as np


class Table:
    """A CSV file of Zona: columns by name, without the unit."""

    def __init__(self, path):
        with open(path, newline="", encoding="utf-8") as file:
            header, *rows = csv.reader(file)
        self.units = {}
        self.names = []
        for title in header:
            name, _, unit = title.partition(" [")
            if title.count(" [") > 1 or name in self.units:
                name = title
            self.names.append(name)
            self.units[name] = unit.rstrip("]")
        rows = [row for row in rows if len(row) == len(header)]
        self.first_cells = [row[0] for row in rows]
        values = np.array([[_number(cell) for cell in row] for row in rows])
        self.columns = dict(zip(self.names, values.T if len(values) else np.empty((len(header), 0))))

    def __contains__(self, name):
        return name in self.columns

    def __getitem__(self, name):
        return self.columns[name]

    def __len__(self):
        return len(next(iter(self.columns.values())))


def _number(cell):
    try:
        return float(cell)
    except ValueError:
        return np.nan


class Frames:
    """The frames of fields.h5."""

    def __init__(self, path):
        self.file = h5py.File(path, "r")
        self.names = list(self.file["frames"])
        self.times = np.array([self.file["frames"][name].attrs["time"] for name in self.names])

    def group(self, index):
        return self.file["frames"][self.names[index]]

    def triangles(self, index, cloud):
        topology = self.group(index)[cloud].attrs["topology"]
        return np.asarray(self.file[topology.decode() if isinstance(topology, bytes) else topology])


class Run:
    """A run directory, or that of one fill of a comparison."""

    def __init__(self, directory, name="", results=None):
        self.directory = pathlib.Path(directory)
        self.name = name
        self.results = results if results is not None else {}

    def table(self, name):
        path = self.directory / name
        return Table(path) if path.is_file() else None

    def frames(self):
        path = self.directory / "fields.h5"
        if not path.is_file():
            return None
        frames = Frames(path)
        return frames if frames.names else None


class Study:
    """A study with its outcome; raises FileNotFoundError or ValueError if the directory is not a run."""

    def __init__(self, directory):
        self.directory = pathlib.Path(directory)
        self.text = (self.directory / "study.toml").read_text(encoding="utf-8")
        self.keys = tomllib.loads(self.text)
        self.summary = json.loads((self.directory / "summary.json").read_text(encoding="utf-8"))
        self.kind = self.summary["study"]
        self.results = self.summary["results"]

    def runs(self):
        """One run, or those of the fills of a comparison."""
        if self.kind != "comparison":
            results = self.results if isinstance(self.results, dict) else {}
            return [Run(self.directory, "", results)]
        return [Run(self.directory / _folder(entry["fluid"]), entry["fluid"], entry)
                for entry in self.results if entry]


def _folder(fluid):
    """The directory of a fill, named as the program does."""
    name = ""
    for character in fluid:
        plain = (character.isascii() and character.isalnum()) or character in ".-"
        if plain or (name and name[-1] != "_"):
            name += character if plain else "_"
    return name
