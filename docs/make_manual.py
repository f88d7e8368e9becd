#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make_manual.py SOURCE TARGET VERSION: the texts of SOURCE/docs as HTML pages in TARGET, with their pictures.

Fails on a link that leads nowhere: to a page, a picture or a heading that does not exist."""
import html
import pathlib
import re
import shutil
import sys

import markdown

# The pages in the order of the contents: file in the repository, name of the page.
USERS = [
    ("docs/index.md", "index"),
    ("docs/first-steps.md", "first-steps"),
    ("docs/manual.md", "manual"),
    ("docs/accuracy.md", "accuracy"),
    ("docs/recipes.md", "recipes"),
    ("docs/command-line.md", "command-line"),
    ("docs/formats.md", "formats"),
    ("docs/troubleshooting.md", "troubleshooting"),
]
DEVELOPERS = [
    ("docs/developers.md", "developers"),
    ("CONTRIBUTING.md", "contributing"),
    ("docs/glossary.md", "glossary"),
    ("docs/tetrahedral-graphics.md", "tetrahedral-graphics"),
    ("core/history/FORMAT.md", "model-file"),
    ("docs/reliability.md", "reliability"),
    ("docs/measured.md", "measured"),
    ("docs/performance.md", "performance"),
    ("docs/dependencies.md", "dependencies"),
]

STYLE = """
:root { color-scheme: light dark; }
body { margin: 0; font: 16px/1.55 system-ui, sans-serif; color: #1c1e21; background: #fff; display: flex; }
nav { flex: 0 0 15em; height: 100vh; overflow-y: auto; position: sticky; top: 0; padding: 1em; background: #f3f5f7; box-sizing: border-box; }
nav a { display: block; padding: .2em .4em; color: inherit; text-decoration: none; border-radius: 4px; }
nav a:hover, nav a[aria-current] { background: #dde6ee; }
nav p { margin: 1em 0 .2em; font-size: .85em; opacity: .75; }
nav a.heading { padding-left: 1.4em; font-size: .85em; }
main { flex: 1 1 auto; max-width: 52em; padding: 1em 2em 4em; min-width: 0; }
h1, h2, h3 { line-height: 1.25; } h2 { margin-top: 2em; }
a { color: #0b62a8; }
img { max-width: 100%; height: auto; border: 1px solid #d5dade; }
figure { margin: 1.5em 0; } figcaption { font-size: .85em; opacity: .8; }
pre { background: #f3f5f7; padding: .8em 1em; overflow-x: auto; }
code { font: .9em/1.45 monospace; }
table { border-collapse: collapse; display: block; overflow-x: auto; }
th, td { border: 1px solid #d5dade; padding: .3em .6em; text-align: left; vertical-align: top; }
@media (min-width: 50em) { code { white-space: nowrap; } pre code { white-space: pre; } }
@media (max-width: 50em) {
  body { display: block; } nav { position: static; height: auto; padding: .5em 1em 1em; } main { padding: 1em 1em 4em; }
  nav a { display: inline-block; } nav a.heading { display: none; }
}
@media (prefers-color-scheme: dark) {
  body { color: #e3e6e8; background: #1b1e21; } nav, pre { background: #24282c; } a { color: #76b9ee; }
  nav a:hover, nav a[aria-current] { background: #37424c; } th, td, img { border-color: #444b52; }
}
"""


def slug(heading, separator):
    """As on the pages where these texts are read otherwise: GitHub's and GitLab's."""
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", separator)


def plain(text):
    return html.unescape(re.sub(r"<[^>]+>", "", text))


def with_blank_lines(text):
    """A blank line before tables and lists that follow a line of text: elsewhere they need none, here they do."""
    lines, in_fence = [], False
    for line in text.splitlines():
        in_fence ^= line.startswith("```")
        before = lines[-1] if lines else ""
        begins = re.match(r"\||- |\d+\. ", line) and not re.match(r"\||- |\d+\. |\s|$", before)
        if begins and not in_fence:
            lines.append("")
        lines.append(line)
    return "\n".join(lines)


def with_captions(body):
    """A picture that is a paragraph of its own has its text below it, too."""
    return re.sub(r'<p>(<img alt="([^"]+)"[^>]*>)</p>', r"<figure>\1<figcaption>\2</figcaption></figure>", body)


class Page:
    def __init__(self, source, file, name):
        self.path, self.name = source / file, name
        converter = markdown.Markdown(extensions=["tables", "fenced_code", "sane_lists", "toc"],
                                      extension_configs={"toc": {"slugify": slug}})
        self.body = with_captions(converter.convert(with_blank_lines(self.path.read_text(encoding="utf-8"))))
        self.anchors = set(re.findall(r' id="([^"]+)"', self.body))
        self.headings = re.findall(r'<h2 id="([^"]+)">(.*?)</h2>', self.body)
        self.title = plain(re.search(r"<h1[^>]*>(.*?)</h1>", self.body).group(1))


class Manual:
    def __init__(self, source, target):
        self.source, self.target, self.mistakes = source, target, []
        self.groups = [(title, [Page(source, *entry) for entry in entries])
                       for title, entries in (("Using TAn", USERS), ("Working on TAn", DEVELOPERS))]
        self.by_path = {page.path.resolve(): page for _, pages in self.groups for page in pages}

    def link(self, page, attribute, url):
        if re.match(r"[a-z]+:", url):
            return f'{attribute}="{url}"'
        path, _, anchor = url.partition("#")
        goal = (page.path.parent / path).resolve() if path else page.path.resolve()
        if goal in self.by_path:
            if anchor and anchor not in self.by_path[goal].anchors:
                self.mistakes.append(f"{page.path}: no heading '{anchor}' in {goal}")
            return f'{attribute}="{self.by_path[goal].name}.html{"#" + anchor if anchor else ""}"'
        if not goal.exists():
            self.mistakes.append(f"{page.path}: {url} does not exist")
        elif goal.is_file() and goal.suffix in (".png", ".svg"):
            name = goal.relative_to(self.source / "docs")
            (self.target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(goal, self.target / name)
            return f'{attribute}="{name}"'
        # The rest of the repository is not part of the manual.
        return f'data-in-the-repository="{goal.relative_to(self.source)}"' if goal.exists() else ""

    def contents(self, current):
        text = ""
        for title, pages in self.groups:
            text += f"<p>{title}</p>"
            for page in pages:
                here = ' aria-current="page"' if page is current else ""
                text += f'<a href="{page.name}.html"{here}>{html.escape(page.title)}</a>'
                if page is current:
                    text += "".join(f'<a class="heading" href="#{anchor}">{html.escape(plain(heading))}</a>'
                                    for anchor, heading in page.headings)
        return text

    def write(self, version):
        shutil.rmtree(self.target, ignore_errors=True)
        self.target.mkdir(parents=True)
        for _, pages in self.groups:
            for page in pages:
                body = re.sub(r'(href|src)="([^"]*)"', lambda found: self.link(page, *found.groups()), page.body)
                (self.target / f"{page.name}.html").write_text(
                    f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
                    f'<meta name="viewport" content="width=device-width"><title>{html.escape(page.title)} – TAn {version}</title>'
                    f"<style>{STYLE}</style></head>\n<body><nav>{self.contents(page)}</nav>\n<main>{body}</main></body></html>\n",
                    encoding="utf-8")


def main():
    source, target = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    manual = Manual(source, target)
    manual.write(sys.argv[3])
    for mistake in manual.mistakes:
        print(mistake, file=sys.stderr)
    return 1 if manual.mistakes else 0


sys.exit(main())
