"""The scenes of scenes.txt, for the tests that solve them by other means than the command line."""

import pathlib

SCENES = pathlib.Path(__file__).with_name("scenes.txt")


def read_scenes():
    """Digest and command line of each."""
    lines = [line for line in SCENES.read_text().splitlines() if line and not line.startswith("#")]
    return [line.split(" ", 1) for line in lines]


def scenes_of_library():
    """Those of one solve or theory. Followed series have one digest only on the command line; uncertain numbers are of it."""
    return [(digest, line.replace("HERE", str(SCENES.parent))) for digest, line in read_scenes()
            if not line.startswith("follow") and "+-" not in line]


def keys_of(words):
    """The theory, or None, and the keys of a command line: solve, compare or theory NAME, and options."""
    theory, keys, waves = (words[1] if words[0] == "theory" else None), {}, []
    options = [word for word in words[2 if theory else 1:] if word != "--from-physical"]
    if words[0] == "compare":  # as solve with the theories
        options += ["--want", "theories"]
    for name, value in zip(options[::2], options[1::2]):
        name = name.removeprefix("--").replace("-", "_")
        if name == "wave":
            waves.append(value.replace(",", "@"))
        else:
            keys[name] = value
    if waves:
        keys["waves"] = ";".join(waves)
    return theory, keys
