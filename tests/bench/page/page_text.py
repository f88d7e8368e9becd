# SPDX-License-Identifier: GPL-3.0-or-later
"""The page of what was measured, as Markdown."""
import re

from figures import AskedPlot, BesidePlot
from number_text import number_text, tick_text
from results import NotMeasured
from steps import STEPS

QUIET = 0.05  # of the machine's time for others

HEAD = """# Measured: what was asked for, and what is reached

`./dev bench all` writes this page and its plots from the results of the benchmarks; nothing on it is typed by hand. Machines are noisy, so what counts are
ratios: every figure stands beside a yardstick of the same run (CGAL, VTK, memcpy, or a simpler way of our own) or beside the paper. A bar that misses its
goal has another colour and is marked *missed*. What was learnt on the way is in the [notes on performance](performance.md); the
[developer's guide](../developer/guide.md#how-to-measure) says how to measure again.
"""


def value_text(value):
    return f"not measured: {value.why}" if isinstance(value, NotMeasured) else number_text(value)


def asked_text(figure):
    return "" if figure.asked is None else f"{'at least' if figure.least else 'at most'} {tick_text(figure.asked)}"


def verdict(figure, value):
    reached = figure.reached(value)
    return "" if reached is None else "yes" if reached else "**no**"


def row(*cells):
    return "| " + " | ".join(cells) + " |"


def table(head, rows):
    return "\n".join([row(*head), "|" + "---|" * len(head)] + rows) + "\n"


def asked_table(plot, results):
    rows = []
    for figure in plot.figures:
        value = figure.value(results)
        rows.append(row(results.text(figure.label), value_text(value), asked_text(figure), verdict(figure, value)))
    return table(("", plot.unit, "asked for", "reached"), rows)


def beside_table(plot, results):
    return table((plot.unit, *plot.names), [row(results.text(label), *(value_text(results.number(source)) for source in sources))
                                            for label, sources in plot.rows])


def line_table(plot, results):
    places = [x for x, _ in max((points for _, points in plot.series), key=len)]
    rows = []
    for name, points in plot.series:
        at = dict(points)
        rows.append(row(name, *(value_text(results.number(at[x])) if x in at else "" for x in places)))
    return table((f"{plot.unit}, at {plot.x_unit}", *(tick_text(results.sizes.get(x, x)) for x in places)), rows)


def plot_text(plot, results, drawings, folder):
    if isinstance(plot, AskedPlot):
        figures = asked_table(plot, results)
    else:
        figures = (beside_table if isinstance(plot, BesidePlot) else line_table)(plot, results)
    title = results.text(plot.title)
    picture = f"![{title}: the figures are in the table below]({folder}/{plot.name}.svg)\n\n" if plot.name in drawings else ""
    return f"### {title}\n\n{results.text(plot.note)}\n\n{picture}{figures}"


def missed_row(plot, results):
    """What was asked for in one plot, how much of it is reached, and what is not; nothing if all is."""
    asked = [(figure, figure.value(results)) for figure in plot.figures if figure.asked is not None]
    missed = [(figure, value) for figure, value in asked if figure.reached(value) is False]
    limits = " or ".join(dict.fromkeys(asked_text(figure) for figure, _ in missed))
    told = "; ".join(f"{results.text(figure.label)}: {number_text(value)}" for figure, value in missed)
    return row(f"[{plot.title}](#{anchor(plot.title)})", f"{limits} {plot.unit}", f"{len(missed)} of {len(asked)}", told) if missed else ""


def anchor(title):
    """As the pages call it where this text is read."""
    return re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")


def summary(sections, results):
    plots = [plot for section in sections for plot in section.plots if isinstance(plot, AskedPlot)]
    asked = [(figure, figure.value(results)) for plot in plots for figure in plot.figures if figure.asked is not None]
    verdicts = [figure.reached(value) for figure, value in asked]
    text = (f"## What is not reached\n\nOf {len(asked)} figures that were asked for {verdicts.count(True)} are reached, "
            f"{verdicts.count(False)} are not, and {verdicts.count(None)} were not measured here.\n\n")
    rows = [line for line in (missed_row(plot, results) for plot in plots) if line]
    return text + (table(("", "asked for", "missed", "which, and what was measured"), rows) if rows else "")


def machine_text(results):
    about = results.machine
    text = (f"## The machine\n\n{about['processor']}, {about['cores']} cores, {about['memory_bytes'] / 2**30:.0f} GiB of memory; "
            f"{about['system']}; {about['compiler']}.\n\n")
    rows, loud, changed = [], [], False
    for step in STEPS:
        if step.name in results.without:
            rows.append(row(step.name, step.what, "left out", "", "", ""))
            continue
        run = results.steps[step.name]["run"]
        changed |= run["changed"]
        loud += [step.name] if run["others_share"] > QUIET else []
        rows.append(row(step.name, step.what, run["date"], run["revision"] + (" and changes" if run["changed"] else ""),
                        f"{run['seconds']:.0f} s", f"{100 * run['others_share']:.0f} %"))
    if loud:
        text += f"**The machine was not quiet** while these ran: {', '.join(loud)}. Times are longer than they should be; ratios scatter.\n\n"
    else:
        text += "The machine was quiet: other programs took no more than a twentieth of its time.\n\n"
    return text + table(("step", "", "measured", "revision", "took", "others' share of the machine"), rows)


def page_text(sections, results, drawings, folder):
    text = HEAD
    if results.machine["trial"]:
        text += "\n**This is a trial of tiny sizes: it shows that the page can be made, and its figures mean nothing.**\n"
    text += "\n" + summary(sections, results) + "\n" + machine_text(results)
    for section in sections:
        text += f"\n## {section.title}\n\n{results.text(section.text)}\n"
        for plot in section.plots:
            text += "\n" + plot_text(plot, results, drawings, folder)
    return text
