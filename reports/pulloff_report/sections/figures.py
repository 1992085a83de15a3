"""The figures of the paper, each drawn from the case that names it. A figure without a case is named in a sentence."""

from markupsafe import Markup

from . import Section
from .. import plots

PUBLISHED = {"published/feng_fig3.csv": "the curves of his Figure 3", "published/feng_fig4.csv": "his pull-off against μ, Figure 4"}
FENG = Markup(
    " <em>Feng’s problem</em> is the smooth sphere of Eqs 10–17. Here it was solved by a second program that shares "
    "neither code nor method with this one and states its own uncertainty.")


def feng_note(references):
    """Which of Feng's own points are available, and which reference is used instead of the others."""
    there = [name for name in PUBLISHED if references.has(name)]
    gone = [name for name in PUBLISHED if name not in there]
    note = Markup("")
    if there:
        note += Markup("Feng’s points ({}) were read off a printed figure and are in {}, with the uncertainty of the reading. "
                       "The solution of Feng’s problem is drawn beside them.").format(
            " and ".join(PUBLISHED[name] for name in there), files(there))
    if gone:
        note += Markup("{}Feng’s points ({}) are not available in tabulated form; the solution of Feng’s problem is used "
                       "instead. If a file with digitised points, {}, is added, the points are drawn and compared within "
                       "their digitisation error.").format(
            " " if there else "", " and ".join(PUBLISHED[name] for name in gone), files(gone, "or"))
    return note + FENG


def files(names, word="and"):
    return Markup(f" {word} ").join(Markup("<code>reference/{}</code>").format(name) for name in names)


def missing(module, script):
    """A figure that is not drawn, and the case that would draw it."""
    which = f"Figure {module.NUMBER}, {module.TITLE[0].lower()}{module.TITLE[1:]}" if module.NUMBER else module.TITLE
    return f"{which} ({getattr(module, 'CASE', script)})"


def build(source):
    figures, absent, run = [], [], source.run
    for script, module in plots.BY_SCRIPT.items():
        found = run.drawing(getattr(module, "CASE", script))
        if found or getattr(module, "SCHEMATIC", False) and run.is_of_paper:
            figures.append(module.make(found[0] if found else None, source.references))
        elif run.is_of_paper:
            absent.append(missing(module, script))
    entries = [(f"figure-{item.id}", f"Figure {item.number} · {item.title}" if item.number else item.title)
               for item in figures]
    return Section("figures", "Figures of the paper" if run.is_of_paper else "Figures", "figures.html",
                   {"figures": figures, "absent": absent, "note": feng_note(source.references) if run.is_of_paper else None},
                   entries, absent="" if figures else "figures")
