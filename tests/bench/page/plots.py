# SPDX-License-Identifier: GPL-3.0-or-later
"""The plots of the sections, drawn by the program tan-bench-plots. Those of which nothing was measured are left out."""
import json
import subprocess

from figures import AskedPlot, BesidePlot
from number_text import number_text, tick_text
from results import NotMeasured, Unusable

REACHED, MISSED = 0, 1  # numbers of colours
OURS, OTHERS = (0, 3), (2, 4)  # blue and green, grey and violet


def with_powers(words):
    return words.replace("^3", "³")


def chart(plot, told, **content):
    """What all charts have: texts, and `told`, which says the same in words."""
    return {"title": with_powers(plot.title), "note": with_powers(plot.note), "unit": plot.unit,
            "description": "; ".join(told) + f". Unit: {plot.unit}.", **content}


def inks_of(names):
    ours, others = iter(OURS), iter(OTHERS)
    return [next(ours if name.startswith(("TAn", "our")) else others) for name in names]


def asked_row(label, value, figure):
    reached = figure.reached(value)
    row = {"label": with_powers(label), "bars": [{"value": value, "text": number_text(value), "ink": MISSED if reached is False else REACHED}]}
    if figure.asked is not None:
        verdict = "" if reached else ", missed"
        row["limit"] = {"value": figure.asked, "text": f"{'≥' if figure.least else '≤'} {tick_text(figure.asked)}{verdict}", "missed": not reached}
    return row


def in_words(label, value, figure):
    if figure.asked is None:
        return f"{label}: {number_text(value)}"
    limit = "at least" if figure.least else "at most"
    return f"{label}: {number_text(value)}, asked for {limit} {tick_text(figure.asked)}, {'reached' if figure.reached(value) else 'missed'}"


def asked_plot(plot, results):
    measured = [(results.text(figure.label), figure.value(results), figure) for figure in plot.figures]
    measured = [entry for entry in measured if not isinstance(entry[1], NotMeasured)]
    rows = [asked_row(*entry) for entry in measured]
    return chart(plot, [in_words(*entry) for entry in measured], rows=rows, logarithmic=plot.logarithmic) if rows else None


def beside_plot(plot, results):
    inks, rows, told = inks_of(plot.names), [], []
    for label, sources in plot.rows:
        values = [results.number(source) for source in sources]
        bars = [None if isinstance(value, NotMeasured) else {"value": value, "text": number_text(value), "ink": ink}
                for value, ink in zip(values, inks)]
        if any(bars):
            label = results.text(label)
            rows.append({"label": with_powers(label), "bars": bars})
            told.append(f"{label}: " + ", ".join(f"{name} {bar['text']}" for name, bar in zip(plot.names, bars) if bar))
    legend = [{"name": name, "ink": ink} for name, ink in zip(plot.names, inks)]
    return chart(plot, told, legend=legend, rows=rows, logarithmic=plot.logarithmic) if rows else None


def line_plot(plot, results):
    series, told = [], []
    for (name, points), ink in zip(plot.series, inks_of([name for name, _ in plot.series])):
        places = [(results.sizes.get(x, x), results.number(source)) for x, source in points]
        places = sorted((x, y) for x, y in places if not isinstance(y, NotMeasured))
        if places:
            series.append({"name": name, "ink": ink, "points": places})
            told.append(f"{name}: " + ", ".join(f"{number_text(y)} at {tick_text(x)}" for x, y in places))
    return chart(plot, told, across=plot.x_unit, series=series) if series else None


def plots_of(sections, results):
    """What is drawn, by the name of the picture."""
    drawn = {}
    for section in sections:
        for plot in section.plots:
            describe = asked_plot if isinstance(plot, AskedPlot) else beside_plot if isinstance(plot, BesidePlot) else line_plot
            described = describe(plot, results)
            if described:
                drawn[plot.name] = described
    return drawn


def draw(program, plots, folder):
    run = subprocess.run([program, folder], input=json.dumps(plots), text=True, check=False)
    if run.returncode != 0:
        raise Unusable(f"{program} did not draw the plots.")
