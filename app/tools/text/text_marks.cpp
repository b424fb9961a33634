#include "app/tools/text/text_marks.h"

#include "app/session/lettering/text_entry.h"

namespace suffuse {

void paintTextInHand(QPainter &painter, const View &view, double dpr, const TextEntry &entry, const QColor &accent,
                     bool hasCaret)
{
    const LaidText &laid = entry.laid();
    const Affine &place = entry.text().place;
    const auto pixel = [&](Point p) {
        const Point at = view.toPixels(place(p));
        return QPointF(at.x, at.y);
    };
    if (entry.hasSelection()) {
        const auto [from, to] = std::minmax({entry.caret(), entry.anchor()});
        QPainterPath path;
        path.setFillRule(Qt::WindingFill);
        for (const std::array<Point, 4> &area : laid.areasOf(from, to))
            path.addPolygon(QPolygonF{pixel(area[0]), pixel(area[1]), pixel(area[2]), pixel(area[3]), pixel(area[0])});
        QColor fill = accent;
        fill.setAlpha(70);
        painter.fillPath(path, fill);
        strokeTwoTone(painter, path.simplified(), accent, dpr, Qt::SolidLine, 0.6);
    }
    if (const auto [from, to] = entry.composed(); from < to)
        for (const std::array<Point, 4> &area : laid.areasOf(from, to)) {
            QPainterPath line(pixel(area[3]));
            line.lineTo(pixel(area[2]));
            strokeTwoTone(painter, line, accent, dpr);
        }
    if (!entry.text().curve.empty()) {
        QPainterPath path;
        for (Cubic curve : entry.text().curve) {
            for (Point &p : curve.p)
                p = place(p);
            addCurve(path, curve, view);
        }
        strokeTwoTone(painter, path, accent, dpr, Qt::DashLine, 0.5);
    }
    if (!hasCaret)
        return;
    const CaretLine caret = laid.caretAt(entry.caret());
    QPainterPath line(pixel(caret[0]));
    line.lineTo(pixel(caret[1]));
    strokeTwoTone(painter, line, accent, 1.6 * dpr);
}

void paintTextFrame(QPainter &painter, const View &view, double dpr, const Text &text, const Rect &box,
                    const QColor &accent)
{
    QPainterPath path;
    for (const Point corner :
         {Point{box.left, box.top}, {box.right, box.top}, {box.right, box.bottom}, {box.left, box.bottom}}) {
        const Point at = view.toPixels(text.place(corner));
        if (path.elementCount() == 0)
            path.moveTo(at.x, at.y);
        else
            path.lineTo(at.x, at.y);
    }
    path.closeSubpath();
    strokeTwoTone(painter, path, accent, dpr, Qt::DashLine);
}

QRectF caretPixels(const TextEntry &entry, const View &view, double dpr)
{
    const CaretLine caret = entry.laid().caretAt(entry.caret());
    const Point a = view.toPixels(entry.text().place(caret[0])), b = view.toPixels(entry.text().place(caret[1]));
    const double margin = 4 * dpr;
    return QRectF(QPointF(a.x, a.y), QPointF(b.x, b.y)).normalized().adjusted(-margin, -margin, margin, margin);
}

} // namespace suffuse
