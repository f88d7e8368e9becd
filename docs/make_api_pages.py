#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the pages of the interfaces from their sources: docs/developer/api/ from the headers of core/include/tan, and
docs/user/python-reference.md from the docstrings of bindings/python/tan.

    docs/make_api_pages.py [--check]

--check writes nothing and names the pages that are not what the sources say."""
import ast
import pathlib
import re
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEADERS = ROOT / "core/include/tan"
MODULE = ROOT / "bindings/python/tan"
NOTICE = "Written by `docs/make_api_pages.py` from {}.\n"


def as_markdown(lines):
    """A comment's text: signs that would mean something in Markdown stand for themselves, but in `code` and in examples."""
    text, in_code = [], False
    for line in lines:
        if line.startswith("~~~"):
            in_code = not in_code
            text.append("```cpp" if in_code else "```")
        elif in_code:
            text.append(line)
        else:
            parts = re.split(r"(`[^`]*`)", line)
            text.append("".join(part if part.startswith("`") else re.sub(r"([<\[\]|])", r"\\\1", part) for part in parts))
    return "\n".join(text).strip("\n")


# --- C++ -----------------------------------------------------------------------------------------------------------------------

NAME = [re.compile(pattern) for pattern in (
    r"^(?:template <.*?> )?(?:struct|class|union|enum class|enum) (?:TAN_API )?(\w+)",
    r"^(?:template <.*> )?using (\w+) =",
    r"^(?:template <.*?> )?concept (\w+)",
    r"\b(operator\S+) ?\(",
    r"(\w+)\(",
    r"(\w+)(?:\[\])?(?: =|\{|;)",
)]
TYPE = re.compile(r"^(?:template <.*>\s)?(?:struct|class|union|enum)\b")
FORWARD = re.compile(r"^(?:template <.*>\s)?(?:struct|class|enum class) \w+(?: : [\w:]+)?;$")


def declared_name(code):
    line = " ".join(code.split())
    for pattern in NAME:
        if found := pattern.search(line):
            return found.group(1)
    return line


def public_part(lines):
    """Of a class, without what is private."""
    shown, hidden = [], False
    for line in lines:
        if re.match(r"^(private|protected):", line):
            hidden = line.startswith("private")
        elif line.startswith("public:") or line.startswith("}"):
            hidden = False
        if not hidden:
            shown.append(line)
    while len(shown) > 2 and not shown[-2].strip():
        del shown[-2]
    return shown


def as_declared(lines):
    """A function without its body, a class without its secrets, and neither with the marks of exported symbols."""
    code = "\n".join(public_part(lines) if TYPE.match(lines[0]) else lines)
    if not TYPE.match(lines[0]):
        depth = 0
        for at, sign in enumerate(code):
            depth += {"(": 1, ")": -1}.get(sign, 0)
            if sign == "{" and depth == 0 and "(" in code[:at]:
                code = code[:at].rstrip() + ";"
                break
    return re.sub(r"\bTAN_API ", "", code)


def entries_of(text):
    """(comment lines, declaration lines) of each declaration at the level of the namespace."""
    inside = text[text.index("namespace tetra {"):text.rindex("} // namespace tetra")].splitlines()[1:]
    comment, code, depth = [], [], 0
    for line in inside:
        if depth == 0 and not code and line.startswith("///"):
            comment.append(line[3:].removeprefix(" "))
            continue
        if depth == 0 and not code and (not line.strip() or line.startswith(("//", "#"))):
            comment = comment if line.strip() else []
            continue
        code.append(line)
        bare = re.sub(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])\'|//.*', "", line)
        depth += sum(bare.count(sign) for sign in "({") - sum(bare.count(sign) for sign in ")}")
        if depth == 0 and (bare.rstrip().endswith((";", "}")) or not bare.strip()):
            yield comment, code
            comment, code = [], []


def header_page(header):
    text = header.read_text(encoding="utf-8")
    head = [line[3:].removeprefix(" ") for line in text.partition("#include")[0].splitlines() if line.startswith("///")]
    title = re.sub(r"^tan/\w+\.h: ", "", head[0]) if head else ""
    title = title[:1].upper() + title[1:]
    parts = [f"# tan/{header.name}\n", NOTICE.format(f"`core/include/tan/{header.name}`"), as_markdown([title] + head[1:]) + "\n"]
    for comment, lines in entries_of(text) if "namespace tetra {" in text else []:
        code = as_declared(lines)
        if "TAN_INTERNAL" in code or FORWARD.match(" ".join(code.split())) or code.startswith(("extern template", "namespace")):
            continue
        if comment or TYPE.match(lines[0]) or not parts[-1].startswith("```cpp"):
            parts.append(f"## {declared_name(code)}\n\n{as_markdown(comment)}\n".replace("\n\n\n", "\n\n"))
            parts.append(f"```cpp\n{code}\n```\n")
        else:  # it shares the comment of the one before
            parts[-1] = parts[-1].removesuffix("```\n") + f"{code}\n```\n"
    return "\n".join(parts)


def contents_page(headers):
    lines = ["# The library's headers\n", NOTICE.format("`core/include/tan`"), "`<tan/tan.h>` includes them all. "
             "[The library](../../../core/README.md) says what it is for and how to link with it.\n", "| header | |", "|---|---|"]
    for header in headers:
        head = re.search(r"^/// tan/\w+\.h: (.*?)(?=\n///\s*\n|\n[^/])", header.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
        what = as_markdown([" ".join(head.group(1).replace("\n///", " ").split())]) if head else ""
        lines.append(f"| [`<tan/{header.name}>`]({header.stem}.md) | {what[:1].upper() + what[1:]} |")
    return "\n".join(lines) + "\n"


# --- Python --------------------------------------------------------------------------------------------------------------------

def docstring(node):
    return as_python_text(ast.get_docstring(node) or "")


def as_list(lines):
    """What begins with the name of an argument, "error: ...", as points of a list."""
    points = [re.sub(r"^([a-z_]+(?:, [a-z_]+)*): ", r"- *\1*: ", line) for line in as_markdown(lines).splitlines()]
    return "\n".join(line if line.startswith("- ") else "  " + line.strip() for line in points)


def as_python_text(text):
    """Doctests and indented examples become code, arguments a list."""
    blocks = []
    for block in re.split(r"\n\s*\n", text):
        if block.lstrip().startswith(">>>") or all(line.startswith("    ") for line in block.splitlines()) and block.strip():
            blocks.append("```python\n" + textwrap.dedent(block).strip("\n") + "\n```")
        elif re.match(r"[a-z_]+(, [a-z_]+)*: ", block):
            blocks.append(as_list(block.splitlines()))
        else:
            blocks.append(as_markdown(block.splitlines()))
    return "\n\n".join(block for block in blocks if block)


def signature(function, owner=None):
    arguments = ast.unparse(function.args)
    arguments = re.sub(r"^(self|cls)(, |$)", "", arguments)
    result = f" -> {ast.unparse(function.returns)}" if function.returns else ""
    return f"{owner + '.' if owner else ''}{function.name}({arguments}){result}"


def is_property(function):
    return any(isinstance(mark, ast.Name) and mark.id in ("property", "cached_property") for mark in function.decorator_list)


def class_text(node):
    bases = ", ".join(ast.unparse(base) for base in node.bases)
    parts = [f"## {node.name}\n", f"`class {node.name}({bases})`\n" if bases else "", docstring(node) + "\n"]
    fields = [f"`{field.target.id}`: `{ast.unparse(field.annotation)}`" for field in node.body
              if isinstance(field, ast.AnnAssign) and isinstance(field.target, ast.Name) and not field.target.id.startswith("_")]
    if fields:
        parts.append("Fields: " + ", ".join(fields) + ".\n")
    for function in node.body:
        if not isinstance(function, ast.FunctionDef) or not ast.get_docstring(function):
            continue
        if function.name.startswith("_") and function.name != "__init__":
            continue
        if is_property(function):
            shown = f"{node.name}.{function.name}" + (f": {ast.unparse(function.returns)}" if function.returns else "")
        else:
            shown = signature(function, node.name).replace(f"{node.name}.__init__", node.name)
        parts.append(f"### `{shown}`\n\n{docstring(function)}\n")
    return "\n".join(part for part in parts if part)


def python_page():
    trees = {file: ast.parse(file.read_text(encoding="utf-8")) for file in sorted(MODULE.glob("*.py"))}
    start = trees[MODULE / "__init__.py"]
    names = next(ast.literal_eval(node.value) for node in start.body
                 if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "__all__")
    found = {node.name: node for file, tree in trees.items() if file.name.startswith("_") for node in tree.body
             if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and node.name in names}
    missing = set(names) - set(found)
    assert not missing, f"no source for {sorted(missing)}"
    first = sorted(name for name in found if isinstance(found[name], ast.FunctionDef))
    parts = ["# Python: the reference\n", NOTICE.format("the docstrings of the module"),
             "What it is for, with examples: [Python](python.md). `help(tan.Model)` and the like show the same.\n", "## Functions\n"]
    parts += [f"### `tan.{signature(found[name])}`\n\n{docstring(found[name])}\n" for name in first]
    parts += [class_text(found[name]) for name in sorted(found) if name not in first]
    return "\n".join(parts)


def pages():
    headers = sorted(HEADERS.glob("*.h"))
    yield ROOT / "docs/developer/api/index.md", contents_page(headers)
    for header in headers:
        yield ROOT / f"docs/developer/api/{header.stem}.md", header_page(header)
    yield ROOT / "docs/user/python-reference.md", python_page()


def main():
    wrong, written = [], dict(pages())
    for path, text in written.items():
        if "--check" not in sys.argv[1:]:
            path.parent.mkdir(exist_ok=True)
            path.write_text(text, encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != text:
            wrong.append(f"{path.relative_to(ROOT)} is not what its sources say: run docs/make_api_pages.py")
    wrong += [f"{path.relative_to(ROOT)} has no source" for path in (ROOT / "docs/developer/api").glob("*.md") if path not in written]
    print("\n".join(wrong) or f"{len(written)} pages")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
