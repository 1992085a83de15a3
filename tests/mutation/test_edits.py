"""Tests of the random edits: what is edited and what is not, that the draw is fair and reproducible, and that the list
of judged edits can be read."""

import collections
import os
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
import draw
import edits
import plant
import tokens

STATUSES = ["PO_OK", "PO_LATE", "PO_LOST", "PO_FULL"]

PROGRAM = r"""#include "po_made.h"
#define TWICE(x) \
  (2 * (x))

/* A comment with 3 < 4 and a + b; // and "this" */
static const double LENGTHS[] = {0.5, 1e-9};

// if (a < b) return 1;
po_status po_made_up(po_made *m, size_t n, const char *name) {
  double sum = 0.0;
  for (size_t i = 0; i < n; ++i) {
    sum += m->value[i] * 2;
    if (sum > 7 && !m->late)
      return po_fail(PO_LATE, "sum %d < 8 \" of %s", (int)sum, name);
  }
  m->found = m->late ? sum : -sum;
  take(n, sum);
  return PO_OK;
}
"""


def found(text=PROGRAM):
    return tokens.edits_of("po_made.c", text, STATUSES)


def pairs(kind):
    return {(edit.line, edit.becomes) for edit in found() if edit.kind == kind}


class Edits(unittest.TestCase):
    def test_comments_directives_and_messages_are_not_edited(self):
        at = [PROGRAM[edit.start:edit.end] for edit in found()]
        for part in ("3 < 4", "TWICE", "if (a < b)", "sum %d < 8"):
            begin = PROGRAM.index(part)
            inside = [edit for edit in found() if edit.kind != "deletion" and edit.kind != "swap"
                      and begin <= edit.start < begin + len(part)]
            self.assertEqual(inside, [], part)
        self.assertIn("<", at)

    def test_loop_bounds_are_shifted_by_one(self):
        head = "for (size_t i = 0; i < n; ++i) {"
        self.assertEqual(pairs("bound"), {
            (head, "for (size_t i = 1; i < n; ++i) {"), (head, "for (size_t i = 0; i <= n; ++i) {"),
            (head, "for (size_t i = 0; i + 1 < n; ++i) {")})
        self.assertNotIn((head, "for (size_t i = 0; i > n; ++i) {"), pairs("comparison"))

    def test_each_kind_makes_its_edits(self):
        condition = "if (sum > 7 && !m->late)"
        self.assertEqual({becomes for line, becomes in pairs("comparison") if line == condition},
                         {"if (sum >= 7 && !m->late)", "if (sum < 7 && !m->late)"})
        self.assertEqual({becomes for line, becomes in pairs("logic") if line == condition},
                         {"if (sum > 7 || !m->late)", "if (sum > 7 && m->late)"})
        self.assertIn((condition, "if (!(sum > 7 && !m->late))"), pairs("condition"))
        self.assertIn(("m->found = m->late ? sum : -sum;", "m->found = !(m->late) ? sum : -sum;"), pairs("condition"))
        self.assertIn(("m->found = m->late ? sum : -sum;", "m->found = m->late ? sum : sum;"), pairs("arithmetic"))
        self.assertIn(("sum += m->value[i] * 2;", "sum += m->value[i] / 2;"), pairs("arithmetic"))
        self.assertIn(("sum += m->value[i] * 2;", "sum -= m->value[i] * 2;"), pairs("arithmetic"))
        self.assertIn(("sum += m->value[i] * 2;", "sum += m->value[i] * 3;"), pairs("constant"))
        self.assertIn(("static const double LENGTHS[] = {0.5, 1e-9};",
                       "static const double LENGTHS[] = {0.5, (2.0 * 1e-9)};"), pairs("constant"))
        self.assertEqual({becomes for line, becomes in pairs("status") if line == "return PO_OK;"},
                         {"return PO_LATE;", "return PO_LOST;"})
        self.assertIn(("take(n, sum);", "take(sum, n);"), pairs("swap"))
        self.assertIn(("take(n, sum);", ";"), pairs("deletion"))
        self.assertIn(("return PO_OK;", ";"), pairs("deletion"))

    def test_condition_before_a_question_mark_is_negated_as_a_whole(self):
        text = "int f(int a) {\n  g(1, h(a) ? 2 : 3);\n  return a < 1 && k[a] ? b : c;\n}\n"
        self.assertEqual({edit.becomes for edit in tokens.edits_of("f.c", text, STATUSES) if edit.kind == "condition"},
                         {"g(1, !(h(a)) ? 2 : 3);", "return !(a < 1 && k[a]) ? b : c;"})

    def test_each_edit_changes_the_text_and_has_a_unique_name(self):
        names = {edit.name for edit in found()}
        self.assertEqual(len(names), len(found()))
        for edit in found():
            self.assertNotEqual(edit.applied(PROGRAM), PROGRAM)
            self.assertIn(edit.function, ("", "po_made_up"))
        self.assertEqual({edit.function for edit in found() if "LENGTHS" in edit.line}, {""})

    def test_a_name_does_not_depend_on_other_code(self):
        moved = PROGRAM.replace("// if", "\n\nstatic int more(int x) {\n  return x + 1;\n}\n// if")
        self.assertLess({edit.name for edit in found()}, {edit.name for edit in found(moved)})

    def test_equal_lines_of_a_function_are_distinguished(self):
        twice = PROGRAM.replace("  take(n, sum);\n", "  take(n, sum);\n" * 2)
        swapped = [edit for edit in found(twice) if edit.becomes == "take(sum, n);"]
        self.assertEqual([edit.nth for edit in swapped], [1, 2])
        self.assertNotEqual(swapped[0].applied(twice), swapped[1].applied(twice))


class Draw(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.edits, cls.paths = draw.candidates(plant.SOURCE)

    def drawn(self, seed, count, edits=None):
        return draw.order(seed, edits or self.edits)[:count]

    def test_every_edit_has_a_name_and_every_kind_occurs(self):
        self.assertEqual({edit.kind for edit in self.edits}, set(tokens.KINDS))
        self.assertEqual(len({edit.name for edit in self.edits}), len(self.edits))
        sources = [name for _, _, names in os.walk(os.path.join(plant.SOURCE, "src")) for name in names if name.endswith(".c")]
        self.assertEqual(len(set(sources)), len(sources), "an edit is known by the name of its file")
        self.assertGreater(len({edit.file for edit in self.edits}), 0.9 * len(sources))

    def test_the_draw_depends_on_the_seed_only(self):
        self.assertEqual(self.drawn(1, 120), self.drawn(1, 120))
        self.assertLess(len(set(self.drawn(1, 120)) & set(self.drawn(2, 120))), 12)

    def test_all_kinds_and_parts_of_the_source_are_drawn(self):
        drawn = self.drawn(3, 300)
        kinds = collections.Counter(edit.kind for edit in drawn)
        self.assertGreaterEqual(min(kinds[kind] for kind in tokens.KINDS), 15)
        self.assertLess(max(collections.Counter(edit.file for edit in drawn).values()), 12)
        self.assertGreater(len({edit.file for edit in drawn}), 120)

    def test_a_change_of_some_files_keeps_most_of_the_draw(self):
        first = self.drawn(1, 120)
        gone = {edit.file for edit in first[:3]}
        still = set(self.drawn(1, 120, [edit for edit in self.edits if edit.file not in gone]))
        self.assertGreater(len(still & set(first)), 100)

    def test_the_list_of_the_project_fits_the_source(self):
        self.assertLessEqual(set(edits.read_judged(os.path.join(HERE, "equivalents.toml"))), {edits.key_of(edit) for edit in self.edits})


class Judged(unittest.TestCase):
    def read(self, text):
        with tempfile.NamedTemporaryFile("w", suffix=".toml") as stream:
            stream.write(text)
            stream.flush()
            return edits.read_judged(stream.name)

    def test_an_entry_has_a_reason_and_occurs_once(self):
        edit = found()[0]
        entry = edits.entry_of(edit)
        with self.assertRaisesRegex(plant.Stale, "without a reason"):
            self.read(entry)
        reasoned = entry.replace('because = ""', 'because = "nothing reads it"')
        self.assertEqual(self.read(reasoned), {edits.key_of(edit): "nothing reads it"})
        with self.assertRaisesRegex(plant.Stale, "twice"):
            self.read(reasoned + reasoned)
        with self.assertRaisesRegex(plant.Stale, "lines"):
            self.read(reasoned.replace("line =", "lines ="))


class Copy(unittest.TestCase):
    def test_a_copy_is_restored_and_contains_no_builds(self):
        with tempfile.TemporaryDirectory() as place:
            root, copy = os.path.join(place, "root"), os.path.join(place, "copy")
            for name in ("src/a.c", "build/b.o", "build-clang/c.o", "tests/build.c", ".git/d"):
                os.makedirs(os.path.dirname(os.path.join(root, name)), exist_ok=True)
                with open(os.path.join(root, name), "w", encoding="utf-8") as stream:
                    stream.write(name)
            os.mkdir(copy)
            edits.mirror(root, copy)
            self.assertEqual(sorted(edits.stamps_of(copy)), ["src/a.c", "tests/build.c"])
            digest, stamps = edits.digest_of(copy), edits.stamps_of(copy)
            edits.mirror(root, copy)
            self.assertEqual(edits.stamps_of(copy), stamps)
            with open(os.path.join(copy, "src/a.c"), "a", encoding="utf-8") as stream:
                stream.write("more")
            with open(os.path.join(copy, "src/new.c"), "w", encoding="utf-8"):
                pass
            self.assertNotEqual(edits.digest_of(copy), digest)
            edits.mirror(root, copy)
            self.assertEqual(edits.digest_of(copy), digest)


if __name__ == "__main__":
    unittest.main()
