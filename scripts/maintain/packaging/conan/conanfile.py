# SPDX-License-Identifier: MIT
"""Conan's recipe: `conan create scripts/maintain/packaging/conan`. With -o "&:system=True" Boost and Eigen are those
that CMake finds."""
import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load

ROOT = os.path.join("..", "..", "..", "..")


class Limitcurve(ConanFile):
    name, license = "limitcurve", "MIT"
    description = "Friction limit curves of soft fingers, with error bounds, and a god-object that obeys them"
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False], "c": [True, False], "system": [True, False]}
    default_options = {"shared": False, "fPIC": True, "c": False, "system": False}

    def set_version(self):
        text = load(self, os.path.join(self.recipe_folder, ROOT, "limitcurve", "version.hpp"))
        self.version = re.search(r'version = "([0-9.]+)"', text)[1]

    def export_sources(self):
        for name in ("CMakeLists.txt", "LICENSE", "package.xml", "limitcurve/*", "godobject/*", "fit/*", "c/*",
                     "cmake/*", "data/engines/*"):
            copy(self, name, os.path.join(self.recipe_folder, ROOT), self.export_sources_folder)

    def requirements(self):
        if not self.options.system:
            self.requires("boost/[>=1.74]", options={"header_only": True}, visible=False)
            self.requires("eigen/[>=3.4 <6]", transitive_headers=True)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables.update(LIMITCURVE_C=bool(self.options.c), LIMITCURVE_FIT=False, LIMITCURVE_CLI=False)
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()

    def package_info(self):
        self.cpp_info.set_property("cmake_find_mode", "none")  # it brings its own configuration
        self.cpp_info.builddirs = ["lib/cmake/limitcurve"]
