"""Builds the two forms of the report from the same sections: one HTML page for the screen, and a short edition on paper."""

import base64
import itertools
import logging
import os
import re
import string
import zlib

import jinja2
from markupsafe import Markup

from . import beside, findings, fonts, identity, sections, svg, words

FACES = "<typefaces>"  # the place of the typefaces in a page; no escaped text can contain it
TITLE = "Pull-off of an adhesive sphere"
TEMPLATES = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "templates")


def template_text(name):
    with open(os.path.join(TEMPLATES, name), encoding="utf-8") as stream:
        return stream.read()


def printed_style(name):
    """A style sheet for paper: with the values of its variables, because WeasyPrint 57 supports no variable in a shorthand property,
    and those of the light page, which come first."""
    colours = dict(reversed(re.findall(r"--([\w-]+):\s*(#\w+)", template_text("style.css"))))
    return Markup(re.sub(r"var\(--([\w-]+)\)", lambda found: colours[found.group(1)],
                         template_text(name)))


def environment():
    made = jinja2.Environment(loader=jinja2.FileSystemLoader(TEMPLATES), autoescape=True,
                              undefined=jinja2.StrictUndefined, trim_blocks=True)
    made.globals["words"] = words
    return made


def with_bars(page):
    """Replaces each letter with a combining macron by a letter with a line over it, which every font renders correctly. Tags and
    entities stay as they are, and with them the texts of attributes."""
    return re.sub(f"(<[^>]*>|&[#0-9A-Za-z]+;)|(.){svg.MACRON}",
                  lambda found: found[1] or f'<span class="over">{found[2]}</span>', page)


def contents(run, references, faults=None, claims=None, cost=None, tests=None, rate=None):
    """All that either form of the report shows. What a run of the paper lacks is named on the first page."""
    built = sections.build_all(sections.Source(run, references, faults, claims, cost, rate))
    found = findings.build(run, {section.id: section.data for section in built}, claims, faults, identity.compare(run, references), tests)
    shown = [section for section in built if not section.absent]
    letter_figures([found["speed"] or {}] + [section.data for section in shown])
    return {"title": TITLE if run.is_of_paper else findings.own_title(run), "found": found, "sections": shown,
            "cases": run.cases, "of_paper": run.is_of_paper,
            "lacking": [section.absent for section in built if section.absent and run.is_of_paper]}


def letter_figures(parts):
    """Gives a letter to every figure that is not one of the paper, in the order of the report."""
    drawn = [item for data in parts for item in [data.get("figure"), *data.get("figures", [])] if item and not item.number]
    for item, letter in zip(drawn, itertools.chain(string.ascii_uppercase, itertools.count(27))):
        item.letter = letter


def filled(template, content, **more):
    """A template filled with the content, with its typefaces embedded."""
    page = with_bars(words.printable(environment().get_template(template).render(font_faces=Markup(FACES), **content, **more)))
    # The embedded fonts hold exactly the characters of the page, so they are made last.
    return page.replace(FACES, fonts.font_faces(page), 1)


def screen(content):
    """The complete report as one HTML page without references to other files."""
    return packed(without_dead_links(filled("report.html", content, paper=False, style=Markup(template_text("style.css")),
                                            script=Markup(template_text("script.js")))))


def packed(page):
    """The page with its long lists and its drawings compressed: the content of <div class="packed ...">...<!--/packed--></div>.
    The script of the page unpacks what is opened or scrolled to."""
    return re.sub(r'(<div class="packed\b[^>]*)>(.*?)<!--/packed--></div>', lambda found: (
        f'{found[1]} data-packed="{base64.b64encode(zlib.compress(found[2].encode("utf-8"), 9)).decode("ascii")}"></div>'),
                  page, flags=re.DOTALL)


def unpacked(page):
    """The page as a browser shows it when everything is opened."""
    return re.sub(r' data-packed="([^"]*)">', lambda found: ">" + zlib.decompress(base64.b64decode(found[1])).decode("utf-8"), page)


def paper(content):
    """The HTML from which the PDF is made: only the sections that belong on paper."""
    printed = [section for section in content["sections"] if section.on_paper]
    omitted = [section for section in content["sections"] if not section.on_paper]
    return filled("paper.html", dict(content, sections=printed), paper=True, omitted=omitted,
                  style=printed_style("style.css"), print_style=printed_style("print.css"))


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
    """The page with links to omitted parts replaced by their text; a reference to the page of such a part is left out."""
    there = set(re.findall(r'\bid="([^"]+)"', text))

    def link(found):
        if found[2] in there:
            return found[0]
        return "" if 'class="page"' in found[1] else found[3]
    return re.sub(r'<a\b([^>]*?)\bhref="#([^"]*)">(.*?)</a>', link, text, flags=re.DOTALL)
