"""The reference data the run was compared with: where each file comes from and whether it is intact."""

from . import Section
from ..references import file_name

KEYS = ("source", "method", "units", "uncertainty", "generator", "command", "date")
# What the words mean that stand for a reference and are no table.
WORDS = {"every_scene": "Every scene has its equilibria: the share of those solved is to be 1",
         "zero": "What an exact solution has none of",
         "traced": "The trace of the same scene by the same program; it vouches for the following, not for the solver"}
CLOSED_FORM = "A closed form built into the program"
STATES = {"verified": "intact: the checksum is the stated one",
          "differs": "altered: the checksum is not the stated one",
          "absent": "no checksum is stated"}


def card(source, name, cases):
    """What is known of a reference; one without a file may be a closed form with a table of it."""
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
    """Published tables that are not there: name -> (what stands in, the cases that would use it)."""
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
    return Section("references", "Reference data", "provenance.html",
                   {"cards": cards, "absent": absent(source)},
                   [(f"reference-{item['name']}", item["name"]) for item in cards])
