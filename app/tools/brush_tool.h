#pragma once

#include "app/session/painting/stabiliser.h"
#include "app/tools/canvas_tool.h"
#include "app/tools/eyedropper_tool.h"
#include "model/brush/brush.h"
#include "model/brush/stroke_builder.h"
#include "model/shaping/reshape.h"

#include <QBasicTimer>
#include <QPointer>

#include <memory>

class QComboBox;

namespace suffuse {

class NumberField;

/// Paints: the stroke in hand is the document's draft, and becomes one undo step when the pen lifts. With Shift from an
/// end of a selected stroke it goes on with that stroke, with the values at that end; from elsewhere Shift changes the
/// brush's size across and its opacity upwards; with Ctrl or Alt it picks colours.
class BrushTool : public CanvasTool {
    Q_OBJECT

public:
    explicit BrushTool(CanvasWidget &canvas, QObject *parent = nullptr);
    ~BrushTool() override;

    QString hint() const override;
    QCursor cursor() const override { return Qt::CrossCursor; }
    QWidget *options() override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    void hover(const PointerEvent &event) override;
    void leave() override;
    /// None: what is painted is to be seen.
    bool showsOutlines() const override { return false; }
    bool isBusy() const override { return m_builder || m_resizing || m_picker.isActive(); }
    void cancel() override;
    void stepSize(int steps) override;
    void stepOpacity(int steps) override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

    /// What the canvas says about the brush at the moment; empty: nothing.
    const QString &note() const { return m_note; }

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    /// A drag that changes the brush, from where it was.
    struct Resizing {
        Brush brush;
        Point pixel;
        enum { Undecided, Size, Opacity } what = Undecided;
    };

    void add(const PointerEvent &event);
    PenSample sampleOf(const PointerEvent &event) const;
    void resizeTo(Point pixel);
    void scaleSize(double factor);
    void addOpacity(double difference);
    void showNote(const QString &note, bool stays);
    void paintString(QPainter &painter, const View &view, double dpr) const;
    void paintOutline(QPainter &painter, const View &view, double dpr) const;
    void paintNote(QPainter &painter, double dpr) const;
    void refreshOptions();
    void pushStroke(const StrokePtr &stroke);
    /// The end node of a selected stroke that is near enough to go on from.
    std::optional<NodeRef> endAt(Point pixel) const;
    void showOutlineAt(Point pixel);
    QRectF outlineBox() const;

    std::unique_ptr<StrokeBuilder> m_builder;
    PenStabiliser m_stabiliser;
    std::optional<Resizing> m_resizing;
    Microseconds m_lastTime = 0;
    std::optional<NodeRef> m_extended; ///< the end that the stroke in hand goes on from
    std::optional<NodeRef> m_nearEnd;  ///< under the pointer
    ColourPicker m_picker;
    bool m_hovering = false;
    Point m_pixel; ///< where the outline is
    QString m_note;
    QBasicTimer m_noteTimer;

    QPointer<QWidget> m_options;
    QComboBox *m_presets = nullptr;
    NumberField *m_size = nullptr;
    NumberField *m_flow = nullptr;
    NumberField *m_opacity = nullptr;
    QComboBox *m_smoothing = nullptr;
    NumberField *m_amount = nullptr;
};

} // namespace suffuse
