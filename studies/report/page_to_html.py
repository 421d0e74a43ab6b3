#!/usr/bin/python3
"""Turn a Markdown page into one HTML file with its figures inside, for any browser, offline.

    studies/report/page_to_html.py PAGE.md PAGE.html
"""

import base64
import pathlib
import re
import sys

import markdown

STYLE = """
body { font: 15px/1.5 sans-serif; max-width: 75em; margin: 2em auto; padding: 0 1em; color: #222; }
table { border-collapse: collapse; margin: 1em 0; font-size: 13px; }
th, td { border: 1px solid #ccc; padding: 0.25em 0.6em; vertical-align: top; }
th { background: #f3f3f3; text-align: left; }
img { max-width: 100%; }
code { background: #f3f3f3; padding: 0 0.2em; }
"""
TYPES = {".svg": "image/svg+xml", ".png": "image/png"}


def embed(match, folder):
    path = folder / match.group(1)
    if not path.is_file():
        return match.group(0)
    data = base64.b64encode(path.read_bytes()).decode()
    return f'src="data:{TYPES[path.suffix]};base64,{data}"'


def main():
    page, target = map(pathlib.Path, sys.argv[1:])
    text = page.read_text(encoding="utf-8").replace("<details>", '<details markdown="1">')
    body = markdown.markdown(text, extensions=["tables", "md_in_html"])
    body = re.sub(r'src="([^":]+)"', lambda match: embed(match, page.parent), body)
    title = re.search(r"^# (.*)$", text, re.MULTILINE).group(1)
    target.write_text(f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{title}</title>'
                      f"<style>{STYLE}</style></head><body>\n{body}\n</body></html>\n", encoding="utf-8")


if __name__ == "__main__":
    main()
