"""What the report cannot use is refused in one line that names it, with exit code 4 (2: usage)."""

import os
import tempfile
import unittest
from unittest import mock

import quickly
import synthetic


RECORD = "fig03/record.json"


def written(data):
    """The record has these bytes."""
    def edit(run):
        with open(os.path.join(run, RECORD), "wb") as stream:
            stream.write(data)
    return edit


def changed(edit, name=RECORD):
    """The record, or a file beside it, with one edit."""
    return lambda run: synthetic.change(os.path.join(run, name), edit)


def cut(run):
    """A curve that ends within a row."""
    path = os.path.join(run, "fig03", "curve-1.csv")
    with open(path, "r+", encoding="utf-8") as stream:
        text = stream.read()
        stream.truncate(text.rindex(",", 0, 4000))


def rename(path):
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text.replace("approach", "distance", 1))


WRONG = (
    (written(b'{"schema": "pulloff-record/1",\n "case": }\n'), "fig03/record.json:2: not JSON", "column 10"),
    (written(b""), "fig03/record.json:1: not JSON"),
    (written(b"\x7fELF\xff\xfe"), "fig03/record.json: not a text file"),
    (changed(lambda record: record.update(schema="pulloff-record/9")), 'schema is "pulloff-record/9", expected "pulloff-record/1"'),
    (changed(lambda record: record["points"][2].pop("work")), "fig03/record.json: points[2].work is missing"),
    (changed(lambda record: record["checks"][1].update(obtained="many")), 'checks[1].obtained is "many", expected a number or null'),
    # a truth is no number, and a number no truth
    (changed(lambda record: record["points"][0].update(failed=0)), "points[0].failed is 0, expected true or false"),
    (changed(lambda record: record["checks"][0].update(error=True)), "checks[0].error is true, expected a number or null"),
    (changed(lambda record: record["checks"][0].update(verdict="perhaps")),
     'checks[0].verdict is "perhaps", expected one of within, outside'),
    # it ended in a traceback
    (changed(lambda record: record["points"][0]["pull_off"].update(force="much")),
     "run: a record, or a file beside it, has a value that cannot be shown: ", ".py:", "pulloff run writes a record again"),
    (lambda run: os.unlink(os.path.join(run, "fig03", "curve-1.csv")), "fig03/curve-1.csv: No such file"),
    (cut, "fig03/curve-1.csv:", "expected 8"),
    (changed(rename, "fig03/curve-0.csv"), "fig03/curve-0.csv: no column named approach"),
    (lambda run: os.unlink(os.path.join(run, RECORD)), "no complete record of this program of any case"),
)


class Refusals(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="pulloff-report-")
        self.addCleanup(holder.cleanup)
        self.folder = holder.name
        self.run_folder = os.path.join(self.folder, "run")
        self.output = os.path.join(self.folder, "report")
        synthetic.make_references(os.path.join(self.folder, "reference"))
        synthetic.make_fig03(self.run_folder)

    def refused(self, *wanted, code=4, path=None, words=None):
        """Runs the report; it must fail with one line that holds all the wanted words."""
        words = words or ["--run", self.run_folder, "--output", self.output,
                          "--reference", os.path.join(self.folder, "reference")]
        with mock.patch.dict(os.environ, {"PATH": os.environ["PATH"] if path is None else path}):
            ended, printed, said = quickly.main(words)
        self.assertEqual((ended, printed), (code, ""), said)
        for word in wanted:
            self.assertIn(word, said)
        if code == 4:
            self.assertEqual(said.count("\n"), 1, said)
            self.assertTrue(said.startswith("pulloff report: "))
        if os.path.isdir(self.output):
            self.assertEqual(os.listdir(self.output), [])

    def test_a_file_that_is_wrong(self):
        """Each edit of the run, and the words of the line that refuses it."""
        for edit, *wanted in WRONG:
            with self.subTest(wanted[0]):
                synthetic.make_fig03(self.run_folder)
                edit(self.run_folder)
                self.refused(*wanted)

    def test_an_altered_record_or_table_is_refused(self):
        for name, said in (("record.json", "it does not have its checksum (pulloff run fig03 writes it again)"),
                           ("curve-1.csv", "it does not have the checksum that its record states")):
            path = os.path.join(self.run_folder, "fig03", name)
            with open(path, encoding="utf-8", newline="") as stream:
                text = stream.read()
            place = max(text.rfind(digit) for digit in "123456789")
            with open(path, "w", encoding="utf-8", newline="") as stream:
                stream.write(text[:place] + str(int(text[place]) % 9 + 1) + text[place + 1:])
            self.refused(f"fig03/{name} was altered: {said}")
            with open(path, "w", encoding="utf-8", newline="") as stream:
                stream.write(text)

    def test_a_matrix_of_faults_that_is_none(self):
        synthetic.make_faults(self.folder)
        path = os.path.join(self.folder, "mutation", "matrix.json")
        with open(path, encoding="utf-8") as stream:
            text = stream.read()
        for edited, words in ((text[:-30], "not JSON"), (text.replace("faults/1", "faults/2"), "schema is"),
                              (text.replace('"by": []', '"by": 0'), "faults[1].cells.tables_math.by is 0"),
                              (text.replace('"what"', '"why"'), "faults[0].what is missing")):
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(edited)
            self.refused("matrix.json", words)

    def test_no_such_folder(self):
        self.refused("No such file or directory", words=[
            "--run", os.path.join(self.folder, "absent"), "--output", self.output])

    def test_absent_gnuplot(self):
        self.refused("gnuplot is not on the PATH", path=self.folder)

    def test_output_is_a_file(self):
        blocked = os.path.join(self.folder, "blocked")
        with open(blocked, "w", encoding="utf-8"):
            pass
        self.refused(blocked, words=["--run", self.run_folder, "--output", blocked, "--reference",
                                     os.path.join(self.folder, "reference")])

    def test_usage(self):
        self.refused("--output", code=2, words=["--run", self.run_folder])


if __name__ == "__main__":
    unittest.main()
