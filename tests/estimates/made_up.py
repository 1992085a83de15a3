"""Tests of campaigns with a synthetic program in place of pulloff."""

import contextlib
import io
import os
import stat
import tempfile
import unittest


class Case(unittest.TestCase):
    """A synthetic program, given as text, in a temporary folder."""

    PROGRAM = None

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()  # pylint: disable=consider-using-with
        self.addCleanup(self.folder.cleanup)
        self.program = os.path.join(self.folder.name, "pulloff")
        with open(self.program, "w", encoding="utf-8") as stream:
            stream.write(self.PROGRAM)
        os.chmod(self.program, stat.S_IRWXU)

    def run_campaign(self, main, *words):
        """Returns the exit code and the printed text."""
        text = io.StringIO()
        with contextlib.redirect_stdout(text):
            code = main(["--program", self.program, "--journal", os.path.join(self.folder.name, "journal"), "--quiet",
                         *words])
        return code, text.getvalue()
