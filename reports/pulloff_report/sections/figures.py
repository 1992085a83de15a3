"""The figures of the paper, each drawn from the case that names it; what cannot be drawn is said."""

from markupsafe import Markup

from . import Section
from .. import plots

PUBLISHED = "published/feng_fig3.csv"
FENG_PRESENT = Markup(
    "Feng’s points (his Figure 3) are those of <code>reference/published/feng_fig3.csv</code>, read off "
    "a figure, with the uncertainty stated there. Beside them stands <em>Feng’s problem</em>: the "
    "smooth sphere of Eqs 10–17, solved by a program that shares neither code nor method with this "
    "one and carries its own uncertainty.")
FENG_ABSENT = Markup(
    "Feng’s points (his Figure 3, and his pull-off against μ) are not available in tabulated form. "
    "What stands in for them is <em>Feng’s problem</em>: the smooth sphere of Eqs 10–17, solved by "
    "a program that shares neither code nor method with this one and carries its own uncertainty. "
    "A digitised file of his points, <code>reference/published/feng_fig3.csv</code>, is drawn and compared "
    "once it is there, with its digitisation error.")


def missing(module, script):
    return (f"Figure {module.NUMBER}, {module.TITLE[0].lower()}{module.TITLE[1:]}, is left out: this "
            f"run holds no record of a case that draws it (pulloff run {script} makes one).")


def build(source):
    figures, absent = [], []
    for script, module in plots.BY_SCRIPT.items():
        found = source.run.drawing(script)
        if found:
            figures.append(module.make(found[0], source.references))
        else:
            absent.append(missing(module, script))
    note = FENG_PRESENT if source.references.has(PUBLISHED) else FENG_ABSENT
    entries = [(f"figure-{item.id}", f"Figure {item.number} · {item.title}") for item in figures]
    return Section("figures", "Figures of the paper", "figures.html",
                   {"figures": figures, "absent": absent, "note": note}, entries)
