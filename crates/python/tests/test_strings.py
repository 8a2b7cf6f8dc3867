"""Responses, modes and user-defined laws, against independent results."""

import math

import numpy as np
import pytest

import drillstring as ds

STEEL = ds.Material(shear_modulus=80e9, density=7850)
UNIFORM = [ds.Section([ds.Tube(10, 0.05, 0.1)], repeat=50)]
BENDING = ds.Bending(damping=2000)


@pytest.fixture(scope="module")
def string():
    return ds.Drillstring(UNIFORM, material=STEEL, torsional_damping=1)


def test_torsional_modes_are_those_of_a_uniform_rod(string):
    # Held above and free below: odd quarters of a wave.
    modes = string.torsional_modes(4, depths=101)
    quarter = math.sqrt(80e9 / 7850) / (4 * 500)
    assert np.allclose(modes.frequencies, quarter * np.array([1, 3, 5, 7]), rtol=1e-9)
    wave = np.sin(math.pi / 2 * modes.depths / 500)
    assert np.allclose(np.abs(modes.shapes[0]), wave, atol=1e-6)
    assert (modes.damping_ratios > 0).all()
    assert string.bending_modes(2, bending=BENDING).damping_ratios is None


@pytest.mark.parametrize("method", ["held", "quadrature", "finite-element"])
def test_taps_have_the_exact_frequency_response(string, method):
    responses = string.responses(method, longest_time=60, sampling_frequency=2000)
    frequency = 1.0
    exact, from_torque = string.torsion_response([frequency])
    assert exact.shape == (1, 1) and from_torque.shape == (1, 1, 1)
    taps = responses.from_surface[0]
    steps = np.arange(len(taps)) / 2000
    found = (taps * np.exp(-2j * math.pi * frequency * steps)).sum()
    # By `held` motion is the mean over a step.
    assert abs(abs(found) - abs(exact[0, 0])) < 0.01 * abs(exact[0, 0])
    assert responses.torsion_margin > -1e-3
    assert responses.bending_margin is None


def test_a_receptance_is_the_same_both_ways(string):
    receptance = string.bending_response([0.5, 2.0], bending=BENDING, sites=[100.0, 0.0])
    assert receptance.shape == (2, 2, 2)
    assert np.allclose(receptance[:, 0, 1], receptance[:, 1, 0], rtol=1e-9)


def coulomb(torque):
    """Coulomb's friction as a function: what holds the bit, or as much against it."""

    def law(time, free_speed, compliance):
        return max(-torque, min(torque, -free_speed / compliance))

    return law


def test_a_law_of_python_is_the_built_in_one_where_they_are_the_same(string):
    responses = string.responses(longest_time=10)
    own = responses.simulate(2.0, 10, bit=coulomb(1000.0))
    built_in = responses.simulate(2.0, 10, bit=ds.BitTorque(1000.0, 1000.0))
    assert np.allclose(own.bit_speed, built_in.bit_speed, atol=1e-9)
    assert own.bit_speed[-1] == pytest.approx(2.0, rel=0.05)
    assert own.bit_torque.min() == -1000.0


def test_a_motion_of_a_sweep_is_that_of_its_responses():
    sweep = ds.Sweep.read("sweeps/fig08b.toml", methods=["quadrature"])
    law = ds.BitTorque(4800.0, 4000.0)
    speed = 0.1 * math.tau / 60
    stepped = sweep.responses().simulate(speed, 40, bit=law)
    assert np.allclose(stepped.bit_speed, sweep.simulate().motion.bit_speed, atol=1e-8)


def test_a_string_carries_an_eccentric_mass():
    """A collar clamped at its top, at 2.3 times its first critical speed in bending."""
    collar = ds.Drillstring(
        [ds.Section([ds.Tube(19, 0.0357, 0.1016)])], material=STEEL, torsional_damping=0.5
    )
    bending = ds.Bending(youngs_modulus=206.8e9, damping=500, support="clamped")
    wall = ds.Wall(clearance=0.5, friction=0.2, radius=0.1, stiffness=1e9)
    mass = ds.EccentricMass(mass=100, offset=0.02)
    speed = math.tau
    bare = collar.bending_response([speed / math.tau], bending=bending)[0, 0, 0]
    pull = mass.mass * speed**2
    exact = abs(bare * pull * mass.offset / (1 - bare * pull))
    radii = []
    for masses in [[mass.mass], None]:
        responses = collar.responses(
            "quadrature", longest_time=30, bending=bending, sampling_frequency=500, masses=masses
        )
        motion = responses.simulate(speed, 30, walls=[wall], eccentric_masses=[mass])
        radii.append(np.hypot(*motion.positions.reshape(-1, 2)[-1]))
    assert radii[0] == pytest.approx(exact, rel=0.01)
    assert radii[1] > 1.1 * exact
    with pytest.raises(ds.DrillstringError, match="masses"):
        collar.responses(longest_time=1, bending=bending, masses=[1, 2])


def test_a_table_of_one_row_is_the_built_in_law_to_the_last_bit(string):
    responses = string.responses(longest_time=40)
    table = ds.TabulatedFriction([0.0], [1000.0], torque_static=1200.0)
    built_in = ds.BitTorque(1200.0, 1000.0)
    for speed in [0.01, 2.0]:
        motions = [responses.simulate(speed, 40, bit=law) for law in [table, built_in]]
        assert np.array_equal(motions[0].bit_speed, motions[1].bit_speed)
        outcomes = [
            responses.regimes(speed, 40, closing_window=10, bit=law) for law in [table, built_in]
        ]
        assert outcomes[0].torsion == outcomes[1].torsion
        assert outcomes[0].measures == outcomes[1].measures
        assert outcomes[0].ended == outcomes[1].ended != "end"
    assert outcomes[0].lateral is None


def test_regimes_are_those_of_the_sweep():
    sweep = ds.Sweep.read("sweeps/fig09.toml", methods=["quadrature"])
    table, responses = sweep.run(), sweep.responses()
    duration = responses.longest_time
    for case in [0, 499]:
        torque = table["torque_dynamic_nm"][case]
        speed = table["surface_speed_rpm"][case] * math.tau / 60
        outcome = responses.regimes(
            speed, duration, closing_window=duration / 3, bit=ds.BitTorque(torque, torque)
        )
        assert outcome.torsion == table["torsion"][case]


def test_smooth_rotation_is_at_the_torque_of_the_law(string):
    def torque(speed):
        return 500.0 + 100.0 * math.exp(-speed) + 50.0 * speed

    law = ds.TabulatedFriction.sampled(torque, 20.0, 2000)
    responses = string.responses(longest_time=60)
    outcome = responses.regimes(6.0, 60, closing_window=5, bit=law)
    assert outcome.torsion == "smooth"
    motion = responses.simulate(6.0, 60, bit=law)
    assert motion.bit_torque[-1] == pytest.approx(-torque(motion.bit_speed[-1]), rel=1e-6)
    # Of Python, called in every step, it is the same regime, stepped to the end.
    own = responses.regimes(6.0, 60, closing_window=5, bit=coulomb(1000.0))
    assert (own.torsion, own.ended) == ("smooth", "end")


def test_what_is_no_table_is_refused(string):
    responses = string.responses(longest_time=10)
    for speeds, torques, words in [
        ([0.0, 1.0], [1.0], "one torque for each speed"),
        ([0.1], [1.0], "must be zero"),
        ([0.0, 0.0], [1.0, 1.0], "larger than the one before"),
        ([], [], "static torque"),
    ]:
        with pytest.raises(ds.DrillstringError, match=words):
            responses.simulate(1.0, 10, bit=ds.TabulatedFriction(speeds, torques))


def test_what_a_law_raises_is_raised_as_it_is(string):
    responses = string.responses(longest_time=10)

    def law(time, free_speed, compliance):
        if time > 1:
            raise ZeroDivisionError("at last")
        return 0.0

    with pytest.raises(ZeroDivisionError, match="at last"):
        responses.simulate(2.0, 10, bit=law)
    with pytest.raises(TypeError):
        responses.simulate(2.0, 10, bit=lambda *_: "much")
    with pytest.raises(ds.DrillstringError, match="is not finite"):
        responses.simulate(2.0, 10, bit=lambda *_: math.inf)


class Rubber:
    """A wall that is a linear spring with a damper, without friction."""

    clearance, radius = 0.015, 0.1

    def __init__(self, stiffness, damping):
        self.stiffness, self.damping = stiffness, damping

    def force(self, approach):
        x, y = approach.free_position
        distance = math.hypot(x, y)
        if distance <= self.clearance:
            return None
        damping = self.damping * approach.rate
        push = self.stiffness * (distance - self.clearance)
        push += damping * (distance - math.hypot(*approach.previous_position))
        force = max(0.0, push / (1 + approach.compliance * (self.stiffness + damping)))
        return (-force * x / distance, -force * y / distance, 0.0)


def test_a_wall_of_python_holds_the_string(string):
    responses = string.responses("quadrature", longest_time=3, bending=BENDING)
    impulse = ds.Impulse(amount=1000, start=1)
    motion = responses.simulate(6.0, 3, walls=[Rubber(1e7, 1e4)], impulses=[impulse])
    distance = np.hypot(motion.positions[0, :, 0], motion.positions[0, :, 1])
    assert motion.touches.any()
    assert 0.015 < distance.max() < 0.03
    # Where it touches, the force is along the radius and pushes inwards.
    pushed = motion.normal_forces[0] > 0
    assert np.allclose(
        np.hypot(*motion.wall_forces[0, pushed].T), motion.normal_forces[0, pushed]
    )
    without = responses.simulate(6.0, 3, walls=[ds.Wall(1.0, 0.0, 0.1)], impulses=[impulse])
    free = np.hypot(without.positions[0, :, 0], without.positions[0, :, 1])
    assert free.max() > 1.5 * distance.max()


@pytest.mark.parametrize("answer", [(math.nan, 0.0, 0.0), (0.0, math.inf, 0.0), (0.0, 0.0, math.nan)])
def test_a_wall_that_answers_no_number_ends_the_motion(string, answer):
    responses = string.responses("quadrature", longest_time=3, bending=BENDING)

    class Broken(Rubber):
        def force(self, approach):
            return answer

    with pytest.raises(ds.DrillstringError):
        responses.simulate(6.0, 3, walls=[Broken(1e7, 1e4)])


@pytest.mark.parametrize("clearance", [math.nan, -0.01, math.inf])
def test_a_wall_without_a_place_is_refused(string, clearance):
    responses = string.responses("quadrature", longest_time=3, bending=BENDING)
    wall = Rubber(1e7, 1e4)
    wall.clearance = clearance
    with pytest.raises(ds.DrillstringError, match="clearance"):
        responses.simulate(6.0, 3, walls=[wall])


def test_what_would_take_all_memory_is_refused(string):
    with pytest.raises(ds.DrillstringError, match="limit|too long|taps|more than the 500"):
        string.responses(longest_time=100, sites=list(np.linspace(0, 99, 5000)), bending=BENDING)
    with pytest.raises(ds.DrillstringError, match="limit|too long|taps|more than the 500"):
        string.responses(longest_time=100, sampling_frequency=1e9)
    with pytest.raises(ds.DrillstringError, match="limit"):
        string.torsional_modes(3, depths=10**9)
    with pytest.raises(ds.DrillstringError, match="limit"):
        string.torsion_response(np.linspace(1, 2, 10**5), sites=list(np.linspace(0, 99, 500)))


def test_an_impulse_without_a_wall_is_refused(string):
    responses = string.responses(longest_time=3)
    with pytest.raises(ds.DrillstringError, match="need walls"):
        responses.simulate(6.0, 3, impulses=[ds.Impulse(amount=1000)])


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf])
def test_frequencies_without_a_response_are_refused_by_their_place(value):
    string = ds.Sweep.read("sweeps/fig08b.toml").string
    for ask, allowed in [
        (string.torsion_response, 0.0),
        (lambda frequencies: string.bending_response(frequencies, bending=ds.Bending()), 1e-3),
    ]:
        with pytest.raises(ValueError, match=r"`frequencies\[1\]` is .*finite number of Hz"):
            ask([1.0, value])
        assert np.isfinite(ask([allowed])[0]).all()
    with pytest.raises(ds.DrillstringError, match="other than zero"):
        string.bending_response([0.0], bending=ds.Bending())


def test_more_sites_than_responses_are_built_for_are_refused_at_once():
    string = ds.Sweep.read("sweeps/fig08b.toml").string
    sites = np.linspace(0, 0.9 * string.length, 2000)
    with pytest.raises(ds.DrillstringError, match="2000 sites are more than the 500"):
        string.responses(longest_time=1, sites=sites)
