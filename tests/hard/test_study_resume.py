#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vti-study that is killed, stopped, out of space or memory, or misused: what it had done is kept, --resume ends with
the same
bytes, every refusal is one line, and nothing hangs.      test_study_resume.py VTI_STUDY MPIRUN SCENES [KILLS]"""
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from programs import ENVIRONMENT, PATIENCE, contents, holds, one_line, run, run_without_place
from tally import check, conclude

STUDY, MPIRUN, SCENES = map(os.path.abspath, sys.argv[1:4])
LONG = len(sys.argv) > 4
KILLS = int(sys.argv[4]) if LONG else 2
JOURNALS = ("study.journal", "cost.journal")
TIMED = ("timing.csv",)


def scene(name):
    return os.path.join(SCENES, name + ".yaml")


def command(ranks, *arguments):
    launch = [MPIRUN, "-n", str(ranks)] if ranks > 0 else []
    return [*launch, STUDY, *([] if "--cost" in arguments else ["--no-plot"]), *arguments]


def study(ranks, *arguments, **options):
    """0 ranks: without mpirun."""
    return run(*command(ranks, *arguments), **options)


def processes(folder):
    """The ranks that write there: mpirun, whose command line is the same, is not one of them."""
    found = []
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{name}/cmdline", "rb") as file:
                words = file.read().split(b"\0")
        except OSError:
            continue
        if words[0] == STUDY.encode() and folder.encode() in words:
            found.append(int(name))
    return found


def tell(ranks, number):
    """A signal to each that is still there."""
    for rank in ranks:
        try:
            os.kill(rank, number)
        except ProcessLookupError:
            pass


def end(process, folder):
    """Waits for mpirun and returns its code. After a kill PMIx 4.2 may lock itself out when mpirun finalises it, one
    time in a hundred and with all ranks gone: that is seen from outside only as an mpirun that stays, and is no hang of
    the study."""
    for _ in range(PATIENCE // 10):
        try:
            return process.wait(timeout=10)
        except subprocess.TimeoutExpired:
            if not processes(folder):
                break
    check(not processes(folder), f"the ranks end within {PATIENCE} s")
    print("        mpirun stayed after its ranks had ended")
    process.kill()
    return process.wait()


def killed(folder, seconds, ranks, *arguments):
    """Starts a study and kills one of its ranks after so many seconds; False if it had ended by itself."""
    with subprocess.Popen(command(ranks, *arguments, "-o", folder), env=ENVIRONMENT, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as process:
        time.sleep(seconds)
        there = processes(folder)
        tell(random.sample(there, min(1, len(there))), signal.SIGKILL)
        code = end(process, folder)
    last = time.monotonic() + 10
    while processes(folder) and time.monotonic() < last:
        time.sleep(0.01)
    if processes(folder):
        check(False, f"no rank outlives the one that is killed after {seconds:.2f} s")
    return code != 0


def kills(base, what, timed, *arguments):
    """SIGKILL of any rank at random moments, some of a study that has been resumed; then it is resumed to its end."""
    begin = time.monotonic()
    result = study(2, *arguments, "-o", f"{base}/whole")
    duration = time.monotonic() - begin
    whole = contents(f"{base}/whole", timed)
    check(result.returncode == 0 and whole, f"{what}: {', '.join(whole)} in {duration:.2f} s")
    done, tries, same, gone_on = 0, 0, 0, 0
    while done < KILLS and tries < 20 * KILLS:
        tries += 1
        folder = f"{base}/killed{tries}"
        if not killed(folder, random.uniform(0.2, 1.0) * duration, random.choice((1, 2, 3)), *arguments, "--resume"):
            continue
        done += 1
        while random.random() < 0.4:
            killed(folder, random.uniform(0.2, 1.0) * duration, 2, *arguments, "--resume")
        last = study(random.choice((1, 2, 3)), *arguments, "--resume", "-o", folder)
        gone_on += "goes on: " in last.stdout
        same += last.returncode == 0 and contents(folder, timed) == whole
        shutil.rmtree(folder)
    check(done == same == KILLS, f"{what}: killed {done} times, resumed {same} times to the same bytes and nothing else")
    check(gone_on > 0 or not LONG, f"... {gone_on} times with runs that were there")


LADDER = ("--h", "2^-4:2^-14", "--steppers", "vti1,vti2,vti3")


def begun(folder, *arguments, number=signal.SIGKILL, said=subprocess.DEVNULL):
    """A study on two ranks that is ended when it has kept something; a machine that is busy may need several. Returns
    its code."""
    journal, code = f"{folder}/study.journal", 0
    for _ in range(20):
        shutil.rmtree(folder, ignore_errors=True)
        with subprocess.Popen(command(2, *arguments, "-o", folder), env=ENVIRONMENT, stdout=subprocess.DEVNULL, stderr=said) as process:
            while process.poll() is None and not holds(journal):
                time.sleep(0.001)
            if number == signal.SIGKILL:
                tell(processes(folder), number)
            else:
                process.send_signal(number)
            code = end(process, folder)
        # mpirun does not wait for ranks that it has ended, and they hold the lock until they have
        while processes(folder):
            time.sleep(0.01)
        if code != 0 and holds(journal):
            break
    return code


def refused_resumes(base):
    folder, path = f"{base}/kept", f"{base}/own.yaml"
    shutil.copy(scene("pendulum"), path)
    begun(folder, path, *LADDER)
    check(set(contents(folder)) <= {"study.journal", "study.journal-journal"}, f"an ended study leaves its journal: {os.listdir(folder)}")
    study(0, path, *LADDER, "-o", folder)  # SQLite takes back what was half done
    before = contents(folder)
    check(list(before) == ["study.journal"], "... and nothing else once somebody has looked at it")

    def refusal(what, words, *arguments, ranks=0):
        result = study(ranks, *arguments, "-o", folder)
        check(one_line(result, "study.journal", *words) and contents(folder) == before, f"{what}: {result.stderr.strip()[:240]}")

    refusal("no --resume, 3 ranks", ["--resume", "delete it"], path, *LADDER, ranks=3)
    refusal("another value", ["another study: bodies.inertia: 1 there, 2 here"], path, *LADDER, "--resume", "--set", "bodies.inertia=2")
    refusal("another scene", ["another study: name: pendulum there, spin here"], scene("spin"), *LADDER, "--resume")
    refusal("another memory", ["another study: --memory: 1000 there, 500 here"], path, *LADDER, "--resume", "--memory", "500")
    if LONG:
        refusal("other steps", ["another study: --h: ..."], path, "--h", "2^-4:2^-13", "--resume")
        refusal("other steppers", ["another study: --steppers: vti1 vti2 vti3 there, vti1 here"], path, *LADDER[:2], "--steppers", "vti1", "--resume")
        refusal("another end", ["another study: --t-end: 10 there, 9 here"], path, *LADDER, "--resume", "--t-end", "9")


def full_disk(base):
    """A file that cannot be written, and files that may not grow: the results before stay, and nothing that was done is
    lost."""
    arguments = [scene("pendulum"), "--h", "2^-4:2^-9"]
    study(1, *arguments, "-o", f"{base}/whole")
    whole = contents(f"{base}/whole", TIMED)
    for name in ("study.h5", "study.csv", "timing.csv") if LONG else ("study.csv",):
        folder = f"{base}/{name}"
        study(0, scene("spin"), "--h", "2^-4:2^-6", "-o", folder)
        earlier = contents(folder)
        result = run_without_place(f"{folder}/study.journal", f"{folder}/{name}.part", *command(0, *arguments, "-o", folder))
        after = contents(folder, JOURNALS)
        check(one_line(result, folder, "--resume") and after == earlier, f"{name}: {result.stderr.strip()[:200]}")
        result = study(1, *arguments, "--resume", "-o", folder)
        check(result.returncode == 0 and contents(folder, TIMED) == whole and "18 of 18" in result.stdout,
              "... with space it goes on to the same bytes")
    folder = f"{base}/journal"
    os.mkdir(folder)
    os.symlink(f"{base}/elsewhere", f"{folder}/study.journal")
    result = study(2, *arguments, "-o", folder)
    check(one_line(result, "study.journal", "no file") and not os.path.exists(f"{base}/elsewhere"), f"a link: {result.stderr.strip()[:200]}")
    limited(base, arguments, whole)


def limited(base, arguments, whole):
    """Files up to a size that the journal reaches in the middle; without shared memory, whose files would be as
    limited."""
    folder, less = f"{base}/limited", 'ulimit -f 600; exec "$0" "$@"'  # blocks of 512 bytes
    result = run(MPIRUN, "-n", "1", "sh", "-c", less, *command(0, *arguments, "-o", folder),
                 env=dict(ENVIRONMENT, OMPI_MCA_btl="self"))
    check(one_line(result, "study.journal", "--resume") and result.stderr.count("study.journal") == 1,
          f"files up to 300 kB: {result.stderr.strip()[:600]}")
    result = study(2, *arguments, "--resume", "-o", folder)
    check(result.returncode == 0 and "goes on" in result.stdout and contents(folder, TIMED) == whole, "... it goes on from there")


def stopped(base):
    # mpirun takes its time to end its ranks: a study that is not over before
    arguments = [scene("pendulum"), "--h", "2^-4:2^-16", "--steppers", "vti1,vti2,vti3"]
    study(2, *arguments, "-o", f"{base}/whole")
    for number in (signal.SIGTERM, signal.SIGUSR1, signal.SIGINT) if LONG else (signal.SIGTERM, signal.SIGUSR1):
        folder = f"{base}/{number.name}"
        with open(f"{base}/said.txt", "w+", encoding="utf-8") as said:
            code = begun(folder, *arguments, number=number, said=said)
            said.seek(0)
            words = said.read()
        if number == signal.SIGUSR1:  # which mpirun hands on; of the others it is in a hurry to end its ranks
            check(code == 75 and "runs are kept in " in words and "go on with --resume" in words, f"SIGUSR1: code {code}, {words[:200]!r}")
        result = study(2, *arguments, "--resume", "-o", folder)
        check(code != 0 and "goes on" in result.stdout and contents(folder, TIMED) == contents(f"{base}/whole", TIMED),
              f"{number.name}: code {code}, and it goes on to the same bytes")


def failing_rank(base):
    """Runs fail while others work; one rank has too little memory: a message, an end, and no hang."""
    for ranks in (1, 2, 3) if LONG else (2,):
        result = study(ranks, scene("pendulum"), "--steppers", "vti1,vti2", "--h", "2,1,1/64,2^-16", "-o", f"{base}/{ranks}")
        words = [line for line in result.stdout.splitlines() if "failed: vti1 at h = " in line and "reduce h" in line]
        check(result.returncode in (1, 3) and len(words) == 2 and "of 8 runs" in result.stdout and "and 2 failed" in result.stdout and
              sorted(contents(f"{base}/{ranks}")) == ["study.csv", "study.h5", "timing.csv"], f"runs fail, {ranks} ranks: {words} {result.stderr.strip()[:120]}")
    if run(MPIRUN, "-n", "1", "true", ":", "-n", "1", "true").returncode != 0:
        print("skipped here: Open MPI 5.0.7 crashes on two programs at once")
        return
    arguments = ["--h", "1/64", "--no-plot", "-o", f"{base}/unread"]
    result = run(MPIRUN, "-n", "1", STUDY, scene("pendulum"), *arguments, ":", "-n", "1", STUDY, f"{base}/none.yaml", *arguments)
    check(one_line(result, "none.yaml", "cannot be read") and not os.path.exists(f"{base}/unread"),
          f"a rank that cannot read the scene: {result.stderr.strip()[:120]}")
    arguments = [scene("torus"), "--h", "1/2000,1/4000", "--t-end", "2", "--no-plot", "-o", f"{base}/memory"]
    ended = 0
    for megabytes in range(40, 700, 20) if LONG else (100, 60, 40):
        less = f'ulimit -v {1024 * megabytes}; exec "$0" "$@"'
        # without shared memory: ranks of Open MPI 4 that get none wait for each other
        result = run(MPIRUN, "-n", "1", STUDY, *arguments, ":", "-n", "1", "sh", "-c", less, STUDY, *arguments,
                     env=dict(ENVIRONMENT, OMPI_MCA_btl="self,tcp"))
        ended += result.returncode != 0 and result.stderr.strip() != ""
        words = [line for line in result.stderr.splitlines() if line.startswith("vti-study: ")]
        print(f"        one rank with {megabytes} MB: code {result.returncode} {words[:1]}")
        shutil.rmtree(f"{base}/memory", ignore_errors=True)
        if ended > 0 and not LONG or result.returncode == 0 and LONG:
            break
    check(ended > 0, f"a rank without memory: {ended} times a message and an end")


random.seed(20240605)
TOPICS = [lambda base: kills(base, "pendulum", TIMED, scene("pendulum"), *LADDER),
          lambda base: kills(base, "cost", ("cost.csv", "prices.csv", "machine.txt"), "--cost", scene("pendulum"), "--evals",
                             "4096", "--repeats", "1", "--t-end", "1", "--steppers", "vti1,vti2,rk4,exact,srkn6"),
          refused_resumes, full_disk, stopped, failing_rank]
for topic in TOPICS:
    with tempfile.TemporaryDirectory() as root:
        started = time.monotonic()
        topic(root)
        print(f"        {time.monotonic() - started:.1f} s")
conclude()
