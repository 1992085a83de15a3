"""Uses the page as a reader does, in a headless Chromium.

Usage: page.py [--solves N] [--only TEXT] PAGE PROGRAM REPORT

REPORT: a report with the page beside it, as live.html.

Prints a line for each test in the format TAP. Exit status: 0 all tests pass, 1 some do not.
"""

import argparse
import base64
import gzip
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

    def __init__(self, browser, page, program, report):
        self.browser, self.page, self.program, self.report = browser, page.resolve().as_uri(), pathlib.Path(program).resolve(), report

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
            idle = self.browser.evaluate("window.pulloff?.isBusy() === false")
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

    def printed(self, line, *more, folder=None):
        words = shlex.split(line)
        assert words[0] == "pulloff", words
        return subprocess.run([self.program, *words[1:], *more], capture_output=True, text=True, check=True, cwd=folder).stdout

    def digest_of_command(self, name="command", folder=None):
        return re.search(r"^digest +(\w+)$", self.printed(self.text(name), folder=folder), flags=re.M).group(1)

    def rows(self, name):
        """The cells of the body of a table."""
        return self.browser.evaluate(f"[...document.querySelector('{name}').tBodies[0].rows].map((row) => [...row.cells].map((cell) => cell.textContent))")

    def click(self, selector):
        self.browser.evaluate(f"document.querySelector({json.dumps(selector)}).click()")
        self.settle()


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


def a_spring_has_its_loop(reader, _):
    for fragment in ("#tabor=3&amplitude=1&wavelength=20", "#from-physical&modulus-pa=1e10&work-j-per-m2=0.05&distance-m=4e-10&radius-m=1e-6&preload-load-n=1e-7"):
        reader.open(fragment)
        reader.click("#spring")
        name = "stiffness-n-per-m" if "physical" in fragment else "stiffness"
        reader.enter(name, "30" if "physical" in fragment else "0.04")
        assert not reader.text("messages") and f"--{name} " in reader.text("command"), reader.text("messages")
        assert reader.digest_of_command() == reader.text("digest")
        loop = json.loads(reader.printed(reader.text("command"), "--json"))["hysteresis"]["spring"]
        energy = [row[1] for row in reader.rows("#numbers") if "spring" in row[0]]
        assert len(energy) == 1 and ("physical" in fragment or abs(float(energy[0].split()[0]) / loop["energy_lost"] - 1) < 1e-3), energy
        # at a jump the far end of the spring, which the figure has as its abscissa, stays where it is
        jumps = reader.browser.evaluate("[...document.querySelectorAll('#load line.jump')].map((line) => ['x1', 'x2', 'y1', 'y2'].map((end) => Number(line.getAttribute(end))))")
        assert len(jumps) == len(loop["jumps"]) and all(abs(a - b) < 0.05 and abs(c - d) > 1 for a, b, c, d in jumps), jumps
        reader.visit(reader.browser.evaluate("location.hash"))
        assert reader.browser.evaluate("document.getElementById('spring').checked")
        reader.click("input[name=control]")
        assert name not in reader.text("command") and reader.digest_of_command() == reader.text("digest")


def a_table_is_a_profile(reader, source):
    reader.open("#profile=table&coupling=0.2")
    table = "r,gap\n" + "".join(f"{r},{r * r * (1 + 0.1 * source.random() / (1 + r)) / 60:.3f}\n" for r in range(0, 40, 2))
    for text, is_good in (("", False), ("r,gap\n0,0\n1,x\n", False), ("x" * 5000, False), (table.replace(",", "|"), False), (table.replace(",", ";"), True), (table, True), (table[:-1], True)):
        reader.enter("table", text)
        marked = reader.browser.evaluate("document.getElementById('field-table').getAttribute('aria-invalid')")
        assert bool(reader.text("messages")) != is_good and marked == (None if is_good else "true"), (text, reader.text("messages"))
    with tempfile.TemporaryDirectory() as folder:
        name, saved = reader.browser.evaluate("(() => { const link = document.getElementById('save'); return [link.download, decodeURIComponent(link.href.replace(/^[^,]*,/, ''))]; })()")
        pathlib.Path(folder, name).write_text(saved, encoding="utf-8")
        assert reader.digest_of_command(folder=folder) == reader.text("digest")
    # the address holds the table
    before = reader.text("digest")
    reader.open(reader.browser.evaluate("location.hash"))
    assert reader.text("digest") == before
    # a file that is dropped on the field
    reader.browser.evaluate("(() => { const files = new DataTransfer(); files.items.add(new File(['r,gap\\n0,0\\n'], 'tip.csv'));"
                            "document.getElementById('field-table').dispatchEvent(new DragEvent('drop', {dataTransfer: files, cancelable: true})); })(); 0")
    reader.wait("document.getElementById('messages').textContent.includes('profile.csv')", "the message about the file")


def theories_are_those_of_compare(reader, _):
    for fragment in ("#tabor=3&amplitude=1&wavelength=20", "#tabor=0.05", "#coupling=0.05&profile=cone&cone-t=0.3", "#tabor=4&amplitude=3&wavelength=10&outer-radius=100"):
        reader.open(fragment)
        wanted = json.loads(reader.printed(reader.text("command"), "--json"))["theories"]
        printed = reader.printed(reader.text("command").replace(" solve ", " compare ").split(" --want ")[0])
        rows = reader.rows("#theories")
        assert len(rows) == len(wanted)
        for row, theory in zip(rows, wanted):
            assert row[5] == theory["source"] and f"\n{row[0]} " in printed, row
            if theory["force"] is None:
                assert row[1] == "–" and row[4] == theory["reason"], row
            else:
                assert abs(float(row[1]) / theory["force"] - 1) < 1e-5 and row[3] == theory["assumptions"], row
                line = next(line for line in printed.splitlines() if line.startswith(row[0] + " "))
                assert line.endswith(row[4].replace("−", "-")), (line, row)


def a_series_is_followed(reader, _):
    reader.open("#tabor=3&amplitude=0.3&wavelength=20&preload-load=1")
    reader.browser.evaluate("document.getElementById('series').open = true")
    state = "document.querySelector('#series [role=status]').textContent"

    def compute(*values):
        for name, value in zip(("from", "to", "points"), values):
            reader.browser.evaluate(f"document.querySelector('#series [name={name}]').value = {json.dumps(value)}; 0")
        reader.browser.evaluate("document.querySelector('#series button').click()")

    for values in (("", "3", "5"), ("2", "1", "5"), ("0", "1", "5"), ("1", "2", "1"), ("1", "2", "x"), ("1", "x", "5"), ("-1", "2", "-5")):
        compute(*values)
        reader.wait(f"/expected/.test({state})", values)
    compute("0.5", "5", "20")
    reader.wait(f"/^20 scenes/.test({state})", "the series")
    wanted = json.loads(reader.printed(reader.browser.evaluate("document.querySelector('#series pre').textContent"), "--json"))["points"]
    assert any(point["followed"] for point in wanted) and not all(point["followed"] for point in wanted)
    rows = reader.rows("#series table")
    assert len(rows) == 20
    for row, point in zip(rows, wanted):
        bound = point["pull_off"]["error_estimate"]
        assert abs(float(row[0]) / point["input"]["tabor"] - 1) < 1e-5 and row[3] == "ok", row
        assert abs(float(row[1].split()[0]) - point["pull_off"]["force"]) < bound, row
    # a click on a point opens its scene
    reader.browser.evaluate("document.querySelector('#series .scene:last-child').dispatchEvent(new MouseEvent('click')); 0")
    reader.settle()
    assert "tabor=5" in reader.browser.evaluate("location.hash") and reader.digest_of_command() == reader.text("digest")
    # a long one is stopped
    reader.browser.evaluate("location.hash = '#tabor=8&amplitude=3&wavelength=6&radius=400'; new Promise((done) => setTimeout(done, 50))")
    compute("5", "20", "200")
    reader.wait(f"/begun/.test({state})", "progress")
    reader.browser.evaluate("document.querySelector('#series button').click()")
    reader.wait(f"{state} === 'Stopped.'", "the end", 2)


def wrong_fields_give_a_message(reader, _):
    reader.open("#tabor=1")
    for name, value in (("tabor", "x"), ("tabor", "0,5"), ("tabor", "-1"), ("tabor", "1e999"), ("tabor", "<b>"), ("radius", "0"), ("wavelength", "nan"),
                        ("outer-radius", "-inf"), ("nodes", "1e9"), ("waves", "1,2;;x"), ("preload", "'\"\\")):
        reader.visit("#tabor=1&scheme=ring" if name == "nodes" else "#tabor=1&amplitude=1&wavelength=20" if name == "wavelength" else "#tabor=1")
        reader.enter(name, value)
        assert reader.text("messages"), (name, value)
        marked = reader.browser.evaluate(f"document.getElementById('field-{name}').getAttribute('aria-invalid')")
        assert reader.text("messages").endswith("(decimal point, not comma)") == (value == "0,5")
        assert marked == "true" or name == "outer-radius" or name == "waves", (name, value, reader.text("messages"))
    # an empty field shows the value for which the solver takes it
    reader.visit("#tabor=3")
    reader.enter("tabor", "")
    assert not reader.text("messages") and reader.browser.evaluate("document.getElementById('field-tabor').placeholder") == "1"
    by_default = reader.text("digest")
    reader.visit("#tabor=1")
    assert reader.text("digest") == by_default
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


def fuzzed_fields_are_survived(reader, source):
    values = ["", "-", "1e", "1e999", "-1e999", "nan", "Infinity", "0x10", "1,2", "1;2", "é", "\u202e1", "<svg onload=alert(1)>", "9" * 190, "1e-300", "-0", " 3 ", "'; --"]
    for start in ("#tabor=1&amplitude=0.5&wavelength=20&time-limit=1", "#from-physical&modulus-pa=1e10&work-j-per-m2=0.05&distance-m=4e-10&radius-m=1e-6&time-limit=1",
                  "#coupling=0.1&profile=punch&punch-b=5&punch-r=20&law=mie&mie-m=4&mie-n=10&time-limit=1", "#tabor=1&stiffness=0.05&scheme=ring&nodes=50&time-limit=1"):
        reader.open(start)
        names = reader.browser.evaluate("[...document.querySelectorAll('.field input[type=text]')].map((field) => field.id.slice(6)).filter((name) => name !== 'time-limit')")
        for _ in range(25):
            name, value = source.choice(names), source.choice(values)
            try:
                reader.enter(name, value)
            except AssertionError as error:
                raise AssertionError(f"{name}: {value!r}") from error
            assert reader.text("messages") or reader.text("digest"), (name, value)
            if source.random() < 0.5:
                reader.visit(start)
        reader.visit(start)
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
    # what both units have stays, what one of them lacks is named, and a scene that is not solved is converted, too
    reader.visit("#tabor=3&outer-radius=50&approach-start=-12&stiffness=0.1")
    reader.click("#si")
    assert "approach-start" in reader.text("messages") and "--outer-radius-m 2e-8" in reader.text("command") and "--stiffness-n-per-m" in reader.text("command")
    reader.click("#si")
    assert all(f"--{name}" in reader.text("command") for name in ("tabor 3", "outer-radius 50", "stiffness 0.1")), reader.text("command")
    reader.visit("#tabor=3&time-limit=x")
    for _ in range(2):
        reader.click("#si")
    assert "tabor=3&" in reader.browser.evaluate("location.hash"), reader.browser.evaluate("location.hash")


def units_follow_the_profile(reader, _):
    for fragment, unit, energy in (("#tabor=2", "πwR", "πwRε"), ("#coupling=0.5&profile=punch&punch-b=8&punch-r=40", "πwε", "πwε²")):
        reader.open(fragment)
        rows = reader.rows("#numbers")
        assert rows[0][2] == unit and [row[2] for row in rows if "Energy" in row[0]] == [energy], rows
        assert all(f"loads in {unit}," in reader.text(name) for name in ("hint", "units"))


def a_preload_is_named_where_one_is_needed(reader, _):
    for fragment in ("#tabor=1", "#tabor=3&amplitude=1&wavelength=20"):
        reader.open(fragment)
        found = json.loads(reader.printed(reader.text("command"), "--json"))["pull_off"]
        rows = [row for row in reader.rows("#numbers") if row[0].startswith(("Preload", "Load"))]
        if found["preload"]["approach"] == found["approach"]:
            assert rows == [["Preload needed", "none: any contact suffices", ""]], rows
        else:
            assert [abs(float(row[1].replace("−", "-")) / found["preload"][name] - 1) < 1e-5 for row, name in zip(rows, ("approach", "load"))] == [True, True], rows
            assert "no compression" in rows[1][2] and found["preload"]["load"] < 0, rows
    reader.click("input[value=load_control]")
    assert any("at given load" in row[0] and "without bound" in row[1] for row in reader.rows("#numbers"))
    assert all(("at given approach" in row[0]) == row[0].startswith("jump") for row in reader.rows("#special"))


def an_early_end_asserts_no_pull_off(reader, _):
    reader.open("#tabor=8&amplitude=3&wavelength=6&radius=400&time-limit=0.3")
    assert "ended early" in reader.text("messages") and reader.text("summary").startswith("Pull-off not reached"), reader.text("summary")
    assert not any("±" in row[1] for row in reader.rows("#numbers")) and not reader.browser.evaluate("document.querySelectorAll('#load .pulloff').length")


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


def a_marker_of_the_report_opens_its_scene(reader, source):
    page = reader.report.resolve().as_uri()
    for name in ("fig03", "fig04"):
        reader.browser.open(page)
        count = reader.browser.evaluate(f"(async () => {{ const figure = document.getElementById('figure-{name}'); await unpackAll(figure.querySelectorAll('.packed')); return figure.querySelectorAll('a.scene').length; }})()")
        assert count > 20, (name, count)
        x, y, address = reader.browser.evaluate(
            f"(() => {{ const link = document.querySelectorAll('#figure-{name} a.scene')[{source.randrange(count)}]; link.scrollIntoView({{block: 'center', behavior: 'instant'}}); if (link.target.baseVal !== '_blank') return null; link.target.baseVal = '_self';"
            "const box = link.querySelector('circle').getBoundingClientRect(), x = box.x + box.width / 2, y = box.y + box.height / 2;"
            "return [x, y, document.elementFromPoint(x, y).closest('a').href.baseVal]; })()")
        for kind in ("mousePressed", "mouseReleased"):
            reader.browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)
        reader.wait("location.pathname.endsWith('live.html') && document.getElementById('digest')?.textContent", "the scene")
        tabor = re.search("tabor=([^&]+)", address)[1]
        assert f"tabor={tabor}" in reader.browser.evaluate("location.hash"), address
        assert not reader.text("messages") and reader.digest_of_command() == reader.text("digest")


def memory_is_bounded(reader, _, solves):
    reader.open("#tabor=1")
    memory = reader.browser.evaluate(
        "(async () => { const seen = []; for (let k = 0; k < %d; ++k) seen.push((await pulloff.ask({keys: {tabor: String(0.5 + k %% 7 / 4), "
        "amplitude: k %% 3 ? '0.3' : '0', wavelength: '20', want: 'curve,hysteresis'}})).memory); return seen; })()" % solves)
    assert len(memory) == solves and max(memory) == max(memory[:21]), (memory[20], max(memory))
    print(f"# {solves} solves: {memory[20] >> 20} MB after 21, {memory[-1] >> 20} MB at the end")


def a_figure_is_in_sight(reader, _):
    reader.open("#figure=fig03")
    head = "document.getElementById('figures-head').getBoundingClientRect()"
    reader.wait(f"{head}.top >= 0 && {head}.bottom <= innerHeight", "the figures", 2)
    assert reader.browser.evaluate("location.hash") == "#figure=fig03" and reader.digest_of_command() == reader.text("digest")
    reader.enter("tabor", "2")
    assert "tabor=2" in reader.browser.evaluate("location.hash")


def a_figure_is_recomputed(reader, _):
    with tempfile.TemporaryDirectory() as folder:
        recompute_twice(reader, folder)


def the_axes_of_the_paper_are_a_choice(reader, _):
    """Minus the approach to the right: the same curve, mirrored, whose points are still found; also through a spring."""
    for fragment in ("#tabor=3&amplitude=1&wavelength=20", "#tabor=3&stiffness=0.05"):
        reader.open(fragment)
        place = "[...document.querySelectorAll('#load .marker')].map((mark) => [Number(mark.getAttribute('cx')), Number(mark.getAttribute('cy'))])"
        width = reader.browser.evaluate("document.getElementById('load').clientWidth")
        before = reader.browser.evaluate(place)
        reader.click("#turned")
        after = reader.browser.evaluate(place)
        assert len(after) == len(before) > 3 and all(abs(a[0] + b[0] - (width + 58 - 12)) < 0.05 and a[1] == b[1] for a, b in zip(after, before)), (before, after)
        assert "minus the" in reader.browser.evaluate("document.querySelector('#load .name').textContent")
        reader.click("#turned")
        assert reader.browser.evaluate(place) == before


def body_and_surface_are_drawn(reader, _):
    """Both are symmetric, the apex of the body is at minus the approach, and the surfaces touch or are apart."""
    for fragment in ("#tabor=3&amplitude=1&wavelength=20", "#coupling=0.5&profile=punch&punch-b=8&punch-r=40", "#from-physical&modulus-pa=1e9&work-j-per-m2=0.05&distance-m=4e-10&radius-m=2e-8"):
        reader.open(fragment)
        drawn = reader.browser.evaluate("""(() => {
          const places = (id, kind) => [...document.querySelector(`#${id} .curve.${kind}`).getAttribute('d').matchAll(/[ML]([-\\d.]+) ([-\\d.]+)/g)].map((m) => [Number(m[1]), Number(m[2])]);
          const ticks = [...document.querySelectorAll('#bodies .frame text[text-anchor=end]')].map((tick) => [Number(tick.getAttribute('y')) - 4, Number(tick.textContent.replace('−', '-'))]);
          return {body: places('bodies', 'body'), surface: places('bodies', 'half-space'), ticks};
        })()""")
        body, surface = drawn["body"], drawn["surface"]
        assert len(body) == len(surface) > 40 and all(a[0] == b[0] for a, b in zip(body, surface))
        middle = (body[0][0] + body[-1][0]) / 2
        assert all(abs(a[0] + b[0] - 2 * middle) < 1 and abs(a[1] - b[1]) < 0.02 for a, b in zip(body, body[::-1])), "not symmetric"
        (low, at_low), (high, at_high) = drawn["ticks"][0], drawn["ticks"][-1]
        apex = at_low + (min(body, key=lambda place: abs(place[0] - middle))[1] - low) / (high - low) * (at_high - at_low)
        approach = float(re.search(r"at approach (\S+)", reader.text("state"))[1].replace("−", "-"))
        assert abs(apex + approach) < 0.01 * abs(at_high - at_low) + 0.02, (apex, approach)
        apart = [s[1] - b[1] for b, s in zip(body, surface) if abs(b[0] - middle) < 100]
        assert min(apart) > -12 and max(apart) > min(apart), apart


def every_address_opens_its_scene_again(reader, _):
    """The address of the scene of all usual values was empty, so that a reload opened the first scene of the page."""
    for fragment in ("", "#", "#tabor=1", "#tabor=1&amplitude=0", "#profile=cone", "#from-physical", "#tabor=2&stiffness=0.05", "#figure=fig03"):
        reader.open(fragment)
        before = reader.text("command"), reader.text("digest"), reader.browser.evaluate("location.hash")
        assert len(before[2]) > 1 and not reader.text("messages"), (fragment, before)
        reader.browser.call("Page.reload")
        reader.wait("document.getElementById('digest')?.textContent", "the scene")
        assert before == (reader.text("command"), reader.text("digest"), reader.browser.evaluate("location.hash")), (fragment, before)
    first = before[0]
    # parts that are missing or unknown are named
    for fragment, word in (("#tabor=", "no value of tabor"), ("#tabor=1&tabor=2", "more than once"), ("#tabr=2", "unknown option tabr"), ("#cone-t=1", "no effect"),
                           *((f"#figure={name}", "no scenes of the figure") for name in ("", "none", "fig99", "constructor", "__proto__", "%20", "a" * 99))):
        reader.open(fragment)
        assert word in reader.text("messages") and reader.text("digest"), (fragment, reader.text("messages"))
    # the way back leads to the scene before
    reader.open("#tabor=1")
    reader.browser.evaluate("document.querySelector('.examples a[href*=cone]').click(); new Promise((done) => setTimeout(done, 50))")
    reader.settle()
    assert "cone" in reader.text("command") != first
    reader.browser.evaluate("history.back(); new Promise((done) => setTimeout(done, 200))")
    reader.settle()
    assert "tabor=1" in reader.browser.evaluate("location.hash") and reader.digest_of_command() == reader.text("digest")


def what_is_shown_says_whose_it_is(reader, _):
    """While a scene was solved, and after its solve was stopped or failed, the numbers of another scene stood beside its fields."""
    whose = ("[document.body.classList.contains('stale'), document.getElementById('whose').hidden ? '' : document.getElementById('whose').textContent,"
             "document.getElementById('summary').hidden, getComputedStyle(document.getElementById('numbers-head'), '::after').content]")
    reader.open("#tabor=2")
    assert reader.browser.evaluate(whose) == [False, "", False, "none"]

    def is_of_another(found):
        return found[0] and found[1].endswith("those of another scene: pulloff solve --tabor 2") and found[2] and "another" in found[3]

    at_once = reader.browser.evaluate("(() => { const field = document.getElementById('field-tabor'); field.value = '2.5'; field.dispatchEvent(new Event('input'));"
                                      f"return {whose}; }})()")
    assert is_of_another(at_once), at_once
    reader.settle()
    assert reader.browser.evaluate(whose) == [False, "", False, "none"] and reader.digest_of_command() == reader.text("digest")
    reader.visit("#tabor=2")
    reader.enter("tabor", "-1")
    assert is_of_another(reader.browser.evaluate(whose)) and reader.text("messages")
    # with a spring, the unfinished curve is drawn against its base, and does not look stable
    reader.browser.evaluate("location.hash = '#tabor=20&amplitude=8&wavelength=10&radius=2000&tolerance=1e-9&stiffness=0.05'")
    reader.wait("document.querySelector('#load .unfinished') !== null", "progress")
    curve = "[document.getElementById('load').getAttribute('aria-label'), [...document.querySelectorAll('#load .curve')].map((path) => path.classList[1])]"
    label, kinds = reader.browser.evaluate(curve)
    assert "base of the spring" in label and kinds == ["unfinished"], (label, kinds)
    assert is_of_another(reader.browser.evaluate(whose)) and "as far as" in reader.browser.evaluate(whose)[1]
    reader.browser.evaluate("document.getElementById('stop').click()")
    reader.wait("document.getElementById('messages').textContent === 'The solve was stopped.'", "the message", 1)
    assert is_of_another(reader.browser.evaluate(whose))
    label, kinds = reader.browser.evaluate(curve)
    assert "base" not in label and "unfinished" not in kinds, (label, kinds)
    # a curve that ends early is drawn against the base of the spring, too
    reader.open("#tabor=8&amplitude=3&wavelength=6&radius=400&time-limit=0.3&stiffness=0.05")
    assert "ended early" in reader.text("messages") and "base of the spring" in reader.browser.evaluate(curve)[0]


def parts_are_those_of_the_scene(reader, _):
    """The staircase and the series of another scene stood beside a scene; the command of a series could be of a later scene."""
    reader.open("#tabor=2&amplitude=1&wavelength=15")
    reader.browser.evaluate("for (const id of ['stairs', 'series']) document.getElementById(id).open = true")
    reader.wait(f"{TEXT.format(repr('stairs-digest'))} !== ''", "the staircase")
    assert "at given approach" in reader.browser.evaluate("document.querySelector('#steps caption').textContent")
    reader.browser.evaluate("document.querySelector('#series [name=points]').value = '3'; document.querySelector('#series button').click()")
    reader.wait("document.querySelector('#series pre').textContent", "the series")
    found = "[document.getElementById('stairs-digest').textContent, document.querySelector('#steps').tBodies[0].rows.length, document.querySelector('#staircase').childElementCount, document.querySelector('#series pre').textContent]"
    reader.enter("tabor", "2.1")
    assert reader.browser.evaluate(found)[3], "a series over this parameter stays"
    at_once = reader.browser.evaluate("(() => { const field = document.getElementById('field-amplitude'); field.value = 'x'; field.dispatchEvent(new Event('input'));"
                                      f"return {found}; }})()")
    assert at_once == ["", 0, 0, ""], at_once
    reader.settle()
    reader.wait(f"/amplitude/.test({TEXT.format(repr('stairs-state'))})", "the refusal of the staircase")
    assert reader.browser.evaluate(found) == ["", 0, 0, ""]


def harder_preloads_are_said(reader, _):
    """What the line `harder` of the program says: that of the usual preload may be far below that of a harder one."""
    for fragment in ("#tabor=3&amplitude=1&wavelength=20", "#tabor=5&amplitude=3.5&wavelength=20&outer-radius=100", "#tabor=4&amplitude=3&wavelength=10&outer-radius=100",
                     "#tabor=1&stiffness=0.05", "#tabor=3&amplitude=1&wavelength=20&preload=1"):
        reader.open(fragment)
        reader.wait("!/being searched/.test(document.getElementById('harder').textContent)", "the search")
        words = reader.text("harder").replace("−", "-")
        command = re.sub(" --(want|stiffness) [^ ]+", "", reader.text("command"))
        printed = re.findall("^harder +(.*)$", reader.printed(command), flags=re.M)
        numbers = [float(text) for text in re.findall(r"-?\d+\.?\d*", printed[0])] if printed else []
        shown = [float(text) for text in re.findall(r"-?\d+\.?\d*", words)]
        assert len(shown) == len(numbers) and all(abs(a / b - 1) < 1e-5 for a, b in zip(shown, numbers)), (words, printed)
        for phrase, kept in (("greater pull-off force", "greater pull-off force"), ("gives the pull-off force", "gives the pull-off force"), ("not examined", "not examined")):
            assert (phrase in "".join(printed)) == (kept in words), (words, printed)


def recompute_twice(reader, folder):
    page = reader.page
    text = pathlib.Path(page.removeprefix("file://")).read_text(encoding="utf-8")
    kept = re.search('id="records">(.*?)</script>', text)[1]
    records = json.loads(gzip.decompress(base64.b64decode(kept)))
    for wrong in (0, 1):
        for name in records:
            count = len(records[name]["scenes"])
            reader.open(f"#figure={name}")
            reader.browser.evaluate("document.querySelector('#figures button').click()")
            reader.wait("document.querySelector('#figures button').textContent !== 'Stop'", name)
            words = reader.browser.evaluate("document.querySelector('#figures [role=status]').textContent")
            assert words == f"{count} of {count} solved, {count - wrong} identical to the last bit with the report", words
            drawn = reader.browser.evaluate("[...document.querySelectorAll('#figure-plot .curve')].map((path) => path.getAttribute('d').length)")
            curves = records[name]["want"] == "curve"
            assert len(drawn) == count if curves else 1 <= len(drawn) < count, (name, drawn)
            assert min(drawn) > (300 if curves else 20), (name, drawn)
        # once more, with another hash of the first scene of each figure
        for figure in records.values():
            figure["scenes"][0][1] = "0123456789abcdef"
        changed = pathlib.Path(folder) / "changed.html"
        changed.write_text(text.replace(kept, base64.b64encode(gzip.compress(json.dumps(records).encode())).decode()), encoding="utf-8")
        reader.page = changed.as_uri()
    reader.page = page


TESTS = [command_gives_the_digest, every_address_opens_its_scene_again, what_is_shown_says_whose_it_is, parts_are_those_of_the_scene,
         harder_preloads_are_said, staircase_has_the_digest, a_spring_has_its_loop, a_table_is_a_profile, theories_are_those_of_compare,
         a_series_is_followed, wrong_fields_give_a_message, fuzzed_fragments_are_survived, fuzzed_fields_are_survived,
         a_long_solve_is_stopped, a_figure_is_in_sight, units_follow_the_profile, a_preload_is_named_where_one_is_needed, an_early_end_asserts_no_pull_off, a_figure_is_recomputed, the_axes_of_the_paper_are_a_choice, body_and_surface_are_drawn, a_marker_of_the_report_opens_its_scene, a_point_is_dragged_along_the_curve, units_are_changed_to_and_fro, every_field_has_a_name, a_narrow_screen_does_not_scroll_sideways,
         memory_is_bounded]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--solves", type=int, default=60)
    parser.add_argument("--only", default="", help="only the tests with this text in their names")
    parser.add_argument("page", type=pathlib.Path)
    parser.add_argument("program")
    parser.add_argument("report", type=pathlib.Path)
    chosen = parser.parse_args()
    failed = False
    tests = [test for test in TESTS if chosen.only in test.__name__]
    print(f"1..{len(tests)}")
    with Browser() as browser:
        reader = Reader(browser, chosen.page, chosen.program, chosen.report)
        for number, test in enumerate(tests, 1):
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
