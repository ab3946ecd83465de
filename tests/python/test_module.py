"""The module as it is installed: its stub, its docstrings, interrupts, its end."""

import ast
import contextlib
import inspect
import io
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest

import rolling_contact as rc
from cases import CARTER, PATCH_3D, Case

HOME = pathlib.Path(rc.__file__).parent


def run_python(text, **more):
    return subprocess.run(
        [sys.executable, "-c", text], capture_output=True, text=True, timeout=120, **more
    )


class Stub(Case):
    def test_has_the_names_of_the_module(self):
        tree = ast.parse((HOME / "__init__.pyi").read_text())
        classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
        functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
        others = {name.asname for node in tree.body if isinstance(node, ast.ImportFrom) for name in node.names if name.asname}
        self.assertEqual(set(classes) | functions | others, set(rc.__all__))
        for name, node in classes.items():
            declared = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
            members = vars(getattr(rc, name))
            special = {"__getitem__", "__setitem__", "__enter__", "__exit__", "__getattr__"} & set(members)
            special |= {"_repr_html_", "_repr_svg_"} & set(members)
            if "self: rolling_contact" in (getattr(rc, name).__init__.__doc__ or ""):
                special.add("__init__")
            public = {member for member in members if not member.startswith("_")}
            self.assertEqual(declared, public | special, name)
        self.assertTrue((HOME / "py.typed").exists())

    def test_has_the_names_of_the_references(self):
        tree = ast.parse((HOME / "references.pyi").read_text())
        declared = {node.name: node for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
        self.assertEqual(set(declared), {name for name in vars(rc.references) if not name.startswith("_")})
        for name, node in declared.items():
            it = getattr(rc.references, name)
            self.assertTrue(it.__doc__, name)
            if isinstance(node, ast.ClassDef):
                members = {member for member in vars(it) if not member.startswith("_")}
                self.assertEqual({item.name for item in node.body if isinstance(item, ast.FunctionDef)} - {"__init__"}, members)
            else:
                for argument in node.args.args:
                    self.assertIn(argument.arg + ":", it.__doc__.splitlines()[0])

    def test_has_the_arguments_of_the_module(self):
        tree = ast.parse((HOME / "__init__.pyi").read_text())
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef):
                for item in node.body:
                    if not isinstance(item, ast.FunctionDef) or item.decorator_list:
                        continue
                    member = getattr(getattr(rc, node.name), item.name)
                    arguments = [one.arg for one in item.args.args + item.args.kwonlyargs]
                    if inspect.isfunction(member):
                        if not item.name.startswith("_"):
                            self.assertEqual(set(arguments), set(inspect.signature(member).parameters))
                        continue
                    said = member.__doc__.splitlines()[0]
                    for argument in set(arguments) - {"self"}:
                        self.assertIn(argument + ":", said)

    def test_everything_has_a_docstring(self):
        for name in rc.__all__:
            it = getattr(rc, name)
            self.assertTrue(it.__doc__, name)
            if inspect.isclass(it):
                for member, value in vars(it).items():
                    if not member.startswith("_"):
                        self.assertTrue(value.__doc__, f"{name}.{member}")


class Process(Case):
    def test_is_silent_unless_told(self):
        for verbosity, silent in (("quiet", True), ("normal", False)):
            text = (
                "import rolling_contact as rc\n"
                f"s = rc.Session({PATCH_3D!r}, verbosity={verbosity!r})\n"
                "s['Contact/Creepage x'] = 0.002\ns.solve()"
            )
            done = run_python(text)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stderr, "")
            self.assertEqual(done.stdout == "", silent)

    def test_is_interrupted_by_control_c(self):
        """In a loop of solves; whatever the handler raises comes out of them."""
        text = (
            "import rolling_contact as rc, signal, sys\n"
            f"s = rc.Session({PATCH_3D!r})\n"
            "s.solve(); print('ready', flush=True)\n"
            "try:\n"
            "    while True: s['Mesh/Growth'] = 0.8; s.solve()\n"
            "except KeyboardInterrupt:\n"
            "    print('interrupted', flush=True)\n"
            "s['Contact/Creepage x'] = 0.002\n"
            "print(s.solve().converged)\n"
        )
        with subprocess.Popen([sys.executable, "-c", text], stdout=subprocess.PIPE, text=True) as child:
            self.assertEqual(child.stdout.readline(), "ready\n")
            time.sleep(0.3)
            child.send_signal(signal.SIGINT)
            rest = child.communicate(timeout=60)[0]
        self.assertEqual(rest, "interrupted\nTrue\n")
        self.assertEqual(child.returncode, 0)

    def test_is_interrupted_inside_one_solve(self):
        class Late(Exception):
            pass

        def raise_late(*_):
            raise Late

        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            session = rc.Session(PATCH_3D, {"Mesh/Elements across patch": 12}, verbosity="normal")
        session.solve()
        session.set({"Contact/Creepage x": 0, "Contact/Creepage y": 0, "Contact/Spin": 0})
        session.set({"Contact/Longitudinal force": -5e3, "Contact/Lateral force": 6e3})
        before_it = said.getvalue()
        before = signal.signal(signal.SIGALRM, raise_late)
        try:
            signal.setitimer(signal.ITIMER_REAL, 0.005)
            with self.assertRaises(Late):
                session.solve()
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)
        self.assertEqual(said.getvalue(), before_it)  # a solve says its end
        state = session.solve()
        self.assert_close(state.force_y, 6e3, 1e-7)
        self.assertNotEqual(said.getvalue(), before_it)

    def test_ends_well_with_sessions_left(self):
        done = run_python(
            "import rolling_contact as rc\n"
            f"s = rc.Session({str(CARTER)!r}, {{'Mesh/Elements across patch': 12}}); s.solve()"
        )
        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
