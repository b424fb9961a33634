// Where on a sheet of paper a part of the canvas lies.
#pragma once

#include "model/formats/print_setup.h"
#include "model/painting/resolution.h"
#include "render/view.h"

#include <QPageLayout>
#include <QPageSize>
#include <QRectF>

namespace suffuse {

/// A sheet and the picture on it, in millimetres from the sheet's upper left corner.
struct PagePlan {
    QSizeF paper;   ///< as it lies
    QRectF room;    ///< what the margins leave; empty: nothing can be printed
    QRectF picture; ///< all of the area, in the middle of the room; it is cut where the room ends
    Rect area;      ///< canvas units

    bool isCut() const;
    bool isEmpty() const { return room.isEmpty() || area.isEmpty() || !picture.intersects(room); }
    /// The dots of the sheet that the picture takes, with so many dots an inch. At least one, unless the plan is empty.
    PixelRect dots(double dpi) const;
    /// What they show: a dot is a pixel.
    View view(double dpi) const;
    /// The whole sheet, in dots.
    QSize sheet(double dpi) const;
};

/// The paper of a name; A4 for one that is not known.
QPageSize paperOf(const QString &name);
/// Paper, orientation and margins, for whoever prints. `sheet`: the painting's own, mm, which may be the paper.
QPageLayout layoutOf(const PrintSetup &setup, const QSizeF &sheet = {});
/// `resolution`: canvas units an inch at the actual size.
PagePlan planOf(const PrintSetup &setup, const Rect &area, double resolution = usualResolution,
                const QSizeF &sheet = {});

} // namespace suffuse
