#!/usr/bin/python3
"""Check that every link in a folder of HTML pages leads to a file that is there, and to an anchor in it.

    docs/site/check_links.py SITE

Links to other hosts are not followed. A page that would load anything from another host is an error.
"""

import html.parser
import pathlib
import sys
import urllib.parse

LOADED = {("script", "src"), ("img", "src"), ("iframe", "src"), ("link", "href"), ("object", "data"), ("source", "src")}
# Doxygen 1.9.4 leads to this part of a class' page also where it has left it out.
LEFT_OUT_BY_DOXYGEN = "nested-classes"


class Page(html.parser.HTMLParser):
    """Anchors of a page, and (tag, attribute, link) of all that it leads to or loads."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(path.read_text(encoding="utf-8", errors="replace"))

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (tag == "a" and name == "name"):
                self.anchors.add(value)
            elif name in ("href", "src", "xlink:href") or (tag, name) in LOADED:
                self.links.append((tag, name, value or ""))


def problem_of(page, link, pages):
    """What is wrong with a link that stays on the site, or None."""
    parts = urllib.parse.urlsplit(link)
    target = page if not parts.path else page.parent / urllib.parse.unquote(parts.path)
    target = pathlib.Path(*target.parts).resolve()
    if not target.is_file():
        return "leads to no file"
    anchor = urllib.parse.unquote(parts.fragment)
    if anchor and target in pages and anchor not in pages[target].anchors | {LEFT_OUT_BY_DOXYGEN}:
        return "leads to no anchor of that page"
    return None


def check(site):
    """The number of links on the site, and a line for each that is broken."""
    site = site.resolve()
    pages = {path: Page(path) for path in sorted(site.rglob("*.html"))}
    count, broken = 0, []
    for path, page in pages.items():
        for tag, name, link in page.links:
            count += 1
            scheme, host = urllib.parse.urlsplit(link)[:2]
            if host:
                loads = (tag, name) in LOADED
                problem = "is loaded from elsewhere: the site must open without a network" if loads else None
            else:  # data:, mailto:, javascript: lead nowhere
                problem = None if scheme else problem_of(path, link, pages)
            if problem:
                broken.append(f"{path.relative_to(site)}: {link} {problem}")
    return count, broken


if __name__ == "__main__":
    number, problems = check(pathlib.Path(sys.argv[1]))
    print("\n".join(problems) or f"{number} links hold")
    sys.exit(1 if problems else 0)
