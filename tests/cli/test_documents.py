"""Every command in the documents runs, the output shown there is that of the present program (documents.py describes the comparison), and
the example of a case file is a valid case. Links lead to files and to headings of pages, and the files and functions that the documents
name exist."""

import pathlib
import re
import subprocess
import sys

import conftest
from conftest import ROOT, expect

HERE = pathlib.Path(__file__).resolve().parent
FOLDERS = ("doc", "src", "cases", "reference", "reports", "tests", "python")
PAGES = [*ROOT.glob("*.md"), *(page for folder in FOLDERS for page in (ROOT / folder).rglob("*.md"))]


def test_the_example_of_a_case(monkeypatch):
    monkeypatch.setenv("PULLOFF_DATA", str(ROOT))
    pathlib.Path("example.yaml").write_text(re.search("^```yaml\n(.*?)^```", (ROOT / "doc/cases.md").read_text(), re.M | re.S)[1])
    expect(0, "", "plan example.yaml").has("^  leave out 1 scene: why not$")


def test_commands():
    done = subprocess.run([sys.executable, HERE / "documents.py", conftest.PROGRAM, ROOT], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def text_of(page):
    """The text of a page. That on JSON documents is tested as it is built, with its tables."""
    built = pathlib.Path(conftest.PROGRAM).parents[2] / "doc/json.md"
    return (built if page == ROOT / "doc/json.md" and built.exists() else page).read_text()


def anchors(page):
    headings = re.findall("^#+ (.*)$", page.read_text(), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def test_links():
    wrong = []
    for page in PAGES:
        for target, anchor in re.findall(r"\]\(([^)#\s]*)(?:#([^)]*))?\)", text_of(page)):
            other = page.parent / target if target else page
            if "://" not in target and (not other.exists() or (anchor and anchor not in anchors(other))):
                wrong.append(f"{page.relative_to(ROOT)}: {target}#{anchor}")
    assert not wrong and len(PAGES) >= 8


def functions_elsewhere(page):
    """Functions that are not in the file or folder that has them by the page: in a row that names functions and one file, or `NAME` in
    `PLACE`."""
    for line in page.read_text().splitlines():
        cells = [re.findall("`([^`]+)`", cell) for cell in line.split("|")[1:3]]
        paths = [ROOT / "src" / word for word in cells[1] if word.endswith(".c")] if len(cells) == 2 else []
        if len(paths) == 1 and paths[0].exists():
            text = paths[0].read_text()
            yield from (f"{page.name}: {word} is not in {paths[0].name}" for word in cells[0]
                        if re.fullmatch(r"po_\w+", word) and not re.search(rf"\b{word}\(", text))
    for word, place in re.findall(r"`(po_\w+)` (?:in |\()`(?:src/)?([\w/]+(?:\.c)?)`", page.read_text()):
        path = ROOT / "src" / place
        paths = path.rglob("*.c") if path.is_dir() else (ROOT / "src").rglob(place)
        if not any(re.search(rf"^\w.*\b{word}\(", path.read_text(), re.M) for path in paths):
            yield f"{page.name}: {word} is not in {place}"


def names_nothing(word, page, source, files):
    """Whether a word of a page is the name of a function, path or file that does not exist."""
    if re.fullmatch(r"po_\w+|PO_[A-Z_]+", word):
        return not re.search(rf"\b{word}\b", source)
    if re.fullmatch(r"(?:[\w.-]+/)+[\w.-]+\.(?:[chp]|py|sh|gp|md|toml|txt|build|csv)", word):
        folders = (ROOT, ROOT / "src", ROOT / "reports/pulloff_report", page.parent)
        return "NAME" not in word and not word.startswith(("build/", "my/")) and not any((folder / word).exists() for folder in folders)
    return bool(re.fullmatch(r"(?:po|test)_\w+\.[ch]", word)) and word not in files


def test_names():
    source = "\n".join(path.read_text() for path in (ROOT / "src").rglob("*.[ch]"))
    files = {path.name for folder in ("src", "tests") for path in (ROOT / folder).rglob("*.*")}
    wrong = []
    for page in PAGES:
        if page.name == "CHANGELOG.md": # it names what there was
            continue
        wrong += functions_elsewhere(page)
        wrong += [f"{page.relative_to(ROOT)}: {word}" for word in re.findall("`([^`\n]+)`", page.read_text())
                  if names_nothing(word, page, source, files)]
    modules = {str(path.parent.relative_to(ROOT / "src")) for path in (ROOT / "src").rglob("*.c")}
    table = set(re.findall(r"^\| `([\w/]+)` \|", (ROOT / "src/README.md").read_text(), re.M))
    assert not wrong and modules == table
