"""Draws random edits of the source from a seed: a number for each module of src, and within a module each kind in turn."""

import concurrent.futures
import hashlib
import math
import os
import re

import plant
import tokens

STATUS = re.compile(r"X\((PO_\w+),")


def statuses_of(root):
    with open(os.path.join(root, "src", "base", "po_status.h"), encoding="utf-8") as stream:
        return STATUS.findall(stream.read())


def candidates(root):
    """All edits of all sources below src, by module."""
    statuses, modules = statuses_of(root), {}
    for folder, _, files in sorted(os.walk(os.path.join(root, "src"))):
        found = []
        for name in sorted(name for name in files if name.endswith(".c")):
            path = os.path.join(folder, name)
            with open(path, encoding="utf-8") as stream:
                found += tokens.edits_of(os.path.relpath(path, root), stream.read(), statuses)
        if found:
            modules[os.path.relpath(folder, root)] = found
    return modules


def rank(seed, name):
    """The rank of an edit in the draw. It depends on the edit and the seed alone, so that changes of the source
    elsewhere do not change the draw."""
    return hashlib.sha256(f"{seed}/{name}".encode()).digest()


def order_of(seed, module, edits):
    """The edits of a module in the order of the draw: the kinds in turn, and by rank within a kind."""
    queues = {kind: [] for kind in sorted(tokens.KINDS, key=lambda kind: rank(seed, f"{module}/{kind}"))}
    for edit in sorted(edits, key=lambda edit: rank(seed, edit.name)):
        queues[edit.kind].append(edit)
    return queues


def draw_module(seed, module, edits, count, is_effective):
    """The first `count` edits of a module that change the program."""
    queues, drawn = order_of(seed, module, edits), []
    while len(drawn) < count and any(queues.values()):
        for queue in queues.values():
            while queue and len(drawn) < count:
                edit = queue.pop(0)
                if is_effective(edit):
                    drawn.append(edit)
                    break
    return drawn


def shares(seed, sizes, count):
    """The number of edits of each module, in proportion to the square root of the number of its candidates. They are
    assigned one by one (Sainte-Lague), so that a larger draw contains a smaller one."""
    share = dict.fromkeys(sizes, 0)
    for _ in range(count):
        share[max(sizes, key=lambda module: (math.sqrt(sizes[module]) / (2 * share[module] + 1), rank(seed, module)))] += 1
    return share


def draw(seed, modules, count, is_effective, jobs=1):
    """Draws `count` edits, in the order of the modules."""
    share = shares(seed, {module: len(edits) for module, edits in modules.items()}, count)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        drawn = pool.map(lambda module: draw_module(seed, module, modules[module], share[module], is_effective), sorted(modules))
        return [edit for row in drawn for edit in row]


class Compiler:
    """Tests whether an edit compiles without a warning and gives an object file that no other edit gave."""

    def __init__(self, build, place):
        self.build, self.place, self.objects = build, place, {}

    def object_bytes(self, file, text):
        """The object file of a text in place of a source; None if the compiler prints a warning or an error."""
        try:
            made, _ = self.build.compile_text(file, text, self.place(file), ["-Werror"])
        except plant.Stale:
            return None
        with open(made, "rb") as stream:
            return stream.read()

    def is_effective(self, edit):
        """Each module is drawn in one thread, so the edits of a file are never tested at the same time."""
        path = os.path.join(self.build.source, edit.file)
        if path not in self.build.compile:
            return False
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        if edit.file not in self.objects:
            self.objects[edit.file] = {self.object_bytes(edit.file, text)}
        made = self.object_bytes(edit.file, edit.applied(text))
        if made is None or made in self.objects[edit.file]:
            return False
        self.objects[edit.file].add(made)
        return True
