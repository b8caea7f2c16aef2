#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""vti-check as users meet it: plugins, JSON, refusals, exit status; and the example hosts.
test_program.py VTI_CHECK PLUGIN EXAMPLE..."""
import json
import subprocess
import sys

from tally import check, conclude

program, plugin, examples = sys.argv[1], sys.argv[2], sys.argv[3:]
OLD_SPIN = "rotation is pushed with the old spin: energy grows"


def run(*arguments):
    result = subprocess.run([program, *arguments], check=False, capture_output=True, text=True, timeout=600)
    return result.returncode, result.stdout, result.stderr


code, out, err = run("--plugin", plugin + ":right")
check(code == 0 and "no fault found\n" in out and "FAIL" not in out and err == "", "a plugin without fault passes")
code, out, err = run("--plugin", plugin + ":old_spin")
check(code == 1 and OLD_SPIN in out, "a plugin with a fault is told so")

code, out, err = run("--plugin", plugin + ":old_spin", "--json")
report = json.loads(out)
check(code == 1 and report["faults"] == [OLD_SPIN] and report["remarks"] == [], "JSON has the sentence")
check({line["verdict"] for line in report["checks"]} <= {"pass", "note", "fail"} and len(report["checks"]) > 20
      and any(line["verdict"] == "fail" for line in report["checks"]), "JSON has the checks")
check(json.loads(run("--rival", "rk8pd", "--json")[1])["faults"] == [], "JSON has null for what is not finite")

code, out, err = run("--plugin", plugin + ":still")
check(code == 1 and "vti-check --translation" in out, "what does not turn bodies is told of --translation")
code, out, err = run("--plugin", plugin + ":still", "--translation")
check(code == 0 and "no fault found, but:\n" in out and "FAIL" not in out and "rotation is not looked at" in out,
      "and passes with it")
words = ("spin", "moment ", "attitude", "pendulum", "turn", "torsion")
check(not [line for line in out.splitlines() if any(word in line for word in words)], "no line is about rotation then")
code, out, err = run("--plugin", plugin + ":still_and_late", "--translation", "--json")
report = json.loads(out)
check(code == 1 and report["faults"] == ["order 1: velocities are half a kick late"]
      and report["remarks"] == ["translation only: rotation is not looked at"], "a fault of translation, as JSON")
code, out, err = run("--translation")
faulty = {line.split()[0] for line in out.splitlines() if not line.startswith(" ") and "no fault" not in line}
# stable at smaller steps only than those that the check takes
short_reach = {"an10-mid", "an10-fine", "abm8", "abm10", "abm12"}
check(code == 1 and faulty == {"vti3", "quat-euler", "campello"} | short_reach and "spin" not in out, "all methods, translation only")

code, out, err = run("--inertia")
faulty = {line.split()[0] for line in out.splitlines() if not line.startswith(" ") and "no fault" not in line}
check(code == 1 and faulty == {"vti3", "yade-aspherical"} and out.count("slender") == 2, "all methods for bodies of three moments")
check(all(line[25:].strip() for line in out.splitlines()), "... of which each line says something")
check(run("--inertia", "--rival", "no-squish")[0] == 0 and "--rival    buss" in run("--inertia", "--list")[1], "... each, and by name")

code, out, err = run("--list")
named = {tuple(line.split()[:2]) for line in out.splitlines()}
check(code == 0 and {("--stepper", "vti2"), ("--rival", "lgvi")} <= named, "--list names both kinds")
check({("--rival", name) for name in ("campello-0", "campello-1", "abm4")} <= named, "... and rivals that are checked by name only")
check(("--rival", "no-squish") not in named and "order 1" in run("--rival", "campello-1")[1], "... but none of other bodies")
check(run("--help")[0] == 0 and "Usage" in run("--help")[1], "--help helps")
for arguments, why in ((("--stepper", "lgvi"), "no stepper of that name"), (("--rival", "vti2"), "no rival of that name"),
                       (("--rival", "no-squish"), "no-squish: moves bodies of three moments; add --inertia"),
                       (("--rival", "no-squish", "--translation"), "give --inertia in place of --translation"),
                       (("--rival", "lgvi", "--inertia"), "lgvi: moves spheres; leave out --inertia"),
                       (("--stepper",), "needs a value"), (("--nonsense",), "is not an option"), (("vti2",), "is not an option"),
                       (("--inertia", "--translation"), "leave out one"), (("--json",), "needs the name"), (("--stepper", "vti1", "--rival", "lgvi"), "only one stepper"),
                       (("--plugin", plugin), "is not FILE.so:SYMBOL"), (("--plugin", plugin + ":none"), "has no symbol none"),
                       (("--plugin", "/nowhere.so:x"), "nowhere.so")):
    code, out, err = run(*arguments)
    check(code == 2 and why in err and err.count("\n") == 1 and out == "", f"refused: {' '.join(arguments)}: {err.strip()}")

for example in examples:
    result = subprocess.run([example], check=False, capture_output=True, text=True, timeout=600)
    check(result.returncode == 0 and "no fault found" in result.stdout and "FAIL" not in result.stdout, example)
conclude()
