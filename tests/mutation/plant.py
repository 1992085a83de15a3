"""Plants one fault in the program: an edited copy of one source file, or of every source that includes an edited header,
is compiled as the build does and linked before the libraries, so that it replaces their objects. The source tree remains
unchanged."""

import json
import os
import re
import shlex
import shutil
import subprocess
import tomllib

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.dirname(os.path.dirname(HERE))

KINDS = ("physics", "harness")
FAULT = {"name": str, "kind": str, "what": str, "file": str, "old": str, "new": str}
OPTIONAL = {"tests": list, "pin_suffices": bool, "timeout_counts": bool}

# Of the linkers of binutils, gold takes a third of the time of the other, which was a third of that of a fault.
LINKER = ["-fuse-ld=gold"] if shutil.which("ld.gold") else []


class Stale(Exception):
    """A fault does not fit the source, or the build cannot be used."""


def content(path):
    with open(path, "rb") as stream:
        return stream.read()


def read_entries(path):
    """The entries of a file, whose tables are named by kind and name, each with both."""
    tables = tomllib.loads(content(path).decode())
    return [{"name": name, "kind": kind, **entry} for kind, entries in tables.items() for name, entry in entries.items()]


def read_faults(path):
    """The faults of a file, each with all keys."""
    faults = read_entries(path)
    names = set()
    for fault in faults:
        known = dict(FAULT, **OPTIONAL)
        wrong = [key for key in fault if not isinstance(fault[key], known.get(key, ()))]
        wrong += [key for key in FAULT if key not in fault]
        if wrong or fault["kind"] not in KINDS or fault["name"] in names:
            raise Stale(f"{path}: {fault.get('name', 'a fault')}: {', '.join(wrong) or 'its kind or name'} is not as "
                        "tests/mutation/README.md says")
        names.add(fault["name"])
        for key, kind in OPTIONAL.items():
            fault.setdefault(key, kind())
    return faults


def altered(fault):
    """The source with the fault. The text of the fault must occur in it exactly once."""
    path = os.path.join(SOURCE, fault["file"])
    try:
        text = content(path).decode()
    except OSError as error:
        raise Stale(f"{fault['file']}: {error.strerror}") from error
    times = text.count(fault["old"])
    if times != 1 or fault["old"] == fault["new"]:
        raise Stale(f"{fault['file']} holds {fault['old']!r} {times} times, expected once: the fault no longer fits the "
                    "source")
    return text.replace(fault["old"], fault["new"])


class Build:
    """The commands with which a build folder of meson compiles files and links programs."""

    def __init__(self, folder, source=SOURCE):
        self.folder, self.source = os.path.abspath(folder), source
        with open(os.path.join(self.folder, "compile_commands.json"), encoding="utf-8") as stream:
            entries = json.load(stream)
        # some tests compile a source again with other options; the command of the library counts
        entries.sort(key=lambda entry: entry["output"].startswith("src/"))
        self.compile = {os.path.normpath(os.path.join(self.folder, entry["file"])): entry for entry in entries}
        self.links = {}

    def link_command(self, program):
        if program not in self.links:
            said = subprocess.run(["ninja", "-C", self.folder, "-t", "commands", program], capture_output=True,
                                  text=True, check=True)
            self.links[program] = shlex.split(said.stdout.splitlines()[-1])
        return self.links[program]

    def target_of(self, file):
        """The library or program that a source is compiled for."""
        return os.path.dirname(self.compile[os.path.join(self.source, file)]["output"]).removesuffix(".p")

    def tested_by(self, program):
        """The library that a program tests: the first one of src that it is linked with; a program of src tests itself."""
        libraries = [word for word in self.link_command(program) if word.endswith(".a") and word.startswith("src/")]
        return program if program.startswith("src/") or not libraries else libraries[0]

    def objects_of(self, fault, place):
        """Compiles the edited source, or all that include the edited header, into `place`. Returns pairs of a new object
        and the object that it replaces."""
        if not fault["file"].endswith(".h"):
            return [self.compile_text(fault["file"], altered(fault), place, ["-w"])]
        headers, files = self.included_in(fault["file"])
        for header in headers:  # an include in quotes looks in the folder of the includer first
            text = altered(fault) if header == fault["file"] else self.text_of(header)
            with open(os.path.join(place, os.path.basename(header)), "w", encoding="utf-8") as stream:
                stream.write(text)
        return [self.compile_text(file, self.text_of(file), place, ["-w"]) for file in files]

    def text_of(self, file):
        return content(os.path.join(self.source, file)).decode()

    def included_in(self, header):
        """The header and those that include it, and the compiled sources below src that include one of these."""
        names = [os.path.relpath(os.path.join(place, name), self.source) for place, _, inside in
                 os.walk(os.path.join(self.source, "src")) for name in inside if name.endswith((".c", ".h"))]
        includes = {name: set(re.findall(r'^ *# *include "([^"]+)"', self.text_of(name), re.MULTILINE)) for name in names}
        headers, more = [], [header]
        while more:
            headers += more
            wanted = {os.path.basename(name) for name in headers}
            more = [name for name in names if name.endswith(".h") and name not in headers and includes[name] & wanted]
        files = sorted(name for name in names if os.path.join(self.source, name) in self.compile and includes[name] & wanted)
        if not files:
            raise Stale(f"{header} is included in no file that is compiled in {self.folder}")
        return headers, files

    def check_fit(self, fault):
        """Raises Stale if the fault cannot be planted."""
        altered(fault)
        if fault["file"].endswith(".h"):
            self.included_in(fault["file"])
        elif os.path.join(self.source, fault["file"]) not in self.compile:
            raise Stale(f"{fault['file']} is not compiled in {self.folder}")

    def compile_text(self, file, text, place, options):
        """Compiles a text instead of a source, with additional options, into `place`. Returns the new object and the
        object that it replaces."""
        entry = self.compile.get(os.path.join(self.source, file))
        if entry is None:
            raise Stale(f"{file} is not compiled in {self.folder}")
        copy = os.path.join(place, os.path.basename(file))
        with open(copy, "w", encoding="utf-8") as stream:
            stream.write(text)
        made = copy + ".o"
        words = shlex.split(entry["command"])
        words[words.index("-c") + 1] = copy
        for option, value in (("-o", made), ("-MF", made + ".d"), ("-MQ", made)):
            words[words.index(option) + 1] = value
        said = subprocess.run(words + options, cwd=self.folder, capture_output=True, text=True, check=False)
        if said.returncode:
            raise Stale(f"{file} with the fault does not compile:\n{said.stderr}")
        return made, entry["output"]

    def program(self, program, objects, place):
        """Links a program with the edited objects, as objects_of returns them; None if it contains none of them."""
        words = list(self.link_command(program))
        contains = False
        for made, original in objects:
            module = os.path.join(os.path.dirname(os.path.dirname(original)), os.path.basename(os.path.dirname(original)))
            if original in words:  # an object of the program, not of a library
                words[words.index(original)] = made
            elif module.removesuffix(".p") in words:
                words.insert(next(place for place, word in enumerate(words) if word.endswith(".o")), made)
            else:
                continue
            contains = True
        if not contains:
            return None
        path = os.path.join(place, os.path.basename(program))
        words[words.index("-o") + 1] = path
        said = subprocess.run(words + LINKER, cwd=self.folder, capture_output=True, text=True, check=False)
        if said.returncode:
            raise Stale(f"{program} with the fault does not link:\n{said.stderr}")
        return path
