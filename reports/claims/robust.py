"""What follows from the judged claims as a whole: the counts that no convention and no preload changes, the preloads that the
numbers of several figures admit in common, and the verdicts on the sentences of the abstract and the conclusions."""

import book
import judge

# Verdicts on a sentence: of all its entries, at each convention, each preload and each choice.
ROBUST, AS_READ, IN_PART, FAILS, UNTESTED = "robust", "as_read", "in_part", "fails", "untested"
PLACES = 3              # preloads of each figure, from light to hard
CLAIMED = "claimed"
MOST_EXCEPTIONS = 3     # choices that are named for a sentence


def verdict_at(row, scale, place):
    """The verdict on a claim by one convention and one preload of its figure; `place` None: all preloads."""
    if not row["choices"]:
        return row["verdict"]
    parts = [part for part in row["choices"] if place is None or part["preload"] in (None, place)]
    return judge.overall([part["verdicts"][scale] for part in parts or row["choices"]])


def cells(row):
    """The verdicts on a claim by every convention, with all preloads."""
    return {scale: verdict_at(row, scale, None) for scale in judge.SCALES}


def holds_always(row):
    return set(cells(row).values()) <= set(judge.HOLDS)


def moves(row):
    """Whether the verdict on a claim is another by half or twice the accuracy of the convention."""
    return len({"holds" if verdict in judge.HOLDS else verdict for verdict in cells(row).values()}) > 1


def counts(rows):
    """{table, holds_always, moved}: the statements by verdict, for every convention and preload; how many hold under all of them,
    and how many verdicts move with the convention."""
    rows = [row for row in rows if not row["kind"]]

    def count(scale, place):
        verdicts = [verdict_at(row, scale, place) for row in rows]
        return {"holds": sum(verdict in judge.HOLDS for verdict in verdicts),
                **{name: verdicts.count(name) for name in (judge.DEPENDS, judge.CONTRADICTED)}}
    return {"table": [{"scale": scale, "preload": place, **count(scale, place)} for scale in judge.SCALES
                      for place in (*range(PLACES), None)],
            "holds_always": sum(map(holds_always, rows)),
            "moved": sum(map(moves, rows)),
            "statements": len(rows)}


def common(surveys):
    """For every convention the preloads at which all surveyed numbers of the paper are reproduced, of those tried for all; and the
    preload that comes nearest: of those that reach all numbers, the one that exceeds them least, because a figure with few amplitudes
    can miss its largest force; if none reaches them, that of the least difference."""
    numbered = [survey for survey in surveys if survey["claimed"] is not None]
    if not numbered:
        return None
    tried = [{part["words"]: part for part in survey["tried"]} for survey in numbered]
    shared = [words for words in tried[0] if all(words in parts and parts[words]["computed"] is not None for parts in tried)]
    if not shared:
        return None

    def off(words):
        return max(abs(parts[words]["computed"] / survey["claimed"] - 1) for parts, survey in zip(tried, numbered))

    def over(words):
        return max(parts[words]["computed"] / survey["claimed"] for parts, survey in zip(tried, numbered))
    reached = [words for words in shared if all(parts[words]["computed"] >= (1 - judge.ABOUT) * survey["claimed"]
                                                for parts, survey in zip(tried, numbered))]
    nearest = min(reached, key=over) if reached else min(shared, key=off)
    return {**{scale: [words for words in shared if all(parts[words]["holds"][scale] for parts in tried)] for scale in judge.SCALES},
            "tried": len(shared), "nearest": nearest, "difference": off(nearest),
            "numbers": [parts[nearest]["computed"] for parts in tried]}


def exceptions(row):
    """The choices of a claim that do not hold; the preloads are named if they decide."""
    groups = {}
    for part in row["choices"]:
        groups.setdefault(part["own"] if part["preload"] is not None else part["words"], []).append(part)
    for own, parts in groups.items():
        failing = [part for part in parts if part["verdict"] == judge.CONTRADICTED]
        if len(failing) == len(parts) and (own or len(groups) == 1):
            yield own or row["tests"]
        else:
            yield from (part["words"] for part in failing)


def number_of(name, choice, rows, surveys):
    """The number of an entry or a survey in words: "9.3", "0.08 to 0.14" over its choices; of the choice `claimed`: that of the
    paper."""
    row = next((row for row in rows if row["id"] == name), None)
    parts = row["choices"] if row else next(survey for survey in surveys if survey["id"] == name)["tried"]
    key = "low" if choice == CLAIMED else "computed"
    found = sorted(part[key] for part in parts if (choice == CLAIMED or choice in (part["words"] or "")) and part[key] is not None)
    if not found:
        return "–"
    ends = [f"{value:.3g}".replace("-", "−") for value in (found[0], found[-1])]
    return ends[0] if ends[0] == ends[1] else f"{ends[0]} to {ends[1]}"


def filled(words, rows, surveys):
    """A text with its numbers in place of their names in braces."""
    for name, choice in book.placeholders(words or ""):
        words = words.replace("{" + name + (f" | {choice}" if choice else "") + "}", number_of(name, choice, rows, surveys))
    return words


def sentence(entry, rows, surveys):
    """The verdict on a sentence from those on its entries, its words with their numbers, and the choices for which it fails."""
    judged = [row for row in rows if row["id"] in entry["entries"]]
    tested = [row for row in judged if row["verdict"] not in (judge.NOT_TESTABLE, judge.NO_RESULT)]
    good = [row for row in tested if row["verdict"] in judge.PASSES]
    if not tested:
        verdict = UNTESTED
    elif len(good) == len(tested):
        verdict = ROBUST if all(row["verdict"] == judge.CHECKED or holds_always(row) for row in tested) else AS_READ
    else:
        verdict = FAILS if all(row["verdict"] == judge.CONTRADICTED for row in tested) else IN_PART
    words = filled(entry["words"], rows, surveys)
    failing = [{"id": row["id"], "words": list(dict.fromkeys(exceptions(row)))[:MOST_EXCEPTIONS]} for row in tested if row not in good]
    return {"where": entry["where"], "quote": entry["quote"], "entries": entry["entries"], "words": words, "verdict": verdict,
            "failing": failing, "convention": [row["id"] for row in good if row["verdict"] != judge.CHECKED and not holds_always(row)]}


def text_of(made):
    """Lines for a terminal: the robust counts, the preloads in common, the sentences."""
    found, shared = made["robust"], made["common"]
    lines = [f"{found['holds_always']} of {found['statements']} statements hold under every convention and preload; "
             f"{found['moved']} verdicts move with the convention"]
    if shared:
        lines.append("preloads that give all surveyed numbers: " + "; ".join(
            f"{scale} the accuracy: {', '.join(shared[scale]) or 'none'}" for scale in judge.SCALES)
            + f" (nearest: {shared['nearest']}, {shared['difference']:.0%})")
    return lines + [f"{entry['verdict']:<9} {entry['where']}: {entry['quote']}" for entry in made["sentences"]]
