// What the tests of wheel, keys, panels and typed fields share.
#pragma once

#include "app/widgets/numbers/number_field.h"
#include "tests/app/all_dialogs.h"

#include <QDockWidget>
#include <QTemporaryDir>
#include <QToolBar>

namespace suffuse {

/// Each tool, for tests that go through all of them.
inline constexpr Command tools[] = {Command::Brush,          Command::Select,     Command::Segments,   Command::Shapes,
                                    Command::Knife,          Command::OutlinePen, Command::LassoFill,  Command::Bucket,
                                    Command::Text,           Command::Redraw,     Command::Push,       Command::Eraser,
                                    Command::AttributeBrush, Command::Eyedropper, Command::Assistants, Command::Pan};

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

/// The docks and tool bars of a window.
inline QList<QWidget *> panelsOf(MainWindow &window)
{
    QList<QWidget *> panels;
    for (auto *dock : window.findChildren<QDockWidget *>())
        panels << dock;
    for (auto *bar : window.findChildren<QToolBar *>())
        panels << bar;
    return panels;
}

/// What in a panel can have the keyboard.
inline QList<QWidget *> focusableIn(QWidget &panel)
{
    QList<QWidget *> widgets = panel.findChildren<QWidget *>();
    widgets.removeIf([&](QWidget *w) {
        return !(w->focusPolicy() & Qt::StrongFocus) || w->focusProxy() || w->window() != panel.window();
    });
    return widgets;
}

} // namespace suffuse
