// What comes into a painting from other files.
#pragma once

#include "app/window/workplace.h"

#include <QObject>

namespace suffuse {

/// Imports strokes and the picture to paint over.
class Importing : public QObject {
    Q_OBJECT

public:
    Importing(const Workplace &place, QObject *parent);

    /// Adds a file's strokes to the painting and selects them. Errors are shown, and so is what was left out.
    void importStrokes(const QString &path);
    /// Errors are shown.
    void importUnderlay(const QString &path);

private:
    void chooseStrokes();

    Workplace m_place;
};

} // namespace suffuse
