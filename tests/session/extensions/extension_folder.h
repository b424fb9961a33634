// Extensions of a test's own: folders with a manifest and a program for the shell.
#pragma once

#include "app/extensions/extension_run.h"
#include "app/extensions/manifest.h"
#include "model/formats/files.h"
#include "tests/files.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

namespace suffuse {

/// Writes an extension whose program is a script. `members`: further ones of the manifest, each with its comma before
/// it.
inline QString writeExtension(const QString &place, const QString &id, const QByteArray &script,
                              const QByteArray &members = {})
{
    const QString folder = place + '/' + id;
    QDir().mkpath(folder);
    put(folder + "/manifest.json", R"({"format": "suffuse-extension", "version": 1, "id": ")" + id.toUtf8() +
                                       R"(", "name": {"en": "Test )" + id.toUtf8() +
                                       R"("}, "run": ["/bin/sh", "{folder}/program.sh"])" + members + "}");
    put(folder + "/program.sh", script);
    return folder;
}

inline Extension extensionIn(const QString &folder)
{
    const QString path = folder + "/manifest.json";
    const Result<Extension> extension = readManifest(bytesOf(path), path);
    if (!extension)
        qFatal("%s", qPrintable(extension.error()));
    return *extension;
}

/// Three short strokes, of which the third is in a group.
inline PaintingPtr threeStrokes()
{
    auto painting = std::make_shared<Painting>();
    painting->canvas.width = painting->canvas.height = 100;
    painting->groups.push_back({.id = 7, .name = "layer"});
    for (const StrokeId id : {1, 2, 3}) {
        auto stroke = std::make_shared<Stroke>();
        stroke->id = id;
        stroke->group = id == 3 ? 7 : 0;
        Segment segment;
        const float y = 20.0f * float(id);
        segment.bezier = {Offset{10, y}, {20, y}, {30, y}, {40, y}};
        stroke->segments = {segment};
        painting->strokes.push_back(stroke);
    }
    return painting;
}

} // namespace suffuse
