"""The named constants of the solver, as they stand in the source."""

import glob
import os
import re

NAME = r"\b(?P<name>[A-Z][A-Z0-9_]+)\s*=\s*"
DECLARATION = re.compile(r"\b(?:static\s+)?const\s+(?:long\s+)?(?:double|float|size_t|int|u?int\d+_t)\s+"
                         r"(?P<body>[A-Z][^;(){}\[\]]*=[^;{}]*);")
ENUM = re.compile(r"\benum\s*\w*\s*\{(?P<body>[^}]*)\}")
MACRO = re.compile(r"^[ \t]*#[ \t]*define[ \t]+(?P<name>[A-Z][A-Z0-9_]+)[ \t]+(?P<value>[^\n]+)$", re.MULTILINE)
WORDS = re.compile(r"(?<![\w.])[A-Za-z_]\w*")
PLAIN = {"DBL_EPSILON", "DBL_MIN", "INFINITY", "NAN", "size_t", "uint64_t"}   # words of a value that is a number all the same


def without_comments(text):
    """The same text with comments blank, so that places stay."""
    return re.sub(r"/\*.*?\*/", lambda comment: re.sub(r"[^\n]", " ", comment.group()), text, flags=re.DOTALL)


def parts(body, offset):
    """(name, value, begin, end) of each `NAME = value` of a list; commas in parentheses are part of a value."""
    for found in re.finditer(NAME, body):
        end, depth = found.end(), 0
        while end < len(body) and (depth or body[end] != ","):
            depth += {"(": 1, ")": -1}.get(body[end], 0)
            end += 1
        value = body[found.end():end].rstrip()
        yield found.group("name"), value, offset + found.end(), offset + found.end() + len(value)


def is_number(value):
    """Whether a value names no other constant: those that do follow from it."""
    return bool(re.search(r"\d", value)) and set(WORDS.findall(value)) <= PLAIN


def in_text(text):
    """(name, value, begin, end) of every constant of a source whose value is a number."""
    plain = without_comments(text)
    found = [part for pattern in (DECLARATION, ENUM) for block in pattern.finditer(plain)
             for part in parts(block.group("body"), block.start("body"))]
    found += [(m.group("name"), m.group("value").strip(), m.start("value"), m.end("value")) for m in MACRO.finditer(plain)]
    return sorted((part for part in found if is_number(part[1])), key=lambda part: part[2])


def sources(root):
    """Paths of the files that compute: core without `result`, which has types and names, but with its request."""
    paths = glob.glob(os.path.join(root, "src", "core", "*", "*.[ch]"))
    return sorted(path for path in paths
                  if os.path.basename(os.path.dirname(path)) != "result" or os.path.basename(path).startswith("po_request."))


def constants(root):
    """(file, name) -> (value, path, begin, end)."""
    result = {}
    for path in sources(root):
        with open(path, encoding="utf-8") as stream:
            for name, value, begin, end in in_text(stream.read()):
                result[os.path.basename(path), name] = (value, path, begin, end)
    return result
