// pybind11. One of Qt's macros, "slots", is the name of a member in Python's headers, so it is put aside for them.
#pragma once

#pragma push_macro("slots")
#undef slots
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#pragma pop_macro("slots")
