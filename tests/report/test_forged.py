"""A run folder of a stranger: no field of a record, a table, the claims or the planted faults brings markup into the report.

The fields of a document are forged with texts that would be an element, an attribute and an entity: each kind of position (a
path of keys), as many at once as the report accepts. It either refuses the document in one line or shows the texts as texts.
"""

import copy
import glob
import html.parser
import json
import os
import re
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree

import quickly
import synthetic
from make_report import refusing
from pulloff_report import claims, cost, errors, faults, page, records, references

# A macron at the beginning, which becomes a line over the letter before it; an element and an attribute; what gnuplot, matplotlib
# or a shell would read as a command, with a new line and a bell; and more characters than a line of gnuplot has.
TEXT = "\u0304\"'><forged forged=\"1\">& \u0304</script></style>\n\a$x_{\\{$ `date` {/:Bold " + "long " * 500
FORGED = "forged"


class Names(html.parser.HTMLParser):
    """The elements and attributes of a page, and its texts, those of attributes among them."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.names, self.texts = set(), []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.names |= {tag} | {f"{tag}.{name}" for name, _ in attrs}
        self.texts += [value for _, value in attrs if value]

    def handle_data(self, data):
        self.texts.append(data)


def kinds(document, path=()):
    """{kind: path} of the texts, numbers, truths and nulls of a document, one of each kind."""
    if not isinstance(document, (dict, list)):
        return {(): path}
    found = {}
    for key, value in document.items() if isinstance(document, dict) else enumerate(document):
        for kind, place in kinds(value, (*path, key)).items():
            found.setdefault((key if isinstance(document, dict) else "*", *kind), place)
    return found


def forged(document, places, value):
    """A copy of a document with a value at these places."""
    made = copy.deepcopy(document)
    for *path, last in places:
        inner = made
        for key in path:
            inner = inner[key]
        inner[last] = value
    return made


def read_json(path):
    with open(path, encoding="utf-8") as stream:
        return json.load(stream)


def write_json(path, document):
    if path.endswith("record.json"):
        synthetic.checksum.write(path, document)
        return
    with open(path, "w", encoding="utf-8") as stream:
        json.dump(document, stream)


def make_claims(folder):
    """A contradicted claim with two choices and a solver, and one that holds."""
    choice = {"words": "far, near", "own": "far", "preload": 0, "reading": "printed", "claimed": "1.5", "low": 1.5, "high": 1.5, "computed": 1.6, "difference": 0.1, "accuracy": 0.05,
              "decided": True, "commands": ["pulloff solve"], "reason": None, "verdict": "contradicted"}
    change = {"words": "no waves", "computed": 1.5, "verdict": "reproduced", "reason": None, "commands": [], "moved": True}
    claim = {"id": "made", "where": "Fig. 9", "quotes": ["It is so much."], "implied": True, "tests": "so much", "kind": None,
             "reading": "printed", "accuracy_because": "made", "brief": "It is more.", "weight": 1, "reply": "a reply", "note": "a note", "survives": "the rest",
             "reason": None, "figure": True, "decided": True, "faults": ["it cannot fail"], "choices": [choice, dict(choice)],
             "change": change, "solvers": [{"name": "newton", "verdict": "contradicted", "computed": 1.7}],
             "verdict": "contradicted"}
    holds = dict(claim, id="other", verdict="reproduced", choices=[dict(choice, verdict="reproduced")], faults=[], solvers=[])
    os.makedirs(os.path.join(folder, "claims"))
    write_json(os.path.join(folder, "claims", "claims.json"), {
        "schema": "pulloff-claims/5", "list_sha256": "0", "readings": {"printed": "half a unit"}, "claims": [claim, holds],
        "counts": {"contradicted": 1, "reproduced": 1}, "preloads": [{"figures": "9", "because": "made", "words": ["far", "near"]}],
        "robust": {"table": [{"scale": scale, "preload": place, "holds": 1, "depends": 0, "contradicted": 1}
                             for scale in ("half", "once", "twice") for place in (0, 1, 2, None)],
                   "holds_always": 1, "moved": 1, "statements": 2},
        "surveys": [{"id": "survey", "figure": "9", "words": "largest force for λ† = 9", "claimed": claimed, "tried": [
            {"words": "Δ† = 4", "approach": 4.0, "computed": 5.0, "holds": {"half": False, "once": True, "twice": True}}]} for claimed in (4, None)],
        "common": {"half": [], "once": [], "twice": ["Δ† = 4"], "tried": 1, "nearest": "Δ† = 4", "difference": 0.2, "numbers": [5.0]},
        "sentences": [{"where": "Abstract", "quote": "so much", "words": "It is 5.", "verdict": "in_part", "entries": ["made"],
                       "failing": [{"id": "made", "words": ["near"]}], "convention": []}]})


def make_few_meshes(run):
    """The timed solves of one scene, with which the figure is drawn soon."""
    def keep(made):
        made["points"] = [point for point in made["points"] if point["sweep"]["tabor"] == 1]
        kept = {point["id"] for point in made["points"]}
        made["measured"] = [item for item in made["measured"] if item["point"] in kept]
        made["checks"] = []

    synthetic.make_precision(run)
    synthetic.change(os.path.join(run, "precision", "record.json"), keep)


def of_run(maker):
    return lambda folder: maker(os.path.join(folder, "run"))


def beside(maker):
    """What lies beside a run of the paper, which is there, too."""
    return lambda folder: (of_run(synthetic.make_fig03)(folder), maker(folder))


# Who makes the files of a folder, and which of them are forged.
FAMILIES = {
    "loading curves": (of_run(synthetic.make_fig03_twice), "run/fig03/record.json"),
    "pull-off": (of_run(synthetic.make_fig04_twice), "run/fig04/record.json"),
    "map": (of_run(synthetic.make_map_at_any_preload), "run/fig14/record.json"),
    "general": (of_run(synthetic.make_general), "run/*/record.json"),
    "extreme": (of_run(synthetic.make_extreme), "run/*/record.json"),
    "precision": (of_run(make_few_meshes), "run/*/record.json"),
    "solvers": (of_run(synthetic.make_solvers), "run/solvers/second/*/record.json"),
    "faults": (beside(synthetic.make_faults), "mutation/matrix.json"),
    "cost": (beside(synthetic.make_cost), "cost/cost.json"),
    "claims": (beside(make_claims), "claims/claims.json"),
}


class Forged(unittest.TestCase):
    refused, drawings = set(), set()

    @classmethod
    def setUpClass(cls):
        quickly.prepare(cls)
        with tempfile.TemporaryDirectory(prefix="pulloff-report-") as cls.folder:
            synthetic.make_references(os.path.join(cls.folder, "reference"))
            for maker, _ in FAMILIES.values():
                maker(cls.folder)
            cls.known = set().union(*(Names(part).names for form in cls.forms() for part in cls.new_parts(form)))

    @classmethod
    def forms(cls):
        """The page for the screen, opened, and the source of the PDF; None if the report refuses the run, in one line."""
        run, tables = (os.path.join(cls.folder, name) for name in ("run", "reference"))
        try:
            with refusing(run):
                content = page.contents(records.Run(run), references.References(tables),
                                        *(module.read(module.beside(run)) for module in (faults, claims, cost)))
                return page.unpacked(page.screen(dict(content, live=["fig03"]))), page.paper(content)
        except errors.ReportError as error:
            assert "\n" not in str(error), error
            cls.by_reader = "cannot be shown" not in str(error)
            return None

    @classmethod
    def new_parts(cls, form):
        """A page with images in place of its drawings, and those of the drawings that no earlier page had."""
        text, pictures = page.with_pictures(form)
        drawings = {picture.decode() for picture in pictures.values()} - cls.drawings
        cls.drawings |= drawings
        return [text, *sorted(drawings)]

    def look(self, where):
        """Whether the report takes what was forged; it then has no other elements and attributes than those of HTML and SVG that
        a report of everything has."""
        forms = self.forms()
        for part in (part for form in forms or () for part in self.new_parts(form)):
            found = Names(part)
            self.assertEqual(found.names - self.known, set(), where)
            for text in found.texts:
                self.assertNotRegex(text, r"&(amp|lt|gt|quot|#\d+);|</?(sup|sub|code|span)\b", where)  # escaped twice, or too late
            for element in ElementTree.fromstring(part).iter() if part.startswith("<svg") else ():
                self.assertIn(element.tag.rsplit("}")[-1].lower(), self.known, where)
        self.shown += any(FORGED in form for form in forms or ())
        return forms is not None

    def check_documents(self, maker, pattern):
        """Forges the kinds of positions of each document: all at once, and of halves that are refused, their halves. A kind that the
        reader of these documents refuses is not tried in the next one."""
        synthetic.make_references(os.path.join(self.folder, "reference"))
        maker(self.folder)
        self.shown = 0
        for path in sorted(glob.glob(os.path.join(self.folder, pattern))):
            whole = read_json(path)
            stack = [[(kind, place) for kind, place in kinds(whole).items() if (whole["schema"], kind) not in self.refused]]
            while stack:
                chosen = stack.pop()
                places = [place for _, place in chosen]
                write_json(path, forged(whole, places, TEXT))
                taken = self.look((path, places[:5]))
                if not taken and len(chosen) > 1:
                    half = len(chosen) // 2
                    stack += [chosen[:half], chosen[half:]]
                elif not taken and self.by_reader:
                    self.refused.add((whole["schema"], chosen[0][0]))
            write_json(path, whole)
        self.assertGreater(self.shown, 0)

    def test_fields_of_documents(self):
        quickly.draw_no_times(self)
        for name, (maker, pattern) in FAMILIES.items():
            with self.subTest(name), tempfile.TemporaryDirectory(prefix="pulloff-report-") as Forged.folder:
                self.check_documents(maker, pattern)

    def test_names_of_folders(self):
        """The name of a solver is that of its folder, and stands in a drawing of matplotlib."""
        with tempfile.TemporaryDirectory(prefix="pulloff-report-") as Forged.folder:
            synthetic.make_references(os.path.join(self.folder, "reference"))
            of_run(synthetic.make_solvers)(self.folder)
            place = os.path.join(self.folder, "run", "solvers")
            os.rename(os.path.join(place, "quick"), os.path.join(place, TEXT[:60].replace("/", "")))
            self.shown = 0
            self.assertTrue(self.look("name of a solver"))
            self.assertEqual(self.shown, 1)

    def test_fields_of_tables(self):
        """Headers, names of columns and cells of the reference tables, and of the curve of a point."""
        flat = TEXT.replace("\n", " ")
        edits = (lambda text: re.sub("(?m)^# (\\w+): .*$", lambda found: f"# {found[1]}: {flat}", text), lambda text: f"# {flat}: {flat}\n{text}",
                 lambda text: text.replace("tabor", f'"{flat[:40]}"', 1),
                 lambda text: re.sub(r"(?m)^[\d.e+-]+,", lambda found: '"' + flat.replace('"', '""') + '",', text, count=1))
        with tempfile.TemporaryDirectory(prefix="pulloff-report-") as Forged.folder:
            synthetic.make_references(os.path.join(self.folder, "reference"))
            synthetic.make_fig03(os.path.join(self.folder, "run"))
            self.shown = 0
            for name in ("reference/feng_curves.csv", "reference/bradley.csv", "run/fig03/curve-0.csv"):
                path = os.path.join(self.folder, name)
                with open(path, encoding="utf-8", newline="") as stream:
                    whole = stream.read()
                for edit in (*edits, lambda text: text):
                    def write(place, text=edit(whole)):
                        with open(place, "w", encoding="utf-8", newline="") as stream:
                            stream.write(text)

                    (synthetic.change if name.startswith("run") else lambda place, how: how(place))(path, write)
                    self.look((name, edit))
            self.assertGreater(self.shown, 0)


if __name__ == "__main__":
    unittest.main()
