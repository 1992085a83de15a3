"""The printed table of a campaign."""

import statistics

ORDER = ("force", "approach", "contact radius", "fold approach", "fold load", "fold contact radius",
         "extremum approach", "extremum load", "extremum contact radius")
TOGETHER = ORDER[3:]     # those of the pull-off are also those of an extremum
QUANTILES = (0.01, 0.1, 0.5, 0.9, 0.99)
VERDICTS = ("held", "open", "violated", "unstated")


def quantile(values, part):
    """A quantile of sorted values, with linear interpolation."""
    place = part * (len(values) - 1)
    low = int(place)
    high = min(low + 1, len(values) - 1)
    return values[low] + (place - low) * (values[high] - values[low])


def row(quantity, of_it):
    counts = [sum(f.verdict == verdict for f in of_it) for verdict in VERDICTS]
    told = sorted((f.ratio, f.is_bound) for f in of_it if f.verdict != "unstated")
    ratios = [ratio for ratio, _ in told]
    cells = [f"{quantile(ratios, part):.3g}" if ratios else "-" for part in QUANTILES]
    bounds = f"{100 * statistics.mean(is_bound for _, is_bound in told):.0f} %" if told else "-"
    return [quantity, str(len(of_it)), *map(str, counts), *cells, bounds]


def grid(findings, order, together=()):
    """The rows of the table, one for each quantity, and one for several together."""
    names = ["median" if part == 0.5 else f"{100 * part:g} %" for part in QUANTILES]
    rows = [["", "stated", *VERDICTS, *names, "at least"]]
    rows += [row(quantity, [f for f in findings if f.quantity == quantity]) for quantity in order]
    if together:
        rows.append(row("together", [f for f in findings if f.quantity in together]))
    widths = [max(len(cells[i]) for cells in rows) for i in range(len(rows[0]))]
    return ["  ".join(cell.ljust(width) if i == 0 else cell.rjust(width)
                      for i, (cell, width) in enumerate(zip(cells, widths))).rstrip() for cells in rows]


def lines(comparisons):
    """The table of all comparisons of a campaign."""
    text = grid([finding for comparison in comparisons for finding in comparison.findings], ORDER, TOGETHER)

    def total(attribute):
        return sum(bool(getattr(comparison, attribute)) for comparison in comparisons)

    def count(attribute):
        return sum(len(getattr(comparison, attribute)) for comparison in comparisons)

    return text + [
        f"folds and extrema missing {count('missing')}, added {count('added')}; in pairs below the stated errors "
        f"{sum(comparison.faint for comparison in comparisons)}",
        f"scenes whose traces ended apart {total('ended_apart')}, with a deeper minimum beyond the earlier end "
        f"{total('beyond')}; two minima as deep within the errors {total('tie')}; a crest at the threshold of contact "
        f"{total('undecided')}"]
