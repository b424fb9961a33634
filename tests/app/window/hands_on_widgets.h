// What the tests of wheel, keys and typed fields share.
#pragma once

#include "app/widgets/numbers/number_field.h"
#include "tests/app/all_dialogs.h"

namespace suffuse {

/// Each tool, for tests that go through all of them.
inline constexpr Command tools[] = {Command::Brush,      Command::Select, Command::Segments, Command::Shapes, Command::Knife,
                                    Command::Redraw,     Command::Push,   Command::Eraser,   Command::AttributeBrush,
                                    Command::Eyedropper, Command::Pan};

/// The visible field of that name; null if there is none.
inline NumberField *fieldCalled(QWidget &root, const QString &name)
{
    for (auto *field : root.findChildren<NumberField *>())
        if (field->accessibleName() == name && field->isVisible())
            return field;
    return nullptr;
}

} // namespace suffuse
