"""Draws random edits of the source from a seed: a number for each room of src, and within a room each kind in turn."""

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
    """All edits of all sources below src, by room."""
    statuses, rooms = statuses_of(root), {}
    for room in sorted(os.listdir(os.path.join(root, "src"))):
        folder = os.path.join(root, "src", room)
        names = sorted(name for name in os.listdir(folder) if name.endswith(".c")) if os.path.isdir(folder) else ()
        found = []
        for name in names:
            with open(os.path.join(folder, name), encoding="utf-8") as stream:
                found += tokens.edits_of(f"src/{room}/{name}", stream.read(), statuses)
        if found:
            rooms[room] = found
    return rooms


def rank(seed, name):
    """The rank of an edit in the draw. It depends on the edit and the seed alone, so that changes of the source
    elsewhere do not change the draw."""
    return hashlib.sha256(f"{seed}/{name}".encode()).digest()


def order_of(seed, room, edits):
    """The edits of a room in the order of the draw: the kinds in turn, and by rank within a kind."""
    queues = {kind: [] for kind in sorted(tokens.KINDS, key=lambda kind: rank(seed, f"{room}/{kind}"))}
    for edit in sorted(edits, key=lambda edit: rank(seed, edit.name)):
        queues[edit.kind].append(edit)
    return queues


def draw_room(seed, room, edits, count, is_effective):
    """The first `count` edits of a room that change the program."""
    queues, drawn = order_of(seed, room, edits), []
    while len(drawn) < count and any(queues.values()):
        for queue in queues.values():
            while queue and len(drawn) < count:
                edit = queue.pop(0)
                if is_effective(edit):
                    drawn.append(edit)
                    break
    return drawn


def shares(seed, sizes, count):
    """The number of edits of each room, in proportion to the square root of the number of its candidates. They are
    assigned one by one (Sainte-Lague), so that a larger draw contains a smaller one."""
    share = dict.fromkeys(sizes, 0)
    for _ in range(count):
        share[max(sizes, key=lambda room: (math.sqrt(sizes[room]) / (2 * share[room] + 1), rank(seed, room)))] += 1
    return share


def draw(seed, rooms, count, is_effective, jobs=1):
    """Draws `count` edits, in the order of the rooms."""
    share = shares(seed, {room: len(edits) for room, edits in rooms.items()}, count)
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        drawn = pool.map(lambda room: draw_room(seed, room, rooms[room], share[room], is_effective), sorted(rooms))
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
        """Each room is drawn in one thread, so the edits of a file are never tested at the same time."""
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
