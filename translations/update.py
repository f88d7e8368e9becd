#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Brings tan_de.ts and tan_it.ts up to date with the texts of the sources; what is new is 'unfinished'.

    python3 translations/update.py [--check] [--also OTHER.ts ...]

Takes the texts by lupdate: tr() and translate(), and of core and plugins Message::say() and Message::marked(). lupdate
gives these two contexts, now "tetra::Message" and now "Message", by what stands before them in a function; here they are
one, in which the window looks first. --check: only says what is missing, or has no source any more, and fails if there is such.
--also: further files of either language that translations are taken from, such as those of another branch."""

import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from xml.sax.saxutils import escape

root = pathlib.Path(__file__).resolve().parent.parent
languages = ("de", "it")
message_context = "tetra::Message"
folders = ("core", "plugins", "ui")


def sources():
    return sorted(str(path) for folder in folders for path in (root / folder).rglob("*")
                  if path.suffix in (".cpp", ".h") and "verify" not in path.relative_to(root).parts)


def extract(target):
    """All texts of the sources, as lupdate finds them, in `target`."""
    lupdate = shutil.which("lupdate", path="/usr/lib/qt6/bin") or shutil.which("lupdate6") or shutil.which("lupdate")
    if lupdate is None:
        sys.exit("update.py: there is no lupdate; install qt6-l10n-tools.")
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as listed:
        listed.write("\n".join(sources()))
        listed.flush()
        run = subprocess.run([lupdate, "-silent", "-locations", "none", "-tr-function-alias", "tr+=say,tr+=marked",
                              "-I", str(root), "-I", str(root / "core/include"), "@" + listed.name, "-ts", target],
                             capture_output=True, text=True)
    problems = [line for line in run.stderr.splitlines() if "tr() like this" in line or "cannot be called" in line]
    problems += [f"{path}: tr() within {call[1]}() is not seen; give that function another name" for path in sources()
                 for call in re.finditer(r"\b(say|marked)\((?:[^\"()]|\([^\"()]*\))*\btr\(", pathlib.Path(path).read_text(encoding="utf-8"))]
    if run.returncode != 0 or problems:
        sys.exit("update.py: " + "\n".join(problems or [run.stderr]))


def remedies():
    """What plugins advise if a library is missing; their names and descriptions bring their translations along."""
    for path in sorted((root / "plugins").rglob("*.json")):
        if remedy := json.loads(path.read_text(encoding="utf-8")).get("remedy"):
            yield remedy


def messages(path):
    """Context, source and translation of each text in the order of the file; None for what is not translated."""
    for context in ElementTree.parse(path).getroot().iter("context"):
        name = context.findtext("name") or ""
        for message in context.iter("message"):
            translation = message.find("translation")
            finished = translation is not None and translation.get("type") is None and translation.text
            yield (message_context if name in ("Message", "") else name, message.findtext("source"),
                   translation.text if finished else None)


def written(language, contexts):
    def text(string):
        return escape(string, {"'": "&apos;", '"': "&quot;"})
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>", f'<TS version="2.1" language="{language}">']
    for name in sorted(contexts):
        lines += ["<context>", f"    <name>{text(name)}</name>"]
        for source, translation in contexts[name].items():
            lines += ["    <message>", f"        <source>{text(source)}</source>",
                      f"        <translation>{text(translation)}</translation>" if translation is not None
                      else '        <translation type="unfinished"></translation>', "    </message>"]
        lines.append("</context>")
    return "\n".join(lines + ["</TS>", ""])


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("--check", action="store_true")
    arguments.add_argument("--also", nargs="*", default=[], type=pathlib.Path)
    wanted = arguments.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        fresh = pathlib.Path(folder) / "fresh.ts"
        extract(str(fresh))
        texts = list(messages(fresh)) + [(message_context, remedy, None) for remedy in remedies()]
    missing = 0
    for language in languages:
        path = root / "translations" / f"tan_{language}.ts"
        others = [other for other in wanted.also if ElementTree.parse(other).getroot().get("language") == language]
        known = {}
        for file in (path, *others):
            for context, source, translation in messages(file):
                known[context, source] = known.get((context, source)) or translation
        needed = {(context, source) for context, source, _ in texts}
        contexts = {}
        for context, source in [text for text in known if text in needed] + [text[:2] for text in texts]:
            contexts.setdefault(context, {})[source] = known.get((context, source))
        text = written(language, contexts)
        if not wanted.check:
            path.write_text(text, encoding="utf-8")
        elif text != path.read_text(encoding="utf-8"):
            print(f"{path.name} is not what update.py makes of it")
            missing += 1
        unfinished = [(context, source) for context, these in contexts.items()
                      for source, translation in these.items() if translation is None]
        for context, source in unfinished:
            print(f"{path.name}: {context}: {source}")
        missing += len(unfinished)
    print(f"{len(texts)} texts, {missing} translations missing")
    return 1 if wanted.check and missing > 0 else 0


if __name__ == "__main__":
    sys.exit(main())
