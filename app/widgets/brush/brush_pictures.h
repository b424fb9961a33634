// Pictures of all brushes, for whoever lists them.
#pragma once

#include "app/widgets/brush/brush_preview.h"

#include <QHash>
#include <QIcon>
#include <QObject>

#include <vector>

namespace suffuse {

/// Draws each brush of the library once for all lists, one after the other when there is nothing else to do, so that
/// no window waits for them.
class BrushPictures : public QObject {
    Q_OBJECT

public:
    /// Logical pixels of a picture.
    static constexpr QSize size{112, 44};

    /// Those of the program.
    static BrushPictures &instance();

    /// A brush's stroke on its sheet, at so many device pixels a logical one: framed where an item is selected, and
    /// with its star and key where it is a favourite. A dot says that the brush is `changed`. The sheet is empty until
    /// the stroke is drawn.
    QIcon icon(const QString &name, double ratio, bool changed = false) const;
    /// The sheet alone, at any size.
    QPixmap sheet(const QString &name, QSize size, double ratio) const;
    /// Has drawn what is missing, or is another brush now; `drawn` tells of each.
    void want(double ratio);
    /// Pictures still to be drawn.
    int pending() const { return int(m_pending.size()); }

signals:
    void drawn(const QString &name);

private:
    using QObject::QObject;
    void renderNext();
    bool isDrawn(const Brush &brush) const;

    struct Drawn {
        Brush brush;
        double ratio = 1;
        QImage image;
    };
    BrushPreview m_preview;
    QHash<QString, Drawn> m_drawn;
    std::vector<QString> m_pending; ///< last first
    double m_ratio = 1;
};

} // namespace suffuse
