#!/usr/bin/python3
"""Makes the site of the documentation in a build folder.

Usage: make.py BUILD_FOLDER, which has the program and the pages of the library.

Warnings of Doxygen and of Sphinx are errors: exit code 1, and the folder site
is as it was before.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pages

SCRIPTS = pathlib.Path("/usr/share/javascript")
HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parents[1]


def library_pages(source, target):
    """Doxygen's pages without its links to places that it does not write."""
    shutil.rmtree(target.parent, ignore_errors=True)
    shutil.copytree(source, target)
    for path in target.glob("class*.html"):
        text = path.read_text(encoding="utf-8")
        if 'name="nested-classes"' not in text:
            text = re.sub(r'<a href="#nested-classes">[^<]*</a>( &#124;)?\s*', "", text)
            path.write_text(text, encoding="utf-8")


def static_files(target):
    """What pages share: styles, and fonts of equations where their style expects them."""
    shutil.rmtree(target, ignore_errors=True)
    shutil.copytree(HERE / "static", target)
    shutil.copy(SCRIPTS / "katex/katex.min.css", target)
    shutil.copytree(SCRIPTS / "katex/fonts", target / "fonts")
    shutil.copy(SCRIPTS / "normalize.css/normalize.css", target)


def without_server(made):
    """Debian's theme takes a style from a folder of the web server: it is among the static files."""
    style = made / "_static/styles/furo.css"
    style.write_text(style.read_text(encoding="utf-8").replace("/javascript/normalize.css/", "../"), encoding="utf-8")


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    work = build / "site_work"
    warnings = (build / "doc/warnings").read_text(encoding="utf-8")
    if warnings:
        sys.exit(f"Doxygen warns:\n{warnings}")
    entries = subprocess.run([build / "rolling-contact", "--parameters-as-json"], check=True, capture_output=True, text=True)
    version = subprocess.run([build / "rolling-contact", "--version"], check=True, capture_output=True, text=True)
    library_pages(build / "doc/html", work / "library/api")
    static_files(work / "static")
    pages.Pages(PROJECT, work / "pages").make(json.loads(entries.stdout))
    environment = dict(os.environ, ROLLING_CONTACT_VERSION=version.stdout.split()[1],
                       STATIC_FILES=str(work / "static"), LIBRARY_PAGES=str(work / "library"), LIBRARY_TAGS=str(build / "doc/library.tag"))
    made = work / "html"
    shutil.rmtree(made, ignore_errors=True)
    sphinx = [sys.executable, "-m", "sphinx", "-q", "-E", "-W", "--keep-going", "-c", HERE, "-d", work / "doctrees",
              "-b", "html", work / "pages", made]
    code = subprocess.run(sphinx, env=environment, check=False).returncode
    if code == 0:
        without_server(made)
        shutil.rmtree(build / "site", ignore_errors=True)
        made.rename(build / "site")
    sys.exit(code)


if __name__ == "__main__":
    main()
