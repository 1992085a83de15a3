"""Tests that every file to which the Markdown pages below a folder link is there.

Usage: links.py FOLDER. Links to folders and files of the source tree that are not installed (src, tests, tools,
reference/make) are left out."""

import pathlib
import re
import sys

LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)|src=\"([^\"]+)\"")
SOURCE_ONLY = ("src", "tests", "tools", "reference/make", "reports/make_report.py", "LICENSE")


def broken(folder):
    for page in sorted(folder.rglob("*.md")):
        for found in LINK.finditer(page.read_text(encoding="utf-8")):
            link = found[1] or found[2]
            if "://" in link or link.startswith("mailto:"):
                continue
            target = (page.parent / link).resolve()
            inside = target.relative_to(folder) if target.is_relative_to(folder) else target
            if not target.exists() and not str(inside).startswith(SOURCE_ONLY):
                yield f"{page.relative_to(folder)}: {link}"


if __name__ == "__main__":
    wrong = list(broken(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(wrong))
    sys.exit(bool(wrong))
