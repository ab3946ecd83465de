#!/usr/bin/python3
"""What an installed copy refers to is there: the links of its documentation, and for each library that
the CMake package links a package that librolling-contact-dev depends on.

Usage: tests/installed.py PREFIX BUILD_FOLDER
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

LINK = re.compile(r"\]\(([^)#\s]+)")


def dead_links(folder):
    """Links of Markdown files to files that are not there."""
    pages = [pathlib.Path(top, name) for top, _, names in os.walk(folder)
             for name in names if name.endswith(".md")]
    return [f"{page}: a link to {link}, which is not installed"
            for page in pages for link in LINK.findall(page.read_text())
            if "://" not in link and not (page.parent / link).exists()]


def linked_libraries(prefix):
    """Libraries that the CMake package names by their path."""
    targets = next(prefix.glob("lib*/**/rolling_contact-targets.cmake")).read_text()
    return sorted(set(re.findall(r'/[^;"\\]*\.(?:so|a)(?=[;"\\])', targets)))


def owner(path):
    """The package that a file or what its links lead to belongs to."""
    while True:
        found = subprocess.run(["dpkg", "-S", path], capture_output=True, text=True, check=False)
        if found.returncode == 0:
            return found.stdout.split(":")[0]
        if not os.path.islink(path):
            return None
        path = os.path.join(os.path.dirname(path), os.readlink(path))


def dependencies(names):
    """What apt installs with these packages on any machine. Of alternatives it may take any that is there:
    they count, the first one, for the packages themselves alone."""
    status = subprocess.run(["dpkg-query", "-W", "-f", "${Package}\t${Pre-Depends}, ${Depends}\n"],
                            capture_output=True, text=True, check=True).stdout
    needs = dict(line.split("\t") for line in status.splitlines())
    seen, waiting = set(), list(names)
    while waiting:
        name = waiting.pop()
        if name in seen or name not in needs:
            continue
        seen.add(name)
        for words in needs[name].split(","):
            first = re.match(r"\s*([a-z0-9.+-]+)", words)
            if first and ("|" not in words or name in names):
                waiting.append(first[1])
    return seen


def missing_packages(prefix, build):
    """Libraries to link that no dependency of the package brings."""
    entry = re.search(r'CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "([^"]*)"',
                      (build / "CPackConfig.cmake").read_text())
    brought = dependencies(re.split(r",\s*", entry[1]))
    complaints = []
    for library in linked_libraries(prefix):
        package = owner(library)
        if package is not None and package not in brought:
            complaints.append(f"{library} is linked, and librolling-contact-dev does not depend on {package}")
    return complaints


def main():
    """Exit code 1 and a line for each complaint."""
    prefix, build = (pathlib.Path(name).resolve() for name in sys.argv[1:3])
    complaints = dead_links(prefix / "share/doc/rolling-contact")
    if shutil.which("dpkg"):
        complaints += missing_packages(prefix, build)
    print("\n".join(complaints) or "links and packages of the installed copy: ok")
    sys.exit(bool(complaints))


main()
