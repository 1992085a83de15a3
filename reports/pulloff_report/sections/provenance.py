"""The reference data of the checks: the origin of each file and whether it is intact."""

from . import Section
from ..references import file_name
from ..words import count

KEYS = ("source", "method", "units", "uncertainty", "generator", "command", "date")
# References that are keywords and not tables.
WORDS = {"every_scene": "Every scene has equilibria, so the expected fraction of solved scenes is 1",
         "zero": "A quantity that vanishes for an exact solution",
         "traced": "A full trace of the same scene by the same program; it verifies the parameter continuation, not the solver"}
CLOSED_FORM = "A closed-form solution built into the program"
STATES = {"verified": "intact: the data have the stated checksum",
          "differs": "altered: the data do not have the stated checksum",
          "absent": "the file states no checksum"}


def card(source, name, cases):
    """The entry of a reference. A closed-form solution has no file of its own, but may have a table of values."""
    built_in = not name.endswith(".csv")
    table = source.references.table(name + ".csv" if built_in else name)
    entry = {"name": name, "cases": sorted(cases), "table": table, "built_in": built_in,
             "meaning": WORDS.get(name, CLOSED_FORM),
             "kind": "", "rows": []}
    if table is None:
        return entry
    entry["what"] = table.header.get("what", "")
    entry["kind"] = table.header.get("kind", "")
    shown = [key for key in KEYS if table.header.get(key)]
    others = [key for key in table.header if key not in KEYS + ("what", "kind", "sha256")]
    entry["rows"] = [(key.replace("_", " "), table.header[key]) for key in shown + others]
    entry["state"] = table.digest_state()
    entry["state_text"] = STATES[entry["state"]]
    entry["digest"] = table.digest()
    return entry


def absent(source):
    """Published tables that are not available, with the reference used instead and the cases that would use them."""
    found = {}
    for case in source.run.cases:
        for check in case.left_out:
            entry = found.setdefault(file_name(check["reference"]),
                                     {"stand_in": file_name(check["stand_in"]), "cases": set()})
            entry["cases"].add(case.name)
    return [{"name": name, "stand_in": entry["stand_in"], "cases": sorted(entry["cases"])}
            for name, entry in sorted(found.items())]


def build(source):
    used = {}
    for case in source.run.cases:
        for check in case.checks:
            name = file_name(check.get("reference"))
            if name:
                used.setdefault(name, set()).add(case.name)
    cards = [card(source, name, cases) for name, cases in sorted(used.items())]
    return Section("references", "Reference data", "provenance.html", {"cards": cards, "absent": absent(source)},
                   on_paper=False, omitted_words=f"{count(len(cards), 'reference')} of the checks: source, method, uncertainty, "
                   "generator and checksum of each")
