// The clipboard, and what is dropped on the canvas.
#pragma once

#include "app/window/workplace.h"
#include "model/geometry/geometry.h"

#include <QObject>

#include <optional>

namespace suffuse {

/// Pastes into a window's painting, and says what of it could not be.
class Pasting : public QObject {
    Q_OBJECT

public:
    Pasting(const Workplace &place, QObject *parent);

private:
    void followClipboard();
    /// Without a middle: where it was.
    void pasteAt(std::optional<Point> middle);
    Point pointer() const;

    Workplace m_place;
    bool m_canPaste = false;
};

} // namespace suffuse
