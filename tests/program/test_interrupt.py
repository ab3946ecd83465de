"""A curve that is interrupted keeps the rows done; a table whose terminal is
closed ends as well, says how to go on, and does; nohup keeps it running."""

import signal

from conftest import QUICK, RESUME


def test_a_curve_that_is_interrupted_keeps_its_rows(program):
    """There is nothing to resume, and nothing is promised."""
    run = program.start("carter_2d_partial_slip", QUICK, {"Analysis": "creep curve", "Creep curve/Creepage x": "0 : 0.008 : 1000000"})
    run.wait_for_rows(2)
    run.send(signal.SIGINT)
    done = run.end()
    assert done.code == 2, done
    assert done.json["status"] == "interrupted"
    assert len(done.results) > 1
    assert "--resume" not in done.out + done.err


def begin_table(program, hangup, options=()):
    """A table that has its first rows, with SIGHUP at its default or ignored."""
    run = program.start("table_3d", {"Mesh/Elements across patch": 6, "Table/Axis 2": "Contact/Creepage x = -0.006 : 0.006 : 13"},
                        output="table", options=options, before=["env", f"--{hangup}-signal=HUP"])
    run.wait_for_rows(2)
    return run


def test_a_table_whose_terminal_is_closed_goes_on_when_resumed(program):
    run = begin_table(program, "default")
    run.send(signal.SIGHUP)
    done = run.end()
    assert done.code == 2 and "as its terminal was closed (SIGHUP" in done.messages, done
    assert done.json["status"] == "interrupted"
    assert "The same command with --resume goes on from here." in done.out
    done = begin_table(program, "default", RESUME).end()
    assert done.code == 0 and len(done.results) == 208, done


def test_nohup_keeps_a_table_running(program):
    run = begin_table(program, "ignore")
    run.send(signal.SIGHUP)
    done = run.end()
    assert done.code == 0 and len(done.results) == 208, done
