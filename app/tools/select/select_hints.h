// What clicking and dragging with the Select tool will do, for the status bar.
#pragma once

#include "model/painting/affine.h"

#include <QCoreApplication>

namespace suffuse {

struct TransformHandle;

struct SelectHints {
    Q_DECLARE_TR_FUNCTIONS(SelectHints)

public:
    /// Over a handle.
    static QString ofHandle(const TransformHandle &handle);
    /// Elsewhere, with the modifier keys that are held.
    static QString ofKeys(Qt::KeyboardModifiers held, bool anySelected);
    // While strokes are dragged.
    static QString ofMove(Point by);
    static QString ofScale(const Affine &map); ///< below 0: mirrored
    static QString ofTurn(double radians);
    static QString ofSkew(const Affine &map);
};

} // namespace suffuse
