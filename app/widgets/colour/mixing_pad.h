#pragma once

#include "app/widgets/brush/stroke_sheet.h"
#include "model/brush/stroke_builder.h"

#include <QWidget>

#include <memory>

class QToolButton;

namespace suffuse {

class Editor;

/// A little sheet to mix colours on. It is painted with strokes like the canvas: paint over other paint mixes with it
/// as pigments do. Rubbing carries paint along; picking makes a mixture the current colour. The sheet is no part of the
/// document.
class MixingPad : public QWidget {
    Q_OBJECT

public:
    enum class Mode { Paint, Rub, Pick };

    explicit MixingPad(Editor &editor, QWidget *parent = nullptr);

    Mode mode() const { return m_mode; }
    void setMode(Mode mode);
    void clear();
    bool isClear() const { return m_strokes.empty(); }
    /// The colour that is seen at a point of the widget, opaque; white outside.
    Colour colourAt(QPointF at) const;

    QSize sizeHint() const override { return {240, 110}; }
    QSize minimumSizeHint() const override { return {120, 110}; }

signals:
    void clearChanged();

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void tabletEvent(QTabletEvent *event) override;

private:
    void press(QPointF at, double pressure, Mode mode);
    void move(QPointF at, double pressure);
    void release();
    void add(QPointF at, double pressure);
    StrokePtr strokeInHand() const;
    void pick(QPointF at);
    void draw();

    /// The colour that the rubbing brush carried at a moment.
    struct Carried {
        Microseconds time;
        Colour colour;
    };

    Editor &m_editor;
    Mode m_mode = Mode::Paint;
    std::vector<StrokePtr> m_strokes;
    std::unique_ptr<StrokeBuilder> m_builder;
    std::vector<Carried> m_carried; ///< colours carried while rubbing
    QImage m_before;                ///< the sheet when the stroke in hand began
    Microseconds m_time = 0;
    StrokeId m_nextId = 1;
    Mode m_hand = Mode::Paint; ///< what the pointer does that is down
    bool m_down = false;
    StrokeSheet m_sheet;
};

/// The pad with its buttons: paint, rub, pick, clear.
class MixingSection : public QWidget {
    Q_OBJECT

public:
    explicit MixingSection(Editor &editor, QWidget *parent = nullptr);

    MixingPad *pad() const { return m_pad; }
    QToolButton *clearButton() const { return m_clear; }

private:
    MixingPad *m_pad = nullptr;
    QToolButton *m_clear = nullptr;
};

} // namespace suffuse
