"""What the report cannot use is refused in one line that names it, with exit code 4 (2: usage)."""

import os
import sys
import tempfile
import unittest
from unittest import mock

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import quickly  # noqa: E402
import synthetic  # noqa: E402


class Refusals(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="pulloff-report-")
        self.addCleanup(holder.cleanup)
        self.folder = holder.name
        self.run_folder = os.path.join(self.folder, "run")
        self.output = os.path.join(self.folder, "report")
        self.record = os.path.join(self.run_folder, "fig03", "record.json")
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

    def change(self, edit):
        """The record with one edit."""
        synthetic.change(self.record, edit)

    def write(self, data):
        with open(self.record, "wb") as stream:
            stream.write(data)

    def test_broken_json(self):
        self.write(b'{"schema": "pulloff-record/1",\n "case": }\n')
        self.refused("fig03/record.json:2: not JSON", "column 10")

    def test_empty_record(self):
        self.write(b"")
        self.refused("fig03/record.json:1: not JSON")

    def test_binary_record(self):
        self.write(b"\x7fELF\xff\xfe")
        self.refused("fig03/record.json: not a text file")

    def test_other_schema(self):
        self.change(lambda record: record.update(schema="pulloff-record/9"))
        self.refused('schema is "pulloff-record/9", expected "pulloff-record/1"')

    def test_missing_key(self):
        self.change(lambda record: record["points"][2].pop("work"))
        self.refused("fig03/record.json: points[2].work is missing")

    def test_wrong_type(self):
        self.change(lambda record: record["checks"][1].update(obtained="many"))
        self.refused('checks[1].obtained is "many", expected a number or null')

    def test_a_truth_is_no_number_and_no_number_a_truth(self):
        self.change(lambda record: record["points"][0].update(failed=0))
        self.refused("points[0].failed is 0, expected true or false")
        self.change(lambda record: record["points"][0].update(failed=False))
        self.change(lambda record: record["checks"][0].update(error=True))
        self.refused("checks[0].error is true, expected a number or null")

    def test_unknown_verdict(self):
        self.change(lambda record: record["checks"][0].update(verdict="perhaps"))
        self.refused('checks[0].verdict is "perhaps", expected one of within, outside')

    def test_a_value_of_a_wrong_kind(self):
        """It ended in a traceback."""
        self.change(lambda record: record["points"][0]["pull_off"].update(force="much"))
        self.refused("run: a record, or a file beside it, has a value that cannot be shown: ", ".py:", "pulloff run writes a record again")

    def test_missing_curve(self):
        os.unlink(os.path.join(self.run_folder, "fig03", "curve-1.csv"))
        self.refused("fig03/curve-1.csv: No such file")

    def test_truncated_curve(self):
        path = os.path.join(self.run_folder, "fig03", "curve-1.csv")
        with open(path, "r+", encoding="utf-8") as stream:
            text = stream.read()
            stream.seek(0)
            stream.truncate()
            stream.write(text[:text.rindex(",", 0, 4000)])
        self.refused("fig03/curve-1.csv:", "expected 8")

    def test_curve_without_its_column(self):
        def rename(path):
            with open(path, encoding="utf-8") as stream:
                text = stream.read()
            with open(path, "w", encoding="utf-8") as stream:
                stream.write(text.replace("approach", "distance", 1))

        synthetic.change(os.path.join(self.run_folder, "fig03", "curve-0.csv"), rename)
        self.refused("fig03/curve-0.csv: no column named approach")

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

    def test_no_run(self):
        os.unlink(self.record)
        self.refused("no complete record of this program of any case")

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
