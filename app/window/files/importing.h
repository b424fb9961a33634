// What comes into a painting from other files.
#pragma once

#include "app/window/workplace.h"

#include <QObject>

namespace suffuse {

/// Imports strokes, pictures, and the picture to paint over.
class Importing : public QObject {
    Q_OBJECT

public:
    Importing(const Workplace &place, QObject *parent);

    /// Adds a file's strokes to the painting and selects them. Errors are shown, and so is what was left out.
    void importStrokes(const QString &path);
    /// Errors are shown.
    void importUnderlay(const QString &path);
    /// Adds a picture as a layer, and selects it. Errors are shown.
    void importPicture(const QString &path);
    /// Asks at a place on the screen what pictures that were dropped are to be: layers, or the last one the underlay.
    void offer(const QStringList &pictures, const QPoint &place);

private:
    void chooseStrokes();
    void pictureToStrokes();

    Workplace m_place;
};

} // namespace suffuse
