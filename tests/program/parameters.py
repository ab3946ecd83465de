#!/usr/bin/python3
"""The parameters for other programs against the listing for people.

    parameters.py JSON PRM

Names, defaults and meanings are those of the listing; choices and ranges are
those that the meaning or the default is among.
"""

import json
import re
import sys


def listing(path):
    """Default, and meaning with its unit, of each Section/Entry of a listing."""
    found, section, help_text = {}, "", []
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.strip()
            if words.startswith("subsection "):
                section, help_text = words[11:] + "/", []
            elif words == "end":
                section = ""
            elif words in ("# Listing of Parameters", "# ---------------------"):
                continue
            elif words.startswith("# "):
                help_text.append(words[2:])
            elif words.startswith("set "):
                name, _, default = words[4:].partition("=")
                found[section + name.strip()] = default.strip(), " ".join(help_text)
                help_text = []
    return found


def numbers_in(allowed):
    """Lower and upper end of a range in words."""
    number = r"(-?[\d.]+(?:e[-+]?\d+)?)"
    lower = re.search(rf"(?:of at least|from) {number}", allowed)
    upper = re.search(rf"(?:of at most|to) {number}", allowed)
    return float(lower[1]) if lower else -float("inf"), float(upper[1]) if upper else float("inf")


def complaints(entry, default, meaning):
    units = [f" Units: {entry['unit']}."] if entry["unit"] else ["", " Units: 1."]
    if entry["default"] != default:
        yield f"default {entry['default']!r}, not {default!r}"
    if meaning not in [entry["meaning"] + unit for unit in units]:
        yield f"meaning {entry['meaning']!r} and unit {entry['unit']!r}, not {meaning!r}"
    allowed = entry["allowed"]
    if "[" in allowed or "MAX" in allowed:
        yield f"allowed {allowed!r} are no words"
    if not default or not allowed:
        return
    if allowed.startswith("`"):
        choices = re.findall(r"`([^`]+)`", allowed)
        if default not in choices:
            yield f"{default!r} is not among {choices}"
    is_word = f"or `{default}`" in allowed
    for value in default.split(",") if "number" in allowed and not is_word else []:
        lower, upper = numbers_in(allowed)
        if not lower <= float(value) <= upper:
            yield f"{value} is not in {allowed!r}"
    if "number" in allowed and entry["unit"] and entry["unit"] not in allowed:
        yield f"{allowed!r} has no unit"


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        told = json.load(file)
    flat = {name: entry for name, entry in told.items() if "default" in entry}
    for section, entries in told.items():
        if section not in flat:
            flat.update({f"{section}/{name}": entry for name, entry in entries.items()})
    shown = listing(sys.argv[2])
    wrong = [f"only in one: {name}" for name in sorted(set(flat) ^ set(shown))]
    for name in sorted(set(flat) & set(shown)):
        wrong += [f"{name}: {what}" for what in complaints(flat[name], *shown[name])]
    print("\n".join(wrong))
    sys.exit(1 if wrong or len(flat) < 100 else 0)


if __name__ == "__main__":
    main()
