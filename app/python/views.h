// Sizes, areas and moments as Python gives them; refused in the words of the command line.
#pragma once

#include "app/cli/options.h"
#include "app/python/bindings.h"

#include <array>
#include <optional>

namespace suffuse::python {

/// What part of a painting is drawn, how large and when; what is not given is as on the command line.
struct ViewWish {
    py::object size;                           ///< None, W or (W, H), pixels
    std::optional<double> scale;               ///< pixels a unit
    std::optional<std::array<double, 4>> area; ///< x, y, width, height, units
    std::optional<double> time;                ///< seconds
};

/// Raises DataError.
cli::PictureOptions pictureOptionsOf(const ViewWish &wish, const Painting &painting);
/// The moment alone.
Microseconds momentOf(std::optional<double> time, const Painting &painting);
/// Raises DataError.
RendererOptions rendererOptionsOf(const QString &backend, int threads, const py::object &devices);

} // namespace suffuse::python
