# SPDX-License-Identifier: GPL-3.0-or-later
"""The manual as HTML: Sphinx, MyST and Furo over the pages in the folder `user`. With the tag `developers`, started over the whole
repository, every text in it. Nothing is fetched from a network, neither now nor by the pages; search works in pages opened as files.

    python3 -m sphinx -W -d TREES -c docs docs/user TARGET
    python3 -m sphinx -W -d TREES -c docs -t developers . TARGET
"""
import pathlib

from docutils import nodes

HERE = pathlib.Path(__file__).resolve().parent
# In the order in which they are read; pages that are not named come after these.
USERS = ["index", "why", "first-steps", "tutorial-ct", "tutorial-cfd", "tutorial-large", "gallery", "manual", "accuracy", "scaling", "many-machines", "recipes",
         "command-line", "python", "python-reference", "paraview", "formats", "troubleshooting", "faq", "limitations", "glossary"]
OLD_SCRIPTS = ["jquery.js", "underscore.js", "_sphinx_javascript_frameworks_compat.js"]  # for themes that need them, as this one does not

extensions = ["myst_parser"]
project, author, html_title = "TAn", "The authors of TAn", "TAn"
html_theme = "furo"
html_copy_source = html_show_copyright = html_show_sphinx = html_use_index = False
html_show_search_summary = False  # it would read other pages, which browsers refuse for files
myst_heading_anchors = 3
suppress_warnings = ["myst.header"]  # the page of figures begins its tables with a level of their own
nitpicky = True

if tags.has("developers"):  # noqa: F821 (Sphinx has it)
    root_doc = "README"
    include_patterns = ["*.md", "docs/*/*.md", "docs/developer/api/*.md", "core/*.md", "core/history/*.md", "core/packed/*.md", "ui/*.md",
                        "packaging/recipes/*.md"]
    exclude_patterns = ["build", ".git", "tests", "shared"]
    pages = sorted(str(page.relative_to(HERE.parent).with_suffix("")) for pattern in include_patterns for page in HERE.parent.glob(pattern))
else:
    root_doc = "index"
    pages = [page for page in USERS if (HERE / "user" / f"{page}.md").exists()]
    pages += sorted(page.stem for page in (HERE / "user").glob("*.md") if page.stem not in USERS)
    include_patterns = [page + ".md" for page in pages]


def add_contents(app, page, text):
    """The table of contents, which Markdown has no words for."""
    if page == root_doc:
        text[0] += "\n```{toctree}\n:hidden:\n\n" + "\n".join(name for name in pages if name != page) + "\n```\n"


def add_captions(app, tree):
    """A picture that is a paragraph of its own has its text below it, too."""
    for number, image in enumerate(list(tree.findall(nodes.image))):
        paragraph = image.parent
        is_alone = isinstance(paragraph, nodes.paragraph) and len(paragraph) == 1 and not isinstance(paragraph.parent, nodes.entry)
        if is_alone and image.get("alt"):
            paragraph.replace_self(nodes.figure("", image, nodes.caption("", image["alt"]), ids=[f"picture-{number}"]))


def leave_out_scripts(app, page, template, context, tree):
    context["script_files"] = [file for file in context.get("script_files", []) if pathlib.Path(file).name not in OLD_SCRIPTS]


def arrange_scripts(app, failure):
    """Removes those that are left out, and joins the theme's two to one: Debian has them as a module, which browsers refuse for files."""
    static = pathlib.Path(app.outdir, "_static")
    for name in OLD_SCRIPTS:
        (static / name).unlink(missing_ok=True)
    theme, part = static / "scripts/furo.js", static / "scripts/gumshoe-patched.js"
    if part.exists():
        theme.write_text(part.read_text(encoding="utf-8") + theme.read_text(encoding="utf-8").partition("\n")[2], encoding="utf-8")
        part.unlink()


def setup(app):
    app.connect("source-read", add_contents)
    app.connect("doctree-read", add_captions)
    app.connect("html-page-context", leave_out_scripts)
    app.connect("build-finished", arrange_scripts)
