#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What vti-run and vti-study replace: results of theirs, and nothing else of anybody's; links are followed, names that
a program
writes under in the meantime are not.      test_overwrite.py VTI_RUN VTI_STUDY SCENES"""
import os
import shutil
import subprocess
import sys
import tempfile
import time

import h5py

from programs import contents, holds, one_line, run
from tally import check, conclude

RUN, STUDY, SCENES = map(os.path.abspath, sys.argv[1:4])
BODIES = "x,y,z,vx,vy,vz\n0,0,0,1,0,0\n2,0,0,0,0,0\n"
BONDS = "i,j\n0,1\n"
TABLE = "bodies: {table: %s, mass: 1}\nh: 1/64\nt_end: 1\n"
SPIN = [f"{SCENES}/spin.yaml", "--t-end", "1"]
# as LAMMPS writes it with "dump_modify time yes"
LAMMPS = ("ITEM: TIME\n0\nITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS ff ff ff\n"
          + 3 * "-5.0000000000000000e-01 5.0000000000000000e-01\n" + "ITEM: ATOMS id type x y z \n1 1 0 0 0 \n")


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", encoding="ascii") as file:
        file.write(text)


def refused(what, folder, words, *command):
    """In one line, and nothing in the folder has changed."""
    before = contents(folder)
    result = run(*command, cwd=folder)
    check(one_line(result, *words), f"{what}: {result.stderr.strip()}")
    check(contents(folder) == before, "... and all that was there is as it was")


def own_inputs(base):
    """The table that a run reads, under the names of its outputs, by links and hard links too, and of what is kept
    while it runs; --force is no help."""
    write(f"{base}/chain.csv", BODIES)
    write(f"{base}/chain.yaml", "name: chain\n" + TABLE % "chain.csv")
    for force in ([], ["--force"]):
        refused(f"name: chain, table: chain.csv {force}", base, ["chain.csv", "table of bodies", "-o"], RUN, "chain.yaml", *force)
    write(f"{base}/tw.csv", BODIES)
    write(f"{base}/tw.yaml", TABLE % "tw.csv")
    refused("-o tw.h5 beside tw.csv", base, ["tw.csv", "table of bodies"], RUN, "tw.yaml", "-o", "tw.h5")
    os.symlink("tw.csv", f"{base}/soft.csv")
    os.link(f"{base}/tw.csv", f"{base}/hard.csv")
    for name in ("soft", "hard"):
        refused(f"a {name} link to it", base, ["tw.csv", "table of bodies"], RUN, "tw.yaml", "-o", f"{name}.h5")
    write(f"{base}/b.dump", BONDS)
    write(f"{base}/b.yaml", "binder: {axial: 1, table: b.dump}\n" + TABLE % "tw.csv")
    refused("bonds", base, ["b.dump", "table of bonds"], RUN, "b.yaml", "-o", "b.h5")
    write(f"{base}/s.xdmf", TABLE % "tw.csv")
    refused("the scene itself", base, ["s.xdmf", "the scene"], RUN, "s.xdmf", "-o", "s.h5")
    write(f"{base}/p.csv.part", BODIES)
    write(f"{base}/p.yaml", TABLE % "p.csv.part")
    refused("under the name that is written meanwhile", base, ["table of bodies"], RUN, "p.yaml", "-o", "p.h5")
    for ending in ("run", "run-journal", "run-wal", "run-shm"):
        write(f"{base}/w.{ending}", TABLE % "tw.csv")
        refused(f"the scene as w.{ending}", base, [f"w.{ending}", "the scene", "kept", "-o"], RUN, f"w.{ending}", "-o", "w.h5", "--force")
        os.remove(f"{base}/w.{ending}")
        write(f"{base}/w.{ending}", BODIES)
        write(f"{base}/w.yaml", TABLE % f"w.{ending}")
        refused(f"a table as w.{ending}", base, ["table of bodies", "kept"], RUN, "w.yaml", "-o", "w.h5")
        os.remove(f"{base}/w.{ending}")
    write(f"{base}/study/study.journal-journal", BODIES)
    write(f"{base}/sj.yaml", TABLE % "study/study.journal-journal")
    refused("vti-study", f"{base}/study", ["study.journal-journal", "table of bodies", "kept"], STUDY, "../sj.yaml", "-o", ".",
            "--h", "1/64")
    write(f"{base}/study/study.csv", BODIES)
    write(f"{base}/st.yaml", TABLE % "study/study.csv")
    refused("vti-study", f"{base}/study", ["study.csv", "table of bodies"], STUDY, "../st.yaml", "-o", ".", "--h", "1/64", "--force")
    write(f"{base}/cost/errors.csv", BODIES)
    write(f"{base}/co.yaml", TABLE % "cost/errors.csv")
    refused("vti-study --cost", f"{base}/cost", ["errors.csv", "table of bodies"], STUDY, "--cost", "../co.yaml@1", "-o", ".")
    write(f"{base}/sweep/first.csv", BODIES)
    write(f"{base}/sweep/sw.yaml", TABLE % "first.csv")
    for name in ("study.csv", "study.h5.part"):
        write(f"{base}/sweep/{name}", BODIES)
        refused("a swept table", f"{base}/sweep", [name, "table of bodies"], STUDY, "sw.yaml", "-o", ".", "--h", "1/64", "--force",
                "--sweep", f"bodies.table=first.csv,{name}")
        os.remove(f"{base}/sweep/{name}")


def foreign(base):
    """Files that are no results of vti are replaced with --force only; results are replaced, those of vti-study too."""
    for name, text in (("o.h5", "text"), ("o.csv", BODIES), ("o.xdmf", "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n"),
                       ("o.dump", LAMMPS)):
        folder = f"{base}/{name}"
        write(f"{folder}/{name}", text)
        refused(f"somebody's {name}", folder, [name, "--force"], RUN, *SPIN, "-o", "o.h5")
        if name == "o.dump":
            result = run(RUN, *SPIN, "-o", f"{folder}/o.h5", "--no-dump")
            check(result.returncode == 0 and contents(folder)["o.dump"] == LAMMPS.encode(), "--no-dump lets it be")
        result = run(RUN, *SPIN, "-o", f"{folder}/o.h5", "--force")
        whole = contents(folder)
        check(result.returncode == 0 and len(whole) == 4 and whole[name] != text.encode(), "... --force replaces it")
        result = run(RUN, *SPIN, "-o", f"{folder}/o.h5", "--t-end", "2")
        check(result.returncode == 0 and contents(folder).keys() == whole.keys() and contents(folder)[name] != whole[name],
              "... and what is ours is replaced by the next run")
        result = run(RUN, *SPIN, "-o", f"{folder}/o.h5", "--no-dump")
        check(result.returncode == 0 and "o.dump" not in contents(folder), "... whose --no-dump takes our dump away")
    os.mkdir(f"{base}/hdf5")
    with h5py.File(f"{base}/hdf5/o.h5", "w") as file:
        file["bodies/x"] = [1.0]
    refused("somebody's HDF5 file", f"{base}/hdf5", ["o.h5", "--force"], RUN, *SPIN, "-o", "o.h5")
    os.makedirs(f"{base}/folder/o.csv")
    refused("a folder", f"{base}/folder", ["o.csv", "is no file"], RUN, *SPIN, "-o", "o.h5", "--force")
    check(one_line(run(STUDY, "--no-plot", "-o", "", *SPIN), "-o: '' is no folder; name one"), "... the empty name is none")
    os.mkdir(f"{base}/empty")
    open(f"{base}/empty/o.h5", "w", encoding="ascii").close()
    check(run(RUN, *SPIN, "-o", f"{base}/empty/o.h5").returncode == 0, "in an empty file nothing is lost")
    studies = [([], ("study.h5", "study.csv", "timing.csv")),
               (["--cost", "--evals", "64", "--repeats", "1", "--t-end", "1"], ("cost.csv", "errors.csv", "prices.csv", "machine.txt"))]
    for options, names in studies:
        folder = f"{base}/study{len(options)}"
        arguments = [STUDY, "--no-plot"] * (not options) + [STUDY, *options] * bool(options)
        arguments += ["--h", "1/64", "--steppers", "vti2", "-o", folder, f"{SCENES}/pendulum.yaml"]
        for name in names:
            os.makedirs(folder, exist_ok=True)
            before = contents(folder)
            write(f"{folder}/{name}", "mine\n")
            result = run(*arguments)
            check(one_line(result, name, "--force") and contents(folder) == {**before, name: b"mine\n"},
                  f"somebody's {name}: {result.stderr.strip()}")
            check(run(*arguments, "--force").returncode == 0 and set(contents(folder)) == set(names), "... --force replaces it")
            check(run(*arguments).returncode == 0, "... and what is ours is replaced")


def pictures(base):
    """Somebody's pictures stay where there is no study of ours that they could be of."""
    common = ["--h", "1/64,1/128", "--t-end", "1", "--steppers", "vti2", "-o", ".", f"{SCENES}/pendulum.yaml"]
    sweep = ["--sweep", "bodies.inertia=1,2", *common]
    for name, arguments in (("convergence.png", common), ("invariants.png", common), ("ensemble.png", sweep)):
        folder = f"{base}/{name}"
        write(f"{folder}/{name}", "mine\n")
        refused(f"somebody's {name}", folder, [name, "--force", "--no-plot"], STUDY, *arguments)
        result = run(STUDY, "--no-plot", *arguments, cwd=folder)
        check(result.returncode == 0 and contents(folder)[name] == b"mine\n", "... --no-plot lets it be")
        for left in ("study.h5", "study.csv", "timing.csv"):
            os.remove(f"{folder}/{left}")
        result = run(STUDY, "--force", *arguments, cwd=folder)
        drawn = contents(folder)[name]
        check(result.returncode == 0 and drawn[:4] == b"\x89PNG", f"... --force replaces it {result.stderr}")
        write(f"{folder}/{name}", "of an earlier study\n")
        check(run(STUDY, *arguments, cwd=folder).returncode == 0 and contents(folder)[name] == drawn, "... and a study's own are drawn anew")


def meanwhile(base):
    """Names that files have for a while are somebody's too, unless a run that was interrupted has left them."""
    for name in ("o.h5.part", "o.csv.part", "o.xdmf.part", "o.dump.part", "o.run-journal", "o.run-wal", "o.run-shm"):
        folder = f"{base}/{name}"
        write(f"{folder}/{name}", "precious\n")
        refused(f"somebody's {name}", folder, [name, "move it away", "-o"], RUN, *SPIN, "-o", "o.h5")
        os.mkdir(f"{folder}/sub")
        os.mkdir(f"{folder}/sub/{name}")
        refused("... a folder", f"{folder}/sub", [name, "-o"], RUN, *SPIN, "-o", "o.h5", *["--force"] * name.endswith("part"))
        if name.endswith("part"):
            result = run(RUN, *SPIN, "-o", f"{folder}/o.h5", "--force")
            check(result.returncode == 0 and name not in contents(folder), "... --force replaces it")
    for name in ("study.csv.part", "study.journal-journal", "study.journal-wal"):
        write(f"{base}/study{name}/{name}", "precious\n")
        refused(f"somebody's {name}", f"{base}/study{name}", [name, "move it away"], STUDY, "--no-plot", "--h", "1/64", "--steppers",
                "vti2", "-o", ".", f"{SCENES}/pendulum.yaml")
    long = [RUN, SPIN[0], "--t-end", "1e5", "--checkpoint", "0.01", "-o", "o.h5"]
    os.mkdir(f"{base}/killed")
    with subprocess.Popen(long, cwd=f"{base}/killed", stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        while process.poll() is None and not holds(f"{base}/killed/o.run"):
            time.sleep(0.001)
        process.kill()
    resume = [*long, "--resume"]
    write(f"{base}/killed/o.csv.part", "precious\n")
    refused("beside a run that was interrupted", f"{base}/killed", ["o.csv.part", "move it away"], *resume)
    write(f"{base}/killed/o.csv.part", "t,kin")
    write(f"{base}/killed/o.h5.part", 4096 * "\0")
    write(f"{base}/killed/o.run-wal", "precious\n")
    refused("... and what it never writes", f"{base}/killed", ["o.run-wal", "move it away"], *resume)
    os.remove(f"{base}/killed/o.run-wal")
    journal = f"{base}/killed/o.run-journal"
    if not os.path.exists(journal) or os.path.getsize(journal) == 0:
        write(journal, "precious\n")
        refused("... and a journal that is none", f"{base}/killed", ["o.run-journal", "move it away"], *resume)
        os.remove(journal)
    with subprocess.Popen(resume, cwd=f"{base}/killed", stdout=subprocess.PIPE, text=True) as process:
        line = next((line for line in process.stdout if "goes on from" in line), "")
        process.kill()
    check(line != "", "what was half written when it was killed is no hindrance")


def spheres(base):
    """A run whose own output is called as another's file of spheres is no such file: neither replaced, nor taken
    away."""
    write(f"{base}/c.yaml", "bodies: {clumps: {spheres: [[0, 0, 0, 1], [1, 0, 0, 1]]}, mass: 1, x: [0, 0, 0], v: [1, 0, 0]}\n"
          "h: 1/64\nt_end: 1\n")
    check(run(RUN, *SPIN, "-o", f"{base}/a-spheres.h5").returncode == 0, "a run that is called a-spheres")
    refused("... is in the way", base, ["a-spheres.h5", "--force"], RUN, "c.yaml", "-o", "a.h5")
    before = contents(base)
    check(run(RUN, *SPIN, "-o", f"{base}/a.h5").returncode == 0 and before.items() <= contents(base).items(), "... and stays there")
    check(run(RUN, f"{base}/c.yaml", "-o", f"{base}/b.h5").returncode == 0 and "b-spheres.h5" in contents(base), "clumps have spheres")
    check(run(RUN, *SPIN, "-o", f"{base}/b.h5").returncode == 0 and "b-spheres.h5" not in contents(base),
          "... which go with them")


def contacts(base):
    """Likewise: OUT-contacts.h5 is one of the files of a run with --contacts, and goes with the next run without."""
    touching = [f"{SCENES}/pile.yaml", "--t-end", "1/64"]
    check(run(RUN, *touching, "-o", f"{base}/a-contacts.h5").returncode == 0, "a run that is called a-contacts")
    refused("... is in the way", base, ["a-contacts.h5", "--force"], RUN, *touching, "--contacts", "-o", "a.h5")
    before = contents(base)
    check(run(RUN, *touching, "-o", f"{base}/a.h5").returncode == 0 and before.items() <= contents(base).items(), "... and stays there")
    for more, there in (["--contacts"], True), (["--contacts"], True), ([], False):
        result = run(RUN, *touching, *more, "-o", f"{base}/b.h5")
        check(result.returncode == 0 and ("b-contacts.h5" in contents(base)) == ("-contacts.h5" in result.stdout) == there,
              f"{' '.join(more) or 'without'}: the file of contacts is {'there' if there else 'taken away'}")


def links(base):
    """An output that is a link stays one, and the file that it leads to is written; not so the name that is written
    meanwhile."""
    os.makedirs(f"{base}/far")
    for ending in ("h5", "csv", "xdmf", "dump"):
        os.symlink(f"far/real.{ending}", f"{base}/out.{ending}")
        write(f"{base}/victim.{ending}", "mine\n")
        os.symlink(f"victim.{ending}", f"{base}/far/real.{ending}.part")
    result = run(RUN, *SPIN, "-o", f"{base}/out.h5")
    check(one_line(result, "real.h5.part", "move it away", "--force") and os.path.islink(f"{base}/far/real.h5.part"),
          f"planted links are somebody's: {result.stderr.strip()}")
    for inertia in (1, 2):
        result = run(RUN, *SPIN, "--set", f"bodies.inertia={inertia}", "-o", f"{base}/out.h5", "--force")
        run(RUN, *SPIN, "--set", f"bodies.inertia={inertia}", "-o", f"{base}/plain/out.h5")
        far, plain = contents(f"{base}/far"), contents(f"{base}/plain")
        check(result.returncode == 0 and all(os.path.islink(f"{base}/{name}") for name in plain) and
              {name.replace("real", "out"): data for name, data in far.items()} == plain, "four links are followed, and stay")
    check(all(contents(base)[f"victim.{ending}"] == b"mine\n" for ending in ("h5", "csv", "xdmf", "dump")),
          "planted links are not written through")
    for ending in ("csv", "xdmf"):
        os.symlink("victim.h5", f"{base}/two.{ending}")
    refused("two outputs that are one file", base, ["two.xdmf", "same file", "two.csv"], RUN, *SPIN, "-o", "two.h5", "--force")
    os.mkdir(f"{base}/more")
    os.symlink("nowhere/out.h5", f"{base}/more/lost.h5")
    refused("a link to a folder that is not there", base, ["lost.h5", "nowhere", "remove that link"], RUN, *SPIN, "-o", "more/lost.h5")
    os.symlink("round.h5", f"{base}/more/round.h5")
    refused("a link to itself", base, ["round.h5", "links"], RUN, *SPIN, "-o", "more/round.h5")


def planted(base):
    """Both outputs as links to one file, under the names that are written meanwhile."""
    write(f"{base}/one", "mine\n")
    for ending in ("h5", "csv"):
        os.symlink("one", f"{base}/out.{ending}.part")
    result = run(RUN, *SPIN, "-o", f"{base}/out.h5", "--force")
    run(RUN, *SPIN, "-o", f"{base}/plain/out.h5")
    there = contents(base)
    check(result.returncode == 0 and there.pop("one") == b"mine\n" and there.pop("plain") is None and
          there == contents(f"{base}/plain"), "two planted links: each output is a file of its own, and the links' is untouched")


def protected(base):
    """A result that is write-protected, or that another program writes to, is kept, unless --force is given; so is one
    that would be taken away."""
    for name in ("o.csv", "o.dump"):
        folder = f"{base}/{name}"
        run(RUN, *SPIN, "-o", f"{folder}/o.h5")
        os.chmod(f"{folder}/{name}", 0o444)
        refused(f"a protected {name}", folder, [name, "write-protected", "--force", "-o"], RUN, *SPIN, "--t-end", "2", "-o", "o.h5")
        before = contents(folder)
        result = run(RUN, *SPIN, "--t-end", "2", "-o", f"{folder}/o.h5", "--force")
        check(result.returncode == 0 and contents(folder)[name] != before[name], "... --force replaces it")
    os.chmod(f"{base}/o.dump/o.dump", 0o444)
    result = run(RUN, *SPIN, "--no-dump", "-o", f"{base}/o.dump/o.h5")
    check(result.returncode == 0 and "o.dump" in contents(f"{base}/o.dump"), "... --no-dump does not take it away")
    with h5py.File(f"{base}/o.dump/o.h5", "a"):
        refused("a result that another program writes to", f"{base}/o.dump", ["o.h5", "another program", "--force", "-o"], RUN, *SPIN, "-o", "o.h5")
        refused("... with --resume", f"{base}/o.dump", ["o.h5", "another program", "without --resume", "-o"], RUN, *SPIN, "-o", "o.h5",
                "--resume", "--force")
    write(f"{base}/table/t.yaml", TABLE % "t.h5")
    with h5py.File(f"{base}/table/t.h5", "w") as file:
        for name in ("x", "y", "z"):
            file[f"bodies/{name}"] = [1.0]
        file.flush()
        for program in ([RUN], [STUDY, "--no-plot"]):
            refused("a table that another program writes to", f"{base}/table", ["t.h5", "another program", "close it there", "CSV"],
                    *program, "t.yaml")


def rights(base):
    """Of one who is not root: what cannot be written or replaced at the end is refused at the start, and what can be is
    written."""
    other = {"user": 65534, "group": 65534, "extra_groups": []} if os.geteuid() == 0 else {}
    os.chmod(base, 0o755)
    program, scene = (shutil.copy(path, base) for path in (RUN, SPIN[0]))  # others may not go where they come from

    def by(*command):
        return run(program, scene, *SPIN[1:], *command, cwd=base, **other)
    for name, mode in (("far", 0o777), ("near", 0o777), ("drop", 0o733), ("shared", 0o1777), ("mine", 0o777)):
        os.mkdir(f"{base}/{name}")
        os.chmod(f"{base}/{name}", mode)
    check(by("-o", "far/out.h5").returncode == 0, "a run of one who is not root")
    for ending in ("h5", "csv", "xdmf", "dump"):
        os.symlink(f"../far/out.{ending}", f"{base}/near/out.{ending}")
    os.chmod(f"{base}/far", 0o555)
    before = contents(f"{base}/far"), contents(f"{base}/near")
    result = by("-o", "near/out.h5", "--t-end", "2")
    check(one_line(result, "near/out.h5", "far", "Permission denied", "remove that link") and result.stdout == "" and
          before == (contents(f"{base}/far"), contents(f"{base}/near")), f"links into a folder that is read-only: {result.stderr.strip()}")
    os.chmod(f"{base}/far", 0o755)
    by("-o", "mine/out.h5")
    os.chmod(f"{base}/mine/out.h5", 0)
    result = by("-o", "mine/out.h5")
    check(one_line(result, "mine/out.h5", "Permission denied", "--force"), f"a result that one may not read: {result.stderr.strip()}")
    with subprocess.Popen([program, scene, "--t-end", "2e4", "-o", "mine/slow.h5"], cwd=base, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, **other) as process:
        process.stdout.readline()
        os.chmod(f"{base}/mine", 0o555)
        error = process.communicate()[1].strip()
    check(process.returncode == 1 and "mine/slow.h5.part" in error and "Permission denied" in error,
          f"a folder that becomes read-only while a run goes: {error}")
    os.chmod(f"{base}/mine", 0o755)
    if other:
        run(RUN, *SPIN, "-o", f"{base}/shared/out.h5")
        result = by("-o", "shared/out.h5", "--t-end", "2", "--force")
        check(one_line(result, "shared/out.h5", "another user's", "-o") and result.stdout == "" and len(contents(f"{base}/shared")) == 4,
              f"another's files in a folder like /tmp: {result.stderr.strip()}")
        result = by("-o", "drop/out.h5")
        check(result.returncode == 0 and contents(f"{base}/drop") == contents(f"{base}/far"),
              f"into a folder that one may write to and not read: {result.stderr.strip()}")


for topic in (own_inputs, foreign, pictures, meanwhile, spheres, contacts, links, planted, protected, rights):
    with tempfile.TemporaryDirectory() as root:
        topic(root)
conclude()
