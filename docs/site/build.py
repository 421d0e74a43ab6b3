#!/usr/bin/python3
"""Build the documentation as one site of static pages, and check every link in it.

    docs/site/build.py [SITE]          # build/site unless told otherwise

The pages are copied as they lie in the repository, so that their links hold in both places. A source file that a page
links becomes a page of its own, with its text; a folder becomes a list of its files. KaTeX, for the formulas, is
Debian's; its fonts go into the style sheet, because some browsers load no fonts from file://. Where docs/Doxyfile is, Doxygen adds the API reference in api/.
Ends with 1 where a link is broken or a tool complains, with 77 where a tool is missing.
"""

import argparse
import base64
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import check_links

ROOT = pathlib.Path(__file__).resolve().parents[2]
KATEX = pathlib.Path("/usr/share/javascript/katex")
LINK = re.compile(r"(?<=\]\()([^)#\s]+)(?=[)#])")
FENCE = re.compile(r"(^ *```.*?^ *```)", re.MULTILINE | re.DOTALL)
LANGUAGES = {".h": "cpp", ".cc": "cpp", ".py": "python", ".toml": "toml", ".csv": "text", ".yml": "yaml",
             ".json": "json"}
COPIED = {".md", ".png", ".svg", ".css", ".js", ".html"}
THEME = pathlib.Path("docs/site/theme")  # not pages of the site
NEEDED = [pathlib.Path("/usr/bin/mkdocs"), pathlib.Path("/usr/share/mkdocs/themes/material"),
          pathlib.Path("/usr/lib/python3/dist-packages/pymdownx"), KATEX]
TOOL_MISSING = 77


class BuildError(Exception):
    def __init__(self, message, code=1):
        super().__init__(message)
        self.code = code


def tracked_files():
    """Paths below the repository's root that belong to it: what git knows, or all where there is no git."""
    listing = subprocess.run(["git", "-C", ROOT, "ls-files", "-co", "--exclude-standard"], text=True,
                             capture_output=True, check=False)
    if listing.returncode == 0:
        return [pathlib.Path(line) for line in listing.stdout.splitlines() if (ROOT / line).is_file()]
    return [path.relative_to(ROOT) for path in ROOT.rglob("*")
            if path.is_file() and path.relative_to(ROOT).parts[0] not in ("build", "runs")]


def write_source_page(source, pages):
    """A page that shows a source file; its name is that of the file with .md behind it."""
    text = (ROOT / source).read_text(encoding="utf-8")
    target = pages / f"{source}.md"
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(f"# {source}\n\n````{LANGUAGES.get(source.suffix, 'text')}\n{text}````\n", encoding="utf-8")


def write_folder_page(folder, pages):
    sources = [path for path in tracked_files() if folder in path.parents]
    for source in sources:
        write_source_page(source, pages)
    links = "".join(f"- [{path.relative_to(folder)}]({path.relative_to(folder.parent)}.md)\n" for path in sources)
    (pages / f"{folder}.md").write_text(f"# {folder}/\n\n{links}", encoding="utf-8")


def copy_page(page, pages):
    """Copy a page; links to source files and folders lead to the pages that show them."""
    def lead(match):
        link = match.group(1)
        source = pathlib.Path(os.path.normpath(page.parent / link))
        if ":" in link or source.suffix in COPIED:
            return link
        if (ROOT / source).is_dir():
            write_folder_page(source, pages)
        elif (ROOT / source).is_file():
            write_source_page(source, pages)
        else:
            return link
        return f"{link.rstrip('/')}.md"

    text = (ROOT / page).read_text(encoding="utf-8")
    parts = FENCE.split(text)  # the odd ones are code
    parts[::2] = [LINK.sub(lead, part) for part in parts[::2]]
    # Markdown within an HTML block is asked for in the site, and taken for granted on git hosts.
    text = "".join(parts).replace("<details>", '<details markdown="1">')
    target = pages / page
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(text, encoding="utf-8")


def copy_pages(pages):
    navigation = (ROOT / "docs/site/mkdocs.yml").read_text(encoding="utf-8")
    for path in tracked_files():
        if path.suffix == ".md" and (path.parts[0] == "docs" or len(path.parts) == 1):
            if f" {path}\n" not in navigation:
                raise BuildError(f"{path} has no place in the navigation of docs/site/mkdocs.yml")
            copy_page(path, pages)
        elif path.parts[0] == "docs" and path.suffix in COPIED and THEME not in path.parents:
            (pages / path.parent).mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / path, pages / path)


def copy_katex(folder):
    """KaTeX in two scripts and a style sheet that holds its fonts."""
    for script in ("katex.min.js", "contrib/auto-render.js"):
        shutil.copyfile(KATEX / script, folder / pathlib.Path(script).name.replace(".min", ""))

    def embed(match):
        data = base64.b64encode((KATEX / match.group(1)).read_bytes()).decode()
        return f"url(data:font/woff2;base64,{data})"

    style = (KATEX / "katex.min.css").read_text(encoding="utf-8")
    style = re.sub(r",url\([^)]*\.(?:woff|ttf)\) format\(\"\w+\"\)", "", style)
    style = re.sub(r"url\(([^)]*\.woff2)\)", embed, style)
    (folder / "katex.css").write_text(style, encoding="utf-8")


def require_tools(has_api):
    doxygen = [pathlib.Path("/usr/bin/doxygen")] if has_api else []
    missing = [str(path) for path in NEEDED + doxygen if not path.exists()]
    if missing:
        raise BuildError(f"not installed: {', '.join(missing)}; packages-dev.txt lists what the documentation needs",
                         TOOL_MISSING)


def run(command, environment):
    """Runs a tool; what it complained of is shown if it fails."""
    answer = subprocess.run(command, cwd=ROOT, env={**os.environ, **environment}, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if answer.returncode != 0:
        said = re.sub(r"\x1b\[\d*m", "", answer.stdout)
        complaints = [line for line in said.splitlines() if re.search("WARNING|ERROR|warning:|error:", line)]
        raise BuildError(f"{command[0]} failed:\n" + ("\n".join(complaints) or said))


def write_search_index(site):
    """The index of the search as a script: pages opened from file:// may not fetch it."""
    index = json.loads((site / "search/search_index.json").read_text(encoding="utf-8"))
    script = "var __search = {index: Promise.resolve(" + json.dumps(index, ensure_ascii=False) + ")};\n"
    (site / "docs/site/search_index.js").write_text(script, encoding="utf-8")


def build(site):
    has_api = (ROOT / "docs/Doxyfile").exists()
    require_tools(has_api)
    with tempfile.TemporaryDirectory(prefix="zona-docs-") as scratch:
        pages, new = pathlib.Path(scratch) / "pages", pathlib.Path(scratch) / "site"
        copy_pages(pages)
        copy_katex(pages / "docs/site")
        run(["/usr/bin/mkdocs", "build", "--config-file", "docs/site/mkdocs.yml"],
            {"ZONA_DOC_PAGES": str(pages), "ZONA_DOC_SITE": str(new), "ZONA_DOC_API": "1" if has_api else ""})
        (new / "404.html").unlink()  # for servers, with links from their root
        write_search_index(new)
        if has_api:
            run(["/usr/bin/doxygen", "docs/Doxyfile"], {"ZONA_DOC_OUT": str(new / "api")})
        shutil.rmtree(site, ignore_errors=True)
        site.parent.mkdir(parents=True, exist_ok=True)
        shutil.move(new, site)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("site", nargs="?", type=pathlib.Path, default=ROOT / "build/site")
    site = arguments.parse_args().site.resolve()
    try:
        build(site)
    except BuildError as error:
        print(f"docs: {error}", file=sys.stderr)
        sys.exit(error.code)
    links, broken = check_links.check(site)
    for problem in broken:
        print(f"docs: {problem}", file=sys.stderr)
    if broken:
        sys.exit(f"docs: {len(broken)} broken links")
    print(f"{links} links hold; open {site / 'index.html'}")


if __name__ == "__main__":
    main()
