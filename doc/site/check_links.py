#!/usr/bin/python3
"""Whether every link and picture within made pages leads to something.

Usage: check_links.py FOLDER

Checks all .html and .css files below the folder: files that links, pictures,
styles, scripts and fonts name exist, and the places in pages that links name
behind a #.
"""

import html.parser
import pathlib
import re
import sys
import urllib.parse


class Page(html.parser.HTMLParser):
    """Places of a page and what it refers to."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links = set(), []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        values = dict(attrs)
        self.anchors.update(value for value in (values.get("id"), tag == "a" and values.get("name")) if value)
        for name in ("href", "src"):
            if values.get(name):
                self.links.append(values[name])


def missing_of_styles(folder):
    for path in sorted(folder.rglob("*.css")):
        for name in re.findall(r"url\([\"']?([^\"')#?]+)", path.read_text(encoding="utf-8")):
            if not name.startswith("data:") and not (path.parent / name).is_file():
                yield f"{path}: {name}: there is no such file."


def missing_of_pages(folder):
    pages = {path: Page(path) for path in sorted(folder.rglob("*.html"))}
    for path, page in pages.items():
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            file = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            place = urllib.parse.unquote(parts.fragment)
            if not file.is_file():
                yield f"{path}: {link}: there is no such file."
            elif place and file in pages and place not in pages[file].anchors:
                yield f"{path}: {link}: the page has no such place."


def main():
    if len(sys.argv) != 2 or not pathlib.Path(sys.argv[1]).is_dir():
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[1]).resolve()
    found = [*missing_of_pages(folder), *missing_of_styles(folder)]
    print("\n".join(found) if found else "links of the site: ok")
    sys.exit(1 if found or not any(folder.rglob("*.html")) else 0)


if __name__ == "__main__":
    main()
