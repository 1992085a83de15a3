#!/usr/bin/python3
"""The test of the recipes notices what is wrong with a recipe."""

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
    def test_sections_and_blocks(self):
        text = "# Page\n\n## One\n\n```c new=a.c\nint a;\n```\n\n## Two\n\nNo block.\n\n## Three\n\n```console\n$ pulloff\n...\n```\n"
        self.assertEqual(list(recipes.recipes_of(text)),
                         [("One", [("c", {"new": "a.c"}, "int a;\n")]), ("Three", [("console", {}, "$ pulloff\n...\n")])])

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
