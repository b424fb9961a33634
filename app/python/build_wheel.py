"""Builds the wheel of the Python module: CMake compiles and installs it, setuptools packs what was installed.

pip calls the functions of this file (PEP 517). SUFFUSE_CMAKE_ARGS are further arguments of CMake; SUFFUSE_BUILD names a build
folder to use, such as one that is there already.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import setuptools
from setuptools.build_meta import _BuildMetaBackend
from setuptools.command.build_ext import build_ext

SOURCE = pathlib.Path(__file__).resolve().parents[2]


class CMakeBuild(build_ext):
    """Compiles by CMake in place of a compiler that setuptools knows."""

    def build_extension(self, ext):
        """Configures, builds and installs into the folder that is packed."""
        folder = pathlib.Path(self.build_lib).resolve()
        named = os.environ.get("SUFFUSE_BUILD")
        with tempfile.TemporaryDirectory() as temporary:
            build = pathlib.Path(named or temporary).resolve()
            arguments = ["-DSUFFUSE_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}", "-DSUFFUSE_PYTHON_DIR=.",
                         "-DSUFFUSE_UNITY=ON", *os.environ.get("SUFFUSE_CMAKE_ARGS", "").split()]
            if not (build / "CMakeCache.txt").is_file():
                arguments += ["-DCMAKE_BUILD_TYPE=Release"]
                if shutil.which("ninja"):
                    arguments += ["-G", "Ninja"]
            subprocess.run(["cmake", "-S", SOURCE, "-B", build, *arguments], check=True)
            targets = ["suffuse_python", "suffuse_image_io", "suffuse_openimageio", "suffuse_pdf", "suffuse_lettering"]
            jobs = str(len(os.sched_getaffinity(0)))
            subprocess.run(["cmake", "--build", build, "-j", jobs, "--target", *targets], check=True)
            for component in ("python", "python_modules"):
                subprocess.run(["cmake", "--install", build, "--prefix", folder, "--component", component, "--strip"], check=True)


def version():
    """The version of the program, which CMakeLists.txt has."""
    text = (SOURCE / "CMakeLists.txt").read_text("utf-8")
    return re.search(r"project\(suffuse VERSION ([0-9.]+)", text).group(1)


class Backend(_BuildMetaBackend):
    """setuptools with what a setup.py would say. What it makes on its way goes into a folder that is removed."""

    def run_setup(self, setup_script="setup.py"):
        """Runs setuptools with the command that it was asked for, which stands in sys.argv."""
        with tempfile.TemporaryDirectory() as folder:
            setuptools.setup(
                version=version(),
                ext_modules=[setuptools.Extension("suffuse._suffuse", [])],
                cmdclass={"build_ext": CMakeBuild},
                options={"egg_info": {"egg_base": folder}, "build": {"build_base": folder}},
            )


_backend = Backend()
build_wheel = _backend.build_wheel
prepare_metadata_for_build_wheel = _backend.prepare_metadata_for_build_wheel


def get_requires_for_build_wheel(config_settings=None):
    """What must be there, beside what pyproject.toml names: nothing."""
    return []
