"""The parts of the report by themselves: numbers, tables, distances between curves, SVG."""

import math
import os
import re
import subprocess
import sys
import tempfile
import types
import unittest
import unittest.mock

import numpy

HERE = os.path.dirname(os.path.abspath(__file__))
for folder in ("reports", "tools"):
    sys.path.insert(0, os.path.join(HERE, "..", "..", folder))

import count_tests  # noqa: E402

from pulloff_report import findings, fonts, geometry, gnuplot, identity, live, page, samples, svg, words  # noqa: E402
from pulloff_report.errors import ReportError  # noqa: E402
from pulloff_report.plots import laws, loading, preload, staircase, theories  # noqa: E402
from pulloff_report.plots.figure import Figure  # noqa: E402
from pulloff_report.tables import Table  # noqa: E402


def sample(seconds, error, scheme="panel", nodes=None, outcome="measured", floor=1e-10):
    """A solve whose force, and folds, are off by so much."""
    mesh = {"scheme": scheme, "grading": "uniform", "nodes": nodes, "tolerance": 1e-6}
    point = {"label": "made", "status": "ok", "sweep": {"tabor": 2.385, **mesh}, "work": {},
             "processor_seconds_all": [9 * seconds, seconds, 0.5 * seconds]}
    item = {"reference_uncertainty": floor, "outcome": outcome, "note": ""}
    return samples.Sample(point, [
        dict(item, quantity="pull_off_force", outcome="measured", error=-error),
        dict(item, quantity="fold_count", error=0.0 if outcome == "measured" else 2.0)]
        + [dict(item, quantity="fold_approach", error=part * error) for part in (1, -2)
           if outcome == "measured"])


class Samples(unittest.TestCase):
    def test_a_sample_has_the_median_time_and_the_greatest_error(self):
        one = sample(0.3, 1e-5)
        self.assertEqual((one.seconds, one.errors["force"], one.errors["folds"]), (0.3, 1e-5, 2e-5))
        wrong = sample(0.3, 1e-5, outcome="no_correspondence")
        self.assertTrue(wrong.misfit)
        self.assertNotIn("folds", wrong.errors)
        self.assertFalse(wrong.reaches("force", 1))

    def test_the_order_is_fitted_to_what_is_resolved_and_above_the_floor(self):
        meshes = [sample(1, 7.0 * n ** -2.0, "ring", n) for n in (50, 100, 200, 400)]
        meshes[0] = sample(1, 0.5, "ring", 50, outcome="no_correspondence")
        found = samples.order(meshes, "force")
        self.assertAlmostEqual(found[0], 2.0, places=12)
        self.assertEqual(found[1:], (100, 400, 3))
        # the finest lies on the floor: nothing is resolved above it
        meshes[3] = sample(1, 2e-10, "ring", 400)
        self.assertIsNone(samples.order(meshes, "force"))

    def test_no_order_is_read_off_two_meshes_or_errors_that_do_not_decrease_with_one_order(self):
        def meshes(*errors):
            return [sample(1, error, "ring", 50 * 2 ** place) for place, error in enumerate(errors)]
        self.assertIsNone(samples.order(meshes(1.0, 0.25), "force"))
        self.assertIsNone(samples.order(meshes(1.0, 2.0 ** -5, 2.0 ** -3), "force"))
        # the coarsest mesh does not belong to the range where the order is 2
        self.assertEqual(samples.order(meshes(0.3, 0.25, 2.0 ** -4, 2.0 ** -6), "force")[1:], (100, 400, 3))

    def test_the_quickest_of_those_as_good(self):
        panels = [sample(0.02, 1e-6), sample(0.05, 1e-9), sample(0.09, 1e-10)]
        goal = sample(3.0, 1e-8, "triangle", 501)
        self.assertIs(samples.quickest(panels, ["force", "folds"], goal), panels[1])
        self.assertIs(samples.marked([panels[0], goal]), goal)
        self.assertIsNone(samples.quickest(panels[:1], ["force"], goal))


class Words(unittest.TestCase):
    def test_decimals_show_two_digits_of_the_tolerance(self):
        self.assertEqual([words.decimals_for(t) for t in (2.385e-5, 1e-4, 0.3, 7.0, None, 0)],
                         [6, 5, 2, 1, None, None])

    def test_fixed(self):
        self.assertEqual(words.fixed(1.6706712, 5), "1.67067")
        self.assertEqual(words.fixed(-0.8734, 3), "\u22120.873")
        self.assertEqual(words.fixed(None, 3), "–")

    def test_scientific_is_markup_with_a_true_minus(self):
        self.assertEqual(words.scientific(-2.3851e-7, 3),
                         "\u22122.39\u202f×\u202f10<sup>\u22127</sup>")
        self.assertEqual(words.scientific(0.02385), "0.024")
        self.assertEqual(words.scientific(0), "0")

    def test_seconds(self):
        self.assertEqual([words.seconds(s) for s in (0.00275, 0.412, 21.2, 130.4)],
                         ["2.75 ms", "0.412 s", "21.2 s", "2 min 10 s"])

    def test_label_of_a_point(self):
        point = {"sweep": {"scheme": "ring", "nodes": 63, "tabor": 2.385}, "label": "-"}
        self.assertEqual(words.sweep_label(point), "ring, N = 63, μ = 2.385")

    def test_a_label_has_only_the_parameters_that_the_solve_uses(self):
        sweep = {"tabor": 1, "amplitude": 0, "wavelength": 0, "outer_radius": "inf", "scheme": "panel", "grading": "uniform", "nodes": 501,
                 "tolerance": 1e-6}
        self.assertEqual(words.sweep_label({"sweep": sweep, "label": ""}), "μ = 1, r†max = ∞, panel, tolerance = 1e−06")
        self.assertEqual(words.sweep_label({"sweep": dict(sweep, scheme="ring", amplitude=1, wavelength=20), "label": ""}),
                         "μ = 1, A† = 1, λ† = 20, r†max = ∞, ring, uniform, N = 501")
        self.assertEqual(words.sweep_label({"sweep": {"amplitude": 0}, "label": ""}), "A† = 0")

    def test_laws_and_profiles_have_their_parameters(self):
        point = {"sweep": {"law": "mie:4,10", "profile": "power:0.05,1.5", "waves": None, "tabor": 0.1, "coupling": 0.05}, "label": "-",
                 "input": {"law": "mie", "mie_m": 4.0, "mie_n": 10.0, "morse_a": None, "profile": "power", "power_c": 0.05,
                           "power_n": 1.5, "cone_t": None}}
        self.assertEqual(words.sweep_label(point), "mie (4, 10), power (0.05, 1.5), w/(E*ε) = 0.05")
        point = {"sweep": {"profile_file": "/a/b/tip.csv", "profile": "table"}, "label": "-",
                 "input": {"profile": "table", "profile_file": "/a/b/tip.csv", "table_scale": 1.0}}
        self.assertEqual(words.sweep_label(point), "tip.csv")


class Tables(unittest.TestCase):
    def table(self, text):
        with tempfile.NamedTemporaryFile("w", suffix=".csv", delete=False) as stream:
            stream.write(text)
        self.addCleanup(os.unlink, stream.name)
        return Table(stream.name)

    def test_header_columns_and_empty_cell(self):
        table = self.table("# what: a: b\n# kind: oracle\nx,y\n1,2.385\n3,\n")
        self.assertEqual(table.header, {"what": "a: b", "kind": "oracle"})
        self.assertEqual(table.numbers("y")[0], 2.385)
        self.assertTrue(math.isnan(table.numbers("y")[1]))

    def test_what_spreadsheets_write_is_read(self):
        table = self.table('\ufeff# what: one\n"x", "a, b" \n "1" , 2.385\n  \n\n')
        self.assertEqual((table.header, list(table.columns)), ({"what": "one"}, ["x", "a, b"]))
        self.assertEqual((table.rows, table.numbers("x")[0], table.numbers("a, b")[0]), (1, 1, 2.385))

    def test_digest_is_of_all_but_its_own_line(self):
        seal = "# sha256: " + self.table("# what: one\nx\n1\n").digest() + "\n"
        for text, state in (("# what: one\n" + seal + "x\n1\n", "verified"),
                            ("# what: two\n" + seal + "x\n1\n", "differs"),
                            ("# what: one\n" + seal + "x\n2\n", "differs")):
            self.assertEqual(self.table(text).digest_state(), state)
        self.assertEqual(self.table("x\n2\n").digest_state(), "absent")

    def test_refusals_name_the_line(self):
        for text, wanted in (("x,y\n1\n", ":2: 1 cells, expected 2"), ("# a: b\n", ":2: no row")):
            with self.assertRaisesRegex(ReportError, wanted):
                self.table(text)
        with self.assertRaisesRegex(ReportError, "no column named z"):
            self.table("x\n1\n").numbers("z")
        with self.assertRaisesRegex(ReportError, "x is 'one'"):
            self.table("x\none\n").numbers("x")


class Distances(unittest.TestCase):
    def test_points_beside_a_circle(self):
        # A curve that turns back in x, as a branch does at a fold.
        angle = numpy.linspace(0.2, 6.0, 60)
        at = numpy.array([0.9, 2.385, 4.1])
        off = numpy.array([0.01, -0.02, 1e-4])
        found = geometry.distances(numpy.cos(angle), numpy.sin(angle), angle,
                                   (1 + off) * numpy.cos(at), (1 + off) * numpy.sin(at))
        numpy.testing.assert_allclose(found, abs(off), atol=2e-6)

    def test_points_beyond_the_ends_have_none(self):
        line = numpy.linspace(0, 1, 11)
        found = geometry.distances(line, 0 * line, line, numpy.array([-0.3, 0.5, 1.2]),
                                   numpy.array([0.1, 0.25, 0.1]))
        self.assertTrue(math.isnan(found[0]) and math.isnan(found[2]))
        self.assertAlmostEqual(found[1], 0.25)


GNUPLOT_LIKE = """<?xml version="1.0"?>
<svg width="100" height="50" viewBox="0 0 100 50" xmlns="http://www.w3.org/2000/svg"
 xmlns:xlink="http://www.w3.org/1999/xlink"><defs>
<rect id='gpPt3' stroke='currentColor' x='-1' y='-1' width='2' height='2'/>
<use xlink:href='#gpPt3' id='gpPt11' stroke='currentColor' transform='rotate(45)'/></defs>
<clipPath id="cut"><rect width="9" height="9"/></clipPath>
<g color="red" stroke="currentColor" clip-path="url(#cut)">
<use xlink:href='#gpPt11' transform='translate(5,6)' color='rgb(0,114,178)'/></g>
<g transform="translate(50,20)" stroke="none" fill="black" font-size="10" text-anchor="middle">
<text><tspan>|</tspan><tspan font-style="italic">W\u0304</tspan><tspan>| load</tspan></text></g></svg>"""


def step(force, begin, until, is_open=False):
    """A step of a staircase between two loads."""
    return {"force": force, "preload": {"approach": begin, "load": begin}, "until": {"approach": until, "load": until},
            "open": is_open}


class Preloads(unittest.TestCase):
    STEPS = [step(0.5, None, 1.0), step(2.0, 3.0, 4.0), step(1.5, 4.0, 5.0, is_open=True)]

    def test_a_preload_in_words(self):
        self.assertEqual(preload.words(4.0, None), "pressed to Δ† = 4")
        self.assertEqual(preload.words(None, 3.0), "pressed to a load of 3 πwR")
        self.assertEqual(preload.words(4.0, 3.0), "pressed to Δ† = 4 or to a load of 3 πwR, whichever comes first")
        self.assertEqual(preload.words(None, None), "pressed to a load of 1 πwR")

    def test_a_staircase_as_a_line(self):
        rows = staircase.stairs({"steps": self.STEPS}, "load", 8.0, True)
        # from contact, straight from where one step ends to where the next begins, and on to the end of the axis
        self.assertEqual(rows, [(0.0, 0.5), (1.0, 0.5), (3.0, 2.0), (4.0, 2.0), (4.0, 1.5), (8.0, 1.5)])
        self.assertEqual(staircase.stairs({"steps": self.STEPS}, "load", 3.5, True)[-1], (3.5, 2.0))
        self.assertEqual(staircase.stairs({"steps": []}, "load", 8.0, True), [])
        # beyond the last preload that was reached nothing is drawn, if a harder one may give more
        self.assertEqual(staircase.stairs({"steps": self.STEPS}, "load", 8.0, False)[-1], (5.0, 1.5))

    def test_tick_marks_are_at_round_distances(self):
        self.assertEqual([staircase.tick_step(*ends) for ends in ((0, 4.9), (-1, 0.2), (0, 700))], [1.0, 0.5, 200.0])

    def test_the_next_jump_of_a_curve_that_is_loaded(self):
        approaches = [0.0, -1.0, 2.0, 4.3, 3.0, 4.1, 1.0, 7.5, 6.0]
        self.assertEqual([loading.next_jump(approaches, preload) for preload in (1.0, 4.2, 4.3, 7.5)],
                         [4.3, 4.3, 7.5, None])


class Svg(unittest.TestCase):
    def setUp(self):
        self.text = svg.embeddable(GNUPLOT_LIKE, "f9", "a test & more")

    def test_nothing_is_left_to_resolve(self):
        for word in ("currentColor", "<use", "xlink", "text-anchor", "tspan", "gpPt"):
            self.assertNotIn(word, self.text)
        self.assertIn('stroke="rgb(0,114,178)"', self.text)
        self.assertIn('aria-label="a test &amp; more"', self.text)

    def test_identifiers_belong_to_the_figure(self):
        self.assertIn("url(#f9-cut)", self.text)
        self.assertEqual(re.findall(r'\bid="([^"]+)"', self.text), ["f9-cut"])

    def test_spans_follow_each_other(self):
        places = [(float(x), text) for x, text in
                  re.findall(r'<text x="([-\d.]+)"[^>]*>([^<]+)</text>', self.text)]
        self.assertEqual([text for _, text in places], ["|", "W", "| load"])
        face, slanted = fonts.face(), fonts.face("Inter", "italic")
        self.assertAlmostEqual(places[1][0] - places[0][0], face.width("|", 10), delta=0.02)
        self.assertAlmostEqual(places[2][0] - places[1][0], slanted.width("W", 10), delta=0.02)

    def test_the_bar_over_a_letter_is_drawn(self):
        self.assertNotIn("\u0304", self.text)
        self.assertEqual(self.text.count("<path"), 1)


class Links(unittest.TestCase):
    """Links from a drawing to the page with the solver, drawn by gnuplot on logarithmic axes."""
    MARKER = r'translate\(([\d.]+),([\d.]+)\) scale'
    POINTS = [{"label": f"tabor={tabor} & more", "command": f"pulloff solve --tabor {tabor} --amplitude {amplitude} --wavelength 20"}
              for tabor in (0.1, 1, 10) for amplitude in (0.02, 0.2, 2.0)]

    def drawn(self, links, rows):
        with tempfile.TemporaryDirectory() as folder:
            script = os.path.join(folder, "one")
            with open(script + ".gp", "w", encoding="utf-8") as stream:
                stream.write("set logscale xy\nset xrange [0.1:10]; set yrange [0.02:2]\nplot 'rows.dat' using 1:2 with points notitle, "
                             "'links.dat' index 0 @link\nunset output\n")
            return svg.embeddable(gnuplot.draw(script, {}, {"rows": [rows], "links": links.blocks}), "one", "a test", links)

    def test_each_marker_is_a_link_to_its_scene(self):
        links, rows = live.Links(), []
        for point in self.POINTS:
            scene = live.options(point["command"])
            rows.append((float(scene["tabor"]), float(scene["amplitude"])))
            links.add(0, rows[-1:], point)
        text = self.drawn(links, rows)
        found = re.findall(r'<a class="scene" href="live.html#([^"]*)" tabindex="-1" target="_blank"><title>([^<]*)</title><circle cx="([\d.]+)" cy="([\d.]+)"', text)
        self.assertEqual([(address, title) for address, title, *_ in found], [
            (f"tabor={tabor}&amp;amplitude={amplitude}&amp;wavelength=20", f"Solve in the browser: tabor={tabor} &amp; more")
            for tabor in (0.1, 1, 10) for amplitude in (0.02, 0.2, 2.0)])
        markers = re.findall(self.MARKER, text)
        self.assertEqual([place[2:] for place in found], markers)
        plain = svg.without_links(text)
        self.assertEqual((plain.count("<a"), plain.count('role="img"'), len(re.findall(self.MARKER, plain))), (0, 1, len(markers)))

    def test_a_map_is_one_link_that_has_its_corners_and_the_values_of_its_scenes(self):
        cells = live.Cells(self.POINTS)
        cells.blocks = [[(0.1, 0.02, 0), (10, 2.0, 1)]]
        text = self.drawn(cells, [(0.1, 0.02), (10, 2.0)])
        (left, bottom), (right, top) = [[float(value) for value in place] for place in re.findall(self.MARKER, text)]
        x, y, width, height = (float(value) for value in re.search(r'</title><rect x="(.*?)" y="(.*?)" width="(.*?)" height="(.*?)"', text).groups())
        for found, wanted in ((x, left), (y, top), (x + width, right), (y + height, bottom)):
            self.assertAlmostEqual(found, wanted, delta=0.02)
        self.assertIn('data-tabor="0.1 1 10" data-amplitude="0.02 0.2 2.0"', text)


class Laws(unittest.TestCase):
    def test_the_name_of_a_law_that_is_spelled_with_its_parameters(self):
        point = {"sweep": {"law": "mie:4,10", "tabor": 1.0}, "input": {"law": "mie", "mie_m": 4.0, "mie_n": 10.0, "morse_a": None}}
        self.assertEqual(laws.law_name(point), "Mie (4, 10)")


class Gnuplot(unittest.TestCase):
    def test_values_as_gnuplot_writes_them(self):
        self.assertEqual(gnuplot.assignment("a", gnuplot.Enhanced("{/:Italic z} = 5 %")), "a = '{/:Italic z} = 5 %'")
        self.assertEqual(gnuplot.assignment("b", [1.5, 2]), "array b[2] = [1.5, 2]")
        self.assertEqual(gnuplot.assignment("c", []), "array c[1]")

    def test_gnuplot_reads_every_text_as_it_was(self):
        """An apostrophe after a backslash ended the string; a word behind @ was replaced, as a macro."""
        texts = ["it's", "a\\'b\\\\''0", "@x a @print", "`id` $y", '"q"1', "{/:Bold b}_^~ %d #z", "two\nlines", "µm"]
        script = "x = 'macro'\n" + gnuplot.assignment("text", [gnuplot.Enhanced(text) for text in texts]) + f"\ndo for [k = 1:{len(texts)}] {{ print text[k].'|' }}\n"
        done = subprocess.run([gnuplot.require()], input=script, stderr=subprocess.PIPE, text=True, check=True,
                              env=dict(os.environ, LC_ALL="C.UTF-8"))
        self.assertEqual(done.stderr, "".join(text + "|\n" for text in texts))


class Paper(unittest.TestCase):
    """The paper edition, which omits the long lists."""

    def test_a_link_to_an_omitted_part_is_plain_text(self):
        here, gone = '<a href="#point-x-0">one</a>', '<a href="#point-x-1">two</a>'
        part = '<p id="point-x-0"></p>'
        self.assertEqual(page.without_dead_links(here + gone + part), here + "two" + part)

    def test_a_figure_as_tall_as_it_is_wide_has_a_page_for_itself(self):
        def made(*heights):
            return Figure("x", "1", "made up", "".join(f'<svg viewBox="0 0 680 {height}"/>' for height in heights), "")
        self.assertEqual([made(*heights).is_tall for heights in ((480,), (640,), (400,), (400, 400))],
                         [False, True, False, True])

    def test_small_errors_on_the_first_page_have_an_exponent(self):
        worst = {"ratio": 1e-4, "quantity": "force", "kind": "relative ", "point": "a < b", "case": types.SimpleNamespace(name="made")}
        with unittest.mock.patch.multiple(findings, worst_check=lambda run: worst, worst_estimate=lambda run: {"count": 3, "ratio": 2e-5}):
            text = str(findings.physics(types.SimpleNamespace(checks=list, cases=[]))["text"])
        self.assertIn("10<sup>\u22124</sup> of its relative tolerance (force, a &lt; b, case made). Where", text)
        self.assertIn("10<sup>\u22125</sup> of the stated one.", text)

    def test_a_link_to_a_scene_asks_for_nothing_beside(self):
        self.assertEqual(live.fragment("pulloff solve --tabor 1 --law mie:3,9 --want curve,hysteresis"), "#tabor=1&law=mie:3,9")

    def test_a_version_without_its_build_options(self):
        self.assertEqual([findings.short_version("GSL", text) for text in ("gcc 12.2.0", "2.7.1", "OpenBLAS 0.3.21 NO_LAPACKE", "git")],
                         ["gcc 12.2.0", "GSL 2.7.1", "OpenBLAS 0.3.21", "git"])


class Identity(unittest.TestCase):
    """Stored digests of two points; what the record of the run has for them."""

    def found(self, points, stored, scenes="s"):
        table = types.SimpleNamespace(columns=dict(zip(("point", "digest", "pull_off_force"), zip(*stored))),
                                      header={"scenes": "s"}) if stored else None
        case = types.SimpleNamespace(name="made", record={"scenes": scenes}, points=[
            {"id": name, "label": name, "sweep": {"tabor": int(name)}, "digest": digest,
             "pull_off": None if force is None else {"force": force}} for name, digest, force in points])
        return identity.compare(types.SimpleNamespace(cases=[case]),
                                types.SimpleNamespace(table=lambda name: table if name == "pins/made.csv" else None))

    def test_all_are_identical(self):
        found = self.found([("0", "a", 1.5), ("1", "b", None)], [("0", "a", "1.5"), ("1", "b", "-")])
        self.assertEqual((found["compared"], found["identical"], found["largest"]), (2, 2, None))

    def test_the_largest_difference_is_named(self):
        found = self.found([("0", "a", 1.5), ("1", "x", 2.0), ("2", "y", 2.0)],
                           [("0", "a", "1.5"), ("1", "b", "2.0000001"), ("2", "c", "2")])
        self.assertEqual((found["compared"], found["identical"], found["different"]), (3, 1, 2))
        self.assertAlmostEqual(found["largest"][0], 5e-8)
        self.assertEqual(found["largest"][1], "made")

    def test_a_force_that_is_lost_differs_beyond_measure(self):
        found = self.found([("0", "x", None)], [("0", "a", "1.5")])
        self.assertEqual(found["largest"][0], math.inf)

    def test_other_scenes_are_not_compared(self):
        """The results of a case whose sweep had changed were compared with the stored ones by the numbers of the points."""
        self.assertIsNone(self.found([("0", "a", 1.5)], [("0", "a", "1.5")], scenes="t"))
        self.assertIsNone(self.found([("0", "a", 1.5)], [("0", "a", "1.5")], scenes=None))

    def test_without_stored_digests_nothing_is_said(self):
        self.assertIsNone(self.found([("0", "a", 1.5)], []))


class Counting(unittest.TestCase):
    """Of the tests a CI run made."""

    def test_a_tap_test_counts_line_by_line(self):
        tap = "TAP version 13\n1..4\nok 1 - a\nnot ok 2 - b\nok 3 - c # SKIP no d\nok 4 - e\n"
        self.assertEqual(count_tests.count({"result": "FAIL", "stdout": tap}), (2, 1))

    def test_a_tap_test_that_dies_is_a_failure(self):
        self.assertEqual(count_tests.count({"result": "ERROR", "stdout": "1..2\nok 1\n"}), (1, 1))
        self.assertEqual(count_tests.count({"result": "TIMEOUT"}), (0, 1))

    def test_others_count_once(self):
        results = ("OK", "EXPECTEDFAIL", "SKIP", "FAIL", "UNEXPECTEDPASS")
        self.assertEqual([count_tests.count({"result": result}) for result in results],
                         [(1, 0), (1, 0), (0, 0), (0, 1), (0, 1)])



class Theories(unittest.TestCase):
    """Ranges, classes and the rule of the section on theories, for made-up deviations."""

    def test_ranges(self):
        rows = [(0.01, 0.02), (0.1, 0.08), (1.0, 0.08), (10.0, 0.02), (100.0, 0.08)]
        self.assertEqual(theories.ranges(rows, 0.05), "μ ≤ 0.032, 3.2 ≤ μ ≤ 32")
        self.assertEqual([theories.ranges(rows, level) for level in (0.01, 0.2)], ["no μ", "all μ"])
        self.assertEqual(theories.ranges(rows[1:4], 0.05), "μ ≥ 3.2")

    @staticmethod
    def scene(tabor, amplitude, **deviations):
        rows = [{"theory": name.replace("_", "-"), "deviation": value} for name, value in deviations.items()]
        return {"input": {"tabor": tabor, "amplitude": amplitude}, "theories": rows}

    def test_classes(self):
        self.assertEqual(theories.class_of(self.scene(1, 1, rigid=0.3, maugis=-0.04)), 2 * 3 + 1)
        self.assertEqual(theories.class_of(self.scene(1, 1, rigid=-0.005, maugis=-0.04, jkr=None)), 0)
        self.assertEqual(theories.class_of(self.scene(1, 1, rigid=0.3, maugis=-0.21)), 12)

    def test_the_rule_counts_its_misses(self):
        points = [self.scene(0.1, 1, rigid=0.01), self.scene(0.1, 1, rigid=0.06), self.scene(1, 1, rigid=0.01),
                  self.scene(1, 0.05, pietrement_troyon=-0.04), self.scene(3, 1, guduru=0.5), self.scene(1, 1, guduru=0.5)]
        self.assertEqual(theories.misses(points), {"scenes": 6, "named": 4, "wrong": 2, "silent": 1})


if __name__ == "__main__":
    unittest.main()
