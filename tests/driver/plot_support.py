# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of vti-plot share: calling it, and looking at what it drew or said. Ends the test with status 77
(skipped) where Python lacks what the program needs."""
import contextlib
import importlib
import io
import os
import struct
import subprocess
import sys
import tempfile
import types
from importlib.machinery import SourceFileLoader

try:
    import h5py
    import matplotlib  # noqa: F401
    import numpy  # noqa: F401
    import PIL  # noqa: F401
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

EPS = 2.0**-52
FINE, COARSE = 150, 50  # dots per inch: as users have them, and for pictures that are compared with each other only
sys.dont_write_bytecode = True


def plot(program, *given, dpi=COARSE, only=None):
    """vti-plot within this process, which takes a second less than by itself; where that may matter there is apart().
    only: no other pictures than these."""
    loader = SourceFileLoader("vti_plot", program)
    module = types.ModuleType(loader.name)
    module.__file__ = program
    loader.exec_module(module)
    for pictures in module.PICTURES.values():
        for name in set(pictures) - set(only or pictures):
            del pictures[name]
    return called(module, program, *given, dpi=dpi)


def apart(program, *given, **environment):
    return subprocess.run([sys.executable, program, *given], capture_output=True, text=True, check=False, env={**os.environ, **environment})


def called(module, *argv, dpi=COARSE):
    """main() of a program with these arguments: its code and what it says."""
    said, complained, before = io.StringIO(), io.StringIO(), sys.argv
    style = importlib.import_module("plot.style")
    sys.argv, style.DPI = list(argv), dpi
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(complained):
        try:
            code = module.main()
        except SystemExit as end:
            code = end.code
            if isinstance(code, str):
                print(code, file=sys.stderr)
                code = 1
    sys.argv = before
    return types.SimpleNamespace(returncode=code or 0, stdout=said.getvalue(), stderr=complained.getvalue())


def picture(path, narrowest, dpi=FINE):
    """The bytes of a PNG, checked: signature, width and weight."""
    with open(path, "rb") as file:
        content = file.read()
    assert content[:8] == b"\x89PNG\r\n\x1a\n", f"{path} is no PNG"
    width, height = struct.unpack(">II", content[16:24])
    assert narrowest <= width * FINE / dpi <= 1610 and height * FINE / dpi >= 400, f"{path} is {width} x {height}"
    assert len(content) < 300_000, f"{path} has {len(content)} bytes"
    return content


def draws(program, source, folder, pictures, narrowest, **options):
    """The pictures' bytes, which are all that there is in the folder, and what was said."""
    done = plot(program, source, "-o", folder, **options)
    assert done.returncode == 0 and done.stderr == "", f"{source}: {done.stderr}"
    assert sorted(os.listdir(folder)) == sorted(pictures), f"{source}: {os.listdir(folder)}"
    return [picture(os.path.join(folder, name), narrowest, options.get("dpi", COARSE)) for name in pictures], done.stdout


def refuses(program, source, *words, options=()):
    """Status 1, nothing on stdout, one line that names the file, the problem and a remedy."""
    done = plot(program, source, *options)
    line = done.stderr
    assert done.returncode == 1 and done.stdout == "", f"{source}: status {done.returncode}, {done.stdout}{line}"
    assert line.startswith("vti-plot: ") and line.count("\n") == 1 and ";" in line, f"{source}: {line}"
    for word in words:
        assert word in line, f"{source}: no '{word}' in: {line}"


def refuses_damage(program, path, write, gone, attributes, replaced):
    """A file that write makes, and of which parts are missing, cut off, or replaced by others: (dataset, values or
    None, words)."""
    refuses(program, path, path, "no such file")
    write(path)
    with open(path, "rb") as file:
        whole = file.read()
    for part in (len(whole) // 2, len(whole) - 1):
        with open(path, "wb") as file:
            file.write(whole[:part])
        refuses(program, path, path, "truncated")
    for name, values, word in [(name, None, "lacks") for name in gone] + replaced:
        write(path)
        with h5py.File(path, "a") as file:
            del file[name]
            if values is not None:
                file[name] = values
        refuses(program, path, word, "/" + name if values is None else "")
    for name in attributes:
        write(path)
        with h5py.File(path, "a") as file:
            del file.attrs[name]
        refuses(program, path, path, "lacks attribute " + name)
    folder = os.path.dirname(path)
    assert not [name for name in os.listdir(folder) if name.endswith((".png", ".part"))], os.listdir(folder)


def left_alone(program, *given):
    """Its reader goes away before it has said anything, as `head` does; 0 and no word about it."""
    with subprocess.Popen([sys.executable, program, *given], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True) as process:
        process.stdout.close()
        said = process.stderr.read()
    assert process.returncode == 0 and said == "", f"{given}: status {process.returncode}, {said}"


def main(*tests):
    """Each test gets the program's path and a folder of its own."""
    if len(sys.argv) != 2:
        sys.exit(f"usage: {os.path.basename(sys.argv[0])} VTI-PLOT")
    sys.path.insert(0, os.path.dirname(os.path.abspath(sys.argv[1])))
    for test in tests:
        with tempfile.TemporaryDirectory() as folder:
            test(os.path.abspath(sys.argv[1]), folder)
        print(f"{test.__name__}: ok")
