#include "app/tools/select/select_hints.h"

#include "app/canvas/overlay/overlay.h"
#include "app/tools/select/transform_handles.h"

#include <QLocale>

#include <cmath>
#include <numbers>

namespace suffuse {

QString SelectHints::ofHandle(const TransformHandle &handle)
{
    using Kind = TransformHandle::Kind;
    switch (handle.kind) {
    case Kind::Scale:
        return tr("Drag: scale. Ctrl: keep the proportions. Shift: about the centre.");
    case Kind::Rotate:
        return tr("Drag: rotate. Ctrl: in steps of 15°. Shift: about the opposite corner.");
    case Kind::Skew:
        return tr("Drag: skew. Ctrl: in steps of 15°. Shift: about the opposite side.");
    case Kind::Centre:
        break;
    }
    return tr("Drag: move the centre of rotation. Shift+click: back into the middle.");
}

QString SelectHints::ofKeys(Qt::KeyboardModifiers held, bool anySelected)
{
    const bool shift = held & Qt::ShiftModifier;
    if (held & Qt::AltModifier)
        return shift ? tr("Shift+Alt+click: add the next stroke below, with Ctrl within its group. "
                          "Shift+Alt+drag: add what the path touches.")
                     : tr("Alt+click: select the next stroke below, with Ctrl within its group. "
                          "Alt+drag: select what the path touches.");
    if (held & Qt::ControlModifier)
        return shift ? tr("Ctrl+Shift+click: one stroke of a group, in or out. Ctrl+Shift+drag: take away.")
                     : tr("Ctrl+click: one stroke of a group. Ctrl+drag: move along an axis.");
    if (shift)
        return tr("Shift+click: add or take away. Shift+drag: add what the band encloses; while moving: do not snap.");
    if (!anySelected)
        return tr("Click paint to select its stroke. Drag for a band, over paint with Shift. Alt+click: the stroke "
                  "below.");
    // The keys Shift, Ctrl and Alt have hints of their own while they are held.
    return tr("Drag: move. Click again: turn and skew. Double click: values. Shift+click: add. Alt+click: the one "
              "below.");
}

QString SelectHints::ofMove(Point by)
{
    const QLocale locale;
    return tr("Move by %1, %2").arg(locale.toString(by.x, 'f', 1), locale.toString(by.y, 'f', 1));
}

QString SelectHints::ofScale(const Affine &map)
{
    const QLocale locale;
    return tr("Scale to %1 % × %2 %").arg(locale.toString(100 * map.a, 'f', 1), locale.toString(100 * map.d, 'f', 1));
}

QString SelectHints::ofTurn(double radians)
{
    return tr("Rotate by %1").arg(angleText(radians));
}

QString SelectHints::ofSkew(const Affine &map)
{
    return tr("Skew by %1°").arg(QLocale().toString(std::atan(map.b + map.c) * 180 / std::numbers::pi, 'f', 1));
}

} // namespace suffuse
