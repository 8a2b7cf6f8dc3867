"""The JSON Schema of sweep files, which `sweep schema` prints, against shipped files and wrong
ones; by a validator that shares no code with the program."""

import json
import sys
from pathlib import Path

import jsonschema
import pytest

from conftest import ROOT

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

# As the tests of the command have it.
SMALL = (ROOT / "tests" / "support" / "small.toml").read_text()


@pytest.fixture(scope="module")
def schema(command):
    return json.loads(command("schema").stdout)


@pytest.fixture(scope="module")
def faults(schema):
    kind = jsonschema.Draft202012Validator
    kind.check_schema(schema)
    validator = kind(schema)

    def of_text(text):
        return [error.message for error in validator.iter_errors(tomllib.loads(text))]

    return of_text


def with_piece(piece, replacement):
    assert SMALL.count(piece) == 1, piece
    return SMALL.replace(piece, replacement)


def test_every_shipped_sweep_is_one_by_the_schema(faults):
    files = sorted(Path("sweeps").glob("*.toml"))
    assert len(files) > 30
    for file in files:
        assert faults(file.read_text()) == [], file


def test_the_file_of_sweep_new_is_one_by_the_schema(command, faults, tmp_path):
    command("new", tmp_path / "my-sweep.toml")
    assert faults((tmp_path / "my-sweep.toml").read_text()) == []


@pytest.mark.parametrize(
    ("piece", "replacement"),
    [
        # Misspelt keys and choices, also of an axis.
        ("title =", "titel ="),
        ("repeat =", "repeats ="),
        ('rock = "sandstone"', 'rock = "sand"'),
        ('methods = ["quadrature"]', 'methods = ["quadratur"]'),
        ("weight_on_bit_kn = { values", "weight_on_bit = { values"),
        ("surface_speed_rpm = { from", "site_00_friction = { from"),
        # A unit that the key has not, and a quantity in two units.
        ("shear_modulus_gpa = 80", "shear_modulus_mpa = 80e3"),
        ("{ length_m = 9.5,", "{ length_m = 9.5, length_ft = 31,"),
        # Out of range, another kind of value, missing.
        ("shear_modulus_gpa = 80", "shear_modulus_gpa = 80e9"),
        ("time_s = 12", 'time_s = "long"'),
        ("repeat = 10\n", ""),
        ("shear_modulus_gpa = 80\n", ""),
        ('kind = "grid"', ""),
        # Two keys that say the same.
        ('methods = ["quadrature"]', 'accuracy = "1 %"\nmethods = ["held"]'),
    ],
)
def test_what_the_program_refuses_an_editor_underlines(faults, piece, replacement):
    assert faults(SMALL) == []
    assert faults(with_piece(piece, replacement)) != []


@pytest.mark.parametrize(
    "text",
    [
        'base = "other.toml"\n[string]\nshear_modulus_gpa = 75\n',
        'base = "other.toml"\n[string]\nfile = "bha.csv"\n',
        with_piece("shear_modulus_gpa = 80", "shear_modulus_psi = 11.6e6"),
        with_piece("{ length_m = 9.5,", "{ length_ft = 31,"),
        with_piece("outer_radius_m = 0.125", "outer_diameter_in = 9.84"),
        with_piece("weight_on_bit_kn = { values", "weight_on_bit_klbf = { values"),
        with_piece("surface_speed_rpm = { from", "section_0_part_1_outer_diameter_in = { from"),
        with_piece("time_s = 12", 'time_s = "auto"'),
        with_piece('methods = ["quadrature"]\n', "").replace(
            "sampling_frequency_hz = 100", 'accuracy = "1.5 %"'
        ),
    ],
)
def test_what_the_program_reads_is_one_by_the_schema(faults, text):
    assert faults(text) == []
