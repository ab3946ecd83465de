"""Surfaces that pass through: scenes, spectra, files, resumed runs, ranks."""

import math
import re
import shutil

import pytest
from conftest import LIGHT, QUICK, QUIET, RESUME, VALIDATE, same_files

SCENE, DISCS = "corrugation_2d", "carter_2d_partial_slip"
# a waved rail without inertia: 0.9 mm a step, 30 steps a wave; there are 11 waves
RECORD = [(0.25 * i, 5 * math.cos(2 * math.pi * 0.25 * i / 27) + 2 * math.cos(2 * math.pi * 0.25 * i / 0.75)) for i in range(1188)]
WAVED = {**LIGHT, "Time/Inertia": "false", "Surfaces/Position unit": "1e-3", "Surfaces/Height unit": "1e-6",
         "Surfaces/Position": 0.0135, "Time/Time step": "45e-6", "Time/Rolled distance": 0.243, "Spectrum/Skipped time": 0,
         "Spectrum/Segment length": "8.1e-3"}


def write_record(path, change=lambda line: line):
    """A record of the rail, with lines that differ or are left out."""
    lines = [change(f"{x}, {height:.6f}") for x, height in RECORD]
    path.write_text("".join(f"{line}\n" for line in lines if line is not None))
    return path


@pytest.fixture
def waved(program):
    """Settings of the waved rail."""
    return {**WAVED, "Surfaces/Rail height": write_record(program.folder / "rail.csv")}


@pytest.fixture(scope="module")
def whole(shared):
    return shared(SCENE, WAVED, {"Surfaces/Rail height": write_record(shared.folder / "rail.csv"), "Output/Verbosity": "normal"},
                  output="whole")


def test_what_is_filtered_and_taken_out_is_said(whole):
    assert re.search(r"rms 3.8. um about a mean of .* waves shorter than 3\.[0-9]* mm fade", whole.screen), whole
    assert re.search("rms 1.41 um is taken out", whole.screen), whole
    for file in ("history.csv", "history.svg", "spectrum.csv", "third_octaves.csv", "spectrum.svg"):
        assert (whole / file).stat().st_size, file


def test_crests_press(whole):
    """Position lies in a trough: step 15, half a wave on, in a crest."""
    history = whole.table("history.csv")
    at = {step: k for k, step in enumerate(history["step"])}
    heights, loads = history["surface_height_m"], history["normal_force_N"]
    assert 4.99e-6 <= heights[at[15]] <= 5.01e-6 and -5.01e-6 <= heights[at[30]] <= -4.99e-6
    assert int(loads[at[15]]) > int(loads[at[30]])


def test_the_spectrum_of_a_tone(whole):
    """On line 6 of 180 steps in 8.1 ms, of (5 um)^2 / 2."""
    spectrum, loads = whole.table("spectrum.csv"), whole.table("history.csv")["normal_force_N"]
    frequency, density, heights = spectrum["frequency_Hz"], spectrum["normal_force_psd_N2/Hz"], spectrum["surface_height_psd_m2/Hz"]
    step = frequency[1] - frequency[0]
    assert 740.7 <= frequency[density.index(max(density))] <= 740.8
    assert 12.49 <= sum(heights) * step * 1e12 <= 12.51
    assert 0.02699 <= spectrum["wavelength_m"][6] <= 0.02701
    # densities of N sum up to its mean square under the window of Hann
    assert len(loads) == 270
    mean = sum(loads) / 270
    window = [(1 - math.cos(2 * math.pi * j / 180)) / 2 for j in range(180)]
    under = sum((w * (load - mean)) ** 2 for first in (0, 90) for w, load in zip(window, loads[first:]))
    squares = 2 * sum(w * w for w in window)
    assert under / squares == pytest.approx(sum(density) * step, rel=1e-6)


def test_the_third_octave_of_a_tone(program):
    """Of 5 um, (5 um)^2 / 2 re (1 um)^2, and what it makes of N and T."""
    run = program(SCENE, LIGHT)
    bands, spectrum = run.table("third_octaves.csv"), run.table("spectrum.csv")
    (band,) = [k for k, f in enumerate(bands["centre_frequency_Hz"]) if 630 < f < 632]
    lines = [k for k, f in enumerate(spectrum["frequency_Hz"]) if 630 < f < 700]
    step = spectrum["frequency_Hz"][1] - spectrum["frequency_Hz"][0]
    assert 10.968 <= bands["surface_height_dB_re_1um"][band] <= 10.970
    for force, tolerance in (("normal_force", 0.001), ("force_x", 0.2)):
        density = spectrum[f"{force}_psd_N2/Hz"]
        level = 10 * math.log10(sum(density[k] for k in lines) * step)
        assert abs(bands[f"{force}_dB_re_1N"][band] - level) <= tolerance, force


def test_roughness_in_3d_has_bands_of_the_lateral_force(program):
    run = program("rail_roughness_3d", QUIET, {"Mesh/Elements across patch": 8, "Time/Rolled distance": 0.064,
                                               "Spectrum/Segment length": "1.6e-3"})
    assert "force_y_dB_re_1N" in run.table("third_octaves.csv")


def test_a_resumed_run_goes_on_over_the_same_record(program, waved, whole):
    program(SCENE, waved, {"Time/Rolled distance": 0.09, "Spectrum/Segment length": 0}, output="half")
    write_record(waved["Surfaces/Rail height"], lambda line: "0.5, 1" if line.startswith("0.5, ") else line)
    program(SCENE, waved, output="half", options=RESUME, code=1, says="Surfaces/Rail height (record)")
    write_record(waved["Surfaces/Rail height"])
    same_files(program(SCENE, waved, output="half", options=RESUME), whole, "history.csv", "spectrum.csv")


def test_a_snapshot_is_the_state_of_the_roughness_that_lies_there(program):
    state = (SCENE, LIGHT, {"Analysis": "quasi-static"})
    snapshot = program(*state, {"Surfaces/Rail height": "5e-6*sin(2*pi*x/0.03)", "Surfaces/Position": "4e-3"}, output="snapshot")
    roughness = program(*state, {"Surfaces/Rail height": "", "Contact/Roughness": "-5e-6*sin(2*pi*(x-4e-3)/0.03)"}, output="roughness")
    assert snapshot.results.texts("force_x_N") == roughness.results.texts("force_x_N")


def test_a_flat_takes_load_off_when_it_comes(program, waved):
    """One of 30 um that passes once in 0.3 m, with heights of 1e-310 m around it."""
    history = program(SCENE, waved, {"Surfaces/Rail height": "", "Surfaces/Wheel height": "-30e-6*exp(-((x+0.12)/0.0045)^2)",
                                     "Surfaces/Position": 0}).table("history.csv")
    loads = history["normal_force_N"]
    assert 0.115 < history["rolled_m"][loads.index(min(loads))] < 0.125
    assert min(loads) < 0.95 * max(loads)


@pytest.mark.skipif(not shutil.which("mpirun"), reason="no mpirun")
def test_distributed_bodies_on_two_ranks_have_the_same_load(program, waved, whole):
    run = program(SCENE, waved, {"Body solver": "distributed", "Spectrum/Write": "never", "Time/Rolled distance": 0.0135}, ranks=2)
    loads = run.table("history.csv")["normal_force_N"]
    assert len(loads) == 15
    assert loads == pytest.approx(whole.table("history.csv")["normal_force_N"][:15], rel=1e-6)


def test_a_spectrum_without_a_surface(program):
    run = program("start_up_2d", LIGHT, {"Time/Rolled distance": 0.04, "Spectrum/Write": "always"})
    spectrum = run.table("spectrum.csv")
    assert len(spectrum) and not any("surface" in column for column in spectrum.columns)


def test_a_short_run_has_no_spectrum(program, waved):
    run = program(SCENE, waved, {"Spectrum/Segment length": 0, "Time/Rolled distance": "9e-3"})
    assert not (run / "spectrum.csv").exists()


def test_warnings(program, waved):
    program(SCENE, waved, {"Spectrum/Skipped time": 0.01}, options=VALIDATE, says="There will be no spectra")
    program(SCENE, waved, {"Time/Time step": "450e-6", "Spectrum/Write": "never"}, says="A step rolls 9 mm")
    program(DISCS, QUICK, {"Surfaces/Position": 1}, options=VALIDATE, says="Surfaces/Position = 1 has no effect")
    run = program(DISCS, QUICK, {"Surfaces/Friction share": "if(sin(100*x)<0,0.5,1)", "Surfaces/Position": 0.01}, options=VALIDATE)
    assert not run.err, "a place of shares of friction is read"


@pytest.mark.parametrize("options", [(), VALIDATE], ids=["run", "validated"])
@pytest.mark.parametrize("says, settings", [
    ("Skipped time = 0.01 s", {"Spectrum/Skipped time": 0.01, "Spectrum/Write": "always"}),
    ("there is no such file", {"Surfaces/Rail height": "/none.csv"}),
    ("Surfaces/Height unit", {"Surfaces/Height unit": 1}),  # heights in metres
    ("Surfaces/Position unit", {"Surfaces/Position unit": 1}),
    ("Surfaces/Height unit = 0", {"Surfaces/Height unit": 0}),
    ("the wheel rolls from 0.1 to", {"Surfaces/Position": 0.1}),  # beyond the record
    ("in 2D there is no y", {"Surfaces/Rail height": "1e-6*cos(x+y)"}),
    ("waves shorter than two elements", {"Surfaces/Wheel height": "1e-6*cos(2*pi*x/1e-3)"}),
    ("decimals take a point", {"Surfaces/Wheel height": "0,5e-6*cos(x)"}),
    ("Analysis = accuracy study", {"Analysis": "accuracy study"}),
])
def test_refused(program, waved, says, settings, options):
    program.refuses(SCENE, says, waved, settings, options=options)


@pytest.mark.parametrize("options", [(), VALIDATE], ids=["run", "validated"])
@pytest.mark.parametrize("says, change", [
    ('line 31: "7.5, nan" has no finite', lambda line: "7.5, nan" if line.startswith("7.5, ") else line),
    ("line 13: a gap: 0.00325 m", lambda line: None if re.match(r"[3-5]\.[0-9]*, ", line) else line),
], ids=["nan", "gap"])
def test_records_that_are_refused(program, waved, says, change, options):
    write_record(waved["Surfaces/Rail height"], change)
    program.refuses(SCENE, says, waved, options=options)
