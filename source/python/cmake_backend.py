"""Builds a wheel of the module with CMake, for pip (PEP 517).

pip install ./source/python                                      # builds in a folder of its own
pip install --config-settings build-dir=build ./source/python    # in a build that is there
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

FOLDER = pathlib.Path(__file__).resolve().parent
PROJECT = FOLDER.parent.parent
NAME = "rolling_contact"


def version():
    """That of project() in CMakeLists.txt."""
    found = re.search(r"project\(\s*rolling-contact\s+VERSION\s+([0-9.]+)", (PROJECT / "CMakeLists.txt").read_text())
    if not found:
        raise RuntimeError(f"{PROJECT / 'CMakeLists.txt'}: no project(rolling-contact VERSION ...)")
    return found.group(1)


def metadata():
    project = (FOLDER / "pyproject.toml").read_text()

    def of(entry):
        return re.search(rf'^{entry} = "(.*)"$', project, re.M).group(1)

    extras = re.findall(r"^(\w+) = \[(.*)\]$", project.split("[project.optional-dependencies]")[1], re.M)
    lines = [
        "Metadata-Version: 2.1",
        f"Name: {of('name')}",
        f"Version: {version()}",
        f"Summary: {of('description')}",
        f"Requires-Python: {of('requires-python')}",
        "Requires-Dist: numpy",
    ]
    for name, packages in extras:
        lines.append(f"Provides-Extra: {name}")
        lines += [f"Requires-Dist: {package} ; extra == '{name}'" for package in re.findall(r'"([^"]+)"', packages)]
    return "\n".join(lines) + "\n"


def tag():
    abi = sysconfig.get_config_var("SOABI").split("-")[1]
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    return f"{python}-cp{abi}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _built(build):
    """The folder of the module that CMake made there."""
    configure = ["cmake", "-S", str(PROJECT), "-B", str(build), "-D", "PYTHON=ON"]
    if not (build / "CMakeCache.txt").is_file():
        configure += ["-D", f"Python_EXECUTABLE={sys.executable}"]
    for command in (
        configure,
        ["cmake", "--build", str(build), "--target", "rolling_contact_python", "--parallel", str(os.cpu_count())],
    ):
        subprocess.run(command, check=True)
    return build / "python" / NAME


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    """Write the wheel into the folder and return its name."""
    given = (config_settings or {}).get("build-dir")
    with tempfile.TemporaryDirectory() as folder:
        module = _built(pathlib.Path(given) if given else pathlib.Path(folder))
        info, name = f"{NAME}-{version()}.dist-info", f"{NAME}-{version()}-{tag()}.whl"
        contents = {
            f"{NAME}/{file.name}": file.read_bytes() for file in sorted(module.iterdir()) if file.is_file()
        }
        contents[f"{info}/METADATA"] = metadata().encode()
        contents[f"{info}/WHEEL"] = (
            f"Wheel-Version: 1.0\nGenerator: cmake_backend\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode()
        )
        contents[f"{info}/LICENSE"] = (PROJECT / "LICENSE").read_bytes()
        record = ""
        with zipfile.ZipFile(pathlib.Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
            for path, content in contents.items():
                digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
                record += f"{path},sha256={digest},{len(content)}\n"
                wheel.writestr(path, content)
            wheel.writestr(f"{info}/RECORD", record + f"{info}/RECORD,,\n")
    return name


def build_sdist(sdist_directory, config_settings=None):
    raise RuntimeError("rolling-contact is built from a clone of its repository: pip install ./source/python")
