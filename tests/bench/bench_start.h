// What the benches of the window begin with.
#pragma once

#include "app/session/settings/settings.h"
#include "model/formats/files.h"
#include "render/bench/generator.h"

#include <QCommandLineParser>
#include <QTemporaryDir>

#include <algorithm>

namespace suffuse {

/// Settings of its own: no window that was left anywhere; CPU and raster unless the environment says otherwise. Before
/// the application is made.
inline void useOwnSettings(const QTemporaryDir &folder)
{
    qputenv("SUFFUSE_SETTINGS", folder.filePath("settings.ini").toLocal8Bit());
    if (qEnvironmentVariableIsEmpty("SUFFUSE_BACKEND"))
        qputenv("SUFFUSE_BACKEND", "cpu");
    if (qEnvironmentVariableIsEmpty("SUFFUSE_PRESENTER"))
        qputenv("SUFFUSE_PRESENTER", "raster");
}

/// By the options "painting" (a file) and "strokes" (generated, of ten segments each).
inline Result<Painting> paintingFrom(const QCommandLineParser &parser)
{
    if (parser.isSet("painting"))
        return loadPainting(parser.value("painting"));
    bench::PaintingOptions options;
    if (parser.isSet("strokes")) {
        options.strokes = std::max(parser.value("strokes").toInt(), 1);
        options.segments = 10 * options.strokes;
    }
    return bench::makePainting(options);
}

} // namespace suffuse
