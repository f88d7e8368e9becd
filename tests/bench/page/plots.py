# SPDX-License-Identifier: GPL-3.0-or-later
"""The plots of the sections as SVG; those of which nothing was measured are left out."""
from charts import asked_chart, beside_chart, line_chart
from figures import AskedPlot, BesidePlot
from results import NotMeasured


def asked_plot(plot, results):
    rows = []
    for figure in plot.figures:
        value = figure.value(results)
        if not isinstance(value, NotMeasured):
            rows.append((results.text(figure.label), value, figure.asked, figure.least, figure.reached(value)))
    return asked_chart(plot.title, plot.note, plot.unit, rows, plot.logarithmic) if rows else ""


def beside_plot(plot, results):
    rows = []
    for label, sources in plot.rows:
        values = [results.number(source) for source in sources]
        values = [None if isinstance(value, NotMeasured) else value for value in values]
        if any(value is not None for value in values):
            rows.append((results.text(label), values))
    return beside_chart(plot.title, plot.note, plot.unit, plot.names, rows, plot.logarithmic) if rows else ""


def line_plot(plot, results):
    series = []
    for name, points in plot.series:
        places = [(results.sizes.get(x, x), results.number(source)) for x, source in points]
        places = [(x, y) for x, y in places if not isinstance(y, NotMeasured)]
        if places:
            series.append((name, places))
    return line_chart(plot.title, plot.note, plot.x_unit, plot.unit, series) if series else ""


def plots_of(sections, results):
    """Name and SVG of each plot."""
    drawn = {}
    for section in sections:
        for plot in section.plots:
            draw = asked_plot if isinstance(plot, AskedPlot) else beside_plot if isinstance(plot, BesidePlot) else line_plot
            drawing = draw(plot, results)
            if drawing:
                drawn[plot.name] = drawing
    return drawn
