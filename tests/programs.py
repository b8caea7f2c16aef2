# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of programs share: how one is run, under mpirun too, how it refuses, and what it leaves in a
folder."""
import os
import subprocess
import time

PATIENCE = 300  # seconds; what takes longer hangs, on a busy machine and under sanitizers too
# Open MPI refuses root, which is who one is in a container, and more ranks than cores (said in one way up to 4 and in
# another from 5 on); its fast path between ranks needs a right that containers lack; 5 warns of ranks that no network
# joins. Looking for networks takes most of a start (pml), a single rank needs no daemon (isolated), one that waits
# spins (yield), and when one fails the others have a second to end (GRACE).
GRACE = "OMPI_MCA_odls_base_sigkill_timeout"
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1", OMPI_MCA_pml="ob1",
                   OMPI_MCA_mpi_yield_when_idle="1", OMPI_MCA_ess_singleton_isolated="1", **{GRACE: "0"},
                   OMPI_MCA_btl_tcp_if_include=os.environ.get("OMPI_MCA_btl_tcp_if_include", "127.0.0.0/8"),
                   OMPI_MCA_btl_vader_single_copy_mechanism="none", OMPI_MCA_rmaps_base_oversubscribe="1",
                   PRTE_MCA_rmaps_default_mapping_policy=":oversubscribe")


def run(*command, **options):
    """To its end, whatever that is."""
    usual = {"env": ENVIRONMENT, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, "timeout": PATIENCE}
    return subprocess.run(command, check=False, **{**usual, **options})


def run_without_place(kept, blocked, *command):
    """To its end, where the folder `blocked` is in the way, which was not there at the start: what it says first waits
    in a full pipe until it has made the file `kept`."""
    out, into = os.pipe()
    os.set_blocking(into, False)
    try:
        while True:
            os.write(into, 4096 * b"\n")
    except BlockingIOError:
        os.set_blocking(into, True)
    with subprocess.Popen(command, env=ENVIRONMENT, stdout=into, stderr=subprocess.PIPE, text=True) as process:
        os.close(into)
        while process.poll() is None and not os.path.exists(kept):
            time.sleep(0.001)
        os.makedirs(blocked)
        with os.fdopen(out, encoding="utf-8") as told:
            output = told.read().lstrip("\n")
        result = subprocess.CompletedProcess(command, process.wait(PATIENCE), output, process.stderr.read())
    os.rmdir(blocked)
    return result


def one_line(result, *words):
    """It has failed, and said so in one line with these words; mpirun may have to say something too."""
    ours = [line for line in result.stderr.splitlines() if line.startswith("vti-")]
    return result.returncode != 0 and len(ours) == 1 and all(word in ours[0] for word in words)


def contents(folder, without=()):
    """The bytes of its files by their names; None stands for a folder."""
    found = {}
    for name in sorted(set(os.listdir(folder)) - set(without)):
        path = os.path.join(folder, name)
        found[name] = None
        if not os.path.isdir(path):
            with open(path, "rb") as file:
                found[name] = file.read()
    return found


def size_of(path):
    """Of a file that may vanish at any moment."""
    try:
        return os.path.getsize(path)
    except FileNotFoundError:
        return 0


def holds(journal):
    """Something has been committed."""
    return size_of(journal) > 0 and size_of(f"{journal}-journal") == 0
