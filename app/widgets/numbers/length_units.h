#pragma once

#include "app/session/selecting/snapping.h"
#include "app/widgets/numbers/display.h"

#include <QObject>
#include <QPointer>

class QWidget;

namespace suffuse {

class Editor;

/// In what a window's fields show and take lengths of the canvas: what its rulers count, as large as its painting says
/// that units are on paper. Fields follow it by themselves.
class LengthUnits : public QObject {
    Q_OBJECT

public:
    LengthUnits(QWidget &window, Editor &editor);
    /// Those of a form for a painting that is not there yet. `resolution`: canvas units an inch.
    LengthUnits(QWidget &form, double resolution);

    /// Those of the window that a widget belongs to; null: there are none.
    static LengthUnits *of(const QWidget *widget);

    void setUnits(RulerUnits units);
    /// Sets how many canvas units an inch has where no painting says it.
    void setResolution(double resolution);
    Display display() const;

signals:
    void changed();

private:
    void refresh();

    QWidget &m_window;
    QPointer<Editor> m_editor; ///< null where the painting has gone before the window
    double m_resolution;
    RulerUnits m_units;
};

/// How lengths are shown in a widget's window; in canvas units where nobody says it.
Display lengthDisplay(const QWidget *widget);

} // namespace suffuse
