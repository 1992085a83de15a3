"""The external solvers of a run as judges of claims: the same entries, with their records in place of those of this program.

A solver can judge an entry if some number of the entry comes from a case, the solver was asked for each such case, and
computes the quantity. Closed forms, reference tables and commands of the entry remain as they are.
"""

import os

from sources import SourceError, record_of

FOLDER = "solvers"
# The beginning of a path -> the quantity of the protocol that gives its numbers.
QUANTITIES = {"pull_off.force": "pull_off_force", "pull_off.approach": "pull_off_approach",
              "pull_off.contact_radius": "contact_radius", "folds.#": "fold_count", "folds.": "folds", "extrema.": "extrema",
              "curve.": "curve"}


class Other:
    """The sources of claims with the answers of one solver."""

    def __init__(self, name, folder, given):
        self.name, self.folder, self.given = name, folder, given

    def path_of(self, source):
        return os.path.join(self.folder, source["case"], "record.json")

    def computes(self, source):
        """Whether the solver was asked for the case of a source, and declares its quantity."""
        wanted = next((quantity for path, quantity in QUANTITIES.items() if source["at"].startswith(path)), None)
        try:
            return wanted in record_of(self.path_of(source))["solver"]["quantities"]
        except OSError:
            return False
        except SourceError:
            return True    # get reports that the record was altered

    def can_judge(self, choices):
        cases = [source for choice in choices for source in choice["get"].values() if "case" in source]
        return bool(cases) and all(map(self.computes, cases))

    def get(self, source):
        """As Sources.get. A list must have an item for each point of the case."""
        if "case" not in source:
            return self.given.get(source)
        found, lines = self.given.of_case(source, self.folder)
        ours, _ = self.given.of_case(source)
        if source.get("all") and len(found) != len(ours):
            raise SourceError(f"{self.name} solves {len(found)} of {len(ours)} points of {source['case']}")
        return found, lines


def read(given):
    """The solvers of the run of these sources, each at the finest value of its knob: the other values have an @ in their
    names."""
    place = os.path.join(given.run, FOLDER)
    names = sorted(name for name in os.listdir(place) if "@" not in name) if os.path.isdir(place) else []
    return [Other(name, os.path.join(place, name), given) for name in names]
