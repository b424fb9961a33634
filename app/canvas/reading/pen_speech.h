// Says what the pen of the keys does.
#pragma once

#include "model/painting/ids.h"

#include <QObject>

namespace suffuse {

class CanvasReading;
class CanvasWidget;

/// Puts what the keyboard's pen does into sentences. Each place that it moves to is told to screen readers only: the
/// status bar shows it anyway.
class PenSpeech : public QObject {
    Q_OBJECT

public:
    /// Canvas and reading must outlive it.
    PenSpeech(CanvasWidget &canvas, CanvasReading &reading, QObject *parent);

signals:
    void said(const QString &sentence);

private:
    QString place() const;
    QString made() const;

    CanvasWidget &m_canvas;
    StrokeId m_next = 0; ///< when the pen was pressed down
};

} // namespace suffuse
