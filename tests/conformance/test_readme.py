#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Code in the documents is quoted from programs that the tests run, their commands and links exist, and numbers that
they tell of
measurements are those measured.      test_readme.py PROJECT"""
import difflib
import pathlib
import re
import sys

from tally import check, conclude

project = pathlib.Path(sys.argv[1])
SUFFIXES = {"c": (".c",), "cpp": (".cpp",), "fortran": (".f90", ".f")}
sources = {language: "\n".join(path.read_text(encoding="utf-8") for path in sorted((project / "examples").rglob("*"))
                               if path.suffix in suffixes) for language, suffixes in SUFFIXES.items()}
commands = (project / "dev").read_text(encoding="utf-8")


def blocks(page, text):
    """The blocks of a page by language, each looked at; the rest is checked by what runs it, test_installed.py."""
    found = re.findall(r"^```(\w*)\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    for language, block in found:
        first = block.strip().splitlines()[0].strip()
        if language in SUFFIXES:
            check(block in sources[language], f"{page}: {language} block '{first}' is quoted from examples/")
        if language == "diff":
            legacy = [(project / "examples" / "legacy" / name).read_text(encoding="utf-8").splitlines(keepends=True)
                      for name in ("before.f", "after.f")]
            lines = list(difflib.unified_diff(*legacy))
            check(block == "".join(lines[3:]), f"{page}: the difference of before.f and after.f is as shown")
    return [language for language, _ in found], found


def shown(page):
    """Commands of ./dev exist. Meson's are run by test_plain.py, those that compile by test_installed.py."""
    text = (project / page).read_text(encoding="utf-8")
    languages, found = blocks(page, text)
    for line in "".join(block for language, block in found if language == "sh").splitlines():
        if re.match(r"(meson|export|cc|gfortran) ", line) and page == "README.md":
            continue
        name = re.match(r"\./dev (\w+)", line)
        check(name is not None and re.search(rf"^{name[1]}\)$", commands, re.MULTILINE) is not None, f"{page}: '{line}' exists")
    return text, languages


def readme():
    text, languages = shown("README.md")
    check(languages.count("c") >= 2 and languages.count("fortran") >= 1, "there is C and Fortran in the README")
    long = [line for line in text.splitlines() if len(line) > 130]
    check(not long, f"its lines have at most 130 columns {long}")
    return text


def anchors(page):
    """What GitHub calls the headings of a page."""
    headings = re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL),
                          re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}


def links():
    """What pages link to is there, sections too."""
    for page in (project / "README.md", project / "CONTRIBUTING.md", *sorted((project / "docs").glob("*.md"))):
        text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
        found = [link for link in re.findall(r"\]\(([^()\s]+)\)", text) if "://" not in link]
        lost = []
        for link in found:
            name, _, section = link.partition("#")
            target = page.parent / name if name else page
            if not target.exists() or (section and section not in anchors(target)):
                lost.append(link)
        check(not lost, f"{page.name}: its {len(found)} links lead somewhere {lost}")


def pictures(page):
    """Each is there, a PNG that is no burden to a clone."""
    text = page.read_text(encoding="utf-8")
    found = re.findall(r"\[[^\]]*\]\(([\w./-]+\.png)\)", text)
    for name in found:
        content = (page.parent / name).read_bytes() if (page.parent / name).is_file() else b""
        check(content.startswith(b"\x89PNG\r\n") and len(content) < 300_000, f"{page.name}: {name} is a PNG of {len(content)} bytes")
    return found


def linking():
    text = (project / "docs" / "linking.md").read_text(encoding="utf-8")
    languages, _ = blocks("linking.md", text)
    check(set(languages) == {"c", "cpp", "fortran", "sh", "cmake", "meson", "ini", "diff"}, "linking.md shows every language and tool")
    check(languages.count("fortran") == 4, "linking.md shows both kinds of Fortran")
    names = "\n".join(path.read_text(encoding="utf-8").lower() for folder in ("include", "fortran")
                      for path in (project / folder).iterdir())
    for name in sorted(set(re.findall(r"`\W?((?:vti_[a-z_]+|VTI[A-Z0-9_]+))\b", text))):
        check(name.lower() in names or name in ("vti_dep", "vti_fortran_dep"), f"linking.md: {name} exists")
    built = re.findall(r"'(vti_\w+)\.f90'", (project / "fortran/meson.build").read_text(encoding="utf-8"))
    told = re.findall(r"`(vti_\w+)`", text.partition("compile the sources in `share/vti/fortran`")[2].partition("and `vti_rrv.c`")[0])
    check(told == built, f"linking.md: sources of Fortran in their order: {told}")
    return text


def versions():
    """One version in all places that name it."""
    places = {"include/vti.h": r'VTI_VERSION_STRING "(.*)"', "CITATION.cff": r"(?m)^version: (.*)$",
              "CHANGELOG.md": r"(?m)^## (\S+)", "docs/linking.md": r"(?m)^revision = v(.*)$"}
    found = {name: re.search(pattern, (project / name).read_text(encoding="utf-8"))[1] for name, pattern in places.items()}
    check(len(set(found.values())) == 1, f"one version: {found}")


def maps():
    """What architecture.md and CONTRIBUTING.md name is there: paths, and names of files in the rooms."""
    files = {path.name for folder in ("include", "src", "drivers", "fortran", "tests", "scenes", "examples", "docs")
             for path in (project / folder).rglob("*")}
    for page in ("docs/architecture.md", "CONTRIBUTING.md"):
        named = set(re.findall(r"`([\w./-]+\.(?:c|h|py|sh|txt|md|yaml|yml|f90|build)|[\w-]+/[\w./-]*)`",
                               (project / page).read_text(encoding="utf-8")))
        lost = [name for name in named if "NAME" not in name and not name.startswith("build/") and not (project / name).exists()
                and ("/" in name or (name not in files and not (project / name).exists()))]
        check(len(named) > 20 and not lost, f"{page}: all {len(named)} files that it names are there {lost}")


def statuses():
    """Fortran's constants of statuses are those of the table."""
    rows = dict(re.findall(r"ROW\((VTI_E_\w+), (-\d+)", (project / "include/vti_status.h").read_text(encoding="utf-8")))
    fortran = dict(re.findall(r"\b(VTI_E_\w+) = (-\d+)", (project / "fortran/vti_types.f90").read_text(encoding="utf-8")))
    check(len(rows) > 15 and rows == fortran, f"vti_types.f90 has the statuses of vti_status.h {set(rows.items()) ^ set(fortran.items())}")


def prices(text):
    """Of docs/accuracy.md: the least time of ours as a share of the best rival's, by error and scene."""
    table = text.split("The cheapest of ours in time;")[1].split("\n\n")[1].splitlines()
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in table]
    return {error: {row[0]: float(share[1]) for row in rows[2:] if (share := re.search(r", ([\d.]+) / ", row[column]))}
            for column, error in enumerate(rows[0]) if column > 0}


def claims():
    """What README and steppers.md tell of evaluations, steps, times and instructions is what the pages have that
    measurements write."""
    said = {name: " ".join((project / name).read_text(encoding="utf-8").split()) for name in ("README.md", "docs/steppers.md")}
    accuracy = (project / "docs/accuracy.md").read_text(encoding="utf-8")
    for scene, place in (("pile", " of the evaluations of the best rival on `pile` (t = 1/2, errors of 1e-2 and 1e-4)"),
                         ("torus-2", " on `torus` (t = 2, 1e-4, 1e-6 and 1e-8)"), ("block", " on `block` (t = 4, 1e-6 and 1e-8)")):
        row = re.search(rf"^\| {scene} (.*)$", accuracy.split("| evaluations to |")[1], re.MULTILINE)[1]
        shares = re.findall(r"\| (\d\.\d\d) \(AN", row)[-place.count("1e-"):]
        told = ", ".join(shares[:-1]) + " and " + shares[-1] + place
        check(told in said["docs/steppers.md"], f"steppers.md: multistep methods take {told}")
    of = prices(accuracy)
    fine = [share for error in ("1e-4", "1e-6", "1e-8") for share in of[error].values()]
    coarse = of["1e-2"].values()
    check("No rival takes less time than the best of ours at any error of the list" in accuracy and "by more than the 5 % that" in accuracy and
          "No rival is faster at any of these errors by more than the 5 % that count as a tie." in said["README.md"],
          "README: that none is faster is as docs/accuracy.md has it")
    rivals = set(re.findall(r"^\| .*? \(`([^`|]+)`\) \| rival \|", accuracy, re.MULTILINE))
    check(f"measures our steppers and {len(rivals)} **rivals**" in said["README.md"], f"README: there are {len(rivals)} rivals in docs/accuracy.md")
    peers = (project / "docs/peers.md").read_text(encoding="utf-8")
    steps = {code: (least, most) for code, least, most in re.findall(r"(\w+) takes ([\d.]+) to ([\d.]+) times(?:,| as many)", peers)}
    ways = ", ".join(f"{code} {'takes ' if code == 'LAMMPS' else ''}{' to '.join(steps.get(code, ['none']))}" for code in ("LAMMPS", "LIGGGHTS", "YADE"))
    gran = [float(cell.split()[0]) for row in re.findall(r"^\| LIGGGHTS: touching pair, (.*) \|$", (project / "docs/performance.md").read_text(
        encoding="utf-8"), re.MULTILINE) for cell in row.split(" | ")[4:]]
    heap = min(re.findall(r"^\| heap .* (\d\.\d\d) \(", peers, re.MULTILINE))
    others = [float(ratio) for ratio in re.findall(r"^\| (?:pile|agglomerate|torus) .* (\d+\.\d\d) \(", peers, re.MULTILINE)]
    table = dict(re.findall(r"^\| ([^|]+) \| (\d+) \|$", (project / "docs/steppers.md").read_text(encoding="utf-8"), re.MULTILINE))
    bond, touch, loss = (int(table[row]) for row in ("binder: moment, axial, shear", "contact (touching pair)", "friction and dashpot together"))
    pendulum = re.search(r"A step of 512 pendulums takes \d+ instructions per pendulum", said["docs/steppers.md"])[0]
    for told in (f"On {'nine' if len(coarse) == 9 else len(coarse)} scenes the best of ours takes {min(fine):g} to {max(fine):g} of the best rival's time to errors of 1e-4 to 1e-8",
                 f"To 1e-2 it takes {min(coarse):g} to {max(coarse):g}",
                 f"for an error of 1e-3 in an impact with dashpots and friction {ways} times as many steps as `vti2`", f"and takes {heap} of it",
                 f"for such a pair LIGGGHTS takes {min(gran):g} to {max(gran):g} of our time a step",
                 f"LAMMPS takes {min(others):g} to {max(others):g} times our time on pile, agglomerate and torus", pendulum,
                 f"stretches and shears takes {bond} a step, an elastic touching pair {touch}",
                 f"with friction and dashpots a touching pair takes {(touch + loss) / touch:.1f} times as many"):
        check(told in said["README.md"], f"README: {told}, as docs/ has it")
    check(f"takes {(touch + loss) / touch:.1f} times the instructions of an elastic one" in said["docs/steppers.md"], "steppers.md: the same")


versions()
maps()
statuses()
claims()
links()
first = pictures(project / "README.md")
check(len(first) > 0, "the README has a picture")
check(len(pictures(project / "docs" / "accuracy.md")) > 0, "accuracy.md has pictures")
texts = readme() + linking() + shown("docs/programs.md")[0] + shown("docs/steppers.md")[0]
for path in re.findall(r"`((?:scenes|examples|include|docs|drivers|src|fortran)/[\w./-]+)`", texts):
    check((project / path).exists() or path.startswith("include/vti/"), f"{path} exists")
conclude()
