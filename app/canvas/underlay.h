// The underlay on the canvas: it lies over the picture like a sheet that is held to the light, and is in no frame.
#pragma once

#include "app/session/files/underlay_image.h"
#include "render/view.h"

#include <QPolygonF>
#include <QRect>
#include <QThreadPool>

class QPainter;

namespace suffuse {

/// What presenters draw.
struct ShownUnderlay {
    UnderlayImagePtr image;
    Rect area; ///< canvas units, not empty
    double opacity = 1;
    bool brightens = false; ///< it multiplies what lies below; on a dark canvas it is screened

    friend bool operator==(const ShownUnderlay &, const ShownUnderlay &) = default;
};

/// How an underlay lies in a view: maps pixels to shares of its width and height.
class UnderlayMap {
public:
    UnderlayMap(const ShownUnderlay &shown, const View &view);
    Point operator()(Point pixel) const { return m_base + pixel.x * m_right + pixel.y * m_down; }
    /// Of one pixel.
    Point right() const { return m_right; }
    Point down() const { return m_down; }

private:
    Point m_base, m_right, m_down;
};

/// Where in the view it shows, device pixels.
QRect underlayBounds(const ShownUnderlay &shown, const View &view);

/// Paints an underlay with QPainter. Keeps it as it stands in the view, so that parts are painted at little cost.
class UnderlaySheet {
public:
    /// The painter's units are device pixels; nothing beyond `part` is needed.
    void paint(QPainter &painter, const ShownUnderlay &shown, const View &view, const QRect &part);
    void forget() { m_sheet = {}; }

private:
    void draw(const ShownUnderlay &shown, const View &view);

    QImage m_sheet; ///< what `underlayBounds` gives
    QPoint m_at;
    ShownUnderlay m_shown; ///< as it was drawn; opacity comes later
    View m_view;
};

/// Decodes the underlay's picture on a thread of its own.
class UnderlayLoader : public QObject {
    Q_OBJECT

public:
    explicit UnderlayLoader(QObject *parent = nullptr);
    ~UnderlayLoader() override;

    /// From now on this one is wanted; null: none.
    void want(const EncodedImage &encoded);
    /// Null until it is decoded, and where it cannot be.
    const UnderlayImagePtr &image() const { return m_image; }

signals:
    void loaded();
    void failed(const QString &problem);

private:
    void take(const EncodedImage &encoded, const Result<UnderlayImagePtr> &image);

    EncodedImage m_wanted;
    UnderlayImagePtr m_image;
    QThreadPool m_thread;
};

} // namespace suffuse
