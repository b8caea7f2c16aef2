#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vti-run and vti-study that are killed, stopped or out of space at every call that changes a file: every file is the
earlier one or the new one, never a piece; want of space is one line; --resume goes on from what was kept, ends with the
same bytes and leaves nothing else. Short: the first and the last such call of each kind on each file.
    test_trouble.py TROUBLE VTI_RUN VTI_STUDY VTI_ADVISE SCENES [long]"""
import os
import shutil
import signal
import sys
import tempfile
import time

import programs
from tally import check, conclude

TROUBLE, RUN, STUDY, ADVISE, SCENES = map(os.path.abspath, sys.argv[1:6])
LONG = len(sys.argv) > 6


def start(command, folder, how="", at=0, log="", **options):
    """A program in a folder, with trouble there if how says which."""
    preload = {"LD_PRELOAD": TROUBLE, "TROUBLE_IN": folder, "TROUBLE_HOW": how, "TROUBLE_AT": str(at), "TROUBLE_LOG": log}
    return programs.run(*command(folder), env={**programs.ENVIRONMENT, **(preload if how else {})}, **options)


class Topic:
    def __init__(self, base, command, earlier, journal, keeps, timed=()):
        """command and earlier give the words that make files, and other files of the same names, in a folder; their
        journal is beside them and has something to go on from after so many commits, each of which cuts SQLite's own
        journal to nothing; the timed ones are never the same."""
        self.command, self.journal, self.timed = command, journal, timed
        self.name, self.folder, self.old = os.path.basename(base), f"{base}/new", f"{base}/old"
        results = [start(earlier, self.old), start(command, f"{base}/whole")]
        self.earlier, self.whole = self.files(self.old), self.files(f"{base}/whole")
        shutil.copytree(self.old, self.folder)
        results.append(start(command, self.folder, "list", 0, f"{base}/log"))
        with open(f"{base}/log", encoding="utf-8") as log:
            self.calls = log.read().splitlines()
        commits = [k + 1 for k, call in enumerate(self.calls) if call.startswith("ftruncate") and call.endswith(f"{journal}-journal")]
        self.kept = commits[keeps - 1] if keeps else len(self.calls)
        check(all(result.returncode == 0 for result in results) and self.files(self.folder) == self.whole and self.earlier.keys() == self.whole.keys() and
              all(self.earlier[name] != self.whole[name] for name in self.whole if name not in timed),
              f"{self.name}: {len(self.calls)} calls change {', '.join(self.whole)}")

    def files(self, folder):
        return {name: b"" if name in self.timed else data for name, data in programs.contents(folder).items()}

    def is_whole(self, after):
        return all(after.get(name) == self.whole[name] for name in self.whole)

    def numbers(self, kind=""):
        """Which calls meet trouble; the first is 1."""
        chosen = [k for k, call in enumerate(self.calls) if call.startswith(kind)]
        if not LONG:
            ends = {}
            for k in chosen:
                ends.setdefault(self.calls[k], [k, k])[1] = k
            chosen = sorted({k for pair in ends.values() for k in pair})
        return [k + 1 for k in chosen]

    def met(self, how, at):
        """Trouble, and how it ends. Returns what is wrong with that, or nothing."""
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(self.old, self.folder)
        result = start(self.command, self.folder, how, at)
        after = self.files(self.folder)
        torn = [name for name in self.whole if after.get(name) not in (self.earlier[name], self.whole[name])]
        wrong = f"pieces: {torn}; " if torn else ""
        wrong += self.full(result, after, self.calls[at - 1]) if how in ("full", "once") else self.ended(result, how, after)
        again = start(self.command, self.folder)
        if at > self.kept and not self.is_whole(after) and "goes on" not in again.stdout:
            wrong += "what had been kept is lost; "
        if again.returncode != 0 or self.files(self.folder) != self.whole:
            wrong += f"goes on with code {again.returncode}: {again.stderr.strip()} {list(programs.contents(self.folder))}; "
        return wrong

    def ended(self, result, how, after):
        codes = [0, 75] if how == "term" else [-signal.SIGKILL]
        if how == "term" and "run" in self.name:
            codes = [0, 75, -signal.SIGTERM]  # the last before its first step, with nothing to go on from
            if result.returncode == codes[2] and self.journal in after:
                return "ended, and left a journal; "
        # MPI may have to say something too
        ours = [line for line in result.stderr.splitlines() if line.startswith("vti-")]
        one_line = len(ours) == (result.returncode == 75)
        return "" if result.returncode in codes and one_line else f"code {result.returncode}: {result.stderr.strip()}; "

    def full(self, result, after, call):
        ours = [line for line in result.stderr.splitlines() if line.startswith("vti-") and self.folder in line]
        beside = set(after) - set(self.whole) - {self.journal, f"{self.journal}-journal"}
        writes = call.startswith(("pwrite", "fflush", "fsync", "fclose")) and call.endswith(".part") and "/writable" not in call
        if result.returncode == 0:
            return "" if self.is_whole(after) and not beside and not writes else "all is well, it says; "
        untouched = all(after.get(name) == self.earlier[name] for name in self.whole)
        if len(ours) == 1 and (untouched or self.is_whole(after)) and not beside:
            return ""
        return f"code {result.returncode}: {result.stderr.strip()}, {list(after)}; "

    def meets(self, how, numbers):
        wrongs, begin = 0, time.monotonic()
        for at in numbers:
            wrong = self.met(how, at)
            wrongs += wrong != ""
            if wrong:
                check(False, f"{self.name}, {how} at call {at}, {self.calls[at - 1]}: {wrong}")
        check(wrongs == 0 < len(numbers), f"{self.name}, {how} at {len(numbers)} calls; {time.monotonic() - begin:.1f} s")

    def ends(self):
        """Killed, or asked to end; in the short test by turns."""
        self.meets("kill", self.numbers()[::1 if LONG else 2])
        self.meets("term", self.numbers()[0 if LONG else 1::1 if LONG else 2])


def run(*words):
    return lambda folder: [RUN, f"{SCENES}/pendulum.yaml", "--h", "2^-14", "--record", "1024", "--frames", "4096", *words,
                           "--checkpoint", "1e-9", "--resume", "-o", f"{folder}/out.h5"]


def study(*words):
    return lambda folder: [STUDY, "--no-plot", *words, "--resume", "-o", folder, f"{SCENES}/pendulum.yaml"]


def cost(*words):
    return lambda folder: [STUDY, "--cost", "--evals", "512", "--repeats", "1", "--t-end", "1", "--steppers", *words, "--resume",
                           "-o", folder, f"{SCENES}/pendulum.yaml"]


def runs(base):
    topic = Topic(base, run("--t-end", "1"), run("--t-end", "1/2"), "out.run", 2)
    topic.ends()
    topic.meets("full", topic.numbers())
    topic.meets("torn", topic.numbers("pwrite"))
    topic.meets("once", topic.numbers("" if LONG else ("fclose", "fsync")))


def studies(base, *arguments, short=()):
    """short says what is done in full in the short test."""
    topic = Topic(base, *arguments)
    topic.meets("torn", topic.numbers("pwrite"))
    topic.meets("full", topic.numbers("" if LONG or "full" in short else "fclose"))
    topic.meets("once", topic.numbers("" if LONG else ("fclose", "fsync")))
    if LONG or "kill" in short:
        topic.ends()


def lockless(base):
    """A file system without locks is written to like any other."""
    for command in (run("--t-end", "1/4"), study("--h", "1/16")):
        result = start(command, base, "nolock")
        check(result.returncode == 0, f"no locks: {result.stderr.strip()}")


def unsaid(base):
    """The files are there, and what could not be said is missed."""
    for command in (run("--t-end", "1"), study("--h", "1/16"), cost("vti1"),
                    lambda folder: [ADVISE, f"{SCENES}/spin.yaml", "--json"]):
        with open("/dev/full", "w", encoding="ascii") as full:
            result = start(command, base, stdout=full)
        ours = [line for line in result.stderr.splitlines() if line.startswith("vti-")]
        check(result.returncode == 1 and len(ours) == 1 and "standard output" in ours[0], f"terminal: {result.stderr.strip()}")
    check({"out.h5", "study.h5", "cost.csv"} <= set(os.listdir(base)), "... and the files are there")


TOPICS = {
    "run": runs,
    "study": lambda base: studies(base, study("--steppers", "vti2", "--h", "1/16,1/32"),
                                  study("--steppers", "vti1", "--h", "1/16"), "study.journal", 0,
                                  ("timing.csv",), short=("full", "kill")),
    "cost": lambda base: studies(base, cost("vti1,vti2"), cost("vti1"), "cost.journal", 0,
                                 ("cost.csv", "prices.csv", "machine.txt"), short=()),
    "lockless": lockless,
    "unsaid": unsaid,
}
with tempfile.TemporaryDirectory() as root:
    programs.ENVIRONMENT["OMPI_MCA_orte_tmpdir_base"] = root  # such ranks would share one
    for name, topic in TOPICS.items():
        os.mkdir(f"{root}/{name}")
        topic(f"{root}/{name}")
conclude()
