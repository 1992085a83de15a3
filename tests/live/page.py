"""Uses the page as a reader does, in a headless Chromium.

Usage: page.py [--solves N] PAGE PROGRAM

Prints a line for each test in the format TAP. Exit status: 0 all tests pass, 1 some do not.
"""

import argparse
import json
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile
import time
import traceback

from browser import Browser

TEXT = "document.getElementById({}).textContent"
WAIT = 60  # s for a solve


class Reader:
    """A reader of the page."""

    def __init__(self, browser, page, program):
        self.browser, self.page, self.program = browser, page.resolve().as_uri(), program

    def text(self, name):
        return self.browser.evaluate(TEXT.format(json.dumps(name)))

    def wait(self, condition, what, seconds=WAIT):
        end = time.monotonic() + seconds
        while not self.browser.evaluate(condition):
            assert time.monotonic() < end, f"{what}: not within {seconds} s"
            time.sleep(0.02)

    def settle(self):
        """Waits until the page has the result of its scene, or a message; the page must answer meanwhile."""
        end = time.monotonic() + WAIT
        while True:
            begin = time.monotonic()
            idle = self.browser.evaluate("!pulloff.isBusy()")
            assert time.monotonic() - begin < 2, "the page does not answer"
            if idle:
                return
            assert time.monotonic() < end, f"no result after {WAIT} s"
            time.sleep(0.02)

    def open(self, fragment):
        self.browser.open("about:blank")
        self.browser.open(self.page + fragment)
        self.settle()

    def visit(self, fragment):
        self.browser.evaluate(f"location.hash = {json.dumps(fragment)}; new Promise((done) => setTimeout(done, 30))")
        self.settle()

    def enter(self, name, value):
        self.browser.evaluate(f"(() => {{ const field = document.getElementById('field-{name}'); field.value = {json.dumps(value)};"
                              "field.dispatchEvent(new Event('input')); })(); 0")
        self.settle()

    def digest_of_command(self, name="command"):
        words = shlex.split(self.text(name))
        assert words[0] == "pulloff", words
        printed = subprocess.run([self.program, *words[1:]], capture_output=True, text=True, check=True).stdout
        return re.search(r"^digest +(\w+)$", printed, flags=re.M).group(1)


def command_gives_the_digest(reader, _):
    reader.open("")
    examples = reader.browser.evaluate("[...document.querySelectorAll('.examples a')].map((link) => link.hash)")
    assert len(examples) > 5
    more = ["#tabor=2&waves=0.5,9;0.2,23&radius=60&preload=1", "#law=mie&mie-m=4&mie-n=10&tabor=0.7", "#tabor=1&scheme=ring&nodes=101",
            "#tabor=0&amplitude=1&wavelength=15", "#tabor=3&approach-start=-12&tolerance=1e-4"]
    for fragment in examples + more:
        reader.visit(fragment)
        assert not reader.text("messages"), (fragment, reader.text("messages"))
        assert reader.digest_of_command() == reader.text("digest"), fragment


def staircase_has_the_digest(reader, _):
    reader.open("#tabor=2&amplitude=1&wavelength=15")
    reader.browser.evaluate("document.getElementById('stairs').open = true")
    reader.wait(f"{TEXT.format(repr('stairs-digest'))} !== ''", "the staircase")
    assert reader.digest_of_command("stairs-command") == reader.text("stairs-digest")


def wrong_fields_give_a_message(reader, _):
    reader.open("#tabor=1")
    for name, value in (("tabor", "x"), ("tabor", "-1"), ("tabor", "1e999"), ("tabor", "<b>"), ("radius", "0"), ("wavelength", "nan"),
                        ("outer-radius", "-inf"), ("nodes", "1e9"), ("waves", "1,2;;x"), ("preload", "'\"\\")):
        reader.visit("#tabor=1&scheme=ring" if name == "nodes" else "#tabor=1&amplitude=1&wavelength=20" if name == "wavelength" else "#tabor=1")
        reader.enter(name, value)
        assert reader.text("messages"), (name, value)
        marked = reader.browser.evaluate(f"document.getElementById('field-{name}').getAttribute('aria-invalid')")
        assert marked == "true" or name == "outer-radius" or name == "waves", (name, value, reader.text("messages"))
    # several waves hide the fields of one wave, until they are deleted
    is_hidden = "document.getElementById('field-amplitude').parentNode.hidden"
    reader.visit("#tabor=1&waves=0.1,20;0.1,9")
    assert reader.browser.evaluate(is_hidden)
    reader.enter("waves", "")
    assert not reader.browser.evaluate(is_hidden) and not reader.text("messages")
    reader.visit("#tabor=1.5")
    assert not reader.text("messages") and reader.digest_of_command() == reader.text("digest")


def fuzzed_fragments_are_survived(reader, source):
    reader.open("")
    start = "tabor=2&amplitude=1&wavelength=20&radius=100&law=morse&morse-a=1&preload-load=1&tolerance=1e-4&time-limit=1"
    pieces = ["&", "=", "%", "%zz", "%00", "#", "tabor", "1e308", "-", "inf", "nan", "<script>", "from-physical", "modulus-pa=1", "\u20ac",
              "9" * 300, "profile=cone", "scheme=ring", "nodes=8", "__proto__=1", "waves=1,2;3,4", "constructor", "0"]
    for _ in range(60):
        text = start
        for _ in range(source.randrange(1, 5)):
            at, end = sorted(source.randrange(len(text) + 1) for _ in range(2))
            text = text[:at] + source.choice(pieces) + text[min(end, at + 12):]
        reader.visit("#" + text + "&time-limit=1")
        assert reader.text("messages") or reader.text("digest"), text
    reader.visit("#tabor=2")
    assert not reader.text("messages") and reader.digest_of_command() == reader.text("digest")


def a_long_solve_is_stopped(reader, _):
    reader.open("#tabor=1")
    before = reader.text("digest")
    reader.browser.evaluate("location.hash = '#tabor=20&amplitude=8&wavelength=10&radius=2000&tolerance=1e-9'")
    reader.wait("!document.getElementById('busy').hidden && /[1-9]\\d* points/.test(document.getElementById('busy-text').textContent)", "progress")
    reader.browser.evaluate("document.getElementById('stop').click()")
    reader.wait("document.getElementById('messages').textContent !== ''", "the message", 1)
    assert reader.text("digest") == before
    reader.visit("#tabor=3")
    assert not reader.text("messages") and reader.digest_of_command() == reader.text("digest")


def a_point_is_dragged_along_the_curve(reader, _):
    reader.browser.size(1280, 900)
    reader.open("#tabor=3&amplitude=1&wavelength=20")
    box = reader.browser.evaluate("(() => { scrollTo(0, 0); const b = document.getElementById('load').getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; })()")
    states = [reader.text("state")]
    for step in range(6):
        kind = "mousePressed" if step == 0 else "mouseMoved"
        reader.browser.call("Input.dispatchMouseEvent", type=kind, x=box[0] + box[2] * (0.2 + 0.12 * step), y=box[1] + 0.5 * box[3],
                            button="left", buttons=1, clickCount=1)
        states.append(reader.text("state"))
    assert len(set(states)) == len(states), states
    paths = "[document.querySelector('#gap .curve').getAttribute('d'), document.querySelector('#traction .curve').getAttribute('d')]"
    before = reader.browser.evaluate(paths)
    reader.browser.evaluate("document.getElementById('point').focus()")
    for name in ("ArrowRight", "ArrowRight", "ArrowLeft", "ArrowRight"):
        code = {"ArrowRight": 39, "ArrowLeft": 37}[name]
        for kind in ("keyDown", "keyUp"):
            reader.browser.call("Input.dispatchKeyEvent", type=kind, key=name, code=name, windowsVirtualKeyCode=code)
    after = reader.browser.evaluate(paths)
    assert before[0] != after[0] and before[1] != after[1]
    assert reader.text("state") != states[-1]


def units_are_changed_to_and_fro(reader, _):
    reader.open("#tabor=3&amplitude=1&wavelength=20&law=morse&morse-a=1")
    force = r"Pull-off force ([\d.]+) πwR"
    before = float(re.search(force, reader.text("summary"))[1])
    for _ in range(2):
        reader.browser.evaluate("document.getElementById('si').click()")
        reader.settle()
        assert not reader.text("messages") and reader.digest_of_command() == reader.text("digest")
    after = float(re.search(force, reader.text("summary"))[1])
    assert abs(after / before - 1) < 1e-4, (before, after)


def every_field_has_a_name(reader, _):
    for fragment in ("#tabor=2", "#from-physical&modulus-pa=1e10&work-j-per-m2=0.05&distance-m=4e-10&radius-m=1e-6", "#coupling=0.1&profile=power&power-c=0.01&power-n=3"):
        reader.open(fragment)
        nameless = reader.browser.evaluate(
            "[...document.querySelectorAll('input, select, button, svg[role]')].filter((e) => !(e.labels?.length || e.getAttribute('aria-label') || e.textContent)).map((e) => e.outerHTML)")
        assert not nameless, nameless


def a_narrow_screen_does_not_scroll_sideways(reader, _):
    reader.browser.size(420, 900, dark=True)
    for fragment in ("#tabor=4&amplitude=3&wavelength=10&outer-radius=100", "#from-physical&modulus-pa=1e10&work-j-per-m2=0.05&distance-m=4e-10&radius-m=1e-6"):
        reader.open(fragment)
        reader.browser.evaluate("for (const part of document.querySelectorAll('details')) part.open = true")
        assert reader.browser.evaluate("document.documentElement.scrollWidth") <= 420
    reader.browser.size(1280, 900)


def memory_is_bounded(reader, _, solves):
    reader.open("#tabor=1")
    memory = reader.browser.evaluate(
        "(async () => { const seen = []; for (let k = 0; k < %d; ++k) seen.push((await pulloff.ask({keys: {tabor: String(0.5 + k %% 7 / 4), "
        "amplitude: k %% 3 ? '0.3' : '0', wavelength: '20', want: 'curve,hysteresis'}})).memory); return seen; })()" % solves)
    assert len(memory) == solves and max(memory) == max(memory[:21]), (memory[20], max(memory))
    print(f"# {solves} solves: {memory[20] >> 20} MB after 21, {memory[-1] >> 20} MB at the end")


def a_figure_is_recomputed(reader, _):
    with tempfile.TemporaryDirectory() as folder:
        recompute_twice(reader, folder)
    reader.open("#figure=none")
    assert "none" in reader.text("messages")


def recompute_twice(reader, folder):
    page = reader.page
    text = pathlib.Path(page.removeprefix("file://")).read_text(encoding="utf-8")
    records = json.loads(re.search('id="records">(.*?)</script>', text)[1])
    for wrong in (0, 1):
        for name in records:
            count = len(records[name]["scenes"])
            reader.open(f"#figure={name}")
            reader.browser.evaluate("document.querySelector('#figures button').click()")
            reader.wait("document.querySelector('#figures button').textContent !== 'Stop'", name)
            words = reader.browser.evaluate("document.querySelector('#figures [role=status]').textContent")
            assert words == f"{count} of {count} solved, {count - wrong} identical to the last bit with the report", words
        # once more, with another hash of the first scene of each figure
        for figure in records.values():
            text = text.replace(figure["scenes"][0][1], "0123456789abcdef")
        changed = pathlib.Path(folder) / "changed.html"
        changed.write_text(text, encoding="utf-8")
        reader.page = changed.as_uri()
    reader.page = page


TESTS = [command_gives_the_digest, staircase_has_the_digest, wrong_fields_give_a_message, fuzzed_fragments_are_survived,
         a_long_solve_is_stopped, a_figure_is_recomputed, a_point_is_dragged_along_the_curve, units_are_changed_to_and_fro, every_field_has_a_name, a_narrow_screen_does_not_scroll_sideways,
         memory_is_bounded]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--solves", type=int, default=60)
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("program")
    chosen = parser.parse_args()
    failed = False
    print(f"1..{len(TESTS)}")
    with Browser() as browser:
        reader = Reader(browser, chosen.page, chosen.program)
        for number, test in enumerate(TESTS, 1):
            more = [chosen.solves] if test is memory_is_bounded else []
            begin, problem = time.monotonic(), ""
            try:
                test(reader, random.Random(number), *more)
            except (AssertionError, RuntimeError, subprocess.CalledProcessError):
                problem = traceback.format_exc()
            faults = browser.faults()
            failed = failed or bool(problem or faults)
            print(f"{'not ok' if problem or faults else 'ok'} {number} - {test.__name__} # {time.monotonic() - begin:.1f} s", flush=True)
            print("".join(f"# {line}\n" for line in problem.splitlines() + faults), end="", flush=True)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
