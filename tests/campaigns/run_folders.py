"""What the folder of a run must be, however the run ended."""
import csv
import json
import pathlib

STATES = ("running", "done", "interrupted", "failed", "not converged")
TIMES = ("wall_s", "cpu_s", "step_wall_s")  # columns that differ from run to run
# how a file ends that is whole
ENDS = {".vtu": b"</VTKFile>", ".pvtu": b"</VTKFile>", ".pvd": b"</VTKFile>", ".svg": b"</svg>"}
BEGINS = {".h5": b"\x89HDF", ".wav": b"RIFF", ".fmu": b"PK"}


def complaints_of_file(path):
    """Why a file with its final name is not whole."""
    data = path.read_bytes()
    end, begin = ENDS.get(path.suffix), BEGINS.get(path.suffix)
    if end and not data.rstrip().endswith(end):
        yield f"{path.name} does not end with {end.decode()}"
    if begin and not data.startswith(begin):
        yield f"{path.name} is no file of its kind"
    if path.suffix == ".csv" and data:
        if not data.endswith(b"\n"):
            yield f"{path.name} ends within a line"
        rows = list(csv.reader(data.decode().splitlines()))
        if any(len(row) != len(rows[0]) for row in rows):
            yield f"{path.name} has a row that is not whole"


def record_of(folder):
    """run.json as read; None if there is none."""
    path = pathlib.Path(folder) / "run.json"
    return json.loads(path.read_text()) if path.exists() else None


def complaints_of(folder, killed=False):
    """What is wrong with a folder after the end of its run, or after SIGKILL."""
    folder = pathlib.Path(folder)
    if not folder.exists():
        return []
    found = []
    try:
        record = record_of(folder)
    except ValueError as error:
        return [f"run.json cannot be read: {error}"]
    if record is None:
        return ["there is no run.json"] if any(folder.iterdir()) else []
    if record.get("status") not in STATES:
        found.append(f"run.json says {record.get('status')}")
    if record.get("status") == "running" and not killed:
        found.append("run.json says running")
    listed = set(record["files"])
    for path in sorted(folder.iterdir()):
        part = path.name.endswith(".part")
        if part and not killed:
            found.append(f"{path.name} was left")
        name = path.name[:-len(".part")].removeprefix(".") if part else path.name
        if name != "run.json" and name not in listed and not (
                name.endswith(".svg") and name[:-4] + ".gp" in listed):
            found.append(f"run.json does not list {path.name}")
        if not part:
            found += complaints_of_file(path)
    if not killed:
        found += [f"{name} is listed and not there" for name in sorted(listed) if not (folder / name).exists()]
    return found


def rows_of(folder):
    """results.csv without its times; None if there is none."""
    path = pathlib.Path(folder) / "results.csv"
    if not path.exists():
        return None
    return [[(column, cell) for column, cell in row.items() if column not in TIMES]
            for row in csv.DictReader(path.read_text().splitlines())]
