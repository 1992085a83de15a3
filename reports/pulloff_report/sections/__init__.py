"""The sections of the report, in reading order.

A section is a module with build(source) -> Section and a template in templates/sections/. To add one, write both
and add the module to build_all.
"""

import dataclasses

from .. import beside
from ..records import Run
from ..references import References


@dataclasses.dataclass
class Source:
    """The data that sections are built from."""
    run: Run
    references: References
    faults: dict | None = None  # the matrix of planted faults
    claims: dict | None = None  # the judged claims of the paper
    cost: dict | None = None    # what equilibria cost
    rate: dict | None = None    # the judged table of viscoelastic pull-offs


@dataclasses.dataclass
class Section:
    """A section with a heading; its template is filled with its data."""
    id: str
    title: str
    template: str
    data: dict
    entries: list = dataclasses.field(default_factory=list)  # (id, title) of its entries in the table of contents
    on_paper: bool = True     # whether the PDF has the section
    omitted_words: str = ""   # what the PDF says about a section that it does not have
    absent: str = ""          # why the run has nothing for this section, which is then left out; the first page says so


def build_all(source):
    """Every section, in order: those of the PDF first, then the long lists that only the HTML page has."""
    from . import cases, checks, claims, cost, environment, extreme, figures, general, planted_faults, precision, provenance, rate, scores, solvers, theories, verdicts
    order = (figures, claims, theories, rate, general, precision, solvers, cost, extreme, verdicts, environment, planted_faults, scores, checks, cases, provenance)
    # Its figures need as long as all the rest.
    drawn = beside.start(lambda: precision.build(source))
    built = {module: module.build(source) for module in order if module is not precision}
    built[precision] = drawn.result()
    return [built[module] for module in order]
