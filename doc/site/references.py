"""What pages of the site name in code leads to where it is explained.

`Section/Entry` leads to the page of all entries, the name of a scene to its
page, that of a public header to Doxygen's page of it. The directive scene shows
a .prm file with the same links.
"""

import os
import pathlib
import re
import xml.etree.ElementTree as Xml

from docutils import nodes
from sphinx.transforms import SphinxTransform
from sphinx.transforms.post_transforms import SphinxPostTransform
from sphinx.util.docutils import SphinxDirective

SECTION = re.compile(r"^ *subsection +(.*?) *(?:#.*)?$")
END = re.compile(r"^ *end *(?:#.*)?$")
ENTRY = re.compile(r"^( *set +)([^=#]*?)( *=.*)$")


def header_pages(tagfile):
    """Doxygen's page of each public header, by its path below rolling_contact."""
    pages = {}
    for file in Xml.parse(tagfile).getroot().findall("compound[@kind='file']"):
        path = (file.findtext("path") or "") + file.findtext("name")
        page = file.findtext("filename")
        pages[path.rpartition("rolling_contact/")[2]] = page if page.endswith(".html") else page + ".html"
    return pages


class Targets:
    """Where names lead to."""

    def __init__(self, app):
        self.entries = {name.lower(): (page, anchor) for name, _, kind, page, anchor, _
                        in app.env.get_domain("std").get_objects() if kind == "entry"}
        self.scenes = {page[4:] for page in app.env.found_docs if page.startswith("prm/")}
        self.headers = header_pages(os.environ["LIBRARY_TAGS"])

    def uri(self, app, page, text):
        """Relative address of what a text in code names, or nothing."""
        name = re.split(r" *= *", text, maxsplit=1)[0].strip().lower()
        if name in self.entries:
            target, anchor = self.entries[name]
            return app.builder.get_relative_uri(page, target) + "#" + anchor
        scene = text.strip().removeprefix("prm/").removesuffix(".prm")
        if scene in self.scenes and "prm/" + scene != page:
            return app.builder.get_relative_uri(page, "prm/" + scene)
        header = text.strip().removeprefix("include/").removeprefix("rolling_contact/")
        if header in self.headers:
            return "../" * page.count("/") + "api/" + self.headers[header]
        return None


class CodeLeads(SphinxPostTransform):
    """Links from code in a text and from the entries of a shown scene."""

    default_priority = 5

    def run(self):
        if self.app.builder.format != "html":
            return
        if not hasattr(self.app, "rolling_contact_targets"):
            self.app.rolling_contact_targets = Targets(self.app)
        targets, page = self.app.rolling_contact_targets, self.env.docname
        for code in list(self.document.findall(nodes.literal)):
            in_link = isinstance(code.parent, (nodes.reference, nodes.title))
            uri = None if in_link else targets.uri(self.app, page, code.astext())
            if uri:
                link = nodes.reference("", "", refuri=uri, internal=True)
                code.replace_self(link)
                link += code
        for entry in list(self.document.findall(nodes.inline)):
            uri = "entry" in entry and targets.uri(self.app, page, entry["entry"])
            if uri:
                link = nodes.reference("", entry.astext(), refuri=uri, internal=True)
                entry.replace_self(link)


def scene_block(text, source):
    """A block of code with the entries of a scene as nodes that CodeLeads makes links of."""
    # Sphinx colours a block whose source is its text, and leaves others as they are
    block, section = nodes.literal_block(source, classes=["scene"]), ""
    for line in text.rstrip().splitlines():
        if SECTION.match(line):
            section = SECTION.match(line)[1] + "/"
        elif END.match(line):
            section = ""
        entry = ENTRY.match(line)
        code, mark, comment = (entry[3] if entry else line).partition("#")
        if entry:
            block += nodes.Text(entry[1])
            block += nodes.inline("", entry[2], entry=section + entry[2])
        block += nodes.Text(code)
        block += nodes.inline("", mark + comment, classes=["comment"])
        block += nodes.Text("\n")
    return block


class Scene(SphinxDirective):
    """A .prm file."""

    required_arguments = 1
    final_argument_whitespace = True

    def run(self):
        path = pathlib.Path(self.arguments[0])
        self.env.note_dependency(str(path))
        return [scene_block(path.read_text(encoding="utf-8"), str(path))]


class ScenesInText(SphinxTransform):
    """Blocks of code without a language that set entries are parts of scenes."""

    default_priority = 200

    def apply(self):
        for block in list(self.document.findall(nodes.literal_block)):
            text = block.astext()
            if block.get("language", "none") in ("none", "default") and re.search(r"^ *(set|subsection) ", text, re.M):
                block.replace_self(scene_block(text, "a part of a scene"))


def setup(app):
    app.add_object_type("entry", "entry", indextemplate="single: %s", objname="entry of a scene")
    app.add_directive("scene", Scene)
    app.add_transform(ScenesInText)
    app.add_post_transform(CodeLeads)
    return {"parallel_read_safe": True, "parallel_write_safe": False}
