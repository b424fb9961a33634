#pragma once

#include "app/tools/selection_tool.h"

#include <map>

namespace suffuse {

/// Selects strokes by their visible paint and moves them; a second click selects the segment under the pointer.
class SelectTool : public SelectionTool {
    Q_OBJECT

public:
    using SelectionTool::SelectionTool;

    QString hint() const override;

protected:
    void pressed(const PointerEvent &event) override;
    void clicked(const PointerEvent &event) override;
    void banded(const Rect &band, const PointerEvent &event) override;
    bool beginDrag(const PointerEvent &event) override;
    void drag(const PointerEvent &event) override;
    void endDrag(bool cancelled) override;

private:
    void moveTo(Point by);

    std::optional<SegmentRef> m_hit;
    bool m_selectedByPress = false;
    std::map<StrokeId, Point> m_origins; ///< of the strokes that are moved, before
    EditRun m_run = 0;
};

/// Selects segments at once; Shift extends to a run, Ctrl adds and removes single ones.
class SegmentTool : public SelectionTool {
    Q_OBJECT

public:
    using SelectionTool::SelectionTool;

    QString hint() const override;
    QCursor cursor() const override { return Qt::PointingHandCursor; }

protected:
    void clicked(const PointerEvent &event) override;
    void banded(const Rect &band, const PointerEvent &event) override;
};

} // namespace suffuse
