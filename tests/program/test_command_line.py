"""Help, version and the parameters there are."""

import json
import math
import re

import pytest

DISCS = "carter_2d_partial_slip"
NUMBER = r"(-?[\d.]+(?:e[-+]?\d+)?)"


@pytest.fixture(scope="module")
def parameters(shared):
    """The listing for people."""
    return shared(None, options=["--print-parameters"])


def test_help_lists_the_options(program):
    assert "--validate" in program(None, options=["--help"]).out


def test_version(program):
    program(None, options=["--version"])


def test_the_listing_is_that_of_prm(program, parameters):
    assert parameters.out == (program.prm / "parameters.txt").read_text(encoding="utf-8")
    assert "Units: m/s" in parameters.out


def test_the_printed_parameters_are_valid_input(program, parameters):
    program(program.write("all.prm", parameters.out), {"Contact/Approach": 1e-4}, options=["--validate"])


def listing(text):
    """Default, and meaning with its unit, of each Section/Entry of a listing."""
    found, section, meaning = {}, "", []
    for line in map(str.strip, text.split("\n")):
        if line.startswith("subsection "):
            section, meaning = line[11:] + "/", []
        elif line == "end":
            section = ""
        elif line.startswith("# ") and line not in ("# Listing of Parameters", "# ---------------------"):
            meaning.append(line[2:])
        elif line.startswith("set "):
            name, _, default = line[4:].partition("=")
            found[section + name.strip()] = default.strip(), " ".join(meaning)
            meaning = []
    return found


def check(entry, default, meaning):
    """The default is that of the listing, as is the meaning, and it is among what is allowed, whose unit is told."""
    unit, allowed = entry["unit"], entry["allowed"]
    assert entry["default"] == default
    assert meaning in [entry["meaning"] + end for end in ([f" Units: {unit}."] if unit else ["", " Units: 1."])]
    assert "[" not in allowed and "MAX" not in allowed, "no words"
    if not default or not allowed:
        return
    if allowed.startswith("`"):
        assert default in re.findall(r"`([^`]+)`", allowed)
    if "number" in allowed:
        if f"or `{default}`" not in allowed:
            lower, upper = (re.search(rf"(?:{words}) {NUMBER}", allowed) for words in ("of at least|from", "of at most|to"))
            for value in map(float, default.split(",")):
                assert (float(lower[1]) if lower else -math.inf) <= value <= (float(upper[1]) if upper else math.inf)
        assert unit in allowed


def test_parameters_for_other_programs(program, parameters):
    """Names, defaults and meanings are those of the listing; choices and ranges are those that the default is among."""
    told, flat = json.loads(program(None, options=["--parameters-as-json"]).out), {}
    for name, entry in told.items():
        flat.update({name: entry} if "default" in entry else {f"{name}/{inner}": it for inner, it in entry.items()})
    shown = listing(parameters.out)
    assert set(flat) == set(shown) and len(flat) >= 100
    for name, entry in flat.items():
        check({"name": name, **entry}, *shown[name])


def test_validate_writes_nothing(program):
    program(DISCS, options=["--validate"])
    assert not (program.folder / "output").exists()


def test_messages_are_as_wide_as_the_terminal(program):
    narrow = {"COLUMNS": "40"}
    warning = program(DISCS, {"Wheel/Young modulus": 210}, options=["--validate"], env=narrow).err.splitlines()
    assert max(map(len, warning)) <= 40 and len(warning) > 2
    error = program(DISCS, options=["--nonsense"], code=1, env=narrow).err.splitlines()
    assert max(map(len, error)) <= 40


@pytest.mark.parametrize("word", ["-%original_token%-o", "--output=%option%", "--%canonical_option%", "--resume=%value%", "-%prefix%"])
def test_words_that_boost_would_fill_into_its_messages_without_end(program, word):
    program(DISCS, options=[word], code=1, says="Command line: ", seconds=20)
