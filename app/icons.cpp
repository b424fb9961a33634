#include "app/icons.h"

#include <QGuiApplication>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QSvgRenderer>

namespace suffuse {

namespace {

/// Outlines on a 24 × 24 grid, drawn with a round pen 1.7 wide. Parts are parted by bars.
const QHash<QString, QByteArray> &outlines()
{
    static const QHash<QString, QByteArray> table{
        {"brush", "M20.2 3.8c-1.4-1.4-3-.6-4.6 1L9.2 12l2.8 2.8 7.2-6.4c1.6-1.6 2.4-3.2 1-4.6z"
                  "|M9 12.4c-2.6-.2-4 1.4-4.2 3.6-.1 1.8-.9 3-2 3.6 1.4.9 3.2 1.2 5 .9 2.6-.4 4.2-2.3 4-5.3"},
        {"select", "M5 3.5l13.5 8.3-6.2 1.4-3.3 5.6z|M12.6 13.6l3.9 6.6"},
        {"segments", "M4 18C6 8 14 16 20 6|M2.6 16.6h2.8v2.8h-2.8z|M18.6 4.6h2.8v2.8h-2.8z|M10.7 10.6h2.8v2.8h-2.8z"},
        {"pan", "M8 12.5V6.2a1.5 1.5 0 0 1 3 0V11m0-5.8a1.5 1.5 0 0 1 3 0V11m0-4.5a1.5 1.5 0 0 1 3 0V13"
                "m0-3.2a1.5 1.5 0 0 1 3 0c0 6.5-1 11-7 11-4 0-5.2-2-8.5-7.3-1-1.7 1.1-2.9 2.3-1.5l1.7 2"},
        {"new", "M6 3h8l5 5v13H6z|M14 3v5h5|M12.5 12v6|M9.5 15h6"},
        {"open", "M3 19V5h6l2 2.5h8V11|M3 19l3-8h16l-3 8z"},
        {"save", "M4 4h13l3 3v13H4z|M8 4v5h7V4|M7 20v-7h10v7"},
        {"export", "M5 12v8h14v-8|M12 15V3.5|M7.5 8L12 3.5 16.5 8"},
        {"undo", "M8.5 5L4 9.5 8.5 14|M4 9.5h10a5.5 5.5 0 0 1 0 11H9"},
        {"redo", "M15.5 5L20 9.5 15.5 14|M20 9.5H10a5.5 5.5 0 0 0 0 11h5"},
        {"zoom-in", "M10.5 4a6.5 6.5 0 1 0 .01 0z|M15.3 15.3L21 21|M7.5 10.5h6|M10.5 7.5v6"},
        {"zoom-out", "M10.5 4a6.5 6.5 0 1 0 .01 0z|M15.3 15.3L21 21|M7.5 10.5h6"},
        {"fit", "M4 9V4h5|M15 4h5v5|M20 15v5h-5|M9 20H4v-5|M9 9h6v6H9z"},
        {"delete", "M4 6.5h16|M9 6.5V4h6v2.5|M6 6.5L7 20.5h10l1-14|M10 10.5v6|M14 10.5v6"},
        {"duplicate", "M8 8h12v12H8z|M16 8V4H4v12h4"},
        {"cut", "M6 15.5a3 3 0 1 0 .01 0z|M18 15.5a3 3 0 1 0 .01 0z|M7.8 16L16.5 3.5|M16.2 16L7.5 3.5"},
        {"copy", "M9 8h11v13H9z|M15 8V3H4v13h5"},
        {"paste", "M8 5H5v16h14V5h-3|M9 3h6v4H9z|M9 12h6|M9 16h6"},
        {"raise", "M12 20V6|M6 12l6-6 6 6"},
        {"lower", "M12 4v14|M6 12l6 6 6-6"},
        {"top", "M5 4h14|M12 21V9|M6.5 14L12 8.5l5.5 5.5"},
        {"bottom", "M5 20h14|M12 3v12|M6.5 10l5.5 5.5L17.5 10"},
        {"eye", "M2.5 12C5 7.5 8.3 5.5 12 5.5s7 2 9.5 6.5c-2.5 4.5-5.8 6.5-9.5 6.5S5 16.5 2.5 12z"
                "|M12 9a3 3 0 1 0 .01 0z"},
        {"eye-off", "M4 4l16 16|M9.5 6C14.8 4.6 18.8 7 21.5 12a16 16 0 0 1-2.7 3.6"
                    "|M6 7.8A16 16 0 0 0 2.5 12c3.2 5.8 8 7.7 13 5.8"},
        {"lock", "M5.5 11h13v9.5h-13z|M8 11V7.5a4 4 0 0 1 8 0V11|M12 14.5v2.5"},
        {"unlock", "M5.5 11h13v9.5h-13z|M8 11V7.5a4 4 0 0 1 7.6-1.7|M12 14.5v2.5"},
        {"reset", "M4.5 12a7.5 7.5 0 1 0 2.5-5.6|M4.5 4v5h5"},
        {"search", "M10.5 4a6.5 6.5 0 1 0 .01 0z|M15.3 15.3L21 21"},
        {"group", "M3 19V6h6l2 2.5h10V19z"},
        {"swap", "M4 8.5h14|M14.5 5l3.5 3.5-3.5 3.5|M20 15.5H6|M9.5 12L6 15.5 9.5 19"},
        {"settings", "M4 7h9|M17 7h3|M15 5v4|M4 12h3|M11 12h9|M9 10v4|M4 17h9|M17 17h3|M15 15v4"},
        {"rotate", "M19.5 12a7.5 7.5 0 1 1-2.5-5.6|M19.5 4v5h-5"},
        {"knife", "M20 3.5L9.5 14l2 2C16 13 20 8 20 3.5z|M9.5 14L4 20.5"},
        {"eraser", "M8.5 19.5l-4.7-4.7a1.5 1.5 0 0 1 0-2.1l8.8-8.8a1.5 1.5 0 0 1 2.1 0l5.4 5.4a1.5 1.5 0 0 1 0 2.1"
                   "L12 19.5z"
                   "|M8.2 8.3l7.5 7.5|M8.5 19.5H20"},
        {"attribute-brush", "M20 3.8L11 13|M11 13c-2.5-.3-4 1.3-4.2 3.4-.1 1.7-.9 2.8-2 3.4 1.4.8 3.1 1 4.7.7"
                            " 2.3-.4 3.9-2 3.7-4.6z|M16 17h6|M19 14v6"},
        {"eyedropper", "M10.5 7.5l6 6|M13.2 8.4l3.1-3.1a1.7 1.7 0 0 1 2.4 2.4l-3.1 3.1|M12 9l-7 7-1 4 4-1 7-7"},
        {"node-insert", "M3 20c1-5 3-7 6-7|M15 13c3 0 5 2 6 7|M9 10h6v6H9z|M12 2v5|M9.5 4.5h5"},
        {"node-corner", "M3 20l6.3-9.4|M21 20l-6.3-9.4|M12 4l4 4-4 4-4-4z"},
        {"node-smooth", "M3 20C4 11 6.5 8.5 9 8|M15 8c2.5.5 5 3 6 12|M9 5h6v6H9z"},
        {"node-symmetric", "M3 20C4 11 6.5 8.5 9 8|M15 8c2.5.5 5 3 6 12|M12 4.7a3.3 3.3 0 1 0 .01 0z"},
        {"node-break", "M3 20c.3-4.5 1.5-7.5 3.5-9.5|M21 20c-.3-4.5-1.5-7.5-3.5-9.5"
                       "|M5.5 5.5h5v5h-5z|M13.5 5.5h5v5h-5z"},
        {"node-join", "M3 20c.3-5.5 2-9 6.3-9.5|M21 20c-.3-5.5-2-9-6.3-9.5"
                      "|M9.3 8h5.4v5.4H9.3z|M3.5 5l4 2|M20.5 5l-4 2"},
        {"segment-delete", "M2.5 9.5h5v5h-5z|M16.5 9.5h5v5h-5z|M10 10l4 4|M14 10l-4 4"},
        {"bridge", "M2.5 14h5v5h-5z|M16.5 14h5v5h-5z|M5 14C6 3.5 18 3.5 19 14"},
        {"reverse", "M4 17C8 6 15 18 20 7|M4.3 11.8L4 17l5-.7"},
        {"lasso", "M12 4.5c5 0 9 2.400 9 5.5s-4 5.5-9 5.5-9-2.400-9-5.5 4-5.5 9-5.5z|M7.5 14.800a2 2 0 1 0 .01 0z|M6.5 18.5c-.3 1.5-1 2.5-2.5 3"},
        {"touch-path", "M3 17C7 5 12 20 21 7|M6 5.5l3 3|M15 15.5l3 3"},
        {"group-strokes", "M3 3h3v3H3z|M18 3h3v3h-3z|M3 18h3v3H3z|M18 18h3v3h-3z|M6 4.5h12|M6 19.5h12|M4.5 6v12|M19.5 6v12|M8.5 8.5h5v5h-5z|M11.5 13.5v2h4v-4h-2"},
        {"ungroup", "M3.5 3.5h8v8h-8z|M12.5 12.5h8v8h-8z"},
        {"flip-across", "M12 3v18|M9 7L3.5 17H9z|M15 7l5.5 10H15z"},
        {"flip-down", "M3 12h18|M7 9L17 3.5V9z|M7 15l10 5.5V15z"},
        {"quarter-left", "M4 9.5h7v10.5H4z|M20 13a7 7 0 0 0-7-7.5|M15.5 2.5L12.5 5.5l3 3"},
        {"quarter-right", "M13 9.5h7v10.5h-7z|M4 13a7 7 0 0 1 7-7.5|M8.5 2.5l3 3-3 3"},
        {"scale-spread", "M12 12m-8 0a8 8 0 1 0 16 0a8 8 0 1 0-16 0|M12 12m-3 0a3 3 0 1 0 6 0a3 3 0 1 0-6 0|M17.5 6.5L21 3"},
        {"proportions", "M9 8H6.5a4 4 0 0 0 0 8H9|M15 8h2.5a4 4 0 0 1 0 8H15|M8.5 12h7"},
        {"align-left", "M4 3v18|M7.5 6h12v4h-12z|M7.5 14h7v4h-7z"},
        {"align-centre", "M12 3v3|M12 10v4|M12 18v3|M6 6h12v4H6z|M8.5 14h7v4h-7z"},
        {"align-right", "M20 3v18|M4.5 6h12v4h-12z|M9.5 14h7v4h-7z"},
        {"align-top", "M3 4h18|M6 7.5h4v12H6z|M14 7.5h4v7h-4z"},
        {"align-middle", "M3 12h3|M10 12h4|M18 12h3|M6 6h4v12H6z|M14 8.5h4v7h-4z"},
        {"align-bottom", "M3 20h18|M6 4.5h4v12H6z|M14 9.5h4v7h-4z"},
        {"gaps-across", "M3 4v16|M21 4v16|M9 7h6v10H9z"},
        {"gaps-down", "M4 3h16|M4 21h16|M7 9h10v6H7z"},
        {"centres-across", "M5 3v18|M12 3v3|M12 18v3|M19 3v18|M9.5 6h5v12h-5z"},
        {"centres-down", "M3 5h18|M3 12h3|M18 12h3|M3 19h18|M6 9.5h12v5H6z"},
        {"play", "M7 4.5v15l12-7.5z"},
        {"pause", "M7 4.5h3.5v15H7z|M13.5 4.5H17v15h-3.5z"},
        {"to-start", "M5 5v14|M19 5v14L8.5 12z"},
        {"to-end", "M19 5v14|M5 5v14l10.5-7z"},
        {"step-back", "M16.5 6.5v11L8 12z|M5 9.5v5"},
        {"step-on", "M7.5 6.5v11L16 12z|M19 9.5v5"},
        {"loop", "M4 11V9.5a3 3 0 0 1 3-3h13|M16.5 3L20 6.5 16.5 10|M20 13v1.5a3 3 0 0 1-3 3H4|M7.5 14L4 17.5 7.5 21"},
        {"skip-pauses", "M3 12h4.5M16.5 12H21|M7.5 7v10|M16.5 7v10|M10.5 16l3-8"},
        {"film", "M3.5 5h17v14h-17z|M7.5 5v14|M16.5 5v14|M3.5 9.7h4|M3.5 14.3h4|M16.5 9.7h4|M16.5 14.3h4"},
        {"fit-time", "M3 5v14|M21 5v14|M6.5 12h11|M9.5 8.5L6 12l3.5 3.5|M14.5 8.5L18 12l-3.5 3.5"},
        {"final-preview", "M2.5 11C5 6.5 8.3 4.5 12 4.5s7 2 9.5 6.5c-.8 1.4-1.6 2.5-2.5 3.4|M2.5 11c1.6 2.9 3.5 4.7 5.5 5.7|M12 8a3 3 0 1 0 .01 0z|M12.5 18l2.5 2.5 5-5.5"},
        {"dry", "M12 3.5C15 7.5 17.5 10.5 17.5 14a5.5 5.5 0 0 1-11 0C6.5 10.5 9 7.5 12 3.5z|M9.5 14l2 2 3.5-4"},
        {"freeze", "M12 3v18|M4.2 7.5l15.6 9|M19.8 7.5l-15.6 9|M9.5 4.5L12 7l2.5-2.5|M9.5 19.5L12 17l2.5 2.5"},
        {"rewet", "M9 4.5C11.5 8 13.5 10.5 13.5 13.5a4.5 4.5 0 0 1-9 0C4.5 10.5 6.5 8 9 4.5z|M18.5 12v7|M15 15.5h7"},
        {"plus", "M12 5v14|M5 12h14"},
        {"menu", "M4 7h16|M4 12h16|M4 17h16"},
        {"rub", "M3 8c4-4.500 7 4.500 11 0s5-2 7-1|M3 16c4-4.500 7 4.500 11 0s5-2 7-1"},
        {"mirror", "M12 3v18|M9 7L3.5 17H9z|M15 7l5.5 10H15z"},
    };
    return table;
}

QByteArray svgOf(const QString &name, const QColor &colour)
{
    QByteArray svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 24 24'><g fill='none' stroke-width='1.7' "
                     "stroke-linecap='round' stroke-linejoin='round' stroke='" +
                     colour.name().toLatin1() + "' stroke-opacity='" + QByteArray::number(colour.alphaF()) + "'>";
    for (const QByteArray &path : outlines().value(name).split('|'))
        svg += "<path d='" + path + "'/>";
    return svg + "</g></svg>";
}

QColor inkOf(QIcon::Mode mode)
{
    const QPalette p = QGuiApplication::palette();
    if (mode == QIcon::Selected)
        return p.color(QPalette::HighlightedText);
    return p.color(mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active, QPalette::ButtonText);
}

/// Paints the outline in the palette's colour of the moment.
class OutlineEngine : public QIconEngine {
public:
    explicit OutlineEngine(const QString &name) : m_name(name) {}

    void paint(QPainter *painter, const QRect &rect, QIcon::Mode mode, QIcon::State) override
    {
        QSvgRenderer svg(svgOf(m_name, inkOf(mode)));
        svg.setAspectRatioMode(Qt::KeepAspectRatio);
        painter->setRenderHint(QPainter::Antialiasing);
        svg.render(painter, rect);
    }

    QPixmap pixmap(const QSize &size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }

    QIconEngine *clone() const override { return new OutlineEngine(m_name); }
    QString key() const override { return "suffuse-outline"; }
    bool isNull() override { return !outlines().contains(m_name); }

private:
    QString m_name;
};

/// Two drops that spread on paper and the curve that they came from, on 64 × 64.
void paintApplicationIcon(QPainter &painter)
{
    QPainterPath sheet;
    sheet.addRoundedRect(QRectF(3, 3, 58, 58), 12, 12);
    painter.fillPath(sheet, QColor(0xFB, 0xFA, 0xF6));
    painter.setClipPath(sheet);
    const auto drop = [&painter](QPointF at, double radius, QColor colour) {
        QRadialGradient gradient(at, radius);
        gradient.setColorAt(0, colour);
        colour.setAlphaF(0.75f);
        gradient.setColorAt(0.6, colour);
        colour.setAlphaF(0);
        gradient.setColorAt(1, colour);
        painter.fillRect(QRectF(0, 0, 64, 64), gradient);
    };
    drop({24, 26}, 24, QColor(0x2F, 0x66, 0x90));
    drop({43, 43}, 18, QColor(0xC2, 0x55, 0x36));
    painter.setClipping(false);
    painter.strokePath(sheet, QPen(QColor(0xC9, 0xC7, 0xBF), 1.5));
    QPainterPath curve({13, 47});
    curve.cubicTo({22, 33}, {33, 46}, {51, 18});
    painter.strokePath(curve, QPen(QColor(0x17, 0x28, 0x3A), 3, Qt::SolidLine, Qt::RoundCap));
}

} // namespace

QIcon icon(const QString &name)
{
    return outlines().contains(name) ? QIcon(new OutlineEngine(name)) : QIcon();
}

QStringList iconNames()
{
    QStringList names = outlines().keys();
    names.sort();
    return names;
}

QIcon applicationIcon()
{
    QIcon result;
    for (const int size : {16, 24, 32, 48, 64, 128, 256}) {
        QPixmap pixmap(size, size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(size / 64.0, size / 64.0);
        paintApplicationIcon(painter);
        painter.end();
        result.addPixmap(pixmap);
    }
    return result;
}

} // namespace suffuse
