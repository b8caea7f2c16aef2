#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vti-study as a person at a terminal sees it, under mpirun: what will be done, a bar with the time left for the
reference and for
the runs, and how Ctrl-C and signals end it.      test_study_terminal.py VTI_STUDY MPIRUN SCENES RANKS.SH"""
import fcntl
import os
import pty
import re
import select
import signal
import subprocess
import sys
import tempfile
import termios
import time

import programs
from programs import ENVIRONMENT, PATIENCE, run
from tally import check, conclude

STUDY, MPIRUN, SCENES, RANKS = map(os.path.abspath, sys.argv[1:5])
CHAIN, PENDULUM, TORUS = (os.path.join(SCENES, name + ".yaml") for name in ("chain", "pendulum", "torus"))
# What Open MPI 5 does otherwise: its mpirun passes on whole lines only; what it says itself after a code that is not 0
# cannot be held back.
MAJOR = int(re.search(r"\(Open.*?\) (\d+)", run(MPIRUN, "--version").stdout)[1])
del ENVIRONMENT[programs.GRACE]  # ranks that are asked to end say a word
PASSES_PIECES = CAN_BE_QUIET = MAJOR < 5
HOURS = ("--h", "2^-9:2^-27", "--no-plot")
HOURS_TO_COMPARE = ("--h", "1e6", "--t-end", "1e6", "--no-plot")  # the reference of the only interval takes as long
SECONDS = ("--h", "2^-4:2^-15", "--no-plot")  # a bar is drawn ten times per second at most

# 640 steps of h
HOURS_OF_FEW = ("--h", "1/16", "--t-end", "40", "--steppers", "srkn6", "--set", "tolerance=1e-16", "--no-plot")


class Terminal:
    """A program on a terminal of its own, whose controlling terminal it is; stderr and stdout may go elsewhere."""

    def __init__(self, *command, stdout=None, environment=ENVIRONMENT):
        self.ours, theirs = pty.openpty()

        def take_terminal():
            os.setsid()
            fcntl.ioctl(theirs, termios.TIOCSCTTY, 0)

        self.process = subprocess.Popen(command, env=environment, stdin=theirs, stdout=stdout or theirs, stderr=theirs,
                                        preexec_fn=take_terminal)
        os.close(theirs)
        self.said = ""

    def read(self, deadline):
        """What comes next, "" at the end and after the deadline."""
        left = deadline - time.monotonic()
        ready = left > 0 and select.select([self.ours], [], [], left)[0]
        try:
            new = os.read(self.ours, 65536).decode() if ready else ""
        except OSError:  # all who had it open have closed it
            new = ""
        self.said += new
        return new

    def until(self, words):
        deadline = time.monotonic() + PATIENCE
        while words not in self.said and self.read(deadline):
            pass
        return words in self.said

    def end(self):
        """Its code. After a kill of ranks mpirun may stay (test_study_resume.py): what does not end is killed too."""
        deadline = time.monotonic() + PATIENCE
        while self.read(deadline):
            pass
        os.close(self.ours)
        try:
            return self.process.wait(timeout=10)
        except subprocess.TimeoutExpired:
            self.process.kill()
            return self.process.wait()


def mpirun(*arguments):
    return [MPIRUN, "-n", "2", STUDY, *arguments]


def first_line(base):
    done = run(*mpirun("--no-plot", "--h", "1/64,1/128", "-o", f"{base}/line", PENDULUM))
    line = (done.stdout.splitlines() + [""])[0]
    check(done.returncode == 0 and all(words in line for words in ("pendulum", "t = 10", "vti1, vti2, vti3", "0.015625", "0.0078125",
                                                                   "6 runs", "2 ranks", "reference")), "study: " + line)
    check("[" not in done.stdout + done.stderr, "... and no bar where there is no terminal")
    done = run(*mpirun("--cost", "--steppers", "vti2,rk4", "--evals", "1000", "--repeats", "1", "-o", f"{base}/cost", PENDULUM))
    line = (done.stdout.splitlines() + [""])[0]
    check(done.returncode == 0 and all(words in line for words in ("pendulum", "2 methods", "2 ranks")), "cost: " + line)


def has_bar(text, what):
    bars = [piece for piece in text.split("\r") if piece.startswith(what + " [")]
    return bars and all("%" in bar for bar in bars) and any(" left" in bar for bar in bars)


def bars(base):
    for ranks in (1, 2):
        terminal = Terminal(MPIRUN, "-n", str(ranks), STUDY, *SECONDS, "-o", f"{base}/{ranks}", PENDULUM)
        code, said = terminal.end(), terminal.said
        check(code == 0 and has_bar(said, "reference") and has_bar(said, "runs"),
              f"{ranks} ranks: bars of the reference and the runs, code {code}")
        table = said.replace("\r\n", "\n").split("stepper  ")[-1]
        check("\r" not in table and "fitted order" in table, "... and the table after them")
    with open(f"{base}/said.txt", "w+", encoding="utf-8") as file:
        terminal = Terminal(*mpirun(*SECONDS, "-o", f"{base}/stderr", PENDULUM), stdout=file)
        code = terminal.end()
        file.seek(0)
        said = file.read()  # "\r" as "\n"
    check(code == 0 and has_bar(terminal.said, "runs") and "[" not in said and "fitted order" in said,
          "stdout in a file: the bar is on stderr")
    terminal = Terminal(STUDY, *SECONDS, "-o", f"{base}/alone", PENDULUM)
    check(terminal.end() == 0 and has_bar(terminal.said, "runs"), "without mpirun: a bar")
    terminal = Terminal(*mpirun("--cost", "--steppers", "vti2", "--evals", "1000", "--repeats", "1", "-o", f"{base}/cost", PENDULUM))
    check(terminal.end() == 0 and all(has_bar(terminal.said, what) for what in ("reference", "times"))
          and "\rerrors [" in terminal.said, "cost: bars")
    hidden = run("sh", "-c", '"$@" | cat', "sh", *mpirun(*SECONDS, "-o", f"{base}/told", PENDULUM),
                 env=dict(ENVIRONMENT, VTI_TERMINAL="1"), text=False)
    check(hidden.returncode == 0 and bool(has_bar(hidden.stderr.decode(), "runs")) == PASSES_PIECES and b"\r" not in hidden.stdout,
          "VTI_TERMINAL=1 where no terminal can be found")


def lines(base):
    """Where there is no terminal: lines, if the study takes longer than they are apart."""
    for seconds, word in (("0.001", True), ("60", False)):
        done = run(STUDY, *SECONDS, "-o", f"{base}/lines{seconds}", PENDULUM, env=dict(ENVIRONMENT, VTI_LOG=seconds))
        found = re.findall(r"^vti-study: runs: \d+ % done, about \d+ s left$", done.stderr, flags=re.M)
        check(done.returncode == 0 and bool(found) == word and "[" not in done.stderr, f"lines {seconds} s apart: {found[:1]}")


def stopped_words(said):
    return "stopped" in said and "--resume" in said


def asked_by(base, what, waits_for, *arguments):
    """Ctrl-C to mpirun, which kills its ranks a second after it has told them to end, and passes on no word any more:
    they say it to its terminal. A busy machine may not let them within the second, and is asked again."""
    for attempt in range(3):
        terminal = Terminal(*mpirun(*arguments, "-o", f"{base}/{attempt}"))
        begun = terminal.until(waits_for)
        os.write(terminal.ours, b"\x03")
        code = terminal.end()
        if not begun or code == 0 or stopped_words(terminal.said):
            break
    check(begun and code != 0 and stopped_words(terminal.said), f"{what}: code {code}, {terminal.said[-160:].strip()!r}")


def ctrl_c(base):
    asked_by(base + "/runs", "Ctrl-C in runs of hours", "runs [", *HOURS, CHAIN)
    # MALLOC_PERTURB_ of Meson writes all over what is allocated: a gigabyte takes more than the second on a busy
    # machine
    asked_by(base + "/reference", "Ctrl-C in a reference of hours", "reference [", "--t-end", "1e7", "--h", "1", "--memory", "10",
             "--no-plot", PENDULUM)


def begin(*command):
    """Started, and its first line said, after which signals are heard on all ranks."""
    process = subprocess.Popen(command, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    check("after a reference" in process.stdout.readline(), "a study of hours begins")
    return process


def ends_soon(process):
    """What it says, and is killed if it goes on."""
    try:
        return process.communicate(timeout=PATIENCE / 4)[1]
    except subprocess.TimeoutExpired:
        process.kill()
        return process.communicate()[1]


def signals(base):
    """To mpirun, which hands SIGUSR1 on; to the only rank that there is; to one of two."""
    for what, command, number in (("USR1 to mpirun", mpirun(), signal.SIGUSR1), ("TERM without mpirun", [STUDY], signal.SIGTERM),
                                  ("INT without mpirun", [STUDY], signal.SIGINT)):
        process = begin(*command, *HOURS, "-o", f"{base}/out", CHAIN)
        process.send_signal(number)
        _, said = process.communicate(timeout=PATIENCE)
        check(process.returncode == 75 and stopped_words(said), f"{what}: code {process.returncode}, {said.strip()[:200]}")
    usr1, term = ("USR1 to mpirun", mpirun(), signal.SIGUSR1), ("TERM without mpirun", [STUDY], signal.SIGTERM)
    interval = (0.5, *HOURS_TO_COMPARE, TORUS), "within an interval of the reference"
    few = (4, *HOURS_OF_FEW, CHAIN), "in a run of few steps of h, each of very many by a tolerance"
    for (what, command, number), ((seconds, *options), where) in ((usr1, interval), (term, interval), (term, few)):
        process = begin(*command, *options, "-o", f"{base}/interval")
        time.sleep(seconds)
        process.send_signal(number)
        said = ends_soon(process)
        check(process.returncode == 75 and stopped_words(said),
              f"{what} {where}: code {process.returncode}, {said.strip()[:200]}")
    given = ",".join(f"8/{steps}" for steps in range(2 * 10**7, 2 * 10**7 + 64))
    process = subprocess.Popen([STUDY, "--cost", "--steppers", "exact", "--h", given, "--repeats", "1", "--t-end", "8", "-o", f"{base}/given",
                                PENDULUM], env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    process.stdout.readline()
    process.send_signal(signal.SIGTERM)
    said = ends_soon(process)
    check(process.returncode == 75 and stopped_words(said), f"TERM among the steps of --cost --h: code {process.returncode}, {said.strip()[:200]}")
    process = begin(*mpirun(), *HOURS, "-o", f"{base}/one", CHAIN)
    worker = rank_of(f"{base}/one", "1")
    os.kill(worker, signal.SIGTERM)
    _, said = process.communicate(timeout=PATIENCE)
    check(process.returncode == 75 and stopped_words(said), f"TERM to rank 1: code {process.returncode}, {said.strip()[:200]}")


def rank_of(folder, rank):
    """The process of a rank of the study that writes to the folder."""
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{name}/cmdline", "rb") as file:
                words = file.read().split(b"\0")
            with open(f"/proc/{name}/environ", "rb") as file:
                environment = file.read().split(b"\0")
        except OSError:
            continue
        if words[0] == STUDY.encode() and folder.encode() in words and f"OMPI_COMM_WORLD_RANK={rank}".encode() in environment:
            return int(name)
    raise AssertionError("there is no such rank")


def ours(said):
    """Without what mpirun says of its own where it cannot be quiet."""
    return said if CAN_BE_QUIET else "".join(line for line in said.splitlines(True) if line.startswith("vti-"))


def by_dev(base):
    """As ./dev starts it: the code is the study's, and mpirun says nothing of its own, if it can be quiet."""
    environment = dict(ENVIRONMENT, RANKS="2", PATH=os.path.dirname(MPIRUN) + ":" + os.environ["PATH"], OMPI_MCA_orte_execute_quiet="1")
    script = ["sh", "-euc", '. "$0"; ranks "$@"', RANKS, STUDY]
    done = run(*script, "--h", "100", "-o", f"{base}/refused", PENDULUM, env=environment)
    said = ours(done.stderr)
    check(done.returncode == 1 and said.count("\n") == 1 and said.startswith("vti-study: --h"),
          f"a refusal: code {done.returncode}, {done.stderr.strip()!r}")
    done = run(*script, "--h", "1/64", "--no-plot", "-o", f"{base}/good", PENDULUM, env=environment)
    check(done.returncode == 0 and done.stderr == "", f"a study: code {done.returncode}, {done.stderr.strip()!r}")
    terminal = Terminal(*script, *HOURS, "-o", f"{base}/c", CHAIN, environment=environment)
    check(terminal.until("runs ["), "a study of hours begins, with a bar")
    os.write(terminal.ours, b"\x03")
    code = terminal.end()
    check(code == 75 and stopped_words(terminal.said) and "-----" not in ours(terminal.said), f"Ctrl-C: code {code}")
    with subprocess.Popen([*script, *HOURS, "-o", f"{base}/t", CHAIN], env=environment, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True) as process:
        check("after a reference" in process.stdout.readline(), "a study of hours begins")
        process.send_signal(signal.SIGTERM)
        _, said = process.communicate(timeout=PATIENCE)
    check(process.returncode == 75 and stopped_words(said) and ours(said).count("\n") == 1,
          f"SIGTERM: code {process.returncode}, {said!r}")


for topic in (first_line, bars, lines, ctrl_c, signals, by_dev):
    started = time.monotonic()
    with tempfile.TemporaryDirectory() as root:
        topic(root)
    print(f"        {topic.__name__}: {time.monotonic() - started:.1f} s")
conclude()
