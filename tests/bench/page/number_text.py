# SPDX-License-Identifier: GPL-3.0-or-later
"""Numbers as the page and its plots show them."""
import math


def number_text(value):
    """Three digits that count, thousands with commas; what is whole and small as it is."""
    if value == 0:
        return "0"
    digits = max(0, 2 - math.floor(math.log10(abs(value))))
    text = f"{value:,.{digits}f}"
    return text if float(value) != int(value) or digits == 0 else f"{int(value):,}"


def tick_text(value):
    return f"{value:,.0f}" if value >= 1 and value == int(value) else f"{value:.6g}"
