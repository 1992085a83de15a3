"""The archive of ./reproduce --archive: its unpacked sources are those that it was made from."""

import contextlib
import io
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "reports"))

import archive  # noqa: E402
from pulloff_report import tree  # noqa: E402

FILES = {"src/solve.c": "int solve;\n", "reproduce": "#!/bin/sh\n", "cases/fig03.yaml": "name: fig03\n", "build.md": "not a folder\n"}
MADE = {"build/report/report.html": "<html>", "build/report/report.pdf": "%PDF", "build/run/fig03/record.json": "{}",
        "build/run/fig03/points.jsonl": "{}", "build/claims/claims.json": "{}", "build/claims/kept/ab.json": "{}"}


def put(folder, files):
    for name, text in files.items():
        path = os.path.join(folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as stream:
            stream.write(text)


@unittest.skipUnless(shutil.which("git"), "git is not installed")
class Archive(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory(prefix="pulloff-archive-")
        self.addCleanup(holder.cleanup)
        self.folder = os.path.join(holder.name, "work")
        put(self.folder, {**FILES, **MADE, ".gitignore": "build/\n"})
        os.chmod(os.path.join(self.folder, "reproduce"), 0o755)
        for words in (["init", "-q"], ["add", "."], ["-c", "user.name=a", "-c", "user.email=a@b", "commit", "-qm", "made"]):
            subprocess.run(["git", "-C", self.folder, *words], check=True)
        self.addCleanup(setattr, archive, "SOURCE", archive.SOURCE)
        archive.SOURCE = self.folder
        self.output = os.path.join(holder.name, "packed.tar.gz")

    def pack(self, status=0):
        with contextlib.redirect_stdout(io.StringIO()) as said, contextlib.redirect_stderr(said):
            self.assertEqual(archive.main([os.path.join(archive.SOURCE, "build"), self.output]), status, said.getvalue())
        return said.getvalue()

    def unpacked(self):
        place = tempfile.mkdtemp(dir=os.path.dirname(self.output))
        with tarfile.open(self.output) as packed:
            packed.extractall(place)
        (top,) = os.listdir(place)
        return os.path.join(place, top)

    def test_the_unpacked_sources_have_the_same_checksum(self):
        self.pack()
        there = self.unpacked()
        self.assertEqual(tree.identity(there)[:2], tree.identity(self.folder)[:2])
        self.assertTrue(os.access(os.path.join(there, "reproduce"), os.X_OK))
        put(there, {"build/src/cli/pulloff": "made later", "reports/__pycache__/a.pyc": "made later"})
        self.assertEqual(tree.files(there), sorted([*FILES, ".gitignore"]))
        put(there, {"src/solve.c": "int other;\n"})
        self.assertNotEqual(tree.identity(there)[1], tree.identity(self.folder)[1])

    def test_it_has_report_and_records_and_nothing_else_of_the_build(self):
        self.pack()
        there = os.path.join(self.unpacked(), tree.RESULTS)
        found = sorted(os.path.relpath(os.path.join(place, name), there) for place, _, names in os.walk(there) for name in names)
        self.assertEqual(found, ["claims/claims.json", "report/report.html", "report/report.pdf", "run/fig03/record.json"])

    def test_the_same_files_give_the_same_bytes_also_from_an_archive(self):
        self.pack()
        first, there = archive.tree.digest(self.output), self.unpacked()
        os.rename(os.path.join(there, tree.RESULTS), os.path.join(there, "build"))
        archive.SOURCE = there
        self.pack()
        self.assertEqual(archive.tree.digest(self.output), first)

    def test_changes_are_named(self):
        self.assertNotIn("changes", tree.words(tree.identity(self.folder)))
        put(self.folder, {"src/solve.c": "int changed;\n"})
        self.assertIn("with changes", tree.words(tree.identity(self.folder)))

    def test_what_is_missing_is_told(self):
        shutil.rmtree(os.path.join(self.folder, "build", "report"))
        self.assertIn("no report", self.pack(4))
        shutil.rmtree(os.path.join(self.folder, ".git"))
        self.assertIn("neither a working copy nor an archive", self.pack(4))
        self.assertEqual(tree.identity(self.folder), [])


if __name__ == "__main__":
    unittest.main()
