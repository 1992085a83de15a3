#!/usr/bin/python3
"""Writes a manual page for each verb from the text that the program prints for --help.

    manual.py PROGRAM PAGE FOLDER

PAGE is the page of the program itself; the pages of the verbs take its date and version. They are FOLDER/pulloff-VERB.1.
"""

import collections
import pathlib
import re
import subprocess
import sys

OPTION = re.compile(r"--?[a-zA-Z][a-zA-Z0-9-]*")


def help_of(program, *verb):
    done = subprocess.run([program, *verb, "--help"], capture_output=True, text=True, check=True)
    return done.stdout.splitlines()


def verbs_of(program):
    """Verb -> what it does, from the list in the help of the program."""
    return dict(re.match(r"  ([a-z][a-z-]*) +(\S.*)", line).groups() for line in help_of(program) if re.match(r"  [a-z][a-z-]* {2,}\S", line))


def escaped(text):
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq").replace("^", "\\(ha").replace("~", "\\(ti")
    return "\\&" + text if text.startswith(".") else text


def prose(text):
    """Text with its options in bold."""
    parts = re.split(r"(?<![\w-])(--[a-z][a-z0-9-]*)", text)
    return "".join(f"\\fB{escaped(part)}\\fR" if k % 2 else escaped(part) for k, part in enumerate(parts))


def tag(text):
    """The left column of an entry: options and names in bold, values in italics."""
    words = re.split(r"([ ,|\[\]]+)", text)
    return "".join(escaped(word) if not word.strip(" ,|[]") else
                   f"\\fI{escaped(word)}\\fR" if word.isupper() else f"\\fB{escaped(word)}\\fR" for word in words)


def column_of(lines):
    """The column at which the text of most entries begins."""
    found = collections.Counter(match.end() for line in lines if (match := re.match(r"  \S.*? {2,}(?=\S)", line)))
    return found.most_common(1)[0][0] if found else None


def entry(line, column):
    """(left, right) of a line that begins an entry of a list, or None."""
    if not re.match(r"  \S", line):
        return None
    if column and len(line) > column and line[column - 1] == " " != line[column] and line[2:column].strip():
        return line[2:column].strip(), line[column:]
    match = re.match(r"  (\S.*?) {2,}(\S.*)", line)
    if match:
        return match.groups()
    return (line.strip(), "") if re.fullmatch(r"  -\S+( \S+)?(, -\S+( \S+)?)*,?", line) else None


def joined(lines):
    """The lines with those that end with a comma after options joined with the next one."""
    made = []
    for line in lines:
        if made and re.fullmatch(r"  --[^ ]+ .*,", made[-1]) and re.match(r"  --", line) and "   " not in made[-1].strip():
            made[-1] = made[-1] + " " + line.strip()
        else:
            made.append(line)
    return made


def body(lines):
    """Paragraphs, headings and lists as macros of man."""
    lines = joined(lines)
    column = column_of([line for line in lines if line.startswith("  -")]) or column_of(lines)
    made, inside, nested = [], False, None

    def leave_nested():
        nonlocal nested
        if nested is not None:
            made.append(".RE")
            nested = None

    for line in lines:
        indent = len(line) - len(line.lstrip())
        inner = re.match(r" {10,}(\S+) {2,}(\S.*)", line) if inside else None
        found = entry(line, column)
        if not line:
            leave_nested()
            made.append(".PP")
            inside = False
        elif not indent and re.fullmatch(r"[A-Z][\w ]+:", line):
            made.append(f'.SS "{line[:-1]}"')
        elif found:
            leave_nested()
            made += [".TP", tag(found[0])] + ([prose(found[1])] if found[1] else [])
            inside = True
        elif inner and (nested is not None or indent > (column or 0)):
            if nested is None:
                made.append(".RS")
            nested = inner.start(2)
            made += [".TP", tag(inner[1]), prose(inner[2])]
        else:
            if inside and indent <= 2:
                leave_nested()
                made.append(".PP")
                inside = False
            elif nested is not None and indent < nested:
                leave_nested()
                made.append(".IP")
            made.append(prose(line.strip()))
    leave_nested()
    return [line for k, line in enumerate(made) if line != ".PP" or (k + 1 < len(made) and not made[k + 1].startswith((".", "\0")))]


def page(verb, what, lines, title):
    usage = [lines[0].split(":", 1)[1].strip()]
    while lines[len(usage)].startswith("       "):
        usage.append(lines[len(usage)].strip())
    rest = lines[len(usage):]
    first = next(k for k, line in enumerate(rest) if line.startswith("Example: "))
    examples = [re.sub(r"^(Example: | {9}(?=pulloff))", "", line) for line in rest[first:]]
    text = rest[:first]
    while text and not text[-1]:
        text.pop()
    synopsis = []
    for line in usage:
        synopsis += [".br"] * bool(synopsis) + [tag(line)]
    begin = next((k for k, line in enumerate(text) if line.startswith("  -") or re.fullmatch(r"[A-Z][\w ]+:", line)), len(text))
    return "\n".join(
        [f".\\\" Made by manual.py from pulloff {verb} --help.", f".TH PULLOFF\\-{verb.upper()} 1 {title}", ".SH NAME",
         f"pulloff\\-{verb} \\- {escaped(what)}", ".SH SYNOPSIS"] + synopsis + [".SH DESCRIPTION"] + body(text[:begin])
        + [".SH OPTIONS"] + body(text[begin:]) + [".SH EXAMPLES", ".nf"] + [escaped(line) for line in examples]
        + [".fi", ".SH SEE ALSO", ".BR pulloff (1):", "units and signs, verdicts, why a trace ends, exit status, environment and files.", ""])


def main(program, main_page, folder):
    title = re.search(r"^\.TH PULLOFF 1 (.*)$", pathlib.Path(main_page).read_text(encoding="utf-8"), re.M)[1]
    for verb, what in verbs_of(program).items():
        text = page(verb, what, help_of(program, verb), title)
        (pathlib.Path(folder) / f"pulloff-{verb}.1").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
