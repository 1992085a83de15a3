"""The sections of the report, in the order they are read.

A section is a module with build(source) -> Section; its template stands in templates/sections/.
To add one: write the module and the template, and enter it in ORDER.
"""

import dataclasses

from ..records import Run
from ..references import References


@dataclasses.dataclass
class Source:
    """What every section draws on."""
    run: Run
    references: References
    faults: dict | None = None  # the matrix of planted faults
    claims: dict | None = None  # the claims of the paper, judged


@dataclasses.dataclass
class Section:
    """A headed part of the page: its template is filled with its data."""
    id: str
    title: str
    template: str
    data: dict
    entries: list = dataclasses.field(default_factory=list)  # (id, title) below it in the contents


def build_all(source):
    """Every section, in order."""
    from . import cases, checks, claims, environment, extreme, figures, planted_faults, precision, provenance
    order = (figures, claims, precision, extreme, checks, cases, planted_faults, provenance, environment)
    return [module.build(source) for module in order]
