// Runs the program of an extension on a painting, in a folder of its own, within limits.
#pragma once

#include "app/extensions/extension.h"
#include "model/painting/painting.h"

#include <QJsonObject>

#include <atomic>
#include <functional>
#include <set>

namespace suffuse {

struct ExtensionOrder {
    Extension extension;
    QJsonObject values; ///< of all fields, as `problemOfValues` wants them
    PaintingPtr painting;
    std::set<StrokeId> selected;
    GroupId layer = 0;     ///< that is painted on; 0: none
    Microseconds time = 0; ///< the moment that is looked at
    QString language;
};

struct ExtensionOutcome {
    QString error;          ///< empty: it went well. A sentence that says what happened and what to do
    PaintingPtr painting;   ///< the whole painting as it is to be; null where it stays as it is
    QString said;           ///< what the program said for people; may be empty
    QString log;            ///< the last lines that it wrote on its standard error
    bool cancelled = false; ///< and the error is empty
};

/// Runs the program and waits until it has ended. It gets the painting, or a part of it, as a file, and what it writes
/// is read and checked as any file is; a painting is made of it, and no document is touched. Files that it was to write
/// are put in their places when all else went well. May be called on any thread.
///
/// `progress` gets the share that is done, from 0 to 1, or -1 where it is not known, and what is done, which may be
/// empty.
ExtensionOutcome runExtension(const ExtensionOrder &order, const std::atomic<bool> &cancel,
                              const std::function<void(double share, const QString &what)> &progress = {});

} // namespace suffuse
