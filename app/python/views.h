// Sizes, areas and moments as Python gives them; refused in the words of the command line.
#pragma once

#include "app/cli/options.h"
#include "app/python/bindings.h"

#include <array>
#include <optional>
#include <vector>

namespace suffuse::python {

/// What part of a painting is drawn, how large and when; what is not given is as on the command line.
struct ViewWish {
    py::object size;                           ///< None, W or (W, H), pixels
    std::optional<double> scale;               ///< pixels a unit
    std::optional<std::array<double, 4>> area; ///< x, y, width, height, units
    std::optional<double> time;                ///< seconds
};

/// The command line that asks for the same as a call from Python: so the same is understood, and refused in the same words.
class Asked {
public:
    /// `options`: those with a value.
    Asked(const char *command, const std::vector<const char *> &options);
    void set(const char *option, const QString &value);
    /// A number, or what is a word as text; None: it is not given.
    void set(const char *option, const py::object &value);
    /// A switch.
    void set(const char *option);
    /// Whatever of them is given.
    void set(const ViewWish &wish);
    void set(const QString &backend, int threads, const py::object &devices);
    const cli::CommandLine &line();

private:
    cli::CommandLine m_line;
    QStringList m_arguments;
};

/// Raises DataError.
cli::PictureOptions pictureOptionsOf(const ViewWish &wish, const Painting &painting);
/// The moment alone.
Microseconds momentOf(std::optional<double> time, const Painting &painting);
/// Raises DataError.
RendererOptions rendererOptionsOf(const QString &backend, int threads, const py::object &devices);

} // namespace suffuse::python
