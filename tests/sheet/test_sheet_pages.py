"""The printed adhesion sheet: every problem, every certified digit, name and checksum are on its pages, and formulas are set."""

import html
import json
import pathlib
import re
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SHEET = ROOT / "reference" / "sheet"
sys.path.insert(0, str(ROOT / "reports"))

import make_sheet  # noqa: E402  pylint: disable=wrong-import-position

MOST_PAGES = 4


@pytest.fixture(scope="module", name="printed")
def made(tmp_path_factory):
    """The text of the page, and the PDF."""
    folder = tmp_path_factory.mktemp("sheet")
    done = subprocess.run([sys.executable, ROOT / "reports" / "make_sheet.py", "--output", folder], capture_output=True, text=True,
                          check=False)
    assert done.returncode == 0, done.stderr
    return (folder / "adhesion-sheet-1.html").read_text(), folder / "adhesion-sheet-1.pdf"


def plain(page):
    """The text of a page without its tags; powers of ten as in the table."""
    page = re.sub(r"·10<sup>(−?\d+)</sup>", r"e\1", page)
    return html.unescape(re.sub(r"<[^>]*>", "", page)).replace("−", "-")


def test_every_value_is_printed(printed):
    score = make_sheet.read_score(SHEET)
    rows, checksum = score.read_values(SHEET)
    text = plain(printed[0])
    assert checksum in text and text.count(checksum[:16]) == 2
    for (problem, quantity), row in rows.items():
        shown = make_sheet.rounded(row)
        number = re.sub(r"·10<sup>(−?\d+)</sup>", r"e\1", shown).replace("−", "-")
        assert f"{quantity}{number}" in text.replace("\n", ""), (problem, quantity)
        error = abs(float(number) - float(row["value"]))
        assert error <= 0.51 * 10.0 ** (-int(row["digits"])) * 10 * abs(float(row["value"]))
        assert len(re.sub(r"e.*|\D", "", number).lstrip("0")) == int(row["digits"])


def test_every_statement_can_be_put_together(printed):
    """The letters of a statement and its own sentences are the whole statement, in order."""
    sheet = json.loads((SHEET / "problems.json").read_text())
    for _, shared, problems in make_sheet.groups(sheet):
        meaning = dict(shared)
        for problem, pieces in problems:
            whole = " ".join(" ".join(meaning[letter] for letter in letters) if letters else own for letters, own in pieces)
            assert whole == problem["statement"]
            assert problem["id"] in plain(printed[0])


@pytest.mark.parametrize("text, shown", [
    ("sqrt(2 pi w a/E*)", "√(2 π w a/E<sup>*</sup>)"), ("int_0^inf p r dr", "∫<sub>0</sub><sup>∞</sup> p r dr"),
    ("mu^(3/2)", "μ<sup>3/2</sup>"), ("(1 + H)^-3", "(1 + H)<sup>−3</sup>"), ("D = -1.5", "D = −1.5"), ("traction-separation", "traction-separation"),
    ("4e-4", "4·10<sup>−4</sup>"), ("r^3.5", "r<sup>3.5</sup>"), ("a < r", "a &lt; r"), ("a_0", "a<sub>0</sub>"),
    ("(n/m)^(1/(n - m))", "(n/m)<sup>1/(n − m)</sup>"), ("A_1, R_t", "A<sub>1</sub>, R<sub>t</sub>")])
def test_formulas(text, shown):
    assert make_sheet.mathematics(text) == shown


def test_a_pdf_of_a_few_pages(printed):
    data = printed[1].read_bytes()
    assert data.startswith(b"%PDF")
    pages = subprocess.run(["pdfinfo", printed[1]], capture_output=True, text=True, check=True).stdout
    assert int(re.search(r"Pages:\s+(\d+)", pages)[1]) <= MOST_PAGES


def test_an_altered_sheet_is_not_printed(tmp_path):
    for name in ("problems.json", "values.csv", "score.py"):
        (tmp_path / name).write_bytes((SHEET / name).read_bytes())
    table = tmp_path / "values.csv"
    table.write_text(table.read_text().replace(",10,", ",11,", 1))
    done = subprocess.run([sys.executable, ROOT / "reports" / "make_sheet.py", "--sheet", tmp_path, "--output", tmp_path],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 1 and "checksum" in done.stderr
