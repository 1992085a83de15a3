#!/usr/bin/python3
"""The test of the recipes notices what is wrong with a recipe."""

import pathlib
import unittest

import recipes


class Edits(unittest.TestCase):
    TEXT = "one\ntwo\nthree\ntwo and a half\n"

    def test_lines_are_replaced_and_added(self):
        self.assertEqual(recipes.edited(self.TEXT, "-two\n+2\n three\n@@\n one\n+1.5\n", "a file"),
                         "one\n1.5\n2\nthree\ntwo and a half\n")

    def test_lines_that_are_not_there(self):
        for edits in ("-four\n+4\n", "-tw\n+2\n", "+2\n", " two\n", "*two\n+2\n", "-two\n-two and a half\n+2\n"):
            with self.assertRaises(recipes.Wrong):
                recipes.edited(self.TEXT, edits, "a file")

    def test_lines_that_are_there_twice(self):
        with self.assertRaises(recipes.Wrong):
            recipes.edited("one\none\n", "-one\n+1\n", "a file")


class Recipes(unittest.TestCase):
    def test_blocks(self):
        text = "```c new=a/a.c\nint a;\n```\n\n```diff file=b.c\n+1\n```\n\n```console\n$ pulloff\n...\n```\n"
        blocks = recipes.blocks_of(text)
        self.assertEqual(blocks, [("c", {"new": "a/a.c"}, "int a;\n"), ("diff", {"file": "b.c"}, "+1\n"), ("console", {}, "$ pulloff\n...\n")])
        self.assertEqual(recipes.touched(blocks), ["a", "b.c"])

    def test_the_page_names_every_file(self):
        """The section of doc/extending.md that links to a recipe names what the recipe touches, and all are linked to."""
        self.assertEqual(sorted(path.stem for path in recipes.HERE.glob("*.recipe")), sorted(recipes.NAMES))
        sections = (recipes.ROOT / "doc/extending.md").read_text(encoding="utf-8").split("\n## ")
        for name in recipes.NAMES:
            section, = [text for text in sections if f"(../tests/recipes/{name}.recipe)" in text]
            touched = [path for path in recipes.touched(recipes.read(name)) if path != "my"]
            self.assertEqual([path for path in touched if (pathlib.Path(path).name if "." in path else path) not in section], [], name)

    def test_a_new_file_that_exists(self):
        with self.assertRaises(recipes.Wrong):
            recipes.carried_out([("c", {"new": "meson.build"}, "")], {})

    def test_a_command_with_other_output(self):
        class Copy:
            @staticmethod
            def command(line):
                if line == "fails":
                    raise recipes.Wrong("fails")
                return ["1 of 2"]
        blocks = [("console", {}, "$ pulloff\n1 of 2\n$ pulloff\n2 of 2\n$ fails\n...\n")]
        self.assertEqual(len(list(recipes.failures(Copy, blocks))), 2)


if __name__ == "__main__":
    unittest.main()
