// A line of text that stands over the picture for a moment.
#pragma once

#include "render/view.h"

#include <QObject>
#include <QString>
#include <QTimer>

class QPainter;

namespace suffuse {

/// Says something where people look while they paint, such as the layer that they have switched to. It goes by itself.
class CanvasNote : public QObject {
    Q_OBJECT

public:
    static constexpr int shownMs = 2000;

    CanvasNote();

    /// Shows a text, in place of one that is shown; an empty one shows none.
    void show(const QString &text);
    /// What is shown; empty where nothing is.
    const QString &text() const { return m_text; }
    /// Paints it in the middle of the upper edge; the painter's unit is a device pixel.
    void paint(QPainter &painter, const View &view, double dpr) const;

signals:
    /// Emitted when something else is shown, or nothing any more.
    void changed();

private:
    QString m_text;
    QTimer m_timer;
};

} // namespace suffuse
