#include "app/canvas/reading/pen_speech.h"

#include "app/canvas/canvas_widget.h"
#include "app/canvas/reading/canvas_reading.h"
#include "app/session/editor.h"
#include "app/session/selecting/stroke_words.h"

#include <QLocale>

namespace suffuse {

PenSpeech::PenSpeech(CanvasWidget &canvas, CanvasReading &reading, QObject *parent) : QObject(parent), m_canvas(canvas)
{
    const KeyboardPen *pen = &canvas.keyboardPen();
    connect(pen, &KeyboardPen::onChanged, this, [this](bool on) {
        emit said(on ? tr("Arrow keys move the pen, Space presses it down and lifts it. Esc puts it away.")
                     : tr("The pen is put away."));
    });
    connect(pen, &KeyboardPen::lowered, this, [this] {
        m_next = m_canvas.editor().unsettled().painting()->nextStrokeId();
        emit said(tr("Pen down at %1.").arg(place()));
    });
    connect(pen, &KeyboardPen::lifted, this, [this] {
        const QString stroke = made();
        //: a place and what was painted: "Pen up at 120, 80: stroke 12, even, blue, 5 segments."
        emit said(stroke.isEmpty() ? tr("Pen up at %1.").arg(place()) : tr("Pen up at %1: %2.").arg(place(), stroke));
    });
    connect(pen, &KeyboardPen::gaveUp, this, [this] { emit said(tr("Given up.")); });
    connect(pen, &KeyboardPen::pressureChanged, this, [this, pen] {
        emit said(tr("Pressure %1 %").arg(QLocale().toString(qRound(100 * pen->pressure()))));
    });
    connect(pen, &KeyboardPen::moved, &reading, [this, &reading] { reading.say(place()); });
}

/// Where the pen is, in whole canvas units where pixels are no finer.
QString PenSpeech::place() const
{
    const Point at = m_canvas.keyboardPen().point();
    const int decimals = std::clamp(int(std::ceil(std::log10(m_canvas.view().scale))), 0, 10);
    const QLocale locale;
    //: a position: x, y
    return tr("%1, %2").arg(locale.toString(at.x, 'f', decimals), locale.toString(at.y, 'f', decimals));
}

/// The stroke that has come since the pen was pressed down, in words.
QString PenSpeech::made() const
{
    const Painting &painting = *m_canvas.editor().unsettled().painting();
    StrokeId newest = 0;
    for (const StrokePtr &stroke : painting.strokes)
        newest = std::max(newest, stroke->id);
    return newest >= m_next ? wordsOf(*painting.find(newest)) : QString();
}

} // namespace suffuse
