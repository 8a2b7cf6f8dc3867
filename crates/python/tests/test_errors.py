"""Errors are exceptions in the words of the command; Ctrl-C and a limit of memory stop a run."""

import os
import signal
import subprocess
import sys
import threading
import time

import pytest

import drillstring as ds

LONG = {
    "base": "sweeps/academic.toml",
    "bit": {"rock": "sandstone"},
    "methods": ["held"],
    "design": {
        "kind": "monte-carlo",
        "cases": 3_000_000,
        "axes": {
            "surface_speed_rpm": {"from": 0.1, "to": 0.4},
            "weight_on_bit_kn": {"from": 20, "to": 80},
        },
    },
}


def test_a_file_is_refused_in_the_words_of_the_command(command, tmp_path):
    file = tmp_path / "wrong.toml"
    file.write_text(f'base = "{os.getcwd()}/sweeps/fig09.toml"\n\n[bit]\nrock = "sandstne"\n')
    with pytest.raises(ds.SweepFileError) as raised:
        ds.Sweep.read(file)
    error = raised.value
    assert (error.file, error.line, error.key) == (str(file), 4, "bit.rock")
    assert isinstance(error, ds.DrillstringError)
    message = command("run", file, code=2).stderr
    assert str(error) in message
    assert error.message in message


def test_a_table_is_refused_by_its_key_and_no_line():
    with pytest.raises(ds.SweepFileError, match="sweep.toml: `time_s`: ") as raised:
        ds.Sweep.from_dict({"base": "sweeps/fig09.toml", "time_s": -1})
    assert raised.value.line is None
    assert raised.value.key == "time_s"


def test_an_unknown_case_method_or_axis_is_refused():
    sweep = ds.Sweep.read("sweeps/fig09.toml")
    for ask, words in [
        (lambda: sweep.simulate(500), "case 500: there are cases 0 to 499"),
        (lambda: sweep.values(500), "case 500"),
        (lambda: sweep.simulate(method="held"), "not one of the sweep's methods"),
        (lambda: sweep.simulate(set={"surface_speed": 1}), "did you mean `surface_speed_rpm`"),
        (lambda: sweep.simulate(set={"friction": 1}), "friction: "),
        (lambda: sweep.run(threads=0), "threads 0"),
        (lambda: sweep.run(memory="8 parsecs"), "is not an amount of memory"),
        (lambda: ds.Sweep.read("sweeps/fig09.toml", methods=["hold"]), "unknown method"),
    ]:
        with pytest.raises(ds.DrillstringError, match=words):
            ask()


def test_an_accuracy_that_cannot_be_had_is_refused():
    text = 'base = "sweeps/fig09.toml"\naccuracy = "1e-9 %"\n'
    with pytest.raises(ds.SweepFileError, match="`accuracy`: "):
        ds.Sweep.from_toml(text, folder=".")


def test_an_invalid_string_is_refused():
    steel = ds.Material()
    with pytest.raises(ds.DrillstringError, match="internal radius < external radius"):
        ds.Drillstring([ds.Section([ds.Tube(10, 0.1, 0.05)])], material=steel, torsional_damping=1)


def test_a_method_that_chatters_is_refused_and_allowed_with_a_warning():
    sweep = ds.Sweep.from_dict(
        {
            "base": "sweeps/academic.toml",
            "bit": {"torque_dynamic_nm": 2000},
            "surface_speed_rpm": 0.3,
            "methods": ["trapezoidal"],
        }
    )
    with pytest.raises(ds.SweepFileError, match="not positive-real"):
        sweep.run()
    with pytest.warns(ds.DrillstringWarning, match="not positive-real") as warned:
        assert sweep.run(allow_unstable=True).rows == 1
    assert {warning.filename for warning in warned} == {__file__}


def test_what_takes_too_much_memory_is_refused_before_it_is_taken():
    sweep = ds.Sweep.from_dict(LONG)
    with pytest.raises(ds.SweepFileError, match="of memory, more than 500 MiB"):
        sweep.run(memory="500M")
    with pytest.raises(ds.SweepFileError, match="of memory, more than 1 MiB"):
        sweep.simulate(memory="1M")


def test_ctrl_c_ends_a_run_within_a_second():
    sweep = ds.Sweep.from_dict(LONG)
    sent = []

    def interrupt():
        sent.append(time.monotonic())
        os.kill(os.getpid(), signal.SIGINT)

    # What is started in the background of a shell ignores the signal.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        threading.Timer(2.0, interrupt).start()
        with pytest.raises(KeyboardInterrupt):
            sweep.run(memory="64G")
    finally:
        signal.signal(signal.SIGINT, before)
    assert time.monotonic() - sent[0] < 1.0


def test_what_progress_raises_ends_a_run():
    calls = []

    def progress(done, total):
        calls.append((done, total))
        if done > 100:
            raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        ds.Sweep.from_dict(LONG).run(progress=progress, memory="64G")
    assert calls[-1][0] > 100
    assert {total for _, total in calls} <= {0, 3_000_000}


DAEMON = """
import threading, time
import drillstring as ds

sweep = ds.Sweep.read("sweeps/fig08b.toml")

def look(done, total):
    sum(range(10**6))

def work():
    while True:
        sweep.run(progress={progress})

threading.Thread(target=work, daemon=True).start()
time.sleep(0.5)
"""


@pytest.mark.parametrize("progress", ["None", "look"])
def test_an_interpreter_exits_while_a_daemon_thread_is_in_the_package(progress):
    """It was ended by a signal: most often without a function of Python, now and then within one."""
    for _ in range(5):
        program = [sys.executable, "-c", DAEMON.format(progress=progress)]
        ended = subprocess.run(program, capture_output=True, text=True, timeout=60)
        assert (ended.returncode, ended.stderr) == (0, "")
