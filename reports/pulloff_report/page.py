"""Puts the parts of the report together: one HTML page, and the same page on paper."""

import logging
import os
import re

import jinja2
from markupsafe import Markup

from . import claims as judged_claims
from . import fonts, sections, summary, svg, words

TITLE = "Pull-off of an adhesive sphere"
TEMPLATES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "templates")


def template_text(name):
    with open(os.path.join(TEMPLATES, name), encoding="utf-8") as stream:
        return stream.read()


def style(name):
    """A style sheet with its colours written out: WeasyPrint 57 knows no variable in a shorthand."""
    colours = dict(re.findall(r"--([\w-]+):\s*(#\w+)", template_text("style.css")))
    return Markup(re.sub(r"var\(--([\w-]+)\)", lambda found: colours[found.group(1)],
                         template_text(name)))


def environment():
    made = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True,
                              undefined=jinja2.StrictUndefined, trim_blocks=True)
    made.globals["words"] = words
    return made


def with_bars(text):
    """W and a combining macron as a letter with a line over it, which every font sets right."""
    return re.sub("(.)" + svg.MACRON, r'<span class="over">\1</span>', text)


def html(run, references, faults=None, claims=None):
    """The whole page as text; it refers to nothing outside itself."""
    source = sections.Source(run, references, faults, claims)
    kind, headline, text = summary.status(run)
    rows = summary.rows(run)
    content = {"title": TITLE, "facts": summary.facts(run), "rows": rows,
               "totals": summary.totals(rows), "claims": summary.claims(claims),
               "contradicted": judged_claims.contradicted(claims), "sections": sections.build_all(source),
               "status": {"kind": kind, "headline": headline, "text": text},
               "style": style("style.css"), "print_style": style("print.css"),
               "script": Markup(template_text("script.js"))}
    page = environment().get_template("report.html")
    # The faces hold just the characters of the page, so it is filled in twice.
    characters = page.render(font_faces="", **content)
    return with_bars(page.render(font_faces=Markup(fonts.font_faces(characters)), **content))


def for_paper(text):
    """The page without the rows that are for the screen: hidden ones cost as much time and memory as others;
    links to them are plain words."""
    text = re.sub(r'<(tbody|tr)\b[^>]* class="screen">.*?</\1>', "", text, flags=re.DOTALL)
    there = set(re.findall(r'\bid="([^"]+)"', text))
    return re.sub(r'<a href="#(point-[^"]*)">(.*?)</a>',
                  lambda link: link[0] if link[1] in there else link[2], text, flags=re.DOTALL)


def pdf(text):
    """The page of html() as the bytes of a PDF."""
    # Style rules for screens and the browser's script are not errors of the paper edition.
    logging.getLogger("weasyprint").setLevel(logging.ERROR)
    import weasyprint
    return weasyprint.HTML(string=for_paper(text)).write_pdf()
