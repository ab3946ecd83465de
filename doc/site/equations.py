"""Equations of the site, typeset by KaTeX when it is built: pages need no script.

Blocks ```math of the Markdown, as GitHub shows them, are equations. One that
KaTeX does not take is a warning, and so ends the build.
"""

import json
import subprocess

from docutils import nodes
from sphinx.transforms import SphinxTransform
from sphinx.util import logging

LOGGER = logging.getLogger(__name__)
TYPESET = """
const katex = require("/usr/share/nodejs/katex");
require("readline").createInterface({input: process.stdin}).on("line", line => {
  const {tex, displayMode} = JSON.parse(line);
  let answer;
  try { answer = {html: katex.renderToString(tex, {displayMode, throwOnError: true})}; }
  catch (error) { answer = {error: error.message}; }
  console.log(JSON.stringify(answer));
});
"""


class Katex:
    """KaTeX as a process that lives as long as the build."""

    def __init__(self):
        self.process = None

    def html(self, tex, display):
        if self.process is None:
            self.process = subprocess.Popen(  # pylint: disable=consider-using-with
                ["node", "-e", TYPESET], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.process.stdin.write(json.dumps({"tex": tex, "displayMode": display}) + "\n")
        self.process.stdin.flush()
        answer = json.loads(self.process.stdout.readline())
        if "error" in answer:
            LOGGER.warning("equation %r: %s", tex, answer["error"])
        return answer.get("html", "")


KATEX = Katex()


class MathBlocks(SphinxTransform):
    """Blocks of code in the language math become equations."""

    default_priority = 200

    def apply(self):
        for block in list(self.document.findall(nodes.literal_block)):
            if block.get("language") == "math":
                block.replace_self(nodes.math_block(block.astext(), block.astext(), nowrap=False, number=None, label=None))


def visit_inline(writer, node):
    writer.body.append(KATEX.html(node.astext(), False))
    raise nodes.SkipNode


def visit_block(writer, node):
    writer.body.append(f'<div class="equation">{KATEX.html(node.astext(), True)}</div>\n')
    raise nodes.SkipNode


def setup(app):
    app.add_transform(MathBlocks)
    app.add_html_math_renderer("katex", (visit_inline, None), (visit_block, None))
    app.config.html_math_renderer = "katex"
    return {"parallel_read_safe": True, "parallel_write_safe": False}
