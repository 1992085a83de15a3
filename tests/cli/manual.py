#!/usr/bin/python3
"""The options of every verb: what it accepts, its help, its manual page and the completion scripts name the same ones.

    manual.py PROGRAM ROOT FOLDER-OF-PAGES

An option is accepted if the table of the verb has it. The program lists the options that begin with a letter when it is given the
letter alone, as an ambiguous beginning; where only one begins so, the names in any help are tried. An unknown option follows twice,
once as a value, so that nothing is ever computed.
"""

import pathlib
import re
import string
import subprocess
import sys

NAME = re.compile(r"--[a-z][a-z0-9-]*[a-z0-9]")
# In SI units, options for lengths end in -m. Help and pages say so in a sentence.
METRES = "lengths are then given by options that end in -m"
# Options that a verb reads in order to say why it does not take them.
REFUSED = {verb: {"--stiffness", "--stiffness-n-per-m"} for verb in ("follow", "compare", "contact-law")}
failed = []


def tell(what, wrong):
    print(f"{'ok' if not wrong else 'FAILED'}: {what}{': ' + str(wrong) if wrong else ''}")
    if wrong:
        failed.append(what)


def output(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False, stdin=subprocess.DEVNULL)
    return done.stdout + done.stderr


def is_accepted(program, verb, option):
    return f"unknown option {option} " not in output(program, verb, option, "--frobnicate", "--frobnicate") + " "


def all_accepted(program, verb, known):
    """The options of a verb. `known`: names in the order in which they are tried where the program lists none, which takes the
    beginning of a name for the name."""
    found = set()
    for letter in string.ascii_lowercase:
        said = output(program, verb, f"--{letter}", "--frobnicate", "--frobnicate")
        if "is the beginning of several options" in said:
            found |= set(NAME.findall(said.split("expected one of", 1)[1]))
        elif f"unknown option --{letter} " not in said:
            one = next((option for option in known if option[2] == letter and is_accepted(program, verb, option)), None)
            if one:
                found.add(one)
            else:
                tell(f"the option of {verb} that begins with {letter} is in a help", "it is in none")
    return found


def entries(text):
    """The options that begin an entry of a list in a help."""
    made = set()
    for line in text.splitlines():
        if re.match(r"  -", line):
            left = line if line.endswith(",") else re.split(r" {3,}|(?<=MANIFEST) ", line.strip())[0]
            made |= set(NAME.findall(left))
    return made


def page_entries(text):
    """The options that begin an entry of a page."""
    plain = text.replace("\\-", "-")
    return {option for line in re.findall(r"^\.TP\n(.*)$", plain, re.M) for option in NAME.findall(line)}


def bash_options(root, program, verb):
    script = f'source "{root}/src/cli/completion/pulloff.bash"; _pulloff_options "$1" "$2"'
    return set(output("bash", "-c", script, "bash", program, verb).split())


def bash_values(root, program, verb, option):
    script = f'source "{root}/src/cli/completion/pulloff.bash"; _pulloff_values "$@"'
    return set(output("bash", "-c", script, "bash", program, verb, option).split())


def zsh_values(root, program, verb, option):
    text = (root / "src/cli/completion/_pulloff").read_text(encoding="utf-8")
    command = re.search(r'^_pulloff_values\(\) {\n  found=\(\$\{\(f\)"\$\((.*?)\)"\}\)\n', text, re.M | re.S)[1]
    command = command.replace("$words[1]", '"$0"').replace("${(z)verb}", "$verb")
    return set(output("bash", "-c", command, program, verb, option).split())



def check_verb(program, root, pages, verb, helps):
    mine = entries(helps[verb])
    every = set().union(*(entries(text) for text in helps.values()))
    in_metres = METRES in " ".join(helps[verb].split())
    lengths = {option + "-m" for option in every if not option.endswith("-m")} if in_metres or verb == "plot" else set()
    accepted = all_accepted(program, verb, [*sorted(mine), *sorted((every | lengths) - mine, key=len, reverse=True)])
    documented = mine | REFUSED.get(verb, set())
    if in_metres:
        documented |= {option for option in accepted & lengths if option[:-2] in mine}
    if verb == "plot":  # its help refers to that of solve
        tell("plot refers to the options of solve", "those of pulloff solve" not in helps[verb])
        documented |= accepted & (entries(helps["solve"]) | {option for option in lengths if option[:-2] in entries(helps["solve"])})
    tell(f"{verb} accepts what its help names", sorted(mine - accepted))
    tell(f"the help of {verb} names what it accepts", sorted(accepted - documented))
    page = (pages / f"pulloff-{verb}.1").read_text(encoding="utf-8")
    tell(f"the page of {verb} has the options of its help", sorted(mine ^ page_entries(page)))
    tell(f"bash completes the options of {verb}", sorted(mine ^ bash_options(root, program, verb)))


def check_values(program, root):
    """The values that completion offers are those that the program names in a message; each of them is accepted."""
    for option, verb in (("--scheme", "solve"), ("--grading", "solve"), ("--law", "solve"), ("--profile", "solve"), ("--scale", "follow"),
                         ("--of", "follow"), ("--want", "solve"), ("--theory", "compare"), ("--key", "follow"), ("--suite", "list")):
        message = output(program, verb, option, "sugar").split("expected", 1)[1].split(";")[0]
        named = set(re.findall(r"[a-z][a-z0-9_-]+", message)) - {"any", "of", "or", "one", "in", "units", "commas", "between", "with"}
        bash, zsh = bash_values(root, program, verb, option), zsh_values(root, program, verb, option)
        tell(f"bash and zsh offer the same for {option}", sorted(bash ^ zsh))
        tell(f"completion offers the values of {option}", sorted(named ^ {value.rstrip(":") for value in bash}) or not bash)


def main(program, root, pages):
    root, pages = pathlib.Path(root), pathlib.Path(pages)
    verbs = re.findall(r"^  ([a-z]+)  ", output(program, "--help"), re.M)
    helps = {verb: output(program, verb, "--help") for verb in verbs}
    main_page = (root / "src/cli/pulloff.1").read_text(encoding="utf-8").replace("\\-", "-")
    tell("the page of the program names every verb", sorted(set(re.findall(r"^\.BR pulloff-(\w+) \(1\)$", main_page, re.M)) ^ set(verbs)))
    for verb in verbs:
        check_verb(program, root, pages, verb, helps)
    check_values(program, root)
    sys.exit(bool(failed))


if __name__ == "__main__":
    main(*sys.argv[1:])
