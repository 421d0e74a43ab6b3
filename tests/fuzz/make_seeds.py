"""Writes the first inputs of the fuzzers: make_seeds.py SOURCE FOLDER.

Study files are those of the project. Of HDF5 there are small files of every storage and type that the readers
meet: as Zona writes them, and as h5py may.
"""
import pathlib
import shutil
import sys

import h5py
import numpy

source, folder = map(pathlib.Path, sys.argv[1:3])
time = numpy.linspace(0, 4e-6, 5)
move = 1e-6 * numpy.sin(2e6 * time)


def place(target):
    """A new, empty folder for the inputs of a fuzzer."""
    path = folder / target
    shutil.rmtree(path, ignore_errors=True)
    path.mkdir(parents=True)
    return path


def studies(path):
    files = [*source.glob("studies/*.toml"), *source.glob("studies/verification/*.toml")]
    for file in files:
        shutil.copy(file, path / f"{file.parent.name}-{file.name}")
    amended = (source / "studies/piercing_lateral_quick.toml").read_text(encoding="utf-8")
    (path / "overrides.toml").write_text(amended + '\n#set grid.cell="8 um"\n#set zona={level=4}\n',
                                         encoding="utf-8")


def csv_traces(path):
    (path / "comma.csv").write_text("# a comment\ntime [us], displacement [um], velocity [m/s]\n\n"
                                    "0, 0, 0\n0.6, 1.25e-3, 0.004\n1.2,+2e-3,-.1\n", encoding="utf-8")
    (path / "micro.csv").write_text("\ufefftime [ns],displacement [nm],acceleration [m/s²],support [µm]\r\n"
                                    "0,0,0,0\r\n1,2,3,4\r\n2,1,0,0\r\n3,-1,-2,1e-300\r\n", encoding="utf-8")
    lines = (source / "studies/example_trace.csv").read_text(encoding="utf-8").splitlines()[:12]
    (path / "example.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


def trace(path, libver="earliest", **storage):
    """A trace in a file of its own; `storage` is what h5py's create_dataset takes."""
    with h5py.File(path, "w", libver=libver) as file:
        for name, values in {"time": time, "displacement": move}.items():
            file.create_dataset(name, data=values, **storage)
            file[name].attrs["unit"] = "s" if name == "time" else "m"


def hdf5_traces(path):
    trace(path / "plain.h5")
    trace(path / "latest.h5", libver="latest")
    trace(path / "single.h5", dtype=">f4")
    trace(path / "integers.h5", dtype="i2")
    trace(path / "chunks.h5", chunks=(2,), maxshape=(None,))
    trace(path / "packed.h5", chunks=(5,), compression="gzip", shuffle=True, fletcher32=True)
    trace(path / "packed_latest.h5", libver="latest", chunks=(4,), compression="gzip")
    with h5py.File(path / "links.h5", "w") as file:
        file["measured/time"] = time
        file["time"] = h5py.SoftLink("/measured/time")
        file["displacement"] = h5py.ExternalLink("trace.h5", "/measured/move")
        file["measured/move"] = numpy.reshape(move, (1, 5))
        file["velocity"] = h5py.SoftLink("/velocity")


def checkpoint(path, text, libver="earliest", **storage):
    with h5py.File(path, "w", libver=libver) as file:
        file.attrs["version"] = text
        file.attrs["study"] = numpy.bytes_(b"0123456789abcdef")
        file.create_dataset("state/body/stress", data=numpy.arange(12.0), **storage)
        file.create_dataset("state/body/order", data=numpy.arange(4, dtype="i4"), **storage)
        file.create_dataset("state/steps", data=numpy.array([7], dtype="i8"))


def checkpoints(path):
    checkpoint(path / "plain.h5", numpy.bytes_(b"0.1.0"))
    checkpoint(path / "text.h5", "of variable length")
    checkpoint(path / "latest.h5", numpy.bytes_(b"0.1.0"), libver="latest")
    checkpoint(path / "packed.h5", numpy.bytes_(b"0.1.0"), chunks=(2,), compression="gzip")


studies(place("study_files"))
csv_traces(place("csv_traces"))
hdf5_traces(place("hdf5_traces"))
checkpoints(place("checkpoints"))
