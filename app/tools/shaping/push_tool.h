#pragma once

#include "app/session/gesture.h"
#include "app/session/selecting/stroke_boxes.h"
#include "app/tools/sized_tool.h"
#include "model/shaping/nodes/tweak.h"

#include <QBasicTimer>

class QComboBox;

namespace suffuse {

/// Moves the strokes under its circle: the selected strokes or, without a selection, all. It pushes them along, combs
/// them into its direction, pinches them together or apart, or roughens them.
class PushTool : public SizedTool {
    Q_OBJECT

public:
    explicit PushTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    QWidget *options() override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    bool changesAnything() const override { return true; }
    bool isBusy() const override { return m_gesture.isOpen(); }
    void cancel() override;

    TweakKind kind() const { return m_kind; }
    void setKind(TweakKind kind);
    /// Sets how much of its effect a touch of full pressure has, (0, 1].
    void setStrength(double strength);

protected:
    void timerEvent(QTimerEvent *event) override;

private:
    Tweak touchAt(Point centre, Point by) const;
    void show(const std::vector<Tweak> &touches);
    /// The strokes that the touches may change. While nothing is selected, letters of texts are none of them: whoever
    /// combs hair over a title means the hair.
    std::vector<StrokePtr> targets(const std::vector<Tweak> &touches);
    void finish();

    QPointer<QWidget> m_options;
    QPointer<QComboBox> m_kinds; ///< one of the fields of the options
    TweakKind m_kind = TweakKind::Push;
    double m_strength = 0.6;
    Gesture m_gesture;
    PointerEvent m_last;
    bool m_touched = false;       ///< whether a stroke lay in the way of this drag
    bool m_sparedLetters = false; ///< whether letters did, which it left alone
    unsigned m_touches = 0;       ///< Counts the touches of this drag, each of which roughens in another way.
    StrokeBoxes m_boxes;
    QBasicTimer m_timer; ///< goes on touching while the pointer stays
};

} // namespace suffuse
