#!/usr/bin/python3
"""Open pages of the site in Chromium, shut off from any network, and see that nothing complains.

    docs/site/open_pages.py SITE

The home page, pages of formulas, and a search from a file. Ends with 77 where there is no Chromium, or no site.
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

CANNOT_TELL = 77


def open_page(address):
    """The page as it is after its scripts have run, and what they complained of."""
    with tempfile.TemporaryDirectory(prefix="zona-browser-", ignore_cleanup_errors=True) as profile:
        answer = subprocess.run(
            ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}",
             "--host-resolver-rules=MAP * ~NOTFOUND", "--enable-logging=stderr", "--virtual-time-budget=10000",
             "--dump-dom", address],
            capture_output=True, text=True, timeout=100, check=True)
    return answer.stdout, [line for line in answer.stderr.splitlines() if "CONSOLE" in line]


def problems_of(site):
    for page in ("index.html", "docs/theory/mpm.html", "docs/theory/beam.html"):
        text, problems = open_page(f"{(site / page).as_uri()}")
        yield from (f"{page}: {problem}" for problem in problems)
        if 'class="katex-error"' in text:
            yield f"{page}: KaTeX does not understand a formula"
        if 'class="arithmatex"' in text and 'class="katex"' not in text:
            yield f"{page}: formulas are not set"
    text, problems = open_page(f"{(site / 'index.html').as_uri()}?q=decohesion")
    yield from (f"search: {problem}" for problem in problems)
    if not re.search(r"\d+ matching documents", text):
        yield "search: finds nothing for 'decohesion'"


def main():
    site = pathlib.Path(sys.argv[1]).resolve()
    if not shutil.which("chromium"):
        print("chromium is not installed; packages-dev.txt lists it")
        sys.exit(CANNOT_TELL)
    if not (site / "index.html").is_file():
        print(f"{site} holds no site")
        sys.exit(CANNOT_TELL)
    problems = list(problems_of(site))
    print("\n".join(problems) or "the pages open without a network")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
