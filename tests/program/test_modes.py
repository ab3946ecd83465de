"""Modes and receptances: tables, pictures, moving shapes and what is refused."""

import math
import re
import shutil

import pytest
from conftest import VALIDATE, charts

PLATE, RAIL, DISCS = "annular_plate_modes", "rail_receptance", "carter_2d_partial_slip"
CONTACT_Y = "contact_y_1/sqrt(kg)"


def mode(run, number):
    return run.table("modes.csv").record(mode=number)


@pytest.fixture(scope="module")
def plate(shared):
    return shared(PLATE, {"Wheel/Cells along": 48, "Modes/Maximum frequency": 800, "Modes/Animated modes": 2,
                          "Wheel/Modal damping": "1e-3, 1e-2, 1e-4", "Wheel/Loss factor": 2e-4}, output="plate")


def test_modes_of_a_plate(plate):
    """Fourier expansion of the plate: 103.80 (twice), 114.99, 143.80 (twice)."""
    first, partner, umbrella, two = (mode(plate, k) for k in (1, 2, 3, 4))
    assert 103 <= first["frequency_Hz"] <= 105.5 and 103 <= partner["frequency_Hz"] <= 105.5
    assert [row["nodal_diameters"] for row in (first, umbrella, two)] == [1, 0, 2]
    assert [row["name"] for row in (first, umbrella, two)] == ["0L1", "0L0", "0L2"]
    assert 0.999 <= two["diameter_share"] <= 1.0000001, "mostly of that order"
    assert 0.99 <= first["axial_share"] <= 1, "it bends"
    for row in plate.table("modes.csv").records():
        assert (row["axial_share"] + row["radial_share"] + row["circumferential_share"] - 1) ** 2 <= 1e-15
    assert (first["pair_mode"], partner["pair_mode"], umbrella["pair_mode"]) == (2, 1, "")
    assert 0 <= first["pair_split"] <= 1e-6
    assert 0.01009 <= first["damping_ratio"] <= 0.01011
    assert 0.00109 <= umbrella["damping_ratio"] <= 0.00111
    assert 0.000199 <= two["damping_ratio"] <= 0.000201
    assert 0.2 <= first[CONTACT_Y] <= 1, "it moves the contact"
    assert abs(partner[CONTACT_Y]) <= 1e-8, "the partner does not"
    assert 0 <= first["residual"] <= 1e-8


def test_files_of_modes(plate):
    assert "modes up to 800 Hz, as many as the inertia counts" in plate.screen
    assert plate.has("modes_wheel.svg", "mode_shapes_wheel.svg", "wheel_mode_001.pvd", "wheel_mode_002_23.vtu")
    charts("modes", plate.folder, "wheel")
    assert not (plate / "wheel_mode_003.pvd").exists(), "two are animated"
    assert not (plate / "results.csv").exists()
    assert sum("DataSet" in line for line in plate.text("wheel_mode_001.pvd").splitlines()) == 24


def test_harmonics_of_a_plate(program, plate):
    """By Fourier series frequencies are exact on a mesh that could not tell them.

    The expansion that 103.80, 114.99 and 143.80 Hz are of has no finer cells at the clamped edge."""
    run = program(PLATE, {"Wheel/Model": "harmonic", "Wheel/Cells along": 24, "Modes/Maximum frequency": 800, "Modes/Animated modes": 1,
                          "Wheel/Modal damping": "1e-3, 1e-2, 1e-4"}, output="harmonic")
    assert "unknowns of the section for each of 0 to 5 nodal diameters" in run.screen
    first, umbrella, two = (mode(run, k) for k in (1, 3, 4))
    assert 103.60 <= first["frequency_Hz"] <= 103.66
    assert 0 <= first["pair_split"] <= 1e-12
    assert 114.84 <= umbrella["frequency_Hz"] <= 114.90
    assert 143.66 <= two["frequency_Hz"] <= 143.71
    assert [row["name"] for row in (first, umbrella, two)] == ["0L1", "0L0", "0L2"]
    assert 0.2 <= first[CONTACT_Y] <= 1
    assert 0.99 <= first[CONTACT_Y] / mode(plate, 1)[CONTACT_Y] <= 1.01, "as from a mesh"
    assert 0.00099 <= umbrella["damping_ratio"] <= 0.00101
    assert "by harmonics of its section" in run.text("run.json")


def test_harmonics_of_a_true_section(program):
    """The wheel on the left at the opposite shift is the mirror image of that on the right."""
    right, left = (
        mode(program("profiles_true_sections",
                     {"Analysis": "modes", "Wheel/Model": "harmonic", "Rail/Rigid": "true", "Profiles/Side": side,
                      "Profiles/Lateral shift": shift, "Modes/Maximum frequency": 400, "Modes/Animated modes": 0,
                      "Output/Plot": "false"}, output=side), 1)
        for side, shift in (("right", 0.003), ("left", -0.003)))
    assert 160 <= right["frequency_Hz"] <= 163.5
    assert abs(right["frequency_Hz"] / left["frequency_Hz"] - 1) <= 1e-7
    assert abs(right[CONTACT_Y] / left[CONTACT_Y] - 1) <= 1e-6


def test_a_plate_without_a_count(program):
    run = program(PLATE, {"Wheel/Cells along": 32, "Modes/Maximum frequency": 300, "Modes/Count check": "false", "Modes/Animated modes": 0})
    assert "not counted" in run.screen


def test_frequencies_go_with_the_root_of_stiffness_over_mass(program, plate):
    run = program(PLATE, {"Wheel/Cells along": 48, "Modes/Maximum frequency": 400, "Wheel/Young modulus": 70e9, "Wheel/Density": 2700,
                          "Modes/Animated modes": 0})
    ratio = mode(run, 1)["frequency_Hz"] / mode(plate, 1)["frequency_Hz"]
    assert abs(ratio / math.sqrt(70 / 210 * 7850 / 2700) - 1) <= 1e-7


def test_discs_in_2d_mirror_each_other(program):
    """z is upwards for both; nothing moves across."""
    run = program(DISCS, {"Analysis": "modes", "Modes/Element size": 0.05, "Modes/Maximum frequency": 8000, "Modes/Animated modes": 1})
    table = run.table("modes.csv")
    assert len({text for text, k in zip(table.texts("frequency_Hz"), table["mode"]) if k == 1}) == 1
    x, z = ({(row["body"], row["mode"]): row[f"contact_{axis}_1/sqrt(kg)"] for row in table.records()} for axis in "xz")
    of_rail = [k for body, k in x if body != "wheel"]
    for k in of_rail:
        size = x["rail", k] ** 2 + z["rail", k] ** 2
        assert (x["rail", k] - x["wheel", k]) ** 2 + (z["rail", k] + z["wheel", k]) ** 2 <= 1e-10 * size
    assert len(of_rail) > 3 and any(x["rail", k] ** 2 > 0.01 for k in of_rail) and any(z["rail", k] ** 2 > 0.01 for k in of_rail)
    assert all(share <= 1e-20 for share in table["axial_share"])


SHORT = {"Rail/Block length": 2, "Rail/Cells along": 40, "Rail/Sponge length": 0.6, "Receptance/Highest frequency": 1000,
         "Receptance/Frequencies per octave": 6}
WAVES = {"Rail/Model": "waveguide", "Rail/Sponge length": 0, "Rail/Sponge rate": 3000, "Receptance/Check frequencies": ""}
ONE_PER_OCTAVE = {"Receptance/Points": "", "Receptance/Frequencies per octave": 1}
DECAYS = {"Receptance/Decay rates": "true", "Receptance/Check frequencies": "", **ONE_PER_OCTAVE}
LONG = {"Rail/Block length": 14, "Rail/Cells along": 140, "Receptance/Lowest frequency": 400, "Receptance/Highest frequency": 630}


def cell(run, frequency, force, motion, column="receptance_m/N"):
    found = [row[column] for row in run.table("receptances.csv").records() if abs(row["frequency_Hz"] - frequency) < 1e-3
             and f"{row['force_at']} {row['force_along']}" == force and f"{row['motion_at']} {row['motion_along']}" == motion]
    assert len(found) == 1, f"{force}, {motion} at {frequency} Hz: {found}"
    return found[0]


def test_receptances_of_a_rail(program):
    run = program(RAIL, SHORT, output="rail")
    assert abs(cell(run, 1000, "contact z", "foot z") / cell(run, 1000, "foot z", "contact z") - 1) <= 1e-7, "it answers there as here"
    assert -3.1416 <= cell(run, 1000, "contact z", "contact z", "phase_rad") <= 0, "it lags"
    real, imaginary, size = (cell(run, 50, "contact z", "contact z", name) for name in ("real_m/N", "imaginary_m/N", "receptance_m/N"))
    assert abs(math.hypot(real, imaginary) / size - 1) <= 1e-7
    assert 1e-9 <= size <= 5e-9, "not stiffer than its foundation"
    assert re.search("error +receptance of the rail|receptance of the rail off by", run.screen)
    assert run.has("receptances_rail.svg")
    charts("receptances", run.folder, "rail")


def test_receptances_of_a_rail_without_ends(program):
    """24 m of mesh have 7.46e-10 and 2.73e-9 m/N at 1001.5 Hz.

    Bending waves of a Timoshenko beam at 1 kHz have k = 4.86 1/m and fade by loss factors of 0.02 in bending and shear and of 0.2
    in a layer that is above its resonance."""
    run = program(RAIL, SHORT, WAVES, output="rail")
    assert "waves in its section, without ends; contact z:" in run.screen
    assert 7.35e-10 <= cell(run, 1000, "contact z", "contact z") <= 7.55e-10
    assert 2.66e-9 <= cell(run, 1000, "contact y", "contact y") <= 2.78e-9
    assert abs(cell(run, 1000, "contact z", "far z", "real_m/N") / cell(run, 1000, "far z", "contact z", "real_m/N") - 1) <= 1e-6
    charts("receptances", run.folder, "rail")
    bending = [row for row in run.table("waves.csv").records()
               if row["frequency_Hz"] > 999 and row["share_vertical"] > 0.5 and row["decay_dB/m"] < 3]
    assert len(bending) == 1
    assert 4.7 <= bending[0]["wavenumber_1/m"] <= 5.0
    assert 0.65 <= bending[0]["decay_dB/m"] <= 0.8
    assert "mostly vertical" in run.text("waves.gp")


def test_pads_that_lie_side_by_side_are_a_layer(program):
    lossy = {"Receptance/Directions": "z", **ONE_PER_OCTAVE, "Rail/Loss factor": 0.1}
    layer = program(RAIL, {**SHORT, **WAVES, **lossy}, output="layer")
    pads = program(RAIL, {**SHORT, **WAVES, **lossy}, {"Rail/Pad spacing": 0.2, "Rail/Pad length": 0.2}, output="pads")
    assert abs(cell(pads, 1000, "contact z", "contact z") / cell(layer, 1000, "contact z", "contact z") - 1) <= 5e-3
    assert not (pads / "waves.csv").exists(), "no waves of a layer"


def decay(run, band, column="decay_vertical_dB/m"):
    return run.table("track_decay.csv").record(third_octave_Hz=band)[column]


@pytest.fixture(scope="module")
def decays(shared):
    return shared(RAIL, {**SHORT, **WAVES, **DECAYS}, output="decay")


def test_decay_rates(decays):
    """A beam on this layer has 2.426 and 0.825 dB/m in the bands of 500 and 1000 Hz."""
    assert "third_octave_Hz  decay_vertical_dB/m  decay_lateral_dB/m" in decays.out
    table = decays.table("track_decay.csv")
    kinds = ["decay", "wave", "limit"]
    assert table.columns == ["third_octave_Hz", *(f"{kind}_{way}_dB/m" for way in ("vertical", "lateral") for kind in kinds)]
    assert table["third_octave_Hz"] == [100, 125, 160, 200, 250, 315, 400, 500, 630, 800, 1000], "all bands up to the highest frequency"
    for row in table.records():
        for way in ("vertical", "lateral"):
            assert row[f"decay_{way}_dB/m"] > 0 and row[f"wave_{way}_dB/m"] > 0
            limit = row[f"limit_{way}_dB/m"]
            assert (limit != "" and limit > 0) == (row["third_octave_Hz"] >= 250)
    assert 2.3 <= decay(decays, 500) <= 2.5
    assert 0.76 <= decay(decays, 1000) <= 0.87
    assert decay(decays, 800, "limit_vertical_dB/m") == 2.19
    assert decay(decays, 315, "limit_lateral_dB/m") == 1.38
    charts("track_decay", decays.folder)


def test_decay_rates_of_little_damping(program):
    run = program(RAIL, {**SHORT, **WAVES, **DECAYS, "Rail/Loss factor": 0.002, "Rail/Foundation loss factor": 0.01, "Output/Plot": "false"},
                  says="vertical vibration in the bands 630, 800, 1000 Hz")
    assert not (run / "track_decay.svg").exists()


def test_decay_rates_on_pads(program):
    """18 m of mesh on these pads have 7.0 and 3.0 dB/m."""
    ballast = {f"Rail/Ballast stiffness {axis}": 1e8 for axis in "xyz"}
    run = program(RAIL, {**SHORT, **WAVES, **DECAYS, "Receptance/Lowest frequency": 400, "Receptance/Highest frequency": 500,
                         "Rail/Pad spacing": 0.6, "Rail/Pad length": 0.15, "Rail/Pad offset": 0.3, "Rail/Sleeper mass": 150, **ballast,
                         "Rail/Ballast loss factor": 1}, output="pads")
    assert 6.7 <= decay(run, 400) <= 7.3
    assert 2.8 <= decay(run, 500) <= 3.2
    assert decay(run, 400, "wave_vertical_dB/m") == decay(run, 500, "wave_lateral_dB/m") == "", "their waves are not known"
    charts("track_decay", run.folder)


def test_decay_rates_of_a_mesh(program, decays):
    """A mesh, and waves that go on beyond its ends."""
    run = program(RAIL, DECAYS, LONG)
    for band in (400, 500, 630):
        assert 0.97 <= decay(run, band) / decay(decays, band) <= 1.03, f"{band} Hz"
    assert "vibration is that of the mesh up to 3 m from the contact" in run.screen
    assert "doubtful" not in run.messages


def test_decay_rates_with_ends_that_reflect(program):
    program(RAIL, DECAYS, LONG, {"Rail/Sponge rate": 50}, says="vertical rates are doubtful from")


def test_frequencies_to_check_without_ends(program):
    program(RAIL, {**SHORT, **WAVES, **ONE_PER_OCTAVE, "Receptance/Check frequencies": 500},
            says="Check frequencies has no effect on a rail")


def test_a_measured_rail(program):
    scene = shutil.copy(program.scene(RAIL), program.folder / "rail.prm")
    shutil.copytree(program.prm / "sections", program.folder / "sections")
    program.write("measured.csv", "frequency_Hz,receptance_m/N\n100,3e-9\n1000,8e-10\n")
    run = program(scene, SHORT, {"Receptance/Measured rail": "measured.csv", "Receptance/Check frequencies": ""})
    assert "measured.csv" in run.text("receptances_rail.dat")
    program.write("unnamed.csv", "hertz,receptance_m/N\n100,3e-9\n")
    program(scene, SHORT, {"Receptance/Measured rail": "unnamed.csv"}, output="unnamed", code=1, says="the file has no column frequency_Hz")


IN_2D = {"Analysis": "receptance"}
BLOCK = {"Rail/Shape": "block", "Rail/Mesh file": "", "Rail/Width": 0.07}


@pytest.mark.parametrize("scene, settings, says", [
    (PLATE, {"Analysis": "receptance", "Receptance/Decay rates": "true", "Rail/Rigid": "true"}, "true: the rail is rigid"),
    (DISCS, {**IN_2D, "Receptance/Decay rates": "true", "Receptance/Directions": "z"}, "take Dimension = 3"),
    (RAIL, {**DECAYS, "Receptance/Lowest frequency": 20, "Receptance/Highest frequency": 90}, "no third octave of 100 Hz to 5 kHz"),
    (RAIL, {"Analysis": "modes", "Rail/Model": "waveguide"}, "has waves in place of modes"),
    (RAIL, {"Rail/Model": "waveguide", "Rail/Hub": "clamped"}, "the rail must lie on springs"),
    (RAIL, {"Rail/Model": "waveguide", **BLOCK}, "not extruded from a section"),
    (PLATE, {"Modes/Maximum frequency": 0}, "Modes/Maximum frequency = 0"),
    (PLATE, {"Body solver": "distributed"}, "Analysis = modes needs the factor"),
    (PLATE, {"Wheel/Rigid": "true"}, "Analysis = modes needs an elastic body"),
    (PLATE, {"Modes/Tolerance": 0.1}, "Modes/Tolerance = 0.1"),
    (RAIL, {"Modes/Cut-off ratio": 0.5}, "Modes/Cut-off ratio = 0.5"),
    (RAIL, {"Receptance/Points": "0, 0, 0"}, "is no named place"),
    (RAIL, {"Receptance/Points": "a: sleeper, 0, 0, 0"}, "names the body sleeper"),
    (RAIL, {"Receptance/Points": "a: rail, 0, 0, 0; a: rail, 1, 0, 0"}, "more than one place with the name a"),
    (RAIL, {"Receptance/Directions": "w"}, '"w" is not x, y or z'),
    (RAIL, {"Receptance/Highest frequency": 10}, "it must be above Lowest frequency"),
    (RAIL, {"Receptance/Check frequencies": 0}, "contains 0; each must be above 0 Hz and at most Highest frequency"),
    (RAIL, {"Receptance/Check frequencies": 3000}, "at most Highest frequency = 2000 Hz"),
    (DISCS, IN_2D, "in 2D nothing moves along y"),
])
def test_refused(program, scene, settings, says):
    program.refuses(scene, says, settings, options=VALIDATE)


@pytest.mark.parametrize("scene, settings, says", [
    ("wheel_modes", {"Wheel/Cells along": 24, "Wheel/Young modulus": 210e3}, "modes lie below 5500 Hz, by inertia, too many"),
    (PLATE, {"Wheel/Model": "harmonic", "Wheel/Shape": "block", "Wheel/Mesh file": ""}, "this is not a body of revolution"),
    (PLATE, {"Wheel/Model": "harmonic", "Wheel/Hub": "elastic", **{f"Wheel/Foundation stiffness {axis}": 1e9 for axis in "xyz"}},
     "its hub must be clamped, free or on an"),
    (PLATE, {"Modes/Maximum frequency": 1, "Wheel/Cells along": 24}, "no body has a mode below"),
    (RAIL, {**SHORT, **DECAYS}, "need 1.95 m from the contact to where Sponge length = 0.6"),
    (RAIL, {**DECAYS, **BLOCK, "Rail/Block length": 3, "Rail/Sponge length": 0, "Receptance/Highest frequency": 200},
     "the rail does not have one section along x"),
    (RAIL, {**SHORT, **WAVES, "Receptance/Points": "far: rail, 0.8, 0, 0"},
     "Rail/Block length = 2 m: with Model = waveguide the mesh must"),
])
def test_what_bodies_cannot_give(program, scene, settings, says):
    run = program(scene, settings, code=1, says=says, output="refused")
    assert not (run / "track_decay.csv").exists() and not (run / "receptances.csv").exists()
