"""Staircases of other profiles and of several waves, with those of the JKR theory."""

from ..words import plain, spelled, value_of
from . import staircase

NUMBER = None
TITLE = "Pull-off force against preload: other profiles, several waves"


def title(point):
    """The profile, its waves (amplitude/wavelength) and the coupling of a point."""
    scene = point["input"]
    name = f"R† = {plain(scene['radius'])}" if scene["profile"] == "sphere" else spelled(point, "profile")
    waves = ", ".join(wave.replace("@", "/") for wave in scene["waves"].split(";"))
    return f"{name}, A†/λ† = {waves}, w/(E*ε) = {plain(value_of(point, 'coupling'))}"


def make(case, references):
    del references
    return staircase.draw(case, "general_stairs", TITLE, title, "JKR", key_frame=3)
