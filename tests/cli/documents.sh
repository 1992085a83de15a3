#!/bin/sh
# Every command in the documents runs, the output shown there is that of the present program, and the example of a case
# file is a valid case. documents.py describes the comparison.
# shellcheck disable=SC1091,SC2034,SC2154
. "$(dirname "$0")/lib.sh"
root=$here/../..
python=${PYTHON:-python3}

# The example of a case uses the reference tables of this source tree.
PULLOFF_DATA=$root
export PULLOFF_DATA
awk '/^```yaml/ { inside = 1; next } /^```/ && inside { exit } inside' "$root/doc/cases.md" >"$work/example.yaml"
expect 0 '' plan "$work/example.yaml"
check 'the example has a point left out' grep -q -x '  leave out 1 scene: why not' "$work/stdout"
check 'the commands of the documents' "$python" "$here/documents.py" "$program" "$root"
# Links lead to files, and to headings of pages. The page on JSON documents is tested as it is built, with its tables.
built=$(dirname "$program")/../../doc/json.md
cat >links.py <<'LINKS'
import pathlib
import re
import sys

root, built = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
folders = ("doc", "cases", "reference", "reports", "tests")
pages = [*root.glob("*.md"), *(page for folder in folders for page in (root / folder).rglob("*.md"))]


def anchors(page):
    headings = re.findall(r"^#+ (.*)$", page.read_text(), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


wrong = []
for page in pages:
    text = (built if page == root / "doc/json.md" and built.exists() else page).read_text()
    for target, anchor in re.findall(r"\]\(([^)#\s]*)(?:#([^)]*))?\)", text):
        if "://" in target:
            continue
        other = page.parent / target if target else page
        if not other.exists() or (anchor and anchor not in anchors(other)):
            wrong.append(f"{page.relative_to(root)}: {target}#{anchor}")
print("\n".join(wrong))
sys.exit(1 if wrong or len(pages) < 8 else 0)
LINKS
check 'the links of the documents' "$python" links.py "$root" "$built"

# The files and functions that the documents name exist.
cat >names.py <<'NAMES'
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1]).resolve()
source = "\n".join(path.read_text() for path in (root / "src").rglob("*.[ch]"))
files = {path.name for folder in ("src", "tests") for path in (root / folder).rglob("*.*")}
wrong = []
for page in (root / "doc").glob("*.md"):
    for line in page.read_text().splitlines(): # a row: functions, and the file that defines them
        cells = [re.findall(r"`([^`]+)`", cell) for cell in line.split("|")[1:3]]
        paths = [root / "src" / word for word in cells[1] if word.endswith(".c")] if len(cells) == 2 else []
        if len(paths) == 1 and paths[0].exists():
            text = paths[0].read_text()
            wrong += [f"{page.name}: {word} is not in {paths[0].name}" for word in cells[0]
                      if re.fullmatch(r"po_\w+", word) and not re.search(rf"\b{word}\(", text)]
    for word in re.findall(r"`([^`\n]+)`", page.read_text()):
        is_name = re.fullmatch(r"po_\w+|PO_[A-Z_]+", word)
        is_path = re.fullmatch(r"(?:[\w.-]+/)+[\w.-]+\.(?:[chp]|py|sh|gp|md|toml|txt|build|csv)", word)
        is_file = re.fullmatch(r"(?:po|test)_\w+\.[ch]", word)
        if (is_name and not re.search(rf"\b{word}\b", source)
                or is_path and "NAME" not in word and not word.startswith(("build/", "my/")) and not any((root / folder / word).exists() for folder in (".", "src"))
                or is_file and word not in files):
            wrong.append(f"{page.name}: {word}")
modules = {str(path.parent.relative_to(root / "src")) for path in (root / "src").rglob("*.c")}
table = set(re.findall(r"^\| `([\w/]+)` \|", (root / "src/README.md").read_text(), re.M))
wrong += [f"src/README.md: module {name}" for name in sorted(modules ^ table)]
print("\n".join(wrong))
sys.exit(bool(wrong))
NAMES
check 'the files and functions of the documents' "$python" names.py "$root"
finish
