// What the tests of wheel, keys and typed fields share.
#pragma once

#include "app/widgets/numbers/number_field.h"
#include "tests/app/all_dialogs.h"

#include <QTemporaryDir>

namespace suffuse {

/// Each tool, for tests that go through all of them.
inline constexpr Command tools[] = {Command::Brush,          Command::Select,     Command::Segments,  Command::Shapes,
                                    Command::Knife,          Command::OutlinePen, Command::LassoFill, Command::Bucket,
                                    Command::Text,           Command::Redraw,     Command::Push,      Command::Eraser,
                                    Command::AttributeBrush, Command::Eyedropper, Command::Pan};

/// Lets the windows of a test keep their settings in a folder of its own, and draw alike everywhere.
inline void keepSettingsIn(const QTemporaryDir &folder)
{
    qputenv("SUFFUSE_PRESENTER", "raster");
    qputenv("SUFFUSE_BACKEND", "cpu");
    qputenv("SUFFUSE_SETTINGS", folder.filePath("settings.ini").toLocal8Bit());
}

/// The visible field of that name; null if there is none.
inline NumberField *fieldCalled(QWidget &root, const QString &name)
{
    for (auto *field : root.findChildren<NumberField *>())
        if (field->accessibleName() == name && field->isVisible())
            return field;
    return nullptr;
}

} // namespace suffuse
