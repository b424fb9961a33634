// The underlay on the canvas. It lies over the picture like a sheet of tracing paper, and is in no frame.
#pragma once

#include "app/session/files/underlay_image.h"
#include "render/view.h"

#include <QPolygonF>
#include <QRect>
#include <QThreadPool>

class QPainter;

namespace suffuse {

/// The underlay as presenters draw it.
struct ShownUnderlay {
    UnderlayImagePtr image;
    Rect area; ///< canvas units, not empty
    double opacity = 1;
    bool brightens = false; ///< The underlay multiplies what lies below it; on a dark canvas it is screened instead.

    friend bool operator==(const ShownUnderlay &, const ShownUnderlay &) = default;
};

/// How an underlay lies in a view: maps pixels to places in it, as shares of its width and height.
class UnderlayMap {
public:
    UnderlayMap(const ShownUnderlay &shown, const View &view);
    Point operator()(Point pixel) const { return m_base + pixel.x * m_right + pixel.y * m_down; }
    /// How far a step of one pixel to the right leads.
    Point right() const { return m_right; }
    Point down() const { return m_down; }

private:
    Point m_base, m_right, m_down;
};

/// The device pixels of the view on which the underlay is seen.
QRect underlayBounds(const ShownUnderlay &shown, const View &view);

/// Paints an underlay with QPainter. It keeps the picture as the view shows it, so that parts are painted at little
/// cost.
class UnderlaySheet {
public:
    /// Paints the underlay. The painter's units are device pixels; nothing beyond `part` is needed.
    void paint(QPainter &painter, const ShownUnderlay &shown, const View &view, const QRect &part);
    void forget() { m_sheet = {}; }

private:
    void draw(const ShownUnderlay &shown, const View &view);

    QImage m_sheet; ///< the part of the view that `underlayBounds` gives
    QPoint m_at;
    ShownUnderlay m_shown; ///< as it was drawn; the opacity is applied when it is painted
    View m_view;
};

/// Decodes the underlay's picture on a thread of its own.
class UnderlayLoader : public QObject {
    Q_OBJECT

public:
    explicit UnderlayLoader(QObject *parent = nullptr);
    ~UnderlayLoader() override;

    /// Sets the picture that is wanted from now on, or none (null).
    void want(const EncodedImage &encoded);
    /// The decoded picture. It is null before it is decoded, and where it cannot be.
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
