# SPDX-License-Identifier: BSD-3-Clause
"""Reading HDF5 so that every way in which it can fail becomes one sentence. study_file and run_file say what should be
in a file; what is common to both is here."""
import os
from contextlib import contextmanager

import h5py
import numpy as np

from .trouble import Trouble

SWEEP, STUDY, RUN, NETWORK = "sweep", "study", "run", "network"
WRITER = {SWEEP: "vti-study", STUDY: "vti-study", RUN: "vti-run", NETWORK: "vti-run"}
GROUPS = {SWEEP: ("ensemble", "sweep"), STUDY: ("runs", "orders", "series"), RUN: ("energies", "VTKHDF")}
CHECKPOINT = ".run"     # beside the place of OUT.h5 as long as a run is not complete
GO_ON = "the run is not complete: the vti-run that began it ends it with --resume, and writes OUT.h5"


def kind(path):
    """SWEEP, STUDY, RUN or NETWORK, by what the file holds: a file may be called anything."""
    with opened(path) as file:
        if "spheres_of" in file.attrs:
            raise Trouble(path, "holds the spheres of a run", "give OUT.h5")
        if "contacts_of" in file.attrs:
            return NETWORK
        found = [kind for kind, groups in GROUPS.items() if any(group in file for group in groups)]
    if not found:
        raise Trouble(path, "holds neither a study nor a run", "give the study.h5 of vti-study or the out.h5 of vti-run")
    return found[0]


def write_anew(kind):
    return f"write it anew with the {WRITER[kind]} of this version"


@contextmanager
def opened(path):
    """The file, with every way in which HDF5 can fail put into words. A damaged file fails in reading, too, and h5py
    then raises almost any exception: what is not ours to explain is therefore taken for damage."""
    if os.path.isdir(path):
        raise Trouble(path, "is a folder", "give the HDF5 file inside it")
    try:
        with open(path, "rb"):
            pass
    except FileNotFoundError:
        raise Trouble(path, "no such file", GO_ON if os.path.isfile(os.path.splitext(path)[0] + CHECKPOINT) else
                      "run vti-study or vti-run first, or correct the path") from None
    except OSError as error:
        raise Trouble(path, f"cannot be read ({error.strerror})", "make it readable, or correct the path") from None
    if not h5py.is_hdf5(path):
        if os.path.splitext(path)[1] == CHECKPOINT:
            raise Trouble(path, "is not an HDF5 file", GO_ON)
        raise Trouble(path, "is not an HDF5 file", "give the study.h5 of vti-study or the out.h5 of vti-run")
    try:
        with h5py.File(path, "r") as file:
            yield file
    except Trouble:
        raise
    except Exception as error:  # see above
        if any(sign in str(error) for sign in ("unable to lock", "already open")):
            raise Trouble(path, "is still being written", "wait until its writer has finished") from None
        problem = "is truncated" if "truncated" in str(error) else "is damaged"
        raise Trouble(path, problem, "write it anew, or restore the file from a copy") from None


class Reader:
    """An open file and the remedy for what it lacks. Names are full paths, as in messages: /runs/h."""

    def __init__(self, path, file, kind):
        self.path, self.file, self.remedy = path, file, write_anew(kind)

    def trouble(self, problem):
        return Trouble(self.path, problem, self.remedy)

    def group(self, name):
        if not isinstance(self.file.get(name), h5py.Group):
            raise self.trouble(f"lacks group {name}")
        return self.file[name]

    def dataset(self, name, dimensions=1):
        dataset = self.file.get(name)
        if not isinstance(dataset, h5py.Dataset):
            raise self.trouble(f"lacks dataset {name}")
        if dataset.ndim != dimensions:
            raise self.trouble(f"dataset {name} is not {('zero', 'one', 'two')[dimensions]}-dimensional")
        return dataset

    def numbers(self, name, dimensions=1, rows=slice(None)):
        dataset = self.dataset(name, dimensions)
        if dataset.dtype.kind not in "fiu":
            raise self.trouble(f"dataset {name} does not hold numbers")
        return dataset[rows].astype(float)

    def finite(self, name, dimensions=1, rows=slice(None)):
        numbers = self.numbers(name, dimensions, rows)
        if not np.all(np.isfinite(numbers)):
            raise self.trouble(f"dataset {name} has a number that is not finite")
        return numbers

    def texts(self, name):
        return np.array([text(value) for value in self.dataset(name)[()]], dtype=object)

    def attribute(self, name, holder=None):
        holder = self.file if holder is None else holder
        if name not in getattr(holder, "attrs", ()):
            raise self.trouble(f"lacks attribute {name} of {holder.name}")
        return np.ravel(holder.attrs[name])[0]  # a C program may as well write a vector of one

    def number(self, name, holder=None):
        value = self.attribute(name, holder)
        if np.asarray(value).dtype.kind not in "fiu":
            raise self.trouble(f"attribute {name} of {'/' if holder is None else holder.name} is not a number")
        return float(value)

    def same_lengths(self, columns, where):
        """columns: name -> values. One sentence about the shortest if they differ."""
        lengths = {name: len(values) for name, values in columns.items()}
        if len(set(lengths.values())) > 1:
            short, long = min(lengths, key=lengths.get), max(lengths, key=lengths.get)
            raise self.trouble(f"{where}/{short} has {lengths[short]} rows, but {long} has {lengths[long]}")


def text(value):
    """Fixed or variable length, ASCII or UTF-8: h5py hands out bytes for some of these and str for others."""
    value = np.ravel(value)[0] if isinstance(value, np.ndarray) else value
    decoded = value.decode("utf-8", "replace") if isinstance(value, bytes) else str(value)
    return decoded.rstrip("\0 ")
