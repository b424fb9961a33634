#include "app/widgets/look/group_tags.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QPainter>

namespace suffuse {

namespace {

struct TagText {
    Q_DECLARE_TR_FUNCTIONS(suffuse::GroupTag)
};

} // namespace

QString nameOf(GroupTag tag)
{
    switch (tag) {
        using enum GroupTag;
    case None:
        return TagText::tr("None", "mark of a group");
    case Red:
        return TagText::tr("Red", "mark of a group");
    case Orange:
        return TagText::tr("Orange", "mark of a group");
    case Yellow:
        return TagText::tr("Yellow", "mark of a group");
    case Green:
        return TagText::tr("Green", "mark of a group");
    case Blue:
        return TagText::tr("Blue", "mark of a group");
    case Violet:
        return TagText::tr("Violet", "mark of a group");
    case Brown:
        return TagText::tr("Brown", "mark of a group");
    case Grey:
        return TagText::tr("Grey", "mark of a group");
    }
    return {};
}

QColor colourOf(GroupTag tag)
{
    switch (tag) {
        using enum GroupTag;
    case None:
        return {};
    case Red:
        return {0xe0, 0x4f, 0x4a};
    case Orange:
        return {0xe8, 0x8a, 0x2e};
    case Yellow:
        return {0xe3, 0xc2, 0x2f};
    case Green:
        return {0x55, 0xa8, 0x4f};
    case Blue:
        return {0x45, 0x8f, 0xd6};
    case Violet:
        return {0xa0, 0x6c, 0xc9};
    case Brown:
        return {0x9c, 0x72, 0x50};
    case Grey:
        return {0x8c, 0x8c, 0x8c};
    }
    return {};
}

QIcon iconOf(GroupTag tag)
{
    constexpr int side = 16;
    const qreal ratio = qApp->devicePixelRatio();
    QPixmap pixmap(QSize(side, side) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = colourOf(tag);
    painter.setPen(colour.isValid() ? QPen(Qt::NoPen) : QPen(colourOf(GroupTag::Grey)));
    painter.setBrush(colour.isValid() ? QBrush(colour) : QBrush(Qt::NoBrush));
    painter.drawRoundedRect(QRectF(0, 0, side, side).adjusted(2.5, 2.5, -2.5, -2.5), 2, 2);
    painter.end();
    return QIcon(pixmap);
}

} // namespace suffuse
