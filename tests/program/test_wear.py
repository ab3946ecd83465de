"""Wear and fatigue of a state: columns, depths, fields and the shakedown map, against the energy, the pressure and the forces that are
told beside them."""

import math
import re

import pytest

STATE = "profiles_tread"
SIX = {"Mesh/Elements across patch": 6}
REPORT = {**SIX, "Wear/Report": "true", "Contact/Speed": 20}


def close(value, wanted, tolerance=1e-6):
    assert abs(value / wanted - 1) <= tolerance


def area(across, column):
    """Of the lines across the patch."""
    return sum(depth * width for depth, width in zip(across[column], across["width_m"]))


@pytest.fixture(scope="module")
def worn(shared):
    return shared(STATE, REPORT, output="worn")


def test_worn_areas(worn):
    """Worn mass is K times the energy: of the rail for a passage, of the wheel once a revolution, mm^2/km = 1e-9 m, at radii within
    0.5 % of 0.46 m. Below 10.4 N/mm^2 everywhere, the USFD law is that of T gamma, but for nodes whose power is negative by the error
    of the mesh."""
    row, across = worn.results.records()[-1], worn.table("across.csv")
    energy = row["dissipation_J/m"]
    close(area(across, "wear_rail_t-gamma_m"), 5.3e-9 * energy / 7850)
    close(row["wear_t-gamma_mm2/km"], 5.3e-9 * energy / 7850 / (2 * math.pi * 0.46) * 1e9, 5e-3)
    for law in ("archard", "usfd", "t-gamma"):
        close(area(across, f"wear_wheel_{law}_m/m") * 1e9, row[f"wear_{law}_mm2/km"])
    close(row["wear_usfd_mm2/km"], row["wear_t-gamma_mm2/km"], 0.025)
    close(row["wear_archard_lowest_mm2/km"], row["wear_archard_mm2/km"] / 5)  # of mild wear
    close(row["wear_archard_highest_mm2/km"], 2 * row["wear_archard_mm2/km"])
    close(row["wear_brr_mm2/km"], 0.25 * energy / 920)


def test_fatigue(worn):
    """Half of the patch sticks, and more than 5 % of the load slides."""
    row = worn.results.records()[-1]
    mu = row["utilised_friction"]
    close(row["load_factor"], row["max_pressure_Pa"] / 300e6)
    close(row["fi_surf"], mu - 1 / row["load_factor"], 1e-5)
    close(mu, row["traction_coefficient"])
    close(row["fi_sub_Pa"], row["normal_force_N"] / (4 * row["patch_1_area_m2"]) * (1 + mu ** 2))
    assert 0.999 <= row["utilised_friction_95"] <= 1.000001


def test_fields_and_the_shakedown_map(worn):
    """The elastic limit of a line without friction, and shakedown, are at 3.33."""
    fields = "".join(path.read_text(encoding="utf-8") for path in worn.folder.glob("interface*.vtu"))
    for field in ("wear_rate_archard", "wear_rate_usfd", "wear_rate_t_gamma", "surface_index"):
        assert f'Name="{field}"' in fields
    assert worn.has("shakedown.svg")
    limits = worn.text("shakedown.dat")
    assert "shakedown, line contact" in limits
    assert re.search(r"elastic limit, line.*\n(.*\n){0,2}0\s*3\.33", limits)
    assert re.search("wear .*usfd", worn.out)


def test_other_constants(program, worn):
    """Twice the yield stress; half the density; half the hardness with the lowest coefficients."""
    row, others = (run.results.records()[-1] for run in (
        program(STATE, REPORT, {"Wear/Shear yield stress": 600e6, "Wear/Density": 3925, "Wear/Hardness": 1.5e9,
                                "Wear/Archard coefficients": "lowest"}), worn))
    close(row["load_factor"], others["load_factor"] / 2)
    close(row["wear_usfd_mm2/km"], 2 * others["wear_usfd_mm2/km"])
    close(row["wear_archard_mm2/km"], 2 * others["wear_archard_lowest_mm2/km"])


def test_an_own_coefficient_of_archard(program, worn):
    """Everywhere, whatever the speed, without a range; half as much again as mild wear has."""
    row = program(STATE, SIX, {"Wear/Report": "true", "Wear/Archard coefficient": 7.5e-4, "Wear/Archard coefficients": "highest"},
                  says="Wear/Archard coefficients = highest has no effect: Wear/Archard coefficient is given").results.records()[-1]
    close(row["wear_archard_mm2/km"], 1.5 * worn.results.records()[-1]["wear_archard_mm2/km"])
    for end in ("lowest", "highest"):
        assert row[f"wear_archard_{end}_mm2/km"] == row["wear_archard_mm2/km"]


def test_a_coefficient_below_zero(program):
    program.refuses(STATE, "give a number of at least 0", {"Wear/Report": "true", "Wear/Archard coefficient": -1})


def test_not_asked(program):
    run = program(STATE, SIX, {"Wear/Hardness": "2e9"}, says="Wear/Hardness = 2e9 has no effect: Wear/Report = false")
    for name in ("results.csv", "across.csv"):
        assert "wear_" not in run.text(name) and "fi_surf" not in run.text(name)
    assert not (run / "shakedown.svg").exists()


def test_a_hardness_that_is_none(program):
    program.refuses(STATE, "Wear/Hardness = 0: it must be above 0, in Pa", {"Wear/Report": "true", "Wear/Hardness": 0})


def test_a_plane(program):
    program("carter_2d_partial_slip", {"Wear/Report": "true"}, says="Wear/Report = true has no effect: it has a meaning in 3D only")
