"""Builds the two forms of the report from the same sections: one HTML page for the screen, and a short edition on paper."""

import logging
import os
import re

import jinja2
from markupsafe import Markup

from . import beside, findings, fonts, identity, sections, svg, words
from .sections import planted_faults

FACES = "/* typefaces */"  # the place of the typefaces in a page
TITLE = "Pull-off of an adhesive sphere"
TEMPLATES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "templates")


def template_text(name):
    with open(os.path.join(TEMPLATES, name), encoding="utf-8") as stream:
        return stream.read()


def style(name):
    """A style sheet with its colour variables replaced: WeasyPrint 57 supports no variable in a shorthand property."""
    colours = dict(re.findall(r"--([\w-]+):\s*(#\w+)", template_text("style.css")))
    return Markup(re.sub(r"var\(--([\w-]+)\)", lambda found: colours[found.group(1)],
                         template_text(name)))


def environment():
    made = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True,
                              undefined=jinja2.StrictUndefined, trim_blocks=True)
    made.globals["words"] = words
    return made


def with_bars(text):
    """Replaces each letter with a combining macron by a letter with a line over it, which every font renders correctly."""
    return re.sub("(.)" + svg.MACRON, r'<span class="over">\1</span>', text)


def contents(run, references, faults=None, claims=None, cost=None):
    """All that either form of the report shows."""
    source = sections.Source(run, references, faults, claims, cost)
    built = sections.build_all(source)
    beside_ours = next(section.data for section in built if section.id == "solvers").get("front")
    return {"title": TITLE, "found": dict(findings.build(run, claims), solvers=beside_ours,
                                         identity=identity.compare(run, references), planted=faults and planted_faults.verdict(faults)), "sections": built}


def filled(template, content, **more):
    """A template filled with the content, with its typefaces embedded."""
    page = with_bars(environment().get_template(template).render(font_faces=Markup(FACES), **content, **more))
    # The embedded fonts hold exactly the characters of the page, so they are made last.
    return page.replace(FACES, fonts.font_faces(page), 1)


def screen(content):
    """The complete report as one HTML page without references to other files."""
    return filled("report.html", content, paper=False, style=style("style.css"), script=Markup(template_text("script.js")))


def paper(content):
    """The HTML from which the PDF is made: only the sections that belong on paper."""
    printed = [section for section in content["sections"] if section.on_paper]
    omitted = [section for section in content["sections"] if not section.on_paper]
    return filled("paper.html", dict(content, sections=printed), paper=True, omitted=omitted,
                  style=style("style.css"), print_style=style("print.css"))


def pdf(content):
    """The paper edition as the bytes of a PDF."""
    # WeasyPrint warns about style rules that are for screens only.
    logging.getLogger("weasyprint").setLevel(logging.ERROR)
    import weasyprint
    page, pictures = with_pictures(without_dead_links(paper(content)))
    def fetch(url, *more, **options):
        if url in pictures:
            return {"string": pictures[url], "mime_type": "image/svg+xml"}
        return weasyprint.default_url_fetcher(url, *more, **options)
    return weasyprint.HTML(string=page, url_fetcher=fetch).write_pdf()


def with_pictures(text):
    """The page with images in place of its drawings, and the drawings by the names of the images: WeasyPrint would read the
    elements of a drawing in the page, and look up style rules for each."""
    pictures = {}

    def image(found):
        name = f"picture:{len(pictures)}"
        pictures[name] = found[0].encode()
        label = re.search(r' aria-label="([^"]*)"', found[0])
        return f'<img src="{name}" alt="{label[1] if label else ""}">'
    return re.sub(r"<svg\b.*?</svg>", image, text, flags=re.DOTALL), pictures


def forms(content):
    """Both forms of the report as bytes: HTML, PDF."""
    html = beside.start(lambda: screen(content).encode("utf-8"))
    printed = pdf(content)
    return html.result(), printed


def without_dead_links(text):
    """The page with links to omitted parts replaced by their text."""
    there = set(re.findall(r'\bid="([^"]+)"', text))
    return re.sub(r'<a href="#([^"]*)">(.*?)</a>',
                  lambda link: link[0] if link[1] in there else link[2], text, flags=re.DOTALL)
