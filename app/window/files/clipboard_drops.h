#pragma once

#include <QObject>

namespace suffuse {

class CanvasWidget;

/// What is dropped on the canvas: a colour goes to the stroke under the pointer, strokes and SVG paths are pasted
/// there. Everything else (files) is left to the window.
class CanvasDrops : public QObject {
    Q_OBJECT

public:
    /// Belongs to the canvas.
    explicit CanvasDrops(CanvasWidget &canvas);

signals:
    /// Of what was dropped, as `clipboard::paste` says it.
    void leftOut(const QString &problem);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    CanvasWidget &m_canvas;
};

} // namespace suffuse
