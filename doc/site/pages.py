"""The sources of the site, made from the documentation of the project.

Pages are copied, the front page is README.md with the table of contents of
doc/README.md, every scene and script that a page links to becomes a page that
shows it, and one page has all entries of a scene.
"""

import os
import pathlib
import re
import shutil

FENCE = re.compile(r"^ *(```|~~~)")
LINK = re.compile(r"(\]\()([^()\s]+)(\))")
SCRIPTS = {".py": "python", ".cc": "cpp", ".sh": "sh", ".txt": "text", ".cff": "yaml", "": "text"}


class Pages:
    """Writes the sources of a project to a folder."""

    def __init__(self, project, folder):
        self.project, self.folder = pathlib.Path(project), pathlib.Path(folder)
        self.shown = set()  # files of the project that have a page of their own

    def make(self, entries):
        """All of them; entries as `rolling-contact --print-parameters=json` gives them."""
        shutil.rmtree(self.folder, ignore_errors=True)
        scenes = sorted(path.relative_to(self.project) for path in self.project.glob("prm/**/*.prm"))
        self.shown.update(scenes)
        sources = sorted(path for path in [*self.project.glob("*.md"), *self.project.glob("doc/**/*.md")]
                         if path.parent.name != "paper")  # a manuscript, with citations of its own form
        texts = {path: self.converted(path) for path in sources}
        front = self.project / "README.md"
        texts[front] += contents((self.project / "doc/README.md").read_text(encoding="utf-8"), self)
        for path, text in texts.items():
            self.write(self.place(path.relative_to(self.project)), text)
        for path in sorted(self.shown):
            self.write(self.place(path), self.page_of(path))
        self.write("parameters.md", page_of_entries(entries))
        self.write("all_scenes.md", list_of_scenes(scenes))
        self.write("library.md", LIBRARY)
        files = sorted(self.place(path) for path in self.shown if path.suffix != ".prm")
        self.write("files.md", list_of_files(files))
        for pattern in ("output/gallery/*", "doc/**/*.svg"):
            for picture in self.project.glob(pattern):
                target = self.folder / picture.relative_to(self.project)
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(picture, target)

    def write(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def place(self, path):
        """Where the site has a file of the project."""
        if path.as_posix() == "README.md":
            return "index.md"
        if path.as_posix() == "prm/parameters.txt":
            return "parameters.md"
        if path.suffix == ".prm":
            return path.with_suffix(".md").as_posix()
        return path.as_posix() + ("" if path.suffix == ".md" else ".md")

    def converted(self, page):
        """Text of a page with its links as the site has them."""
        lines, code = [], False
        for line in page.read_text(encoding="utf-8").splitlines():
            if FENCE.match(line):
                code = not code
            lines.append(line if code else LINK.sub(lambda link: self.link(page, link), line))
        return "\n".join(lines) + "\n"

    def link(self, page, link):
        target, hash_mark, anchor = link[2].partition("#")
        if "://" in target or not target:
            return link[0]
        path = pathlib.Path(os.path.normpath(page.parent / target)).relative_to(self.project)
        if path.suffix in (".svg", ".png"):
            return link[0]
        if not (self.project / path).is_file():
            raise SystemExit(f"{page}: {link[2]} is no file.")
        if path.suffix != ".md" and path.as_posix() != "prm/parameters.txt":
            self.shown.add(path)
        here = pathlib.PurePath(self.place(page.relative_to(self.project))).parent
        return link[1] + os.path.relpath(self.place(path), here) + hash_mark + anchor + link[3]

    def page_of(self, path):
        """Shows a file; a scene with its command and links to its entries."""
        if path.suffix == ".prm":
            name = path.relative_to("prm").with_suffix("").as_posix()
            return f"# {name}\n\n```sh\n./build/rolling-contact {path}\n```\n\n```{{scene}} {self.project / path}\n```\n"
        text = (self.project / path).read_text(encoding="utf-8")
        return f"# {path.name}\n\n~~~~{SCRIPTS[path.suffix]}\n{text.rstrip()}\n~~~~\n"


def contents(overview, pages):
    """Tables of contents, hidden ones for the side bar, from the lists of doc/README.md."""
    start, *sections = re.split(r"^## ", overview, flags=re.M)
    blocks = [("Start", ["Front page <self>", "All documentation <doc/README>", *names_in(start, pages)])]
    for section in sections:
        title, _, text = section.partition("\n")
        names = names_in(text, pages)
        if "doc/reference/scenes" in names:
            names.insert(names.index("doc/reference/scenes") + 1, "all_scenes")
        blocks.append((title, names))
    blocks[-1][1].extend(["library", "files"])
    return "\n" + "\n".join(
        f"```{{toctree}}\n:hidden:\n:maxdepth: 1\n:caption: {title}\n\n" + "\n".join(names) + "\n```\n"
        for title, names in blocks)


def names_in(text, pages):
    """The pages that a part of doc/README.md links to, but the front page."""
    names = []
    for target in re.findall(r"\]\(([^()#\s]+)\)", text):
        path = pathlib.Path(os.path.normpath(pages.project / "doc" / target)).relative_to(pages.project)
        if path.as_posix() != "README.md":
            names.append(pages.place(path).removesuffix(".md"))
    return names


def list_of_scenes(scenes):
    names = [path.relative_to("prm").with_suffix("").as_posix() for path in scenes]
    links = "\n".join(f"prm/{name}" for name in names)
    return ("# Scene files\n\nWhat each is for and what to expect of it: [scenes](doc/reference/scenes.md), and "
            "[extreme cases](doc/measurements/extremes.md) for those of `prm/extreme`.\n\n"
            f"```{{toctree}}\n:maxdepth: 1\n\n{links}\n```\n")


def list_of_files(names):
    return ("# Other files\n\nFiles that pages of this site lead to.\n\n```{toctree}\n:maxdepth: 1\n\n"
            + "\n".join(name.removesuffix(".md") for name in names) + "\n```\n")


def page_of_entries(entries):
    """All entries by sections, each to be linked to."""
    top = {name: child for name, child in entries.items() if "default" in child}
    known = sorted((f"{section}/{name}" for section in entries if section not in top for name in entries[section]),
                   key=len, reverse=True)
    lines = ["# All entries", "",
             "Every entry of a scene as the program has it (`rolling-contact --print-parameters`). Sections: "
             + ", ".join(f"[{name}](#{name.lower().replace(' ', '-')})" for name in entries if name not in top) + ".", "",
             "## Outside of sections", ""]
    for name, entry in top.items():
        lines += entry_lines(name, entry, known)
    for section, children in entries.items():
        if section in top:
            continue
        lines += [f"## {section}", ""]
        for name, entry in children.items():
            lines += entry_lines(f"{section}/{name}", entry, known)
    return "\n".join(lines) + "\n"


def entry_lines(path, entry, known):
    """An entry with its facts."""
    default = f"`{entry['default']}`" if entry["default"] else "*empty*"
    facts = [f"Default: {default}"] + [f"{fact}: {entry[fact]}" for fact in ("unit", "allowed") if entry[fact]]
    return ["````{entry} " + path, marked(entry["meaning"], known), "", "; ".join(facts) + ".", "````", ""]


def marked(text, known):
    """Text of no markup but backticks; entries that it names become code."""
    parts = text.split("`")
    for k in range(0, len(parts), 2):
        words = re.split("(" + "|".join(map(re.escape, known)) + r")(?!\w)", parts[k])
        words[::2] = [re.sub(r"([\\*_<>\[\]#$|])", r"\\\1", word) for word in words[::2]]
        words[1::2] = [f"`{word}`" for word in words[1::2]]
        parts[k] = "".join(words)
    return "`".join(parts)


LIBRARY = """# Pages of the library

Made by Doxygen from the public headers, with a search of their own:

```{raw} html
<ul>
<li><a href="api/index.html">Rooms of the library</a></li>
<li><a href="api/annotated.html">Classes</a></li>
<li><a href="api/files.html">Headers</a></li>
</ul>
```

Names of headers, as `contact/contact_problem.h`, lead there from all pages of this site. How the rooms fit together:
[architecture](doc/development/architecture.md); an example: [as a library](doc/development/architecture.md#as-a-library).
"""
