// What clicking and dragging with the Select tool will do, for the status bar.
#pragma once

#include "model/geometry/affine.h"

#include <QCoreApplication>

namespace suffuse {

struct TransformHandle;

struct SelectHints {
    Q_DECLARE_TR_FUNCTIONS(SelectHints)

public:
    /// What a drag of a handle does.
    static QString ofHandle(const TransformHandle &handle);
    /// What clicks and drags beside the handles do with the modifier keys that are held.
    static QString ofKeys(Qt::KeyboardModifiers held, bool anySelected);
    /// What the strokes in the hand have been moved by, in canvas units.
    static QString ofMove(Point by);
    /// How the box has been scaled; a side that is mirrored has a value below 0.
    static QString ofScale(const Affine &map);
    /// How far the strokes have been turned, from radians.
    static QString ofTurn(double radians);
    /// How far the box has been skewed.
    static QString ofSkew(const Affine &map);
};

} // namespace suffuse
