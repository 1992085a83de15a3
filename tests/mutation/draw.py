"""Draws random edits of the source from a seed. The draw depends on the text of an edit, its function and the name of its
file, and on no folder: files can be moved."""

import collections
import hashlib
import math
import os
import re

import plant
import tokens

STATUS = re.compile(r"X\((PO_\w+),")


def candidates(root):
    """All edits of all sources below src, with the names of the files without folders; and where these files are."""
    paths = {name: os.path.join(folder, name) for folder, _, names in os.walk(os.path.join(root, "src")) for name in names}
    texts = {name: plant.content(path).decode() for name, path in sorted(paths.items()) if name.endswith((".c", "po_status.h"))}
    statuses = STATUS.findall(texts.pop("po_status.h"))
    return [edit for name, text in texts.items() for edit in tokens.edits_of(name, text, statuses)], paths


def order(seed, edits):
    """The edits in a random order, in which each kind occurs equally often, and a file with four times as many edits
    twice as often: the exponential variates of weighted sampling without replacement."""
    files, kinds = (collections.Counter(getattr(edit, key) for edit in edits) for key in ("file", "kind"))

    def variate(edit):
        uniform = (int(hashlib.sha256(f"{seed}/{edit.name}".encode()).hexdigest()[:13], 16) + 1) / 16**13
        return -math.log(uniform) * math.sqrt(files[edit.file]) * kinds[edit.kind]
    return sorted(edits, key=variate)


class Compiler:
    """Tests whether an edit compiles without a warning and gives an object file that no other edit gave."""

    def __init__(self, build, place, paths):
        self.build, self.place, self.paths, self.objects = build, place, paths, {}

    def object_bytes(self, path, text):
        """The object file of a text in place of a source; None if the compiler prints a warning or an error."""
        try:
            made, _ = self.build.compile_text(path, text, self.place, ["-Werror"])
        except plant.Stale:
            return None
        return plant.content(made)

    def is_effective(self, edit):
        path = self.paths[edit.file]
        if path not in self.build.compile:
            return False
        text = plant.content(path).decode()
        known = self.objects.setdefault(edit.file, {})
        if not known:
            known[self.object_bytes(path, text)] = None
        made = self.object_bytes(path, edit.applied(text))
        return made is not None and known.setdefault(made, edit.name) == edit.name
