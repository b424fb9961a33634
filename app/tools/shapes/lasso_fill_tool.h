#pragma once

#include "app/tools/shapes/drawing_tool.h"

#include <optional>

namespace suffuse {

/// Paints what is drawn around. A drag is closed by a straight line when it ends, and becomes a filled stroke. Clicks
/// set corners between straight lines, and with Alt the end of a drag is such a corner; a press on the first point, a
/// double click or Return closes what is in hand then.
class LassoFillTool : public DrawingTool {
    Q_OBJECT

public:
    explicit LassoFillTool(CanvasWidget &canvas, QObject *parent = nullptr);

    QString hint() const override;
    void press(const PointerEvent &event) override;
    void move(const PointerEvent &event) override;
    void release(const PointerEvent &event) override;
    void hover(const PointerEvent &event) override;
    void leave() override;
    void settle() override { finish(); }
    /// What was drawn since the last press, or the corner that it set.
    bool takeBack() override;
    bool keyPress(QKeyEvent *event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    void paint(QPainter &painter, const View &view, double dpr) const override;

protected:
    void show() override;
    void forget() override;

private:
    using Part = std::vector<Point>; ///< what was drawn between a press and its release, canvas units

    bool closesAt(Point pixel) const;
    bool isClick(const Part &part) const;
    void add(const PointerEvent &event);
    void finish();
    /// The closed outline of what is in hand, smooth within each part.
    std::vector<Cubic> outline() const;

    std::vector<Part> m_parts;
    std::vector<Part> m_takenBack; ///< since the last press; the last one comes back first
    bool m_isPressed = false;
    std::optional<Point> m_next; ///< where the next straight line would lead
};

} // namespace suffuse
