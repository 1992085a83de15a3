"""The reference data a run was compared with: where it comes from, and whether it is intact."""

import os

from .tables import Table


class References:
    """The folder of reference data; a table is read when first asked for."""

    def __init__(self, folder):
        self.folder = folder
        self._tables = {}

    def has(self, name):
        return os.path.isfile(os.path.join(self.folder, name))

    def table(self, name):
        """The Table of this file name, or None when there is no such file."""
        if name not in self._tables:
            path = os.path.join(self.folder, name)
            self._tables[name] = Table(path) if os.path.isfile(path) else None
        return self._tables[name]


def file_name(reference):
    """"reference/feng.csv" -> "feng.csv", "reference/published/a.csv" -> "published/a.csv"; "bradley",
    built in, stays as it is."""
    return (reference or "").rpartition("reference/")[2]
