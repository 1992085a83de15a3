"""Access to the reference data that a run was compared with."""

import os

from .tables import Table


class References:
    """The folder of reference data; a table is read on first use."""

    def __init__(self, folder):
        self.folder = folder
        self._tables = {}

    def path_of(self, name):
        """The path of a table. Pins are in the folder of the cases, next to the folder of the reference data."""
        folder = os.path.join(self.folder, "..", "cases") if name.startswith("pins/") else self.folder
        return os.path.join(folder, name)

    def has(self, name):
        return os.path.isfile(self.path_of(name))

    def table(self, name):
        """The Table with this file name, or None when there is no such file."""
        if name not in self._tables:
            path = self.path_of(name)
            self._tables[name] = Table(path) if os.path.isfile(path) else None
        return self._tables[name]


def file_name(reference):
    """"reference/feng.csv" -> "feng.csv", "reference/published/a.csv" -> "published/a.csv",
    "bradley", built in, stays as it is."""
    folder, name = os.path.split(reference or "")
    kind = os.path.basename(folder)
    return f"{kind}/{name}" if kind == "published" else name
