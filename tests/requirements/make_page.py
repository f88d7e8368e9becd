# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/lab/requirements.md: each requirement, the way to it in the window and on the command line, and the tests that prove it.

    make_page.py SOURCE [--check --tan PROGRAM]

Tests name what they prove by its number in a comment: in the one at the head of a file for all of its functions, elsewhere for the function
that follows. --check writes nothing and says what is wrong: a page that is not up to date, a number that no row has, a row without a test, a
text that the window does not have, an option that the program does not have."""
import argparse
import functools
import json
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

NUMBER = re.compile(r"\b([RSBC])(\d{1,2})(?:(?: to |-)\1?(\d{1,2}))?\b")
MISSING = "missing: "
HEAD = """# What TAn must do, and what proves it

Written by `./dev test --requirements` from the numbers in the comments of the tests and from `tests/requirements/rows.md`. *R* is what the paper describes or
announces, with its section; *S* where it is silent or wrong; *B* what TAn adds; *C* what the first version left open. The last column names test sources in
`tests/`, after a colon the functions, if not all of the file's.
"""


def numbers_in(text):
    """R20 to R22 means three; C60 is a molecule."""
    for kind, first, last in NUMBER.findall(text):
        for number in range(int(first), int(last or first) + 1):
            if (kind, number) != ("C", 60):
                yield f"{kind}{number}"


def comment_of(line):
    stripped = line.strip()
    return stripped if stripped.startswith(("//", "/*", "*", "#")) and not stripped.startswith("#include") else None


def tests_of(source):
    """number -> {test source: its functions, none for all}"""
    proofs = {}
    for path in sorted((source / "tests").rglob("*_test.*")):
        if path.suffix not in (".cpp", ".py", ".sh"):
            continue
        name = str(path.relative_to(source / "tests").with_suffix(""))
        waiting = []  # numbers that belong to what follows
        for line in path.read_text(encoding="utf-8").splitlines():
            comment = comment_of(line)
            if comment is not None:
                waiting += numbers_in(comment)
                continue
            function = re.match(r"\s*(?:void|def) (?:\w+::)?(\w+)\(", line)
            if function:
                for number in waiting:
                    functions = proofs.setdefault(number, {}).setdefault(name, [])
                    if functions is not None and (test := function[1].removesuffix("_data")) not in functions:
                        functions.append(test)
                waiting = []
            elif re.match(r"#include|import |from |set |class ", line):
                for number in waiting:
                    proofs.setdefault(number, {})[name] = None
                waiting = []
    return proofs


def rows_of(source):
    """Lines of the page: a heading, or the cells of a row."""
    for line in (source / "tests/requirements/rows.md").read_text(encoding="utf-8").splitlines():
        if line.startswith("## "):
            yield line
        elif re.match(r"\| [RSBC]\d", line):
            yield [cell.strip() for cell in line.strip().strip("|").split("|")]


def page_of(rows, proofs):
    lines = [HEAD]
    for row in rows:
        if isinstance(row, str):
            lines += [row, "", "| | what | in the window | on the command line | proved by |", "|---|---|---|---|---|"]
            continue
        number, what, window, command = row
        tests = ["`" + name + (": " + ", ".join(functions) if functions else "") + "`" for name, functions in
                 sorted(proofs.get(number, {}).items())]
        lines.append(f"| {number} | {what} | {window} | {command} | {', '.join(tests) or '-'} |")
        following = rows[rows.index(row) + 1:][:1]
        if following and isinstance(following[0], str):
            lines.append("")
    return "\n".join(lines) + "\n"


def window_texts(source):
    for file in sorted((source / "translations").rglob("*_de.ts")) + sorted((source / "plugins").rglob("*_de.ts")):
        for text in xml.etree.ElementTree.parse(file).getroot().iter("source"):
            yield (text.text or "").replace("&", "").rstrip(".…")
    for file in (source / "plugins").rglob("*.json"):
        yield json.loads(file.read_text(encoding="utf-8")).get("name")


@functools.cache
def help_of(program, subcommand):
    return subprocess.run([program, subcommand, "--help"], capture_output=True, text=True, stdin=subprocess.DEVNULL, check=True).stdout


def wrong_commands(row, program):
    for subcommand, options in re.findall(r"`tan (\w+)([^`]*)`", row[3]):
        for option in options.split():
            if not re.search(rf"(?<![-\w]){option}(?![-\w])", help_of(program, subcommand)):
                yield f"{row[0]}: tan {subcommand} has no {option}"


def findings(source, rows, proofs, program):
    known = {row[0]: row for row in rows if not isinstance(row, str)}
    for number in sorted(set(proofs) - set(known)):
        yield f"{number} is no requirement, but named by {', '.join(proofs[number])}"
    texts = set(window_texts(source))
    for number, row in known.items():
        missing = row[2].startswith(MISSING) and row[3].startswith(MISSING)
        if missing == (number in proofs):
            yield f"{number} is missing, but proved" if missing else f"{number} is proved by no test"
        for text in re.findall(r"\*([^*]+)\*", row[2]):
            if text not in texts:
                yield f"{number}: the window has no text '{text}'"
        yield from wrong_commands(row, program)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--tan")
    options = parser.parse_args()
    rows, proofs = list(rows_of(options.source)), tests_of(options.source)
    page, path = page_of(rows, proofs), options.source / "docs/lab/requirements.md"
    if not options.check:
        path.write_text(page, encoding="utf-8")
        return 0
    found = list(findings(options.source, rows, proofs, options.tan))
    if not path.exists() or path.read_text(encoding="utf-8") != page:
        found.append("docs/lab/requirements.md is not up to date: ./dev test --requirements")
    print("\n".join(found) or f"{sum(not isinstance(row, str) for row in rows)} rows")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
