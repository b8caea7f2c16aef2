#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A manual page says all that its program says of itself, and groff finds nothing wrong.      test_manual.py VERSION PAGE..."""
import pathlib
import re
import shutil
import subprocess
import sys

from tally import check, conclude

version = sys.argv[1]
pages = [pathlib.Path(word) for word in sys.argv[2:]]
check(len(pages) >= 4, f"there are {len(pages)} pages")
for page in pages:
    text = page.read_text(encoding="utf-8")
    said = subprocess.run([page.with_suffix(""), "--help"], check=True, stdout=subprocess.PIPE, encoding="utf-8").stdout
    plain = re.sub(r"^\.\w+ ?|\\f[BIR]|\\&|\\/|\\,", "", text, flags=re.MULTILINE).replace("\\-", "-").replace("\\e", "\\")
    plain = re.sub(r"\\\(aq|\\\(cq", "'", plain).replace("\\(dq", '"')
    words = re.sub(r"^(usage|   or):", "", said, flags=re.IGNORECASE | re.MULTILINE).split()
    lost = [word for word in words if word not in plain]
    check(len(words) > 50 and not lost, f"{page.name} has all {len(words)} words of --help {lost[:5]}")
    options = re.findall(r"^ {2,6}(-.*?)(?:  |$)", said, re.MULTILINE)
    check(len(options) > 2 and all(option.split()[0].strip(",") in plain for option in options), f"its options are {', '.join(options)}")
    check(version in text.splitlines()[1], "and it names the version")
    if shutil.which("groff"):
        result = subprocess.run(["groff", "-man", "-Tutf8", "-ww", page], check=False, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        check(result.returncode == 0 and not result.stderr, f"groff: {result.stderr.decode() or 'no warning'}")
conclude()
