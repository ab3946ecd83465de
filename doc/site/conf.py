"""Sphinx's settings for the site; made by .ci/site, which sets the environment."""

import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))

project = "rolling-contact"
author = "the authors of rolling-contact"
copyright = author  # pylint: disable=redefined-builtin
version = release = os.environ["ROLLING_CONTACT_VERSION"]
extensions = ["myst_parser", "equations", "references"]
root_doc = "index"
html_theme = "furo"
html_title = f"rolling-contact {release}"
html_static_path = [os.environ["STATIC_FILES"]]
html_css_files = ["katex.min.css", "site.css"]
html_extra_path = [os.environ["LIBRARY_PAGES"]]
html_copy_source = False
html_show_sphinx = False
html_show_search_summary = False  # browsers forbid its requests in pages of a disk
pygments_style = "tango"
highlight_language = "none"
myst_heading_anchors = 4
suppress_warnings = ["myst.header"]  # a page may begin with a lower heading after the contents
