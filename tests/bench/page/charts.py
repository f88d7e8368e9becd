# SPDX-License-Identifier: GPL-3.0-or-later
"""The three kinds of plots: bars beside what was asked for, bars of several beside each other, lines."""
from svg import LINE, SIDE, WIDTH, Drawing, Scale, number_text, tick_text

TOP = 66
BOTTOM = 44
LABELS = 282
ROW = 26
OURS, OTHERS = ("s0", "s3"), ("s2", "s4")


def styles_of(names):
    """Blue and green are ours, grey and violet others'."""
    ours, others = iter(OURS), iter(OTHERS)
    return [next(ours if name.startswith(("TAn", "our")) else others) for name in names]


def axis(drawing, scale, top, bottom, unit):
    for tick in scale.ticks():
        x = scale.place(tick)
        drawing.line(x, top, x, bottom, "grid")
        drawing.text(x, bottom + LINE, tick_text(tick), "soft", "middle")
    drawing.text((scale.start + scale.end) / 2, bottom + 2 * LINE, unit, "soft", "middle")


def asked_chart(title, note, unit, rows, logarithmic=False):
    """`rows`: label, value, what was asked for or None, whether at least that, whether it is reached (or None). What misses has
    another colour, and says so."""
    bottom = TOP + ROW * len(rows)
    drawing = Drawing(title, "; ".join(in_words(*row) for row in rows) + f". Unit: {unit}.", bottom + BOTTOM)
    drawing.header(note)
    scale = Scale([row[1] for row in rows] + [row[2] for row in rows if row[2]], LABELS, WIDTH - 214, logarithmic)
    axis(drawing, scale, TOP, bottom, unit)
    if any(row[2] is not None for row in rows):
        drawing.text(WIDTH - 142, TOP - 8, "measured", "soft", "end")
        drawing.text(WIDTH - 126, TOP - 8, "asked for", "soft")
        drawing.line(WIDTH - 58, TOP - 19, WIDTH - 58, TOP - 5, "asked")
    for number, (label, value, asked, least, reached) in enumerate(rows):
        top = TOP + ROW * number
        drawing.text(SIDE, top + 18, label)
        drawing.bar(LABELS, top + 5, scale.place(value) - LABELS, ROW - 9, "s1" if reached is False else "s0")
        drawing.text(WIDTH - 142, top + 18, number_text(value), "strong", "end")
        if asked is not None:
            drawing.line(scale.place(asked), top + 1, scale.place(asked), top + ROW - 1, "asked")
            sign = "≥" if least else "≤"
            drawing.text(WIDTH - 126, top + 18, f"{sign} {tick_text(asked)}" + ("" if reached else ", missed"), "" if reached else "strong")
    drawing.line(LABELS, TOP, LABELS, bottom, "axis")
    return drawing.svg()


def in_words(label, value, asked, least, reached):
    if asked is None:
        return f"{label}: {number_text(value)}"
    limit = "at least" if least else "at most"
    return f"{label}: {number_text(value)}, asked for {limit} {tick_text(asked)}, {'reached' if reached else 'missed'}"


def legend(drawing, names):
    x = LABELS
    for style, name in zip(styles_of(names), names):
        drawing.bar(x, TOP - 9, 11, 11, style)
        drawing.text(x + 16, TOP + 1, name, "soft")
        x += 26 + 6.4 * len(name)


def beside_chart(title, note, unit, names, rows, logarithmic=True):
    """`rows`: label and one value for each of `names`, None where there is none."""
    height = 15 * len(names) + 12
    first, styles = TOP + 20, styles_of(names)
    bottom = first + height * len(rows)
    words = "; ".join(label + ": " + ", ".join(f"{name} {number_text(value)}" for name, value in zip(names, values) if value is not None)
                      for label, values in rows)
    drawing = Drawing(title, f"{words}. Unit: {unit}.", bottom + BOTTOM)
    drawing.header(note)
    legend(drawing, names)
    scale = Scale([value for _, values in rows for value in values if value], LABELS, WIDTH - 76, logarithmic)
    axis(drawing, scale, first - 6, bottom, unit)
    for number, (label, values) in enumerate(rows):
        top = first + height * number
        drawing.text(SIDE, top + height / 2, label)
        for series, value in enumerate(values):
            if value is not None:
                y = top + 15 * series
                drawing.bar(LABELS, y + 1, scale.place(value) - LABELS, 12, styles[series])
                drawing.text(scale.place(value) + 5, y + 12, number_text(value), "soft")
    drawing.line(LABELS, first - 6, LABELS, bottom, "axis")
    return drawing.svg()


def line_chart(title, note, x_unit, unit, series):
    """`series`: a name and its points (x, y); both axes logarithmic, marks of its own for each."""
    left, right, top, bottom = 84, WIDTH - 170, TOP + 14, TOP + 294
    series = [(name, sorted(points)) for name, points in series]
    styles = styles_of([name for name, _ in series])
    words = "; ".join(name + ": " + ", ".join(f"{number_text(y)} at {tick_text(x)}" for x, y in points) for name, points in series)
    drawing = Drawing(title, f"{words}. Units: {unit}, at {x_unit}.", bottom + BOTTOM + 6)
    drawing.header(note)
    points = [point for _, some in series for point in some]
    across = Scale([x for x, _ in points], left, right, True)
    up = Scale([y for _, y in points], bottom, top, True)
    for x in sorted({x for x, _ in points}):
        drawing.line(across.place(x), top, across.place(x), bottom, "grid")
        drawing.text(across.place(x), bottom + LINE, tick_text(x), "soft", "middle")
    for tick in up.ticks():
        drawing.line(left, up.place(tick), right, up.place(tick), "grid")
        drawing.text(left - 8, up.place(tick) + 4, tick_text(tick), "soft", "end")
    drawing.text((left + right) / 2, bottom + 2 * LINE + 2, x_unit, "soft", "middle")
    drawing.text(SIDE, top - 6, unit, "soft")
    ends = spread([(up.place(some[-1][1]), name, number) for number, (name, some) in enumerate(series)])
    for number, (_, some) in enumerate(series):
        places = [(across.place(x), up.place(y)) for x, y in some]
        drawing.path(places, styles[number] + (" dash" if number else ""))
        for x, y in places:
            drawing.mark(x, y, number, styles[number])
    for y, name, number in ends:
        drawing.mark(right + 14, y - 4, number, styles[number])
        drawing.text(right + 26, y, name)
    return drawing.svg()


def spread(ends):
    """Names at the ends of lines, moved apart so that none covers another."""
    placed = []
    for y, name, number in sorted(ends):
        placed.append((max(y + 4, placed[-1][0] + LINE if placed else 0), name, number))
    return placed
