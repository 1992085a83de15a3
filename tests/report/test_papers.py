"""The recipe of doc/papers.md: the toy paper is judged from an empty folder, and its output is that of the page.

Usage: test_papers.py PROGRAM
"""

import json
import os
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest

import quickly
import synthetic

TREE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
RUN = os.path.join(TREE, "reports", "claims", "run.py")
PROGRAM = os.path.abspath(sys.argv.pop(1)) if len(sys.argv) > 1 and os.path.exists(sys.argv[1]) else None


def judge(*words):
    return subprocess.run([sys.executable, RUN, *words], capture_output=True, text=True, check=False)


def fits(value, schema):
    """Whether a value has the form of a JSON schema, of the keywords that the schema of the list uses."""
    if "anyOf" in schema:
        return any(fits(value, part) for part in schema["anyOf"])
    if "const" in schema or "enum" in schema:
        return value in schema.get("enum", [schema.get("const")])
    name = {str: "string", bool: "boolean", int: "integer", float: "number", list: "array", dict: "object"}[type(value)]
    if name not in ([schema["type"]] if isinstance(schema["type"], str) else schema["type"]):
        return False
    if name == "array":
        return len(value) >= schema.get("minItems", 0) and all(fits(item, schema["items"]) for item in value if "items" in schema)
    known, more = schema.get("properties", {}), schema.get("additionalProperties", True)
    return name != "object" or set(schema.get("required", ())) <= set(value) and all(
        fits(item, known[key]) if key in known else more is True or more is not False and fits(item, more) for key, item in value.items())


class Papers(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="pulloff-papers-")
        self.addCleanup(holder.cleanup)
        self.folder = os.path.join(holder.name, "toy")
        os.makedirs(self.folder)
        with open(os.path.join(TREE, "doc", "papers.md"), encoding="utf-8") as stream:
            self.shown = re.search(r"```text\n(.*?)```", stream.read(), re.S)[1]
        with open(os.path.join(TREE, "doc", "examples", "toy", "claims.toml"), encoding="utf-8") as stream:
            self.listed = stream.read()
        self.put(self.listed)

    def put(self, text):
        with open(os.path.join(self.folder, "claims.toml"), "w", encoding="utf-8") as stream:
            stream.write(text)

    @unittest.skipUnless(PROGRAM, "no program is given")
    def test_the_toy_paper_is_judged_as_the_page_says(self):
        done = judge("--paper", self.folder, "--program", PROGRAM)
        self.assertEqual((done.returncode, done.stdout), (0, self.shown), done.stderr)
        with open(os.path.join(self.folder, "claims", "claims.json"), encoding="utf-8") as stream:
            made = json.load(stream)
        self.assertEqual([row["verdict"] for row in made["claims"]], ["within_reading", "depends", "contradicted"])
        self.assertEqual([row["change"]["moved"] for row in made["claims"]], [True] * 3)
        self.assertIn("1.67, not 1.75", made["claims"][2]["brief"])

    @unittest.skipUnless(PROGRAM, "no program is given")
    def test_the_report_of_a_paper_says_nothing_of_the_first_one(self):
        judge("--paper", self.folder, "--program", PROGRAM)
        quickly.prepare(self)
        folder, run = os.path.dirname(self.folder), os.path.join(self.folder, "run")
        synthetic.make_references(os.path.join(folder, "reference"))
        synthetic.make_fig04(run)
        synthetic.change(os.path.join(run, "fig04", "record.json"), lambda record: record.update(figure=None, title="Spheres of the toy paper"))
        self.assertEqual(quickly.html_only(self, "--run", run, "--reference", os.path.join(folder, "reference"), "--output", folder,
                                           "--claims", os.path.join(self.folder, "claims", "claims.json")), (0, ""))
        with open(os.path.join(folder, "report.html"), encoding="utf-8") as stream:
            text = re.sub(r"\s+", " ", re.sub("<[^>]+>", "", stream.read()))
        for words in ("1 of 3 statements hold under every convention of readingRead by one convention, 1 statement holds; 1 depends",
                      "The ratio is 0.75.", "1 statement of the text is contradicted", "listed in claims.toml in the folder of the paper",
                      "Holds, depends, contradictedall choices half the accuracy1, 1, 1 the convention1, 1, 1"):
            self.assertTrue(words in text, f"not found: {words}")
        for words in ("Papangelo", "wavy_sphere", "figures were not", "light preload", "./reproduce --only"):
            self.assertFalse(words in text, f"found: {words}")

    @unittest.skipUnless(PROGRAM, "no program is given")
    def test_a_table_is_that_of_the_paper_first(self):
        os.makedirs(os.path.join(self.folder, "reference"))
        with open(os.path.join(self.folder, "reference", "mine.csv"), "w", encoding="utf-8") as stream:
            stream.write("tabor,force\n1,1.67\n")
        self.put('[[claim]]\nid = "mine"\nwhere = "Tab. 1"\nquote = "It is so much."\ntests = "the force"\nclaimed = "1.67"\nreading = "printed"\n'
                 'get.force = { table = "reference/mine.csv", when = { tabor = 1 }, column = "force" }\n'
                 'change = { words = "one more", value = "force + 1" }\n')
        done = judge("--paper", self.folder, "--program", PROGRAM, "--brief")
        self.assertEqual((done.returncode, done.stdout), (0, "1 claims: 1 reproduced\n"), done.stderr)

    def test_the_schema_describes_the_lists(self):
        schema = json.loads(judge("--schema").stdout)
        with open(os.path.join(TREE, "reports", "papers", "wavy_sphere", "claims.toml"), "rb") as stream:
            first = tomllib.load(stream)
        toy = tomllib.loads(self.listed)
        self.assertTrue(fits(first, schema) and fits(toy, schema))
        for change in ({"colour": "red"}, {"reading": "guessed"}, {"claimed": None}, {"get": {"force": {"pulloff": 1}}}, {"choice": [{"words": "one"}]}):
            entry = {key: value for key, value in {**toy["claim"][0], **change}.items() if value is not None}
            self.assertEqual(fits({**toy, "claim": [entry]}, schema), change == {"claimed": None}, change)

    def test_what_is_wrong_with_a_folder_is_said(self):
        self.put(self.listed.replace("reading = \"large\"", "reading = \"huge\""))
        done = judge("--paper", self.folder, "--program", PROGRAM or __file__)
        self.assertEqual(done.returncode, 2)
        self.assertIn("claim crest: reading: expected one of", done.stderr)
        done = judge("--paper", os.path.join(self.folder, "none"))
        self.assertEqual((done.returncode, "claims.toml" in done.stderr), (4, True))


if __name__ == "__main__":
    unittest.main()
