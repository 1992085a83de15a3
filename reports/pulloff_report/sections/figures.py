"""The figures of the paper, each drawn from the case that names it; what cannot be drawn is said."""

from markupsafe import Markup

from . import Section
from .. import plots

PUBLISHED = {"published/feng_fig3.csv": "his Figure 3", "published/feng_fig4.csv": "his pull-off against μ, Figure 4"}
FENG = Markup(
    " <em>Feng’s problem</em> is the smooth sphere of Eqs 10–17, solved by a program that shares neither code "
    "nor method with this one and carries its own uncertainty.")


def feng_note(references):
    """What of Feng's own points is at hand, and what stands in for the rest."""
    there = [name for name in PUBLISHED if references.has(name)]
    gone = [name for name in PUBLISHED if name not in there]
    note = Markup("")
    if there:
        note += Markup("Feng’s points ({}) are those of {}, read off a figure, with the uncertainty stated there. "
                       "Beside them stands Feng’s problem.").format(
            " and ".join(PUBLISHED[name] for name in there), files(there))
    if gone:
        note += Markup("{}Feng’s points ({}) are not available in tabulated form. What stands in for them is Feng’s "
                       "problem. A digitised file of his points, {}, is drawn and compared once it is there, with its "
                       "digitisation error.").format(
            " " if there else "", " and ".join(PUBLISHED[name] for name in gone), files(gone, "or"))
    return note + FENG


def files(names, word="and"):
    return Markup(f" {word} ").join(Markup("<code>reference/{}</code>").format(name) for name in names)


def missing(module, script):
    which = f"Figure {module.NUMBER}, {module.TITLE[0].lower()}{module.TITLE[1:]}," if module.NUMBER else f"{module.TITLE}"
    return (f"{which} is left out: this "
            f"run holds no record of a case that draws it (pulloff run {case_of(module, script)} makes one).")


def case_of(module, script):
    """The case that a figure is drawn from."""
    return getattr(module, "CASE", script) + ("_any" if getattr(module, "AT_ANY_PRELOAD", False) else "")


def build(source):
    figures, absent = [], []
    for script, module in plots.BY_SCRIPT.items():
        found = [case for case in source.run.drawing(getattr(module, "CASE", script))
                 if case.any_preload or not getattr(module, "AT_ANY_PRELOAD", False)]
        if found or getattr(module, "SCHEMATIC", False):
            figures.append(module.make(found[0] if found else None, source.references))
        else:
            absent.append(missing(module, script))
    entries = [(f"figure-{item.id}", f"Figure {item.number} · {item.title}" if item.number else item.title)
               for item in figures]
    return Section("figures", "Figures of the paper", "figures.html",
                   {"figures": figures, "absent": absent, "note": feng_note(source.references)}, entries)
