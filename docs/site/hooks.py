"""What mkdocs.yml cannot say: the API reference, which Doxygen writes next to the pages, in the navigation."""

import os

from mkdocs.structure.nav import Link


def on_nav(nav, config, files):
    if os.environ.get("ZONA_DOC_API"):
        developers = next(item for item in nav.items if item.title == "Developers")
        developers.children.append(Link("API reference", "api/index.html"))
    return nav
