// Numbers of pixels as Python gives them, in whatever type of array.
#pragma once

#include "app/python/bindings.h"

#include <algorithm>
#include <cmath>

namespace suffuse::python {

using Floats = py::array_t<float, py::array::c_style | py::array::forcecast>;

/// The number that stands for 1 in an array of pixels: 255 of uint8, 65535 of uint16, 1 of floats. Raises DataError for
/// any other type, whose white nobody knows.
inline float whiteOf(const py::array &pixels, const char *name)
{
    const py::dtype type = pixels.dtype();
    if (type.kind() == 'u' && type.itemsize() == 1)
        return 255;
    if (type.kind() == 'u' && type.itemsize() == 2)
        return 65535;
    if (type.kind() == 'f')
        return 1;
    raise(Raised::Value, QStringLiteral("%1: dtype %2: give uint8 (0 to 255), uint16 (0 to 65535) or floats (0 to 1)")
                             .arg(QLatin1String(name), py::str(py::object(type)).cast<QString>()));
}

/// The same numbers as floats. Raises DataError where one is not finite: nothing that is made of it could be saved.
inline Floats finiteFloatsOf(const py::array &pixels, const char *name)
{
    Floats numbers = Floats::ensure(pixels);
    if (!numbers) {
        PyErr_Clear();
        raise(Raised::Value, QStringLiteral("%1: give an array of numbers").arg(QLatin1String(name)));
    }
    if (!std::all_of(numbers.data(), numbers.data() + numbers.size(), [](float v) { return std::isfinite(v); }))
        raise(Raised::Value, QStringLiteral("%1: holds NaN or infinity: give finite numbers, as numpy.nan_to_num does")
                                 .arg(QLatin1String(name)));
    return numbers;
}

} // namespace suffuse::python
