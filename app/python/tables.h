// Paintings to and from tables: structured arrays with a row for each stroke, segment, fill and so on.
#pragma once

#include "app/python/bindings.h"

#include <functional>
#include <string>
#include <vector>

namespace suffuse::python {

/// The names of the tables, in the order in which they refer to each other.
const std::vector<std::string> &tableNames();
/// One of the tables of a painting, which cannot be written to. Of a painting it is made once.
py::object tableOf(PaintingValue &value, const std::string &name);
/// A painting of tables: those that are not given are those of `base`, or empty. Raises DataError where a value is not
/// in its domain, with the path of the text form.
PaintingPtr paintingOf(const py::dict &tables, PaintingValue *base);
/// A table with so many rows of defaults.
py::array newTable(const std::string &name, std::size_t rows);
/// Sets some values, which are named as the columns are, and leaves the others alone.
template <class T>
using SetValues = std::function<void(T &)>;
/// Of a segment, a stroke, a fill, a group or a canvas. The change may be called without Python's lock.
template <class T>
SetValues<T> changeOf(const py::dict &values);
/// What the columns of a table are: for each its name, type, shape, unit, domain and words.
py::list columnsOf(const std::string &name);

} // namespace suffuse::python
