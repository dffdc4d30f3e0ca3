#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the validation cases and writes docs/validation.md with its figures (`make validate`).

Each case is a test of tests/validation: a C program of the build or a Python script. Its header
comment says setup, formula, source and tolerance, its checks and curves come as CSV files (see
evidence.h there and common_runs.py), and cases.py names its figure. The page is made from these alone.

    validation/report.py BUILD [--jobs 2] [--only 03,14]
"""
import argparse
import concurrent.futures
import csv
import os
import re
import shutil
import subprocess
import sys
import time

import numpy

import cases

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
TESTS = os.path.join(ROOT, "tests", "validation")
DOCS = os.path.join(ROOT, "docs")
SHOWN = 6  # 1   rows of one quantity in a table; of more the one furthest off is shown
SECTIONS = ("Setup", "Formula", "Source", "Tolerance")
HEAD = """<!-- Written by `make validate`; do not edit. -->
# Validation

Every row was measured by the tests in `tests/validation` on the code as it is, and compared with theory
or with published numbers; `make validate` runs them again and rewrites this page. *Tolerance* is what
the test enforces and why; a verdict is *passed* only if every check of the case holds. Where a quantity
was measured at many points, the table has the one furthest off (for its tolerance), and how many there were.

"""


def source_of(stem):
    """The file of a case and its kind."""
    for ending in (".c", ".py"):
        path = os.path.join(TESTS, stem + ending)
        if os.path.exists(path):
            return path
    sys.exit(f"report.py: there is no {stem}.c or {stem}.py in {TESTS}")


def header_of(path):
    """Title and sections of a test's header comment."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    if path.endswith(".c"):
        lines = re.match(r"(?://.*\n)+", text).group().splitlines()[1:]
        lines = [line[2:].strip() for line in lines]
    else:
        lines = [line.strip() for line in re.search(r'"""(.*?)"""', text, re.S).group(1).splitlines()]
    title, found, name = [], {}, None
    for line in lines:
        word = line.split(" ", 1)[0]
        if word in SECTIONS:
            name, line = word, line[len(word):].strip()
        (found.setdefault(name, []) if name else title).append(line)
    return " ".join(title).strip(), {k: " ".join(v).strip() for k, v in found.items()}


def run(stem, build, data):
    """Runs one case; its output, exit code and seconds."""
    path = source_of(stem)
    work = os.path.join(os.path.dirname(data), "work", stem)
    os.makedirs(work, exist_ok=True)
    if path.endswith(".c"):
        command = [os.path.join(build, "tests", "validation_" + stem)]
    else:
        command = [sys.executable, path, os.path.join(build, "quern")]
    begin = time.monotonic()
    env = dict(os.environ, QUERN_VALIDATION=data, QUERN_SOURCE_DIR=ROOT, OMP_NUM_THREADS="1",
               PYTHONDONTWRITEBYTECODE="1", MPLBACKEND="Agg")
    done = subprocess.run(command, cwd=work, env=env, text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    seconds = time.monotonic() - begin
    print(f"{'passed' if done.returncode == 0 else 'FAILED'}  {stem}  {seconds:.0f} s", flush=True)
    if done.returncode:
        print(done.stdout, flush=True)
    return done.stdout, done.returncode


def rows(path):
    """Rows of a CSV file as dictionaries; none if it is not there."""
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(file))


def columns(path):
    """Columns of a CSV file of numbers, as arrays."""
    return numpy.loadtxt(path, delimiter=",", skiprows=1, ndmin=2).T


def plain(text):
    """Text as Markdown shows it unchanged."""
    return re.sub(r"([*_<>|\[\]`\\])", r"\\\1", text)


def number(value):
    """Six digits, without the noise of a rounding error."""
    value = float(value)
    return "0" if value == 0 else f"{value:.6g}"


def table(checks):
    """The table of a case: quantities in their order, few rows of each."""
    groups = {}
    for row in checks:
        groups.setdefault(row["quantity"], []).append(row)
    lines = ["| quantity | at | measured | expected | tolerance |", "|---|---|---|---|---|"]
    for quantity, group in groups.items():
        note = ""
        if len(group) > SHOWN:
            note = f" ({len(group)} points)"
            group = [max(group, key=off)]
        for row in group:
            sign = "" if float(row["tolerance"]) == 0 else "±"
            lines.append(f"| {plain(quantity)}{note} | {plain(row['at'])} | {number(row['value'])} | "
                         f"{number(row['expected'])} | {sign}{number(row['tolerance'])} |")
    return lines


def off(row):
    """How far a row is off, in tolerances."""
    distance = abs(float(row["value"]) - float(row["expected"]))
    tolerance = float(row["tolerance"])
    return distance / tolerance if tolerance > 0 else (0 if distance == 0 else float("inf"))


def promises(output):
    """The sentences a case has checked, and whether each held."""
    found = re.findall(r"^(ok  |FAIL) (\w+)", output, re.M)
    return [(name.replace("_", " "), verdict == "ok  ") for verdict, name in found]


def section(case, outcome, data, images):
    """Lines of one case, its summary row, and whether it passed."""
    output, code = outcome
    title, parts = header_of(source_of(case.stem))
    title = title.rstrip(".")
    checks = rows(os.path.join(data, case.stem + ".checks.csv"))
    held = promises(output)
    passed = code == 0
    lines = [f"## {plain(title)}", "", f"Test: `{os.path.relpath(source_of(case.stem), ROOT)}`", ""]
    for name in SECTIONS:
        if name in parts:
            lines += [f"**{name}.** {plain(parts[name])}", ""]
    if checks:
        lines += table(checks) + [""]
    if case.figure:
        picture = os.path.join(images, case.stem + ".png")
        try:
            case.figure(lambda name: columns(os.path.join(data, f"{case.stem}.{name}.csv")), picture)
            lines += [f"![{plain(case.caption)}]({os.path.relpath(picture, DOCS)})", "", case.caption, ""]
        except OSError as error:
            passed = False
            lines += [f"**There is no figure**: {plain(str(error))}", ""]
    lines += ["Checked:", ""]
    lines += [f"- {sentence}{'' if good else ' (**failed**)'}" for sentence, good in held] + [""]
    verdict = "passed" if passed else "**failed**"
    lines += [f"Verdict: {verdict}.", ""]
    anchor = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
    summary = f"| [{plain(title)}](#{anchor}) | {case.covers} | {len(held)} | {len(checks)} | {verdict} |"
    return lines, summary, passed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", help="beginnings of names, with commas; writes no page")
    options = parser.parse_args()
    page = "validation.md"
    chosen = [c for c in cases.CASES
              if not options.only or c.stem.startswith(tuple(options.only.split(",")))]
    build = os.path.abspath(options.build)
    data = os.path.join(build, "validation")
    images = os.path.join(DOCS, "img", "validation") if not options.only else data
    shutil.rmtree(data, ignore_errors=True)
    os.makedirs(data)
    os.makedirs(images, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        outcomes = list(pool.map(lambda c: run(c.stem, build, data), chosen))
    lines, overview, failed = [], [], 0
    for case, outcome in zip(chosen, outcomes):
        more, summary, passed = section(case, outcome, data, images)
        lines += more
        overview.append(summary)
        failed += not passed
    path = os.path.join(DOCS, page) if not options.only else os.path.join(data, page)
    with open(path, "w", encoding="utf-8") as file:
        file.write(HEAD)
        file.write("\n".join(["| case | stands for | promises | numbers | verdict |", "|---|---|---|---|---|"]
                             + overview + ["", *lines]))
    print(f"{len(chosen) - failed} cases passed, {failed} failed; {os.path.relpath(path)}")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
