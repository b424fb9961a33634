#include "app/tools/shapes/shape_paint.h"

#include "app/session/settings/settings.h"
#include "app/tools/shapes/shape_tool.h"
#include "model/painting/validate.h"
#include "undo/fill_edits.h"

#include <QComboBox>
#include <QHBoxLayout>

namespace suffuse {

namespace {

QString paintKey(const QString &tool)
{
    return QStringLiteral("tools/%1/paint").arg(tool);
}

} // namespace

StrokePtr paintedAlong(const std::vector<Cubic> &curves, const Brush &brush, StrokeId id, Microseconds born,
                       ShapePaint paint)
{
    Stroke stroke = strokeAlong(curves, brush, id, born);
    if (stroke.segments.empty())
        return nullptr;
    if (paint != ShapePaint::Outline)
        stroke.fill = usualFill(stroke);
    if (paint == ShapePaint::Fill)
        for (Segment &segment : stroke.segments)
            segment.density = 0; // it bounds the fill, and lays no paint
    return problemOf(stroke).isEmpty() ? std::make_shared<const Stroke>(std::move(stroke)) : nullptr;
}

QComboBox *addPaintField(QHBoxLayout &row, ShapePaint now, const std::function<void(ShapePaint)> &take)
{
    auto *paints = new QComboBox(row.parentWidget());
    paints->setObjectName("paint");
    paints->addItems({ShapeTool::tr("Outline"), ShapeTool::tr("Fill"), ShapeTool::tr("Outline and fill")});
    paints->setToolTip(ShapeTool::tr("What of the shape is painted"));
    paints->setAccessibleName(ShapeTool::tr("What of the shape is painted"));
    paints->setCurrentIndex(int(now));
    QObject::connect(paints, &QComboBox::activated, paints, [take](int index) { take(ShapePaint(index)); });
    row.addWidget(paints);
    return paints;
}

ShapePaint storedPaint(const QString &tool)
{
    bool ok = false;
    const int paint = settings::store().value(paintKey(tool)).toInt(&ok);
    return ok && paint >= 0 && paint <= int(ShapePaint::Both) ? ShapePaint(paint) : ShapePaint::Fill;
}

void storePaint(const QString &tool, ShapePaint paint)
{
    settings::store().setValue(paintKey(tool), int(paint));
}

} // namespace suffuse
