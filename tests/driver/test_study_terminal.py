#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vti-study as a person at a terminal sees it, under mpirun: what will be done, a bar with the time left for the reference and for
the runs, and how Ctrl-C and signals end it.      test_study_terminal.py VTI_STUDY MPIRUN SCENES RANKS.SH"""
import fcntl
import os
import pty
import select
import signal
import subprocess
import sys
import tempfile
import termios
import time

from programs import ENVIRONMENT, PATIENCE, run
from tally import check, conclude

STUDY, MPIRUN, SCENES, RANKS = map(os.path.abspath, sys.argv[1:5])
CHAIN, PENDULUM = (os.path.join(SCENES, name + ".yaml") for name in ("chain", "pendulum"))
HOURS = ("--h", "2^-9:2^-27", "--no-plot")


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

    def read(self):
        """What comes next, "" at the end."""
        ready, _, _ = select.select([self.ours], [], [], PATIENCE)
        try:
            new = os.read(self.ours, 65536).decode() if ready else ""
        except OSError:  # all who had it open have closed it
            new = ""
        self.said += new
        return new

    def until(self, words):
        while words not in self.said and self.read():
            pass
        return words in self.said

    def end(self):
        """Its code. After a kill of ranks mpirun may stay (test_study_resume.py): what says nothing for long is killed too."""
        while self.read():
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
        terminal = Terminal(MPIRUN, "-n", str(ranks), STUDY, "--no-plot", "-o", f"{base}/{ranks}", PENDULUM)
        code, said = terminal.end(), terminal.said
        check(code == 0 and has_bar(said, "reference") and has_bar(said, "runs"), f"{ranks} ranks: bars of the reference and the runs")
        table = said.replace("\r\n", "\n").split("stepper  ")[-1]
        check("\r" not in table and "fitted order" in table, "... and the table after them")
    with open(f"{base}/said.txt", "w+", encoding="utf-8") as file:
        terminal = Terminal(*mpirun("--no-plot", "-o", f"{base}/stderr", PENDULUM), stdout=file)
        code = terminal.end()
        file.seek(0)
        said = file.read()  # "\r" as "\n"
    check(code == 0 and has_bar(terminal.said, "runs") and "[" not in said and "fitted order" in said,
          "stdout in a file: the bar is on stderr")
    terminal = Terminal(STUDY, "--no-plot", "-o", f"{base}/alone", PENDULUM)
    check(terminal.end() == 0 and has_bar(terminal.said, "runs"), "without mpirun: a bar")
    terminal = Terminal(*mpirun("--cost", "--steppers", "vti2", "--evals", "1000", "--repeats", "1", "-o", f"{base}/cost", PENDULUM))
    check(terminal.end() == 0 and all(has_bar(terminal.said, what) for what in ("reference", "times"))
          and "\rerrors [" in terminal.said, "cost: bars")
    hidden = run("sh", "-c", '"$@" | cat', "sh", *mpirun("--no-plot", "-o", f"{base}/told", PENDULUM),
                 env=dict(ENVIRONMENT, VTI_TERMINAL="1"), text=False)
    check(has_bar(hidden.stderr.decode(), "runs") and b"\r" not in hidden.stdout, "VTI_TERMINAL=1 where no terminal can be found")


def stopped_words(said):
    return "stopped" in said and "--resume" in said


def asked_by(base, what, waits_for, *arguments):
    """Ctrl-C to mpirun, which kills its ranks a second after it has told them to end: a busy machine may not let them say a word
    in it, and is asked again."""
    for attempt in range(10):
        terminal = Terminal(*mpirun(*arguments, "-o", f"{base}/{attempt}"))
        begun = terminal.until(waits_for)
        os.write(terminal.ours, b"\x03")
        code = terminal.end()
        if code == 0 or stopped_words(terminal.said):
            break
    check(begun and code != 0 and stopped_words(terminal.said), f"{what}: code {code}, {terminal.said[-160:].strip()!r}")


def ctrl_c(base):
    asked_by(base + "/runs", "Ctrl-C in runs of hours", "runs [", *HOURS, CHAIN)
    asked_by(base + "/reference", "Ctrl-C in a reference of hours", "reference [", "--t-end", "1e7", "--h", "1", "--no-plot", PENDULUM)


def begin(*command):
    """Started, and its first line said, after which signals are heard on all ranks."""
    process = subprocess.Popen(command, env=ENVIRONMENT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    check("after a reference" in process.stdout.readline(), "a study of hours begins")
    return process


def signals(base):
    """To mpirun, which hands SIGUSR1 on; to the only rank that there is; to one of two."""
    for what, command, number in (("USR1 to mpirun", mpirun(), signal.SIGUSR1), ("TERM without mpirun", [STUDY], signal.SIGTERM),
                                  ("INT without mpirun", [STUDY], signal.SIGINT)):
        process = begin(*command, *HOURS, "-o", f"{base}/out", CHAIN)
        process.send_signal(number)
        _, said = process.communicate(timeout=PATIENCE)
        check(process.returncode == 75 and stopped_words(said), f"{what}: code {process.returncode}, {said.strip()[:200]}")
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


def by_dev(base):
    """As ./dev starts it: the code is the study's, and mpirun says nothing of its own."""
    environment = dict(ENVIRONMENT, RANKS="2", PATH=os.path.dirname(MPIRUN) + ":" + os.environ["PATH"], OMPI_MCA_orte_execute_quiet="1",
                       PRTE_MCA_prte_execute_quiet="1")
    script = ["sh", "-euc", '. "$0"; ranks "$@"', RANKS, STUDY]
    done = run(*script, "--h", "100", "-o", f"{base}/refused", PENDULUM, env=environment)
    check(done.returncode == 1 and done.stderr.count("\n") == 1 and done.stderr.startswith("vti-study: --h"),
          f"a refusal: code {done.returncode}, {done.stderr.strip()!r}")
    done = run(*script, "--h", "1/64", "--no-plot", "-o", f"{base}/good", PENDULUM, env=environment)
    check(done.returncode == 0 and done.stderr == "", f"a study: code {done.returncode}, {done.stderr.strip()!r}")
    terminal = Terminal(*script, *HOURS, "-o", f"{base}/c", CHAIN, environment=environment)
    check(terminal.until("runs ["), "a study of hours begins, with a bar")
    os.write(terminal.ours, b"\x03")
    code = terminal.end()
    check(code == 75 and stopped_words(terminal.said) and "-----" not in terminal.said, f"Ctrl-C: code {code}")
    with subprocess.Popen([*script, *HOURS, "-o", f"{base}/t", CHAIN], env=environment, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True) as process:
        check("after a reference" in process.stdout.readline(), "a study of hours begins")
        process.send_signal(signal.SIGTERM)
        _, said = process.communicate(timeout=PATIENCE)
    check(process.returncode == 75 and stopped_words(said) and said.count("\n") == 1, f"SIGTERM: code {process.returncode}, {said!r}")


for topic in (first_line, bars, ctrl_c, signals, by_dev):
    started = time.monotonic()
    with tempfile.TemporaryDirectory() as root:
        topic(root)
    print(f"        {topic.__name__}: {time.monotonic() - started:.1f} s")
conclude()
