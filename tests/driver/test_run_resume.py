#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vti-run that is killed, stopped, out of space or misused: what it had is kept, --resume ends with the same bytes, and
every refusal is one line.      test_run_resume.py VTI_RUN SCENES"""
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

import h5py

import programs
from programs import run
from run_support import contents, read_csv, read_vtkhdf, read_xdmf, same
from tally import check, conclude

RUN, SCENES = map(os.path.abspath, sys.argv[1:3])
RESUME = 75
KILLS = 5


def scene(name):
    return os.path.join(SCENES, name + ".yaml")


def size_of(path):
    return os.path.getsize(path) if os.path.exists(path) else 0


def one_line(result, *words):
    lines = result.stderr.splitlines()
    return len(lines) == 1 and lines[0].startswith("vti-run: ") and all(word in lines[0] for word in words)


def killed(arguments, seconds):
    """Starts a run and kills it after so many seconds; False if it had ended by itself."""
    with subprocess.Popen([RUN, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
        time.sleep(seconds)
        process.kill()
        return process.wait() == -signal.SIGKILL


def kills(base, name, *options):
    """SIGKILL at random moments, some of them of a run that has been resumed; then the run is resumed to its end."""
    arguments = [scene(name), *options]
    begin = time.monotonic()
    run(RUN, *arguments, "-o", f"{base}/whole/out.h5")
    duration = time.monotonic() - begin
    whole = contents(f"{base}/whole/out")
    done, tries, same, left, gone_on = 0, 0, 0, 0, 0
    while (done < KILLS or gone_on == 0) and tries < 50 * KILLS:
        tries += 1
        folder = f"{base}/killed{tries}"
        again = [*arguments, "--checkpoint", "0.03", "-o", f"{folder}/out.h5", "--resume"]
        if not killed(again, random.uniform(0, 1.1 * duration)):
            continue
        done += 1
        while random.random() < 0.5:
            killed(again, random.uniform(0, 1.1 * duration))
        last = run(RUN, *again)
        gone_on += "goes on from" in last.stdout
        same += last.returncode == 0 and contents(f"{folder}/out") == whole
        left += len(os.listdir(folder)) != len(whole)
        shutil.rmtree(folder)
    check(None not in whole.values() and done == same >= KILLS,
          f"{name}: killed {done} times, resumed {same} times to the same bytes")
    check(left == 0, "... and nothing is left behind")
    check(gone_on > 0, f"... {gone_on} times from a checkpoint")


SIGNALS = (signal.SIGTERM, signal.SIGUSR1, signal.SIGINT, signal.SIGHUP, signal.SIGXCPU)


def as_usual(number):
    """Whatever the shell or nohup wants that the tests were started from."""
    signal.signal(number, signal.SIG_DFL)


def signals_before(base):
    """Before the first step they simply end the program, while it waits for its scene too, and leave nothing."""
    os.mkfifo(f"{base}/scene.yaml")
    for number in SIGNALS:
        with subprocess.Popen([RUN, f"{base}/scene.yaml"], cwd=base, preexec_fn=lambda: as_usual(number)) as process:
            time.sleep(0.2)  # too early is well too
            process.send_signal(number)
            try:
                code = process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                code = "none"
        check(code == -number and os.listdir(base) == ["scene.yaml"], f"a FIFO as scene, {number.name}: code {code}")
    with subprocess.Popen([RUN, scene("torus"), "--t-end", "1", "-o", f"{base}/hup/out.h5"], stdout=subprocess.DEVNULL,
                          preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_IGN)) as process:
        while process.poll() is None and not os.path.exists(f"{base}/hup/out.run"):
            time.sleep(0.0005)
        process.send_signal(signal.SIGHUP)
        check(process.wait() == 0, "under nohup a SIGHUP is ignored")


def failed_starts(base):
    """They say why, leave nothing, and do not touch an earlier run's files."""
    for name, text in (("velocity", "{x: [0, 0, 0], v: [1e200, 0, 0], mass: 1}"), ("energy", "{x: [0, 0, 0], v: [1e150, 0, 0], mass: 1e100}"),
                       ("momentum", "{x: [9e153, 0, 0], v: [0, 1e153, 0], mass: 100}")):
        with open(f"{base}/{name}.yaml", "w", encoding="ascii") as file:
            file.write(f"bodies: {text}\nh: 0.1\nt_end: 1\n")
        run(RUN, scene("spin"), "-o", f"{base}/{name}/out.h5")
        earlier = contents(f"{base}/{name}/out")
        for more in ([], ["--checkpoint", "1e-9"], ["--resume", "-o", f"{base}/none/out.h5"]):
            result = run(RUN, f"{base}/{name}.yaml", "-o", f"{base}/{name}/out.h5", *more)
            check(result.returncode == 1 and one_line(result, "the start (t = 0)", "smaller") and "reduce h" not in result.stderr,
                  f"too large {name}: {result.stderr.strip()}")
            check(contents(f"{base}/{name}/out") == earlier and len(os.listdir(f"{base}/{name}")) == 4, "... leaves all as it was")
    result = run(RUN, scene("spin"), "--h", "0.1", "--t-end", "0.05", "-o", f"{base}/short.h5")
    check(result.returncode == 1 and one_line(result, "h = 0.1", "t_end = 0.05", "smaller h"), f"no step: {result.stderr.strip()}")
    os.makedirs(f"{base}/mine/out.run/notes")
    result = run(RUN, scene("spin"), "-o", f"{base}/mine/out.h5")
    check(result.returncode == 1 and one_line(result, "out.run", "-o") and os.listdir(f"{base}/mine") == ["out.run"],
          f"somebody's folder: {result.stderr.strip()}")
    magic = bytes.fromhex("d9d505f920a163d7")  # of SQLite's journal, over zeros that are there before
    for dead, header in (("dead", b""), ("zeros", bytes(512)), ("torn", magic[:5] + bytes(507))):
        os.makedirs(f"{base}/{dead}")
        for name, start in (("out.run", b""), ("out.run-journal", header)):
            with open(f"{base}/{dead}/{name}", "wb") as file:
                file.write(start)
        result = run(RUN, scene("spin"), "-o", f"{base}/{dead}/out.h5")
        check(result.returncode == 0 and len(os.listdir(f"{base}/{dead}")) == 4,
              f"{dead}: one killed before its first checkpoint is no run to go on")


def one_stem(base):
    """out.h5 and out.hdf5 would share out.csv, out.xdmf and out.dump."""
    with subprocess.Popen([RUN, scene("torus"), "--t-end", "1000", "--checkpoint", "0.02", "-o", f"{base}/out.h5"],
                          stdout=subprocess.DEVNULL) as process:
        # before, the other one may be the first to lock it
        while process.poll() is None and size_of(f"{base}/out.run") == 0:
            time.sleep(0.0005)
        result = run(RUN, scene("torus"), "--t-end", "0.1", "-o", f"{base}/out.hdf5")
        check(result.returncode == 1 and one_line(result, "another vti-run"), f"two endings: {result.stderr.strip()}")
        process.kill()


def vanished(base):
    """The folder of a run goes while it runs: no space would help."""
    with subprocess.Popen([RUN, scene("torus"), "--t-end", "1000", "--checkpoint", "0.02", "-o", f"{base}/new/out.h5"],
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as process:
        while process.poll() is None and size_of(f"{base}/new/out.run") == 0:
            time.sleep(0.0005)
        os.rename(f"{base}/new", f"{base}/gone")
        words = process.communicate()[1]
    check(process.returncode == 1 and "vanished" in words and "space" not in words and words.count("\n") == 1,
          f"the folder has vanished: {words.strip()}")


def signals(base):
    """Signals in a run that would take hours: a checkpoint, one line, code 75; and it goes on to an end
    that is moved to 500 steps later."""
    options = [scene("torus"), "--stepper", "vti3-leapfrog", "--record", "8", "--frames", "64", "--checkpoint", "0.02"]
    for number in SIGNALS:
        stem = f"{base}/{number.name}/out"
        with subprocess.Popen([RUN, *options, "--t-end", "100000", "-o", stem + ".h5"], stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True, preexec_fn=lambda: as_usual(number)) as process:
            while process.poll() is None and size_of(stem + ".run") == 0:
                time.sleep(0.0005)
            process.send_signal(number)
            words = process.communicate()[1]
        check(process.returncode == RESUME and words.count("\n") == 1 and number.name in words and "--resume" in words,
              f"{number.name}: code {process.returncode}, {words.strip()}")
        check(not os.path.exists(stem + ".h5"), "... no file is half there")
        step = int(words.split("at step ")[1].split()[0]) if "at step " in words else 0
        ends = ["--t-end", f"{step + 500}/1000"]
        result = run(RUN, *options, *ends, "-o", stem + ".h5", "--resume")
        run(RUN, *options, *ends, "-o", f"{base}/whole/out.h5")
        check(result.returncode == 0 and (f"goes on from step {step}" in result.stdout) == (step > 0) and
              contents(stem) == contents(f"{base}/whole/out"), f"... and it goes on to the same bytes, step {step + 500}")


def stopped(arguments, seconds):
    """A run that SIGTERM is sent so many seconds after its first line, before which it hears none, and SIGKILL 20
    later: its code, and what it says on either stream."""
    with subprocess.Popen([RUN, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          preexec_fn=lambda: as_usual(signal.SIGTERM)) as process:
        first = process.stdout.readline()
        time.sleep(seconds)
        process.terminate()
        killer = threading.Timer(20, process.kill)
        killer.start()
        said, words = process.stdout.read(), process.stderr.read()
        killer.cancel()
    return process.returncode, first + said, words


def far_from_multiples(base):
    """Within a step of h of millions of shorter ones a run cannot end: a signal that comes again some seconds later
    ends it."""
    with subprocess.Popen([RUN, scene("spin"), "--stepper", "kl8", "--control", "integrating", "--set", "turning=2e-8", "--h", "4096",
                           "--t-end", "8192", "-o", f"{base}/out.h5"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
                          preexec_fn=lambda: as_usual(signal.SIGTERM)) as process:
        process.stdout.readline()
        for seconds in (0.2, 0.1, 6):  # twice at once, as launchers do
            time.sleep(seconds)
            waited = process.poll() is None
            process.terminate()
        killer = threading.Timer(20, process.kill)
        killer.start()
        process.wait()
        killer.cancel()
    check(waited and process.returncode == -signal.SIGTERM, f"a second signal: code {process.returncode}")


def between_rows(base):
    """Steps of variable length whose rows are hours apart: signals and checkpoints do not wait for them, and the bytes
    and what is said of the steps are those of a run that nobody stopped."""
    for number, case in enumerate((("srkn11", "--tolerance", "1e-12", "--errors"), ("srkn6", "--control", "integrating"),
                                   ("srkn6", "--control", "naive"))):
        stem, far = f"{base}/{number}/out", str(2**33)
        options = [scene("pendulum"), "--stepper", *case, "--h", "1/4", "--record", far, "--frames", far, "--checkpoint", "0.05"]
        endless, steps = [*options, "--t-end", "4e9", "-o", stem + ".h5"], []
        for _ in range(3):
            code, _, words = stopped([*endless, "--resume"], 0.25)
            steps.append(int(words.split("at step ")[1].split()[0]) if "at step " in words else 0)
            check(code == RESUME and (steps[-1] > max(steps[:-1], default=0)), f"{' '.join(case)}: code {code}, {words.strip()}")
            if code != RESUME:
                return
        killed([*endless, "--resume"], 0.4)
        code, said, words = stopped([*endless, "--resume"], 0.25)
        check(code == RESUME and int(said.split("goes on from step ")[1].split(",")[0]) > steps[-1], "... a checkpoint before SIGKILL, too")
        ends = ["--t-end", f"{int(words.split('at step ')[1].split()[0]) + 500}/4"]
        parts = run(RUN, *options, *ends, "-o", stem + ".h5", "--resume")
        whole = run(RUN, *options, *ends, "-o", f"{base}/whole{number}/out.h5")
        check(parts.returncode == whole.returncode == 0 and contents(stem) == contents(f"{base}/whole{number}/out"),
              f"... and it goes on to the same bytes {parts.stderr}")
        tallies = [[line for line in result.stdout.splitlines() if "force evaluations" in line] for result in (parts, whole)]
        check(tallies[0] == tallies[1] and tallies[0], f"... and the same steps: {tallies[0]}")


def with_limit(kilobytes):
    """A run whose files can only become so large, as on a disk that is full."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
        resource.setrlimit(resource.RLIMIT_FSIZE, (1024 * kilobytes, 1024 * kilobytes))
    return limit


def full_disk(base):
    options = [scene("torus"), "--t-end", "1"]
    run(RUN, *options, "-o", f"{base}/whole/out.h5")
    whole = contents(f"{base}/whole/out")
    run(RUN, scene("spin"), "-o", f"{base}/earlier/out.h5")
    earlier = contents(f"{base}/earlier/out")
    sizes = sorted(len(content) // 1024 for content in whole.values())
    for kilobytes in (1, sizes[2] - 1, sizes[3] - 1):
        folder = f"{base}/full{kilobytes}"
        shutil.copytree(f"{base}/earlier", folder)
        result = run(RUN, *options, "-o", f"{folder}/out.h5", preexec_fn=with_limit(kilobytes))
        # of ours: in builds for coverage libgcov has something to say too
        check(result.returncode == 1 and programs.one_line(result, folder), f"files up to {kilobytes} kB: {result.stderr.strip()}")
        check(contents(f"{folder}/out") == earlier and set(os.listdir(folder)) - {"out.run"} == set(os.listdir(f"{base}/earlier")),
              "... the files of an earlier run are untouched")
        result = run(RUN, *options, "-o", f"{folder}/out.h5", "--resume")
        check(result.returncode == 0 and contents(f"{folder}/out") == whole, "... with space it goes on to the same bytes")


def interrupted(folder):
    """The journal of a run that got to its end and found no place for its files."""
    arguments = [scene("torus"), "--t-end", "0.25", "--record", "7", "--frames", "4", "-o", f"{folder}/out.h5"]
    result = programs.run_without_place(f"{folder}/out.run", f"{folder}/out.csv.part", RUN, *arguments)
    assert result.returncode == 1 and size_of(f"{folder}/out.run") > 0, result.stderr
    return arguments


def prolonged(base):
    """A run whose end time is moved: as if it had been asked for so from the start, with the same steps between
    records."""
    arguments = interrupted(f"{base}/longer")
    result = run(RUN, *[word if word != "0.25" else "0.4" for word in arguments], "--resume")
    run(RUN, scene("torus"), "--t-end", "0.4", "--record", "7", "--frames", "4", "-o", f"{base}/asked/out.h5")
    check(result.returncode == 0 and "goes on from step 250" in result.stdout and
          contents(f"{base}/longer/out") == contents(f"{base}/asked/out"), "--resume with a later --t-end prolongs the run")


def fields(base):
    """Of a run that was prolonged, too, and off unless asked for, all else being the same."""
    start = [scene("pile"), "--frames", "8", "--record", "8"]
    ends = [[*start, "--t-end", end, "-o", f"{base}/{name}/out.h5"] for end, name in (("1/4", "whole"), ("1/8", "two"), ("1/4", "two"))]
    for arguments, more in zip(ends, ([], [], ["--resume"])):
        result = run(RUN, *arguments, "--fields", "force", *more)
        check(result.returncode == 0, f"--fields force {' '.join(more)} {result.stderr}")
    check("goes on from step 256" in result.stdout and contents(f"{base}/two/out") == contents(f"{base}/whole/out"),
          "--fields force: prolonged to the same bytes")
    run(RUN, *start, "--t-end", "1/4", "-o", f"{base}/without/out.h5")
    frames, plain = read_vtkhdf(f"{base}/whole/out.h5"), read_vtkhdf(f"{base}/without/out.h5")
    refused = run(RUN, *ends[1], "--resume")
    check(one_line(refused, "--fields force", f"{base}/two/out.h5"), f"... and with the fields that it has: {refused.stderr}")
    check(set(frames[0]) - set(plain[0]) == {"force"} and same(frames, plain, set(plain[0]) - {"t"}) and
          contents(f"{base}/whole/out")[".csv"] == contents(f"{base}/without/out")[".csv"], "it adds force and changes nothing")


def contacts(base):
    """The same of what touches, which a complete run goes on from too, from a file of its own."""
    start = [scene("heap"), "--frames", "16", "--record", "8"]
    ends = [[*start, "--t-end", end, "-o", f"{base}/{name}/out.h5"] for end, name in (("1/4", "whole"), ("1/8", "two"), ("1/4", "two"))]
    for arguments, more in zip(ends, ([], [], ["--resume"])):
        result = run(RUN, *arguments, "--contacts", *more)
        check(result.returncode == 0, f"--contacts {' '.join(more)} {result.stderr}")
    whole = contents(f"{base}/whole/out")
    check("goes on from step 256" in result.stdout and len(whole) == 5 and contents(f"{base}/two/out") == whole,
          "--contacts: prolonged to the same bytes")
    run(RUN, *start, "--t-end", "1/4", "-o", f"{base}/without/out.h5")
    plain = contents(f"{base}/without/out")
    check(len(plain) == 4 and all(plain[ending] == whole[ending] for ending in plain if ending != ".h5") and
          same(read_vtkhdf(f"{base}/whole/out.h5"), read_vtkhdf(f"{base}/without/out.h5"), ["Points", "velocity", "omega", "alpha"]),
          "they change nothing")
    refused = run(RUN, *ends[1], "--resume")
    check(one_line(refused, "--contacts", f"{base}/two/out.h5"), f"... and go on with --contacts only: {refused.stderr}")
    later = [RUN, *start, "--t-end", "1/2", "-o", f"{base}/two/out.h5", "--contacts", "--resume"]
    with h5py.File(f"{base}/two/out-contacts.h5", "r+") as file:
        file["VTKHDF/CellData/force"][40, 1] += 1
    refused = run(*later)
    check(one_line(refused, "out-contacts.h5", "without --resume"), f"a force that is spoilt: {refused.stderr}")
    os.remove(f"{base}/two/out-contacts.h5")
    for arguments in (later, [RUN, *ends[2], "--contacts", "--resume"]):
        refused = run(*arguments)
        check(one_line(refused, "out-contacts.h5", "is not there", "without --resume"), f"no file of them: {refused.stderr}")


def continued(base):
    """A run that is complete goes on from its end: as if it had been asked for the later end from the start, with the
    rows and frames that it has; three times over, from out.h5 alone."""
    with open(f"{base}/bodies.csv", "w", encoding="ascii") as file:
        file.write("x,y,z,vx,vy,vz,mass\n0,0,0,1,0,0,1\n3,0,0,0,0,0,2\n")
    with open(f"{base}/table.yaml", "w", encoding="ascii") as file:
        file.write("bodies: {table: bodies.csv, diameter: 1}\ncontact: {stiffness: 100}\nh: 1/256\nt_end: 1\n")
    # its checkpoint fills more than one piece of the journal
    with open(f"{base}/lattice.yaml", "w", encoding="ascii") as file:
        file.write("bodies: {lattice: {counts: [16, 16, 16], spacing: 1}, mass: 1, inertia: 0.1, omega: [0.1, 0.2, 0.3]}\n"
                   "binder: {moment: 10, axial: 200, shear: {stiffness: 200}}\nh: 1/128\nt_end: 1\n")
    even = ["--h", "1e-3"]  # rows and frames every 0.005 and 0.05 for any of these ends
    cases = [("torus", "vti2", ["--record", "7", "--frames", "32"], ("0.1", "0.25", "0.4")),
             ("pendulum", "vti3-leapfrog", even, ("4", "4.5", "5")), ("pendulum", "srkn6", [], ("1/4", "1", "2")),
             ("torus", "an4", ["--record", "7", "--frames", "32"], ("0.002", "0.1", "0.25")),  # from within its start
             # steps by a tolerance: the first end is no multiple of rows and frames, and cuts a step that none of one
             # run is
             ("torus", "srkn11", ["--record", "64", "--frames", "64", "--tolerance", "1e-6", "--errors", "--h", "1/256"], ("62/256", "1/4", "0.6")),
             ("pendulum", "srkn6", ["--record", "16", "--frames", "32", "--control", "integrating", "--h", "1/4"], ("47/4", "16", "20")),
             ("spin", "vti1", [*even, "--no-dump"], ("4", "5")), (f"{base}/table", "exact", [], ("1/3", "2")),
             (f"{base}/lattice", "vti2", ["--record", "1", "--frames", "2"], ("2/128", "6/128"))]
    for number, (name, stepper, options, ends) in enumerate(cases):
        arguments = [name + ".yaml" if name.startswith(base) else scene(name), "--stepper", stepper, *options]
        stem = f"{base}/{number}/out"
        run(RUN, *arguments, "--t-end", ends[0], "-o", stem + ".h5")
        for ending in (".csv", ".dump", ".xdmf"):  # all that is needed is in out.h5
            if os.path.exists(stem + ending):
                os.unlink(stem + ending)
        for end in ends[1:]:
            more = run(RUN, *arguments, "--t-end", end, "-o", stem + ".h5", "--resume")
            kept = more.stdout.split("those of one run with ")[-1].split("\n")[0].split()
            intervals = [] if options[:1] in (["--record"], ["--h"]) else kept
            run(RUN, *arguments, "--t-end", end, *intervals, "-o", f"{base}/whole{number}{end.replace('/', '_')}/out.h5")
            check(more.returncode == 0 and "goes on from step" in more.stdout and kept[0] == "--record" and
                  contents(stem) == contents(f"{base}/whole{number}{end.replace('/', '_')}/out"),
                  f"{name}, {stepper}: to {ends[0]}, then {end}, with the bytes of one run {more.stderr}")
        before, times = contents(stem), os.stat(stem + ".h5").st_mtime_ns
        again = run(RUN, *arguments, "--t-end", ends[-1], "-o", stem + ".h5", "--resume")
        check(again.returncode == 0 and "complete" in again.stdout and "nothing to do" in again.stdout and
              contents(stem) == before and os.stat(stem + ".h5").st_mtime_ns == times, "... and then there is nothing to do")
        check(not os.path.exists(stem + ".run"), "... and nothing is left behind")


def refused_ends(base):
    """A complete run is not written over by --resume if it is another one, damaged, broken off or longer."""
    torus = [scene("torus"), "--t-end", "0.05", "-o", f"{base}/out.h5"]
    run(RUN, *torus)
    whole = contents(f"{base}/out")

    def refusal(what, words, *options, file=None):
        if file is not None:
            with open(f"{base}/out.h5", "wb") as out:
                out.write(file)
        before = contents(f"{base}/out")
        result = run(RUN, *torus, "--resume", *options)
        check(result.returncode == 1 and one_line(result, "out.h5" if "--t-end" not in words else "--t-end", *words),
              f"{what}: {result.stderr.strip()}")
        check(contents(f"{base}/out") == before and len(os.listdir(base)) == 4, "... and leaves all as it was")

    refusal("an earlier end", ["--t-end", "0.04", "end of the run at t = 0.05"], "--t-end", "0.04")
    refusal("another value", ["another run: binder.axial: 200 there, 201 here"], "--set", "binder.axial=201", "--t-end", "0.1")
    refusal("another h", ["another run: h: 0.001 there, 0.00048828125 here"], "--h", "1/2048", "--t-end", "0.1")
    with h5py.File(f"{base}/out.h5", "r+") as file:
        file["energies/total"][3] *= 1 + 1e-15
    refusal("a row that is spoilt", ["rows or frames", "without --resume"], "--t-end", "0.1")
    for name in ("VTKHDF/Points", "restart/checkpoint", "restart/identity"):
        with open(f"{base}/out.h5", "wb") as out:
            out.write(whole[".h5"])
        with h5py.File(f"{base}/out.h5", "r+") as file:
            data = file[name]
            at = (85, 0) if data.ndim == 2 else len(data) // 2
            if name.endswith("y"):
                at = bytes(data[:]).index(b"0", at)    # a text, which stays one of the same lines
            data[at] = data[at] + 1
        refusal(f"{name} is spoilt", ["another run"] if name.endswith("y") else ["without --resume"], "--t-end", "0.1")
    blown = [scene("torus"), "--h", "0.02", "--t-end", "20", "-o", f"{base}/out.h5"]
    run(RUN, *blown)
    torus = blown
    refusal("a run that broke off", ["no run that came to its end", "without --resume"])


def completed(base):
    """What a complete run lacks of the files that are asked for is made by --resume, and nothing else changes."""
    whole = [scene("torus"), "--t-end", "0.1", "-o"]
    run(RUN, *whole, f"{base}/plain/out.h5")
    run(RUN, *whole, f"{base}/out.h5")
    for ending in (".csv", ".xdmf", ".dump"):
        os.remove(f"{base}/out{ending}")
        result = run(RUN, *whole, f"{base}/out.h5", "--resume")
        check(result.returncode == 0 and contents(f"{base}/out") == contents(f"{base}/plain/out"), f"out{ending} is made {result.stderr}")
    times = os.stat(f"{base}/out.h5").st_mtime_ns
    result = run(RUN, *whole, f"{base}/out.h5", "--resume")
    check(result.returncode == 0 and "nothing to do" in result.stdout and os.stat(f"{base}/out.h5").st_mtime_ns == times, "... once")
    many = [scene("spin"), "--t-end", "5", "--h", "1/512", "--frames", "1", "-o", f"{base}/many.h5"]  # 2561 frames
    run(RUN, *many)
    result = run(RUN, *many, "--resume")
    check("nothing to do" in result.stdout and not os.path.exists(f"{base}/many.xdmf"), "an index of many frames is none that is missed")
    result = run(RUN, *many, "--resume", "--xdmf")
    check(result.returncode == 0 and os.path.exists(f"{base}/many.xdmf") and len(read_xdmf(f"{base}/many.xdmf")) > 0, "... with --xdmf it is")


def prolonged_and_killed(base):
    """A complete run that goes on and is killed before its first checkpoint: it is no other run's to replace, and goes
    on."""
    arguments = [scene("pendulum"), "--stepper", "vti2", "--record", "16", "--frames", "64", "-o", f"{base}/out.h5"]
    run(RUN, *arguments, "--t-end", "2")
    before = contents(f"{base}/out")
    with subprocess.Popen([RUN, *arguments, "--t-end", "1e6", "--resume"], stdout=subprocess.PIPE, text=True) as process:
        line = next((line for line in process.stdout if "goes on from" in line), "")
        process.kill()
    result = run(RUN, *arguments, "--t-end", "2", "--h", "1/2048", "--resume")
    check(line != "" and result.returncode == 1 and one_line(result, "another run: h: ") and contents(f"{base}/out") == before,
          f"killed while it goes on, another run leaves it: {result.stderr.strip()}")
    result = run(RUN, *arguments, "--t-end", "3", "--resume")
    run(RUN, *arguments[:-1], f"{base}/whole/out.h5", "--t-end", "3")
    check(result.returncode == 0 and contents(f"{base}/out") == contents(f"{base}/whole/out"), f"... and it goes on {result.stderr}")


TOUCHING = """bodies: {chain: {count: 2, spacing: 1.02}, diameter: 1, mass: 1, random: {seed: 3, v: 1}}
contact: {stiffness: 1000}
wall: {stiffness: 1000, planes: [[0, 0, 1, -0.52]]}
gravity: [0, 0, -9.81]
h: 1/512
t_end: 1/8
"""


def looked_at_once(base):
    """Steppers that leave the forces of other positions than the bodies': where a run goes on, the verdict does not take
    the largest force so far from those of the bodies' positions, which it begins with."""
    with open(f"{base}/touching.yaml", "w", encoding="utf-8") as file:
        file.write(TOUCHING)
    for stepper in ("an7", "srkn14"):
        start = [f"{base}/touching.yaml", "--stepper", stepper, "--record", "64", "--frames", "64", "-o"]
        run(RUN, *start, f"{base}/whole/out.h5")
        same_bytes = []
        for step in range(57, 64):  # before a contact: the force grows from step to step
            name = f"{base}/{stepper}-{step}/out"
            run(RUN, *start, f"{name}.h5", "--t-end", f"{step}/512")
            run(RUN, *start, f"{name}.h5", "--resume")
            same_bytes.append(contents(name) == contents(f"{base}/whole/out"))
        check(all(same_bytes), f"{stepper}: prolonged from each of the last steps to the same bytes")


def unheard(base):
    """Who reads standard output has gone: it is said, and the files are there."""
    arguments = [scene("torus"), "--t-end", "0.1"]
    run(RUN, *arguments, "-o", f"{base}/whole/out.h5")
    for lines in (0, 1):
        with subprocess.Popen([RUN, *arguments, "-o", f"{base}/{lines}/out.h5"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True, preexec_fn=lambda: as_usual(signal.SIGPIPE)) as process:
            for _ in range(lines):
                process.stdout.readline()
            process.stdout.close()
            words = process.stderr.read()
        check(process.returncode == 1 and words.count("\n") == 1 and "standard output: cannot be written" in words and
              contents(f"{base}/{lines}/out") == contents(f"{base}/whole/out") and
              len(os.listdir(f"{base}/{lines}")) == len(os.listdir(f"{base}/whole")), f"{lines} lines are read: {words.strip()}")


def prolonged_from_nothing(base):
    """A run whose last checkpoint is before its first step, but after a lagging stepper had moved its velocities."""
    arguments = [scene("pendulum"), "--stepper", "vti3-leapfrog", "--h", "1e-3", "--record", "1", "--frames", "1"]
    with subprocess.Popen([RUN, *arguments, "--t-end", "1", "--checkpoint", "1e-9", "-o", f"{base}/none/out.h5"],
                          preexec_fn=with_limit(100), stderr=subprocess.DEVNULL) as process:
        pass
    check(process.returncode == 1 and size_of(f"{base}/none/out.run") > 0, "a run is interrupted early")
    result = run(RUN, *arguments, "--t-end", "1", "-o", f"{base}/none/out.h5", "--resume")
    run(RUN, *arguments, "--t-end", "1", "-o", f"{base}/asked/out.h5")
    check(result.returncode == 0 and "starts at t = 0" in result.stdout and
          contents(f"{base}/none/out") == contents(f"{base}/asked/out"), "... and starts once, not twice")


def broken(base):
    """A run that blows up: the step and the body are named, and what was before is in the files."""
    result = run(RUN, scene("torus"), "--h", "0.02", "--t-end", "20", "--record", "1", "-o", f"{base}/blown/out.h5")
    check(result.returncode == 1 and one_line(result, "step ", "body "), f"blown up: {result.stderr.strip()}")
    check("warning: h = 0.02 is above the stable step" in result.stdout, "... of which it has warned")
    rows = read_csv(f"{base}/blown/out.csv")[1]
    check(len(rows) > 1 and (abs(rows) < float("inf")).all() and len(read_vtkhdf(f"{base}/blown/out.h5")) >= 1,
          f"... what was recorded is there: {len(rows)} rows")
    with h5py.File(f"{base}/blown/out.h5") as file:
        check(file.attrs["complete"] == 0, "... and they say that it broke off")
    result = run(RUN, scene("pair"), "--stepper", "gear", "--h", "1", "--t-end", "2000", "--record", "1", "-o", f"{base}/nan/out.h5")
    check(result.returncode == 1 and one_line(result, "body 0 has angular velocity nan; "), f"NaN has no sign: {result.stderr.strip()}")
    result = run(RUN, scene("pendulum"), "--stepper", "vti1", "--h", "1", "-o", f"{base}/turned/out.h5")
    check(result.returncode == 1 and one_line(result, "vti1", "step ", "body 0", "h|Omega|"),
          f"VTI-1 turns too far: {result.stderr.strip()}")


def refused_resumes(base):
    arguments = interrupted(f"{base}/kept")
    before = programs.contents(f"{base}/kept")

    def refusal(what, words, *options, command=None):
        result = run(RUN, *(command or arguments), *options)
        check(result.returncode == 1 and one_line(result, *words), f"{what}: {result.stderr.strip()}")
        check(programs.contents(f"{base}/kept") == before, "... and leaves all as it was")

    refusal("a journal, but no --resume", ["out.run", "--resume", "delete it"])
    refusal("another scene", ["another run: name: torus there, torus-printed here"], "--resume",
            command=[scene("torus-printed"), *arguments[1:]])
    refusal("another value", ["another run: binder.axial: 200 there, 201 here"], "--resume", "--set", "binder.axial=201")
    refusal("another h", ["another run: h: 0.001 there, 0.00048828125 here"], "--resume", "--h", "1/2048")
    refusal("another stepper", ["another run: stepper: vti2 there, vti1 here"], "--resume", "--stepper", "vti1")
    refusal("other rows", ["--record", "12", "leave it out"], "--resume", "--record", "12")
    refusal("other frames", ["--frames", "12", "leave it out"], "--resume", "--frames", "12")
    refusal("an end before the checkpoint", ["--t-end", "0.2", "checkpoint", "0.25"], "--resume", "--t-end", "0.2")
    more = ["--resume", "--t-end", "1000"]
    with subprocess.Popen([RUN, *arguments, *more], stdout=subprocess.DEVNULL) as process:
        while not os.path.exists(f"{base}/kept/out.run-journal"):
            time.sleep(0.0005)
        result = run(RUN, *arguments, *more)
        check(result.returncode == 1 and one_line(result, "another vti-run"), f"two at once: {result.stderr.strip()}")
        process.kill()


def changed_tables(base):
    """One number of a table, of either kind, is changed between a run and its resumption."""
    names = [*"xyz", *(kind + axis for kind in ("v", "alpha_", "omega_") for axis in "xyz")]
    bodies = {**dict.fromkeys(names, [0.0] * 4), "x": [0.0, 1.0, 2.0, 3.0],
              **dict.fromkeys(("mass", "inertia", "diameter"), [1.0] * 4)}
    bonds = {"i": [0, 0], "j": [1, 2], "axial": [10.0, 20.0], "moment": [1.0, 2.0], "shear": [1.0, 2.0]}

    def write(ending, tables):
        for group, columns in tables.items():
            if ending == "csv":
                with open(f"{base}/{group}.csv", "w", encoding="ascii") as file:
                    file.writelines(",".join(map(str, row)) + "\n" for row in [columns, *zip(*columns.values())])
                continue
            with h5py.File(f"{base}/{group}.h5", "w") as file:
                for name, values in columns.items():
                    file[f"{group}/{name}"] = values

    def changed(table, name):
        return {**table, name: [*table[name][:-1], table[name][-1] + (1 if name in "ij" else 1e-9)]}

    for ending in ("csv", "h5"):
        with open(f"{base}/{ending}.yaml", "w", encoding="ascii") as file:
            file.write(f"bodies: {{table: bodies.{ending}}}\nbinder: {{table: bonds.{ending}}}\nh: 1/1024\nt_end: 1\n")
        arguments = [f"{base}/{ending}.yaml", "-o", f"{base}/{ending}/out.h5", "--record", "8", "--frames", "8"]
        write(ending, {"bodies": bodies, "bonds": bonds})
        folder = f"{base}/{ending}"
        result = programs.run_without_place(f"{folder}/out.run", f"{folder}/out.csv.part", RUN, *arguments)
        check(result.returncode == 1 and one_line(result, "out.run"), f"{ending}, no place for a file: {result.stderr.strip()}")
        for group, name in [("bodies", name) for name in bodies] + [("bonds", name) for name in bonds]:
            tables = {"bodies": bodies, "bonds": bonds}
            write(ending, {**tables, group: changed(tables[group], name)})
            result = run(RUN, *arguments, "--resume")
            check(result.returncode == 1 and one_line(result, f"another run: table of {group}, {name}: ", "-o"),
                  f"{group}.{ending}, other {name}: {result.stderr.strip()}")
        write(ending, {"bodies": bodies, "bonds": bonds})
        check(run(RUN, *arguments, "--resume").returncode == 0, f"... with its own {ending} tables it goes on")


def refused(base):
    blocked = f"{base}/file"
    open(blocked, "w", encoding="ascii").close()
    cases = [
        ("no scene", [], ["SCENE.yaml"]),
        ("unknown scene", [f"{base}/none.yaml"], ["none.yaml", "cannot be read"]),
        ("two scenes", [scene("spin"), scene("torus")], ["only one scene"]),
        ("unknown option", [scene("spin"), "--frob"], ["--frob", "--help"]),
        ("option without value", [scene("spin"), "--record"], ["--record", "needs a value"]),
        ("unknown field", [scene("torus"), "--fields", "force,spin"], ["--fields", "'spin'", "there are force, moment and lost"]),
        ("no field", [scene("torus"), "--fields", "force,"], ["--fields", "''", "there are force, moment and lost"]),
        ("books of what takes nothing", [scene("torus"), "--fields", "lost"], ["--fields", "torus", "leave lost out"]),
        ("field that is not there", [scene("pile"), "--fields", "moment"], ["--fields", "pile", "gives a moment"]),
        ("value of an option without one", [scene("spin"), "--resume=yes"], ["--resume=yes", "takes no value"]),
        ("rows of no step", [scene("spin"), "--record", "0"], ["--record", "'0'", "write 50 or 1e3"]),
        ("rows of too many steps", [scene("spin"), "--record", "1e18"], ["--record", "'1e18'", "from 1 to 9007199254740992"]),
        ("frames of words", [scene("spin"), "--frames", "many"], ["--frames", "'many'"]),
        ("no time between checkpoints", [scene("spin"), "--checkpoint", "0"], ["--checkpoint", "'0'"]),
        ("negative h", [scene("spin"), "--h", "-1"], ["--h=-1: h: '-1'"]),
        ("unknown stepper", [scene("spin"), "--stepper", "rk5"], ["--stepper=rk5: stepper: 'rk5'", "take one of " + ", ".join(
            line.split("\t")[0] for line in run(RUN, "--list", "steppers").stdout.splitlines())]),
        ("a step by --set", [scene("spin"), "--set", "h=-1"], ["--set h=-1: h: '-1'"]),
        ("an end that is none", [scene("spin"), "--t-end", "now"], ["--t-end=now: t_end: 'now' is not a number"]),
        ("rival of spheres", [scene("slender"), "--stepper", "mercury"], ["bodies.moments", "mercury", "bodies.inertia"]),
        ("a rotor of what has none", [scene("heavy-top"), "--stepper", "campello", "--set", "rotor=4"],
         ["--set rotor=4: rotor: the stepper campello is no list of kicks and drifts", "take vti2 or leave it out"]),
        ("multistep method of spheres", [scene("slender"), "--stepper", "an4"],
         ["bodies.moments", "an4", "bodies.inertia"]),
        ("step control of spheres", [scene("slender"), "--stepper", "srkn11", "--tolerance", "1e-6"],
         ["bodies.moments", "step control", "bodies.inertia"]),
        ("contacts where nothing touches", [scene("spin"), "--contacts"], ["spin: --contacts: nothing touches; give contact or wall"]),
        ("estimates of steps that go by turning", [scene("spin"), "--stepper", "srkn6", "--control", "naive", "--errors"],
         ["--errors", "srkn6-naive"]),
        ("steps that follow how fast nothing turns", [f"{base}/mass.yaml", "--stepper", "srkn6", "--control", "integrating"],
         ["mass: control: integrating: steps follow how fast bodies turn, and none does; leave it out"]),
        ("unknown path", [scene("spin"), "--set", "bodies.inertai=1"], ["bodies.inertai"]),
        ("a scene beside a list", ["--list", "keys", scene("spin")], ["spin.yaml", "--list"]),
        ("a name that is no text", [scene("spin"), "-o", os.fsdecode(f"{base}/".encode() + b"a\xe9.h5")], ["-o", "\\xe9", "UTF-8"]),
        ("a name of half a character", [scene("spin"), "-o", os.fsdecode(f"{base}/".encode() + b"a\xc3.h5")], ["\\xc3", "UTF-8"]),
        ("a name that XML has no letter for", [scene("spin"), "-o", f"{base}/a\x02.h5"], ["-o", "'a?.h5'", "byte 2"]),
        ("a name of 6000 letters", [scene("spin"), "-o", f"{base}/{6000 * 'a'}/o.h5"], ["-o", "is too long; use a shorter path"]),
        ("wrong ending", [scene("spin"), "-o", f"{base}/out.yaml"], ["-o", "out.yaml", ".h5"]),
        ("unwritable place", [scene("spin"), "-o", f"{blocked}/out.h5"], [blocked, "-o"]),
        ("a file in the journal's place", [scene("spin"), "-o", f"{blocked}.h5"], [f"{blocked}.run"]),
    ]
    with open(f"{blocked}.run", "w", encoding="ascii") as file:
        file.write("mine\n")
    with open(f"{base}/mass.yaml", "w", encoding="ascii") as file:
        file.write("bodies: {x: [0, 0, 0], v: [1, 0, 0], mass: 1}\nh: 0.01\nt_end: 1\n")
    for what, arguments, words in cases:
        result = run(RUN, *arguments, cwd=base)
        check(result.returncode == 1 and one_line(result, *words), f"{what}: {result.stderr.strip()}")
    check(sorted(os.listdir(base)) == ["file", "file.run", "mass.yaml"], "refusals leave nothing behind")
    result = run(RUN, scene("spin"), "--resume", "-o", f"{blocked}.h5")
    check(result.returncode == 1 and one_line(result, f"{blocked}.run"), f"... nor with --resume: {result.stderr.strip()}")


random.seed(20240117)
TOPICS = [lambda base: kills(base, "chain", "--stepper", "rk8pd-adaptive", "--h", "1/64", "--t-end", "20"),
          lambda base: kills(base, "chain", "--stepper", "srkn11", "--tolerance", "1e-9", "--h", "1/16", "--t-end",
                             "80"),
          lambda base: kills(base, "chain", "--stepper", "yade-leapfrog", "--h", "1/2048", "--t-end", "20"),
          lambda base: kills(base, "torus", "--t-end", "4", "--fields", "force,moment"),
          lambda base: kills(base, "pile", "--t-end", "1/2"),
          lambda base: kills(base, "heap", "--t-end", "1/8", "--contacts"),
          signals, far_from_multiples, between_rows, signals_before, failed_starts, one_stem, vanished, full_disk, changed_tables, prolonged,
          fields, contacts, continued, refused_ends, completed, prolonged_and_killed, looked_at_once, unheard,
          prolonged_from_nothing, broken, refused_resumes, refused]
for topic in TOPICS:
    with tempfile.TemporaryDirectory() as root:
        topic(root)
conclude()
