"""Every public name has a docstring and a stub, and the stub has the same parameters; importing is light."""

import ast
import pathlib
import subprocess
import sys
import unittest

import support  # skips where numpy is missing

import suffuse


def public(owner):
    return sorted(name for name in vars(owner) if not name.startswith("_"))


def stubs():
    """The stub's functions and classes by their names."""
    text = (pathlib.Path(suffuse.__file__).parent / "__init__.pyi").read_text("utf-8")
    return {node.name: node for node in ast.parse(text).body if isinstance(node, (ast.FunctionDef, ast.ClassDef))}


def members(name):
    """The members of a class, of those that it is made of, too."""
    found = {}
    for part in reversed(getattr(suffuse, name).__mro__):
        if part.__module__.startswith("suffuse"):
            found.update({key: value for key, value in vars(part).items() if not key.startswith("_")})
    return found


CLASSES = ("Painting", "Renderer", "Frames", "DifferentiablePicture", "Step", "Document")


class Stubs(unittest.TestCase):
    def test_all_is_all(self):
        mine = {name for name in public(suffuse)}
        self.assertEqual(sorted(suffuse.__all__), sorted(mine))

    def test_every_public_name_has_a_docstring_and_a_stub(self):
        known = stubs()
        for name in suffuse.__all__:
            value = getattr(suffuse, name)
            self.assertGreater(len(value.__doc__ or ""), 20, name)
            self.assertIn(name, known)
        self.assertEqual(sorted(known), sorted(suffuse.__all__))
        for name in CLASSES:
            typed = {node.name for node in known[name].body if isinstance(node, ast.FunctionDef)}
            for member, value in members(name).items():
                self.assertGreater(len(value.__doc__ or ""), 15, f"{name}.{member}")
                self.assertIn(member, typed, name)
            for member in typed:
                self.assertTrue(hasattr(getattr(suffuse, name), member), f"{name}.{member}")

    def test_stubs_name_the_parameters(self):
        """What pybind11 says about its arguments, where one is wrong, against the stub."""
        known = stubs()
        functions = [(name, getattr(suffuse, name), known[name]) for name in suffuse.__all__
                     if isinstance(known[name], ast.FunctionDef) and name not in ("gradient", "table_names", "brushes", "backends")]
        self.assertGreater(len(functions), 10)
        for name, function, stub in functions:
            with self.assertRaises(TypeError) as raised:
                function(no_such_parameter=1)
            said = str(raised.exception)
            for argument in stub.args.args + stub.args.kwonlyargs:
                self.assertIn(f"{argument.arg}: ", said, name)

    def test_types_are_marked(self):
        self.assertTrue((pathlib.Path(suffuse.__file__).parent / "py.typed").is_file())

    def test_import_loads_neither_numpy_nor_gui(self):
        code = ("import sys, suffuse; maps = open('/proc/self/maps').read(); "
                "print('numpy' in sys.modules, 'libQt6Gui' in maps, 'libQt6Core' in maps)")
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.split(), ["False", "False", "True"])


if __name__ == "__main__":
    unittest.main()
