"""The report as a whole, from made-up records: what stands in it, and that it stands by itself."""

import base64
import contextlib
import gzip
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from html import unescape

HERE = os.path.dirname(os.path.abspath(__file__))
REPORTS = os.path.join(HERE, "..", "..", "reports")
import quickly
import synthetic
from pulloff_report import errors, faults, page, plots, records, references, tree_tests

PRINTED = ("Figures of the paper", "Error against run time", "Cost of an equilibrium", "Extreme scenes", "Checks by case", "Environment")
SCREEN_ONLY = ("Planted faults", "Every check", "Every case and how to repeat it", "Reference data")


@contextlib.contextmanager
def made_up(maker):
    """A folder with reference/ and the run/ that maker makes."""
    with tempfile.TemporaryDirectory(prefix="pulloff-report-") as folder:
        synthetic.make_references(os.path.join(folder, "reference"))
        maker(os.path.join(folder, "run"))
        yield folder


def content_of(run, folder):
    return page.contents(records.Run(run), references.References(os.path.join(folder, "reference")),
                         faults.read(faults.beside(run)))


def page_of(folder):
    """The page as it is when everything in it is opened."""
    run = os.path.join(folder, "run")
    return page.unpacked(page.screen(content_of(run, folder)))


def plain(html):
    """The text a reader sees, white space reduced."""
    html = re.sub(r"<(style|script)\b.*?</\1>", " ", html, flags=re.S)
    return re.sub(r"\s+", " ", re.sub(r"<[^>]+>", "", html))


def cells_of_faults(html):
    """The letters of each fault in the matrix of planted faults, one a detector; "" for an empty cell, which may be several columns wide."""
    table = re.search(r'<table class="faults">(.*?)</table>', html, re.S).group(1)
    rows = []
    for row in re.findall(r"<tr.*?</tr>", re.search(r"<tbody>.*</tbody>", table, re.S).group(0), re.S):
        if 'class="group"' not in row:
            cells = re.findall(r'<td([^>]*)>([^<]*)</td>', row)  # the cell with the name of the fault has marks inside
            rows.append([letter for marks, letter in cells
                         for _ in range(int((re.search(r'colspan="(\d+)"', marks) or [0, 1])[1]))])
    return rows


class PageTest(unittest.TestCase):
    """Looks for words in a page and, when they are not as wanted, names them and not the page."""

    def has(self, text, *wanted):
        for words in wanted:
            self.assertTrue(words in text, f"not found: {words}")

    def lacks(self, text, *unwanted):
        for words in unwanted:
            self.assertFalse(words in text, f"found: {words}")


class Whole(PageTest):
    """One report of everything, written as a user would."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.mkdtemp(prefix="pulloff-report-")
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        synthetic.make_references(os.path.join(cls.folder, "reference"))
        synthetic.make_run(os.path.join(cls.folder, "run"))
        synthetic.make_faults(cls.folder)
        synthetic.make_cost(cls.folder)
        cls.output = os.path.join(cls.folder, "deep", "report")
        cls.first = cls.make()
        with open(os.path.join(cls.output, "report.html"), encoding="utf-8") as stream:
            cls.packed = stream.read()
        cls.html = page.unpacked(cls.packed)
        cls.text = plain(cls.html)

    @classmethod
    def make(cls, *more):
        return subprocess.run(
            [sys.executable, os.path.join(REPORTS, "make_report.py"),
             "--run", os.path.join(cls.folder, "run"), "--output", cls.output,
             "--reference", os.path.join(cls.folder, "reference"), *more],
            capture_output=True, text=True, check=False)

    def test_one_line_names_the_pages_and_nothing_else_is_left(self):
        self.assertEqual((self.first.returncode, self.first.stdout, self.first.stderr),
                         (0, f"made: {os.path.join(self.output, 'report.html')} and report.pdf\n", ""))
        self.assertEqual(sorted(os.listdir(self.output)),
                         [".report-key", "report.html", "report.pdf"])

    def test_an_unchanged_run_is_not_drawn_again(self):
        before = os.stat(os.path.join(self.output, "report.pdf")).st_mtime_ns
        again = self.make()
        self.assertEqual(again.returncode, 0)
        self.assertIn("kept", again.stdout)
        self.assertEqual(os.stat(os.path.join(self.output, "report.pdf")).st_mtime_ns, before)

    def test_the_same_run_gives_the_same_bytes(self):
        def written():
            found = []
            for name in ("report.html", "report.pdf"):
                with open(os.path.join(self.output, name), "rb") as stream:
                    found.append(stream.read())
            return found
        before = written()
        self.assertEqual(self.make("--fresh").returncode, 0)
        for name, first, second in zip(("report.html", "report.pdf"), before, written()):
            self.assertTrue(first == second, f"{name} differs")

    def test_sections_figures_and_verdict(self):
        self.has(self.text, *PRINTED, *SCREEN_ONLY, "All 64 checks against independent references pass", "Figure 3.",
                 "Figure 4.", "Observed orders", "not available in tabulated form",
                 "pulloff solve --tabor 2.5", "intact")
        drawn = {"fig03", "fig04"} | {name for name, module in plots.BY_SCRIPT.items()
                                      if getattr(module, "SCHEMATIC", False)}
        self.assertEqual(self.html.count('role="img"'), len(drawn) + 5)   # and three of the errors against time, two of costs
        self.has(self.text, "Not in this run", "the claims of the paper (./reproduce --only claims)",
                 "other laws and profiles (pulloff run --suite general)", "which theory holds where (./reproduce --only theories)", "Figure 7, rigid pull-off against α (fig07)",
                 "Figure A. Error against run time.", "Figure B. Error against run time, wavy spheres.")
        self.lacks(self.text, "External solvers", "Claims of the paper")

    def test_markers_link_to_the_page_with_the_solver_if_it_is_there(self):
        self.lacks(self.html, "live.html", 'class="scene"')
        beside = tempfile.mkdtemp(dir=self.folder)
        with open(os.path.join(beside, "live.html"), "w", encoding="utf-8") as stream:
            stream.write('<script id="records">' + base64.b64encode(gzip.compress(b'{"fig03": {}}')).decode() + "</script>")
        quickly.prepare(self)
        self.assertEqual(quickly.html_only(self, "--run", os.path.join(self.folder, "run"), "--output", beside,
                                           "--reference", os.path.join(self.folder, "reference")), (0, ""))
        with open(os.path.join(beside, "report.html"), encoding="utf-8") as stream:
            linked = page.unpacked(stream.read())
        run = records.Run(os.path.join(self.folder, "run"))
        for name, least in (("fig03", 20), ("fig04", 6)):
            scenes = {point["command"].removeprefix("pulloff solve ") for case in run.cases if case.name == name for point in case.points}
            drawing = re.search(f'<figure id="figure-{name}".*?</figure>', linked, re.S)[0]
            found = [re.sub(r"&?([\w-]+)=", r" --\1 ", unescape(address)).strip() for address in re.findall('href="live.html#([^"]+)" tabindex', drawing)]
            self.assertGreater(len(found), least)
            self.assertLessEqual(set(found), scenes)
            self.assertEqual("Recompute this figure" in drawing, name == "fig03")

    def test_what_is_large_is_packed(self):
        self.assertLess(len(self.packed), 0.6 * len(self.html))
        self.lacks(self.packed, "<svg", 'data-verdict="')
        self.has(self.packed, "Figure 3.", 'id="checks-fig03"')

    def test_every_check_has_its_row(self):
        self.assertEqual(len(re.findall(r'<tr data-verdict="within"', self.html)), 64)

    def test_orders_are_those_the_errors_were_made_with(self):
        self.has(self.text, "ring uniform 1.00 (63–1001, 5)", "triangle graded 2.00 (63–1001, 5)",
                 "triangle uniform 2.00 (251–1001, 3)")

    def test_what_is_not_solved_and_what_is_quicker_is_said(self):
        self.has(self.text, "2 combinations (N 2001): it would take all day",
                 "All 54 solves", "Of 27 solves, none found wrong folds and none failed.")
        # 501 triangles take 2e-7 501^2.3 s to 1.6e-4; panels at 1e-4 are quickest of those as good
        quotient = f"{2e-7 * 501 ** 2.3 / 0.016:.3g}"
        self.has(self.text, f"× {quotient}", f"{float(quotient):.2g} to {float(quotient):.2g} times as fast as this program’s own 500 triangles, at their error")

    def test_extreme_scenes_have_their_rows_and_a_summary(self):
        self.has(self.text, "6 of 6 scenes", "6 of 6 extreme scenes, which are hard to compute, are solved, with μ from 0.0001 to 40", "13.7", "2, 0.037", "≠ 2", "≠ 1")

    def test_it_refers_to_nothing_outside(self):
        for target in re.findall(r"""(?:src|href|action)\s*=\s*["']([^"']*)""", self.html):
            self.assertTrue(target.startswith("#") or target == "https://doi.org/10.3390/lubricants8090090", target)
        for target in re.findall(r"url\(([^)]{0,40})", self.html):
            self.assertTrue(target.startswith(("data:", "#")), target)
        self.lacks(self.html, "<link", "@import", "<iframe", "fetch(", "XMLHttpRequest",
                   "currentColor")

    def test_links_lead_somewhere_and_names_are_unique(self):
        names = re.findall(r'\sid="([^"]+)"', self.html)
        self.assertEqual(len(names), len(set(names)))
        for target in re.findall(r'href="#([^"]+)"', self.html):
            self.assertIn(target, names)

    def test_text_in_figures_has_seven_points_on_paper(self):
        with open(os.path.join(REPORTS, "templates", "print.css"), encoding="utf-8") as stream:
            style = stream.read()
        margin = float(re.search(r"@page \{ size: A4; margin: \S+ (\d+)mm", style)[1])
        widths = {selector.removesuffix(".picture").strip(): float(width) / 100 * (210 - 2 * margin) / 25.4 * 72
                  for selectors, width in re.findall(r"^([^\n{]*\.picture) \{ width: (\d+)%", style, re.M) for selector in selectors.split(", ")}
        front = self.html[:self.html.index("<section")]
        figures = re.findall(r'<figure id="([^"]*)"( class="tall")?>(.*?)</figure>', self.html, re.S)
        self.assertGreater(len(figures), 7)
        for name, tall, inside in figures:
            width = widths.get("#" + name, widths["figure.tall" if tall else ".front" if f'id="{name}"' in front else ""])
            for across, drawing in re.findall(r'<svg viewBox="\S+ \S+ ([\d.]+) .*?>(.*?)</svg>', inside, re.S):
                sizes = {float(size) for size in re.findall(r'<text[^>]* font-size="([\d.]+)"', drawing)}
                self.assertTrue(sizes, name)
                for size in sizes:   # an index has 0.8 of the size of its text
                    read = max(other for other in sizes if other == size or abs(size / other - 0.8) < 0.01)
                    self.assertGreaterEqual(read * width / float(across), 7.0, (name, size))
        # Figures that this run lacks: no script but those of `pulloff plot` sets another size.
        for script in sorted(os.listdir(os.path.join(REPORTS, "figures"))):
            with self.subTest(script=script), open(os.path.join(REPORTS, "figures", script), encoding="utf-8") as stream:
                self.assertEqual(bool(re.search(r"font (?!'Inter,11')", re.sub("#.*", "", stream.read()))), script in ("map.gp", "picture.gp"))

    def test_the_pdf_has_all_sections_and_pages(self):
        if not shutil.which("pdftotext"):
            self.skipTest("pdftotext is not installed")
        done = subprocess.run(["pdftotext", "-layout", os.path.join(self.output, "report.pdf"), "-"],
                              capture_output=True, text=True, check=True)
        pages = done.stdout.split("\f")[:-1]
        self.assertGreater(len(pages), 4)
        self.assertLess(len(pages), 41)
        for title in PRINTED:
            self.assertRegex(pages[0], re.escape(title) + r"[ .]+\d+\b")
            self.assertGreaterEqual(done.stdout.count(title), 2)
        for title in SCREEN_ONLY:
            self.assertNotIn(title, "".join(pages[:-1]))
            self.assertIn(title, pages[-1])
        self.has(pages[0], "All 64 checks against independent references", "The largest error is", "2026-01-02 10:00 UTC", "report.html")
        self.assertRegex(pages[0], rf"\b1 ?/ ?{len(pages)}\s")
        self.has(done.stdout, "triangle uniform 501", "Tabor parameter", "Observed orders",
                 "uncertainty of the")


class Parts(PageTest):
    """Pages of runs that lack something: what is absent is said, what is there is shown."""

    @classmethod
    def setUpClass(cls):
        quickly.prepare(cls)
        quickly.draw_no_times(cls)

    def test_a_missing_case_leaves_a_sentence(self):
        with made_up(synthetic.make_fig04) as folder:
            text = plain(page_of(folder))
        self.has(text, "Not drawn, because this run has no record of the case in brackets", "Figure 3, load against approach of a smooth sphere (fig03)",
                 "error against run time (pulloff run --suite precision)", "Figure 4.")

    def test_a_run_of_ones_own_cases_shows_nothing_of_the_paper(self):
        def own(run):
            synthetic.make_fig04(run)
            synthetic.change(os.path.join(run, "fig04", "record.json"), lambda record: record.update(
                figure=None, figure_script=None, title="My tip, pressed and pulled"))
        with made_up(own) as folder:
            text = plain(page_of(folder))
            synthetic.make_faults(folder)
            output = os.path.join(folder, "report")
            self.assertEqual(quickly.html_only(self, "--run", os.path.join(folder, "run"), "--output", output), (0, ""))
            with open(os.path.join(output, "report.html"), encoding="utf-8") as stream:
                written = plain(stream.read())
        for found in (text, written):
            self.assertTrue(found.strip().startswith("My tip, pressed and pulled"))
            self.has(found, "All 50 checks against independent references pass", "Checks by case")
            self.lacks(found, "Papangelo", "Feng’s points", "Figures", "Not in this run", "Planted faults", "Claims", "500 elements")

    def test_the_tests_of_the_tree_are_on_the_first_page(self):
        with made_up(synthetic.make_fig04) as folder:
            path = tree_tests.beside(os.path.join(folder, "run"))
            os.makedirs(os.path.dirname(path))
            with open(path, "w", encoding="utf-8") as stream:
                for name, result in (("a", "OK"), ("b / c", "FAIL"), ("d", "SKIP")):
                    stream.write(json.dumps({"name": "pulloff:" + name, "result": result, "starttime": 1767348000.0}) + "\n")
            run = os.path.join(folder, "run")
            content = page.contents(records.Run(run), references.References(os.path.join(folder, "reference")), tests=tree_tests.read(path))
            self.has(plain(page.screen(content)), "1 of 2 tests passed in the last run of meson here, 2026-01-02 10:00 UTC (not passed: b / c)")
            with open(path, "a", encoding="utf-8") as stream:
                stream.write("{}\n")
            with self.assertRaisesRegex(errors.ReportError, "not a log of meson"):
                tree_tests.read(path)

    def test_smooth_spheres_are_drawn_beside_the_discretisation_of_the_paper(self):
        with made_up(synthetic.make_fig03_twice) as folder:
            text = plain(page_of(folder))
        self.has(text, "at most 4.4 × 10−6 for μ = 0.01 and", "at most 3.2 × 10−4 for μ = 0.01 and",
                 " μ = 5, which this figure of the paper does not show", "and the branch has", "are spurious")
        with made_up(synthetic.make_fig04_twice) as folder:
            html = page_of(folder)
        self.has(plain(html), "at most 1.0 × 10−5 for the force (μ = 5)", "at most 1.0 × 10−3 for the force",
                 "(e) Number of folds of the branch; with the paper’s discretisation 12 at μ = 5 instead of 1",
                 "The others are spurious")
        self.has(html, "paper’s discretisation, cut at r = R</text>")

    def test_what_was_followed_stands_beside_what_was_traced(self):
        with made_up(synthetic.make_map) as folder:
            text = plain(page_of(folder))
        self.has(text, "Figure 14: 2 random scenes computed by parameter continuation and by a full trace",
                 "A full trace of the same scene by the same program", "2 scenes drawn at random were also traced", "Used by fig14",
                 "0.7 0.01000 2.19800000 2.19799997 3.0 × 10−8 0.03 ✓ within")
        with made_up(lambda run: synthetic.make_map(run, outside=True)) as folder:
            self.has(plain(page_of(folder)), "2.6 0.20000 2.54000000 2.53600000 4.0 × 10−3 4e+03 ✗ outside",
                     "1 of 2 repeated traces agree")

    def test_other_preloads_are_a_second_layer(self):
        with made_up(synthetic.make_map) as folder:
            text = plain(page_of(folder))
        self.has(text, "here all spheres are pressed to a load of 1 πwR", "no record of fig14_any")
        with made_up(synthetic.make_map_at_any_preload) as folder:
            text = plain(page_of(folder))
        self.has(text, "(b) The largest force at any preload, for 15 scenes: its maximum is 3.5 at μ = 5, A/λ = 0.2",
                 "may give a larger force (3 scenes)",
                 "(1) 1.4 from Δ† = −1; 3.5 from Δ† = 6; no harder preload gives more.")

    def test_other_laws_and_profiles_have_their_figures(self):
        with made_up(synthetic.make_general) as folder:
            html = page_of(folder)
            text = plain(html)
            self.has(text, "8 of 8 scenes were solved, and 1 of 1 check pass", "in (b), 1.50 (Mie (4, 10)), 1.50 (Maugis–Dugdale)",
                     "it differs from the Lennard-Jones law most at μ = 0.1, by 0.032", "mie (4, 10), μ = 0.1",
                     "At μ = 1, the surfaces jump into contact at Δ† = −1.62 to −1.62, and out of contact at −1.90 to −1.90.",
                     "The quotients at the right ends are 1.2500 (cone).", "(1) cone (0.3), A†/λ† = 1/12, w/(E*ε) = 0.5: 1.4 from Δ† = −1.")
            self.lacks(text, "no harder preload gives more")
            for name in plots.OF_GENERAL:
                self.assertEqual(html.count(f'id="figure-{name}"'), 1)
            os.unlink(os.path.join(folder, "reference", "jkr_pull_off.csv"))
            self.has(plain(page_of(folder)), "The JKR pull-offs (jkr_pull_off.csv) are not available")

    def test_external_solvers_are_beside_this_program(self):
        with made_up(synthetic.make_fig04) as folder:
            self.has(plain(page_of(folder)), "external solvers (./reproduce --only solvers)")
        with made_up(synthetic.make_solvers) as folder:
            html = page_of(folder)
        text = plain(html)
        self.assertEqual(html.count('id="figure-solvers"'), 1)
        self.has(text, "second, nodes 126 ∅ failed3 of 6 pass, 3 failed; points 6/6, checks 6/6",
                 "second, nodes 126 2.0 × 10−45 s × 100 1 × 10−5 ≥ × 71.4", "second, nodes 251 5.0 × 10−540 s × 800 1 × 10−5 ≥ × 571",
                 "second, nodes 251 timed out– no result no result", "quick 1.0 × 10−91 ms not reached by pulloff × 0.0143 1 × 10−7",
                 "quick on μ = 3, A† = 1, λ† = 20: no tolerance of this program reaches its error.", "at 1e-6 it is 70 times faster",
                 "2 of 12 solves gave no result")
        self.lacks(text, "were timed in rounds without this program", "This program is faster on every scene")
        self.has(text, "pulloff ✓ within6 of 6 pass; points 6/6, checks 6/6",
                 "quick and second, judged by the same cases. At the error of the other solver, in 2 comparisons, this program is "
                 "100 to 800 times as fast; 2 errors it does not reach (external solvers)")

    def test_the_record_of_some_points_is_shown_with_its_coverage(self):
        with made_up(synthetic.make_solvers) as folder:
            place = os.path.join(folder, "run", "solvers", "quick", "solver_times")
            with open(os.path.join(place, "record.json"), encoding="utf-8") as stream:
                record = json.load(stream)
            record["solver"]["coverage"].update(asked=3, made=3)
            for point in record["points"][3:]:
                point.update(status="unsupported", reason="not asked: the run was limited to other points", pull_off=None)
            record["checks"], record["measured"] = record["checks"][:3], record["measured"][:3]
            synthetic.checksum.write(os.path.join(place, "part.json"), record)
            os.unlink(os.path.join(place, "record.json"))
            text = plain(page_of(folder))
        self.has(text, "quick ✓ within3 of 3 pass; points 3/6, checks 3/6")

    def test_missing_references_leave_sentences(self):
        with made_up(synthetic.make_fig03) as folder:
            for name in ("feng_curves.csv", "bradley.csv"):
                os.unlink(os.path.join(folder, "reference", name))
            text = plain(page_of(folder))
        self.has(text, "The reference curves (feng_curves.csv) are not available")
        self.has(text, "Bradley’s solution (bradley.csv) is not available")
        self.has(text, "The reference data contain no file of this name")

    def test_published_points_are_absent_or_drawn(self):
        with made_up(synthetic.make_fig03_left_out) as folder:
            html = page_of(folder)
            self.has(plain(html), "published/feng_fig3.csv is not available: these published numbers",
                     "feng_curves.csv is used instead in fig03", "not available in tabulated form")
            self.lacks(plain(html), "Crosses: Feng’s own points")
            synthetic.make_published(os.path.join(folder, "reference"))
            text = plain(page_of(folder))
        self.has(text, "Crosses: Feng’s own points, read off his figure")
        self.has(text, "Feng’s points (the curves of his Figure 3) were read off a printed figure and are in reference/published/feng_fig3.csv")

    def test_planted_faults_are_a_matrix_or_a_sentence(self):
        with made_up(synthetic.make_fig03) as folder:
            self.has(plain(page_of(folder)), "planted faults (./reproduce --only faults)")
            synthetic.make_faults(folder)
            html = page_of(folder)
            self.has(plain(html), "3 of 3 planted faults were detected.", "only what is too large is outside",
                     "Faults in the harness", "N solves fail")
            self.lacks(plain(html), "only a pin changed", "not detected")
            for letter, kind in (("O", "caught"), ("T", "caught"), ("N", "caught"), ("·", "missed")):
                self.has(html, f'<td class="cell {kind}">{letter}</td>')
            self.assertEqual(cells_of_faults(html), [["O", "T", ""], ["N", "·", ""], ["", "", "T"]])
            self.has(html, '<td colspan="2"></td>')
            self.has(plain(html), "blank: not run with this fault")
            synthetic.make_faults(folder, missed=True)
            html = page_of(folder)
            self.has(plain(html), "3 of 4 planted faults were detected; not detected: jacobian.", "only a pin changed",
                     "po_equilibrium.c not detected")
            self.has(html, '<td class="cell seen">P</td>')

    def test_a_published_table_has_its_card(self):
        with made_up(synthetic.make_fig03_published) as folder:
            synthetic.make_published(os.path.join(folder, "reference"))
            html = page_of(folder)
        self.has(html, 'id="reference-published/feng_fig3.csv"', "digitised by nobody")
        self.lacks(plain(html), "is not available: these published numbers")

    def test_an_altered_reference_is_told(self):
        with made_up(synthetic.make_fig04) as folder:
            with open(os.path.join(folder, "reference", "feng_pull_off.csv"), "a",
                      encoding="utf-8") as stream:
                stream.write("6,1.5,-5,1e-9,1e-9\n")
            self.has(plain(page_of(folder)), "altered: the data do not have the stated checksum")

    def test_a_check_outside_is_the_headline(self):
        with made_up(lambda run: synthetic.make_fig04(run, outside=True)) as folder:
            html = page_of(folder)
        self.has(plain(html), "2 of 50 checks against independent references fail", "Failing:")
        self.has(html, 'class="status physics failing"')

    def test_slack_checks_are_notable(self):
        def maker(run):
            synthetic.make_fig04(run)
            synthetic.change(os.path.join(run, "fig04", "record.json"),
                             lambda record: [check.update(verdict="slack") for check in record["checks"][:2]])

        with made_up(maker) as folder:
            text = plain(page_of(folder))
        self.has(text, "All 50 checks against independent references pass", "50 (2 notable)",
                 "slack: within the tolerance, which is more than a thousand times")

    def test_a_failed_solve_is_told_with_its_reason(self):
        with made_up(lambda run: synthetic.make_run(run, failed=True)) as folder:
            html = page_of(folder)
        text = plain(html)
        self.has(text, "checks against independent references pass, none fails", "2 checks without a result and 2 failed solves")
        self.has(text, "tabor=2.5: the solve ended with step too small (the step fell below")
        self.has(text, "Of 27 solves, 7 found wrong folds and 1 failed.")
        self.lacks(html.lower(), ">nan<")

    def test_a_failure_within_the_share_that_may_fail_is_told_but_no_failure(self):
        def allowed(run):
            synthetic.make_run(run, failed=True)
            for name in ("fig04", "precision"):
                synthetic.change(os.path.join(run, name, "record.json"),
                                 lambda record: [point.update(failed=False) for point in record["points"]])
        with made_up(allowed) as folder:
            text = plain(page_of(folder))
        self.has(text, "2 checks without a result.", "tabor=2.5: the solve ended with step too small")
        self.lacks(text, "and 2 failed solves")


if __name__ == "__main__":
    unittest.main()
